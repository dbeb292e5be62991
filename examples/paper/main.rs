//! Prints published tables beside what this crate reaches.
//!
//! ```sh
//! cargo xtask paper grid [--seeds 200] [--json]
//! cargo xtask paper road [--json] [--wasm FILE]
//! cargo xtask paper parking [--json]
//! cargo xtask paper settings [--json]
//! cargo xtask paper volumes [--json]
//! ```

mod parking;
mod road;
mod settings;
mod volumes;

use std::fmt::Write as _;
use std::time::Instant;

use parkade::papers::grid::{COLUMNS, ROWS, Table, measure, summary};
use parkade::papers::{Claim, Spread, claims};

fn main() {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let mut words = arguments.iter().map(String::as_str);
    let (mut seeds, mut as_json) = (200, false);
    match (words.next(), &arguments.get(1..).unwrap_or_default()) {
        (Some("grid"), _) => {}
        (Some("parking"), []) => return parking::print(false),
        (Some("parking"), [word]) if word == "--json" => return parking::print(true),
        (Some("settings"), []) => return settings::print(false),
        (Some("settings"), [word]) if word == "--json" => return settings::print(true),
        (Some("volumes"), []) => return volumes::print(false),
        (Some("volumes"), [word]) if word == "--json" => return volumes::print(true),
        (Some("road"), words) => {
            let file = words.iter().position(|word| word == "--wasm").and_then(|at| words.get(at + 1));
            let as_json = words.first().is_some_and(|word| word == "--json");
            if words.len() != usize::from(as_json) + 2 * usize::from(file.is_some()) {
                return usage();
            }
            std::process::exit(i32::from(!road::print(as_json, file.map(String::as_str))));
        }
        _ => return usage(),
    }
    while let Some(word) = words.next() {
        match (word, words.clone().next().and_then(|n| n.parse().ok())) {
            ("--json", _) => as_json = true,
            ("--seeds", Some(n)) if n > 0 => {
                seeds = n;
                words.next();
            }
            _ => return usage(),
        }
    }
    let start = Instant::now();
    let mut clock = || start.elapsed().as_secs_f64() * 1e3;
    let tables: Result<Vec<Table>, _> =
        ROWS.iter().map(|row| summary(row, &measure(row, 1, seeds, &mut clock)?)).collect();
    match tables {
        Ok(tables) if as_json => {
            println!("{:#}", serde_json::json!({ "tables": tables, "claims": claims(&tables) }));
        }
        Ok(tables) => print!("{}", markdown(&tables, &claims(&tables))),
        Err(error) => eprintln!("error: {error}"),
    }
}

fn usage() {
    eprintln!(
        "usage: cargo xtask paper grid [--seeds 200] [--json]\n       cargo xtask paper road [--json]\n       cargo \
         xtask paper parking|settings|volumes [--json]"
    );
    std::process::exit(2);
}

fn markdown(tables: &[Table], claims: &[Claim]) -> String {
    let mut text = format!(
        "# Hu et al. 2024, tables 3 and 4; Yuan 2020\n\n{} maps a row; median / 95th percentile / worst. \"Nodes\" \
         are the cells that ever entered the open list; lengths in\ncells, after pruning. The papers' maps are not \
         published.\n",
        tables.first().map_or(0, |t| t.maps)
    );
    for table in tables {
        let _ = write!(
            text,
            "\n## Table {}: {} × {}, {}\n\n| planner | nodes, printed | nodes | expanded | length, printed | length | \
             shortest over its cells | smoothed | ms |\n| --- | --- | --- | --- | --- | --- | --- | --- | --- |\n",
            table.row.table, table.row.size, table.row.size, table.row.id
        );
        for line in &table.lines {
            let of = |name: &str| {
                spread(
                    &line.figures[COLUMNS.iter().position(|c| *c == name).unwrap_or(0)],
                    if name == "milliseconds" || name.starts_with("length") { 2 } else { 0 },
                )
            };
            let printed = |value: Option<f64>| value.map_or_else(|| "–".to_owned(), |v| v.to_string());
            let flag = if line.impossible { " ⚠" } else { "" };
            let _ = writeln!(
                text,
                "| {} | {} | {} | {} | {}{flag} | {} | {} | {} | {} |",
                line.planner,
                printed(line.printed_nodes),
                of("generated"),
                of("expanded"),
                printed(line.printed_length),
                of("lengthPruned"),
                of("lengthDp"),
                of("lengthSmoothed"),
                of("milliseconds"),
            );
        }
        if table.lines.iter().any(|line| line.impossible) {
            let _ = writeln!(
                text,
                "\n⚠ shorter than the straight line between the printed end points, {:.4}: only ratios can be \
                 compared.",
                table.straight
            );
        }
        text.push_str("\n| ratio | printed | ours |\n| --- | --- | --- |\n");
        for ratio in &table.ratios {
            let printed = ratio.printed.map_or_else(|| "–".to_owned(), |v| format!("{v:.3}"));
            let _ = writeln!(
                text,
                "| {} {} / {} {} | {printed} | {} |",
                ratio.planner,
                ratio.figure,
                ratio.over,
                if ratio.over_figure == ratio.figure { "" } else { ratio.over_figure },
                spread(&ratio.ours, 3)
            );
        }
    }
    text.push_str("\n## Claims\n\n| claim | figures | holds |\n| --- | --- | --- |\n");
    for claim in claims {
        let _ = writeln!(text, "{claim}");
    }
    text
}

fn spread(s: &Spread, digits: usize) -> String {
    format!("{:.digits$} / {:.digits$} / {:.digits$}", s.median, s.p95, s.worst)
}

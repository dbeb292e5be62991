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

use parkade::papers::grid::{COLUMNS, READINGS, ROWS, Table, measure, summary};
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
        text.push_str(&readings(table));
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
    text.push_str(&closest(tables));
    text.push_str("\n## Claims\n\n| claim | figures | holds |\n| --- | --- | --- |\n");
    for claim in claims {
        let _ = writeln!(text, "{claim}");
    }
    text
}

/// What a printed length may mean, side by side: our medians, and how much they differ from it.
fn readings(table: &Table) -> String {
    let mut text = String::from(
        "\n| length | printed | cells | pruned | shortest over the cells | smoothed |\n\
         | --- | --- | --- | --- | --- | --- |\n",
    );
    for line in table.lines.iter().filter(|line| line.printed_length.is_some()) {
        let _ = write!(text, "| {} | {} ", line.planner, line.printed_length.unwrap_or_default());
        for reading in READINGS {
            let at = COLUMNS.iter().position(|c| *c == reading).unwrap_or(0);
            let share = (line.over_printed(reading).unwrap_or(1.0) - 1.0) * 100.0;
            let mark = if line.closest == Some(reading) { "**" } else { "" };
            let _ = write!(text, "| {mark}{:.2} ({share:+.1} %){mark} ", line.figures[at].median);
        }
        text.push_str("|\n");
    }
    text
}

/// On how many rows each reading is the nearest to the printed length.
fn closest(tables: &[Table]) -> String {
    let mut text = String::from(
        "\n## Which length is printed\n\n\
         Rows on which a reading is the nearest to the printed length; rows with a length that cannot be are \
         left out.\n\n\
         | | cells | pruned | shortest over the cells | smoothed |\n\
         | --- | --- | --- | --- | --- |\n",
    );
    for planner in ["four", "eight", "risk-field"] {
        let lines = || tables.iter().flat_map(|t| &t.lines).filter(|line| line.planner == planner);
        let count = |reading| lines().filter(|line| line.closest == Some(reading)).count().to_string();
        let _ = writeln!(text, "| {planner} | {} |", READINGS.map(count).join(" | "));
    }
    text
}

fn spread(s: &Spread, digits: usize) -> String {
    format!("{:.digits$} / {:.digits$} / {:.digits$}", s.median, s.p95, s.worst)
}

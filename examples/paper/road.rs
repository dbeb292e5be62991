//! The road manuscript's tables beside plain A*, ours and its own method taken literally.

use std::fmt::Write as _;
use std::time::Instant;

use parkade::papers::road::{Line, Promise, ROWS, Table, measure};
use serde_json::{Value, json};

/// Rounds of which the fastest counts.
const ROUNDS: u32 = 5;

pub(crate) fn print(as_json: bool) {
    let printed: Value = serde_json::from_str(include_str!("../../tests/data/paper-tables-road.json"))
        .expect("valid JSON in the repository");
    let start = Instant::now();
    let mut clock = || start.elapsed().as_secs_f64() * 1e3;
    let tables: Result<Vec<Table>, _> = ROWS.iter().map(|row| measure(row, ROUNDS, &mut clock)).collect();
    match tables {
        Ok(tables) if as_json => {
            println!("{:#}", json!({ "tables": tables, "flags": printed["flags"] }));
        }
        Ok(tables) => print!("{}", markdown(&tables, &printed["flags"])),
        Err(error) => eprintln!("error: {error}"),
    }
}

fn markdown(tables: &[Table], flags: &Value) -> String {
    let mut text = String::from(
        "# Road navigation manuscript, section 4\n\nPercentages are against plain A*, printed against printed and ours against ours. Body clearances are mean (at most 1.2 m\neach) and least, side clearances those of the middle less half the width; hits are of 1000 drives beside the path by chance, in\nbrackets for a disc. Milliseconds are of everything, rasters and checks included, here and natively.\n",
    );
    for table in tables {
        text.push_str(&scene(table));
    }
    text.push_str("\n## Promises\n\n| | figure | bound | found | plain A* | kept |\n| --- | --- | --- | --- | --- | --- |\n");
    for table in tables {
        for Promise { figure, at_least, bound, found, plain, kept } in &table.promises {
            let sign = if *at_least { '≥' } else { '≤' };
            let _ = writeln!(
                text,
                "| {} | {figure} | {sign} {bound:.2} | {found:.2} | {plain:.2} | {} |",
                table.row.id,
                if *kept { "yes" } else { "no" }
            );
        }
    }
    text.push_str("\n## ⚠ What the manuscript's numbers cannot be\n\n");
    for flag in flags.as_array().into_iter().flatten().filter_map(Value::as_str) {
        let _ = writeln!(text, "* {flag}");
    }
    text
}

fn scene(table: &Table) -> String {
    let row = &table.row;
    let mut text = format!(
        "\n## {}: `{}`{}\n\n| | length, m | turning points | body clearance, m | side clearance, m | curvature variation, 1/m | hits | lane deviation, m | B/cell | ms | check |\n| --- | --- | --- | --- | --- | --- | --- | --- | --- | --- | --- |\n",
        row.id,
        row.scene,
        if row.ship { ", ten times as large, with the ship" } else { "" }
    );
    let share = |now: f64, was: f64| {
        if was == 0.0 { String::new() } else { format!(" ({:+.1} %)", (now / was - 1.0) * 100.0) }
    };
    let p = &row.printed;
    for (k, name) in ["printed, plain", "printed, improved"].into_iter().enumerate() {
        let of = |values: [f64; 2]| {
            format!("{}{}", values[k], if k == 0 { String::new() } else { share(values[1], values[0]) })
        };
        let _ = writeln!(
            text,
            "| {name} | {} | {} | {} ⚠ | – | – | {} | – | {} MB | {} s | – |",
            of(p.length),
            of(p.turns),
            of(p.safety),
            of(p.collisions),
            of(p.memory),
            of(p.time),
        );
    }
    let plain = &table.lines[0];
    for (k, line) in table.lines.iter().enumerate() {
        let (m, f) = (&line.metrics, &line.metrics.figures);
        let of = |value: &dyn Fn(&Line) -> f64| {
            if k == 0 { String::new() } else { share(value(line), value(plain)) }
        };
        let _ = writeln!(
            text,
            "| {}{} | {:.1}{} | {}{} | {:.2} / {:.2} | {:.2} / {:.2} | {:.2}{} | {} ({}){} | {:.2} / {:.2} | {:.1} | {:.1} | {} |",
            line.id,
            if line.fell_back { ", chords" } else { "" },
            f.middle_length,
            of(&|l| l.metrics.figures.middle_length),
            m.turns_pruned,
            of(&|l| f64::from(l.metrics.turns_pruned)),
            f.body_clearance_mean,
            f.body_clearance_min,
            f.side_clearance_mean,
            f.side_clearance_min,
            f.curvature_variation,
            of(&|l| l.metrics.figures.curvature_variation),
            line.risk.hits,
            line.risk.disc_hits,
            of(&|l| f64::from(l.risk.hits)),
            f.lane_deviation_mean.unwrap_or(0.0),
            f.lane_deviation_max.unwrap_or(0.0),
            m.bytes as f64 / f64::from(table.cells),
            line.milliseconds,
            line.verdict,
        );
    }
    text
}

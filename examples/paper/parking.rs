//! The parking paper's tables 2 to 11 beside ours, in its own rounding.

use std::fmt::Write as _;
use std::time::Instant;

use parkade::papers::parking::{ROWS, Table, measure};

/// Rounds of which the fastest counts.
const ROUNDS: u32 = 3;

pub(crate) fn print(as_json: bool) {
    let start = Instant::now();
    let mut clock = || start.elapsed().as_secs_f64() * 1e3;
    let tables: Vec<Table> =
        ROWS.iter().map(|row| measure(row.id, ROUNDS, &mut clock).expect("a row of the paper")).collect();
    if as_json {
        println!("{:#}", serde_json::json!({ "tables": tables, "means": means(&tables) }));
    } else {
        print!("{}", markdown(&tables));
    }
}

/// The abstract's figures: what four rows save on average, printed and ours, percent.
fn means(tables: &[Table]) -> [(&'static str, f64, f64, f64); 2] {
    let mean =
        |rows: &[Table], column: usize| rows.iter().map(|t| t.saved[column]).sum::<f64>() / rows.len() as f64;
    let (across, along) = (&tables[1..5], &tables[6..10]);
    [
        ("P1 to P4", 8.18, mean(across, 0), mean(across, 1)),
        ("L1 to L4", 20.53, mean(along, 0), mean(along, 1)),
    ]
}

fn markdown(tables: &[Table]) -> String {
    let mut text = String::from(
        "# Parking paper 2025, tables 2 to 11\n\nLengths in steps of 0.1 m, nodes between them, time of driving at 2 m/s, as the paper has them; it prints no computing time.\nOurs plan with a margin of 0.1 m (P1: 0) and are checked with the exact body every 2 cm.\n\n| row | tables | | time, s | changes | nodes | length, m | exact, m | clearance, m | expanded | ms | check |\n| --- | --- | --- | --- | --- | --- | --- | --- | --- | --- | --- | --- |\n",
    );
    for table in tables {
        let row = &table.row;
        let numbers = match row.tables {
            [first, last] if first == last => first.to_string(),
            [first, last] => format!("{first}–{last}"),
        };
        let both = [("printed, traditional", row.traditional), ("printed, improved", row.improved)];
        for ((name, cell), impossible) in both.into_iter().zip(table.impossible) {
            let flag = if impossible { format!(" ⚠ < {:.2}", table.bound) } else { String::new() };
            let _ = writeln!(
                text,
                "| {} | {numbers} | {name} | {:.2} | {} | {} | {:.1}{flag} | | | | | |",
                row.id, cell.time, cell.changes, cell.nodes, cell.length
            );
        }
        for line in &table.lines {
            let _ = writeln!(
                text,
                "| | | `{}` | {:.2} | {} | {} | {:.1} | {:.2} | {:.2} | {} | {:.1} | {} |",
                line.planner,
                line.time,
                line.changes,
                line.nodes,
                line.length,
                line.exact,
                line.clearance,
                line.expanded,
                line.milliseconds,
                line.verdict
            );
        }
    }
    text.push_str(
        "\n⚠ shorter than the shortest path without obstacles, which no car of that turning radius can do.\n\n| row | bound, m | held to, m / changes | reached | kept | saved, printed | ours | |\n| --- | --- | --- | --- | --- | --- | --- | --- |\n",
    );
    for Table { row, bound, lines, kept, saved, .. } in tables {
        let _ = writeln!(
            text,
            "| {} | {bound:.2} | {:.2} / {} | {:.2} / {} | {} | {:.1} % | {:.1} % | {} |",
            row.id,
            row.reach.0,
            row.reach.1,
            lines[1].exact,
            lines[1].changes,
            if *kept { "yes" } else { "no" },
            saved[0],
            saved[1],
            row.note
        );
    }
    text.push_str("\n| driving time saved, mean | abstract | its rows | ours |\n| --- | --- | --- | --- |\n");
    for (rows, said, printed, ours) in means(tables) {
        let _ = writeln!(text, "| {rows} | {said} % | {printed:.2} % | {ours:.2} % |");
    }
    text.push_str(
        "\nThe traditional planner here is the same search from the other end, shortcut included: it is as short, only slower.\n`hybrid-classic` is as coarse and greedy as the program that the paper started from.\n",
    );
    text
}

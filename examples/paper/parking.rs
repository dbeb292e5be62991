//! The parking paper's tables 2 to 11 beside ours, in its own rounding.

use std::fmt::Write as _;
use std::time::Instant;

use parkade::papers::parking::{ROWS, Table, measure};
use parkade::papers::verdicts::{Saved, parking_claims, saved};
use serde_json::{Value, json};

/// Rounds of which the fastest counts.
const ROUNDS: u32 = 3;

pub(crate) fn print(as_json: bool) {
    let start = Instant::now();
    let mut clock = || start.elapsed().as_secs_f64() * 1e3;
    let tables: Vec<Table> =
        ROWS.iter().map(|row| measure(row.id, ROUNDS, &mut clock).expect("a row of the paper")).collect();
    if as_json {
        let claims = parking_claims(&values(&tables)).expect("tables of our own");
        println!(
            "{:#}",
            json!({ "tables": tables, "saved": saved(&values(&tables)).ok(), "claims": claims })
        );
    } else {
        print!("{}", markdown(&tables));
    }
}

fn values(tables: &[Table]) -> Vec<Value> {
    tables.iter().map(|table| json!(table)).collect()
}

fn markdown(tables: &[Table]) -> String {
    let mut text = String::from(
        "# Parking paper 2025, tables 2 to 11\n\nLengths in steps of 0.1 m, nodes between them, time of driving at 2 \
         m/s, as the paper has them; it prints no computing time.\nOurs plan with a margin of 0.1 m (P1: 0) and are \
         checked with the exact body every 2 cm.\n\n| row | tables | | time, s | changes | nodes | length, m | exact, \
         m | clearance, m | expanded | ms | check |\n| --- | --- | --- | --- | --- | --- | --- | --- | --- | --- | \
         --- | --- |\n",
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
        "\n⚠ shorter than the shortest path without obstacles, which no car of that turning radius can do.\n\n| row | \
         bound, m | held to, m / changes | reached | kept | saved, printed | ours | |\n| --- | --- | --- | --- | --- \
         | --- | --- | --- |\n",
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
    text.push_str(&verdicts(tables));
    text.push_str(
        "\nThe traditional planner here is the same search from the other end, shortcut included: it is as short, \
         only slower.\n`hybrid-classic` is as coarse and greedy as the program that the paper started from.\n",
    );
    text
}

/// What each end has to search, what is saved, and the paper's claims.
fn verdicts(tables: &[Table]) -> String {
    let values = values(tables);
    let mut text = String::from(
        "\n| row | expanded from the start | from the goal | ms from the start | from the goal |\n| --- | --- | --- | \
         --- | --- |\n",
    );
    for Table { row, lines, .. } in tables {
        let [forward, reverse] = [&lines[0], &lines[1]];
        let _ = writeln!(
            text,
            "| {} | {} | {} | {:.1} | {:.1} |",
            row.id, forward.expanded, reverse.expanded, forward.milliseconds, reverse.milliseconds
        );
    }
    text.push_str(
        "\n| driving time saved, mean | abstract | its rows | against `hybrid-forward` | against \
        `hybrid-classic` |\n| --- | --- | --- | --- | --- |\n",
    );
    let all = saved(&values).expect("tables of our own").into_iter().flatten();
    for (rows, mean) in ["P1 to P4", "L1 to L4"].into_iter().zip(all) {
        let Saved { said, printed, over_forward, over_classic } = mean;
        let _ = writeln!(
            text,
            "| {rows} | {said} % | {printed:.2} % | {over_forward:.2} % | {over_classic:.2} % |"
        );
    }
    text.push_str("\n| claim | figures | holds |\n| --- | --- | --- |\n");
    for claim in parking_claims(&values).expect("tables of our own") {
        let _ = writeln!(text, "{claim}");
    }
    text
}

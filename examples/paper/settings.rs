//! Settings of the published program, tried one by one for the parking paper's traditional column.

use std::fmt::Write as _;

use parkade::papers::parking::ROWS;
use parkade::papers::traditional::{COMBINATIONS, Found, Tried, attempt, by_row, settings};

pub(crate) fn print(as_json: bool) {
    let tried: Vec<Tried> = (0..COMBINATIONS).map(|i| attempt(i).expect("a combination there is")).collect();
    let rows = by_row(&tried);
    if as_json {
        let all: Vec<_> = (0..COMBINATIONS).map(settings).collect();
        println!("{:#}", serde_json::json!({ "settings": all, "tried": tried, "rows": rows }));
    } else {
        print!("{}", markdown(&tried, &rows));
    }
}

fn markdown(tried: &[Tried], rows: &[Found]) -> String {
    let mut text = format!(
        "# The traditional column of the parking paper\n\n{COMBINATIONS} combinations of the published program's \
         settings, each on all ten rows. Lengths in metres in the paper's rounding.\n\n| row | printed: m, changes | \
         combinations with 0 / 1 / 2 / 3 / 4 / 5 or more changes | without a path | nearest with the printed changes \
         | settings |\n| --- | --- | --- | --- | --- | --- |\n"
    );
    for (row, found) in ROWS.iter().zip(rows) {
        let counts: Vec<String> = found.changes.iter().map(ToString::to_string).collect();
        let printed = row.traditional;
        let (nearest, with) = match found.nearest {
            Some((path, combination)) => {
                (format!("{:.1} ({:+.1})", path.length, path.length - printed.length), told(combination))
            }
            None => ("–".to_owned(), "–".to_owned()),
        };
        let _ = writeln!(
            text,
            "| {} | {:.1}, {} | {} | {} | {nearest} | {with} |",
            row.id,
            printed.length,
            printed.changes,
            counts.join(" / "),
            found.none
        );
    }
    let best = |of: fn(&Tried) -> usize| tried.iter().max_by_key(|t| (of(t), usize::MAX - t.combination));
    if let (Some(changes), Some(both)) = (best(|t| t.same_changes), best(|t| t.same)) {
        let _ = write!(
            text,
            "\nThe most rows with the printed number of changes: {} of {}, with {}.\nThe most rows with the printed \
             length to half a metre, too: {}, with {}.\nThe published values: {} and {}.\n",
            changes.same_changes,
            ROWS.len(),
            told(changes.combination),
            both.same,
            told(both.combination),
            tried[0].same_changes,
            tried[0].same,
        );
    }
    text
}

/// What differs between combinations.
fn told(combination: usize) -> String {
    let all = settings(combination);
    let fixed = ["profile", "margin"];
    let told = all.iter().filter(|(name, _)| !fixed.contains(&name.as_str()));
    told.map(|(name, value)| format!("{name} {value}")).collect::<Vec<_>>().join(", ").replace('"', "")
}

//! The parking paper's traditional column, looked for: settings of the classic hybrid A\* that give its printed lengths
//! and its two to four gear changes.
//!
//! The paper does not print the settings of its traditional planner. Those of the published program that it started
//! from are varied here, each around its published value, and every combination plans all ten rows.

use serde::Serialize;
use serde_json::{Map, Value, json};

use super::parking::{ROWS, Row};
use crate::error::Error;
use crate::plan::{Options, Outcome, Planner};
use crate::scenario::catalog;

/// The values of a varied setting: its name in `hybrid-classic`, then the values, the published one first.
const VARIED: [(&str, &[f64]); 8] = [
    ("steerSamples", &[20.0, 2.0]),
    ("directionChangeCost", &[0.0, 3.0, 10.0]),
    ("reverseCost", &[1.5, 1.0]),
    ("steerCost", &[0.25, 0.0]),
    ("steerChangeCost", &[0.9, 0.0]),
    ("heuristicWeight", &[5.0, 1.0]),
    ("xyResolution", &[2.0, 1.0]),
    ("motionPrimitiveLength", &[3.1, 1.5]),
];

/// Names of estimates; the paper prefers the straight line.
const HEURISTICS: [&str; 3] = ["max", "reeds-shepp", "euclid"];

/// Combinations of settings.
pub const COMBINATIONS: usize = {
    let (mut count, mut i) = (2 * HEURISTICS.len(), 0);
    while i < VARIED.len() {
        count *= VARIED[i].1.len();
        i += 1;
    }
    count
};

/// The settings of a combination, 0 to [`COMBINATIONS`] − 1; 0 has the published values.
pub fn settings(combination: usize) -> Map<String, Value> {
    let mut rest = combination;
    let mut pick = |count: usize| {
        let at = rest % count;
        rest /= count;
        at
    };
    let mut settings = Map::new();
    for (name, values) in VARIED {
        let value = values[pick(values.len())];
        let value = if name == "steerSamples" { json!(value as u32) } else { json!(value) };
        settings.insert(name.to_owned(), value);
    }
    settings.insert("heuristic".to_owned(), HEURISTICS[pick(HEURISTICS.len())].into());
    settings.insert("firstShot".to_owned(), (pick(2) == 0).into());
    // The costs above count only in this profile; the published program keeps no margin.
    settings.insert("profile".to_owned(), "shortest".into());
    settings.insert("margin".to_owned(), 0.0.into());
    settings
}

/// A path of one combination in one row, in the paper's rounding.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct Path {
    /// Gear changes.
    pub changes: u32,
    /// Metres.
    pub length: f64,
}

/// Results of one combination in all rows.
#[derive(Debug, Clone, Serialize)]
#[serde(rename_all = "camelCase")]
pub struct Tried {
    /// Its number.
    pub combination: usize,
    /// One for each row; none where it finds nothing.
    pub paths: Vec<Option<Path>>,
    /// Rows with the printed number of gear changes.
    pub same_changes: usize,
    /// Rows with the printed number of gear changes and the printed length, to half a metre.
    pub same: usize,
}

/// Plans all rows with a combination of settings.
///
/// # Errors
/// None for combinations below [`COMBINATIONS`].
pub fn attempt(combination: usize) -> Result<Tried, Error> {
    let settings = settings(combination);
    let plan = |row: &Row| -> Result<Option<Path>, Error> {
        let scene = catalog::scenario(row.id)?;
        let plan = Planner::new("hybrid-classic", &scene, &settings)?.plan(Options::default());
        let hybrid = plan.metrics.hybrid.unwrap_or_default();
        let path = Path { changes: plan.metrics.direction_changes, length: hybrid.paper_length };
        Ok((plan.outcome == Outcome::Found).then_some(path))
    };
    let paths: Vec<Option<Path>> = ROWS.iter().map(plan).collect::<Result<_, _>>()?;
    let count = |near: f64| {
        let agrees = |(row, path): (&Row, &Option<Path>)| {
            path.is_some_and(|p| {
                p.changes == row.traditional.changes && (p.length - row.traditional.length).abs() <= near
            })
        };
        ROWS.iter().zip(&paths).filter(|pair| agrees(*pair)).count()
    };
    Ok(Tried { combination, same_changes: count(f64::INFINITY), same: count(0.5), paths })
}

/// Results of all combinations in one row.
#[derive(Debug, Clone, Serialize)]
#[serde(rename_all = "camelCase")]
pub struct Found {
    /// The row.
    pub id: &'static str,
    /// Combinations with 0, 1, 2, … gear changes, the last one with at least so many.
    pub changes: [usize; 6],
    /// Combinations without a path.
    pub none: usize,
    /// The path with the printed gear changes whose length is nearest to the printed one, and its combination.
    pub nearest: Option<(Path, usize)>,
}

/// The same attempts, row by row.
pub fn by_row(tried: &[Tried]) -> Vec<Found> {
    let of = |(i, row): (usize, &Row)| {
        let mut found = Found { id: row.id, changes: [0; 6], none: 0, nearest: None };
        for attempt in tried {
            let Some(path) = attempt.paths[i] else {
                found.none += 1;
                continue;
            };
            found.changes[(path.changes as usize).min(5)] += 1;
            let off = |path: Path| (path.length - row.traditional.length).abs();
            if path.changes == row.traditional.changes
                && found.nearest.is_none_or(|best| off(path) < off(best.0))
            {
                found.nearest = Some((path, attempt.combination));
            }
        }
        found
    };
    ROWS.iter().enumerate().map(of).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn combinations_differ_and_the_first_is_published() {
        assert_eq!(COMBINATIONS, 2304);
        let all: Vec<_> = (0..COMBINATIONS).map(settings).collect();
        let told: std::collections::BTreeSet<_> = all.iter().map(|one| json!(one).to_string()).collect();
        assert_eq!(told.len(), COMBINATIONS);
        let first = &all[0];
        assert_eq!((&first["steerSamples"], &first["directionChangeCost"]), (&json!(20), &json!(0.0)));
    }

    #[test]
    fn attempts_are_counted_row_by_row() {
        let tried: Vec<_> = [0, 1, 5].map(|i| attempt(i).unwrap()).into();
        for (row, found) in ROWS.iter().zip(by_row(&tried)) {
            assert_eq!(found.changes.iter().sum::<usize>() + found.none, 3, "{}", row.id);
            assert!(found.nearest.is_none_or(|(path, _)| path.changes == row.traditional.changes));
        }
        let plain = attempt(0).unwrap();
        assert!(plain.same <= plain.same_changes && plain.paths.iter().filter(|p| p.is_some()).count() >= 8);
    }
}

//! Claims of the parking paper and of the road manuscript, each judged by figures on our rows. No verdict depends on
//! a clock.
//!
//! The tables come back as JSON, because a page measures their rows in several workers and joins them; so each number
//! is read by its path, and one that is missing or no number is refused by name. All rows of a paper must be there
//! before any of its claims is judged: a claim over four rows says nothing about three.

use serde_json::Value;

use super::claims::{Claim, share_of};
use super::{parking, road};
use crate::error::{Error, ErrorCode};

/// A table as JSON, as the package and the page have it, and where it stands.
struct Rows<'a> {
    tables: Vec<(usize, &'a Value)>,
}

impl<'a> Rows<'a> {
    /// The tables of these rows in their order; `None` while one is missing.
    fn of(tables: &'a [Value], ids: &[&str]) -> Option<Self> {
        let find = |id: &&str| tables.iter().enumerate().find(|(_, t)| t["row"]["id"] == **id);
        ids.iter().map(find).collect::<Option<Vec<_>>>().map(|tables| Self { tables })
    }

    fn number(&self, row: usize, path: &str) -> Result<f64, Error> {
        let (at, table) = self.tables[row];
        table.pointer(path).and_then(Value::as_f64).ok_or_else(|| {
            let field = format!("[{at}]{}", path.replace('/', "."));
            Error::new(ErrorCode::Input, field, "must be a finite number")
        })
    }

    /// One number of each row.
    fn all(&self, path: &str) -> Result<Vec<f64>, Error> {
        (0..self.tables.len()).map(|row| self.number(row, path)).collect()
    }
}

/// Percent of driving time that the parking paper's abstract says it saves: across the aisle, along it.
pub const SAID: [f64; 2] = [8.18, 20.53];

/// Percent of driving time saved on average over four rows.
#[derive(Debug, Clone, Copy, PartialEq, serde::Serialize)]
#[serde(rename_all = "camelCase")]
pub struct Saved {
    /// Percentage in the abstract.
    pub said: f64,
    /// Percentage of the printed rows.
    pub printed: f64,
    /// Ours, from the goal, against ours from the start.
    pub over_forward: f64,
    /// Ours, from the goal, against the coarse and greedy planner.
    pub over_classic: f64,
}

/// The savings of rows P1 to P4 and L1 to L4; `None` while rows are missing.
///
/// # Errors
/// [`ErrorCode::Input`] for tables without their numbers.
pub fn saved(tables: &[Value]) -> Result<Option<[Saved; 2]>, Error> {
    let Some(rows) = Rows::of(tables, &parking::ROWS.map(|row| row.id)) else { return Ok(None) };
    let printed = [rows.all("/row/traditional/time")?, rows.all("/row/improved/time")?];
    let [forward, ours, classic] = [0, 1, 3].map(|at| rows.all(&format!("/lines/{at}/time")));
    let (forward, ours, classic) = (forward?, ours?, classic?);
    let mean = |old: &[f64], new: &[f64], from: usize, to: usize| {
        let shares = old[from..to].iter().zip(&new[from..to]).map(|(old, new)| (1.0 - new / old) * 100.0);
        shares.sum::<f64>() / (to - from) as f64
    };
    let of = |from, to, said| Saved {
        said,
        printed: mean(&printed[0], &printed[1], from, to),
        over_forward: mean(&forward, &ours, from, to),
        over_classic: mean(&classic, &ours, from, to),
    };
    Ok(Some([of(1, 5, SAID[0]), of(6, 10, SAID[1])]))
}

/// The parking paper's claims, judged when all rows are there.
///
/// # Errors
/// As [`saved`].
pub fn parking_claims(tables: &[Value]) -> Result<Vec<Claim>, Error> {
    let ids = parking::ROWS.map(|row| row.id);
    let (Some(saved), Some(rows)) = (saved(tables)?, Rows::of(tables, &ids)) else { return Ok(Vec::new()) };
    let sum = |path: &str| rows.all(path).map(|all| all.iter().sum::<f64>());
    let (forward, reverse) = (rows.all("/lines/0/expanded")?, rows.all("/lines/1/expanded")?);
    let work = [forward.iter().sum::<f64>(), reverse.iter().sum::<f64>()];
    let worse = forward.iter().zip(&reverse).filter(|(old, new)| new > old).count();
    let printed = [sum("/row/traditional/changes")?, sum("/row/improved/changes")?];
    let changes = [sum("/lines/0/changes")?, sum("/lines/1/changes")?, sum("/lines/3/changes")?];
    // Lengths are compared where a car can drive what is printed.
    let impossible = |row: &usize| {
        rows.tables[*row].1["impossible"].as_array().is_none_or(|both| both.contains(&true.into()))
    };
    let possible: Vec<usize> = (0..rows.tables.len()).filter(|row| !impossible(row)).collect();
    let metres = |path: &str| possible.iter().map(|&row| rows.number(row, path)).sum::<Result<f64, Error>>();
    let (from_start, ours, coarse) =
        (metres("/lines/0/exact")?, metres("/lines/1/exact")?, metres("/lines/3/exact")?);
    let theirs = metres("/row/improved/length")?;
    let (before, after) = (rows.all("/lines/0/exact")?, rows.all("/lines/1/exact")?);
    let shorter = possible.iter().filter(|&&row| after[row] <= before[row] + 0.005).count();
    let time = |id, Saved { printed, over_forward, over_classic, said }: Saved| {
        let figures = [
            ("printed", printed.into()),
            ("overForward", over_forward.into()),
            ("overClassic", over_classic.into()),
        ];
        Claim::new(id, figures, share_of(&[over_forward >= said, over_classic >= said]))
    };
    Ok(vec![
        time("K1", saved[0]),
        time("K2", saved[1]),
        Claim::new(
            "K3",
            [("forward", work[0].into()), ("reverse", work[1].into()), ("worse", (worse as f64).into())],
            share_of(&[work[1] < work[0], worse == 0]),
        ),
        Claim::new(
            "K4",
            [
                ("traditional", printed[0].into()),
                ("improved", printed[1].into()),
                ("forward", changes[0].into()),
                ("reverse", changes[1].into()),
                ("classic", changes[2].into()),
            ],
            share_of(&[changes[1] < changes[0], changes[1] < changes[2]]),
        ),
        Claim::new(
            "K5",
            [
                ("rows", (possible.len() as f64).into()),
                ("forward", from_start.into()),
                ("reverse", ours.into()),
                ("classic", coarse.into()),
                ("printed", theirs.into()),
                ("shorter", (shorter as f64).into()),
            ],
            share_of(&[shorter == possible.len(), ours < coarse]),
        ),
    ])
}

/// The least falls that the road manuscript claims, percent of plain A\*, and its least clearance, metres.
const TURNS: f64 = -55.0;
const BENDING: f64 = -75.0;
const HITS: f64 = -95.0;
const CLEARANCE: f64 = 0.795;

/// The road manuscript's claims of its car's scenes S1 to S4, judged when all are there.
///
/// # Errors
/// [`ErrorCode::Input`] for tables without their numbers.
pub fn road_claims(tables: &[Value]) -> Result<Vec<Claim>, Error> {
    let cars: Vec<_> = road::ROWS.iter().filter(|row| !row.ship).map(|row| row.id).collect();
    let Some(rows) = Rows::of(tables, &cars) else { return Ok(Vec::new()) };
    // The straight lane has nothing to gain.
    let range = |name: &str| -> Result<(f64, f64), Error> {
        let [plain, ours] = [0, 1].map(|at| rows.all(&format!("/lines/{at}/{name}")));
        let changes = plain?.into_iter().zip(ours?).skip(1).map(|(old, new)| (new / old - 1.0) * 100.0);
        Ok(changes.fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), c| (low.min(c), high.max(c))))
    };
    let by = |(low, high): (f64, f64), bound: f64| share_of(&[high <= bound, low <= bound]);
    let fell = |id, range: (f64, f64), bound| Claim::new(id, [("change", range.into())], by(range, bound));
    let least = |path| rows.all(path).map(|all| all.into_iter().fold(f64::INFINITY, f64::min));
    let (mean, nearest) =
        (least("/lines/1/metrics/bodyClearanceMeanCapped")?, least("/lines/1/metrics/bodyClearanceMin")?);
    let length = range("metrics/middleLength")?;
    Ok(vec![
        fell("R1", range("metrics/turnsPruned")?, TURNS),
        fell("R2", range("metrics/curvatureVariation")?, BENDING),
        Claim::new(
            "R3",
            [("mean", mean.into()), ("least", nearest.into())],
            share_of(&[mean >= CLEARANCE, nearest >= CLEARANCE]),
        ),
        fell("R4", range("risk/hits")?, HITS),
        Claim::new(
            "R5",
            [("change", length.into())],
            if length.0 >= 1.8 && length.1 <= 4.7 { "yes" } else { "no" },
        ),
    ])
}

#[cfg(test)]
mod tests {
    use serde_json::json;

    use super::super::claims::Figure;
    use super::*;

    fn still() -> f64 {
        0.0
    }

    #[test]
    fn the_parking_papers_claims_are_judged_by_counts() {
        let measure = |row: &parking::Row| json!(parking::measure(row.id, 1, &mut still).unwrap());
        let tables: Vec<_> = parking::ROWS.iter().map(measure).collect();
        assert!(parking_claims(&tables[..9]).unwrap().is_empty() && saved(&tables[..9]).unwrap().is_none());
        let [across, along] = saved(&tables).unwrap().unwrap();
        assert!((across.printed - 8.18).abs() < 0.005 && (along.printed - 20.26).abs() < 0.005);
        let claims = parking_claims(&tables).unwrap();
        for claim in &claims {
            println!("{}: {:?} – {}", claim.id, claim.figures, claim.holds);
        }
        let holds: Vec<_> = claims.iter().map(|claim| (claim.id, claim.holds)).collect();
        assert_eq!(holds, [("K1", "no"), ("K2", "no"), ("K3", "yes"), ("K4", "yes"), ("K5", "yes")]);
        let work = ["forward", "reverse", "worse"].map(|name| claims[2].figures[name]);
        assert_eq!(work, [6749.0, 513.0, 0.0].map(Figure::Number));
        // Row by row, a tree from the slot is far smaller.
        for id in ["L0", "P4", "P0"] {
            let table = tables.iter().find(|t| t["row"]["id"] == id).unwrap();
            let expanded = |at: usize| table["lines"][at]["expanded"].as_f64().unwrap();
            assert!(expanded(1) < 0.05 * expanded(0), "{id}: {} {}", expanded(0), expanded(1));
        }
        let mut torn = tables.clone();
        torn[2]["lines"][1]["expanded"] = Value::Null;
        let error = parking_claims(&torn).unwrap_err().to_string();
        assert_eq!(error, "[2].lines.1.expanded: must be a finite number");
    }

    #[test]
    fn the_road_manuscripts_claims_need_all_four_scenes() {
        let cars = road::ROWS.iter().filter(|row| !row.ship);
        let tables: Vec<_> = cars.map(|row| json!(road::measure(row, 1, &mut still).unwrap())).collect();
        assert!(road_claims(&tables[1..]).unwrap().is_empty());
        let claims = road_claims(&tables).unwrap();
        for claim in &claims {
            println!("{}: {:?} – {}", claim.id, claim.figures, claim.holds);
        }
        let holds: Vec<_> = claims.iter().map(|claim| (claim.id, claim.holds)).collect();
        assert_eq!(holds, [("R1", "partly"), ("R2", "yes"), ("R3", "partly"), ("R4", "yes"), ("R5", "no")]);
    }
}

//! Maps on which the risk field taken literally loses its way: three directions alone, and nothing held back.

use super::grid::Row;
use crate::error::{Error, ErrorCode};
use crate::map::Cell;
use crate::planners::Outcome;
use crate::planners::query::{GridScratch, Query};
use crate::planners::risk_field::{self, Config, Fallback};
use crate::scenario::generate::occupancy;

/// Most seeds of one question.
const MAX_SEEDS: u64 = 10_000;

/// The seeds from `from` to `to`, both included, whose map has a path that the literal planner does not find.
///
/// # Errors
/// [`ErrorCode::Input`] for seeds in the wrong order or too many.
///
/// # Examples
/// ```
/// use parkade::papers::{grid::row, incomplete::incomplete};
///
/// let seeds = incomplete(row("random-60").unwrap(), 1, 20).unwrap();
/// assert!(seeds.len() < 5);
/// ```
pub fn incomplete(row: &Row, from: u64, to: u64) -> Result<Vec<u64>, Error> {
    if from > to || to - from >= MAX_SEEDS {
        let rule = message!("must be {} to {}, got {}", from, from.saturating_add(MAX_SEEDS - 1), to);
        return Err(Error::new(ErrorCode::Input, "to", rule));
    }
    let literal = Config { fallback: Fallback::None, ..Config::PAPER };
    let mut scratch = GridScratch::new();
    let mut seeds = Vec::new();
    for seed in from..=to {
        // Generated maps are connected.
        let map = occupancy(row.family, row.size, seed)?;
        let end = map.width() as i32 - 1;
        let query = Query { map: &map, start: Cell::new(0, 0), goal: Cell::new(end, end) };
        if risk_field::plan(query, &literal, &mut scratch, &mut ()).outcome != Outcome::Found {
            seeds.push(seed);
        }
    }
    Ok(seeds)
}

#[cfg(test)]
mod tests {
    use super::super::grid::{ROWS, row};
    use super::*;

    #[test]
    fn the_literal_planner_is_incomplete_on_12_and_18_of_200_maps_of_60_cells() {
        let count = |id| incomplete(row(id).unwrap(), 1, 200).unwrap().len();
        assert_eq!((count("random-60"), count("regular-60")), (12, 18));
        let all: Vec<_> = ROWS.iter().map(|row| (row.id, incomplete(row, 1, 200).unwrap().len())).collect();
        println!("{all:?}");
        assert!(all.iter().all(|(_, count)| *count > 0));
    }

    #[test]
    fn slices_add_up_and_bad_ones_are_named() {
        let row = row("regular-30").unwrap();
        let (whole, parts) =
            (incomplete(row, 1, 40).unwrap(), [incomplete(row, 1, 15), incomplete(row, 16, 40)]);
        assert_eq!(whole, parts.map(Result::unwrap).concat());
        assert_eq!(incomplete(row, 3, 2).unwrap_err().to_string(), "to: must be 3 to 10002, got 2");
    }
}

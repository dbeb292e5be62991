//! Search from both ends that stops at "the same best node", as Yuan 2020 says, beside the cheapest paths.

use std::sync::OnceLock;

use serde::Serialize;

use super::grid::{ROWS, Row};
use crate::error::Error;
use crate::map::Cell;
use crate::planners::Outcome;
use crate::planners::bidirectional::{Config, plan};
use crate::planners::query::{GridScratch, Query};
use crate::scenario::generate::occupancy;
use crate::search::{Observers, Stop};

/// Seeds of each kind and size of map.
const SEEDS: u64 = 250;
/// Larger maps take longer and say the same.
const LARGEST: u32 = 60;

/// Results of a stop rule on maps that all have a path.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct NaiveStop {
    /// Maps tried.
    pub maps: u32,
    /// Maps on which it finds no path.
    pub none: u32,
    /// Maps on which its path is longer than the cheapest one.
    pub longer: u32,
    /// Its longest path, in lengths of the cheapest one.
    pub worst: f64,
}

impl NaiveStop {
    /// The rule on 1000 maps: seeds 1 to 250 of both kinds with 30 and with 60 cells a side. Measured once.
    ///
    /// # Examples
    /// ```
    /// let found = parkade::papers::NaiveStop::measured();
    /// assert!(found.maps == 1000 && found.none > 0 && found.longer > 500);
    /// ```
    pub fn measured() -> Self {
        static MEASURED: OnceLock<NaiveStop> = OnceLock::new();
        *MEASURED.get_or_init(|| {
            let mut sum = Self { maps: 0, none: 0, longer: 0, worst: 1.0 };
            let mut scratch = GridScratch::new();
            let small = ROWS.iter().filter(|row| row.size <= LARGEST);
            for (row, seed) in small.flat_map(|row| (1..=SEEDS).map(move |seed| (row, seed))) {
                // The families are known to have maps of these sizes.
                let _ = sum.add(row, seed, &mut scratch);
            }
            sum
        })
    }

    /// Plans one map with the literal stop and with the one that is proven the cheapest.
    fn add(&mut self, row: &Row, seed: u64, scratch: &mut GridScratch) -> Result<(), Error> {
        let map = occupancy(row.family, row.size, seed)?;
        let end = map.width() as i32 - 1;
        let query = Query { map: &map, start: Cell::new(0, 0), goal: Cell::new(end, end) };
        let mut by =
            |stop| plan(query, &Config { stop, ..Config::DEFAULT }, scratch, &mut Observers::default());
        let [cheapest, naive] = [Stop::Optimal, Stop::Naive].map(&mut by);
        self.maps += 1;
        if naive.outcome == Outcome::Found {
            self.longer += u32::from(naive.cost_micro > cheapest.cost_micro);
            self.worst = self.worst.max(naive.cost_micro as f64 / cheapest.cost_micro as f64);
        } else {
            self.none += 1;
        }
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_same_best_node_is_missed_on_some_maps_and_dear_on_most() {
        let found = NaiveStop::measured();
        // Counts of searches in whole numbers: the same on every machine.
        assert_eq!((found.maps, found.none, found.longer), (1000, 5, 767), "{found:?}");
        assert!((found.worst - 1.35).abs() < 0.005, "{found:?}");
    }

    #[test]
    fn a_path_that_is_found_is_never_shorter_than_the_cheapest() {
        let mut scratch = GridScratch::new();
        for seed in 5000..5040 {
            let mut sum = NaiveStop { maps: 0, none: 0, longer: 0, worst: 0.0 };
            sum.add(&ROWS[3], seed, &mut scratch).unwrap();
            assert!(sum.none == 1 || sum.worst >= 1.0, "{seed}: {sum:?}");
            assert_eq!(sum.longer == 1, sum.worst > 1.0, "{seed}: {sum:?}");
        }
    }
}

//! Grid A* from start and goal at once, with any neighbourhood (Yuan 2020).
//!
//! The paper stops where the two searches meet, which is fast but not always the cheapest; NBA* (Pijls and Post 2009)
//! goes on until nothing cheaper can exist. Estimates are the exact costs over an empty map.

use super::grid_lattice::Grid;
use super::heuristics::{Chosen, Estimate, Heuristic, Octile};
use super::moves::Neighbourhood;
use super::query::{GridReport, GridScratch, Query};
use super::settings::Common;
use super::weighted::Weighted;
use crate::error::Error;
use crate::json;
use crate::search::{Observer, Stop, both_ways};

json::words!(Stop: "first" = First, "best" = Best, "nba" = Optimal);

/// Settings of the search from both ends.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Config {
    /// Which cells a step may lead to.
    pub neighbours: Neighbourhood,
    /// When the search stops.
    pub stop: Stop,
    /// What every grid planner has.
    pub common: Common,
}

json::settings!(
    Config: "neighbours" = neighbours,
    "stop" = stop,
    "corner" = common.corner,
    "inflation" = common.inflation,
    "margin" = common.margin,
    "minPassage" = common.min_passage,
    "trapMouth" = common.trap_mouth,
    "post" = common.post,
    "smoothMode" = common.smooth_mode,
    "minRadius" = common.min_radius,
    "maxExpansions" = common.max_expansions
);

impl Default for Config {
    fn default() -> Self {
        Self { neighbours: Neighbourhood::Sixteen, stop: Stop::First, common: Common::PLAIN }
    }
}

impl Config {
    /// Checks every setting.
    ///
    /// # Errors
    /// [`ErrorCode::Config`](crate::error::ErrorCode::Config) with the field and the rule.
    pub fn validate(&self) -> Result<(), Error> {
        self.common.validate()
    }
}

/// Searches a path over the cells of a map, from both ends. Counters add up both sides.
///
/// `config` must be valid ([`Config::validate`]); `observer` is `()` where nobody watches.
///
/// ```
/// use parkade::map::{Cell, Occupancy};
/// use parkade::planners::bidirectional::{Config, plan};
/// use parkade::planners::query::{GridScratch, Query};
///
/// let map = Occupancy::parse("....\n.##.\n....");
/// let query = Query { map: &map, start: Cell::new(0, 0), goal: Cell::new(3, 2) };
/// let report = plan(query, &Config::default(), &mut GridScratch::new(), &mut ());
/// assert_eq!(report.cost_micro, 5_000_000);
/// ```
pub fn plan<O: Observer<i64, ()>>(
    query: Query,
    config: &Config,
    scratch: &mut GridScratch,
    observer: &mut O,
) -> GridReport {
    if let Some(report) = query.trivial() {
        return report;
    }
    if query.map.weights().is_some() {
        let estimate = Chosen { heuristic: Heuristic::Gauge, neighbourhood: config.neighbours, weight: None };
        let grid =
            Weighted::new(Grid::new(&query, config.neighbours, config.common.corner, estimate), &query);
        let most = config.common.max_expansions;
        let found = both_ways(&grid, query.ends(), config.stop, most, &mut scratch.lattice, observer);
        return GridReport::along(&query, &found, grid.lattice.los_calls());
    }
    match config.neighbours {
        Neighbourhood::Eight => search(query, config, Octile, scratch, observer),
        neighbourhood => {
            let gauge = Chosen { heuristic: Heuristic::Gauge, neighbourhood, weight: None };
            search(query, config, gauge, scratch, observer)
        }
    }
}

fn search<E: Estimate, O: Observer<i64, ()>>(
    query: Query,
    config: &Config,
    gauge: E,
    scratch: &mut GridScratch,
    observer: &mut O,
) -> GridReport {
    let mut grid = Grid::new(&query, config.neighbours, config.common.corner, gauge);
    if config.stop == Stop::Optimal {
        grid = grid.on_shortest_ways();
    }
    let most = config.common.max_expansions;
    let found = both_ways(&grid, query.ends(), config.stop, most, &mut scratch.lattice, observer);
    GridReport::along(&query, &found, grid.los_calls())
}

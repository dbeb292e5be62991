//! Grid A* from start and goal at once, with any neighbourhood (Yuan 2020).
//!
//! The paper stops at "the same best node". Taken literally ([`Stop::Naive`]) the two searches can pass each other, so
//! by default the search stops where they meet, which is fast but not always the cheapest; NBA* (Pijls and Post 2009)
//! goes on until nothing cheaper can exist. Estimates are the exact costs over an empty map.

use super::grid_lattice::Grid;
use super::grid_planner::grid_planner;
use super::heuristics::{Chosen, Estimate, Heuristic, Octile};
use super::moves::Neighbourhood;
use super::parameters::{Form, NEIGHBOURS, parameters, spec};
use super::query::{GridReport, GridScratch, Query};
use super::settings::Common;
use super::weighted::Weighted;
use super::{Detail, Outcome};
use crate::json;
use crate::search::{Observer, Observers, Recording, Stop, bidirectional, record_bidirectional};

json::words!(Stop: "first" = First, "best" = Best, "nba" = Optimal, "naive" = Naive);

parameters! {
    /// Settings of the search from both ends.
    #[derive(Debug, Clone, Copy, PartialEq)]
    pub struct Config {
        /// Which cells a step may lead to.
        neighbours: Neighbourhood = Neighbourhood::Sixteen,
            NEIGHBOURS;
        /// When the search stops.
        stop: Stop = Stop::First,
            spec("stop", Form::Choice(&["first", "best", "nba", "naive"]), "1", true,
                 ["Stop", "停止规则"],
                 ["First: where the two meet; best: the best connection until then; nba: the cheapest path; naive: \
                   both take up the same cell (the paper), which can fail.",
                  "first：相遇即停；best：其间最佳连接；nba：最短路径；naive：两侧同时取到同一格（论文），可能失败。"]);
    }
    /// The settings that all grid planners share.
    shared common: Common = Common::PLAIN;
}

grid_planner!(Config: plan, record);

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
    let mut report = stopped(query, config, scratch, observer);
    if report.outcome == Outcome::NoPath && config.stop == Stop::Naive {
        // Silent, but of the type that plans are watched with: a second copy of the search saves nothing.
        let sound = Config { stop: Stop::First, ..*config };
        if stopped(query, &sound, scratch, &mut Observers::default()).outcome == Outcome::Found {
            report.detail = Some(Detail::Incomplete);
        }
    }
    report
}

/// The search with one stopping rule. Cells with weights wrap the lattice; its estimate stays that of plain cells,
/// which is below every cost because weights are at least 1. Eight neighbours have an estimate of their own, compiled
/// in.
fn stopped<O: Observer<i64, ()>>(
    query: Query,
    config: &Config,
    scratch: &mut GridScratch,
    observer: &mut O,
) -> GridReport {
    if query.map.weights().is_some() {
        let estimate = Chosen { heuristic: Heuristic::Gauge, neighbourhood: config.neighbours, weight: None };
        let grid =
            Weighted::new(Grid::new(&query, config.neighbours, config.common.corner, estimate), &query);
        let most = config.common.max_expansions;
        let found = bidirectional(&grid, query.ends(), config.stop, most, &mut scratch.lattice, observer);
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
    let found = bidirectional(&grid, query.ends(), config.stop, most, &mut scratch.lattice, observer);
    GridReport::along(&query, &found, grid.los_calls())
}

/// The same search with its events written down, at most `limit` of them.
pub fn record(query: Query, config: &Config, limit: usize) -> Recording {
    if query.trivial().is_some() {
        return Recording::empty();
    }
    let Config { neighbours, stop, common } = *config;
    let estimate = Chosen { heuristic: Heuristic::Gauge, neighbourhood: neighbours, weight: None };
    let mut grid = Grid::new(&query, neighbours, common.corner, estimate);
    let (ends, most) = (query.ends(), common.max_expansions);
    if query.map.weights().is_some() {
        return record_bidirectional(&Weighted::new(grid, &query), ends, stop, most, limit);
    }
    if stop == Stop::Optimal {
        grid = grid.on_shortest_ways();
    }
    record_bidirectional(&grid, ends, stop, most, limit)
}

//! Dijkstra's search and greedy best-first search, between which A* stands (Yuan 2020, section 1).
//!
//! Dijkstra's search orders cells by the cost from the start alone and finds the cheapest path. Greedy best-first
//! search orders them by the straight distance to the goal alone: it keeps the first way that it finds to each
//! cell, so its path can be far from the shortest.

use super::Outcome;
use super::grid_astar::record_grid;
use super::grid_lattice::Grid;
use super::grid_planner::{GridPlanner, Prepared};
use super::heuristics::{Chosen, Heuristic};
use super::moves::{Neighbourhood, cost};
use super::parameters::{Field, NEIGHBOURS, parameters};
use super::query::{GridReport, GridScratch, Query};
use super::settings::Common;
use super::weighted::Weighted;
use crate::search::one_way;
use crate::search::{Observer, Observers, Recording, record_one_way};

parameters! {
    /// Settings of both searches.
    #[derive(Debug, Clone, Copy, PartialEq)]
    pub struct Config {
        /// Which cells a step may lead to.
        neighbours: Neighbourhood = Neighbourhood::Eight,
            NEIGHBOURS;
    }
    /// The settings that all grid planners share.
    shared common: Common = Common::PLAIN;
}

/// One of the two searches with its settings.
pub(super) struct Search {
    config: Config,
    is_greedy: bool,
}

impl Search {
    pub(super) const DIJKSTRA: Self = Self { config: Config::DEFAULT, is_greedy: false };
    pub(super) const GREEDY: Self = Self { config: Config::DEFAULT, is_greedy: true };
}

impl super::parameters::Parameters for Search {
    fn fields(&mut self) -> Vec<Field<'_>> {
        self.config.fields()
    }
}

impl GridPlanner for Search {
    fn common(&self) -> Common {
        self.config.common
    }

    fn run(&self, at: Prepared, scratch: &mut GridScratch, observers: &mut Observers) -> GridReport {
        let plan = if self.is_greedy { greedy } else { dijkstra };
        plan(at.query, &self.config, scratch, observers)
    }

    fn record(&self, at: Prepared, limit: usize) -> Option<Recording> {
        let record = if self.is_greedy { record_greedy } else { record_dijkstra };
        Some(record(at.query, &self.config, limit))
    }
}

/// Searches the cheapest path over the cells of a map by Dijkstra's search.
///
/// `config` must be valid ([`Config::validate`]); `observer` is `()` where nobody watches.
///
/// ```
/// use parkade::map::{Cell, Occupancy};
/// use parkade::planners::dijkstra_greedy::{Config, dijkstra};
/// use parkade::planners::query::{GridScratch, Query};
///
/// let map = Occupancy::parse("....\n.##.\n....");
/// let query = Query { map: &map, start: Cell::new(0, 0), goal: Cell::new(3, 2) };
/// let report = dijkstra(query, &Config::default(), &mut GridScratch::new(), &mut ());
/// assert_eq!((report.cost_micro, report.stats.expanded), (5_000_000, 10));
/// ```
pub fn dijkstra<O: Observer<i64, ()>>(
    query: Query,
    config: &Config,
    scratch: &mut GridScratch,
    observer: &mut O,
) -> GridReport {
    if let Some(report) = query.trivial() {
        return report;
    }
    let grid = lattice(&query, config, Heuristic::Zero);
    let (ends, most) = (query.ends(), config.common.max_expansions);
    let mut report = if query.map.weights().is_some() {
        let grid = Weighted::new(grid, &query);
        let found = one_way(&grid, ends, most, &mut scratch.lattice, observer);
        GridReport::along(&query, &found, grid.lattice.los_calls())
    } else {
        let found = one_way(&grid, ends, most, &mut scratch.lattice, observer);
        GridReport::along(&query, &found, grid.los_calls())
    };
    if report.outcome == Outcome::NoPath {
        // Without an estimate no expanded cell is nearer than another.
        report.closest = greedy(query, config, scratch, observer).closest;
    }
    report
}

/// Searches a path over the cells of a map by greedy best-first search.
///
/// `config` must be valid ([`Config::validate`]); `observer` is `()` where nobody watches. Weights of cells are
/// ignored.
///
/// ```
/// use parkade::map::{Cell, Occupancy};
/// use parkade::planners::dijkstra_greedy::{Config, greedy};
/// use parkade::planners::query::{GridScratch, Query};
///
/// let map = Occupancy::new(9, 9);
/// let query = Query { map: &map, start: Cell::new(0, 0), goal: Cell::new(8, 8) };
/// let report = greedy(query, &Config::default(), &mut GridScratch::new(), &mut ());
/// assert_eq!((report.cost_micro, report.stats.expanded), (8 * 1_414_214, 9));
/// ```
pub fn greedy<O: Observer<i64, ()>>(
    query: Query,
    config: &Config,
    scratch: &mut GridScratch,
    observer: &mut O,
) -> GridReport {
    if let Some(report) = query.trivial() {
        return report;
    }
    let grid = Weighted::for_nothing(lattice(&query, config, Heuristic::Euclid), &query);
    let found = one_way(&grid, query.ends(), config.common.max_expansions, &mut scratch.lattice, observer);
    let mut report = GridReport::along(&query, &found, grid.lattice.los_calls());
    report.cost_micro = report.cells.windows(2).map(|p| cost(p[1].x - p[0].x, p[1].y - p[0].y)).sum();
    report
}

/// Dijkstra's search with its events written down, at most `limit` of them.
pub fn record_dijkstra(query: Query, config: &Config, limit: usize) -> Recording {
    if query.trivial().is_some() {
        return Recording::empty();
    }
    record_grid(query, lattice(&query, config, Heuristic::Zero), config.common, limit)
}

/// Greedy best-first search with its events written down, at most `limit` of them.
pub fn record_greedy(query: Query, config: &Config, limit: usize) -> Recording {
    if query.trivial().is_some() {
        return Recording::empty();
    }
    let grid = Weighted::for_nothing(lattice(&query, config, Heuristic::Euclid), &query);
    record_one_way(&grid, query.ends(), config.common.max_expansions, limit)
}

fn lattice<'a>(query: &Query<'a>, config: &Config, heuristic: Heuristic) -> Grid<'a, Chosen> {
    let neighbourhood = config.neighbours;
    let estimate = Chosen { heuristic, neighbourhood, weight: None };
    Grid::new(query, neighbourhood, config.common.corner, estimate)
}

//! Risk-field A*: eight directions, of which a potential field picks three per cell (Hu et al. 2024).
//!
//! The force on a cell (the goal attracts, the nearest obstacle repels) names a region; the region names three of the
//! eight directions, and diagonal ones also offer a double step. A weighted estimate that favours the longer of the
//! diagonal and the straight part drives the search on. The three-direction rule alone loses the way on 2 to 22 % of
//! ordinary maps, so the other five directions are held back, not dropped ([`Fallback`]).
//! The path is not the cheapest one: the paper trades that for speed.
//!
//! Units: distances in the field are cells, forces have none, and costs are micro-cells. Of equal priorities the
//! smaller estimate and then the newest entry comes first, as in all grid planners.

pub(super) mod config;
mod directions;
mod domain;
mod explain;

use super::grid_astar;
use super::grid_planner::grid_planner;
use super::heuristics::{DistanceWeight, Heuristic as GridHeuristic};
use super::moves::Neighbourhood;
use super::query::{GridReport, GridScratch, Query};
use super::settings::Common;
use super::weighted::Weighted;
use crate::map::Corner;
use crate::planners::{Detail, Outcome};
use crate::search::one_way_deferring;
use crate::search::{Observer, Observers};
use crate::search::{Recording, record_deferring};
use config::permille;

pub use config::{Config, Fallback, Heuristic};
pub use explain::{Candidate, Explanation, explain};

grid_planner!(Config: plan, record;
    fn risk_field(&self) -> Option<&Config> {
        Some(self)
    }
);

/// Searches a path over the cells of a map.
///
/// `config` must be valid ([`Config::validate`]); `observer` is `()` where nobody watches.
///
/// ```
/// use parkade::map::{Cell, Occupancy};
/// use parkade::planners::query::{GridScratch, Query};
/// use parkade::planners::risk_field::{Config, plan};
///
/// let map = Occupancy::new(9, 9);
/// let query = Query { map: &map, start: Cell::new(0, 0), goal: Cell::new(8, 8) };
/// let report = plan(query, &Config::PAPER, &mut GridScratch::new(), &mut ());
/// assert_eq!(report.cells.first(), Some(&query.start));
/// assert_eq!(report.cost_micro, 8 * 1_414_214);
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
    let (dx, dy) = (query.goal.x - query.start.x, query.goal.y - query.start.y);
    let weight = DistanceWeight::new(permille(config.wbar), dx, dy);
    let grid = domain::RiskGrid::new(query, config, weight, config.deferral());
    let most = config.common.max_expansions;
    let mut report = if query.map.weights().is_some() {
        let grid = Weighted::new(grid, &query);
        let found = one_way_deferring(&grid, query.ends(), most, &mut scratch.risk, observer);
        GridReport::along(&query, &found, grid.lattice.los_calls())
    } else {
        let found = one_way_deferring(&grid, query.ends(), most, &mut scratch.risk, observer);
        GridReport::along(&query, &found, grid.los_calls())
    };
    let incomplete = matches!(config.fallback, Fallback::StuckOnly | Fallback::None);
    if report.outcome == Outcome::NoPath && incomplete && is_reachable(query, config.common.corner, scratch) {
        report.detail = Some(Detail::Incomplete);
    }
    report
}

/// The same search with its events written down, at most `limit` of them.
/// The recorded search agrees with [`plan`] in order, costs and counters, but for a bound of steps.
pub fn record(query: Query, config: &Config, limit: usize) -> Recording {
    if query.trivial().is_some() {
        return Recording::empty();
    }
    let (dx, dy) = (query.goal.x - query.start.x, query.goal.y - query.start.y);
    let weight = DistanceWeight::new(permille(config.wbar), dx, dy);
    let grid = domain::RiskGrid::new(query, config, weight, config.deferral());
    let (ends, most) = (query.ends(), config.common.max_expansions);
    if query.map.weights().is_some() {
        return record_deferring(&Weighted::new(grid, &query), ends, most, limit);
    }
    record_deferring(&grid, ends, most, limit)
}

/// True if ordinary steps lead from start to goal.
fn is_reachable(query: Query, corner: Corner, scratch: &mut GridScratch) -> bool {
    let eight = Neighbourhood::Eight;
    let common = Common { corner, ..Common::PLAIN };
    let config =
        grid_astar::Config { heuristic: GridHeuristic::Octile, common, ..grid_astar::Config::new(eight) };
    // Silent, but of the type that plans are watched with: a second copy of the search saves nothing.
    grid_astar::plan(query, eight, &config, scratch, &mut Observers::default()).outcome == Outcome::Found
}

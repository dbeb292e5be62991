//! A second look where a path changes gear often: one more search in which a change is dear.
//!
//! Whoever answers first may rock where another drives on: in a tight slot coarse lattices soon end, and the first that
//! gets out takes two changes where a finer one takes one. So the path is held against one search of a very fine
//! lattice with the same margin and from the same end. A gear change costs several metres in it, and what cannot be
//! cheaper by that price than the known path is left out, so that the search soon ends where there is nothing to gain.

use super::Floods;
use super::members::FIRST_SLICE;
use crate::geometry::arcs;
use crate::planners::hybrid::config::{FIRST_SHUFFLING_LEVEL, Level};
use crate::planners::hybrid::question::{Search, Work};
use crate::planners::hybrid::report::Status;

/// With more gear changes than this a path is held against another.
const FEW_CHANGES: u32 = 2;
/// Extra cost of a gear change in the search, metres.
const EXTRA_CHANGE_COST: f64 = 4.0;
/// Weight of the estimate in it.
const WEIGHT: f64 = 2.0;
/// Its expansions: as many as the path took, but so many at least and at most.
const EXPANSIONS: [u32; 2] = [FIRST_SLICE, 50_000];
/// The level that is refined for it, and which of the refined lattices it takes: the one with the smallest cells.
const LEVEL: (u32, usize) = (FIRST_SHUFFLING_LEVEL - 1, 3);

/// Replaces the path in `work`, where it changes gear often, by a cheaper one with fewer changes.
pub(super) fn look_again(search: Search, floods: &Floods, work: &mut Work) {
    let config = search.config;
    let changes = arcs::direction_changes(&work.report.arcs);
    if changes <= FEW_CHANGES || config.levels() <= FIRST_SHUFFLING_LEVEL {
        return;
    }
    let Some(margin) = floods.margins.iter().position(|&margin| margin == work.report.margin) else { return };
    let is_swapped = work.report.from_goal != search.mirrored;
    let flood = floods.get(margin, is_swapped);
    let search = if is_swapped { search.swapped(flood) } else { Search { flood, ..search } };
    let counters = work.report.counters();
    let known = core::mem::replace(work.report, counters);
    let (number, refinement) = LEVEL;
    (work.report.margin, work.report.level) = (known.margin, number);
    let level = config.level(number).refined(refinement, config);
    let [least, most] = EXPANSIONS;
    let level = Level {
        max_expansions: level.max_expansions.min(known.expanded.clamp(least, most)),
        weight: config.heuristic_weight.unwrap_or(WEIGHT),
        extra_change: EXTRA_CHANGE_COST,
        bound: known.cost + EXTRA_CHANGE_COST * f64::from(changes),
        ..level
    };
    let is_better = search.level(level, work)
        && arcs::direction_changes(&work.report.arcs) < changes
        && work.report.cost < known.cost;
    if is_better {
        work.report.status = Status::Suboptimal;
    } else {
        *work.report = work.report.with_path_of(known);
    }
}

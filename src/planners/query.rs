//! Queries to grid planners and their results.
//!
//! A query is a prepared map with two cells on it; metres, cars and headings are the business of those who ask. So one
//! map serves any number of queries, and a planner can be tested and measured without a scene.

use super::{Detail, Outcome};
use crate::map::{Cell, Occupancy};
use crate::search::{Found, NodeId, PackedEntry, PackedScratch, SearchStats, WideEntry};
use crate::search::{Report, Scratch};

/// A question to a grid planner.
#[derive(Debug, Clone, Copy)]
pub struct Query<'a> {
    /// Free and blocked cells, safety space included.
    pub map: &'a Occupancy,
    /// Start cell.
    pub start: Cell,
    /// Goal cell.
    pub goal: Cell,
}

/// The answer of a grid planner.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct GridReport {
    /// How the search ended.
    pub outcome: Outcome,
    /// A finer word where there is no path.
    pub detail: Option<Detail>,
    /// The path from start to goal, one entry per move; empty where there is none.
    pub cells: Vec<Cell>,
    /// Sum of the moves' integer costs, micro-cells; 0 where there is no path.
    pub cost_micro: i64,
    /// The counters of the search; bytes are those of its cells and open list.
    pub stats: SearchStats,
    /// Expansions of moves that were held back (risk field).
    pub deferred: u32,
    /// Line-of-sight checks, single steps included.
    pub los_calls: u32,
    /// Cells that bounds excluded before they were expanded; only NBA* has bounds.
    pub rejected: Option<u32>,
    /// Cells looked at along jumps (jump points).
    pub cells_scanned: Option<u32>,
    /// The expanded cell with the smallest estimate: how near the search came. The start where nothing was searched.
    pub closest: Cell,
}

/// A grid search's memory, reused between queries.
#[derive(Debug, Default)]
pub struct GridScratch {
    pub(super) lattice: PackedScratch<PackedEntry>,
    pub(super) risk: PackedScratch<WideEntry>,
    pub(super) lengths: Scratch<f64, Cell>,
}

impl GridScratch {
    /// Memory with nothing in it yet.
    pub fn new() -> Self {
        Self::default()
    }
}

impl Query<'_> {
    /// The numbers of start and goal, which must be on the map.
    pub(super) fn ends(&self) -> (NodeId, NodeId) {
        (self.map.index(self.start), self.map.index(self.goal))
    }

    /// The answer that needs no search: start or goal outside or blocked, or start and goal the same cell.
    pub(super) fn trivial(&self) -> Option<GridReport> {
        let outcome = if !self.map.contains(self.start) {
            Outcome::StartOutside
        } else if !self.map.contains(self.goal) {
            Outcome::GoalOutside
        } else if self.map.blocked(self.start) {
            Outcome::StartBlocked
        } else if self.map.blocked(self.goal) {
            Outcome::GoalBlocked
        } else if self.start == self.goal {
            Outcome::Found
        } else {
            return None;
        };
        let mut report = GridReport::empty(outcome, self.start);
        if outcome == Outcome::Found {
            report.cells = vec![self.start];
            report.stats.generated = 1;
        }
        Some(report)
    }
}

impl GridReport {
    /// An answer without a path, all of its counters at 0.
    pub(super) fn empty(outcome: Outcome, closest: Cell) -> Self {
        Self {
            outcome,
            detail: None,
            cells: Vec::new(),
            cost_micro: 0,
            stats: SearchStats::default(),
            deferred: 0,
            los_calls: 0,
            rejected: None,
            cells_scanned: None,
            closest,
        }
    }

    /// The answer of a search by lengths, still without its cost.
    pub(super) fn of(
        query: &Query,
        search: &Report<f64, ()>,
        scratch: &Scratch<f64, Cell>,
        los_calls: u32,
    ) -> Self {
        let outcome = Outcome::from(search.end);
        let bytes = Scratch::<f64, Cell>::bytes(query.map.len(), search.stats.open_peak) as u64;
        let mut report = Self {
            stats: SearchStats { bytes, ..search.stats },
            los_calls,
            detail: (outcome == Outcome::NoPath).then_some(Detail::Unreachable),
            ..Self::empty(outcome, query.map.cell(search.closest.1))
        };
        if let (Outcome::Found, Some((last, ..))) = (outcome, &search.found) {
            report.cells = scratch.chain(*last).into_iter().map(|(_, cell)| cell).collect();
        }
        report
    }

    /// The answer of a search over the map's cells by number.
    pub(super) fn along(query: &Query, found: &Found, los_calls: u32) -> Self {
        let outcome = Outcome::from(found.end);
        Self {
            cells: found.nodes.iter().map(|&node| query.map.cell(node)).collect(),
            cost_micro: found.cost,
            stats: found.stats,
            deferred: found.deferred,
            rejected: found.rejected,
            los_calls,
            detail: (outcome == Outcome::NoPath).then_some(Detail::Unreachable),
            ..Self::empty(outcome, query.map.cell(found.closest))
        }
    }
}

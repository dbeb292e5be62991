//! Jump point search: the cheapest eight-neighbour path with strict corners, by looking along lines instead of at
//! neighbours (Harabor and Grastien 2011), 64 cells at a time (2014).
//!
//! Of the many equally cheap ways over open ground only those are followed that go diagonally first, and of their
//! cells only those become nodes where an obstacle forces a turn. Few expansions are not little work:
//! [`GridReport::cells_scanned`] counts the cells looked at.

use std::cell::Cell as Counter;

use super::heuristics::octile;
use super::moves::{D, DIRECTIONS, R2};
use super::query::{GridReport, GridScratch, Query};
use super::settings::Common;
use crate::error::Error;
use crate::json;
use crate::map::{Bits, Cell};
use crate::search::{Domain, Finish, Limits, NodeId, Observer, Relax, Visit, best_first};

/// Settings of jump point search. Corners are strict.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Config {
    /// Whether turns that no obstacle forces are passed over: those of a diagonal jump into a straight one, and those to
    /// the free side of a straight jump's end.
    pub prune: bool,
    /// What every grid planner has.
    pub common: Common,
}

json::settings!(
    Config: "prune" = prune,
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
        Self { prune: true, common: Common::PLAIN }
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

/// The direction in which a node was reached, as in [`DIRECTIONS`]; at the start this one.
const START: u8 = 8;

struct Jumps<'a> {
    query: Query<'a>,
    bits: &'a Bits,
    prune: bool,
    scanned: Counter<u32>,
}

impl Jumps<'_> {
    /// The straight jump from a cell: the number of steps, if it gets anywhere.
    fn straight(&self, from: Cell, direction: u8) -> Option<(Cell, i64)> {
        let (dx, dy) = DIRECTIONS[direction as usize];
        let goal = self.query.goal;
        let (scan, to) = if dy == 0 {
            let scan = self.bits.along_row(from, dx, goal);
            (scan, scan.jump.map(|x| Cell::new(x, from.y)))
        } else {
            let scan = self.bits.along_column(from, dy, goal);
            (scan, scan.jump.map(|y| Cell::new(from.x, y)))
        };
        self.scanned.set(self.scanned.get() + scan.cells);
        to.map(|to| (to, i64::from((to.x - from.x).abs() + (to.y - from.y).abs())))
    }

    fn jump<S: Relax<i64, u8>>(&self, from: Cell, direction: u8, sink: &mut S) {
        if direction.is_multiple_of(2) {
            if let Some((to, steps)) = self.straight(from, direction) {
                sink.emit(self.query.map.index(to), steps * D, direction);
            }
        } else {
            self.diagonal(from, direction, sink);
        }
    }

    fn diagonal<S: Relax<i64, u8>>(&self, from: Cell, direction: u8, sink: &mut S) {
        let map = self.query.map;
        let (dx, dy) = DIRECTIONS[direction as usize];
        let sides = [(direction + 1) % 8, (direction + 7) % 8];
        let needed = 1 << direction | 1 << sides[0] | 1 << sides[1];
        let (mut at, mut cost) = (from, 0);
        while map.free_around(at) & needed == needed {
            at = at.offset(dx, dy);
            cost += R2;
            self.scanned.set(self.scanned.get() + 1);
            if at == self.query.goal {
                sink.emit(map.index(at), cost, direction);
                return;
            }
            let mut turns = false;
            // The vertical jump first, as at an expansion.
            let vertical = usize::from(DIRECTIONS[sides[0] as usize].0 != 0);
            for side in [sides[vertical], sides[1 - vertical]] {
                if let Some((to, steps)) = self.straight(at, side) {
                    turns = true;
                    if self.prune {
                        sink.emit(map.index(to), cost + steps * D, side);
                    } else {
                        break;
                    }
                }
            }
            if turns && !self.prune {
                sink.emit(map.index(at), cost, direction);
                return;
            }
        }
    }
}

impl Domain for Jumps<'_> {
    type Cost = i64;
    type Label = u8;
    type Tail = ();

    fn node_count(&self) -> usize {
        self.query.map.len()
    }

    fn successors<S: Relax<i64, u8>>(&self, from: Visit<i64, u8>, sink: &mut S) {
        let cell = self.query.map.cell(from.node);
        let reached = from.label;
        let turned = |by: u8| (reached + by) % 8;
        if reached == START {
            (0..8).for_each(|direction| self.jump(cell, direction, sink));
        } else if reached % 2 == 1 {
            let (dx, _) = DIRECTIONS[turned(1) as usize];
            let (vertical, horizontal) =
                if dx == 0 { (turned(1), turned(7)) } else { (turned(7), turned(1)) };
            for direction in [vertical, horizontal, reached] {
                self.jump(cell, direction, sink);
            }
        } else {
            let sides = if reached == 0 || reached == 6 { [2, 6] } else { [6, 2] };
            self.jump(cell, reached, sink);
            // Without an obstacle behind, a turn to that side would have come earlier.
            let free = self.query.map.free_around(cell);
            let forced = |side: &&u8| !self.prune || free >> turned(if **side == 2 { 3 } else { 5 }) & 1 == 0;
            for side in sides.iter().filter(forced) {
                // A diagonal jump asks for both cells beside it.
                self.jump(cell, turned(if *side == 2 { 1 } else { 7 }), sink);
            }
            for side in sides.iter().filter(forced) {
                self.jump(cell, turned(*side), sink);
            }
        }
    }

    fn heuristic(&self, node: NodeId, _: u8) -> i64 {
        let at = self.query.map.cell(node);
        octile(self.query.goal.x - at.x, self.query.goal.y - at.y)
    }

    fn finish(&mut self, at: Visit<i64, u8>, _: i64) -> Option<Finish<i64, ()>> {
        (at.node == self.query.map.index(self.query.goal)).then_some(Finish { cost: 0, tail: () })
    }
}

/// Searches the cheapest path over the cells of a map, given as bits, too. The report's path has every cell.
///
/// `config` must be valid ([`Config::validate`]); `observer` is `()` where nobody watches.
///
/// ```
/// use parkade::map::{Bits, Cell, Occupancy};
/// use parkade::planners::jump_point::{Config, plan};
/// use parkade::planners::query::{GridScratch, Query};
///
/// let map = Occupancy::parse("....\n.##.\n....");
/// let query = Query { map: &map, start: Cell::new(0, 0), goal: Cell::new(3, 2) };
/// let report = plan(query, &Bits::new(&map), &Config::default(), &mut GridScratch::new(), &mut ());
/// assert_eq!(report.cost_micro, 5_000_000);
/// ```
pub fn plan<O: Observer<i64, u8>>(
    query: Query,
    bits: &Bits,
    config: &Config,
    scratch: &mut GridScratch,
    observer: &mut O,
) -> GridReport {
    if let Some(report) = query.trivial() {
        return report;
    }
    let prune = config.prune;
    let mut jumps = Jumps { query, bits, prune, scanned: Counter::new(0) };
    let limits = Limits { max_expansions: config.common.max_expansions, first: true };
    let (start, _) = query.ends();
    let search = best_first(&mut jumps, (start, START), limits, &mut scratch.jumps, observer);
    let mut report = GridReport::of(&query, &search, &scratch.jumps, 0);
    report.cost_micro = search.found.map_or(0, |found| found.1);
    report.cells = stepwise(&report.cells);
    report.cells_scanned = jumps.scanned.get();
    report
}

/// The cells between jump points: diagonal steps first, as they were found.
fn stepwise(jumps: &[Cell]) -> Vec<Cell> {
    let mut cells: Vec<Cell> = jumps.iter().take(1).copied().collect();
    for pair in jumps.windows(2) {
        let mut at = pair[0];
        while at != pair[1] {
            at = at.offset((pair[1].x - at.x).signum(), (pair[1].y - at.y).signum());
            cells.push(at);
        }
    }
    cells
}

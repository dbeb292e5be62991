//! Jump point search: the cheapest eight-neighbour path with strict corners, by looking along lines instead of at
//! neighbours (Harabor and Grastien 2011), 64 cells at a time (2014).
//!
//! Of the many equally cheap ways over open ground only those are followed that go diagonally first, and of their
//! cells only those become nodes where an obstacle forces a turn. Few expansions are not little work:
//! [`GridReport::cells_scanned`] counts the cells looked at.
//!
//! A straight jump runs from a cell until it meets the goal, a wall, or a cell beside which a wall ends: behind the
//! wall lies a *forced neighbour*, which no cheaper way reaches. A diagonal jump tries straight jumps to both of its
//! sides at each cell. A jump ends only where a turn can be worthwhile, so a search expands turns, not cells:
//!
//! ```text
//! . . . # f        x jumps east; at n the wall above ends,
//! x → → → n        so f is a forced neighbour and n becomes a node
//! ```
//!
//! Straight jumps read rows and columns as bitmaps, 64 cells at a time, and find the end by counting zeros. Costs,
//! estimates and paths' costs are those of eight neighbours. All free cells must cost the same, else a turn might be
//! worthwhile anywhere.

use std::cell::Cell as Counter;

use super::grid_planner::{GridPlanner, Prepared};
use super::heuristics::octile;
use super::moves::{D, DIRECTIONS, R2};
use super::parameters::{Form, parameters, spec};
use super::query::{GridReport, GridScratch, Query};
use super::settings::Common;
use crate::map::{Bits, Cell};
use crate::search::lattice::{Edge, EdgeSink, Lattice};
use crate::search::one_way;
use crate::search::{
    Considered, Legality, NodeId, Observer, Observers, PackedEntry, Part, Recording, record_one_way,
};

parameters! {
    /// Settings of jump point search. Corners are strict.
    #[derive(Debug, Clone, Copy, PartialEq)]
    pub struct Config {
        /// True if turns that no obstacle forces are passed over: those of a diagonal jump into a straight one, and
        /// those to the free side of a straight jump's end.
        prune: bool = true,
            spec("prune", Form::Flag, "1", false,
                 ["Skip free turns", "跳过自由转折"],
                 ["Expands only cells where an obstacle forces a turn: the same cost from fewer expansions.",
                  "只扩展被障碍迫使转向的栅格：代价相同，扩展更少。"]);
    }
    /// The settings that all grid planners share.
    shared common: Common = Common::PLAIN, without "corner";
}

impl GridPlanner for Config {
    fn common(&self) -> Common {
        self.common
    }

    fn run(&self, at: Prepared, scratch: &mut GridScratch, observers: &mut Observers) -> GridReport {
        plan(at.query, prepared(at), self, scratch, observers)
    }

    fn record(&self, at: Prepared, limit: usize) -> Option<Recording> {
        Some(record(at.query, prepared(at), self, limit))
    }

    fn needs_bits(&self) -> bool {
        true
    }
}

fn prepared(at: Prepared<'_>) -> &Bits {
    at.bits.expect("prepared before the search")
}

struct Jumps<'a> {
    query: Query<'a>,
    bits: &'a Bits,
    prune: bool,
    scanned: Counter<u32>,
}

impl Jumps<'_> {
    /// The directions in which a jump from a cell leads anywhere, or might lead to the goal.
    #[inline]
    fn ways(&self, from: Cell) -> u32 {
        let mut ways = self.bits.ways(from);
        let goal = self.query.goal;
        if from.x == goal.x || from.y == goal.y {
            let straight = if from.x == goal.x { 0b0100_0100 } else { 0b0001_0001 };
            ways |= self.query.map.free_around(from) & straight;
        }
        u32::from(ways)
    }

    /// The straight jump from a cell in one of its [`Jumps::ways`]: where it gets and the number of steps, if it gets
    /// anywhere.
    #[inline(always)]
    fn straight(&self, from: Cell, direction: u32) -> Option<(Cell, i64)> {
        let goal = self.query.goal;
        let (dx, dy) = DIRECTIONS[direction as usize % 8];
        let mut steps = self.bits.straight(from, direction / 2) as i32;
        let (x, y) = (goal.x - from.x, goal.y - from.y);
        let scanned = self.scanned.get() + steps as u32;
        self.scanned.set(scanned);
        if x * dy == y * dx {
            // The goal is free, so it is before a wall.
            let far = x * dx + y * dy;
            if (1..=steps).contains(&far) {
                steps = far;
            } else if self.bits.ways(from) >> direction & 1 == 0 {
                return None;
            }
        }
        Some((from.offset(dx * steps, dy * steps), i64::from(steps)))
    }

    /// Offers a node that is reached in a direction.
    #[inline(always)]
    fn emit<S: EdgeSink>(&self, to: Cell, cost: i64, direction: u32, sink: &mut S) {
        let node = self.query.map.index(to);
        if sink.improves(node, cost) {
            sink.relax(Edge::new(direction, cost), node, self.ahead(to));
        }
    }

    fn ahead(&self, at: Cell) -> i64 {
        octile(self.query.goal.x - at.x, self.query.goal.y - at.y)
    }

    /// Jumps in one of a cell's [`Jumps::ways`].
    fn jump<S: EdgeSink>(&self, from: Cell, direction: u32, sink: &mut S) {
        if direction % 2 == 1 {
            self.diagonal(from, direction, sink);
        } else if let Some((to, steps)) = self.straight(from, direction) {
            self.emit(to, steps * D, direction, sink);
        }
    }

    /// Jumps diagonally from a cell. At each cell on the way the two straight jumps beside it are looked at. With
    /// pruning what they find is a successor itself, at the cost of both parts, and the jump goes on; without, it ends
    /// at the cell in between.
    fn diagonal<S: EdgeSink>(&self, from: Cell, direction: u32, sink: &mut S) {
        let goal = self.query.goal;
        let (dx, dy) = DIRECTIONS[direction as usize % 8];
        let (left, right) = ((direction + 1) % 8, (direction + 7) % 8);
        // The vertical jump first, as at an expansion.
        let sides = if left % 4 == 2 { [left, right] } else { [right, left] };
        let (mut at, mut cost, mut scanned) = (from, 0, 0);
        let mut goes_on = true;
        while goes_on {
            at = at.offset(dx, dy);
            cost += R2;
            scanned += 1;
            if at == goal {
                self.emit(at, cost, direction, sink);
                break;
            }
            let ways = self.ways(at);
            goes_on = ways >> direction & 1 == 1;
            let mut open = ways >> sides[0] & 1 | (ways >> sides[1] & 1) << 1;
            while open != 0 {
                let side = sides[open.trailing_zeros() as usize % 2];
                open &= open - 1;
                if let Some((to, steps)) = self.straight(at, side) {
                    if self.prune {
                        self.emit(to, cost + steps * D, side, sink);
                    } else {
                        self.emit(at, cost, direction, sink);
                        goes_on = false;
                        break;
                    }
                }
            }
        }
        self.scanned.set(self.scanned.get() + scanned);
    }
}

impl Lattice for Jumps<'_> {
    type Entry = PackedEntry;

    /// A move's number is the direction in which the node was reached, as in [`DIRECTIONS`].
    const JUMPS: bool = true;

    fn node_count(&self) -> usize {
        self.query.map.len()
    }

    fn successors<S: EdgeSink>(&self, node: NodeId, last: Option<u32>, sink: &mut S) {
        let cell = self.query.map.cell(node);
        let ways = self.ways(cell);
        let Some(reached) = last else {
            return (0..8).filter(|&c| ways >> c & 1 == 1).for_each(|c| self.jump(cell, c, sink));
        };
        let mut open = (ways as u8).rotate_right(reached);
        if reached % 2 == 0 && self.prune {
            // Without an obstacle behind, a turn to that side would have come earlier.
            let free = self.query.map.free_around(cell).rotate_right(reached);
            let [left, right] = [3, 5].map(|behind| free >> behind & 1);
            open &= !(left * 0b110 + right * 0b1100_0000);
        }
        // A list of what is open, instead of a question for each: processors guess badly which ones are.
        let mut turns = TURNS[reached as usize % 8][usize::from(open & 7 | open >> 3 & 0b1_1000)];
        while turns != 0 {
            self.jump(cell, (reached + turns) % 8, sink);
            turns >>= 4;
        }
    }

    fn before(&self, node: NodeId, _: u32) -> NodeId {
        node
    }

    fn to_goal(&self, node: NodeId) -> i64 {
        self.ahead(self.query.map.cell(node))
    }
}

/// Every jump that a node's moves lead to, as if each improved its target.
struct AllJumps<'a>(&'a mut dyn FnMut(NodeId, i64, Legality));

impl EdgeSink for AllJumps<'_> {
    fn improves(&self, _: NodeId, _: i64) -> bool {
        true
    }

    fn improves_around(&self, _: NodeId, _: usize, _: i64, _: i64) -> u32 {
        0xff
    }

    fn improves_beside(&self, _: NodeId, _: usize, _: i64) -> u32 {
        0b0101_0101
    }

    fn relax(&mut self, edge: Edge, target: NodeId, _: i64) {
        (self.0)(target, edge.cost(), Legality::Free);
    }
}

impl Considered for Jumps<'_> {
    fn consider(
        &self,
        node: NodeId,
        last: Option<u32>,
        _: Part,
        tell: &mut dyn FnMut(NodeId, i64, Legality),
    ) {
        self.successors(node, last, &mut AllJumps(tell));
    }
}

/// The turns to try at a node, in their order: four bits each, the highest one set. By the direction in which the node
/// was reached, and by which turns are open: from the lowest bit those by 0, 1, 2, 6 and 7 eighths.
static TURNS: [[u32; 32]; 8] = {
    let mut table = [[0; 32]; 8];
    let mut reached = 0;
    while reached < 8 {
        // To where one comes diagonally, the vertical way is first.
        let order: [u32; 5] = match reached {
            1 | 5 => [1, 7, 0, 8, 8],
            3 | 7 => [7, 1, 0, 8, 8],
            0 | 6 => [0, 1, 7, 2, 6],
            _ => [0, 7, 1, 6, 2],
        };
        let mut open = 0;
        while open < 32 {
            let (mut place, mut k) = (0, 0);
            while k < 5 {
                let bit = if order[k] < 3 { order[k] } else { order[k] - 3 };
                if order[k] < 8 && open >> bit & 1 == 1 {
                    table[reached][open] |= (8 | order[k]) << (4 * place);
                    place += 1;
                }
                k += 1;
            }
            open += 1;
        }
        reached += 1;
    }
    table
};

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
pub fn plan<O: Observer<i64, ()>>(
    query: Query,
    bits: &Bits,
    config: &Config,
    scratch: &mut GridScratch,
    observer: &mut O,
) -> GridReport {
    if let Some(report) = query.trivial() {
        return report;
    }
    let jumps = Jumps { query, bits, prune: config.prune, scanned: Counter::new(0) };
    let most = config.common.max_expansions;
    let found = one_way(&jumps, query.ends(), most, &mut scratch.lattice, observer);
    let mut report = GridReport::along(&query, &found, 0);
    report.cells = stepwise(&report.cells);
    report.cells_scanned = Some(jumps.scanned.get());
    report
}

/// The same search with its events written down, at most `limit` of them.
pub fn record(query: Query, bits: &Bits, config: &Config, limit: usize) -> Recording {
    if query.trivial().is_some() {
        return Recording::empty();
    }
    let jumps = Jumps { query, bits, prune: config.prune, scanned: Counter::new(0) };
    record_one_way(&jumps, query.ends(), config.common.max_expansions, limit)
}

/// The cells between jump points: diagonal steps first, as they were found.
fn stepwise(jumps: &[Cell]) -> Vec<Cell> {
    let between = |pair: &[Cell]| (pair[1].x - pair[0].x, pair[1].y - pair[0].y);
    let steps = |(dx, dy): (i32, i32)| dx.abs().max(dy.abs()) as usize;
    let mut cells = Vec::with_capacity(1 + jumps.windows(2).map(|pair| steps(between(pair))).sum::<usize>());
    cells.extend(jumps.first());
    for pair in jumps.windows(2) {
        let (dx, dy) = between(pair);
        let diagonal = dx.abs().min(dy.abs());
        cells.extend((1..=diagonal).map(|k| pair[0].offset(k * dx.signum(), k * dy.signum())));
        let (corner, rest) =
            (pair[0].offset(diagonal * dx.signum(), diagonal * dy.signum()), steps((dx, dy)));
        let (right, up) = if dx.abs() > dy.abs() { (dx.signum(), 0) } else { (0, dy.signum()) };
        cells.extend((1..=rest as i32 - diagonal).map(|k| corner.offset(k * right, k * up)));
    }
    cells
}

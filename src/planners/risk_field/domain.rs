//! The search domain of risk-field A*.
//!
//! The search asks for the steps of a cell in two parts. First come the three directions that the force picks, with
//! the extensions of diagonal ones (in straight mode of the middle one); the other five are deferred and come when
//! the search's rule says so. Nothing is computed twice: the bits of all eight steps that are free, and that would
//! improve their targets, are read once and split by a mask.
//!
//! The estimate in integers, for differences x ≥ y of columns and rows: with a diagonal part √2·y and a straight part
//! x − y, the weight w1 belongs to the larger part and w2 to the other. The result is linear in x and y within a
//! mode,
//!
//! ```text
//! h = a · x + b · y          (a, b) by mode and heuristic
//! ```
//!
//! so two multiplications give it, and the distance weight of eq 12 multiplies the sum. The weights are free, so
//! priorities may be negative or reach 2⁴⁸; entries are therefore wide ones.
//!
//! A move's number is 8·k + c for k extra steps in direction c, so that it alone gives the origin
//! ([`Lattice::before`]).

use std::cell::Cell as Counter;

use super::config::{Config, Heuristic, permille};
use super::directions::{is_oblique, primaries, region};
use crate::map::risk::PotentialField;
use crate::map::{Cell, Corner, line_of_sight};
use crate::planners::grid_lattice::legality;
use crate::planners::heuristics::DistanceWeight;
use crate::planners::moves::{D, DIRECTIONS, LEGAL, R2, cost};
use crate::planners::query::Query;
use crate::search::lattice::{Deferral, Deferring, Edge, EdgeSink, Lattice};
use crate::search::{Considered, Legality, Part};
use crate::search::{NodeId, WideEntry};

/// One query as a lattice. Counters are cells, because a lattice is asked by shared reference.
pub(super) struct RiskGrid<'a> {
    query: Query<'a>,
    field: PotentialField<'a>,
    weight: DistanceWeight,
    /// Amounts that one step of the larger and one of the smaller difference add to `unit` times the estimate, in
    /// straight mode and in oblique mode.
    estimates: [(i64, i64); 2],
    /// 1 where the weights are whole, else 1000.
    unit: i64,
    ext_len: i32,
    goal_side: bool,
    goal_shot: bool,
    corner: Corner,
    deferral: Deferral,
    /// How much larger the number of a neighbour is, by direction.
    offsets: [i32; 8],
    legal: &'static [u8; 256],
    los_calls: Counter<u32>,
    /// The central direction at the cell that was expanded last.
    center: Counter<usize>,
    /// The steps held back there that would improve what is known of their targets, and the legal ones of all.
    others: Counter<(u32, u32)>,
}

impl<'a> RiskGrid<'a> {
    pub(super) fn new(query: Query<'a>, config: &Config, weight: DistanceWeight, deferral: Deferral) -> Self {
        let (w1, w2) = (permille(config.w1), permille(config.w2));
        let unit = if w1 % 1000 == 0 && w2 % 1000 == 0 { 1 } else { 1000 };
        Self {
            query,
            field: config.field(&query),
            weight,
            estimates: estimates(config.heuristic, (w1 * unit / 1000, w2 * unit / 1000), unit),
            unit,
            ext_len: config.ext_len as i32,
            goal_side: config.goal_side,
            goal_shot: config.goal_shot,
            corner: config.common.corner,
            deferral,
            offsets: DIRECTIONS.map(|(dx, dy)| dy * query.map.width() as i32 + dx),
            legal: &LEGAL[config.common.corner as usize],
            los_calls: Counter::new(0),
            center: Counter::new(0),
            others: Counter::new((0, 0)),
        }
    }

    /// Line-of-sight questions so far: one for each move that would improve its target.
    pub(super) fn los_calls(&self) -> u32 {
        self.los_calls.get()
    }

    /// Columns and rows from a cell to the goal.
    fn toward_goal(&self, at: Cell) -> (i32, i32) {
        (self.query.goal.x - at.x, self.query.goal.y - at.y)
    }

    fn count_los(&self, calls: u32) {
        self.los_calls.set(self.los_calls.get() + calls);
    }

    /// The steps from a cell that lead to free cells and would improve what is known of them, and those of all that are
    /// legal.
    #[inline(always)]
    fn look<S: EdgeSink>(&self, node: NodeId, sink: &S) -> (u32, u32) {
        let free = self.query.map.free_around_index(node);
        let worth = sink.improves_around(node, self.query.map.width() as usize, D, R2);
        (worth & u32::from(free), u32::from(self.legal[usize::from(free)]))
    }

    /// Relaxes the single step in direction `c`, which is known to be legal and to improve its target.
    #[inline]
    fn step<S: EdgeSink>(&self, (node, at): (NodeId, Cell), c: usize, sink: &mut S) {
        let (dx, dy) = DIRECTIONS[c % 8];
        let to = node.wrapping_add_signed(self.offsets[c % 8]);
        sink.relax(Edge::new(c as u32, step_cost(c)), to, self.ahead(at.offset(dx, dy)));
    }

    /// Offers the steps of two and more cells in one direction, where a step of one is legal or not.
    fn extensions<S: EdgeSink>(&self, (node, at): (NodeId, Cell), c: usize, mut is_open: bool, sink: &mut S) {
        let (map, (dx, dy), offset) = (self.query.map, DIRECTIONS[c % 8], self.offsets[c % 8]);
        let is_legal = |from: NodeId| self.legal[usize::from(map.free_around_index(from))] >> c & 1 == 1;
        let (mut before, mut to) = (node, at.offset(dx, dy));
        let mut count = 0;
        while count < self.ext_len {
            count += 1;
            // Sight along the line asks whether each step is legal.
            is_open = is_open && (count == 1 || is_legal(before));
            (before, to) = (before.wrapping_add_signed(offset), to.offset(dx, dy));
            if map.blocked(to) {
                continue;
            }
            let (target, cost) = (before.wrapping_add_signed(offset), i64::from(count + 1) * step_cost(c));
            if sink.improves(target, cost) {
                self.count_los(1);
                if is_open && is_legal(before) {
                    sink.relax(Edge::new(count as u32 * 8 + c as u32, cost), target, self.ahead(to));
                }
            }
        }
    }

    /// True if a step in direction `c` increases the distance to the goal's column or row.
    fn leads_away(&self, at: Cell, c: usize) -> bool {
        let (dx, dy) = self.toward_goal(at);
        DIRECTIONS[c].0 * dx < 0 || DIRECTIONS[c].1 * dy < 0
    }
}

/// [`RiskGrid::estimates`] of w1 and w2 times `unit`: w1 is the weight of the kind of steps that prevail.
fn estimates(heuristic: Heuristic, (w1, w2): (i64, i64), unit: i64) -> [(i64, i64); 2] {
    [(w2, w1), (w1, w2)].map(|(diagonal, straight)| match heuristic {
        Heuristic::Corrected => (straight * D, diagonal * R2 - straight * D),
        Heuristic::Printed => (straight * D, diagonal * 2 * D + straight * (D - 2 * R2)),
        Heuristic::Octile => (unit * D, unit * (R2 - D)),
    })
}

const DIAGONALS: u32 = 0b1010_1010;

/// A bit for each of some directions.
const fn mask(directions: [usize; 3]) -> u32 {
    1 << directions[0] | 1 << directions[1] | 1 << directions[2]
}

/// Micro-cells of a single step.
const fn step_cost(direction: usize) -> i64 {
    if direction.is_multiple_of(2) { D } else { R2 }
}

impl RiskGrid<'_> {
    /// The weighted estimate.
    pub(super) fn ahead(&self, at: Cell) -> i64 {
        let (dx, dy) = self.toward_goal(at);
        let (x, y) = (i64::from(dx.abs()), i64::from(dy.abs()));
        let (by_far, by_near) = self.estimates[usize::from(is_oblique(dx, dy))];
        let h = by_far * x.max(y) + by_near * x.min(y);
        self.weight.apply(if self.unit == 1 { h } else { h.div_euclid(self.unit) }, dx, dy)
    }

    /// Takes the steps of which a bit each is set.
    #[inline]
    fn take_all<S: EdgeSink>(&self, node: NodeId, mut steps: u32, sink: &mut S) {
        if steps == 0 {
            return;
        }
        let at = self.query.map.cell(node);
        while steps != 0 {
            self.step((node, at), steps.trailing_zeros() as usize, sink);
            steps &= steps - 1;
        }
    }
}

impl Lattice for RiskGrid<'_> {
    type Entry = WideEntry;

    fn node_count(&self) -> usize {
        self.query.map.len()
    }

    fn padding(&self) -> usize {
        self.query.map.width() as usize + 1
    }

    fn successors<S: EdgeSink>(&self, node: NodeId, _: Option<u32>, sink: &mut S) {
        let at = self.query.map.cell(node);
        let (dx, dy) = self.toward_goal(at);
        let oblique = is_oblique(dx, dy);
        let center = region(self.field.force(at), oblique);
        self.center.set(center);
        let picked = mask(primaries(center));
        let (worth, legal) = self.look(node, sink);
        self.others.set((worth & !picked, legal));
        self.count_los((worth & picked).count_ones());
        // As seen in the central direction: itself, its left neighbour, and its right one last.
        let turned = |directions: u32| u32::from((directions as u8).rotate_right(center as u32));
        let mut steps = turned(worth & legal & picked);
        while steps != 0 {
            self.step((node, at), (center + steps.trailing_zeros() as usize) % 8, sink);
            steps &= steps - 1;
        }
        let mut stretched = [1, turned(picked & DIAGONALS)][usize::from(oblique)];
        while stretched != 0 {
            let c = (center + stretched.trailing_zeros() as usize) % 8;
            stretched &= stretched - 1;
            if !(self.goal_side && oblique && self.leads_away(at, c)) {
                self.extensions((node, at), c, legal >> c & 1 == 1, sink);
            }
        }
    }

    /// The goal where it is in sight.
    fn direct(&self, node: NodeId) -> Option<i64> {
        if !self.goal_shot {
            return None;
        }
        self.count_los(1);
        let at = self.query.map.cell(node);
        let (dx, dy) = self.toward_goal(at);
        line_of_sight(self.query.map, at, self.query.goal, self.corner).then(|| cost(dx, dy))
    }

    fn before(&self, node: NodeId, number: u32) -> NodeId {
        node.wrapping_add_signed(-(number as i32 / 8 + 1) * self.offsets[number as usize % 8])
    }

    fn to_goal(&self, node: NodeId) -> i64 {
        self.ahead(self.query.map.cell(node))
    }
}

impl Deferring for RiskGrid<'_> {
    /// The central direction: the force at a cell is not computed twice.
    fn payload(&self) -> u32 {
        self.center.get() as u32
    }

    fn deferred_successors<S: EdgeSink>(&self, node: NodeId, payload: u32, sink: &mut S) {
        let (worth, legal) = self.look(node, sink);
        let worth = worth & !mask(primaries(payload as usize));
        self.count_los(worth.count_ones());
        self.take_all(node, worth & legal, sink);
    }

    fn deferred_at_once<S: EdgeSink>(&self, node: NodeId, sink: &mut S) {
        let (worth, legal) = self.others.get();
        self.count_los(worth.count_ones());
        self.take_all(node, worth & legal, sink);
    }

    fn deferral(&self) -> Deferral {
        self.deferral
    }
}

impl Considered for RiskGrid<'_> {
    fn consider(
        &self,
        node: NodeId,
        _: Option<u32>,
        part: Part,
        tell: &mut dyn FnMut(NodeId, i64, Legality),
    ) {
        let (map, at) = (self.query.map, self.query.map.cell(node));
        let (dx, dy) = self.toward_goal(at);
        let oblique = is_oblique(dx, dy);
        let picked = primaries(region(self.field.force(at), oblique));
        let mut offer = |c: usize, steps: i32| {
            let to = at.offset(steps * DIRECTIONS[c].0, steps * DIRECTIONS[c].1);
            if map.contains(to) {
                tell(map.index(to), i64::from(steps) * step_cost(c), legality(map, at, to, self.corner));
            }
        };
        if part == Part::Deferred {
            return (0..8).filter(|c| !picked.contains(c)).for_each(|c| offer(c, 1));
        }
        for c in picked {
            offer(c, 1);
        }
        for (i, c) in picked.into_iter().enumerate() {
            let is_stretched = if oblique { c % 2 == 1 } else { i == 0 };
            if is_stretched && !(self.goal_side && oblique && self.leads_away(at, c)) {
                (2..=self.ext_len + 1).for_each(|steps| offer(c, steps));
            }
        }
    }
}

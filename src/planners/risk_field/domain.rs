//! The search domain of risk-field A*.

use std::cell::Cell as Counter;

use super::directions::{is_oblique, primaries, region};
use super::{Config, Heuristic, permille};
use crate::map::risk::PotentialField;
use crate::map::{Cell, Corner, line_of_sight};
use crate::planners::heuristics::{DistanceWeight, octile};
use crate::planners::moves::{D, DIRECTIONS, LEGAL, R2, cost};
use crate::planners::query::Query;
use crate::search::lattice::{Hold, Lattice, Sink};
use crate::search::{NodeId, Wide};

pub(super) struct RiskGrid<'a> {
    query: Query<'a>,
    field: PotentialField<'a>,
    weight: DistanceWeight,
    heuristic: Heuristic,
    /// w1 and w2, thousandths.
    weights: (i64, i64),
    ext_len: i32,
    goal_side: bool,
    goal_shot: bool,
    corner: Corner,
    hold: Hold,
    /// How much larger the number of a neighbour is, by direction.
    offsets: [i32; 8],
    legal: &'static [u8; 256],
    los_calls: Counter<u32>,
    /// The central direction at the cell that was expanded last.
    center: Counter<usize>,
}

impl<'a> RiskGrid<'a> {
    pub(super) fn new(query: Query<'a>, config: &Config, weight: DistanceWeight, hold: Hold) -> Self {
        Self {
            query,
            field: config.field(&query),
            weight,
            heuristic: config.heuristic,
            weights: (permille(config.w1), permille(config.w2)),
            ext_len: config.ext_len as i32,
            goal_side: config.goal_side,
            goal_shot: config.goal_shot,
            corner: config.common.corner,
            hold,
            offsets: DIRECTIONS.map(|(dx, dy)| dy * query.map.width() as i32 + dx),
            legal: &LEGAL[config.common.corner as usize],
            los_calls: Counter::new(0),
            center: Counter::new(0),
        }
    }

    pub(super) fn los_calls(&self) -> u32 {
        self.los_calls.get()
    }

    fn toward_goal(&self, at: Cell) -> (i32, i32) {
        (self.query.goal.x - at.x, self.query.goal.y - at.y)
    }

    fn count_los(&self) {
        self.los_calls.set(self.los_calls.get() + 1);
    }

    fn steps<S: Sink>(
        &self,
        (node, at): (NodeId, Cell),
        directions: impl Iterator<Item = usize>,
        sink: &mut S,
    ) {
        let free = self.query.map.free_around(at);
        let legal = self.legal[usize::from(free)];
        for c in directions.filter(|c| free >> c & 1 == 1) {
            let to = node.wrapping_add_signed(self.offsets[c]);
            if sink.worth(to, step_cost(c)) {
                self.count_los();
                if legal >> c & 1 == 1 {
                    let (dx, dy) = DIRECTIONS[c];
                    sink.take(c as u32, to, step_cost(c), self.ahead(at.offset(dx, dy)));
                }
            }
        }
    }

    fn extensions<S: Sink>(&self, (node, at): (NodeId, Cell), c: usize, sink: &mut S) {
        let map = self.query.map;
        for k in 2..=self.ext_len + 1 {
            let to = at.offset(k * DIRECTIONS[c].0, k * DIRECTIONS[c].1);
            if map.blocked(to) {
                continue;
            }
            let (target, step) = (node.wrapping_add_signed(k * self.offsets[c]), i64::from(k) * step_cost(c));
            if sink.worth(target, step) {
                self.count_los();
                if self.is_open(at, c, k) {
                    sink.take((k - 1) as u32 * 8 + c as u32, target, step, self.ahead(to));
                }
            }
        }
    }

    /// Whether `count` single steps from a cell are legal, which is what sight along them asks.
    fn is_open(&self, at: Cell, c: usize, count: i32) -> bool {
        let (dx, dy) = DIRECTIONS[c];
        (0..count).all(|k| {
            let free = self.query.map.free_around(at.offset(k * dx, k * dy));
            self.legal[usize::from(free)] >> c & 1 == 1
        })
    }

    fn leads_away(&self, at: Cell, c: usize) -> bool {
        let (dx, dy) = self.toward_goal(at);
        DIRECTIONS[c].0 * dx < 0 || DIRECTIONS[c].1 * dy < 0
    }
}

const fn step_cost(direction: usize) -> i64 {
    if direction.is_multiple_of(2) { D } else { R2 }
}

impl RiskGrid<'_> {
    /// The weighted estimate.
    pub(super) fn ahead(&self, at: Cell) -> i64 {
        let (dx, dy) = self.toward_goal(at);
        let (x, y) = (i64::from(dx.abs()), i64::from(dy.abs()));
        let (far, near) = (x.max(y), x.min(y));
        let (diagonal, straight) =
            if is_oblique(dx, dy) { self.weights } else { (self.weights.1, self.weights.0) };
        let h = match self.heuristic {
            Heuristic::Corrected => (diagonal * R2 * near + straight * D * (far - near)) / 1000,
            Heuristic::Printed => {
                (diagonal * 2 * D * near + straight * (D * (far + near) - 2 * R2 * near)) / 1000
            }
            Heuristic::Octile => octile(dx, dy),
        };
        self.weight.apply(h, dx, dy)
    }
}

impl Lattice for RiskGrid<'_> {
    type Entry = Wide;

    const HOLDS_BACK: bool = true;

    fn node_count(&self) -> usize {
        self.query.map.len()
    }

    fn successors<S: Sink>(&self, node: NodeId, _: Option<u32>, sink: &mut S) {
        let at = self.query.map.cell(node);
        let (dx, dy) = self.toward_goal(at);
        let oblique = is_oblique(dx, dy);
        let center = region(self.field.force(at), oblique);
        self.center.set(center);
        let picked = primaries(center);
        self.steps((node, at), picked.into_iter(), sink);
        if oblique {
            for c in picked.into_iter().filter(|c| c % 2 == 1) {
                if !(self.goal_side && self.leads_away(at, c)) {
                    self.extensions((node, at), c, sink);
                }
            }
        } else {
            self.extensions((node, at), picked[0], sink);
        }
    }

    fn predecessors<S: Sink>(&self, _: NodeId, _: Option<u32>, _: &mut S) {
        unreachable!("the field leads forwards");
    }

    /// The central direction: the force at a cell is not computed twice.
    fn note(&self) -> u32 {
        self.center.get() as u32
    }

    fn held_back<S: Sink>(&self, node: NodeId, note: u32, sink: &mut S) {
        let at = self.query.map.cell(node);
        let picked = primaries(note as usize);
        self.steps((node, at), (0..8).filter(|c| !picked.contains(c)), sink);
    }

    fn hold(&self) -> Hold {
        self.hold
    }

    /// The goal where it is in sight.
    fn shot(&self, node: NodeId) -> Option<i64> {
        if !self.goal_shot {
            return None;
        }
        self.count_los();
        let at = self.query.map.cell(node);
        let (dx, dy) = self.toward_goal(at);
        line_of_sight(self.query.map, at, self.query.goal, self.corner).then(|| cost(dx, dy))
    }

    fn after(&self, node: NodeId, number: u32) -> NodeId {
        node.wrapping_add_signed((number as i32 / 8 + 1) * self.offsets[number as usize % 8])
    }

    fn before(&self, node: NodeId, number: u32) -> NodeId {
        node.wrapping_add_signed(-(number as i32 / 8 + 1) * self.offsets[number as usize % 8])
    }

    fn to_goal(&self, node: NodeId) -> i64 {
        self.ahead(self.query.map.cell(node))
    }

    fn to_start(&self, _: NodeId) -> i64 {
        0
    }
}

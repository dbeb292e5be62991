//! The search domain of risk-field A*.

use std::cell::Cell as Counter;

use super::directions::{is_oblique, primaries, region};
use super::{Config, Heuristic, permille};
use crate::map::risk::PotentialField;
use crate::map::{Cell, Corner, line_of_sight};
use crate::planners::heuristics::{DistanceWeight, octile};
use crate::planners::moves::{D, DIRECTIONS, R2, cost, legal_steps};
use crate::planners::query::Query;
use crate::search::{Domain, Finish, Hold, NodeId, Relax, Visit};

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
    hold: Hold<i64>,
    los_calls: Counter<u32>,
}

impl<'a> RiskGrid<'a> {
    pub(super) fn new(query: Query<'a>, config: &Config, weight: DistanceWeight, hold: Hold<i64>) -> Self {
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
            los_calls: Counter::new(0),
        }
    }

    pub(super) fn los_calls(&self) -> u32 {
        self.los_calls.get()
    }

    fn to_goal(&self, at: Cell) -> (i32, i32) {
        (self.query.goal.x - at.x, self.query.goal.y - at.y)
    }

    fn count_los(&self) {
        self.los_calls.set(self.los_calls.get() + 1);
    }

    /// The central direction at a cell.
    fn center(&self, at: Cell) -> usize {
        let (dx, dy) = self.to_goal(at);
        region(self.field.force(at), is_oblique(dx, dy))
    }

    fn steps<S: Relax<i64, Cell>>(&self, at: Cell, directions: impl Iterator<Item = usize>, sink: &mut S) {
        let free = self.query.map.free_around(at);
        let legal = legal_steps(free, self.corner);
        for c in directions.filter(|c| free >> c & 1 == 1) {
            let to = at.offset(DIRECTIONS[c].0, DIRECTIONS[c].1);
            let (node, step) = (self.query.map.index(to), step_cost(c));
            if sink.worth(node, step) {
                self.count_los();
                if legal >> c & 1 == 1 {
                    sink.emit(node, step, to);
                }
            }
        }
    }

    fn extensions<S: Relax<i64, Cell>>(&self, at: Cell, c: usize, sink: &mut S) {
        let map = self.query.map;
        for k in 2..=self.ext_len + 1 {
            let to = at.offset(k * DIRECTIONS[c].0, k * DIRECTIONS[c].1);
            if map.blocked(to) {
                continue;
            }
            let (node, step) = (map.index(to), i64::from(k) * step_cost(c));
            if sink.worth(node, step) {
                self.count_los();
                if line_of_sight(map, at, to, self.corner) {
                    sink.emit(node, step, to);
                }
            }
        }
    }

    fn leads_away(&self, at: Cell, c: usize) -> bool {
        let (dx, dy) = self.to_goal(at);
        DIRECTIONS[c].0 * dx < 0 || DIRECTIONS[c].1 * dy < 0
    }
}

const fn step_cost(direction: usize) -> i64 {
    if direction.is_multiple_of(2) { D } else { R2 }
}

impl Domain for RiskGrid<'_> {
    type Cost = i64;
    type Label = Cell;
    type Tail = ();

    const HOLDS_BACK: bool = true;

    fn node_count(&self) -> usize {
        self.query.map.len()
    }

    fn successors<S: Relax<i64, Cell>>(&self, from: Visit<i64, Cell>, sink: &mut S) {
        let at = from.label;
        let (dx, dy) = self.to_goal(at);
        let oblique = is_oblique(dx, dy);
        let picked = primaries(region(self.field.force(at), oblique));
        self.steps(at, picked.into_iter(), sink);
        if oblique {
            for c in picked.into_iter().filter(|c| c % 2 == 1) {
                if !(self.goal_side && self.leads_away(at, c)) {
                    self.extensions(at, c, sink);
                }
            }
        } else {
            self.extensions(at, picked[0], sink);
        }
    }

    fn held_back<S: Relax<i64, Cell>>(&self, from: Visit<i64, Cell>, sink: &mut S) {
        let picked = primaries(self.center(from.label));
        self.steps(from.label, (0..8).filter(|c| !picked.contains(c)), sink);
    }

    fn hold(&self) -> Hold<i64> {
        self.hold
    }

    fn heuristic(&self, _: NodeId, at: Cell) -> i64 {
        let (dx, dy) = self.to_goal(at);
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

    fn finish(&mut self, at: Visit<i64, Cell>, _: i64) -> Option<Finish<i64, ()>> {
        if at.label == self.query.goal {
            return Some(Finish { cost: 0, tail: () });
        }
        if !self.goal_shot {
            return None;
        }
        self.count_los();
        let (dx, dy) = self.to_goal(at.label);
        let seen = line_of_sight(self.query.map, at.label, self.query.goal, self.corner);
        seen.then(|| Finish { cost: cost(dx, dy), tail: () })
    }
}

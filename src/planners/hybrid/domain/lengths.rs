//! Lengths of moves other than the level's own: of blocked moves, and of a car that shuffles.

use super::StateLattice;
use crate::geometry::Pose;
use crate::geometry::arcs::Arc;
use crate::planners::hybrid::state::State;
use crate::search::{Relax, Visit};

/// Moves while shuffling are at least this long, metres.
const MIN_SHUFFLE_MOVE: f64 = 0.01;
/// What is left of a blocked move is at least this long, metres.
const MIN_SHORTENED_MOVE: f64 = 0.02;

impl StateLattice<'_> {
    /// Emits a blocked move as far as it is free.
    pub(super) fn shorten<S: Relax<f64, State>>(
        &self,
        from: Visit<f64, State>,
        primitive: &Arc,
        sink: &mut S,
    ) {
        let State { pose, motion, .. } = from.label;
        let mut reach = self.ahead(&self.reach[0], pose);
        let far = if self.is_tightest(primitive) {
            reach.free_length(self.checker, primitive)
        } else {
            self.checker.free_length(pose, primitive, self.level.spacing, self.margin)
        };
        if far < MIN_SHORTENED_MOVE {
            return;
        }
        let length = far.copysign(primitive.length);
        let arc = Arc { length, ..*primitive };
        let cost = self.costs.arc(motion, &arc);
        let (end, motion) = (pose.advance_turned(reach.turned(), arc.curvature, length), motion.then(&arc));
        let node = self.node(end, motion.gear);
        if sink.improves(node, cost) {
            let cost = cost + self.costs.places(self.checker, pose, &arc);
            sink.emit(node, cost, State { pose: end, motion, length });
        }
    }

    /// How far to drive along a primitive: its length or, while shuffling, until something is in the way, and half as
    /// far.
    pub(super) fn lengths(&self, from: Pose, arc: &Arc) -> [f64; 2] {
        if !self.level.shuffles() {
            return [arc.length, 0.0];
        }
        let far = self.checker.free_length(from, arc, self.level.spacing, self.margin);
        [far, far / 2.0].map(|far| if far < MIN_SHUFFLE_MOVE { 0.0 } else { far.copysign(arc.length) })
    }
}

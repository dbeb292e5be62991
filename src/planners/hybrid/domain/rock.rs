//! Rocking: a move that turns the car nearly on the spot.

use super::StateLattice;
use crate::geometry::arcs::Arc;
use crate::planners::hybrid::cost::Motion;
use crate::planners::hybrid::state::{State, rock_arcs};
use crate::search::{Relax, Visit};

impl StateLattice<'_> {
    /// Turns nearly on the spot: a little way on one lock, twice as far back on the other, and the same way again. A
    /// state between would share its cell with others, one of which is kept.
    pub(super) fn rock<S: Relax<f64, State>>(&self, from: Visit<f64, State>, sink: &mut S) {
        let State { pose, motion, .. } = from.label;
        let gear = if motion.gear < 0 { -1.0 } else { 1.0 };
        for side in [1.0, -1.0] {
            let curvature = side * gear / self.costs.radius;
            let part = Arc { curvature, length: gear * self.costs.radius * self.level.rock / 4.0 };
            let (mut end, mut before, mut cost) = (pose, motion, 0.0);
            for arc in rock_arcs(part) {
                cost += self.costs.arc(before, &arc);
                before = Motion::after(&arc);
                end = end.advance(arc.curvature, arc.length);
            }
            let node = self.node(end, before.gear);
            if !sink.improves(node, cost) {
                continue;
            }
            let mut at = pose;
            let is_free = rock_arcs(part).iter().all(|arc| {
                let free = self.free(at, arc);
                at = at.advance(arc.curvature, arc.length);
                free
            });
            if is_free {
                let motion = Motion { is_rock: true, ..before };
                sink.emit(node, cost, State { pose: end, motion, length: part.length });
            }
        }
    }
}

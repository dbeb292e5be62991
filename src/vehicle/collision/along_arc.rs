//! Questions of a car that drives along an arc, asked of poses a little apart.
//!
//! Where the discs around the body have room, that room settles the poses ahead without a look. Elsewhere the exact
//! test tells how far the nearest edge is at least. As long as no point of the body moves farther than that, the next
//! poses are free without an exact test of their own. Checks are counted as if each had one.

use super::CollisionChecker;
use super::checker::{CONTACT, Placement};
use crate::geometry::arcs::Arc;
use crate::geometry::{Pose, math};

/// Poses of a long arc that are looked at first are this far apart, in spacings.
const STRIDE: u32 = 16;

/// Poses along an arc, equally far apart; the first has the number 0.
struct Samples {
    start: Placement,
    heading: f64,
    curvature: f64,
    /// Length of the arc from one to the next, with its sign, and the turn along it.
    part: f64,
    turn: f64,
    margin: f64,
    /// Of the discs that cover the body.
    radius: f64,
    /// How far a disc moves from one to the next, at most.
    disc_step: f64,
}

impl Samples {
    /// Sine and cosine of a pose's heading.
    fn turned(&self, number: u32) -> (f64, f64) {
        if self.turn == 0.0 {
            return (self.start.sin, self.start.cos);
        }
        math::sin_cos(self.heading + self.turn * f64::from(number))
    }

    /// A pose whose heading has this sine and cosine.
    fn at(&self, number: u32, (sin, cos): (f64, f64)) -> Placement {
        self.start.along(self.curvature, self.part * f64::from(number), sin, cos)
    }
}

impl CollisionChecker<'_> {
    /// True if the body with `margin` around it stays free along an arc, tested every `spacing` metres and at its end.
    ///
    /// The end is tested first: it is the farthest from what is known to be free. Where the body has room, the poses
    /// that the room covers are free without a test.
    pub fn arc_free(&self, from: Pose, arc: &Arc, spacing: f64, margin: f64) -> bool {
        self.hit_along(from, arc, spacing, margin).is_none()
    }

    /// Where the body with `margin` around it meets something on an arc, metres from its beginning, with its sign: the
    /// place that is found first, by the tests of [`CollisionChecker::arc_free`].
    pub fn hit_along(&self, from: Pose, arc: &Arc, spacing: f64, margin: f64) -> Option<f64> {
        if !self.corridor_holds(from, arc) {
            return Some(arc.length);
        }
        let steps = (arc.length.abs() / spacing).ceil().max(1.0);
        let part = arc.length / steps;
        let samples = Samples {
            start: Placement::of(from),
            heading: from.heading,
            curvature: arc.curvature,
            part,
            turn: arc.curvature * part,
            margin,
            radius: self.disc_radius(margin),
            disc_step: part.abs() * self.max_disc_speed(arc.curvature),
        };
        let mut checks = 0;
        let hit = self
            .hit_far_apart(&samples, steps as u32, &mut checks)
            .or_else(|| self.hit_one_by_one(&samples, steps as u32, &mut checks));
        self.count(checks);
        hit.map(|number| part * f64::from(number))
    }

    /// Looks at places far apart: what is in the way of a long arc is found soonest there.
    fn hit_far_apart(&self, samples: &Samples, last: u32, checks: &mut u32) -> Option<u32> {
        let mut far = last;
        while far > STRIDE {
            far -= STRIDE;
            *checks += 1;
            let place = samples.at(far, samples.turned(far));
            let spare = self.spare(place, samples.radius);
            if spare <= 0.0 && self.exact(place, samples.margin - CONTACT).is_some() {
                return Some(far);
            }
            far = far.saturating_sub((spare / samples.disc_step) as u32);
        }
        None
    }

    /// Looks at all poses that are not known to be free, from the last to the second.
    fn hit_one_by_one(&self, samples: &Samples, last: u32, checks: &mut u32) -> Option<u32> {
        let body_step = samples.part.abs() * self.max_body_speed(samples.curvature, samples.margin);
        // Poses from this one on are known to be free.
        let mut known = u32::MAX;
        let mut one_turn = None;
        let (mut k, (mut sin, mut cos)) = (last, samples.turned(last));
        loop {
            let place = samples.at(k, (sin, cos));
            *checks += 1;
            let spare = self.spare(place, samples.radius);
            if spare <= 0.0 && k < known {
                let Some(gap) = self.gap(place, samples.margin - CONTACT) else { return Some(k) };
                known = k.saturating_sub((gap / body_step) as u32);
            }
            let settled = ((spare / samples.disc_step) as u32).saturating_add(1);
            if settled >= k {
                return None;
            }
            k -= settled;
            (sin, cos) = if settled == 1 && samples.turn != 0.0 {
                let (turn_sin, turn_cos) = *one_turn.get_or_insert_with(|| math::sin_cos(samples.turn));
                (sin * turn_cos - cos * turn_sin, cos * turn_cos + sin * turn_sin)
            } else {
                samples.turned(k)
            };
        }
    }

    /// True if the body keeps a clearance along an arc, but for a tolerance, both in metres: looked at every `spacing`
    /// metres, or less often where there is room.
    ///
    /// This is the distance from the body to the nearest edge. The margin of the other questions makes the body larger,
    /// and its corners reach farther than that.
    pub fn keeps_clearance(
        &self,
        from: Pose,
        arc: &Arc,
        spacing: f64,
        (clearance, tolerance): (f64, f64),
    ) -> bool {
        if !self.corridor_holds(from, arc) {
            return false;
        }
        let whole = arc.length.abs();
        let mut kept = 0.0;
        loop {
            let [at, rest] = [kept, whole - kept].map(|length| length.copysign(arc.length));
            let pose = from.advance(arc.curvature, at);
            if self.clearance(pose, clearance) < clearance - tolerance {
                return false;
            }
            kept += self.free_length(pose, &Arc { length: rest, ..*arc }, spacing, clearance);
            if kept >= whole {
                return true;
            }
            kept = f64::min(kept + spacing, whole);
        }
    }

    /// How far the body with `margin` around it can drive along an arc until it meets something, metres without sign:
    /// tested every `spacing` metres, or less often where there is room, and the end told to a sixteenth of that.
    ///
    /// Sampling may miss an obstacle that is thinner than the body moves between two samples, as in
    /// [`CollisionChecker::arc_free`].
    pub fn free_length(&self, from: Pose, arc: &Arc, spacing: f64, margin: f64) -> f64 {
        let whole = arc.length.abs();
        let radius = self.disc_radius(margin);
        let max_disc_speed = self.max_disc_speed(arc.curvature);
        let start = Placement::of(from);
        let (mut reached, mut step) = (0.0, spacing);
        while reached < whole && step > spacing / 17.0 {
            let next = f64::min(reached + step, whole);
            let place = start.after(from.heading, arc.curvature, next.copysign(arc.length));
            self.count(1);
            let spare = self.spare(place, radius);
            if spare > 0.0 || self.exact(place, margin - CONTACT).is_none() {
                reached = f64::min(next + spare / max_disc_speed, whole);
            } else {
                step /= 2.0;
            }
        }
        reached
    }
}

#[cfg(test)]
mod tests;

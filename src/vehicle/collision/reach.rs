//! How far the body can go from one pose at full lock and straight on.
//!
//! Every Reeds–Shepp curve begins with one of six motions: full lock to either side or straight, in either gear. What
//! blocks one of them blocks every curve that begins with a longer one, so each motion is followed once, no farther
//! than it is asked for.
//!
//! A sample with spare room settles more than itself. If the nearest edge is s metres beyond what the discs need, and
//! no disc moves farther than v metres per metre of the arc, the next s/v metres are free without a look. Open space
//! is passed in a few steps, and only near obstacles the samples lie `spacing` apart.
//!
//! What is known of a motion is an interval: free up to one length, blocked from another on. A question between the
//! two costs one check, a longer one extends the interval, and all others cost nothing. How far the body can go is
//! found by halving the interval.

use super::CollisionChecker;
use super::checker::{CONTACT, Placement};
use crate::geometry::arcs::Arc;
use crate::geometry::reeds_shepp::Word;
use crate::geometry::{Pose, math};

/// Where a motion is blocked is told to such a part of the distance of its samples.
const PRECISION: f64 = 1.0 / 16.0;

/// How motions are sampled.
#[derive(Debug, Clone, Copy)]
pub struct Sampling {
    /// Distance of the samples, metres; more where the body has room.
    spacing: f64,
    /// Kept free around the body, metres.
    margin: f64,
    /// Sine and cosine of the turn from one sample to the next at full lock to the left.
    turn: (f64, f64),
}

impl Sampling {
    /// Samples `spacing` metres apart with `margin` metres around the body, for a car that turns with `radius` metres.
    pub fn new(spacing: f64, margin: f64, radius: f64) -> Self {
        Self { spacing, margin, turn: math::sin_cos(spacing / radius) }
    }
}

/// The known part of one motion.
/// `free` and `blocked` are lengths along the motion, without sign.
#[derive(Debug, Clone, Copy, Default)]
struct Motion {
    /// The body is free at every sample up to here, metres.
    free: f64,
    /// The first sample at which it is not, metres; 0 while none is known.
    blocked: f64,
}

/// The six motions from one pose, as far as they were followed.
/// The memory is valid for one pose, one margin and one set of obstacles; it is not told when these change.
#[derive(Debug, Clone)]
pub struct Reach {
    from: Pose,
    start: Placement,
    sampling: Sampling,
    motions: [Motion; 6],
}

/// Which of the six motions an arc belongs to.
fn number(arc: &Arc) -> usize {
    let side = if arc.curvature == 0.0 { 0 } else { 1 + usize::from(arc.curvature < 0.0) };
    2 * side + usize::from(arc.length < 0.0)
}

impl Reach {
    /// An empty memory: no motion has been followed yet.
    pub fn new(from: Pose, sampling: Sampling) -> Self {
        Self { from, start: Placement::of(from), sampling, motions: [Motion::default(); 6] }
    }

    /// Pose at which the motions begin.
    pub fn from(&self) -> Pose {
        self.from
    }

    /// Sine and cosine of that pose's heading.
    pub(crate) fn turned(&self) -> (f64, f64) {
        (self.start.sin, self.start.cos)
    }

    /// True if the body is free along an arc from the pose, at full lock or straight: at every sample and at its end.
    #[inline(never)]
    pub fn is_free(&mut self, checker: &CollisionChecker, arc: &Arc) -> bool {
        if !checker.corridor_holds(self.from, arc) {
            return false;
        }
        let length = arc.length.abs();
        let which = number(arc);
        let mut motion = self.motions[which];
        if length > motion.free && motion.blocked == 0.0 {
            motion = self.follow(checker, arc, motion.free);
            self.motions[which] = motion;
        }
        if length <= motion.free || (motion.blocked != 0.0 && length >= motion.blocked) {
            return length <= motion.free;
        }
        checker.count(1);
        self.is_free_after(checker, arc, arc.length)
    }

    /// How far the body can go along an arc from the pose, at full lock or straight, metres without sign; 0 where the
    /// arc leaves the corridor. What is blocked begins within a sixteenth of the samples' spacing behind that.
    pub fn free_length(&mut self, checker: &CollisionChecker, arc: &Arc) -> f64 {
        let whole = arc.length.abs();
        if self.is_free(checker, arc) {
            return whole;
        }
        if !checker.corridor_holds(self.from, arc) {
            return 0.0;
        }
        let Motion { free, blocked } = self.motions[number(arc)];
        let (mut free, mut blocked) = (free, if blocked == 0.0 { whole } else { blocked.min(whole) });
        while blocked - free > PRECISION * self.sampling.spacing {
            let middle = f64::midpoint(free, blocked);
            checker.count(1);
            if self.is_free_after(checker, arc, middle.copysign(arc.length)) {
                free = middle;
            } else {
                blocked = middle;
            }
        }
        self.motions[number(arc)] = Motion { free, blocked };
        free
    }

    /// True if the body is free where it stands after some metres, with sign, of an arc from the pose.
    fn is_free_after(&self, checker: &CollisionChecker, arc: &Arc, length: f64) -> bool {
        let (sin, cos) = math::sin_cos(self.from.heading + arc.curvature * length);
        checker.is_free_at(self.start.along(arc.curvature, length, sin, cos), self.sampling.margin)
    }

    /// True if the body is free along a word that leads from this pose to that of `back`, for turning radius `radius`.
    /// The word's ends come first: what is known of them decides most words.
    #[inline(never)]
    pub fn is_word_free(
        &mut self,
        back: &mut Self,
        checker: &CollisionChecker,
        word: &Word,
        radius: f64,
    ) -> bool {
        let mut arcs = word.arcs(radius);
        let (Some(first), last) = (arcs.next(), arcs.next_back()) else { return true };
        let is_last_free =
            last.is_none_or(|last| back.is_free(checker, &Arc { length: -last.length, ..last }));
        if !is_last_free || !self.is_free(checker, &first) {
            return false;
        }
        let Sampling { spacing, margin, .. } = self.sampling;
        let mut pose = self.from.advance(first.curvature, first.length);
        arcs.all(|arc| {
            let free = checker.arc_free(pose, &arc, spacing, margin);
            pose = pose.advance(arc.curvature, arc.length);
            free
        })
    }

    /// Follows an arc that is free for some metres until its end or what blocks it.
    #[inline(never)]
    fn follow(&self, checker: &CollisionChecker, arc: &Arc, mut free: f64) -> Motion {
        let Sampling { spacing, margin, turn } = self.sampling;
        let radius = checker.disc_radius(margin);
        let max_disc_speed = checker.max_disc_speed(arc.curvature);
        let (sign, length) = (1.0_f64.copysign(arc.length), arc.length.abs());
        let turn_sin = turn.0 * sign.copysign(arc.curvature * arc.length);
        let at = |along: f64| math::sin_cos(self.from.heading + arc.curvature * along * sign);
        let (mut sin, mut cos) = if free == 0.0 { (self.start.sin, self.start.cos) } else { at(free) };
        let max_body_speed = checker.max_body_speed(arc.curvature, margin);
        let mut checks = 0;
        let mut blocked = 0.0;
        // Up to here the body is known to be free.
        let mut known = 0.0;
        while free < length {
            let next = free + spacing;
            if arc.curvature != 0.0 {
                (sin, cos) = (sin * turn.1 + cos * turn_sin, cos * turn.1 - sin * turn_sin);
            }
            let place = self.start.along(arc.curvature, next * sign, sin, cos);
            checks += 1;
            let spare = checker.spare(place, radius);
            if spare <= 0.0 {
                if next > known {
                    let Some(gap) = checker.gap(place, margin - CONTACT) else {
                        blocked = next;
                        break;
                    };
                    known = next + gap / max_body_speed;
                }
                free = next;
            } else {
                free = next + spare / max_disc_speed;
                if arc.curvature != 0.0 && free < length {
                    (sin, cos) = at(free);
                }
            }
        }
        checker.count(checks);
        Motion { free, blocked }
    }
}

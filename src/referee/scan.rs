//! The whole body against the exact obstacles along a motion, with a certificate for what lies between two moments.
//!
//! Where the body is `c` metres from everything, no point of it can touch before it has moved by `c`. So a clearance
//! measured once certifies all that follows until that is used up (conservative advancement), and the clearance at the
//! next place measured certifies backwards.
//!
//! For a motion between two poses that moves no point of the body by more than d, and clearances c₀ and c₁ at its ends,
//! no contact is possible if c₀ + c₁ ≥ d: a point that touches has moved by c₀ at least and still has c₁ to go. An
//! upper bound of d is the distance driven plus the turn times the farthest corner's distance from the rear axle. What
//! this leaves open is halved and measured again.

use crate::geometry::{Pose, math};
use crate::metrics::Body;
use crate::scenario::resolve::Owner;
use crate::vehicle::Vehicle;

/// Motions shorter than this are not cut any further, metres.
const SHORTEST: f64 = 1e-5;
/// Allowance for rounding in a clearance, metres.
const ROUNDING: f64 = 1e-9;
/// Overlaps up to this are contact, which is free, as at the moments themselves, metres.
const CONTACT: f64 = 1e-6;

/// Contacts of a body along a motion.
///
/// The whole motion counts, not only the moments looked at.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Contacts {
    /// Moments looked at.
    pub frames: u32,
    /// Moments at which the body overlaps something.
    pub touching_frames: u32,
    /// Motions between two moments that are neither certified free nor touching at an end.
    pub uncertified: u32,
    /// When the body first overlaps what, and where.
    pub first: Option<(f64, Owner, Pose)>,
    /// The least clearance measured, metres; infinite where nothing was. Between measured places it may be less, but
    /// not where that would touch.
    pub min_clearance: f64,
}

impl Contacts {
    /// True if the whole motion is free: no moment touches, and every motion between two moments is certified.
    pub fn are_none(&self) -> bool {
        self.touching_frames == 0 && self.uncertified == 0
    }
}

/// How far a point of the body moves at most from one pose to another on a straight motion of both, metres.
fn displacement(vehicle: &Vehicle, from: Pose, to: Pose) -> f64 {
    // The rear axle's way of a frame is an arc: no more than 1 + 1e-6 times its chord.
    let chord = math::hypot(to.x - from.x, to.y - from.y) * (1.0 + 1e-6);
    chord + (to.heading - from.heading).abs() * vehicle.reach()
}

/// Looks at every moment (time, pose with unwrapped heading) of a motion.
///
/// The cost is the number of clearance queries: it falls with the room around the car. In the open one query covers
/// thousands of moments.
pub fn scan(vehicle: &Vehicle, body: &Body, moments: &[(f64, Pose)]) -> Contacts {
    let mut found = Contacts { min_clearance: f64::INFINITY, ..Contacts::default() };
    // What is left of the last measured clearance here, and whether the body overlapped there.
    let (mut left, mut touched) = (0.0, true);
    for (i, &(t, pose)) in moments.iter().enumerate() {
        found.frames += 1;
        let moved = if i == 0 { 0.0 } else { displacement(vehicle, moments[i - 1].1, pose) };
        if moved < left - ROUNDING {
            left -= moved;
            continue;
        }
        let here = measure(body, pose, &mut found);
        if here.is_none() {
            found.touching_frames += 1;
            if found.first.is_none() {
                found.first = body.hit(pose).map(|owner| (t, owner, pose));
            }
        }
        let clearance = here.unwrap_or(0.0);
        if !touched && here.is_some() && left + clearance + CONTACT < moved {
            let ends = [(moments[i - 1].1, left), (pose, clearance)];
            found.uncertified += u32::from(!certified(vehicle, body, ends, &mut found));
        }
        (left, touched) = (clearance, here.is_none());
    }
    found
}

/// The clearance at a pose; `None` where the body overlaps something.
fn measure(body: &Body, pose: Pose, found: &mut Contacts) -> Option<f64> {
    if body.hit(pose).is_some() {
        found.min_clearance = 0.0;
        return None;
    }
    let clearance = body.clearance(pose);
    found.min_clearance = found.min_clearance.min(clearance);
    Some(clearance)
}

/// True if the body is free all the way between two poses with clearances, by bisection. A part shorter than
/// [`SHORTEST`] that is still open is not certified: the body is within micrometres of touching there.
fn certified(vehicle: &Vehicle, body: &Body, ends: [(Pose, f64); 2], found: &mut Contacts) -> bool {
    let mut parts = vec![ends];
    while let Some([(from, before), (to, after)]) = parts.pop() {
        let moved = displacement(vehicle, from, to);
        if before + after + CONTACT >= moved {
            continue;
        }
        if moved < SHORTEST {
            return false;
        }
        let middle = Pose::new(
            f64::midpoint(from.x, to.x),
            f64::midpoint(from.y, to.y),
            f64::midpoint(from.heading, to.heading),
        );
        let Some(clearance) = measure(body, middle, found) else { return false };
        parts.extend([[(middle, clearance), (to, after)], [(from, before), (middle, clearance)]]);
    }
    true
}

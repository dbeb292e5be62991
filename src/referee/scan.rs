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
    /// Moments at which the body overlaps something, those between two of the given ones too where one was looked at.
    pub touching_frames: u32,
    /// Motions between two moments that are neither certified free nor known to touch.
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
        let here = measure(body, (t, pose), &mut found);
        let clearance = here.unwrap_or(0.0);
        if !touched && here.is_some() && left + clearance + CONTACT < moved {
            certify(vehicle, body, [(moments[i - 1], left), ((t, pose), clearance)], &mut found);
        }
        (left, touched) = (clearance, here.is_none());
    }
    found
}

/// The clearance at a moment; `None` where the body overlaps something, which is noted.
fn measure(body: &Body, (t, pose): (f64, Pose), found: &mut Contacts) -> Option<f64> {
    if let Some(owner) = body.hit(pose) {
        found.touching_frames += 1;
        found.first.get_or_insert((t, owner, pose));
        found.min_clearance = 0.0;
        return None;
    }
    let clearance = body.clearance(pose);
    found.min_clearance = found.min_clearance.min(clearance);
    Some(clearance)
}

/// Looks between two moments with clearances, by bisection, and notes what it finds: nothing where the body is free all
/// the way, else the overlap, or a motion that is not certified. Such a part is shorter than [`SHORTEST`]: the body is
/// within micrometres of touching there.
fn certify(vehicle: &Vehicle, body: &Body, ends: [((f64, Pose), f64); 2], found: &mut Contacts) {
    let mut parts = vec![ends];
    while let Some([(from, before), (to, after)]) = parts.pop() {
        let moved = displacement(vehicle, from.1, to.1);
        if before + after + CONTACT >= moved {
            continue;
        }
        if moved < SHORTEST {
            found.uncertified += 1;
            return;
        }
        let middle = Pose::new(
            f64::midpoint(from.1.x, to.1.x),
            f64::midpoint(from.1.y, to.1.y),
            f64::midpoint(from.1.heading, to.1.heading),
        );
        let middle = (f64::midpoint(from.0, to.0), middle);
        let Some(clearance) = measure(body, middle, found) else { return };
        parts.extend([[(middle, clearance), (to, after)], [(from, before), (middle, clearance)]]);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::Point;
    use crate::scenario::catalog;
    use crate::scenario::resolve::{Form, Geometry, Shape};

    #[test]
    fn an_overlap_between_two_frames_is_told_and_a_touch_is_not_certified() {
        let scene = catalog::scenario("perpendicular").unwrap().geometry().unwrap();
        let (vehicle, at) = (scene.vehicle, scene.start.point());
        // Halfway on this turn the left front corner is farthest to the east, by 20 µm.
        let reach = math::hypot(vehicle.rear_to_front, vehicle.width / 2.0);
        let aside = math::atan2(vehicle.width / 2.0, vehicle.rear_to_front);
        let moments = [-0.003, 0.003].map(|turn| (turn, Pose::new(at.x, at.y, turn - aside)));
        let wall_at = |depth: f64| {
            let x = at.x + reach - depth;
            let form = Form::Segment(Point::new(x, at.y - 1.0), Point::new(x, at.y + 1.0));
            let shapes = vec![Shape { owner: Owner::Obstacle(0), form }];
            scan(&vehicle, &Body::new(&Geometry { shapes, ..scene.clone() }), &moments)
        };
        let through = wall_at(1e-5);
        assert_eq!((through.frames, through.touching_frames, through.uncertified), (2, 1, 0));
        let (t, owner, pose) = through.first.unwrap();
        assert_eq!((owner, through.min_clearance), (Owner::Obstacle(0), 0.0));
        assert!(t.abs() < 1e-12 && (pose.heading + aside).abs() < 1e-12, "{t} {pose:?}");
        let touch = wall_at(0.0);
        assert_eq!((touch.touching_frames, touch.uncertified, touch.first), (0, 1, None));
        let beside = wall_at(-0.02);
        assert_eq!((beside.touching_frames, beside.uncertified, beside.first), (0, 0, None));
    }
}

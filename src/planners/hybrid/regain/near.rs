//! Where the body comes near obstacles along a path, and how each arc's length changes the distance there.

use nalgebra::DVector;

use crate::geometry::arcs::Arc;
use crate::planners::hybrid::descent::{Column, Stand, column};
use crate::vehicle::collision::{CollisionChecker, Contact};

/// Distances are measured up to this, metres.
pub(super) const FAR: f64 = 0.3;
/// Contacts farther off than the margin and this are left out, metres.
const LOOK: f64 = 0.02;
/// No point of the body moves farther for each metre of an arc, if it is a car's.
const SPEED: f64 = 1.5;
/// The spacing of the places where the body is near something, metres; …
const FINE: f64 = 0.02;
/// … contacts are told every so many metres and where the body is nearest.
const SPACING: f64 = 0.05;
/// Where the body is nearest is told to this, metres along the path.
const PRECISION: f64 = 0.001;

/// One contact: how its distance changes for each metre that each arc up to it grows, and the distance.
pub(super) struct Near {
    pub(super) slopes: DVector<f64>,
    pub(super) distance: f64,
}

/// A path and what it should keep away from.
pub(super) struct Way<'a> {
    pub(super) checker: &'a CollisionChecker<'a>,
    pub(super) margin: f64,
    pub(super) arcs: &'a [Arc],
    /// The poses before each arc and at the end.
    pub(super) stands: &'a [Stand],
}

impl Way<'_> {
    /// Adds the contacts along an arc; returns the least distance. Nothing where the body overlaps something.
    pub(super) fn contacts(
        &self,
        number: usize,
        (near, found): (&mut Vec<Near>, &mut Vec<Contact>),
    ) -> Option<f64> {
        let Self { checker, margin, arcs, stands } = *self;
        let arc = &arcs[number];
        let whole = arc.length.abs();
        let Stand { pose: from, turned } = stands[number];
        let pose = |along: f64| from.advance_turned(turned, arc.curvature, along.copysign(arc.length));
        let distance = |along: f64| checker.clearance(pose(along), FAR);
        let mut places = vec![(0.0, distance(0.0))];
        let mut last = places[0];
        while last.0 < whole {
            let along = (last.0 + ((last.1 - margin) / SPEED).max(FINE)).min(whole);
            last = (along, distance(along));
            places.push(last);
        }
        let limit = margin + LOOK;
        let (mut least, mut told) = (FAR, f64::NEG_INFINITY);
        for (at, &(mut along, mut room)) in places.iter().enumerate() {
            least = f64::min(least, room);
            let before = places[at.saturating_sub(1)];
            let after = places.get(at + 1).copied().unwrap_or(places[at]);
            let is_nearest = room <= before.1 && room <= after.1;
            if room >= limit || !(is_nearest || along > told + SPACING) {
                continue;
            }
            told = along;
            if is_nearest {
                (along, room) = nearest((before.0, after.0), (along, room), distance);
                least = f64::min(least, room);
            }
            let at = pose(along);
            let here = Stand::at(at);
            checker.contacts(at, limit, found);
            for &Contact { distance, point, away } in &*found {
                let arm = point - at.point();
                let turning = arm.x * away.y - arm.y * away.x;
                let slope = |[x, y, heading]: Column| away.x * x + away.y * y + turning * heading;
                let slopes = DVector::from_fn(number + 1, |n, _| {
                    if n < number {
                        slope(column(at, stands[n + 1], arcs[n].curvature))
                    } else {
                        along / whole * slope(column(at, here, arc.curvature))
                    }
                });
                near.push(Near { slopes, distance });
            }
        }
        (least > 0.0).then_some(least)
    }
}

/// The place between two others where something is nearest, and how near, from a first one: by golden sections.
fn nearest((mut low, mut high): (f64, f64), first: (f64, f64), distance: impl Fn(f64) -> f64) -> (f64, f64) {
    let section = (5.0_f64.sqrt() - 1.0) / 2.0;
    let at = |along: f64| (along, distance(along));
    let (mut near, mut far) = (at(high - section * (high - low)), at(low + section * (high - low)));
    while high - low > PRECISION {
        if near.1 < far.1 {
            (high, far) = (far.0, near);
            near = at(high - section * (high - low));
        } else {
            (low, near) = (near.0, far);
            far = at(low + section * (high - low));
        }
    }
    [near, far].into_iter().fold(first, |best, one| if one.1 < best.1 { one } else { best })
}

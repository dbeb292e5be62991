//! The poses of a car whose middle follows a line.
//!
//! A *tractrix* is the path of a point that is towed at a fixed distance by another one. Here the car's middle goes
//! along a line and tows the rear axle, l metres behind. The rear wheels roll without slip, so with the angle α from
//! the heading to the middle's direction of motion the heading changes by dθ/ds = sin α / l per metre of the middle's
//! way.
//!
//! Between two places the rear axle is taken to drive one arc. Its chord then has the mean heading, which fixes the
//! turn in closed form: with the step d and the angle α from the heading to it, tan(Δθ/2) = d·sin α / (2l + d·cos α).
//! The middle is exactly in each place, errors do not add up, and the curvature that is answered is that of the arc
//! that the check drives.

use super::measured::Driven;
use crate::geometry::{Point, Pose, Vector, arcs, math};
use crate::scenario::resolve::Geometry;

/// Tows the car by its middle through `places`, each with the direction of the way there: forwards, the rear wheels
/// rolling without slip, so between two places the rear axle drives an arc. The car points along its start's heading at
/// first where the wheel can turn that into the line, along the line otherwise. Where its rear axle is its middle it
/// points along the line throughout.
///
/// Linear in the places. The gear is forward throughout: towing backwards is unstable, since an error of the heading
/// grows.
pub(super) fn tractrix(geometry: &Geometry, places: &[(Point, Vector)]) -> Driven {
    let lever = geometry.vehicle.middle();
    let towed = lever > 1e-3;
    let direction = |way: Vector| math::atan2(way.y, way.x);
    let mut driven = Driven::default();
    let Some((&(first, way), rest)) = places.split_first() else { return driven };
    let mut heading = direction(way);
    let off = math::turn(geometry.start.heading, heading).abs();
    if towed && off < math::FRAC_PI_2 && math::tan(off) <= lever * geometry.vehicle.max_curvature() {
        heading = geometry.start.heading;
    }
    let behind = |middle: Point, heading: f64| Pose::new(middle.x, middle.y, heading).advance(0.0, -lever);
    let mut middle = first;
    driven.poses.push(behind(middle, heading));
    for &(next, way) in rest {
        let step = next - middle;
        let turn = if towed {
            // Half the turn, from chords of the rear axle's arc having the mean heading.
            let off = math::turn(heading, direction(step));
            let (sin, cos) = math::sin_cos(off);
            2.0 * math::atan2(step.norm() * sin, 2.0 * lever + step.norm() * cos)
        } else {
            math::turn(heading, direction(way))
        };
        heading = math::wrap(heading + turn);
        let pose = behind(next, heading);
        let chord = (pose.point() - driven.poses[driven.poses.len() - 1].point()).norm();
        let length = arcs::length_over(chord, turn);
        driven.curvatures.push(if length > 0.0 { turn / length } else { 0.0 });
        driven.poses.push(pose);
        middle = next;
    }
    driven.curvatures.push(driven.curvatures.last().copied().unwrap_or(0.0));
    driven.directions = vec![1; driven.poses.len()];
    driven
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::vehicle::Vehicle;

    fn geometry(heading: f64) -> Geometry {
        let pose = Pose::new(0.0, 0.0, heading);
        let vehicle = Vehicle::SEDAN;
        Geometry {
            start: pose,
            goal: pose,
            goals: None,
            vehicle,
            boundary: Vec::new(),
            shapes: Vec::new(),
            parked: Vec::new(),
        }
    }

    #[test]
    fn the_middle_is_on_the_line_and_the_rear_axle_rolls() {
        let radius = 20.0;
        let place = |k: u32| {
            let (sin, cos) = math::sin_cos(f64::from(k) * 0.1 / radius);
            (Point::new(radius * sin, radius * (1.0 - cos)), Vector::new(cos, sin))
        };
        let places: Vec<_> = (0..600).map(place).collect();
        let driven = tractrix(&geometry(0.05), &places);
        for (pose, (point, _)) in driven.poses.iter().zip(&places) {
            assert!((pose.advance(0.0, 1.4).point() - point).norm() < 1e-12);
        }
        for (pair, curvature) in driven.poses.windows(2).zip(&driven.curvatures) {
            let length = math::turn(pair[0].heading, pair[1].heading) / curvature;
            assert!((pair[0].advance(*curvature, length).point() - pair[1].point()).norm() < 1e-9);
        }
        assert_eq!(driven.poses[0].heading, 0.05);
        // In the end the rear axle is on a circle of its own.
        let settled = driven.curvatures[driven.curvatures.len() - 1];
        assert!((settled - (radius * radius - 1.4 * 1.4_f64).sqrt().recip()).abs() < 1e-4, "{settled}");
    }

    #[test]
    fn a_start_across_the_line_is_not_pretended_away() {
        let places: Vec<_> = (0..9).map(|k| (Point::new(f64::from(k), 0.0), Vector::new(1.0, 0.0))).collect();
        assert_eq!(tractrix(&geometry(1.0), &places).poses[0].heading, 0.0);
        assert!(tractrix(&geometry(0.0), &places).curvatures.iter().all(|k| *k == 0.0));
    }
}

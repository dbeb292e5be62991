//! A path of straight pieces and arcs as the poses of a car that follows it.

use crate::geometry::{Point, Pose, math};

/// A piece of a path on the plane, metres.
#[derive(Debug, Clone, Copy)]
pub(super) enum Piece {
    Line { from: Point, to: Point },
    /// From `start` (radians, seen from the centre) through `sweep` (positive to the left).
    Arc { center: Point, radius: f64, start: f64, sweep: f64 },
}

/// The poses of a car along a path, close together.
#[derive(Debug, Default)]
pub(super) struct Driven {
    pub(super) poses: Vec<Pose>,
    pub(super) directions: Vec<i8>,
    pub(super) curvatures: Vec<f64>,
}

impl Piece {
    fn length(&self) -> f64 {
        match *self {
            Self::Line { from, to } => (to - from).norm(),
            Self::Arc { radius, sweep, .. } => radius * sweep.abs(),
        }
    }

    fn curvature(&self) -> f64 {
        match *self {
            Self::Line { .. } => 0.0,
            Self::Arc { radius, sweep, .. } => sweep.signum() / radius,
        }
    }

    fn pose(&self, t: f64) -> Pose {
        match *self {
            Self::Line { from, to } => {
                let way = to - from;
                let at = from + way * t;
                Pose::new(at.x, at.y, math::atan2(way.y, way.x))
            }
            Self::Arc { center, radius, start, sweep } => {
                let (sin, cos) = math::sin_cos(start + sweep * t);
                let quarter = if sweep > 0.0 { math::FRAC_PI_2 } else { -math::FRAC_PI_2 };
                let heading = math::wrap(start + sweep * t + quarter);
                Pose::new(center.x + radius * cos, center.y + radius * sin, heading)
            }
        }
    }
}

/// Follows `pieces` with poses at most `step` metres apart. A corner gives two poses at one place. The car drives in
/// reverse throughout where its tail points along the path at the start, rather than its nose.
pub(super) fn follow(pieces: &[Piece], start_heading: f64, step: f64) -> Driven {
    let mut driven = Driven::default();
    for piece in pieces.iter().filter(|p| p.length() > 1e-9) {
        let steps = (piece.length() / step).ceil().max(1.0) as u32;
        let first = piece.pose(0.0);
        match driven.poses.last() {
            Some(last) if math::turn(last.heading, first.heading).abs() < 1e-6 => {
                driven.poses.pop();
                driven.curvatures.pop();
            }
            Some(_) => {
                // The pose before a corner: the way on from it is no curve.
                if let Some(before) = driven.curvatures.last_mut() {
                    *before = f64::NAN;
                }
            }
            None => {}
        }
        for k in 0..=steps {
            driven.poses.push(piece.pose(f64::from(k) / f64::from(steps)));
            driven.curvatures.push(piece.curvature());
        }
    }
    let reverse = driven.poses.first().is_some_and(|p| {
        math::turn(start_heading, p.heading).abs() > math::FRAC_PI_2 + 1e-6
    });
    if reverse {
        driven.poses.iter_mut().for_each(|p| p.heading = math::wrap(p.heading + math::PI));
        driven.curvatures.iter_mut().for_each(|k| *k = -*k);
    }
    driven.directions = vec![if reverse { -1 } else { 1 }; driven.poses.len()];
    driven
}

/// The pieces of a polyline.
pub(super) fn polyline(points: &[Point]) -> Vec<Piece> {
    points.windows(2).map(|w| Piece::Line { from: w[0], to: w[1] }).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_corner_is_two_poses_and_a_straight_joint_is_one() {
        let points = [(0.0, 0.0), (1.0, 0.0), (2.0, 0.0), (2.0, 1.0)].map(|(x, y)| Point::new(x, y));
        let driven = follow(&polyline(&points), 0.0, 0.5);
        assert_eq!(driven.poses.len(), 8);
        assert_eq!(driven.poses[4], Pose::new(2.0, 0.0, 0.0));
        assert_eq!(driven.poses[5], Pose::new(2.0, 0.0, math::FRAC_PI_2));
        assert!(driven.curvatures[4].is_nan());
        assert_eq!(driven.directions, [1; 8]);
    }

    #[test]
    fn a_path_behind_the_car_is_driven_in_reverse() {
        let arc = Piece::Arc { center: Point::new(0.0, 5.0), radius: 5.0, start: -math::FRAC_PI_2, sweep: 1.0 };
        let driven = follow(&[arc], math::PI, 0.1);
        assert_eq!(driven.directions[0], -1);
        assert!((driven.poses[0].heading - math::PI).abs() < 1e-12);
        assert!((driven.curvatures[0] + 0.2).abs() < 1e-12);
        let end = driven.poses[0].advance(driven.curvatures[0], -5.0);
        let last = driven.poses[driven.poses.len() - 1];
        assert!((end.point() - last.point()).norm() < 1e-9);
    }
}

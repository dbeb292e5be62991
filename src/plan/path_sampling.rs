//! A path of straight pieces and arcs as the poses of a car that follows it.
//!
//! A grid path knows positions only, so the heading of each pose is that of the piece it lies on. Where two pieces meet
//! without a change of heading, one pose serves both; at a corner there are two poses, and the curvature of the way
//! between them is not a number, since a turn on the spot has none. Curvature in 1/m is that of the piece in 1/cells
//! divided by the resolution; in reverse the car's nose points the other way and the sign changes.

use super::measured::Driven;
use crate::geometry::{Pose, math};
use crate::map::Frame;
use crate::post::Piece;

/// Follows `pieces`, given in cells, with poses at most `step` metres apart. A corner gives two poses at one place. The
/// car drives in reverse throughout where its tail points along the path at the start, rather than its nose.
///
/// A reversal in the middle of the path is a corner of 180°, not a gear change: a grid planner does not know gears.
pub(super) fn follow(frame: &Frame, pieces: &[Piece], start_heading: f64, step: f64) -> Driven {
    let pose = |piece: &Piece, share: f64| {
        let at = frame.world(piece.point(share));
        Pose::new(at.x, at.y, piece.heading(share))
    };
    let mut driven = Driven::default();
    for piece in pieces.iter().filter(|p| p.length() > 1e-9) {
        let steps = (piece.length() * frame.resolution / step).ceil().max(1.0) as u32;
        let first = pose(piece, 0.0);
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
            driven.poses.push(pose(piece, f64::from(k) / f64::from(steps)));
            driven.curvatures.push(piece.curvature() / frame.resolution);
        }
    }
    let reverse = driven
        .poses
        .first()
        .is_some_and(|p| math::turn(start_heading, p.heading).abs() > math::FRAC_PI_2 + 1e-6);
    if reverse {
        driven.poses.iter_mut().for_each(|p| p.heading = math::wrap(p.heading + math::PI));
        driven.curvatures.iter_mut().for_each(|k| *k = -*k);
    }
    driven.directions = vec![if reverse { -1 } else { 1 }; driven.poses.len()];
    driven
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::Point;

    const FRAME: Frame = Frame { origin: Point::new(-0.25, -0.25), width: 9, height: 9, resolution: 0.5 };

    #[test]
    fn a_corner_is_two_poses_and_a_straight_joint_is_one() {
        let pieces = Piece::lines(&[[0.0, 0.0], [2.0, 0.0], [4.0, 0.0], [4.0, 2.0]]);
        let driven = follow(&FRAME, &pieces, 0.0, 0.5);
        assert_eq!(driven.poses.len(), 8);
        assert_eq!(driven.poses[4], Pose::new(2.0, 0.0, 0.0));
        assert_eq!(driven.poses[5], Pose::new(2.0, 0.0, math::FRAC_PI_2));
        assert!(driven.curvatures[4].is_nan());
        assert_eq!(driven.directions, [1; 8]);
    }

    #[test]
    fn a_path_behind_the_car_is_driven_in_reverse() {
        let arc = Piece::Arc { center: [0.0, 10.0], radius: 10.0, start_angle: -math::FRAC_PI_2, sweep: 1.0 };
        let driven = follow(&FRAME, &[arc], math::PI, 0.1);
        assert_eq!(driven.directions[0], -1);
        assert!((driven.poses[0].heading - math::PI).abs() < 1e-12);
        assert!((driven.curvatures[0] + 0.2).abs() < 1e-12);
        let end = driven.poses[0].advance(driven.curvatures[0], -5.0);
        let last = driven.poses[driven.poses.len() - 1];
        assert!((end.point() - last.point()).norm() < 1e-9);
    }
}

//! A position and a heading.
//!
//! A pose doubles as a frame of reference: x ahead, y to the left. [`Pose::to_world`] and [`Pose::to_local`]
//! convert points between that frame and the world, and [`Pose::advance`] drives along an arc.

use serde::Serialize;

use super::{Point, Vector, math};

/// Position of the rear axle's middle (metres) and heading (radians, counter-clockwise from east).
///
/// # Examples
/// ```
/// use parkade::geometry::{Point, Pose};
///
/// let car = Pose::new(10.0, 4.0, std::f64::consts::FRAC_PI_2);
/// // A point 2 m ahead of the rear axle and 1 m to its left lies north and west of it.
/// let lamp = car.to_world(Point::new(2.0, 1.0));
/// assert!((lamp - Point::new(9.0, 6.0)).norm() < 1e-12);
/// assert!((car.to_local(lamp) - Point::new(2.0, 1.0)).norm() < 1e-12);
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize)]
pub struct Pose {
    /// Metres, to the east.
    pub x: f64,
    /// Metres, to the north.
    pub y: f64,
    /// Radians, counter-clockwise from east.
    pub heading: f64,
}

impl Pose {
    /// A pose from its three numbers.
    pub const fn new(x: f64, y: f64, heading: f64) -> Self {
        Self { x, y, heading }
    }

    /// The position.
    pub fn point(self) -> Point {
        Point::new(self.x, self.y)
    }

    /// The unit vector along the heading.
    pub fn direction(self) -> Vector {
        let (sin, cos) = math::sin_cos(self.heading);
        Vector::new(cos, sin)
    }

    /// A point of the vehicle's frame (x ahead, y to the left) in the world.
    pub fn to_world(self, local: Point) -> Point {
        self.turned(math::sin_cos(self.heading), local)
    }

    /// [`Pose::to_world`] by a pose whose heading has this sine and cosine.
    pub(crate) fn turned(self, (sin, cos): (f64, f64), local: Point) -> Point {
        Point::new(self.x + local.x * cos - local.y * sin, self.y + local.x * sin + local.y * cos)
    }

    /// A point of the world in the vehicle's frame (x ahead, y to the left).
    pub fn to_local(self, world: Point) -> Point {
        let (sin, cos) = math::sin_cos(self.heading);
        let (dx, dy) = (world.x - self.x, world.y - self.y);
        Point::new(dx * cos + dy * sin, dy * cos - dx * sin)
    }

    /// The pose after an arc of signed `length` (metres, negative in reverse) at `curvature` (1/m, left positive).
    ///
    /// Integrated exactly: θ′ = θ + κℓ, and the position moves by the integral of (cos θ, sin θ) along the arc, which
    /// is (sin θ′ − sin θ, cos θ − cos θ′)/κ. The heading is wrapped to (−π, π] unless the line is straight.
    #[must_use]
    #[inline(never)]
    pub fn advance(self, curvature: f64, length: f64) -> Self {
        self.advance_turned(math::sin_cos(self.heading), curvature, length)
    }

    /// [`Pose::advance`] from a pose whose heading has this sine and cosine.
    #[must_use]
    #[inline]
    pub(crate) fn advance_turned(self, turned: (f64, f64), curvature: f64, length: f64) -> Self {
        self.advance_turning(turned, curvature, length).0
    }

    /// [`Pose::advance_turned`], with sine and cosine of the new heading.
    #[inline]
    pub(crate) fn advance_turning(
        self,
        (s0, c0): (f64, f64),
        curvature: f64,
        length: f64,
    ) -> (Self, (f64, f64)) {
        if curvature == 0.0 {
            return (Self::new(self.x + length * c0, self.y + length * s0, self.heading), (s0, c0));
        }
        let heading = self.heading + curvature * length;
        let (s1, c1) = math::sin_cos(heading);
        let (x, y) = (self.x + (s1 - s0) / curvature, self.y - (c1 - c0) / curvature);
        (Self::new(x, y, math::wrap(heading)), (s1, c1))
    }

    /// True if all three numbers are finite.
    pub fn is_finite(self) -> bool {
        self.x.is_finite() && self.y.is_finite() && self.heading.is_finite()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_quarter_turn_left_ends_on_the_circle() {
        let end = Pose::new(0.0, 0.0, 0.0).advance(0.5, math::PI);
        assert!((end.x - 2.0).abs() < 1e-12 && (end.y - 2.0).abs() < 1e-12);
        assert!((end.heading - math::FRAC_PI_2).abs() < 1e-12);
    }

    #[test]
    fn frames_are_inverse() {
        let pose = Pose::new(3.0, -2.0, 0.7);
        let p = Point::new(1.5, 0.25);
        assert!((pose.to_local(pose.to_world(p)) - p).norm() < 1e-12);
    }

    #[test]
    fn a_pose_is_finite_when_all_its_numbers_are() {
        assert!(Pose::new(1.0, 2.0, 3.0).is_finite());
        let bad = [f64::NAN, f64::INFINITY, f64::NEG_INFINITY];
        for v in bad {
            let poses = [Pose::new(v, 0.0, 0.0), Pose::new(0.0, v, 0.0), Pose::new(0.0, 0.0, v)];
            assert!(poses.iter().all(|pose| !pose.is_finite()), "{v}");
        }
    }

    #[test]
    fn the_frame_is_ahead_and_to_the_left() {
        let pose = Pose::new(3.0, -2.0, math::FRAC_PI_2);
        assert!((pose.to_world(Point::new(2.0, 0.5)) - Point::new(2.5, 0.0)).norm() < 1e-12);
        assert!((pose.direction() - Vector::new(0.0, 1.0)).norm() < 1e-12);
        let back = Pose::new(3.0, -2.0, math::PI).advance(0.0, -4.0);
        assert!((back.point() - Point::new(7.0, -2.0)).norm() < 1e-12);
    }
}

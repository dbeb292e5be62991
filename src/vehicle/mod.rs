//! The car: dimensions, footprint and collision.
//!
//! A car is a rectangle on a kinematic bicycle: it turns about a point on the line of its rear axle, and does not
//! slide. With wheelbase L and steering angle δ the curvature of the rear axle's path is
//!
//! ```text
//! κ = tan δ / L,   |κ| ≤ tan(max_steer) / wheelbase = 1 / min_turning_radius
//! ```
//!
//! All dimensions are in metres, angles in radians, and measured from the middle of the rear axle: the body reaches
//! from `-rear_to_back` to `rear_to_front` along the heading and `width / 2` to either side.
//!
//! Two frames occur: the *world*, x east and y north, and the *body*, x ahead and y to the left. A [`Pose`] places
//! the body in the world; headings run counter-clockwise from east, and a positive curvature turns to the left.
//!
//! A rectangle is a model: mirrors, rounded corners and tyres are left out. Everything that must be certain, the
//! final check above all, treats contact as free and overlap as a collision.

pub mod collision;
pub mod library;

use serde::Serialize;

use crate::IS_COMPLETE;
use crate::error::{Error, ErrorCode};
use crate::geometry::{Point, Pose, math};

/// No dimension is smaller, metres and radians: sums with the others would lose it.
const LEAST: f64 = 0.001;

/// Dimensions of a car whose reference point is the middle of its rear axle: each 0.001 to 100.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
#[serde(rename_all = "camelCase")]
pub struct Vehicle {
    /// Distance between the axles, metres.
    pub wheelbase: f64,
    /// Full width, metres.
    pub width: f64,
    /// Rear axle to front bumper, metres.
    pub rear_to_front: f64,
    /// Rear axle to rear bumper, metres.
    pub rear_to_back: f64,
    /// Largest steering angle of the middle front wheel, radians, 0.001 or more and less than π/2.
    pub max_steer: f64,
    /// Largest steering speed, radians per second.
    pub max_steer_rate: f64,
}

/// Steering speed of a car that does not state its own, radians per second.
pub const DEFAULT_STEER_RATE: f64 = 0.6;

impl Vehicle {
    /// The parking paper's car (5.5 m × 2.6 m, turns in 5.41 m).
    pub const PAPER: Self = Self {
        wheelbase: 3.7,
        width: 2.6,
        rear_to_front: 4.5,
        rear_to_back: 1.0,
        max_steer: 0.6,
        max_steer_rate: 0.6,
    };

    /// An ordinary sedan (4.7 m × 1.9 m, turns in 5.5 m).
    pub const SEDAN: Self = Self {
        wheelbase: 2.8,
        width: 1.9,
        rear_to_front: 3.75,
        rear_to_back: 0.95,
        // atan(2.8 / 5.5)
        max_steer: 0.470_893_858_980_703_24,
        max_steer_rate: 0.6,
    };

    /// The road manuscript's ship (72 m × 16 m, turns in 144 m); it turns about a point a quarter of its length from
    /// the stern, a choice of ours.
    pub const SHIP: Self = Self {
        wheelbase: 36.0,
        width: 16.0,
        rear_to_front: 54.0,
        rear_to_back: 18.0,
        // atan(36 / 144)
        max_steer: 0.244_978_663_126_864_15,
        max_steer_rate: 0.05,
    };

    /// The named profile, if there is one.
    pub fn profile(name: &str) -> Option<Self> {
        match name {
            "paper" => Some(Self::PAPER),
            "sedan" => Some(Self::SEDAN),
            "ship" if IS_COMPLETE => Some(Self::SHIP),
            _ => None,
        }
    }

    /// Radius of the tightest circle of the rear axle's middle, metres.
    /// 1 / [`Vehicle::max_curvature`]; the outer corners of the body sweep a wider circle.
    pub fn min_turning_radius(&self) -> f64 {
        self.wheelbase / math::tan(self.max_steer)
    }

    /// Largest curvature of the path of the rear axle's middle, 1/m.
    pub fn max_curvature(&self) -> f64 {
        math::tan(self.max_steer) / self.wheelbase
    }

    /// Full length, metres.
    pub fn length(&self) -> f64 {
        self.rear_to_front + self.rear_to_back
    }

    /// No point of the body is farther from the rear axle's middle, metres.
    pub fn reach(&self) -> f64 {
        math::hypot(self.rear_to_front.max(self.rear_to_back), self.width / 2.0)
    }

    /// How far the body's middle is ahead of the rear axle, metres.
    pub fn middle(&self) -> f64 {
        (self.rear_to_front - self.rear_to_back) / 2.0
    }

    /// The corners of the body at `pose`: front left, rear left, rear right, front right.
    /// Counter-clockwise around the body, in the coordinates of `pose`.
    ///
    /// ```
    /// use parkade::geometry::{Point, Pose};
    /// use parkade::vehicle::Vehicle;
    ///
    /// let [front_left, rear_left, ..] = Vehicle::SEDAN.outline(Pose::new(10.0, 0.0, 0.0));
    /// assert_eq!(front_left, Point::new(13.75, 0.95));
    /// assert_eq!(rear_left, Point::new(9.05, 0.95));
    /// ```
    pub fn outline(&self, pose: Pose) -> [Point; 4] {
        self.outline_turned(pose, math::sin_cos(pose.heading))
    }

    /// [`Vehicle::outline`] at a pose whose heading has this sine and cosine.
    pub(crate) fn outline_turned(&self, pose: Pose, turn: (f64, f64)) -> [Point; 4] {
        let (front, back, side) = (self.rear_to_front, -self.rear_to_back, self.width / 2.0);
        [(front, side), (back, side), (back, -side), (front, -side)]
            .map(|(x, y)| pose.turned(turn, Point::new(x, y)))
    }

    /// Checks every dimension.
    ///
    /// # Errors
    /// [`ErrorCode::Vehicle`] with the field and the rule.
    pub fn validate(&self) -> Result<(), Error> {
        let sizes = [
            ("wheelbase", self.wheelbase),
            ("width", self.width),
            ("rearToFront", self.rear_to_front),
            ("rearToBack", self.rear_to_back),
            ("maxSteerRate", self.max_steer_rate),
        ];
        for (name, value) in sizes {
            if !(LEAST..=100.0).contains(&value) {
                let message = message!("must be {} to 100, got {}", LEAST, value);
                return Err(Error::new(ErrorCode::Vehicle, name, message));
            }
        }
        if !(self.max_steer >= LEAST && self.max_steer < math::FRAC_PI_2) {
            let message = message!("must be at least {} and less than π/2, got {}", LEAST, self.max_steer);
            return Err(Error::new(ErrorCode::Vehicle, "maxSteer", message));
        }
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_parking_papers_car_is_its_table_1() {
        let car = Vehicle::PAPER;
        assert_eq!((car.wheelbase, car.width, car.rear_to_back), (3.7, 2.6, 1.0));
        assert_eq!((car.max_steer, car.max_steer_rate), (0.6, 0.6));
        // The printed length of 4.5 m is that from the rear axle to the front; the printed radius is 5.408 m.
        assert_eq!((car.rear_to_front, car.length()), (4.5, 5.5));
        assert!((car.min_turning_radius() - 5.408).abs() < 5e-4);
    }

    #[test]
    fn corners_are_offset_from_the_rear_axle() {
        let (car, heading) = (Vehicle::PAPER, 0.7);
        let (sin, cos) = math::sin_cos(heading);
        let corners = car.outline(Pose::new(3.0, -2.0, heading));
        // Equation 10 with the rear axle's place in that of the front axle's.
        let (ahead, aside) = (car.rear_to_front, car.width / 2.0);
        let a = Point::new(3.0 + ahead * cos - aside * sin, -2.0 + ahead * sin + aside * cos);
        assert!((corners[0] - a).norm() < 1e-12, "{corners:?}");
        let sides = [0, 1, 2, 3].map(|i| (corners[(i + 1) % 4] - corners[i]).norm());
        for (side, expected) in sides.into_iter().zip([5.5, 2.6, 5.5, 2.6]) {
            assert!((side - expected).abs() < 1e-12, "{sides:?}");
        }
        let middle = nalgebra::center(&corners[0], &corners[2]);
        assert!((middle - Pose::new(3.0, -2.0, heading).advance(0.0, car.middle()).point()).norm() < 1e-12);
    }

    #[test]
    fn an_arc_is_the_motion_of_equation_9() {
        let (car, from, step) = (Vehicle::PAPER, Pose::new(1.0, 2.0, 0.4), 1e-6);
        for steer in [-0.6, -0.3, 0.0, 0.3, 0.6] {
            let curvature = math::tan(steer) / car.wheelbase;
            for length in [-3.0, 0.0, 2.5] {
                let [before, at, after] = [-step, 0.0, step].map(|by| from.advance(curvature, length + by));
                let rate = |a: f64, b: f64| (b - a) / (2.0 * step);
                let (sin, cos) = math::sin_cos(at.heading);
                assert!((rate(before.x, after.x) - cos).abs() < 1e-8, "{steer} {length}");
                assert!((rate(before.y, after.y) - sin).abs() < 1e-8, "{steer} {length}");
                assert!((rate(before.heading, after.heading) - curvature).abs() < 1e-8, "{steer} {length}");
            }
        }
    }

    #[test]
    fn profiles_turn_in_the_stated_radius() {
        assert!((Vehicle::PAPER.min_turning_radius() - 5.408_275_004_188_978).abs() < 1e-12);
        assert!((Vehicle::SEDAN.min_turning_radius() - 5.5).abs() < 1e-9);
        assert!((Vehicle::SHIP.min_turning_radius() - 144.0).abs() < 1e-9 && Vehicle::SHIP.length() == 72.0);
    }

    #[test]
    fn a_bad_dimension_is_named() {
        let error = Vehicle { wheelbase: -1.0, ..Vehicle::PAPER }.validate().unwrap_err();
        assert_eq!(error.to_string(), "wheelbase: must be 0.001 to 100, got -1");
        assert!(Vehicle { max_steer: f64::NAN, ..Vehicle::PAPER }.validate().is_err());
        assert!(Vehicle::PAPER.validate().is_ok());
    }
}

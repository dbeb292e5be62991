//! Limits that a trajectory must keep.
//!
//! One set of limits serves both sides: `optimise` plans within it and `referee` judges by it, with 0.1 % of tolerance
//! for rounding.

use crate::error::{Error, ErrorCode};
use crate::json;
use crate::vehicle::Vehicle;

/// Limits of a car in motion; the steering angle's limit is the car's own.
///
/// # Examples
/// ```
/// use parkade::referee::MotionLimits;
///
/// let limits = MotionLimits { speed: 0.0, ..MotionLimits::default() };
/// assert!(limits.validate().unwrap_err().to_string().contains("speed"));
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct MotionLimits {
    /// Largest speed in either gear, m/s, 0.1 to 100.
    pub speed: f64,
    /// Largest acceleration, m/s², 0.01 to 100.
    pub acceleration: f64,
    /// Largest deceleration, m/s², 0.01 to 100.
    pub deceleration: f64,
    /// Largest steering rate, rad/s, 0.01 to 100; the car's own where that is less.
    pub steering_rate: f64,
    /// Largest lateral acceleration v²·|κ|, m/s², 0.01 to 100; no limit where absent.
    pub lateral_acceleration: Option<f64>,
}

impl Default for MotionLimits {
    fn default() -> Self {
        Self {
            speed: 2.5,
            acceleration: 1.0,
            deceleration: 1.0,
            steering_rate: 0.5,
            lateral_acceleration: None,
        }
    }
}

json::settings! {
    MotionLimits:
    "speed" = speed,
    "acceleration" = acceleration,
    "deceleration" = deceleration,
    "steeringRate" = steering_rate,
    "lateralAcceleration" = lateral_acceleration,
}

impl MotionLimits {
    /// Checks every limit.
    ///
    /// # Errors
    /// [`ErrorCode::Config`] with the field and the rule.
    pub fn validate(&self) -> Result<(), Error> {
        let fields = [
            ("speed", self.speed, 0.1),
            ("acceleration", self.acceleration, 0.01),
            ("deceleration", self.deceleration, 0.01),
            ("steeringRate", self.steering_rate, 0.01),
            ("lateralAcceleration", self.lateral_acceleration.unwrap_or(1.0), 0.01),
        ];
        match fields.iter().find(|(_, value, least)| !(*least..=100.0).contains(value)) {
            Some((name, value, least)) => {
                let message = message!("must be between {} and 100, got {}", least, value);
                Err(Error::new(ErrorCode::Config, *name, message))
            }
            None => Ok(()),
        }
    }

    /// The steering rate that holds for a car, rad/s.
    pub fn steering_rate_of(&self, vehicle: &Vehicle) -> f64 {
        self.steering_rate.min(vehicle.max_steer_rate)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_limit_outside_its_range_is_named() {
        assert!(MotionLimits::default().validate().is_ok());
        let error = MotionLimits { steering_rate: f64::NAN, ..MotionLimits::default() }.validate();
        assert_eq!(error.unwrap_err().to_string(), "steeringRate: must be between 0.01 and 100, got NaN");
        let error = MotionLimits { speed: 0.0, ..MotionLimits::default() }.validate().unwrap_err();
        assert_eq!(error.to_string(), "speed: must be between 0.1 and 100, got 0");
        let rate = MotionLimits { steering_rate: 3.0, ..MotionLimits::default() };
        assert_eq!(rate.steering_rate_of(&Vehicle::PAPER), 0.6);
    }
}

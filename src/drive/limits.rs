//! What a drive keeps to: speeds, accelerations, jerk, the wheel at steps of the curvature.
//!
//! Limits are those of comfort or of the law as much as of the car: the wheel's largest angle and rate come from the
//! vehicle. Every range is checked before a drive is planned, and nothing is clamped.

use crate::error::{Error, ErrorCode};
use crate::json;

/// How the speed comes about.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Profile {
    /// From standstill to standstill within all limits.
    #[default]
    Limited,
    /// Constant: the parking paper's, with `speed` 2 and no `dwell`.
    Constant,
}

json::words!(Profile: "limited" = Limited, "constant" = Constant);

/// Behaviour at a step of the curvature inside a run, which no steering wheel can follow.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Steps {
    /// The speed is kept; the wheel begins to turn before the step, and may come late where steps follow each other
    /// closely.
    #[default]
    Preview,
    /// At most 0.5 m/s within 0.5 m of a step, and slow enough everywhere for the wheel to keep up.
    Slow,
}

json::words!(Steps: "preview" = Preview, "slow" = Slow);

/// Limits of a trajectory.
#[derive(Debug, Clone, PartialEq)]
pub struct Limits {
    /// How the speed comes about.
    pub profile: Profile,
    /// Largest speed, m/s, 0.01 to 100.
    pub speed: f64,
    /// Largest acceleration, m/s², 0.01 to 100.
    pub acceleration: f64,
    /// Largest deceleration, m/s², 0.01 to 100.
    pub deceleration: f64,
    /// Largest lateral acceleration v²·|κ|, m/s², 0.01 to 100.
    pub lateral_acceleration: f64,
    /// Largest jerk, m/s³, 0.01 to 1000; no limit where absent.
    pub jerk: Option<f64>,
    /// Speed at the beginning of the first run, m/s, 0 to 100.
    pub start_speed: f64,
    /// Speed at the end of the last run, m/s, 0 to 100.
    pub goal_speed: f64,
    /// Behaviour at a step of the curvature inside a run.
    pub steps: Steps,
    /// True if the wheel is turned at standstill at the start and at gear changes.
    pub dwell: bool,
    /// Largest time between two rows, seconds, 0.001 to 10.
    pub dt: f64,
}

impl Default for Limits {
    fn default() -> Self {
        Self {
            profile: Profile::Limited,
            speed: 2.0,
            acceleration: 1.0,
            deceleration: 1.5,
            lateral_acceleration: 1.5,
            jerk: None,
            start_speed: 0.0,
            goal_speed: 0.0,
            steps: Steps::Preview,
            dwell: true,
            dt: 0.05,
        }
    }
}

json::settings! {
    Limits:
    "profile" = profile,
    "speed" = speed,
    "acceleration" = acceleration,
    "deceleration" = deceleration,
    "lateralAcceleration" = lateral_acceleration,
    "jerk" = jerk,
    "startSpeed" = start_speed,
    "goalSpeed" = goal_speed,
    "steps" = steps,
    "dwell" = dwell,
    "dt" = dt,
}

/// Refuses a setting outside its range.
pub(super) fn within(path: &str, value: f64, low: f64, high: f64) -> Result<(), Error> {
    if (low..=high).contains(&value) {
        return Ok(());
    }
    Err(Error::new(ErrorCode::Config, path, message!("must be between {} and {}, got {}", low, high, value)))
}

impl Limits {
    /// The parking paper's driving: 2 m/s throughout, its time is the length by that.
    pub fn paper() -> Self {
        Self { profile: Profile::Constant, dwell: false, ..Self::default() }
    }

    /// On roads: 10 m/s, 2 m/s² sideways, a jerk of 2 m/s³, no stop to turn the wheel.
    pub fn road() -> Self {
        Self {
            speed: 10.0,
            acceleration: 1.5,
            deceleration: 2.0,
            lateral_acceleration: 2.0,
            jerk: Some(2.0),
            dwell: false,
            ..Self::default()
        }
    }

    /// Checks every limit.
    ///
    /// # Errors
    /// [`ErrorCode::Config`] with the field and the rule.
    pub fn validate(&self) -> Result<(), Error> {
        within("speed", self.speed, 0.01, 100.0)?;
        within("acceleration", self.acceleration, 0.01, 100.0)?;
        within("deceleration", self.deceleration, 0.01, 100.0)?;
        within("lateralAcceleration", self.lateral_acceleration, 0.01, 100.0)?;
        within("jerk", self.jerk.unwrap_or(1.0), 0.01, 1000.0)?;
        within("startSpeed", self.start_speed, 0.0, 100.0)?;
        within("goalSpeed", self.goal_speed, 0.0, 100.0)?;
        within("dt", self.dt, 0.001, 10.0)
    }
}

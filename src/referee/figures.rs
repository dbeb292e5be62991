//! Figures of a trajectory's time, effort and smoothness, as the competitions state them.
//!
//! With a linear course c₀ → c₁ over Δt, the integral of its square is Δt·(c₀² + c₀c₁ + c₁²)/3, which makes the effort
//! exact. Lateral acceleration v²·tan φ/L has no such form and is sampled at the ends and at three places between.

use super::{MotionLimits, States};
use crate::geometry::math;
use crate::vehicle::Vehicle;

/// Speeds up to this are no motion where gear changes are counted, m/s.
const STANDING: f64 = 0.01;
/// A limit is kept when it is exceeded by no more than this factor.
const TOLERANCE: f64 = 1.001;
/// Lateral accelerations are looked at this often between two rows.
const PARTS: u32 = 4;

/// Duration, effort and smoothness of a trajectory. The integrals are exact for speeds and steering angles that are
/// linear between rows.
///
/// A trajectory with fewer than two rows has zeros. Figures say nothing of obstacles; [`super::Contacts`] does.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct Figures {
    /// Seconds.
    pub duration: f64,
    /// Distance driven, ∫|v|, metres.
    pub length: f64,
    /// ∫ a² + v²·ω² dt. With a in m/s², v in m/s and ω in rad/s; a sum of two units, as the benchmark has it.
    pub effort: f64,
    /// ∫ φ² dt.
    pub steering: f64,
    /// Changes of the sign of v between speeds beyond 0.01 m/s. A stop that goes on in the same gear is none.
    pub gear_changes: u32,
    /// Largest |v|, m/s.
    pub max_speed: f64,
    /// Largest rate at which |v| grows, m/s².
    pub max_acceleration: f64,
    /// Largest rate at which |v| falls, m/s².
    pub max_deceleration: f64,
    /// Largest |φ|, radians.
    pub max_steering: f64,
    /// Largest |ω|, rad/s.
    pub max_steering_rate: f64,
    /// Largest v²·|κ|, m/s².
    pub max_lateral_acceleration: f64,
}

impl Figures {
    /// The figures of a trajectory.
    pub fn new(vehicle: &Vehicle, states: &States) -> Self {
        let mut figures = Self { duration: states.duration(), ..Self::default() };
        let mut gear = 0.0;
        for &speed in &states.speed {
            if speed.abs() > STANDING {
                figures.gear_changes += u32::from(gear * speed < 0.0);
                gear = speed.signum();
            }
        }
        for (i, t) in states.t.windows(2).enumerate() {
            let (v, angle) =
                ([states.speed[i], states.speed[i + 1]], [states.steering[i], states.steering[i + 1]]);
            figures.add(vehicle, t[1] - t[0], v, angle);
        }
        figures
    }

    /// Takes in what lies between two rows: `v` and `angle` at their ends, linear between them.
    fn add(&mut self, vehicle: &Vehicle, dt: f64, v: [f64; 2], angle: [f64; 2]) {
        let square = |c: [f64; 2]| dt * (c[0] * c[0] + c[0] * c[1] + c[1] * c[1]) / 3.0;
        let (a, rate) = ((v[1] - v[0]) / dt, (angle[1] - angle[0]) / dt);
        self.effort += a * a * dt + rate * rate * square(v);
        self.steering += square(angle);
        self.length += if v[0] * v[1] >= 0.0 {
            dt * (v[0] + v[1]).abs() / 2.0
        } else {
            dt * (v[0] * v[0] + v[1] * v[1]) / 2.0 / (v[1] - v[0]).abs()
        };
        let most = |limit: &mut f64, value: f64| *limit = limit.max(value.abs());
        for k in 0..2 {
            most(&mut self.max_speed, v[k]);
            most(&mut self.max_steering, angle[k]);
        }
        most(&mut self.max_steering_rate, rate);
        // Through standstill the car brakes first and then speeds up.
        let is_reversal = v[0] * v[1] < 0.0;
        if v[1].abs() > v[0].abs() || is_reversal {
            most(&mut self.max_acceleration, a);
        }
        if v[1].abs() < v[0].abs() || is_reversal {
            most(&mut self.max_deceleration, a);
        }
        for k in 0..=PARTS {
            let share = f64::from(k) / f64::from(PARTS);
            let (v, angle) = (v[0] + (v[1] - v[0]) * share, angle[0] + (angle[1] - angle[0]) * share);
            most(&mut self.max_lateral_acceleration, v * v * math::tan(angle) / vehicle.wheelbase);
        }
    }

    /// 10·effort + 10·steering + 5·gear changes.
    pub fn smoothness(&self) -> f64 {
        10.0 * self.effort + 10.0 * self.steering + 5.0 * f64::from(self.gear_changes)
    }

    /// The TPCAP competition's cost: smoothness + 100·duration.
    pub fn tpcap_cost(&self) -> f64 {
        self.smoothness() + 100.0 * self.duration
    }

    /// True if all limits are kept, to 0.1 %.
    ///
    /// Largest steering angle and rate come from the vehicle, the other limits from `limits`; of two steering rates the
    /// lesser holds.
    pub fn keep(&self, vehicle: &Vehicle, limits: &MotionLimits) -> bool {
        let pairs = [
            (self.max_speed, limits.speed),
            (self.max_acceleration, limits.acceleration),
            (self.max_deceleration, limits.deceleration),
            (self.max_steering, vehicle.max_steer),
            (self.max_steering_rate, limits.steering_rate_of(vehicle)),
            (self.max_lateral_acceleration, limits.lateral_acceleration.unwrap_or(f64::INFINITY)),
        ];
        pairs.iter().all(|(value, limit)| *value <= limit * TOLERANCE)
    }
}

//! A route sampled in time.
//!
//! Rows are at most `dt` seconds apart, and there is one wherever the acceleration changes. The steering angle
//! follows the curvature no faster than the car's limit, which is why it may lag behind where the curvature steps.

use super::limits::Limits;
use super::path_segments::Route;
use super::speed_profile::{Motion, angle, preview};
use crate::error::{Error, ErrorCode};
use crate::fnv::Fnv;
use crate::geometry::Pose;
use crate::vehicle::Vehicle;

/// Columns of equal length, one item per moment; times increase strictly.
///
/// Between two rows speed is linear (or of the second degree with a limited jerk), so the trapezoids under |speed| add
/// up to `station` without a limit of jerk.
#[derive(Debug, Clone, Default)]
pub struct Rows {
    /// Seconds.
    pub t: Vec<f64>,
    /// Distance driven, metres.
    pub station: Vec<f64>,
    /// Middle of the rear axle.
    pub poses: Vec<Pose>,
    /// m/s, negative in reverse.
    pub speed: Vec<f64>,
    /// Change of `speed` from here on, m/s².
    pub acceleration: Vec<f64>,
    /// Angle of the middle front wheel, radians, positive to the left; changes no faster than the car's limit.
    pub steering: Vec<f64>,
}

/// A moment of a drive.
#[derive(Debug, Clone, Copy)]
pub(super) struct Moment {
    pub(super) t: f64,
    pub(super) station: f64,
    /// Without sign.
    pub(super) speed: f64,
    pub(super) acceleration: f64,
    pub(super) run: usize,
}

impl Rows {
    /// FNV-1a-64 over all columns, as 16 hex digits: equal on every platform.
    pub fn hash(&self) -> String {
        let poses = self.poses.iter().flat_map(|p| [p.x, p.y, p.heading]);
        let columns = [&self.t, &self.station, &self.speed, &self.acceleration, &self.steering];
        hash(poses.chain(columns.into_iter().flatten().copied()))
    }

    /// Adds a moment. The wheel has followed the previous one's curvature since then.
    pub(super) fn push(&mut self, vehicle: &Vehicle, route: &Route, now: Moment, wheel: &mut Wheel) {
        let run = route.runs.get(now.run);
        let gear = run.map_or(1.0, |r| r.gear);
        wheel.turn(now.t, vehicle.max_steer_rate);
        wheel.wanted = run.map_or(0.0, |run| {
            angle(vehicle, route.curvature_in(run, now.station + preview(vehicle) * now.speed))
        });
        self.t.push(now.t);
        self.station.push(now.station);
        self.poses.push(route.pose(now.station));
        // Not −0 where the car stands.
        self.speed.push(now.speed * gear + 0.0);
        self.acceleration.push(now.acceleration * gear + 0.0);
        self.steering.push(wheel.at);
    }
}

/// Rows of one trajectory, about.
const MAX_TICKS: f64 = 1e6;

/// FNV-1a-64 of numbers, as 16 hex digits.
pub(crate) fn hash(values: impl Iterator<Item = f64>) -> String {
    let mut hash = Fnv::new();
    hash.add_numbers(values);
    hash.hex()
}

/// A wheel that turns towards an angle at a limited rate, straight at first.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct Wheel {
    pub(super) at: f64,
    pub(super) wanted: f64,
    time: f64,
}

impl Wheel {
    fn turn(&mut self, t: f64, rate: f64) {
        let most = rate * (t - self.time);
        self.at += (self.wanted - self.at).clamp(-most, most);
        self.time = t;
    }
}

/// A path in time.
#[derive(Debug, Clone)]
pub struct Trajectory {
    /// At most `dt` apart, with a row wherever the acceleration changes.
    pub rows: Rows,
    /// Time of the whole drive, seconds.
    pub duration: f64,
    /// Metres.
    pub length: f64,
    /// Time at standstill to turn the wheel, seconds.
    pub dwell: f64,
    /// Largest v²·|κ|, m/s².
    pub max_lateral_acceleration: f64,
}

/// Gives a route times: speeds within limits, standstill to turn the wheel at gear changes.
///
/// # Errors
/// As [`Motion::new`]; [`ErrorCode::Config`] where `dt` would make more than a million rows.
///
/// # Examples
/// ```
/// use parkade::drive::{Limits, Route, trajectory};
/// use parkade::plan::Planner;
///
/// let scene = parkade::scenario::catalog::scenario("P2").unwrap();
/// let mut planner = Planner::new("hybrid", &scene, &Default::default()).unwrap();
/// let plan = planner.plan(Default::default());
/// let vehicle = &planner.geometry().vehicle;
/// let route = Route::new(vehicle, &plan.path, &plan.directions, Some(&plan.curvatures)).unwrap();
/// let driven = trajectory(vehicle, &route, &Limits::default()).unwrap();
/// assert!(driven.dwell > 1.9 && driven.duration > driven.length / 2.0);
/// ```
pub fn trajectory(vehicle: &Vehicle, route: &Route, limits: &Limits) -> Result<Trajectory, Error> {
    let motion = Motion::new(vehicle, route, limits)?;
    if motion.duration > MAX_TICKS * limits.dt {
        let message = message!(
            "must be at least {} for {} s, got {}",
            motion.duration / MAX_TICKS,
            format_args!("{:.0}", motion.duration),
            limits.dt
        );
        return Err(Error::new(ErrorCode::Config, "dt", message));
    }
    let (mut rows, mut wheel, mut lateral) = (Rows::default(), Wheel::default(), 0.0_f64);
    let mut tick = 0.0;
    let mut add = |phase: &super::phase::Phase, after: f64| {
        let (station, speed, acceleration) = phase.after(after);
        let now = Moment { t: phase.time + after, station, speed, acceleration, run: phase.run };
        rows.push(vehicle, route, now, &mut wheel);
        let curvature = route.leg(station).map_or(0.0, |leg| leg.curvature);
        lateral = lateral.max(speed * speed * curvature.abs());
    };
    for phase in &motion.phases {
        add(phase, 0.0);
        let end = phase.time + phase.duration;
        while tick * limits.dt < end - 1e-9 {
            let after = tick * limits.dt - phase.time;
            if after > 1e-9 {
                add(phase, after);
            }
            tick += 1.0;
        }
    }
    match motion.phases.last() {
        Some(last) => add(last, last.duration),
        None => add(&super::phase::Phase::default(), 0.0),
    }
    if let (Some(station), Some(acceleration)) = (rows.station.last_mut(), rows.acceleration.last_mut()) {
        (*station, *acceleration) = (route.length(), 0.0);
    }
    if let Some(pose) = rows.poses.last_mut() {
        *pose = route.pose(route.length());
    }
    Ok(Trajectory {
        rows,
        duration: motion.duration,
        length: route.length(),
        dwell: motion.dwell,
        max_lateral_acceleration: lateral,
    })
}

//! Speeds along a route: limits, a forward and a backward pass, standstill at gear changes.
//!
//! Along the distance s the speed is bounded by the speed limit, by the lateral acceleration, |κ|·v² ≤
//! `lateral_acceleration`, and, where the curvature changes gradually, by the wheel's rate. Between two places Δs
//! apart the car can neither speed up nor brake harder than its limits:
//!
//! ```text
//! v(s + Δs)² ≤ v(s)² + 2 · a_up · Δs          forward pass
//! v(s)² ≤ v(s + Δs)² + 2 · a_down · Δs        backward pass
//! ```
//!
//! The largest v that satisfies all of them is the fastest drive without a limit of jerk. Drives of limited jerk
//! are planned by other rules (`jerk_limited`). All in m, m/s, m/s² and m/s³.

use super::jerk_limited;
use super::limits::{Limits, Profile, Steps};
use super::path_segments::{Route, Run};
use super::phase::Phase;
use crate::error::{Error, ErrorCode};
use crate::geometry::math;
use crate::vehicle::Vehicle;

/// The longest drive, seconds: time and memory grow with it.
const MAX_DURATION: f64 = 100_000.0;
/// Neighbouring legs up to this length are samples of a changing curvature, not steps of it, metres.
const SAMPLE: f64 = 0.25;
/// `slow` keeps to this speed, m/s, …
const SLOW: f64 = 0.5;
/// … this near to a step of the curvature, metres.
const NEAR_STEP: f64 = 0.5;

/// Speeds along a route, in time.
///
/// Phases follow each other without a gap and cover the whole duration, standstills included.
///
/// # Examples
/// ```
/// use parkade::drive::{Limits, Motion, Route};
/// use parkade::geometry::Pose;
/// use parkade::vehicle::Vehicle;
///
/// let path = [Pose::new(0.0, 0.0, 0.0), Pose::new(30.0, 0.0, 0.0)];
/// let route = Route::new(&Vehicle::SEDAN, &path, &[1], None).unwrap();
/// let seconds = |limits: Limits| Motion::new(&Vehicle::SEDAN, &route, &limits).unwrap().duration();
/// assert_eq!(seconds(Limits::paper()), 15.0);
/// // Limited accelerations take time, a limited jerk some more.
/// let jerk = Limits { jerk: Some(1.0), ..Limits::default() };
/// assert!(15.0 < seconds(Limits::default()) && seconds(Limits::default()) < seconds(jerk));
/// ```
#[derive(Debug, Clone)]
pub struct Motion {
    pub(super) phases: Vec<Phase>,
    /// When each run begins to move and when it has ended, seconds.
    pub(super) runs: Vec<(f64, f64)>,
    pub(super) duration: f64,
    pub(super) dwell: f64,
}

impl Motion {
    /// Drives `route` within `limits`; the wheel is straight at first.
    ///
    /// # Errors
    /// As [`Limits::validate`]; [`ErrorCode::Config`] for a start or goal speed for which the way or its limits leave
    /// no room, and for drives of more than 100 000 s.
    pub fn new(vehicle: &Vehicle, route: &Route, limits: &Limits) -> Result<Self, Error> {
        limits.validate()?;
        let mut motion = Self { phases: Vec::new(), runs: Vec::new(), duration: 0.0, dwell: 0.0 };
        let mut steering = 0.0;
        for (index, run) in route.runs.iter().enumerate() {
            let wanted = angle(vehicle, route.legs[run.first].curvature);
            let speeds = [
                if index == 0 { limits.start_speed } else { 0.0 },
                if index + 1 == route.runs.len() { limits.goal_speed } else { 0.0 },
            ];
            if limits.dwell && speeds[0] == 0.0 && (wanted - steering).abs() > 1e-9 {
                let duration = (wanted - steering).abs() / vehicle.max_steer_rate;
                motion.push(index, &[Phase { duration, station: run.from, ..Phase::default() }]);
                motion.dwell += duration;
            }
            steering = angle(vehicle, route.legs[run.end - 1].curvature);
            let from = motion.duration;
            let phases = if limits.profile == Profile::Constant {
                let duration = (run.to - run.from) / limits.speed;
                let steady = Phase { duration, station: run.from, speed: limits.speed, ..Phase::default() };
                Some(vec![steady])
            } else {
                let zones = zones(vehicle, route, run, limits);
                match limits.jerk {
                    Some(jerk) => {
                        let ends = [(run.from, speeds[0]), (run.to, speeds[1])];
                        jerk_limited::phases(limits, jerk, &gathered(&zones, run.from), ends)
                    }
                    None => passes(&zones, limits, run, speeds),
                }
            };
            let Some(phases) = phases else {
                let (path, speed) =
                    if speeds[0] > 0.0 { ("startSpeed", speeds[0]) } else { ("goalSpeed", speeds[1]) };
                let message = message!("must leave room to keep the limits of the way, got {}", speed);
                return Err(Error::new(ErrorCode::Config, path, message));
            };
            motion.push(index, &phases);
            motion.runs.push((from, motion.duration));
        }
        motion.within_time()
    }

    /// Drives each run as fast as its length allows, from rest to rest, as if no curvature mattered.
    ///
    /// # Errors
    /// [`ErrorCode::Config`] for drives of more than 100 000 s.
    pub(crate) fn trapezoids(route: &Route, speed: f64, up: f64, down: f64) -> Result<Self, Error> {
        let mut motion = Self { phases: Vec::new(), runs: Vec::new(), duration: 0.0, dwell: 0.0 };
        for (index, run) in route.runs.iter().enumerate() {
            let length = run.to - run.from;
            let peak = speed.min((2.0 * length / (1.0 / up + 1.0 / down)).sqrt());
            let (rise, fall) = (peak * peak / 2.0 / up, peak * peak / 2.0 / down);
            let cruise = (length - rise - fall).max(0.0);
            let begin = Phase { station: run.from, ..Phase::default() };
            let from = motion.duration;
            motion.push(
                index,
                &[
                    Phase { duration: peak / up, acceleration: up, ..begin },
                    Phase { duration: cruise / peak, station: run.from + rise, speed: peak, ..begin },
                    Phase {
                        duration: peak / down,
                        station: run.to - fall,
                        speed: peak,
                        acceleration: -down,
                        ..begin
                    },
                ],
            );
            motion.runs.push((from, motion.duration));
        }
        motion.within_time()
    }

    /// The motion, unless it takes too long.
    fn within_time(self) -> Result<Self, Error> {
        if self.duration > MAX_DURATION {
            let message = message!(
                "must be driven within {} s, takes {} s",
                MAX_DURATION,
                format_args!("{:.0}", self.duration)
            );
            return Err(Error::new(ErrorCode::Config, "path", message));
        }
        Ok(self)
    }

    fn push(&mut self, run: usize, phases: &[Phase]) {
        for phase in phases {
            self.phases.push(Phase { time: self.duration, run, ..*phase });
            self.duration += phase.duration;
        }
    }

    /// The time of the whole drive, seconds. 0 for a route of no length.
    pub fn duration(&self) -> f64 {
        self.duration
    }

    /// Station, speed and acceleration at a time.
    pub(super) fn at(&self, time: f64) -> (f64, f64, f64) {
        let after = self.phases.partition_point(|p| p.time <= time);
        self.phases
            .get(after.max(1) - 1)
            .map_or((0.0, 0.0, 0.0), |p| p.after((time - p.time).clamp(0.0, p.duration)))
    }
}

/// The steering angle of a curvature, radians.
pub(super) fn angle(vehicle: &Vehicle, curvature: f64) -> f64 {
    math::atan(vehicle.wheelbase * curvature)
}

/// The wheel is turned for the curvature this far ahead, seconds: half the time from straight to full lock, so that a
/// step of the curvature falls into the middle of the wheel's turn and leaves no heading error.
pub(super) fn preview(vehicle: &Vehicle) -> f64 {
    vehicle.max_steer / vehicle.max_steer_rate / 2.0
}

/// Stretches of one speed limit: where each ends and its limit.
///
/// The wheel's turn for a step of the curvature lies half before and half after the step; a leg has to be long enough
/// for the halves at its two ends. On samples of a changing curvature that is the limit δ̇ / |dδ/ds|, which always
/// holds.
///
/// A leg of length s between steps whose turns of the wheel take t₁ and t₂ seconds has room for both halves up to the
/// speed 2s/(t₁ + t₂).
fn zones(vehicle: &Vehicle, route: &Route, run: &Run, limits: &Limits) -> Vec<(f64, f64)> {
    let legs = &route.legs[run.first..run.end];
    let turn = |i: usize| {
        (angle(vehicle, legs[i].curvature) - angle(vehicle, legs[i - 1].curvature)).abs()
            / vehicle.max_steer_rate
    };
    let slow = limits.steps == Steps::Slow;
    let short = |i: usize| legs.get(i).is_some_and(|leg| leg.length <= SAMPLE);
    let sampled = |i: usize| short(i) && (short(i + 1) || i > 0 && short(i - 1));
    let turns = |i: usize| {
        let before = if i > 0 { turn(i) } else { 0.0 };
        before + if i + 1 < legs.len() { turn(i + 1) } else { 0.0 }
    };
    // With a limited jerk no zone is shorter than a sample: a wheel's limit of a few millimetres would hold for all of
    // it.
    let window = |i: usize| {
        let (mut first, mut end, mut length) = (i, i + 1, legs[i].length);
        while limits.jerk.is_some() && !slow && length < SAMPLE && (first > 0 || end < legs.len()) {
            let back = first > 0 && (end == legs.len() || i - first < end - i);
            let next = if back { first - 1 } else { end };
            (first, end) = (first.min(next), end.max(next + 1));
            length += legs[next].length;
        }
        2.0 * length / (first..end).map(turns).sum::<f64>()
    };
    let mut zones = Vec::new();
    for (i, leg) in legs.iter().enumerate() {
        let lateral = (limits.lateral_acceleration / leg.curvature.abs()).sqrt();
        let wheel = if slow || sampled(i) { window(i) } else { f64::INFINITY };
        let end = if i + 1 < legs.len() { leg.station + leg.length } else { run.to };
        zones.push((end, limits.speed.min(lateral).min(wheel)));
    }
    let zones = lowered(&zones, run.from, &route.slow);
    let steps = legs.windows(2).filter(|pair| slow && pair[0].length.max(pair[1].length) > SAMPLE);
    let near_steps: Vec<_> =
        steps.map(|pair| (pair[1].station - NEAR_STEP, pair[1].station + NEAR_STEP, SLOW)).collect();
    lowered(&zones, run.from, &near_steps)
}

/// The same zones with at most some speeds between two stations each: from, to, speed, by both stations in order.
/// Linear in zones and stretches, as few stretches overlap.
///
/// `start` is the station at which the first zone begins, metres.
fn lowered(zones: &[(f64, f64)], start: f64, slow: &[(f64, f64, f64)]) -> Vec<(f64, f64)> {
    let mut parts = Vec::new();
    let (mut at, mut passed) = (start, 0);
    for &(end, limit) in zones {
        while at < end {
            passed += slow[passed..].iter().take_while(|stretch| stretch.1 <= at).count();
            let (mut until, mut lowest) = (end, limit);
            for &(from, to, speed) in &slow[passed..] {
                if from > at {
                    until = until.min(from);
                    break;
                }
                (until, lowest) = (until.min(to), lowest.min(speed));
            }
            parts.push((until, lowest));
            at = until;
        }
    }
    parts
}

/// Zones at least [`SAMPLE`] long, with the lowest limit in each; what is shorter takes of the next zone what it lacks.
///
/// A long zone keeps its limit where it can; one that is too short takes the lower limit with it, so no limit is ever
/// exceeded.
fn gathered(zones: &[(f64, f64)], start: f64) -> Vec<(f64, f64)> {
    let mut parts: Vec<(f64, f64)> = Vec::new();
    let mut begin = start;
    for &(end, limit) in zones {
        if let Some(last) = parts.last_mut() {
            let lacking = begin + SAMPLE - last.0;
            if lacking > 0.0 {
                *last = (end.min(begin + SAMPLE), last.1.min(limit));
            }
            if last.1 == limit {
                last.0 = end;
            }
            if last.0 >= end {
                continue;
            }
            begin = last.0;
        }
        parts.push((end, limit));
    }
    parts
}

/// The fastest speeds through the zones from one speed to another: a forward pass, a backward pass, then at most three
/// phases in each zone. `None` where a limit comes too soon for the one or the other.
///
/// Within a zone of length s between the squared speeds a and b, the parabolas of speeding up and braking meet at v² =
/// (2·up·down·s + down·a + up·b)/(up + down). Above the zone's limit the top is cut off by a phase of steady speed.
/// Linear in the zones.
fn passes(zones: &[(f64, f64)], limits: &Limits, run: &Run, speeds: [f64; 2]) -> Option<Vec<Phase>> {
    let (up, down) = (limits.acceleration, limits.deceleration);
    let length = |i: usize| zones[i].0 - if i == 0 { run.from } else { zones[i - 1].0 };
    // Squared speeds at the ends of the zones.
    let ends = speeds.map(|speed| speed * speed);
    let mut square = vec![ends[0]; zones.len() + 1];
    for i in 0..zones.len() {
        let next = zones.get(i + 1).map_or(speeds[1], |z| z.1);
        let top = zones[i].1.min(next);
        square[i + 1] = (square[i] + 2.0 * up * length(i)).min(top * top);
    }
    let reached = square[zones.len()] >= ends[1] - 1e-9;
    for i in (0..zones.len()).rev() {
        square[i] = (square[i + 1] + 2.0 * down * length(i)).min(square[i]);
    }
    let first = zones.first().map_or(f64::INFINITY, |z| z.1);
    if !reached || square[0] < ends[0] - 1e-9 || speeds[0] > first {
        return None;
    }
    let mut phases = Vec::new();
    for (i, &(end, limit)) in zones.iter().enumerate() {
        let (from, to, length) = (square[i], square[i + 1], length(i));
        let meet = (2.0 * up * down * length + down * from + up * to) / (up + down);
        let peak = meet.min(limit * limit).max(from).max(to);
        let (rise, fall) = ((peak - from) / (2.0 * up), (peak - to) / (2.0 * down));
        let cruise = length - rise - fall;
        let (v0, v1, top) = (from.sqrt(), to.sqrt(), peak.sqrt());
        let start = end - length;
        let parts = [
            (start, v0, up, (top - v0) / up),
            (start + rise, top, 0.0, cruise / top),
            (end - fall, top, -down, (top - v1) / down),
        ];
        for (station, speed, acceleration, duration) in parts {
            // Shorter times are rounding.
            if duration > 1e-9 {
                phases.push(Phase { duration, station, speed, acceleration, ..Phase::default() });
            }
        }
    }
    Some(phases)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn stretches_lower_the_zones_that_they_overlap() {
        let zones = [(2.0, 5.0), (6.0, 3.0), (9.0, 8.0)];
        assert_eq!(lowered(&zones, 0.0, &[]), zones);
        let parts =
            lowered(&zones, 0.0, &[(-1.0, 1.0, 4.0), (1.5, 3.0, 2.0), (2.5, 7.0, 6.0), (8.0, 20.0, 7.0)]);
        let want = [
            (1.0, 4.0),
            (1.5, 5.0),
            (2.0, 2.0),
            (2.5, 2.0),
            (3.0, 2.0),
            (6.0, 3.0),
            (7.0, 6.0),
            (8.0, 8.0),
            (9.0, 7.0),
        ];
        assert_eq!(parts, want);
    }
}

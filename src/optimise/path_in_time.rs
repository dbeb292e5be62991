//! A trajectory's path, driven with more stops than it has itself.
//!
//! The path and the steering angle at each place stay; the car is nowhere faster than the trajectory and brakes and
//! speeds up no harder, so that all limits are kept that the trajectory keeps.
//!
//! The limits along the distance s are those of the trajectory: with its own speed v₀(s), and its largest acceleration
//! a and deceleration b,
//!
//! ```text
//! v ≤ v₀(s)        dv²/ds ≤ 2a        dv²/ds ≥ −2b        v = 0 at each stop
//! ```
//!
//! A slower drive of the same path turns the wheel more slowly and has less lateral acceleration, so these hold too.
//! The forward and the backward pass over v² give the fastest such drive in time linear in the rows. Stops can only be
//! at rows, because only there v² has a corner.

use super::roll_out::moved;
use crate::drive::Rows;
use crate::geometry::Pose;
use crate::referee::States;

/// Rows stand no farther apart, seconds.
const ROW: f64 = 0.05;
/// Shorter stretches are none, metres.
const NOTHING: f64 = 1e-12;
/// A car that stops can start again, however steady the trajectory's own speed is, m/s².
const LEAST: f64 = 0.01;

/// A stop at a row of the trajectory until a time, seconds.
///
/// Several stops may be at one row: the car waits until the last of them.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Stop {
    pub(super) row: usize,
    pub(super) until: f64,
}

/// Times and speeds at the trajectory's rows.
///
/// All columns have one item per row of the trajectory.
#[derive(Debug)]
pub(super) struct Timeline {
    /// When the car comes to a row and when it leaves it, seconds; infinite behind a stop without end.
    pub(super) comes: Vec<f64>,
    pub(super) leaves: Vec<f64>,
    /// m/s, without sign.
    pub(super) speeds: Vec<f64>,
}

impl Timeline {
    /// Infinite if the last stop has no end.
    pub(super) fn duration(&self) -> f64 {
        self.leaves.last().copied().unwrap_or(0.0)
    }

    /// The row that was left last at a time.
    pub(super) fn row_at(&self, t: f64) -> usize {
        self.comes.partition_point(|&comes| comes <= t).max(1) - 1
    }
}

/// `stations` are metres driven up to each row.
pub(super) struct PathInTime<'a> {
    states: &'a States,
    wheelbase: f64,
    pub(super) stations: Vec<f64>,
    /// Largest acceleration and deceleration of the trajectory, m/s².
    up: f64,
    pub(super) down: f64,
}

impl<'a> PathInTime<'a> {
    /// Linear in the rows. A trajectory of constant speed would allow no braking; [`LEAST`] sees to it that it does.
    pub(super) fn new(states: &'a States, wheelbase: f64) -> Self {
        let (mut up, mut down) = (LEAST, LEAST);
        for (t, v) in states.t.windows(2).zip(states.speed.windows(2)) {
            let change = (v[1].abs() - v[0].abs()) / (t[1] - t[0]);
            (up, down) = (up.max(change), down.max(-change));
        }
        Self { states, wheelbase, stations: states.stations(), up, down }
    }

    pub(super) fn pose(&self, row: usize) -> Pose {
        self.states.poses[row]
    }

    /// True if the trajectory itself stands at a row.
    pub(super) fn rests(&self, row: usize) -> bool {
        self.states.speed[row] == 0.0
    }

    /// True if the car can stop at a row when it stood at row `last` before: with a row on the way from one standstill
    /// to the next.
    pub(super) fn can_stop(&self, row: usize, last: usize) -> bool {
        let is_moving = |row: usize| self.states.speed.get(row).is_some_and(|&v| v != 0.0);
        row == last || self.rests(row) || (row >= last + 2 && is_moving(row - 1) && is_moving(row + 1))
    }

    /// The distance in which the car comes to rest, metres.
    pub(super) fn braking_distance(&self, speed: f64) -> f64 {
        speed * speed / 2.0 / self.down
    }

    /// The fastest drive with stops, which are in the rows' order.
    pub(super) fn timeline(&self, stops: &[Stop]) -> Timeline {
        let (n, states) = (self.states.t.len(), self.states);
        let length = |i: usize| self.stations[i + 1] - self.stations[i];
        let mut square: Vec<f64> = states.speed.iter().map(|v| v * v).collect();
        for stop in stops {
            square[stop.row] = 0.0;
        }
        for i in 1..n {
            square[i] = square[i].min(square[i - 1] + 2.0 * self.up * length(i - 1));
        }
        for i in (1..n).rev() {
            square[i - 1] = square[i - 1].min(square[i] + 2.0 * self.down * length(i - 1));
        }
        let speeds: Vec<f64> = square.into_iter().map(f64::sqrt).collect();
        let (mut comes, mut leaves) = (Vec::with_capacity(n), Vec::with_capacity(n));
        let (mut t, mut stops) = (0.0_f64, stops.iter().peekable());
        for i in 0..n {
            comes.push(t);
            while let Some(stop) = stops.next_if(|stop| stop.row == i) {
                t = t.max(stop.until);
            }
            leaves.push(t);
            if i + 1 < n {
                let (length, sum) = (length(i), speeds[i] + speeds[i + 1]);
                // A wheel that turns at standstill takes as long as it did.
                t += if length > NOTHING { 2.0 * length / sum } else { states.t[i + 1] - states.t[i] };
            }
        }
        Timeline { comes, leaves, speeds }
    }

    /// The rows of a drive up to a time.
    ///
    /// Rows stand at most 0.05 s apart, at those of the trajectory and at the ends of waits. The last one is at `end`
    /// or the drive's own end.
    pub(super) fn rows(&self, timeline: &Timeline, end: f64) -> Rows {
        let mut rows = Rows::default();
        let n = self.states.t.len();
        for i in 0..n {
            let (comes, leaves) = (timeline.comes[i], timeline.leaves[i].min(end));
            if comes > end {
                break;
            }
            let place = self.place(i, 0.0);
            spread(comes, leaves, |t, _| self.push(&mut rows, i, place, (t, 0.0, 0.0)));
            if i + 1 == n || timeline.leaves[i] > end {
                self.push(&mut rows, i, place, (leaves, timeline.speeds[i], 0.0));
                break;
            }
            let (from, to, next) = (timeline.speeds[i], timeline.speeds[i + 1], timeline.comes[i + 1]);
            let duration = next - leaves;
            let acceleration = (to - from) / duration;
            spread(leaves, next, |t, share| {
                if t <= end {
                    let speed = from + (to - from) * share;
                    let length = self.stations[i + 1] - self.stations[i];
                    let along = if length > NOTHING {
                        f64::midpoint(from, speed) * share * duration / length
                    } else {
                        share
                    };
                    self.push(&mut rows, i, self.place(i, along), (t, speed, acceleration));
                }
            });
        }
        if let Some(last) = rows.acceleration.last_mut() {
            *last = 0.0;
        }
        rows
    }

    /// Adds a row: behind trajectory row `i`, at a station, a pose and a steering angle; time, speed and acceleration
    /// without sign.
    fn push(&self, rows: &mut Rows, i: usize, place: (f64, Pose, f64), (t, speed, change): (f64, f64, f64)) {
        if rows.t.last().is_some_and(|&last| last >= t) {
            return;
        }
        let speeds = &self.states.speed;
        let gear = if speeds[i] + speeds.get(i + 1).copied().unwrap_or(0.0) < 0.0 { -1.0 } else { 1.0 };
        rows.t.push(t);
        rows.station.push(place.0);
        rows.poses.push(place.1);
        // Not −0 where the car stands.
        rows.speed.push(speed * gear + 0.0);
        rows.acceleration.push(change * gear + 0.0);
        rows.steering.push(place.2);
    }

    /// Station, pose and steering angle a share of the way, or at standstill of the time, from row `i` to the next.
    ///
    /// The trajectory is linear in *time* between rows, so a share of the distance is first turned into its own time
    /// there, and the pose is integrated to that time.
    fn place(&self, i: usize, share: f64) -> (f64, Pose, f64) {
        let states = self.states;
        let (pose, angle) = (states.poses[i], states.steering[i]);
        if share == 0.0 {
            return (self.stations[i], pose, angle);
        }
        let (from, to) = (states.speed[i], states.speed[i + 1]);
        let (dt, length) = (states.t[i + 1] - states.t[i], self.stations[i + 1] - self.stations[i]);
        let along = share * length;
        let after = if length > NOTHING {
            // Seconds in which the trajectory itself comes so far.
            let change = (to.abs() - from.abs()) / dt;
            let speed = (from * from + 2.0 * change * along).max(0.0).sqrt();
            (2.0 * along / (from.abs() + speed)).min(dt)
        } else {
            share * dt
        };
        let mixed = |from: f64, to: f64| [0.0, 0.5, 1.0].map(|part| from + (to - from) * part * after / dt);
        let angles = mixed(angle, states.steering[i + 1]);
        let pose = moved(pose, after, mixed(from, to), angles, self.wheelbase);
        (self.stations[i] + along, pose, angles[2])
    }
}

/// Times from one to another that are no farther apart than rows, the last left out, and their shares of the way.
fn spread(from: f64, to: f64, mut each: impl FnMut(f64, f64)) {
    let parts = ((to - from) / ROW - 1e-9).ceil().max(0.0);
    for part in 0..parts as u32 {
        let share = f64::from(part) / parts;
        each(from + (to - from) * share, share);
    }
}

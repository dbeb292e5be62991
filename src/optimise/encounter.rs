//! Stop, wait, go: along a trajectory, for what moves.
//!
//! The rules are those of [`crate::drive::stop_wait_go`], but the car brakes and speeds up as a car does. `reactive`
//! keeps a stopping distance: it brakes for a moving box that is nearer to its way than the car needs to stop. It knows
//! no motion ahead, so it may still be in a box's way, where it brakes or where it stands. `predictive` knows all
//! motions, so its stops are found before the car starts.
//!
//! A constant-speed car stops within no distance. This one needs v²/(2b) with the deceleration b, so *where* it can
//! stand depends on how fast it comes, and a decision has to be taken that far ahead. Both rules change the speeds
//! only, never the path or the steering angle at a place; every stop re-times the rest of the drive ([`PathInTime`]).
//!
//! Times are seconds from the start of the drive, stations metres driven in either gear. The answer has rows that are
//! more finely spaced than the trajectory's, and is checked for contact between the rows by code that the rules do not
//! use.

use super::path_in_time::{PathInTime, Stop, Timeline};
use crate::drive::{
    Contact, Encounter, Ending, Mover, Rows, Rule, SAMPLE, SHORTEST, SPARE, Scope, Wait, WaitOptions,
    first_contact, nearest, times_to_collision,
};
use crate::error::Error;
use crate::geometry::{Point, Pose, math};
use crate::referee::States;
use crate::vehicle::Vehicle;

/// Drives a trajectory, stopping and waiting for `movers`. It is nowhere faster than the trajectory, and brakes and
/// speeds up no harder; of the options `speed` and `deceleration` do not matter.
///
/// The work grows with the rows, the samples of the path and the stops. `free_duration` of the answer is the
/// trajectory's own.
///
/// # Errors
/// As [`WaitOptions::validate`].
///
/// # Panics
/// For states without a row.
///
/// # Examples
/// ```
/// use parkade::drive::{Ending, Mover, Route, WaitOptions};
/// use parkade::optimise::{Options, optimise, stop_wait_go};
/// use parkade::plan::Planner;
///
/// let scene = parkade::scenario::catalog::scenario("fig16-conflict").unwrap();
/// let mut planner = Planner::new("hybrid", &scene, &Default::default()).unwrap();
/// let plan = planner.plan(Default::default());
/// let car = planner.geometry().vehicle;
/// let route = Route::new(&car, &plan.path, &plan.directions, Some(&plan.curvatures)).unwrap();
/// let clearance = plan.metrics.min_clearance;
/// let made = optimise(planner.geometry(), &route, clearance, &Options::default()).unwrap();
/// let movers: Vec<Mover> = scene.moving.iter().map(Mover::new).collect();
/// let met = stop_wait_go(&car, &made.states, &movers, &WaitOptions::default()).unwrap();
/// assert_eq!((met.ending, met.waits.len()), (Ending::Arrived, 1));
/// ```
pub fn stop_wait_go(
    vehicle: &Vehicle,
    states: &States,
    movers: &[Mover],
    options: &WaitOptions,
) -> Result<Encounter, Error> {
    options.validate()?;
    let drive = Drive::new(vehicle, states, movers, options);
    let (stops, ending) = match options.rule {
        Rule::Predictive => drive.foreseen(),
        Rule::Reactive => drive.reacted(),
    };
    let timeline = drive.path.timeline(&stops);
    let blocked = if ending == Ending::Blocked { stops.last().map(|stop| stop.until) } else { None };
    let end = blocked.unwrap_or(timeline.duration());
    let (end, ending) =
        if end > options.max_time { (options.max_time, Ending::OutOfTime) } else { (end, ending) };
    let rows = drive.path.rows(&timeline, end);
    let contact = contact(vehicle, movers, &rows);
    let clearance = |(&t, &pose): (&f64, &Pose)| nearest(movers, &vehicle.outline(pose), t).0;
    Ok(Encounter {
        ending: ending.with(options.rule, contact.is_some()),
        clearances: rows.t.iter().zip(&rows.poses).map(clearance).collect(),
        times_to_collision: times_to_collision(vehicle, movers, &rows),
        waits: drive.waits(&stops, &timeline, end),
        contact,
        duration: rows.t[rows.t.len() - 1],
        free_duration: states.duration(),
        rows,
    })
}

/// The first overlap; between two rows the pose is linear, which is half a millimetre off at most.
fn contact(vehicle: &Vehicle, movers: &[Mover], rows: &Rows) -> Option<Contact> {
    let after = |i: usize| (i + 1).min(rows.t.len() - 1);
    let speed = |i: usize| rows.speed[i].abs().max(rows.speed[after(i)].abs());
    let moments: Vec<(f64, f64)> = rows.t.iter().enumerate().map(|(i, &t)| (t, speed(i))).collect();
    first_contact(vehicle, movers, &moments, |i, t| {
        let (from, to) = (rows.poses[i], rows.poses[after(i)]);
        let lasts = rows.t[after(i)] - rows.t[i];
        let share = if lasts > 0.0 { (t - rows.t[i]) / lasts } else { 0.0 };
        let at = from.point() + (to.point() - from.point()) * share;
        Pose::new(at.x, at.y, from.heading + math::turn(from.heading, to.heading) * share)
    })
}

/// Samples ascend; their stations do as well, except that several samples can share a station where the wheel turns at
/// standstill.
struct Drive<'a> {
    path: PathInTime<'a>,
    movers: &'a [Mover],
    options: &'a WaitOptions,
    /// Rows at which the body is held against the boxes: all at standstill, others [`SAMPLE`] apart.
    samples: Vec<usize>,
    /// The body at each of them.
    bodies: Vec<[Point; 4]>,
    /// When the last box stands, seconds.
    last_motion: f64,
    /// The trajectory's largest speed, m/s: a standing car starts where it would not have to brake at that speed.
    top: f64,
}

impl<'a> Drive<'a> {
    /// Samples the trajectory where the car rests and at equal distances, and keeps the body's outline at each
    /// sample: only times change from then on.
    fn new(vehicle: &Vehicle, states: &'a States, movers: &'a [Mover], options: &'a WaitOptions) -> Self {
        let path = PathInTime::new(states, vehicle.wheelbase);
        let mut samples: Vec<usize> = Vec::new();
        for row in 0..states.t.len() {
            let is_far = |&last: &usize| path.stations[row] >= path.stations[last] + SAMPLE;
            if path.rests(row) || samples.last().is_none_or(is_far) || row + 1 == states.t.len() {
                samples.push(row);
            }
        }
        let bodies = samples.iter().map(|&row| vehicle.outline(states.poses[row])).collect();
        let last_motion = movers.iter().fold(0.0_f64, |last, mover| last.max(mover.end()));
        let top = states.speed.iter().fold(0.0, |top: f64, speed| top.max(speed.abs()));
        Self { path, movers, options, samples, bodies, last_motion, top }
    }

    /// Distance driven up to a sample, metres.
    fn station(&self, sample: usize) -> f64 {
        self.path.stations[self.samples[sample]]
    }

    /// True if a box, grown by `margin`, is at a sample's body between two times. `to` may be infinite.
    fn is_met(&self, sample: usize, margin: f64, from: f64, to: f64) -> bool {
        self.movers.iter().any(|mover| mover.meets(&self.bodies[sample], margin, from, to))
    }

    /// The first sample from one on, up to another, at which a box comes nearer than `margin`; all `later` by so many
    /// seconds.
    ///
    /// Between a sample and the next the body is taken to stand at the first for the whole time; samples are [`SAMPLE`]
    /// apart, which the margin covers.
    fn first_hit(
        &self,
        timeline: &Timeline,
        (first, last): (usize, usize),
        margin: f64,
        later: f64,
    ) -> Option<usize> {
        (first..=last).find(|&k| {
            let row = self.samples[k];
            let from = if k == first { timeline.leaves[row] } else { timeline.comes[row] };
            let to = self.samples.get(k + 1).map_or(from, |&next| timeline.comes[next]);
            self.is_met(k, margin, from + later, to + later)
        })
    }

    /// The stops of `predictive`, and whether the car arrives.
    ///
    /// Each stop is added behind the last, so the loop ends: a stop either lies farther along, or releases later at the
    /// same place, and time is bounded by the options.
    fn foreseen(&self) -> (Vec<Stop>, Ending) {
        let mut stops: Vec<Stop> = Vec::new();
        // The sample at which the car stands.
        let mut at = 0;
        loop {
            let timeline = self.path.timeline(&stops);
            let end = self.samples.len() - 1;
            let hit = self.first_hit(&timeline, (at, end), self.options.margin, 0.0);
            // Without a place to stand the car had better leave the box's way.
            let hold = hit.and_then(|hit| self.hold(&stops, &timeline, (at, hit)));
            let Some(hold) = hold else { return (stops, Ending::Arrived) };
            at = hold;
            let row = self.samples[hold];
            stops.push(Stop { row, until: f64::INFINITY });
            let arrival = self.path.timeline(&stops).comes[row];
            let since = stops.iter().rev().skip(1).find(|stop| stop.row == row).map_or(arrival, |s| s.until);
            let last = stops.len() - 1;
            match self.release(&mut stops, (at, since)) {
                Ok(until) => stops[last].until = until,
                Err(until) => {
                    stops[last].until = until;
                    return (stops, Ending::Blocked);
                }
            }
            if stops[last].until > self.options.max_time {
                return (stops, Ending::OutOfTime);
            }
        }
    }

    /// The last sample from `at` up to a hit where the car can stop half a metre earlier than it must, and stays free
    /// for all later times.
    ///
    /// Later places are tried first, since a car that stands nearer to the box's way needs less time to be past it. The
    /// braking car itself must stay free on the way to the stop.
    fn hold(&self, stops: &[Stop], timeline: &Timeline, (at, hit): (usize, usize)) -> Option<usize> {
        let margin = self.options.margin;
        let is_safe = |k: usize, from: f64| !self.is_met(k, margin, from, f64::INFINITY);
        (at..=hit).rev().find_map(|must| {
            if !is_safe(must, timeline.comes[self.samples[must]]) {
                return None;
            }
            let early = self.station(must) - SPARE;
            let hold = (at..=must)
                .rev()
                .find(|&k| self.station(k) <= early && self.path.can_stop(self.samples[k], self.samples[at]));
            let hold = hold.unwrap_or(at);
            let with = [stops, &[Stop { row: self.samples[hold], until: f64::INFINITY }]].concat();
            let slower = self.path.timeline(&with);
            let is_free = is_safe(hold, slower.comes[self.samples[hold]])
                && (hold == at || self.first_hit(&slower, (at, hold - 1), margin, 0.0).is_none());
            is_free.then_some(hold)
        })
    }

    /// When the car goes on from a sample where it stands since a time: the whole way is free then. An error tells when
    /// that will never be.
    fn release(&self, stops: &mut [Stop], (at, since): (usize, f64)) -> Result<f64, f64> {
        let dt = self.options.dt;
        let first = ((since + SHORTEST) / dt - 1e-9).ceil() * dt;
        if let Some(stop) = stops.last_mut() {
            stop.until = first;
        }
        let timeline = self.path.timeline(stops);
        let given_up = self.last_motion.max(since) + SHORTEST + dt;
        for tick in 0.. {
            let later = f64::from(tick) * dt;
            let end = self.samples.len() - 1;
            if self.first_hit(&timeline, (at, end), self.options.release_margin, later).is_none() {
                return Ok(first + later);
            }
            if first + later > given_up.min(self.options.max_time) {
                return Err(first + later);
            }
        }
        Err(given_up)
    }

    /// The stops of `reactive`, and whether the car arrives.
    ///
    /// A decision every `dt` seconds. A car that is braking does not change its mind before it stands.
    fn reacted(&self) -> (Vec<Stop>, Ending) {
        let mut stops: Vec<Stop> = Vec::new();
        let mut timeline = self.path.timeline(&stops);
        for tick in 0.. {
            let t = f64::from(tick) * self.options.dt;
            if t > self.options.max_time {
                return (stops, Ending::OutOfTime);
            }
            let row = timeline.row_at(t);
            match stops.last_mut().filter(|stop| stop.until == f64::INFINITY) {
                Some(stop) if row < stop.row => {}
                Some(stop) => {
                    let is_blocked =
                        self.is_obstructed((stop.row, self.path.stations[stop.row], self.top), t);
                    if is_blocked && t <= self.last_motion + SHORTEST {
                        continue;
                    }
                    stop.until = t;
                    if is_blocked {
                        return (stops, Ending::Blocked);
                    }
                    timeline = self.path.timeline(&stops);
                }
                None if t >= timeline.duration() => return (stops, Ending::Arrived),
                None => {
                    let now = self.moment(&timeline, row, t);
                    if self.is_obstructed(now, t)
                        && let Some(row) = self.braked(&stops, now)
                    {
                        stops.push(Stop { row, until: f64::INFINITY });
                        timeline = self.path.timeline(&stops);
                    }
                }
            }
        }
        (stops, Ending::OutOfTime)
    }

    /// Row left last, station and speed at a time.
    fn moment(&self, timeline: &Timeline, row: usize, t: f64) -> (usize, f64, f64) {
        let (station, from) = (self.path.stations[row], timeline.speeds[row]);
        let (Some(&to), Some(&next)) = (timeline.speeds.get(row + 1), timeline.comes.get(row + 1)) else {
            return (row, station, 0.0);
        };
        let (after, lasts) = ((t - timeline.leaves[row]).max(0.0), next - timeline.leaves[row]);
        let speed = from + (to - from) * (after / lasts).min(1.0);
        (row, station + f64::midpoint(from, speed) * after, speed)
    }

    /// The row at which a braking car stands; none where that is the end. The trajectory's rows are the only places to
    /// stop, so it may be a little farther than the least braking distance.
    fn braked(&self, stops: &[Stop], (row, station, speed): (usize, f64, f64)) -> Option<usize> {
        let end = station + self.path.braking_distance(speed);
        let last = stops.last().map_or(0, |stop| stop.row);
        let can_stop = |row: usize| {
            let is_behind = self.path.stations[row] >= end - 1e-9;
            is_behind && self.path.can_stop(row, last)
        };
        let first = if speed == 0.0 { row } else { row + 1 };
        (first..self.path.stations.len() - 1).find(|&row| can_stop(row))
    }

    /// True if a box is so near to the way ahead now that a car of this speed has to brake.
    fn is_obstructed(&self, (row, station, speed): (usize, f64, f64), t: f64) -> bool {
        let (braking, margin) = (self.path.braking_distance(speed), self.options.margin);
        let reach = match self.options.scope {
            Scope::Remaining => f64::INFINITY,
            Scope::Window => braking + 0.5 * speed + 1.0,
        };
        let is_near = |k: usize, mover: &Mover| {
            let room = if mover.moves(t) { margin.max(braking) } else { margin };
            mover.meets(&self.bodies[k], room, t, t)
        };
        let first = self.samples.partition_point(|&sample| sample <= row).max(1) - 1;
        (first..self.samples.len())
            .take_while(|&k| k == first || self.station(k) <= station + reach)
            .any(|k| self.movers.iter().any(|mover| is_near(k, mover)))
    }

    /// The stops as waits, those at one station joined; what begins after the end of the drive is left out.
    fn waits(&self, stops: &[Stop], timeline: &Timeline, end: f64) -> Vec<Wait> {
        let mut waits: Vec<Wait> = Vec::new();
        for stop in stops {
            let (station, from) = (self.path.stations[stop.row], timeline.comes[stop.row]);
            match waits.last_mut() {
                Some(last) if last.station == station => last.to = stop.until.min(end),
                _ if from < end => {
                    let pose = self.path.pose(stop.row);
                    waits.push(Wait { pose, station, from, to: stop.until.min(end) });
                }
                _ => {}
            }
        }
        waits
    }
}

//! Stop, wait, go: along a path, for what moves.
//!
//! The parking paper stops when the obstacle's present place touches the way ahead (`reactive`). That can be in the
//! middle of the obstacle's way. `predictive` rolls the drive out against the known motion and stops where it is safe
//! to stand. The result is checked by other code: outlines edge by edge, between the moments too.
//!
//! A decision is taken every `dt` seconds, at stations that are whole multiples of `speed`·`dt`. The car stops and
//! starts at once (its speed is a step), so the drive's time is that of the free drive plus the waits. A moving box
//! never reacts to the car.
//!
//! The guarantee of `predictive` is one-sided: where it arrives without [`Ending::Unavoidable`], the check found no
//! contact. It tries no other speeds and no other paths, and its waits need not be the shortest.

use super::contact::{Contact, first_contact, nearest};
use super::limits::within;
use super::moving_obstacles::Mover;
use super::path_segments::Route;
use super::time_to_collision::times_to_collision;
use super::trajectory::{Moment, Rows, Wheel};
use crate::error::Error;
use crate::geometry::{Point, Pose};
use crate::json;
use crate::vehicle::Vehicle;

/// Stations of a roll-out are this far apart, metres.
pub(crate) const SAMPLE: f64 = 0.1;
/// The car stops this much before the last place that is safe, metres.
pub(crate) const SPARE: f64 = 0.5;
/// It waits at least this long, seconds.
pub(crate) const SHORTEST: f64 = 0.5;
/// The rule by which the car stops.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Rule {
    /// A hit to come, known from the obstacles' motion; waits where it is safe to stand.
    #[default]
    Predictive,
    /// The parking paper's: an obstacle that is on the way ahead now.
    Reactive,
}

json::words!(Rule: "predictive" = Predictive, "reactive" = Reactive);

/// How far ahead `reactive` looks.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Scope {
    /// To the end of the path.
    #[default]
    Remaining,
    /// v²/(2·deceleration) + 0.5 s·v + 1 m.
    Window,
}

json::words!(Scope: "remaining" = Remaining, "window" = Window);

/// How to wait.
#[derive(Debug, Clone, PartialEq)]
pub struct WaitOptions {
    /// The rule by which the car stops.
    pub rule: Rule,
    /// How far ahead `reactive` looks.
    pub scope: Scope,
    /// Speed along a route, m/s, 0.01 to 100; the car stops and starts at once, as in the paper.
    pub speed: f64,
    /// For a route's window, m/s², 0.01 to 100.
    pub deceleration: f64,
    /// `predictive` keeps this much distance when it decides to stop, metres, 0 to 10.
    pub margin: f64,
    /// And this much when it decides to go on, metres, 0 to 10; more than `margin` makes it stop less often.
    pub release_margin: f64,
    /// A drive that takes longer is given up, seconds, 1 to 3600.
    pub max_time: f64,
    /// Time between two decisions, seconds, 0.01 to 1.
    pub dt: f64,
}

impl Default for WaitOptions {
    fn default() -> Self {
        Self {
            rule: Rule::Predictive,
            scope: Scope::Remaining,
            speed: 2.0,
            deceleration: 1.5,
            margin: 0.3,
            release_margin: 0.5,
            max_time: 600.0,
            dt: 0.05,
        }
    }
}

json::settings! {
    WaitOptions:
    "rule" = rule,
    "scope" = scope,
    "speed" = speed,
    "deceleration" = deceleration,
    "margin" = margin,
    "releaseMargin" = release_margin,
    "maxTime" = max_time,
    "dt" = dt,
}

impl WaitOptions {
    /// Checks every option.
    ///
    /// # Errors
    /// [`crate::error::ErrorCode::Config`] with the field and the rule.
    pub fn validate(&self) -> Result<(), Error> {
        within("speed", self.speed, 0.01, 100.0)?;
        within("deceleration", self.deceleration, 0.01, 100.0)?;
        within("margin", self.margin, 0.0, 10.0)?;
        within("releaseMargin", self.release_margin, 0.0, 10.0)?;
        within("maxTime", self.max_time, 1.0, 3600.0)?;
        within("dt", self.dt, 0.01, 1.0)
    }
}

/// How a drive among moving obstacles ended.
///
/// The first three are all arrivals; the check after the drive decides among them.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Ending {
    /// At the goal, nothing touched.
    Arrived,
    /// At the goal, but `predictive` saw no place to stand safely and something was touched.
    Unavoidable,
    /// At the goal, but something was touched.
    Hit,
    /// Waiting for an obstacle that stays on the path for ever.
    Blocked,
    /// Still under way after `max_time`.
    OutOfTime,
}

impl Ending {
    /// The word of the JS API.
    pub const fn as_str(self) -> &'static str {
        match self {
            Self::Arrived => "arrived",
            Self::Unavoidable => "unavoidable",
            Self::Hit => "hit",
            Self::Blocked => "blocked",
            Self::OutOfTime => "out-of-time",
        }
    }

    /// How a drive ended that arrived and touched something.
    pub(crate) const fn with(self, rule: Rule, is_touched: bool) -> Self {
        match (self, rule, is_touched) {
            (Self::Arrived, Rule::Predictive, true) => Self::Unavoidable,
            (Self::Arrived, Rule::Reactive, true) => Self::Hit,
            _ => self,
        }
    }
}

/// A time at standstill.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Wait {
    /// Pose of the car, metres and radians.
    pub pose: Pose,
    /// Distance driven before, metres.
    pub station: f64,
    /// Since when, seconds.
    pub from: f64,
    /// Until when, seconds.
    pub to: f64,
}

/// A drive among moving obstacles.
#[derive(Debug, Clone)]
pub struct Encounter {
    /// How it ended.
    pub ending: Ending,
    /// The drive, one row per decision and one at the end.
    pub rows: Rows,
    /// Per row: distance from the body to the nearest moving box, metres; infinite where there is none.
    pub clearances: Vec<f64>,
    /// Per row: seconds until the body would touch a moving box if both kept their velocity; infinite where they never
    /// would.
    pub times_to_collision: Vec<f64>,
    /// The stops.
    pub waits: Vec<Wait>,
    /// The first overlap.
    pub contact: Option<Contact>,
    /// Seconds.
    pub duration: f64,
    /// Seconds it would take without stops.
    pub free_duration: f64,
}

struct Drive<'a> {
    vehicle: &'a Vehicle,
    route: &'a Route,
    movers: &'a [Mover],
    options: &'a WaitOptions,
}

/// Drives `route` at constant speed, stopping and waiting for `movers`.
///
/// The work is that of a roll-out along the way ahead at each decision, until the way is known to stay clear.
///
/// # Examples
/// ```
/// use parkade::drive::{Ending, Mover, Route, WaitOptions, stop_wait_go};
/// use parkade::geometry::Pose;
/// use parkade::scenario::MovingObstacle;
/// use parkade::vehicle::Vehicle;
///
/// let path = [Pose::new(0.0, 0.0, 0.0), Pose::new(20.0, 0.0, 0.0)];
/// let route = Route::new(&Vehicle::SEDAN, &path, &[1], None).unwrap();
/// // A cart that crosses the way ten metres ahead.
/// let cart = MovingObstacle {
///     id: None,
///     size: [1.0, 1.0],
///     points: vec![[12.0, -8.0], [12.0, 8.0]],
///     speed: 1.5,
///     start: 0.0,
/// };
/// let met = stop_wait_go(&Vehicle::SEDAN, &route, &[Mover::new(&cart)], &WaitOptions::default()).unwrap();
/// assert!(met.ending == Ending::Arrived && met.contact.is_none());
/// assert!(met.waits.len() == 1 && met.duration > met.free_duration);
/// ```
///
/// # Errors
/// As [`WaitOptions::validate`].
pub fn stop_wait_go(
    vehicle: &Vehicle,
    route: &Route,
    movers: &[Mover],
    options: &WaitOptions,
) -> Result<Encounter, Error> {
    options.validate()?;
    let drive = Drive { vehicle, route, movers, options };
    let (mut states, waits, mut ending) = drive.run();
    let free_duration = route.length() / options.speed;
    let contact = drive.contact(&states);
    ending = ending.with(options.rule, contact.is_some());
    let (mut rows, mut wheel) = (Rows::default(), Wheel::default());
    if let Some(last) = states.last_mut() {
        last.speed = 0.0;
    }
    let mut clearances = Vec::new();
    for state in &states {
        rows.push(vehicle, route, *state, &mut wheel);
        clearances.push(drive.clearance(state.station, state.t));
    }
    let duration = states.last().map_or(0.0, |s| s.t);
    let times_to_collision = times_to_collision(vehicle, movers, &rows);
    Ok(Encounter { ending, rows, clearances, times_to_collision, waits, contact, duration, free_duration })
}

impl Drive<'_> {
    /// The moments of the drive, the stops, and whether it arrived.
    fn run(&self) -> (Vec<Moment>, Vec<Wait>, Ending) {
        let (options, length) = (self.options, self.route.length());
        let step = options.speed * options.dt;
        let last_motion = self.movers.iter().fold(0.0_f64, |last, m| last.max(m.end()));
        let (mut states, mut waits): (Vec<Moment>, Vec<Wait>) = (Vec::new(), Vec::new());
        let (mut moved, mut waiting, mut clear) = (0.0, None, false);
        for tick in 0.. {
            let (t, s) = (f64::from(tick) * options.dt, f64::min(moved * step, length));
            let blocked = waiting.is_some() && t > last_motion + SHORTEST;
            if let Some(from) = waiting
                && self.released(s, t, from)
            {
                waiting = None;
                {
                    if let Some(wait) = waits.last_mut() {
                        wait.to = t;
                    }
                }
            }
            if waiting.is_none() && !clear && s < length {
                let stop = match options.rule {
                    Rule::Predictive => self.should_hold(s, t, &mut clear),
                    Rule::Reactive => self.obstructed(s, t),
                };
                if stop {
                    waiting = Some(t);
                    waits.push(Wait { pose: self.route.pose(s), station: s, from: t, to: t });
                }
            }
            let speed = if waiting.is_some() || s >= length { 0.0 } else { options.speed };
            let run =
                self.route.runs.iter().position(|r| s < r.to).unwrap_or(self.route.runs.len().max(1) - 1);
            states.push(Moment { t, station: s, speed, acceleration: 0.0, run });
            let ending = match () {
                () if s >= length => Some(Ending::Arrived),
                () if waiting.is_some() && blocked => Some(Ending::Blocked),
                () if t >= options.max_time => Some(Ending::OutOfTime),
                () => None,
            };
            if let Some(ending) = ending {
                if let (Some(wait), Some(_)) = (waits.last_mut(), waiting) {
                    wait.to = t;
                }
                return (states, waits, ending);
            }
            if speed > 0.0 {
                moved += 1.0;
                if moved * step >= length - 1e-9 {
                    let t = t + (length - s) / options.speed;
                    states.push(Moment { t, station: length, speed: 0.0, acceleration: 0.0, run });
                    return (states, waits, Ending::Arrived);
                }
            }
        }
        (states, waits, Ending::OutOfTime)
    }

    /// True if a car that has stood at station `s` since `from` goes on at time `t`.
    fn released(&self, s: f64, t: f64, from: f64) -> bool {
        match self.options.rule {
            Rule::Predictive => {
                t - from >= SHORTEST - 1e-9 && self.first_hit(s, t, self.options.release_margin).is_none()
            }
            Rule::Reactive => !self.obstructed(s, t),
        }
    }

    /// True if `predictive` stops here and now.
    fn should_hold(&self, s: f64, t: f64, clear: &mut bool) -> bool {
        let Some(hit) = self.first_hit(s, t, self.options.margin) else {
            *clear = true;
            return false;
        };
        // Later than that the car is on the obstacle's way already and had better leave it.
        self.safe_until(s, t, hit).is_some_and(|hold| s >= hold - SPARE - 1e-9 && s <= hold + 1e-9)
    }

    /// The station of the first hit of a drive on from (s, t), if there is one.
    fn first_hit(&self, s: f64, t: f64, margin: f64) -> Option<f64> {
        let length = self.route.length();
        let (last, time) = (((length - s) / SAMPLE).ceil() as u32, SAMPLE / self.options.speed);
        (0..=last).find_map(|k| {
            let station = (s + f64::from(k) * SAMPLE).min(length);
            let from = t + (station - s) / self.options.speed;
            let body = self.body(station);
            self.movers.iter().any(|m| m.meets(&body, margin, from, from + time)).then_some(station)
        })
    }

    /// The last station up to `hit` where the car, once there, stays free for all later times. Steps back from the hit
    /// by [`SAMPLE`]; `None` where no place from the start on is free for ever.
    fn safe_until(&self, s: f64, t: f64, hit: f64) -> Option<f64> {
        let steps = (hit / SAMPLE + 1e-6).floor() as u32;
        (0..=steps).map(|k| hit - f64::from(k) * SAMPLE).find(|&station| {
            let from = t + (station - s).max(0.0) / self.options.speed;
            let body = self.body(station);
            !self.movers.iter().any(|m| m.meets(&body, self.options.margin, from, f64::INFINITY))
        })
    }

    /// True if an obstacle is on the way ahead now.
    fn obstructed(&self, s: f64, t: f64) -> bool {
        let v = self.options.speed;
        let reach = match self.options.scope {
            Scope::Remaining => f64::INFINITY,
            Scope::Window => v * v / (2.0 * self.options.deceleration) + 0.5 * v + 1.0,
        };
        let end = self.route.length().min(s + reach);
        (0..=((end - s) / SAMPLE).ceil() as u32).any(|k| {
            let body = self.body((s + f64::from(k) * SAMPLE).min(end));
            self.movers.iter().any(|m| m.meets(&body, 0.0, t, t))
        })
    }

    /// The corners of the car's body at a station.
    fn body(&self, station: f64) -> [Point; 4] {
        self.vehicle.outline(self.route.pose(station))
    }

    /// Distance to the nearest box.
    fn clearance(&self, station: f64, t: f64) -> f64 {
        nearest(self.movers, &self.body(station), t).0
    }

    /// The first overlap, looked for between the moments too.
    fn contact(&self, states: &[Moment]) -> Option<Contact> {
        let speed = |i: usize| {
            let (Some(a), Some(b)) = (states.get(i), states.get(i + 1)) else { return 0.0 };
            if b.t > a.t { (b.station - a.station) / (b.t - a.t) } else { 0.0 }
        };
        let moments: Vec<(f64, f64)> = states.iter().enumerate().map(|(i, s)| (s.t, speed(i))).collect();
        first_contact(self.vehicle, self.movers, &moments, |i, t| {
            self.route.pose(states[i].station + (t - states[i].t) * moments[i].1)
        })
    }
}

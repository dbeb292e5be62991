//! From a plan to a trajectory that a car can follow to the centimetre: the steering angle is continuous, its rate and
//! all other limits are kept, and the time is nearly the least.
//!
//! The path stage changes the path's shape, gear changes included. Then the fastest speeds along it are found exactly,
//! rows are rolled out in time, and the last millimetres to the goal are corrected. The referee's check has the last
//! word: where it refuses every attempt, the plan's own path is driven, and where its curvature steps, the wheel
//! turns on the way or, where there is no room for that, at a standstill.
//!
//! # Why a path is not yet a drive
//!
//! Hybrid A* joins arcs of constant curvature. Where one ends the steering angle φ would have to jump, which no wheel
//! does: the car either stops there or leaves the path. A trajectory here is a list of times, poses, speeds and
//! steering angles for which
//!
//! ```text
//! |v| ≤ v_max    −b ≤ d|v|/dt ≤ a    |φ| ≤ φ_max    |dφ/dt| ≤ ω_max    v²·|κ| ≤ a_lat
//! ```
//!
//! hold, and whose poses are those of the kinematic bicycle under these controls. It starts and ends at rest with
//! straight wheels.
//!
//! # Why in two stages
//!
//! Time along a given path is a solved problem: a forward and a backward pass give the fastest speeds exactly. The
//! shape is not convex, because every obstacle can be passed on two sides. So the shape is improved from the plan's, by
//! Gauss–Newton steps over nodes in the *distance*, and obstacles keep the side that the search has chosen. Nodes in
//! distance have one advantage over nodes in time: a node stays at its place while speeds change.
//!
//! # What a caller may rely on
//!
//! There is always an answer: the worst is the plan's own path with standstills, if the route takes no longer than an
//! hour. No answer takes longer than that one. [`Optimised::check`] is the referee's verdict on the states as they are
//! answered, and it may be that they do not pass. Equal input gives equal bytes; work is bounded by counts of steps,
//! not by time.

mod banded;
mod encounter;
mod features;
mod path;
mod path_in_time;
mod path_stage;
mod plan_path;
mod roll_out;
mod round;
mod segment;

pub use encounter::stop_wait_go;
pub use plan_path::stop_and_steer;

use crate::drive::{Limits, Motion, Route, Steps};
use crate::error::{Error, ErrorCode};
use crate::geometry::{Pose, math};
use crate::json;
use crate::metrics::Body;
use crate::referee::{Judgement, MAX_DURATION, MotionLimits, States, check};
use crate::scenario::resolve::Geometry;
use crate::vehicle::Vehicle;
use features::Features;
use path::Path;
use path_stage::PathStage;
use plan_path::PlanPath;
use roll_out::{OFF, Rows};
use round::{Car, Task};
use segment::HEADING;

/// The path keeps this much less than the largest steering angle (radians) and steering rate (share), so that the last
/// correction stays within them.
const ANGLE_RESERVE: f64 = 0.002;
const RATE_RESERVE: f64 = 0.01;
/// More than the body's corners leave a straight line between two samples, metres.
const BETWEEN: f64 = 0.003;
/// A trajectory that takes less than this share of stop-and-steer's time, and no longer than a slow drive along the
/// plan's own path, is the answer without further attempts.
const QUICK: f64 = 0.75;
/// Added to the margin, attempt by attempt, from the plan's own path: clearance is no hard limit in the path stage,
/// metres.
const AGAIN: [(f64, f64); 5] = [(0.0, 0.5), (0.004, 0.5), (0.01, 0.5), (0.0, 0.25), (0.0, 1.0)];

/// A path whose end is off the goal has not converged: it is optimised on so many times.
const ON: usize = 2;
/// Options of an optimisation.
///
/// Metres, seconds and radians. The steering angle's limit is the vehicle's.
#[derive(Debug, Clone, PartialEq)]
pub struct Options {
    /// Limits of the car.
    pub limits: MotionLimits,
    /// Kept from obstacles where the plan keeps as much, metres, 0 to 10.
    pub margin: f64,
}

impl Default for Options {
    fn default() -> Self {
        Self { limits: MotionLimits::default(), margin: 0.05 }
    }
}

json::settings! {
    Options:
    "speed" = limits.speed,
    "acceleration" = limits.acceleration,
    "deceleration" = limits.deceleration,
    "steeringRate" = limits.steering_rate,
    "lateralAcceleration" = limits.lateral_acceleration,
    "margin" = margin,
}

impl Options {
    /// Checks every option.
    ///
    /// # Errors
    /// [`ErrorCode::Config`] with the field and the rule.
    pub fn validate(&self) -> Result<(), Error> {
        self.limits.validate()?;
        if (0.0..=10.0).contains(&self.margin) {
            return Ok(());
        }
        let message = message!("must be between 0 and 10, got {}", self.margin);
        Err(Error::new(ErrorCode::Config, "margin", message))
    }
}

/// The stage that made a trajectory.
///
/// In the order of preference.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Stage {
    /// The optimised path.
    Optimised,
    /// The plan's own path; where its curvature steps, the wheel turns on the way.
    ContinuousCurvature,
    /// The plan's own path, with a standstill at steps of the curvature.
    StopAndSteer,
}

impl Stage {
    /// The stage as the JS API spells it.
    pub const fn as_str(self) -> &'static str {
        match self {
            Self::Optimised => "optimised",
            Self::ContinuousCurvature => "continuous-curvature",
            Self::StopAndSteer => "stop-and-steer",
        }
    }
}

/// A trajectory and the referee's verdict on it.
///
/// The states are in the world frame, as the route is.
#[derive(Debug, Clone)]
pub struct Optimised {
    /// Its states; the controls are constant between rows, which are at most 0.05 s apart.
    pub states: States,
    /// The stage that made it.
    pub stage: Stage,
    /// The referee's verdict.
    pub check: Judgement,
    /// Steps of the optimiser, of all attempts.
    pub steps: u32,
}

/// One way to try it: metres kept from obstacles, and whether no run may vanish.
type Attempt = (f64, bool);

/// Optimises a route that leads from the scene's start to its goal and keeps `clearance` metres from everything. The
/// lowest of the speed limits on the route holds for all of it.
///
/// # Errors
/// As [`Options::validate`]; [`ErrorCode::Input`] for a route that takes more than an hour.
///
/// # Examples
/// ```
/// use parkade::drive::Route;
/// use parkade::optimise::{Options, Stage, optimise};
/// use parkade::plan::Planner;
///
/// let scene = parkade::scenario::catalog::scenario("reverse-in").unwrap();
/// let mut planner = Planner::new("hybrid", &scene, &Default::default()).unwrap();
/// let plan = planner.plan(Default::default());
/// let car = &planner.geometry().vehicle;
/// let route = Route::new(car, &plan.path, &plan.directions, Some(&plan.curvatures)).unwrap();
/// let clearance = plan.metrics.min_clearance;
/// let driven = optimise(planner.geometry(), &route, clearance, &Options::default()).unwrap();
/// assert_eq!(driven.stage, Stage::Optimised);
/// assert!(driven.check.passes() && driven.states.duration() < 14.5);
/// ```
pub fn optimise(
    geometry: &Geometry,
    route: &Route,
    clearance: f64,
    options: &Options,
) -> Result<Optimised, Error> {
    options.validate()?;
    let speed = options.limits.speed.min(route.lowest_limit());
    let limits = &MotionLimits { speed, ..options.limits.clone() };
    let plain = plain(geometry, route, limits)?;
    let kept = options.margin.min(clearance.max(0.0));
    // Numbers near 0: floors may be 1e9 m from the origin.
    let features = Features::new(geometry, route.pose(0.0).point());
    let mut trials = Trials {
        geometry,
        body: Body::new(geometry),
        features,
        route,
        limits,
        most: plain.duration(),
        steps: 0,
        near: None,
    };
    let smooth = Path::new(&geometry.vehicle, route);
    let mut first =
        [(kept, false), (kept, true)].into_iter().find_map(|how| trials.attempt(how, smooth.clone()));
    let optimised =
        |(states, check): Trial, steps| Optimised { states, stage: Stage::Optimised, check, steps };
    let slow = slow_duration(&geometry.vehicle, route, limits);
    let enough = slow.min(QUICK * plain.duration());
    if let Some(first) = first.take_if(|(states, _)| states.duration() < enough) {
        return Ok(optimised(first, trials.steps));
    }
    let own = PlanPath::quick(geometry, &trials.body, route, limits);
    let states = own.states();
    trials.most = states.duration();
    let first = first.filter(|(states, _)| states.duration() <= trials.most);
    let again = trials.again(first, &own, kept, slow);
    let most = trials.most;
    let near = trials.near.take().filter(|(states, _)| states.duration() <= most);
    if let Some(best) = again.or(near) {
        return Ok(optimised(best, trials.steps));
    }
    Ok(Optimised { steps: trials.steps, ..judged(geometry, &trials.body, limits, (own, states), plain) })
}

/// What `optimise` falls back to: the plan's own path, the wheel turning on the way where the referee allows it.
///
/// Takes as long as a few checks by the referee, without an optimisation.
///
/// # Errors
/// As [`optimise`].
pub fn fallback(geometry: &Geometry, route: &Route, limits: &MotionLimits) -> Result<Optimised, Error> {
    limits.validate()?;
    let plain = plain(geometry, route, limits)?;
    let body = Body::new(geometry);
    let own = PlanPath::quick(geometry, &body, route, limits);
    let states = own.states();
    Ok(judged(geometry, &body, limits, (own, states), plain))
}

/// The plan's own path with ramps or, where the referee refuses that, with standstills.
fn judged(
    geometry: &Geometry,
    body: &Body,
    limits: &MotionLimits,
    (own, states): (PlanPath, States),
    plain: States,
) -> Optimised {
    let found = check(geometry, body, &states, limits);
    if found.passes() {
        let stage = if own.is_continuous() { Stage::ContinuousCurvature } else { Stage::StopAndSteer };
        return Optimised { states, stage, check: found, steps: 0 };
    }
    let check = check(geometry, body, &plain, limits);
    Optimised { states: plain, stage: Stage::StopAndSteer, check, steps: 0 }
}

/// Stop-and-steer, unless that takes too long.
///
/// # Errors
/// Where it takes longer than an hour.
fn plain(geometry: &Geometry, route: &Route, limits: &MotionLimits) -> Result<States, Error> {
    let shortest = route.length() / limits.speed;
    if shortest > MAX_DURATION {
        return Err(too_long(shortest));
    }
    let plain = stop_and_steer(&geometry.vehicle, route, limits);
    if plain.duration() > MAX_DURATION { Err(too_long(plain.duration())) } else { Ok(plain) }
}

/// Seconds of a drive with [`Steps::Slow`] along a route within the same limits, the steering rate too; infinite where
/// there is none. The wheel stays as it is at the goal, and the car may stray by centimetres.
pub fn slow_duration(vehicle: &Vehicle, route: &Route, limits: &MotionLimits) -> f64 {
    let vehicle = Vehicle { max_steer_rate: limits.steering_rate_of(vehicle), ..*vehicle };
    let limits = Limits {
        speed: limits.speed,
        acceleration: limits.acceleration,
        deceleration: limits.deceleration,
        lateral_acceleration: limits.lateral_acceleration.unwrap_or(100.0),
        steps: Steps::Slow,
        ..Limits::default()
    };
    Motion::new(&vehicle, route, &limits).map_or(f64::INFINITY, |motion| motion.duration())
}

/// States that the referee lets pass, and its verdict.
type Trial = (States, Judgement);

/// Attempts at one route.
///
/// They share what depends on the scene alone: features for the optimiser and outlines for the referee.
struct Trials<'a> {
    geometry: &'a Geometry,
    body: Body,
    features: Features,
    route: &'a Route,
    limits: &'a MotionLimits,
    /// No trajectory may take longer, seconds.
    most: f64,
    steps: u32,
    /// What passes the referee, but ends farther off the goal than the others.
    near: Option<Trial>,
}

impl Trials<'_> {
    /// Optimises a first guess; `None` where the referee refuses what comes of it. A path that does not end at the goal
    /// is optimised on.
    fn attempt(&mut self, how: Attempt, mut path: Path) -> Option<Trial> {
        let task = task(self.geometry, self.limits, &self.features, how);
        for _ in 0..=ON {
            self.steps += PathStage::new(&task).run(&mut path);
            if let Some(states) = rolled_out(&task, self.route, &path, self.most) {
                let found = check(self.geometry, &self.body, &states, self.limits);
                let (x, y, heading) = found.end_error;
                let is_off = [x, y, heading].iter().any(|error| error.abs() > OFF);
                match found.passes() {
                    true if !is_off => return Some((states, found)),
                    true => self.near = Some((states, found)),
                    false if found.attained => return None,
                    false => {}
                }
            }
        }
        None
    }

    /// The fastest of a first trial and others from the plan's own path, until one takes no longer than `enough`
    /// seconds.
    fn again(&mut self, first: Option<Trial>, own: &PlanPath, kept: f64, enough: f64) -> Option<Trial> {
        let mut found: Vec<Trial> = first.into_iter().collect();
        for (more, speed) in AGAIN {
            let next = self.attempt((kept + more, true), own.path(speed));
            let is_enough = next.as_ref().is_some_and(|(states, _)| states.duration() <= enough);
            found.extend(next);
            if is_enough {
                break;
            }
        }
        found.into_iter().min_by(|a, b| a.0.duration().total_cmp(&b.0.duration()))
    }
}

fn too_long(duration: f64) -> Error {
    let message = message!(
        "must be driven within {} s, takes {} s with a stop at each step of the curvature",
        MAX_DURATION,
        format_args!("{duration:.0}")
    );
    Error::new(ErrorCode::Input, "path", message)
}

/// The car's limits for the path stage, less the reserve for the last correction.
fn task<'a>(
    geometry: &'a Geometry,
    limits: &'a MotionLimits,
    features: &'a Features,
    (margin, keeps_runs): Attempt,
) -> Task<'a> {
    let vehicle = &geometry.vehicle;
    let car = Car {
        vehicle,
        limits,
        max_angle: (vehicle.max_steer - ANGLE_RESERVE).max(vehicle.max_steer / 2.0),
        max_rate: limits.steering_rate_of(vehicle) * (1.0 - RATE_RESERVE),
    };
    Task { car, features, margin: margin + BETWEEN, keeps_runs }
}

/// The states of an optimised path; `None` where they do not end at the goal or take longer than `most` seconds.
fn rolled_out(task: &Task, route: &Route, path: &Path, most: f64) -> Option<States> {
    let (start, end) = (route.pose(0.0), route.pose(route.length()));
    // The route's last heading is wrapped, the path's is not.
    let turn = path.nodes[path.nodes.len() - 1][HEADING] - end.heading;
    let heading = end.heading + (turn / math::TAU).round() * math::TAU;
    let goal = Pose::new(end.x - start.x, end.y - start.y, heading);
    let mut rows = Rows::new(most, 0.0);
    rows.along(path, &task.car);
    rows.turn(0.0, task.car.max_rate);
    rows.states(start, goal, &task.car)
}

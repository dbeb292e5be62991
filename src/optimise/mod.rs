//! From a plan to a trajectory that a car can follow to the centimetre: the steering angle is continuous, its rate and
//! all other limits are kept, and the time is nearly the least.
//!
//! The path stage changes the path's shape, gear changes included. Then the fastest speeds along it are found exactly,
//! rows are rolled out in time, and the last millimetres to the goal are corrected. The referee's check has the last
//! word: where it refuses every attempt, the plan's own path is driven with a standstill at each step of the curvature.

mod banded;
mod features;
mod path;
mod path_stage;
mod roll_out;
mod round;
mod segment;
mod stop_and_steer;

pub use stop_and_steer::stop_and_steer;

use crate::drive::Route;
use crate::error::{Error, ErrorCode};
use crate::geometry::{Pose, math};
use crate::json;
use crate::metrics::Body;
use crate::referee::{Judgement, MAX_DURATION, MotionLimits, States, check};
use crate::scenario::resolve::Geometry;
use features::Features;
use path::Path;
use path_stage::PathStage;
use round::Task;
use segment::HEADING;

/// The path keeps this much less than the largest steering angle (radians) and steering rate (share), so that the last
/// correction stays within them.
const ANGLE_RESERVE: f64 = 0.002;
const RATE_RESERVE: f64 = 0.01;
/// More than the body's corners leave a straight line between two samples, metres.
const BETWEEN: f64 = 0.003;

/// Options of an optimisation.
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
        let message = format!("must be between 0 and 10, got {}", self.margin);
        Err(Error::new(ErrorCode::Config, "margin", message))
    }
}

/// The stage that made a trajectory.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Stage {
    /// The optimised path.
    Optimised,
    /// The plan's own path, with a standstill at each step of the curvature.
    StopAndSteer,
}

impl Stage {
    /// The stage as the JS API spells it.
    pub const fn as_str(self) -> &'static str {
        match self {
            Self::Optimised => "optimised",
            Self::StopAndSteer => "stop-and-steer",
        }
    }
}

/// A trajectory and the referee's verdict on it.
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
    let shortest = route.length() / limits.speed;
    if shortest > MAX_DURATION {
        return Err(too_long(shortest));
    }
    let plain = stop_and_steer(&geometry.vehicle, route, limits);
    if plain.duration() > MAX_DURATION {
        return Err(too_long(plain.duration()));
    }
    let body = Body::new(geometry);
    let kept = options.margin.min(clearance.max(0.0));
    let attempts: [Attempt; 3] = [(kept, false), (kept, true), (kept / 2.0, true)];
    // Numbers near 0: floors may be 1e9 m from the origin.
    let features = Features::new(geometry, route.pose(0.0).point());
    let first = Path::new(&geometry.vehicle, route);
    let mut steps = 0;
    for attempt in attempts {
        let task = task(geometry, limits, &features, attempt);
        let Some(states) = attempted(&task, route, first.clone(), plain.duration(), &mut steps) else {
            continue;
        };
        let check = check(geometry, &body, &states, limits);
        if check.passes() {
            return Ok(Optimised { states, stage: Stage::Optimised, check, steps });
        }
    }
    let check = check(geometry, &body, &plain, limits);
    Ok(Optimised { states: plain, stage: Stage::StopAndSteer, check, steps })
}

fn too_long(duration: f64) -> Error {
    let message = format!(
        "must be driven within {MAX_DURATION} s, takes {duration:.0} s with a stop at each step of the curvature"
    );
    Error::new(ErrorCode::Input, "path", message)
}

fn task<'a>(
    geometry: &'a Geometry,
    limits: &'a MotionLimits,
    features: &'a Features,
    (margin, keeps_runs): Attempt,
) -> Task<'a> {
    let vehicle = &geometry.vehicle;
    Task {
        vehicle,
        limits,
        features,
        margin: margin + BETWEEN,
        max_angle: (vehicle.max_steer - ANGLE_RESERVE).max(vehicle.max_steer / 2.0),
        max_rate: limits.steering_rate_of(vehicle) * (1.0 - RATE_RESERVE),
        keeps_runs,
    }
}

/// The states of an optimised path; `None` where they do not end at the goal or take longer than `most` seconds.
fn attempted(task: &Task, route: &Route, mut path: Path, most: f64, steps: &mut u32) -> Option<States> {
    let (start, end) = (route.pose(0.0), route.pose(route.length()));
    // The route's last heading is wrapped, the path's is not.
    let turn = path.nodes[path.nodes.len() - 1][HEADING] - end.heading;
    let heading = end.heading + (turn / math::TAU).round() * math::TAU;
    let goal = Pose::new(end.x - start.x, end.y - start.y, heading);
    *steps += PathStage::new(task).run(&mut path);
    roll_out::rows(&path, task, most).states(start, goal, task.vehicle.wheelbase, task.vehicle.max_steer)
}

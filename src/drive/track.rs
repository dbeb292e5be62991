//! A simulated car follows a route in closed loop: how far a real one would stray.
//!
//! A kinematic bicycle whose wheel turns at a limited rate, driven at the trajectory's speeds, so that only steering is
//! judged.
//!
//! The same feedback law as [`crate::referee::track`], plus a preview of half the wheel's time from straight to full
//! lock, because the curvature of a route steps. Errors are measured to the nearest point of the current run: lateral
//! positive to the left of the route, heading positive where the car points farther to the left.

use super::limits::Limits;
use super::path_segments::{Route, Run};
use super::speed_profile::{Motion, angle, preview};
use super::trajectory::hash;
use crate::error::Error;
use crate::geometry::{Point, Pose, math};
use crate::json;
use crate::metrics::Body;
use crate::scenario::resolve::Owner;
use crate::vehicle::Vehicle;

/// Time step, seconds.
const STEP: f64 = 0.005;
/// Largest errors of a passed run: lateral (m), distance at the end (m), heading at the end (rad).
const PASS: [f64; 3] = [0.10, 0.10, 0.05];
/// Every so many steps a row is kept.
const KEPT: u32 = 10;

/// Gain of Stanley's rule, 1/s: more makes wheels of limited rate swing.
const STANLEY: f64 = 1.5;

/// The steering controller.
///
/// Pure pursuit steers along the circle through a point ahead, κ = 2·y/d² with its lateral offset y and distance d in
/// the car's frame. Looking ahead makes it cut corners; Stanley's rule corrects at the axle that leads. Both are there
/// to compare.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Controller {
    /// Curvature ahead, corrected by heading and lateral error.
    #[default]
    Feedback,
    /// Heads for the point max(1.5 m, 1 s) ahead on the route.
    PurePursuit,
    /// Lateral error of the leading axle, by the arc tangent of its ratio to the speed (Stanley).
    Stanley,
}

json::words!(Controller: "feedback" = Feedback, "pure-pursuit" = PurePursuit, "stanley" = Stanley);

/// How well a car followed.
///
/// Columns have one item per kept row (every 50 ms of motion); the largest errors count every step.
#[derive(Debug, Clone, Default)]
pub struct Tracking {
    /// Seconds, one per row.
    pub t: Vec<f64>,
    /// Poses of the simulated car, one per output step.
    pub poses: Vec<Pose>,
    /// How far to the left of the route, metres.
    pub lateral: Vec<f64>,
    /// Wheel angle, radians.
    pub steering: Vec<f64>,
    /// Largest |lateral error|, metres.
    pub max_lateral: f64,
    /// Largest |heading error|, radians.
    pub max_heading: f64,
    /// Between the last pose and the route's end, metres.
    pub end_distance: f64,
    /// Between the last heading and the route's, radians.
    pub end_heading: f64,
    /// The first obstacle that the body overlapped, and the pose there.
    pub hit: Option<(Owner, Pose)>,
}

impl Tracking {
    /// FNV-1a-64 over all columns, as 16 hex digits: equal on every platform.
    pub fn hash(&self) -> String {
        let poses = self.poses.iter().flat_map(|p| [p.x, p.y, p.heading]);
        hash(poses.chain([&self.t, &self.lateral, &self.steering].into_iter().flatten().copied()))
    }

    /// True if the route was followed: at most 0.10 m to the side, 0.10 m and 0.05 rad off at the end, no hit.
    pub fn passes(&self) -> bool {
        let worst = [self.max_lateral, self.end_distance, self.end_heading];
        self.hit.is_none() && worst.iter().zip(PASS).all(|(got, most)| *got <= most)
    }
}

struct Car {
    pose: Pose,
    steering: f64,
    /// Of the nearest point of the route.
    station: f64,
}

/// Errors to the nearest point of a run.
struct Errors {
    lateral: f64,
    heading: f64,
}

/// Lets a car follow `route` at the speeds of `limits`, the wheel straight at first; `body` tells what it hits.
///
/// # Errors
/// As [`Limits::validate`].
pub fn track(
    vehicle: &Vehicle,
    body: &Body,
    route: &Route,
    limits: &Limits,
    controller: Controller,
) -> Result<Tracking, Error> {
    let motion = Motion::new(vehicle, route, limits)?;
    let mut log = Tracking::default();
    simulate(vehicle, route, &motion, controller, |car, now| match now {
        Event::Step { t, errors, index, is_last } => {
            log.max_lateral = log.max_lateral.max(errors.lateral.abs());
            if !is_last {
                log.max_heading = log.max_heading.max(errors.heading.abs());
            }
            if index % KEPT == 0 {
                log.t.push(t);
                log.poses.push(car.pose);
                log.lateral.push(errors.lateral);
                log.steering.push(car.steering);
            }
            if is_last {
                let goal = route.pose(route.length());
                log.end_distance = (car.pose.point() - goal.point()).norm();
                log.end_heading = math::turn(goal.heading, car.pose.heading).abs();
            }
        }
        Event::Moved => {
            if log.hit.is_none() {
                log.hit = body.hit(car.pose).map(|owner| (owner, car.pose));
            }
        }
    });
    Ok(log)
}

/// A drive of the simulated car, every few milliseconds.
#[derive(Debug, Default)]
pub(crate) struct Followed {
    /// Seconds.
    pub(crate) t: Vec<f64>,
    pub(crate) poses: Vec<Pose>,
    /// m/s, negative in reverse.
    pub(crate) speed: Vec<f64>,
    /// Radians.
    pub(crate) steering: Vec<f64>,
}

/// Lets a car follow `route` at the speeds of a motion, by feedback.
pub(crate) fn follow(vehicle: &Vehicle, route: &Route, motion: &Motion) -> Followed {
    let mut log = Followed::default();
    simulate(vehicle, route, motion, Controller::Feedback, |car, now| {
        let Event::Step { t, .. } = now else { return };
        if log.t.last().is_some_and(|last| t <= *last) {
            return;
        }
        let after = motion.phases.partition_point(|p| p.time <= t).max(1) - 1;
        let gear = motion.phases.get(after).map_or(1.0, |p| route.runs[p.run].gear);
        log.t.push(t);
        log.poses.push(car.pose);
        log.speed.push(gear * motion.at(t).1 + 0.0);
        log.steering.push(car.steering);
    });
    log
}

/// An event of the simulation.
enum Event {
    /// A time step begins, the `index`-th of its run's motion or standstill, or the drive is over (`is_last`).
    Step { t: f64, errors: Errors, index: u32, is_last: bool },
    /// The car has moved on.
    Moved,
}

/// A closed-loop drive, the wheel straight at first.
fn simulate(
    vehicle: &Vehicle,
    route: &Route,
    motion: &Motion,
    controller: Controller,
    mut each: impl FnMut(&Car, Event),
) {
    let mut car = Car { pose: route.pose(0.0), steering: 0.0, station: 0.0 };
    let mut standing = 0.0;
    for (run, &(from, to)) in route.runs.iter().zip(&motion.runs) {
        car.station = run.from;
        for (from, to) in [(standing, from), (from, to)] {
            let count = steps(to - from);
            let at = |k: u32| from + (to - from) * f64::from(k) / f64::from(count);
            for index in 0..count {
                let (t, dt) = (at(index), at(index + 1) - at(index));
                let errors = nearest(route, run, &mut car);
                let (station, speed, _) = motion.at(t);
                let driven = (motion.at(at(index + 1)).0 - station).max(0.0);
                let wanted = command(vehicle, route, run, &car, &errors, speed, controller);
                each(&car, Event::Step { t, errors, index, is_last: false });
                let before = car.steering;
                let most = vehicle.max_steer_rate * dt;
                car.steering +=
                    (wanted.clamp(-vehicle.max_steer, vehicle.max_steer) - before).clamp(-most, most);
                let curvature = math::tan(f64::midpoint(before, car.steering)) / vehicle.wheelbase;
                car.pose = car.pose.advance(curvature, run.gear * driven);
                if driven > 0.0 {
                    each(&car, Event::Moved);
                }
            }
        }
        standing = to;
    }
    let errors = match route.runs.last() {
        Some(run) => nearest(route, run, &mut car),
        None => Errors { lateral: 0.0, heading: 0.0 },
    };
    each(&car, Event::Step { t: motion.duration(), errors, index: 0, is_last: true });
}

/// How many steps of at most [`STEP`] seconds a time has.
fn steps(time: f64) -> u32 {
    (time / STEP - 1e-6).ceil().max(0.0) as u32
}

/// Moves the car's station on to the nearest point of the run, never back.
///
/// Four projections on the tangent are enough: at parking speeds the car moves by a centimetre in a step.
fn nearest(route: &Route, run: &Run, car: &mut Car) -> Errors {
    let mut pose = route.pose_in(run, car.station);
    for _ in 0..4 {
        let ahead = (car.pose.point() - pose.point()).dot(&pose.direction()) * run.gear;
        let station = (car.station + ahead).min(run.to).max(car.station);
        if station - car.station < 1e-9 {
            break;
        }
        car.station = station;
        pose = route.pose_in(run, station);
    }
    let local = pose.to_local(car.pose.point());
    Errors { lateral: local.y, heading: math::turn(pose.heading, car.pose.heading) }
}

/// The wheel angle that a controller asks for, radians.
fn command(
    vehicle: &Vehicle,
    route: &Route,
    run: &Run,
    car: &Car,
    errors: &Errors,
    speed: f64,
    controller: Controller,
) -> f64 {
    let ahead = route.curvature_in(run, (car.station + preview(vehicle) * speed).min(run.to));
    match controller {
        Controller::Feedback => {
            angle(vehicle, ahead - run.gear * 1.6 * errors.heading - 0.64 * errors.lateral)
        }
        Controller::PurePursuit => {
            let target = route.pose_in(run, car.station + speed.max(1.5));
            let local = car.pose.to_local(target.point());
            angle(vehicle, 2.0 * local.y / local.coords.norm_squared().max(0.01))
        }
        Controller::Stanley => {
            let least_speed = speed.max(0.3);
            if run.gear < 0.0 {
                return angle(vehicle, ahead) + errors.heading
                    - math::atan(STANLEY * errors.lateral / least_speed);
            }
            let pose = route.pose_in(run, car.station);
            let wheel = angle(vehicle, route.curvature_in(run, car.station));
            let axle = Point::new(vehicle.wheelbase, 0.0);
            let way = Pose { heading: pose.heading + wheel, ..pose };
            let off = car.pose.to_world(axle) - pose.to_world(axle);
            let lateral = way.direction().perp(&off);
            angle(vehicle, ahead) - errors.heading - math::atan(STANLEY * lateral / least_speed)
        }
    }
}

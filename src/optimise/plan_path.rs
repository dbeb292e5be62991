//! The plan's own path, driven as it is: where its curvature steps, the wheel turns on the way, along a short ramp, or
//! at a standstill.
//!
//! The fallback has to work for every plan, so it changes the path as little as possible. A ramp of length 2h replaces
//! the jump of the angle between two arcs: the wheel turns evenly while the car drives on, half before and half after
//! the jump. At the speed v and the wheel's rate ω it needs 2h = v·|Δφ|/ω, so ramps get short where the car is slow,
//! and at v = 0 they vanish: the wheel turns at standstill. The path with ramps leaves the plan's by some millimetres
//! to centimetres, which the referee checks run by run.

use super::path::{Link, Path};
use super::roll_out::Rows;
use super::round::Car;
use super::segment::{ANGLE, HEADING, Node, STEP, X, Y, drive};
use crate::drive::Route;
use crate::geometry::arcs::Arc;
use crate::geometry::{Pose, math};
use crate::metrics::Body;
use crate::referee::{MotionLimits, States, check};
use crate::scenario::resolve::Geometry;
use crate::vehicle::Vehicle;

/// Speeds at which the wheel turns on the way, m/s, the fastest first: the slower the car, the shorter the ramp and the
/// nearer to the plan's path. At 0 it stands.
const SPEEDS: [f64; 6] = [2.0, 1.0, 0.5, 0.25, 0.1, 0.0];
/// Ramps take so much of an arc at most, so that a part of it stays.
const SHARE: f64 = 0.98;
/// Distance of nodes, metres.
const SPACING: f64 = 0.25;
/// Shorter stretches are none, metres.
const NOTHING: f64 = 1e-12;
/// The states of a run end at its end when they are this near, metres.
const REACHED: f64 = 1e-5;

/// A stretch in one gear.
///
/// All arcs have the same sign of length. Headings go on from the run before.
struct Run {
    /// Relative to the start's place; the heading is not wrapped.
    from: Pose,
    arcs: Vec<Arc>,
}

impl Run {
    /// The pose where the run ends, relative to the start's place.
    fn end(&self) -> Pose {
        self.arcs.iter().fold(self.from, driven)
    }
}

/// The pose at the end of an arc; the heading is not wrapped.
fn driven(from: Pose, arc: &Arc) -> Pose {
    let heading = from.heading + arc.curvature * arc.length;
    Pose { heading, ..from.advance(arc.curvature, arc.length) }
}

/// The plan's path in runs, each driven at the fastest of [`SPEEDS`] that keeps it free.
///
/// `speeds` has the speed of each run's ramps, m/s; 0 where the wheel turns at standstill.
pub(super) struct PlanPath<'a> {
    car: Car<'a>,
    start: Pose,
    runs: Vec<Run>,
    speeds: Vec<f64>,
}

/// Drives the arcs of a route, each from rest to rest, and turns the wheel between them.
///
/// The slowest answer and the surest: it follows the plan exactly, so it is free wherever the plan is. It serves as the
/// bound that no other answer may exceed. The wheel is straight at both ends.
pub fn stop_and_steer(vehicle: &Vehicle, route: &Route, limits: &MotionLimits) -> States {
    PlanPath::new(vehicle, route, limits).states()
}

impl<'a> PlanPath<'a> {
    /// Every step of the curvature at a standstill.
    pub(super) fn new(vehicle: &'a Vehicle, route: &Route, limits: &'a MotionLimits) -> Self {
        let car =
            Car { vehicle, limits, max_angle: vehicle.max_steer, max_rate: limits.steering_rate_of(vehicle) };
        let mut runs: Vec<Run> = Vec::new();
        let mut at = Pose { x: 0.0, y: 0.0, ..route.pose(0.0) };
        for arc in route.arcs() {
            let from = at;
            at = driven(at, &arc);
            match runs.last_mut() {
                Some(run) if run.arcs[0].length.signum() == arc.length.signum() => run.arcs.push(arc),
                _ => runs.push(Run { from, arcs: vec![arc] }),
            }
        }
        let speeds = vec![0.0; runs.len()];
        Self { car, start: route.pose(0.0), runs, speeds }
    }

    /// The wheel turns on the way wherever the referee allows it.
    ///
    /// Each run is judged by itself, with a replay and a scan for each speed that is tried.
    pub(super) fn quick(
        geometry: &'a Geometry,
        body: &Body,
        route: &Route,
        limits: &'a MotionLimits,
    ) -> Self {
        let mut path = Self::new(&geometry.vehicle, route, limits);
        for i in 0..path.runs.len() {
            let is_free = |speed: f64| {
                let Some(states) = path.run_states(i, speed, 0.0) else { return false };
                let found = check(geometry, body, &states, limits);
                found.keeps_limits && found.contacts.are_none()
            };
            path.speeds[i] = SPEEDS.into_iter().find(|&speed| speed == 0.0 || is_free(speed)).unwrap_or(0.0);
        }
        path
    }

    /// True if the car never stands but at gear changes.
    pub(super) fn is_continuous(&self) -> bool {
        self.runs.iter().zip(&self.speeds).all(|(run, &speed)| run.arcs.len() < 2 || speed > 0.0)
    }

    /// Runs one after another, each beginning with the angle that the one before ends with; the wheel is straightened
    /// at last.
    pub(super) fn states(&self) -> States {
        let mut all = States::default();
        let mut angle = 0.0;
        for (i, &speed) in self.speeds.iter().enumerate() {
            let states = self.run_states(i, speed, angle).unwrap_or_default();
            let (offset, skip) = (all.duration(), usize::from(i > 0));
            for k in skip..states.t.len() {
                all.push(offset + states.t[k], states.poses[k], states.speed[k], states.steering[k]);
            }
            angle = all.steering.last().copied().unwrap_or(0.0);
        }
        let last = all.poses.last().copied().unwrap_or(self.start);
        let mut rows = Rows::new(f64::INFINITY, angle);
        rows.turn(0.0, self.car.max_rate);
        let turned = rows.plain(last, self.car.vehicle.wheelbase);
        let offset = all.duration();
        for k in usize::from(!all.t.is_empty())..turned.t.len() {
            all.push(offset + turned.t[k], last, 0.0, turned.steering[k]);
        }
        all
    }

    /// The states of a run from rest with the wheel at an angle; `None` where they do not end where the run does.
    fn run_states(&self, i: usize, speed: f64, angle: f64) -> Option<States> {
        let run = &self.runs[i];
        let mut rows = Rows::new(f64::INFINITY, angle);
        rows.along(&self.path_of(run, speed), &self.car);
        let wheelbase = self.car.vehicle.wheelbase;
        let start = Pose { x: self.start.x + run.from.x, y: self.start.y + run.from.y, ..run.from };
        if speed == 0.0 {
            return Some(rows.plain(start, wheelbase));
        }
        let end = run.end();
        let goal = Pose { x: end.x - run.from.x, y: end.y - run.from.y, ..end };
        let states = rows.states(start, goal, &self.car)?;
        let last = states.poses[states.poses.len() - 1];
        let off = math::hypot(last.x - start.x - goal.x, last.y - start.y - goal.y);
        (off < REACHED && (last.heading - goal.heading).abs() < REACHED).then_some(states)
    }

    /// The whole path as a first guess: start, runs and goal, with standstills between them. Runs in which the car
    /// stands are ramped for a speed.
    pub(super) fn path(&self, least: f64) -> Path {
        let mut path = Path { nodes: vec![[0.0, 0.0, self.start.heading, 0.0, 0.0]], links: Vec::new() };
        let mut end = Pose { x: 0.0, y: 0.0, ..self.start };
        for (run, &speed) in self.runs.iter().zip(&self.speeds) {
            let part = self.path_of(run, speed.max(least));
            path.links.push(Link::Turn);
            path.nodes.extend(part.nodes);
            path.links.extend(part.links);
            end = run.end();
        }
        path.links.push(Link::Turn);
        path.nodes.push([end.x, end.y, end.heading, 0.0, 0.0]);
        path
    }

    /// Nodes along a run.
    fn path_of(&self, run: &Run, speed: f64) -> Path {
        let angles: Vec<f64> =
            run.arcs.iter().map(|arc| math::atan(self.car.vehicle.wheelbase * arc.curvature)).collect();
        let halves = self.halves(run, &angles, speed);
        let Pose { x, y, heading } = run.from;
        let mut path = Path { nodes: vec![[x, y, heading, angles[0], 0.0]], links: Vec::new() };
        for (i, arc) in run.arcs.iter().enumerate() {
            let before = if i == 0 { 0.0 } else { halves[i - 1] };
            let after = halves.get(i).copied().unwrap_or(0.0);
            if i > 0 && before == 0.0 {
                let mut node = path.nodes[path.nodes.len() - 1];
                node[ANGLE] = angles[i];
                path.links.push(Link::Turn);
                path.nodes.push(node);
            }
            let gear = arc.length.signum();
            self.advance(&mut path, arc.length.abs() - before - after, angles[i], gear);
            if after > 0.0 {
                self.advance(&mut path, 2.0 * after, angles[i + 1], gear);
            }
        }
        path
    }

    /// Half the length of the ramp at each step of the curvature. A ramp takes at most half of an arc between two
    /// ramps, so neighbouring ramps never meet.
    fn halves(&self, run: &Run, angles: &[f64], speed: f64) -> Vec<f64> {
        let count = run.arcs.len();
        let room = |i: usize| {
            let is_inner = i > 0 && i + 1 < count;
            SHARE * run.arcs[i].length.abs() / if is_inner { 2.0 } else { 1.0 }
        };
        let steps = (1..count).map(|i| {
            let turn = (angles[i] - angles[i - 1]).abs();
            (speed * turn / self.car.max_rate / 2.0).min(room(i - 1)).min(room(i))
        });
        steps.collect()
    }

    /// Drives on from the last node while the wheel turns evenly to an angle.
    fn advance(&self, path: &mut Path, length: f64, angle: f64, gear: f64) {
        if length < NOTHING {
            return;
        }
        // From rest to rest a speed is reached somewhere.
        let parts = (length / SPACING).ceil().max(4.0);
        let from = path.nodes[path.nodes.len() - 1][ANGLE];
        for part in 1..=parts as u32 {
            let share = f64::from(part) / parts;
            let angle = if share == 1.0 { angle } else { from + (angle - from) * share };
            let last = path.nodes.len() - 1;
            let node: &mut Node = &mut path.nodes[last];
            node[STEP] = length / parts;
            let end = drive(node, angle, gear, self.car.vehicle.wheelbase).pose;
            path.links.push(Link::Drive(gear));
            path.nodes.push([end[X], end[Y], end[HEADING], angle, 0.0]);
        }
    }
}

//! Lots to park in and a checker that shares nothing with the planner.

use std::f64::consts::PI;

use parkade::geometry::arcs::{self, Arc};
use parkade::geometry::{Point, Pose, math};
use parkade::planners::hybrid::{Config, Query, Report, Scratch, plan};
use parkade::scenario::{Goal, catalog};
use parkade::vehicle::Vehicle;
use parkade::vehicle::collision::{CollisionChecker, Obstacles, Solid};

pub(crate) const CAR: Vehicle = Vehicle::PAPER;
pub(crate) const BORDER: u32 = 0;

/// A floor, what stands on it, and a question.
#[derive(Clone)]
pub(crate) struct Lot {
    pub(crate) floor: Vec<[f64; 2]>,
    pub(crate) solids: Vec<Vec<[f64; 2]>>,
    pub(crate) start: [f64; 3],
    pub(crate) goal: [f64; 3],
}

pub(crate) fn pose([x, y, heading]: [f64; 3]) -> Pose {
    Pose::new(x, y, heading)
}

impl Lot {
    /// A scene of the catalogue in the paper's lot.
    pub(crate) fn of(id: &str) -> Self {
        let scene = catalog::scenario(id).expect("a scene of the catalogue");
        let Goal::Pose(goal) = scene.goal else { panic!("{id} has no pose as its goal") };
        let numbers = |pose: Pose| [pose.x, pose.y, pose.heading];
        let floor = scene.map.boundary.expect("the paper's lot has a boundary");
        Self { floor, solids: Vec::new(), start: numbers(scene.start), goal: numbers(goal) }
    }

    /// The same lot with another question.
    pub(crate) fn between(self, start: [f64; 3], goal: [f64; 3]) -> Self {
        Self { start, goal, ..self }
    }

    pub(crate) fn with(mut self, solid: &[[f64; 2]]) -> Self {
        self.solids.push(solid.to_vec());
        self
    }

    pub(crate) fn obstacles(&self) -> Obstacles {
        let point = |p: &[f64; 2]| Point::new(p[0], p[1]);
        let solid = |points: &[[f64; 2]], owner| Solid { outline: points.iter().map(point).collect(), owner };
        let solids: Vec<Solid> = (1..).zip(&self.solids).map(|(owner, s)| solid(s, owner)).collect();
        Obstacles::new(&[], &solids, &solid(&self.floor, BORDER))
    }

    pub(crate) fn plan(&self, config: &Config) -> Report {
        config.validate().unwrap();
        let obstacles = self.obstacles();
        let query =
            Query { obstacles: &obstacles, vehicle: &CAR, start: pose(self.start), goal: pose(self.goal) };
        plan(&query, config, &mut Scratch::default(), false, &mut None)
    }

    /// Plans and checks the path; its length and direction changes.
    pub(crate) fn solve(&self, name: &str, config: &Config) -> (f64, u32, Report) {
        let report = self.plan(config);
        assert!(report.status.is_found(), "{name}: {:?}", report.status);
        self.check(name, &report.arcs);
        let length = arcs::length(&report.arcs);
        assert!(length >= report.rs_bound - 1e-6, "{name}: {length} below {}", report.rs_bound);
        (length, arcs::direction_changes(&report.arcs), report)
    }

    /// Drives `path` in steps of 2 cm: ends at the goal, turns within the limit, touches nothing.
    pub(crate) fn check(&self, name: &str, path: &[Arc]) {
        self.check_every(name, path, 0.02);
    }

    /// Drives `path` in steps of so many metres.
    pub(crate) fn check_every(&self, name: &str, path: &[Arc], spacing: f64) {
        let mut at = self.start;
        assert_eq!(self.hit(at), None, "{name}: at the start");
        for arc in path {
            assert!(arc.curvature.abs() <= CAR.max_curvature() + 1e-9, "{name}: {arc:?}");
            let steps = (arc.length.abs() / spacing).ceil();
            let from = at;
            for k in 1..=steps as u32 {
                at = drive(from, arc.curvature, arc.length * f64::from(k) / steps);
                assert_eq!(self.hit(at), None, "{name}: at {at:?} on {arc:?}");
            }
        }
        let [x, y, heading] = self.goal;
        assert!(math::hypot(at[0] - x, at[1] - y) < 1e-6, "{name} ends at {at:?}");
        assert!(math::wrap(at[2] - heading).abs() < 1e-6, "{name} ends at {at:?}");
        assert_eq!(arcs::reversed(&arcs::reversed(path)), path, "{name}");
        let back = arcs::end(pose(self.goal), &arcs::reversed(path));
        assert!((back.point() - pose(self.start).point()).norm() < 1e-6, "{name} does not lead back");
    }

    /// The least distance from the car to anything along a path, 1 m at most.
    pub(crate) fn clearance(&self, path: &[Arc]) -> f64 {
        let obstacles = self.obstacles();
        let checker = CollisionChecker::new(&obstacles, &CAR);
        let points = arcs::sample(pose(self.start), path, pose(self.goal), 0.02);
        points.iter().fold(1.0, |least, p| checker.clearance(obstacles.local(p.pose), least).min(least))
    }

    /// True if the car overlaps a solid or an edge of the floor by more than a micrometre.
    pub(crate) fn hit(&self, at: [f64; 3]) -> Option<usize> {
        let body = body(at);
        let n = self.floor.len();
        let walls = (0..n).map(|i| vec![self.floor[i], self.floor[(i + 1) % n]]);
        let things: Vec<Vec<[f64; 2]>> = walls.chain(self.solids.iter().cloned()).collect();
        things.iter().position(|thing| overlap(&body, thing))
    }
}

/// Corners of the car.
fn body([x, y, heading]: [f64; 3]) -> [[f64; 2]; 4] {
    let (s, c) = (math::sin(heading), math::cos(heading));
    let side = CAR.width / 2.0;
    [
        (CAR.rear_to_front, side),
        (-CAR.rear_to_back, side),
        (-CAR.rear_to_back, -side),
        (CAR.rear_to_front, -side),
    ]
    .map(|(u, v)| [x + u * c - v * s, y + u * s + v * c])
}

/// Separating axes of two convex outlines; a segment is one of two corners.
fn overlap(a: &[[f64; 2]], b: &[[f64; 2]]) -> bool {
    let axes = |p: &[[f64; 2]]| -> Vec<[f64; 2]> {
        let edge = |i: usize| [p[(i + 1) % p.len()][0] - p[i][0], p[(i + 1) % p.len()][1] - p[i][1]];
        (0..p.len()).map(edge).map(|[dx, dy]| [-dy / math::hypot(dx, dy), dx / math::hypot(dx, dy)]).collect()
    };
    let range = |p: &[[f64; 2]], [nx, ny]: [f64; 2]| {
        let along = p.iter().map(|q| q[0] * nx + q[1] * ny);
        along.fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), v| (low.min(v), high.max(v)))
    };
    axes(a).into_iter().chain(axes(b)).all(|axis| {
        let ((a0, a1), (b0, b1)) = (range(a, axis), range(b, axis));
        a1.min(b1) - a0.max(b0) > 1e-6
    })
}

/// A pose after an arc, by the chord: another formula than the planner's.
fn drive([x, y, heading]: [f64; 3], curvature: f64, length: f64) -> [f64; 3] {
    let half = curvature * length / 2.0;
    let chord = if half.abs() < 1e-12 { length } else { length * math::sin(half) / half };
    [x + chord * math::cos(heading + half), y + chord * math::sin(heading + half), heading + 2.0 * half]
}

/// A number in [0, 1) and the next state.
pub(crate) fn random(state: &mut u64) -> f64 {
    *state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
    (*state >> 11) as f64 / (1_u64 << 53) as f64
}

/// A lot with boxes scattered over it.
pub(crate) fn random_scenes(seed: u64) -> Lot {
    let mut state = seed.wrapping_mul(0x9e37_79b9_7f4a_7c15);
    let mut between = |low: f64, high: f64| low + (high - low) * random(&mut state);
    let mut lot = Lot::of("P0");
    for _ in 0..6 {
        let (x, y, turn) = (between(-24.0, 24.0), between(8.0, 29.0), between(0.0, PI));
        let (a, b) = (between(0.3, 2.5), between(0.3, 1.5));
        let (s, c) = (math::sin(turn), math::cos(turn));
        let corner = |u: f64, v: f64| [x + u * c - v * s, y + u * s + v * c];
        lot.solids.push(vec![corner(-a, -b), corner(a, -b), corner(a, b), corner(-a, b)]);
    }
    let mut free = || loop {
        let at = [between(-23.0, 23.0), between(3.0, 28.0), between(-PI, PI)];
        if lot.hit(at).is_none() && at[1] > 6.0 + 4.0 * f64::from(at[0].abs() > 9.0) {
            return at;
        }
    };
    (lot.start, lot.goal) = (free(), free());
    lot
}

/// The rows of the paper's tables.
pub(crate) const ROWS: [&str; 10] = ["P0", "P1", "P2", "P3", "P4", "L0", "L1", "L2", "L3", "L4"];

//! Hybrid A* for parking: arcs on a lattice of poses, joined to the target by Reeds–Shepp curves.
//!
//! The tree grows from the goal by default (the parking paper's reverse search): the car model drives the same way
//! back, and leaving a slot needs far fewer expansions than finding it. Dolgov et al. 2010 for the search itself.

mod config;
mod cost;
mod domain;
mod flood;
mod keys;
mod passage;
mod shortcut;

pub use config::{Config, Heuristic, SearchFrom};
pub use passage::Gap;

use core::cell::RefCell;

use config::Level;
use cost::{CostModel, Motion};
use domain::{Lattice, Setting, State};
use flood::Flood;
use keys::Keys;

use crate::geometry::arcs::{self, Arc};
use crate::geometry::{Pose, math, reeds_shepp};
use crate::search::{End, Limits, NodeId, Observer, best_first};
use crate::vehicle::Vehicle;
use crate::vehicle::collision::{Obstacles, Probe};

/// Spacing of the last check of a path, metres.
const VERIFY: f64 = 0.02;
/// Expansions after which the estimate gets more weight.
const SOON: u32 = 1000;
/// Its weight then.
const PATIENCE: f64 = 1.3;
/// Arcs of the search tree that are kept for drawing.
const TREE: usize = 20_000;

/// A question to hybrid A*: poses in world coordinates.
#[derive(Debug, Clone, Copy)]
pub struct Query<'a> {
    /// Everything that blocks.
    pub obstacles: &'a Obstacles,
    /// The car.
    pub vehicle: &'a Vehicle,
    /// Where it stands.
    pub start: Pose,
    /// Where it shall go.
    pub goal: Pose,
}

/// How planning ended.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Status {
    /// There is a path, and nothing cheaper was left to try on its level.
    Found,
    /// There is a path, but the budget ended before it was proven the cheapest.
    Suboptimal,
    /// The body overlaps this owner's obstacle at the start.
    StartInCollision(u32),
    /// The body overlaps this owner's obstacle at the goal.
    GoalInCollision(u32),
    /// Some gap on every way is narrower than the car and its margin.
    Unreachable,
    /// A place on every way is narrower than the body; in world coordinates.
    TooNarrow(Gap),
    /// Every level was searched to its end.
    NoPath,
    /// The budget ended with this estimate still to go, metres.
    BudgetExhausted(f64),
    /// Every path found touches something between two checks.
    VerificationFailed,
}

/// The answer of hybrid A*.
#[derive(Debug, Clone)]
pub struct Report {
    /// How it ended.
    pub status: Status,
    /// The path from start to goal; empty where there is none, and where start and goal are one.
    pub arcs: Vec<Arc>,
    /// Its cost under the settings.
    pub cost: f64,
    /// Length of the shortest path without obstacles, metres.
    pub rs_bound: f64,
    /// Level of the resolution ladder that gave the path, or the last one tried.
    pub level: u32,
    /// The margin planned with, metres: less than asked where start or goal have less.
    pub margin: f64,
    /// Expansions, over all levels.
    pub expanded: u32,
    /// Distinct states met, over all levels.
    pub generated: u32,
    /// Insertions into the open list, over all levels.
    pub pushes: u32,
    /// Largest size of the open list.
    pub open_peak: u32,
    /// Poses tested for collision.
    pub collision_checks: u32,
    /// The expanded pose with the least estimate to go: how near the search came.
    pub closest: Option<Pose>,
    /// Arcs of the search tree as driven, in order of expansion: x, y, heading, curvature, signed length, ….
    pub tree: Vec<f32>,
    /// Tree arcs beyond the cap.
    pub tree_dropped: u64,
}

/// The memory of hybrid A*, reused between queries.
#[derive(Debug, Default)]
pub struct Scratch {
    search: crate::search::Scratch<f64, State>,
    keys: RefCell<Keys>,
}

/// Keeps the arcs that led to expanded states.
struct Tree {
    arcs: Vec<f32>,
    dropped: u64,
    origin: Pose,
    mirrored: bool,
}

impl Observer<f64, State> for Tree {
    fn expanded(&mut self, _: NodeId, at: State, _: f64) {
        if at.length == 0.0 {
            return;
        }
        if self.arcs.len() >= TREE * 5 {
            self.dropped += 1;
            return;
        }
        let (curvature, length) = (at.motion.curvature, at.length);
        let (from, length) =
            if self.mirrored { (at.pose, -length) } else { (at.pose.advance(curvature, -length), length) };
        let (x, y) = (from.x + self.origin.x, from.y + self.origin.y);
        self.arcs.extend([x, y, from.heading, curvature, length].map(|v| v as f32));
    }
}

/// Plans a path that the car can drive.
///
/// Levels of the resolution ladder are tried in order until one gives a path that survives verification at 0.02 m.
/// Deterministic: budgets count expansions and collision checks, never time. `trace` keeps the search tree.
///
/// # Examples
/// ```
/// use parkade::geometry::{Point, Pose};
/// use parkade::planners::hybrid::{Config, Query, Scratch, Status, plan};
/// use parkade::vehicle::Vehicle;
/// use parkade::vehicle::collision::{Obstacles, Solid};
///
/// let corners = [(0.0, 0.0), (40.0, 0.0), (40.0, 30.0), (0.0, 30.0)];
/// let floor = Solid { outline: corners.map(|(x, y)| Point::new(x, y)).to_vec(), owner: 0 };
/// let obstacles = Obstacles::new(&[], &[], &floor);
/// let query = Query {
///     obstacles: &obstacles,
///     vehicle: &Vehicle::SEDAN,
///     start: Pose::new(5.0, 5.0, 0.0),
///     goal: Pose::new(30.0, 20.0, 1.0),
/// };
/// let report = plan(&query, &Config::default(), &mut Scratch::default(), false);
/// assert_eq!(report.status, Status::Found);
/// ```
pub fn plan(query: &Query, config: &Config, scratch: &mut Scratch, trace: bool) -> Report {
    let local = |pose| query.obstacles.local(pose);
    let (start, goal) = (local(query.start), local(query.goal));
    let probe = Probe::new(query.obstacles, query.vehicle);
    let radius = query.vehicle.min_turning_radius();
    let mut report = empty(reeds_shepp::distance(start, goal, radius));
    let blocked = |pose: Pose| query.obstacles.inside(pose.point()).or_else(|| probe.hit(pose, 0.0));
    if let Some(owner) = blocked(start) {
        report.status = Status::StartInCollision(owner);
        return report;
    }
    if let Some(owner) = blocked(goal) {
        report.status = Status::GoalInCollision(owner);
        return report;
    }
    let clearance = probe.clearance(start, config.margin).min(probe.clearance(goal, config.margin));
    report.margin = config.margin.min(clearance);
    let apart = (goal.point() - start.point()).norm();
    if apart <= 1e-6 && math::turn(start.heading, goal.heading).abs() <= 1e-6 {
        report.status = Status::Found;
        return report;
    }
    let mirrored = config.search_from == SearchFrom::Goal;
    let (root, target) = if mirrored { (goal, start) } else { (start, goal) };
    let flood = Flood::new(query.obstacles, query.vehicle, target, report.margin);
    let search = Search { query, config, probe: &probe, flood: &flood, root, target, mirrored, start, goal };
    if flood.distance(root).is_infinite() {
        report.status = search.unreachable();
        return report;
    }
    search.climb(&mut report, scratch, trace);
    report.collision_checks = probe.checks();
    report
}

fn empty(rs_bound: f64) -> Report {
    Report {
        status: Status::NoPath,
        arcs: Vec::new(),
        cost: 0.0,
        rs_bound,
        level: 0,
        margin: 0.0,
        expanded: 0,
        generated: 0,
        pushes: 0,
        open_peak: 0,
        collision_checks: 0,
        closest: None,
        tree: Vec::new(),
        tree_dropped: 0,
    }
}

struct Search<'a> {
    query: &'a Query<'a>,
    config: &'a Config,
    probe: &'a Probe<'a>,
    flood: &'a Flood,
    root: Pose,
    target: Pose,
    mirrored: bool,
    start: Pose,
    goal: Pose,
}

impl Search<'_> {
    /// Why there is no way at all.
    fn unreachable(&self) -> Status {
        let gap = passage::too_narrow(self.query.obstacles, self.query.vehicle, self.start, self.goal);
        gap.map_or(Status::Unreachable, |gap| {
            let at = self.world(Pose::new(gap.at.x, gap.at.y, 0.0)).point();
            Status::TooNarrow(Gap { at, ..gap })
        })
    }

    /// Tries the levels in order until one gives a path.
    fn climb(&self, report: &mut Report, scratch: &mut Scratch, trace: bool) {
        for (number, level) in self.config.levels().enumerate() {
            report.level = number as u32;
            let patient = if number == 0 {
                let soon = Level { max_expansions: level.max_expansions.min(SOON), ..level };
                let found = self.level(soon, report, scratch, trace);
                let whole = soon.max_expansions == level.max_expansions;
                if found && (report.status == Status::Found || whole) {
                    return;
                }
                if whole || report.status == Status::NoPath {
                    continue;
                }
                // On long cluttered ways the plain estimate spends its budget on detours of equal promise.
                Level { weight: self.config.heuristic_weight.unwrap_or(PATIENCE), ..level }
            } else {
                level
            };
            if self.level(patient, report, scratch, trace) {
                return;
            }
        }
    }

    /// Searches one level, with finer collision checks where verification fails; tells whether there is a path.
    fn level(&self, level: Level, report: &mut Report, scratch: &mut Scratch, trace: bool) -> bool {
        for halvings in 0..3 {
            let level = Level { spacing: level.spacing / f64::from(1 << halvings), ..level };
            let Some((arcs, status)) = self.search(level, report, scratch, trace) else { return false };
            let arcs = self.improve(arcs, level, report.margin);
            if self.verified(&arcs) {
                let costs = CostModel::driven(self.config, self.query.vehicle.min_turning_radius());
                report.cost = costs.path(self.probe, self.start, Motion::default(), &arcs);
                report.arcs = arcs;
                report.status = status;
                return true;
            }
            report.status = Status::VerificationFailed;
        }
        false
    }

    fn search(
        &self,
        level: Level,
        report: &mut Report,
        scratch: &mut Scratch,
        trace: bool,
    ) -> Option<(Vec<Arc>, Status)> {
        let radius = self.query.vehicle.min_turning_radius();
        let driven = CostModel::driven(self.config, radius);
        let costs = if self.mirrored { driven.mirrored() } else { driven };
        let setting = Setting { probe: self.probe, flood: self.flood, keys: &scratch.keys, costs };
        let mut lattice =
            Lattice::new(setting, self.query.vehicle, self.config, level, self.target, report.margin);
        let limits = Limits { max_expansions: level.max_expansions, first: self.config.first_shot };
        let state = State { pose: self.root, ..State::default() };
        let root = (lattice.node(self.root, 0), state);
        let mut tree = trace.then(|| Tree {
            arcs: Vec::new(),
            dropped: 0,
            origin: self.origin(),
            mirrored: self.mirrored,
        });
        let found = best_first(&mut lattice, root, limits, &mut scratch.search, &mut tree);
        if let Some(tree) = tree {
            (report.tree, report.tree_dropped) = (tree.arcs, tree.dropped);
        }
        report.expanded += found.expanded;
        report.generated += found.generated;
        report.pushes += found.pushes;
        report.open_peak = report.open_peak.max(found.open_peak);
        let closest = scratch.search.label(found.closest.1).map(|s| s.pose);
        report.closest = closest.map(|p| self.world(p));
        let Some((last, _, tail)) = found.found else {
            report.status = match found.end {
                End::BudgetSpent => Status::BudgetExhausted(found.closest.0 / level.weight.max(1e-9)),
                _ => Status::NoPath,
            };
            return None;
        };
        let arcs = domain::path(&scratch.search.chain(last), &tail, radius);
        let arcs = if self.mirrored { arcs::reversed(&arcs) } else { arcs };
        let status = if found.end == End::BudgetSpent { Status::Suboptimal } else { Status::Found };
        Some((arcs, status))
    }

    fn improve(&self, arcs: Vec<Arc>, level: Level, margin: f64) -> Vec<Arc> {
        if !self.config.shortcut {
            return arcs;
        }
        let costs = CostModel::driven(self.config, self.query.vehicle.min_turning_radius());
        shortcut::shortcut(self.probe, &costs, self.start, arcs, level.spacing, margin)
    }

    /// Whether the path is free at the finest spacing and ends at the goal.
    fn verified(&self, arcs: &[Arc]) -> bool {
        let mut pose = self.start;
        let free = arcs.iter().all(|arc| {
            let free = self.probe.arc_free(pose, arc, VERIFY, 0.0);
            pose = pose.advance(arc.curvature, arc.length);
            free
        });
        let off = (pose.point() - self.goal.point()).norm();
        free && off < 1e-6 && math::turn(pose.heading, self.goal.heading).abs() < 1e-6
    }

    /// The world position of the local origin.
    fn origin(&self) -> Pose {
        let at = self.query.start.point() - self.start.point();
        Pose::new(at.x, at.y, 0.0)
    }

    fn world(&self, pose: Pose) -> Pose {
        let origin = self.origin();
        Pose::new(pose.x + origin.x, pose.y + origin.y, pose.heading)
    }
}

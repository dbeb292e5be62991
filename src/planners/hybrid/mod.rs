//! Hybrid A\* for parking: arcs on a lattice of poses, joined to the target by Reeds–Shepp curves.
//!
//! Grid search treats the car as a point; its paths have corners that no car can drive. Hybrid A\* searches over
//! poses (x, y, heading) and gears instead. A node's moves are *motion primitives*: arcs of a fixed length at some
//! steering angles, in both gears. A lattice cell of position, heading and gear keeps the cheapest real-valued pose
//! that reached it, so poses are not rounded and every path can be driven (Dolgov et al. 2010).
//!
//! Three things make that fast:
//!
//! * The *heuristic* is the larger of two: the Reeds–Shepp curve to the target, which knows the turning radius but
//!   no obstacles, and the way of a disc around obstacles, which knows obstacles but no turning radius.
//! * *Analytic expansion*: from many nodes, the fewer the farther away, a Reeds–Shepp curve to the target is tried.
//!   The first free one that no open node can beat ends the search exactly at the target pose.
//! * The tree grows *from the goal* by default (the parking paper's reverse search): the car model drives the same
//!   way back, and leaving a slot needs far fewer expansions than finding it.
//!
//! A cost in metres: length, times `reverseCost` in reverse, plus `directionChangeCost` a gear change, plus weights
//! of steering and of nearness to obstacles (`cost`). Where the coarse lattice finds nothing, a portfolio of finer
//! ones and of smaller margins takes turns (`portfolio`). "No path" with a proof and "budget spent" are told apart
//! ([`Status`]).

mod analytic_expansion;
mod anchor;
mod bidirectional;
mod bottleneck;
mod choices;
mod config;
mod cost;
mod descent;
mod domain;
mod flood;
mod flood_memory;
mod goals;
mod holonomic;
mod improvement;
mod lattices;
mod level;
mod longer_moves;
mod obstacle_heuristic;
mod obstruction;
mod portfolio;
mod pose_heuristic;
mod press;
mod profile;
mod question;
mod recording;
mod regain;
mod report;
mod rivals;

mod shortcut;
mod squeeze;
mod state;
mod state_index;
mod tree;
mod widest;

pub use analytic_expansion::FailedExpansions;
pub use anchor::{Last, stay};
pub use choices::{Prefer, choices};
pub use config::{Config, Heuristic, SearchFrom};
pub use flood_memory::FloodMemory;
pub use goals::{goal_of, plan_any, with_room};
pub use profile::Profile;
pub use question::{Query, Scratch, obstacles};
pub use recording::PoseRecording;
pub use report::{Report, Status};

use portfolio::Floods;
use question::{MIN_MARGIN, Search, TIGHT_CLEARANCE, Work};

use super::{Gap, Obstruction};
use crate::IS_COMPLETE;
use crate::geometry::arcs::Arc;
use crate::geometry::{Pose, math, reeds_shepp};
use crate::search::Progress;
use crate::vehicle::Vehicle;
use crate::vehicle::collision::CollisionChecker;

/// A car that can go no farther than this, ahead and back together, is stuck, metres.
const STUCK_TRAVEL: f64 = 1.0;
/// Plans a path that the car can drive.
///
/// The members of a portfolio, levels of resolution with one of several margins, take turns until one gives a path that
/// survives verification at 0.01 m.
/// Deterministic: budgets count expansions and collision checks, never time. `trace` keeps the search tree and the
/// connections that failed; `progress` is told of the expansions over all levels.
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
/// let report = plan(&query, &Config::default(), &mut Scratch::default(), false, &mut None);
/// assert_eq!(report.status, Status::Found);
/// ```
pub fn plan(
    query: &Query,
    config: &Config,
    scratch: &mut Scratch,
    trace: bool,
    progress: &mut Option<Progress>,
) -> Report {
    let report = search_alone(query, config, scratch, trace, progress);
    if IS_COMPLETE { compared(query, config, report, scratch, trace, progress) } else { report }
}

/// The answer, or what other settings find for less by the same measure; the rest of the work counts, too.
fn compared(
    query: &Query,
    config: &Config,
    report: Report,
    scratch: &mut Scratch,
    trace: bool,
    progress: &mut Option<Progress>,
) -> Report {
    let earlier = progress.as_ref().map_or(0, Progress::earlier);
    rivals::compare(query, config, report, &mut |rival, before| {
        if let Some(progress) = progress {
            if progress.is_stopped() {
                return None;
            }
            progress.continue_after(earlier.saturating_add(before));
        }
        Some(plan(query, rival, scratch, trace, progress))
    })
}

/// The answer of the portfolio under these settings alone.
fn search_alone(
    query: &Query,
    config: &Config,
    scratch: &mut Scratch,
    trace: bool,
    progress: &mut Option<Progress>,
) -> Report {
    let [start, goal] = [query.start, query.goal].map(|pose| query.obstacles.local(pose));
    let checker = CollisionChecker::new(query.obstacles, query.vehicle);
    let local = Local { query, checker: &checker, start, goal };
    let mut report = Report::empty(reeds_shepp::distance(start, goal, query.vehicle.min_turning_radius()));
    if local.refuses_contact(&mut report) {
        return report;
    }
    let look = config.margin.max(TIGHT_CLEARANCE);
    let clearance = checker.clearance(start, look).min(checker.clearance(goal, look));
    let margin = config.margin.max(MIN_MARGIN).min(clearance);
    report.margin = margin;
    let apart = (goal.point() - start.point()).norm();
    if apart <= 1e-6 && math::turn(start.heading, goal.heading).abs() <= 1e-6 {
        report.status = Status::Found;
        return report;
    }
    let room = Room { margin, is_tight: clearance < TIGHT_CLEARANCE, travels: local.travels(margin) };
    let mut work = Work { report: &mut report, scratch, progress };
    for config in &attempts(config) {
        local.search(config, &room, trace, &mut work);
        if !work.report.arcs.is_empty() || work.progress.as_ref().is_some_and(Progress::is_stopped) {
            break;
        }
    }
    report.stats.bytes += query.obstacles.bytes();
    report.collision_checks = checker.checks();
    local.explain(&mut report);
    report
}

/// The settings that are tried in turn. Where the search from the end that was asked for finds nothing, the portfolio
/// starts at the one that is hard to leave.
fn attempts(config: &Config) -> Vec<Config> {
    let from_asked = Config { ladder: false, ..*config };
    let from_any = Config { search_from: SearchFrom::Goal, ..*config };
    match (config.search_from == SearchFrom::Goal, config.levels()) {
        (true, _) => vec![from_any],
        (false, 1) => vec![from_asked],
        (false, _) => vec![from_asked, from_any],
    }
}

/// A question in the obstacles' coordinates.
struct Local<'a> {
    query: &'a Query<'a>,
    checker: &'a CollisionChecker<'a>,
    start: Pose,
    goal: Pose,
}

/// The room at both ends.
struct Room {
    /// The margin asked for, or what the ends leave of it, metres.
    margin: f64,
    is_tight: bool,
    /// How far the car can go from start and goal with that margin.
    travels: [f64; 2],
}

impl Local<'_> {
    /// True if the car touches something at one of its ends; the report then says what.
    fn refuses_contact(&self, report: &mut Report) -> bool {
        let obstacles = self.query.obstacles;
        for (at_start, pose) in [(true, self.start), (false, self.goal)] {
            let owner = obstacles.inside(pose.point()).or_else(|| self.checker.hit(pose, 0.0));
            if let Some(owner) = owner {
                report.status =
                    if at_start { Status::StartInCollision(owner) } else { Status::GoalInCollision(owner) };
                report.obstruction = Some(Obstruction::Contact { at_start, owner });
                return true;
            }
        }
        false
    }

    /// How far the car can go at start and goal, ahead and back together, metres.
    fn travels(&self, margin: f64) -> [f64; 2] {
        [self.start, self.goal].map(|pose| travel(self.checker, self.query.vehicle, pose, margin))
    }

    /// The portfolio from the end that is hard to leave, or from the one asked for.
    fn search(&self, config: &Config, room: &Room, trace: bool, work: &mut Work) {
        let Self { query, checker, start, goal } = *self;
        let [from_start, from_goal] = room.travels;
        let mirrored = config.search_from != SearchFrom::Start
            && (from_start >= STUCK_TRAVEL || from_start >= from_goal);
        let (root, target) = if mirrored { (goal, start) } else { (start, goal) };
        let floods = Floods::new(query, config, [target, root], room.margin, &work.scratch.floods);
        (work.report.margin, work.report.obstruction) = (floods.least(), None);
        if let Some((widest, flood)) = floods.widest() {
            work.report.margin = floods.margin(widest);
            let search = Search {
                query,
                config,
                checker,
                flood,
                root,
                target,
                mirrored,
                start,
                goal,
                tight: room.is_tight,
                trace,
                poses: None,
                goals: &[],
            };
            portfolio::plan(search, &floods, widest, work);
        } else {
            (work.report.status, work.report.obstruction) =
                unreachable(query, [start, goal], work.report.margin);
        }
        work.report.stats.bytes += floods.bytes();
    }

    /// Says what is in the way where there is no path.
    fn explain(&self, report: &mut Report) {
        let [from_start, from_goal] = self.travels(report.margin);
        let least = from_start.min(from_goal);
        if report.status == Status::NoPath && least < STUCK_TRAVEL {
            let at_start = from_start < from_goal;
            let stuck = if at_start { self.start } else { self.goal };
            report.status = Status::BoxedIn { at_start, travel: least };
            let stops = obstruction::stops(self.checker, self.query, stuck, report.margin);
            report.obstruction = Some(Obstruction::BoxedIn { at_start, stops });
        } else if report.arcs.is_empty() && report.obstruction.is_none() {
            let nearest = |pose: Pose| Obstruction::Nearest { at: pose.point(), heading: Some(pose.heading) };
            report.obstruction = report.closest.map(nearest);
        }
    }
}

/// Why there is no way at all, and where it ends.
fn unreachable(query: &Query, ends: [Pose; 2], margin: f64) -> (Status, Option<Obstruction>) {
    let Some(gap) = bottleneck::too_narrow(query.obstacles, query.vehicle, ends[0], ends[1]) else {
        return (Status::Unreachable, Some(obstruction::enclosed(query, ends, margin)));
    };
    let gap = Gap { at: gap.at + (query.start.point() - ends[0].point()), ..gap };
    (Status::TooNarrow(gap), Some(Obstruction::Gap(gap)))
}

/// How far the body can go ahead and back from a pose, together, metres; a metre each way at most.
fn travel(checker: &CollisionChecker, vehicle: &Vehicle, pose: Pose, margin: f64) -> f64 {
    let limit = vehicle.max_curvature();
    let way = |length: f64| {
        let far = |curvature: f64| checker.free_length(pose, &Arc { curvature, length }, 0.05, margin);
        [-limit, 0.0, limit].into_iter().map(far).fold(0.0, f64::max)
    };
    way(1.0) + way(-1.0)
}

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
//! * *Analytic expansion*: from many nodes a Reeds–Shepp curve to the target is tried. The first free one that no
//!   open node can beat ends the search exactly at the target pose.
//! * The tree grows *from the goal* by default (the parking paper's reverse search): the car model drives the same
//!   way back, and leaving a slot needs far fewer expansions than finding it.
//!
//! A cost in metres: length, times `reverseCost` in reverse, plus `directionChangeCost` a gear change, plus weights
//! of steering and of nearness to obstacles (`cost`). Where the coarse lattice finds nothing, a portfolio of finer
//! ones and of smaller margins takes turns (`portfolio`). "No path" with a proof and "budget spent" are told apart
//! ([`Status`]).

mod analytic_expansion;
#[cfg(feature = "complete")]
mod anchor;
#[cfg(feature = "complete")]
mod bidirectional;
mod bottleneck;
#[cfg(feature = "complete")]
mod choices;
mod config;
mod cost;
mod domain;
#[cfg(feature = "complete")]
mod goals;
#[cfg(feature = "complete")]
mod holonomic;
mod level;
mod obstacle_heuristic;
mod obstruction;
mod portfolio;
#[cfg(feature = "complete")]
mod pose_heuristic;
mod profile;
mod question;
#[cfg(feature = "complete")]
mod recording;
mod report;
#[cfg(feature = "complete")]
mod rivals;
mod shortcut;
mod state;
mod state_index;
mod tree;
#[cfg(feature = "complete")]
mod widest;

pub use analytic_expansion::FailedExpansions;
#[cfg(feature = "complete")]
pub use anchor::{Last, stay};
#[cfg(feature = "complete")]
pub use choices::{Prefer, choices};
pub use config::{Config, Heuristic, SearchFrom};
#[cfg(feature = "complete")]
pub use goals::{goal_of, plan_any, with_room};
pub use profile::Profile;
pub use question::{Query, Scratch, obstacles};
#[cfg(feature = "complete")]
pub use recording::PoseRecording;
pub use report::{Report, Status};

use portfolio::Floods;
use question::{MIN_MARGIN, Search, TIGHT_CLEARANCE, Work};

use super::{Gap, Obstruction};
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
    #[cfg(feature = "complete")]
    let report = rivals::compare(query, config, report, &mut |rival, before| {
        if let Some(progress) = progress {
            if progress.is_stopped() {
                return None;
            }
            progress.continue_after(before);
        }
        Some(search_alone(query, rival, scratch, trace, progress))
    });
    report
}

/// The answer of the portfolio under these settings alone.
#[cfg_attr(feature = "complete", inline(never))]
fn search_alone(
    query: &Query,
    config: &Config,
    scratch: &mut Scratch,
    trace: bool,
    progress: &mut Option<Progress>,
) -> Report {
    let local = |pose| query.obstacles.local(pose);
    let (start, goal) = (local(query.start), local(query.goal));
    let probe = CollisionChecker::new(query.obstacles, query.vehicle);
    let radius = query.vehicle.min_turning_radius();
    let mut report = Report::empty(reeds_shepp::distance(start, goal, radius));
    let blocked = |pose: Pose| query.obstacles.inside(pose.point()).or_else(|| probe.hit(pose, 0.0));
    if let Some(owner) = blocked(start) {
        report.status = Status::StartInCollision(owner);
        report.obstruction = Some(Obstruction::Contact { at_start: true, owner });
        return report;
    }
    if let Some(owner) = blocked(goal) {
        report.status = Status::GoalInCollision(owner);
        report.obstruction = Some(Obstruction::Contact { at_start: false, owner });
        return report;
    }
    let look = config.margin.max(TIGHT_CLEARANCE);
    let clearance = probe.clearance(start, look).min(probe.clearance(goal, look));
    report.margin = config.margin.max(MIN_MARGIN).min(clearance);
    let apart = (goal.point() - start.point()).norm();
    if apart <= 1e-6 && math::turn(start.heading, goal.heading).abs() <= 1e-6 {
        report.status = Status::Found;
        return report;
    }
    let travels = |margin| [start, goal].map(|pose| travel(&probe, query.vehicle, pose, margin));
    let [from_start, from_goal] = travels(report.margin);
    let margin = report.margin;
    // Where the search from the end that was asked for finds nothing, the portfolio starts at the one that is hard to
    // leave.
    let from_asked = Config { ladder: false, ..*config };
    let from_any = Config { search_from: SearchFrom::Goal, ..*config };
    let both = [from_asked, from_any];
    let attempts = match (config.search_from == SearchFrom::Goal, config.levels()) {
        (true, _) => &both[1..],
        (false, 1) => &both[..1],
        (false, _) => &both[..],
    };
    for config in attempts {
        let mirrored = config.search_from != SearchFrom::Start
            && (from_start >= STUCK_TRAVEL || from_start >= from_goal);
        let (root, target) = if mirrored { (goal, start) } else { (start, goal) };
        let floods = Floods::new(query, config, [target, root], margin, scratch.flood.take());
        (report.margin, report.obstruction) = (floods.least(), None);
        if let Some((widest, flood)) = floods.widest() {
            report.margin = floods.margin(widest);
            let search = Search {
                query,
                config,
                probe: &probe,
                flood,
                root,
                target,
                mirrored,
                start,
                goal,
                tight: clearance < TIGHT_CLEARANCE,
                trace,
                #[cfg(feature = "complete")]
                poses: None,
                #[cfg(feature = "complete")]
                goals: &[],
            };
            portfolio::plan(search, &floods, widest, &mut Work { report: &mut report, scratch, progress });
        } else {
            (report.status, report.obstruction) = unreachable(query, [start, goal], report.margin);
        }
        report.stats.bytes += floods.bytes();
        scratch.flood = floods.into_memory();
        if !report.arcs.is_empty() || progress.as_ref().is_some_and(Progress::is_stopped) {
            break;
        }
    }
    report.stats.bytes += query.obstacles.bytes();
    report.collision_checks = probe.checks();
    let [from_start, from_goal] = travels(report.margin);
    let least = from_start.min(from_goal);
    if report.status == Status::NoPath && least < STUCK_TRAVEL {
        let at_start = from_start < from_goal;
        report.status = Status::BoxedIn { at_start, travel: least };
        let stops = obstruction::stops(&probe, query, if at_start { start } else { goal }, report.margin);
        report.obstruction = Some(Obstruction::BoxedIn { at_start, stops });
    } else if report.arcs.is_empty() && report.obstruction.is_none() {
        report.obstruction =
            report.closest.map(|pose| Obstruction::Nearest { at: pose.point(), heading: Some(pose.heading) });
    }
    report
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
fn travel(probe: &CollisionChecker, vehicle: &Vehicle, pose: Pose, margin: f64) -> f64 {
    let limit = vehicle.max_curvature();
    let way = |length: f64| {
        let far = |curvature: f64| probe.free_length(pose, &Arc { curvature, length }, 0.05, margin);
        [-limit, 0.0, limit].into_iter().map(far).fold(0.0, f64::max)
    };
    way(1.0) + way(-1.0)
}

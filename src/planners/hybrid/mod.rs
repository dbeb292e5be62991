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
mod recording;
mod shortcut;
mod state_index;
#[cfg(feature = "complete")]
mod widest;

pub use analytic_expansion::FailedExpansions;
#[cfg(feature = "complete")]
pub use anchor::{Last, stay};
#[cfg(feature = "complete")]
pub use choices::{Prefer, choices};
pub use config::{Config, Heuristic, Profile, SearchFrom};
#[cfg(feature = "complete")]
pub use goals::{goal_of, plan_any, with_room};

#[cfg(feature = "complete")]
pub use recording::PoseRecording;

use core::cell::RefCell;

use analytic_expansion::Recorder;
use domain::State;
use level::{Search, Work};
use obstacle_heuristic::ObstacleHeuristic;
use portfolio::Floods;
use state_index::StateIndex;

use super::{Gap, Obstruction};
use crate::geometry::arcs::Arc;
use crate::geometry::{Pose, math, reeds_shepp};
use crate::scenario::resolve::{Form, Geometry};
#[cfg(feature = "complete")]
use crate::search::{ExpansionCallback, Expansions};
use crate::search::{NodeId, Observer, Progress};
use crate::vehicle::Vehicle;
use crate::vehicle::collision::{CollisionChecker, Edge, Obstacles, Solid};

/// A car that can go no farther than this, ahead and back together, is stuck, metres.
const STUCK_TRAVEL: f64 = 1.0;
/// The least margin where start and goal have it, metres: what passes unseen between two checks.
const MIN_MARGIN: f64 = 0.002;
/// Less clearance than this at start or goal is tight, metres.
const TIGHT_CLEARANCE: f64 = 0.4;
/// Arcs of the search tree that are kept for drawing.
const MAX_TREE_ARCS: usize = 20_000;

/// Everything that blocks in a scene, prepared for queries. Owner 0 is the border, owner k is `shapes[k - 1]`.
pub fn obstacles(geometry: &Geometry) -> Obstacles {
    let (mut walls, mut solids) = (Vec::new(), Vec::new());
    for (owner, shape) in (1..).zip(&geometry.shapes) {
        match &shape.form {
            Form::Segment(a, b) => walls.push(Edge { a: *a, b: *b, owner }),
            Form::Polygon(outline) => solids.push(Solid { outline: outline.clone(), owner }),
        }
    }
    Obstacles::new(&walls, &solids, &Solid { outline: geometry.boundary.clone(), owner: 0 })
}

/// A question to hybrid A*: poses in world coordinates.
#[derive(Debug, Clone, Copy)]
pub struct Query<'a> {
    /// Everything that blocks.
    pub obstacles: &'a Obstacles,
    /// The car.
    pub vehicle: &'a Vehicle,
    /// Start pose.
    pub start: Pose,
    /// Goal pose.
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
    /// The body would not fit through if it moved in any direction and turned on the spot.
    #[cfg(feature = "complete")]
    NoRoom,
    /// Some level was searched to its end with the least margin.
    NoPath,
    /// So it was, and the car can hardly move where it starts or arrives.
    BoxedIn {
        /// True at the start, false at the goal.
        at_start: bool,
        /// Distance that it can drive ahead plus back there with its margin, metres.
        travel: f64,
    },
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
    /// Level of the portfolio that gave the path, or the last one tried.
    pub level: u32,
    /// The margin planned with, metres: less than asked where start or goal have less, and 5 cm, 3 cm, 1 cm or 2 mm
    /// where no way with more was found.
    pub margin: f64,
    /// True if the tree that gave the path, or was grown last, grew from the goal.
    #[cfg(feature = "complete")]
    pub from_goal: bool,
    /// Side of that tree's position cells, metres, and width of its heading bins, radians.
    #[cfg(feature = "complete")]
    pub resolution: (f64, f64),
    /// Expansions, over all levels.
    pub expanded: u32,
    /// Distinct states met, over all levels.
    pub generated: u32,
    /// Insertions into the open list, over all levels.
    pub pushes: u32,
    /// Largest size of the open list.
    pub open_peak: u32,
    /// Bytes of the obstacles' rasters and buckets, the estimate's raster, and of the level that kept most of its nodes
    /// and open list.
    pub bytes: u64,
    /// Poses tested for collision.
    pub collision_checks: u32,
    /// The expanded pose with the least estimate to go: how near the search came.
    pub closest: Option<Pose>,
    /// The obstruction between the car and its goal, if known.
    pub obstruction: Option<Obstruction>,
    /// Arcs of the search tree as driven, in order of expansion: x, y, heading, curvature, signed length, ….
    pub tree: Vec<f64>,
    /// Tree arcs beyond the cap.
    pub tree_dropped: u64,
    /// Connections that hit something, of the same search.
    pub shots: FailedExpansions,
    /// The events of the same search, where [`Scratch::record`] asks for them.
    #[cfg(feature = "complete")]
    pub recorded: Option<PoseRecording>,
}

/// The memory of hybrid A*, reused between queries.
#[derive(Debug, Default)]
pub struct Scratch {
    search: crate::search::Scratch<f64, State>,
    keys: RefCell<StateIndex>,
    flood: Option<ObstacleHeuristic>,
    /// Of the other tree, where two grow.
    #[cfg(feature = "complete")]
    other: Option<Box<Self>>,
    #[cfg(feature = "complete")]
    recorded_steps: Option<usize>,
}

#[cfg(feature = "complete")]
impl Scratch {
    /// From now on searches from one end write down all that they do, each at most so many steps.
    pub fn record(&mut self, limit: Option<usize>) {
        self.recorded_steps = limit;
    }
}

/// Numbers of an arc: x, y, heading, curvature, signed length.
const ARC: usize = 5;
/// Arcs that a callback is given at a time: often enough for a drawing, and few calls.
#[cfg(feature = "complete")]
const TOLD_ARCS: usize = 64;

/// Keeps the arcs that led to expanded states.
struct Tree<'a> {
    arcs: Vec<f64>,
    dropped: u64,
    origin: Pose,
    mirrored: bool,
    /// Those of the numbers that `tell` knows.
    #[cfg(feature = "complete")]
    told: usize,
    #[cfg(feature = "complete")]
    tell: Option<ExpansionCallback<'a>>,
    #[cfg(not(feature = "complete"))]
    tell: core::marker::PhantomData<&'a ()>,
}

impl Tree<'_> {
    /// Tells what is not told yet.
    #[cfg(feature = "complete")]
    fn flush(&mut self) {
        if let Some(tell) = self.tell.filter(|_| self.told < self.arcs.len()) {
            tell(Expansions { is_first: self.told == 0, nodes: &[], numbers: &self.arcs[self.told..] });
            self.told = self.arcs.len();
        }
    }
}

impl Observer<f64, State> for Tree<'_> {
    fn side(&mut self, side: usize) {
        self.mirrored = side == 1;
    }

    fn expanded(&mut self, _: NodeId, at: State, _: f64) {
        if at.length == 0.0 {
            return;
        }
        if self.arcs.len() >= MAX_TREE_ARCS * ARC {
            self.dropped += 1;
            return;
        }
        let (curvature, length) = (at.motion.curvature, at.length);
        let (from, length) =
            if self.mirrored { (at.pose, -length) } else { (at.pose.advance(curvature, -length), length) };
        let (x, y) = (from.x + self.origin.x, from.y + self.origin.y);
        self.arcs.extend([x, y, from.heading, curvature, length]);
        #[cfg(feature = "complete")]
        if self.arcs.len() - self.told == TOLD_ARCS * ARC {
            self.flush();
        }
    }
}

impl Report {
    /// No path, after as much work.
    fn counters(&self) -> Self {
        Self {
            expanded: self.expanded,
            generated: self.generated,
            pushes: self.pushes,
            open_peak: self.open_peak,
            bytes: self.bytes,
            ..empty(self.rs_bound)
        }
    }

    /// The answer of an earlier search, after as much work.
    fn with_path_of(&self, known: Self) -> Self {
        let Self { expanded, generated, pushes, open_peak, bytes, .. } = *self;
        Self { expanded, generated, pushes, open_peak, bytes, ..known }
    }

    fn keep(&mut self, tree: Option<Tree>, watch: Option<&RefCell<Recorder>>) {
        if let (Some(tree), Some(watch)) = (tree, watch) {
            #[cfg(feature = "complete")]
            let tree = {
                let mut tree = tree;
                tree.flush();
                tree
            };
            (self.tree, self.tree_dropped) = (tree.arcs, tree.dropped);
            self.shots = core::mem::take(&mut watch.borrow_mut().shots);
        }
    }
}

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
#[cfg_attr(feature = "complete", inline(never))]
pub fn plan(
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
    let mut report = empty(reeds_shepp::distance(start, goal, radius));
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
                goals: &[],
            };
            portfolio::plan(search, &floods, widest, &mut Work { report: &mut report, scratch, progress });
        } else {
            (report.status, report.obstruction) = unreachable(query, [start, goal], report.margin);
        }
        report.bytes += floods.bytes();
        scratch.flood = floods.into_memory();
        if !report.arcs.is_empty() || progress.as_ref().is_some_and(Progress::is_stopped) {
            break;
        }
    }
    report.bytes += query.obstacles.bytes();
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

fn empty(rs_bound: f64) -> Report {
    Report {
        status: Status::NoPath,
        arcs: Vec::new(),
        cost: 0.0,
        rs_bound,
        level: 0,
        margin: 0.0,
        #[cfg(feature = "complete")]
        from_goal: false,
        #[cfg(feature = "complete")]
        resolution: (0.0, 0.0),
        expanded: 0,
        generated: 0,
        pushes: 0,
        open_peak: 0,
        bytes: 0,
        collision_checks: 0,
        closest: None,
        obstruction: None,
        tree: Vec::new(),
        tree_dropped: 0,
        shots: FailedExpansions::default(),
        #[cfg(feature = "complete")]
        recorded: None,
    }
}

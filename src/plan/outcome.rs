//! The answer of a planner.
//!
//! A [`Plan`] holds the path as poses, the search's counters ([`Stats`]), figures of the path ([`Metrics`]) and the
//! verdict of the independent check. A plan without a path has the counters and the trace, too, and says what
//! blocks the way.
//!
//! # Layout
//!
//! `path`, `directions` and `curvatures` have one item per pose. Item i of the latter two describes the way from pose i
//! to pose i + 1; the last repeats the one before. With the gear g (±1) and the curvature κ (1/m, positive where the
//! car turns to its left) the next pose is the arc's end after the signed length g·s, s metres on. Two poses at one
//! place with different headings are a corner, which only grid planners make.
//!
//! # Without a path
//!
//! The outcome tells a proof from a shortage. `no-path` means that the search went through everything that its settings
//! allow. `budget-spent` means that it stopped before that, and proves nothing. `start-blocked` and its likes are found
//! before any search. `path` is then empty and [`Plan::check`] has the verdict `none`.

use serde::Serialize;

use crate::fnv::Fnv;
use crate::geometry::{Point, Pose, arcs, math};
use crate::json;
use crate::metrics::Check;
use crate::planners::Obstruction;
use crate::planners::hybrid::FailedExpansions;
use crate::planners::hybrid::PoseRecording;
pub use crate::planners::{Detail, Outcome};
use crate::scenario::GoalPose;
use crate::search::Recording;
use crate::search::SearchStats;

/// Counters of the search.
///
/// Counts are exact and equal on every platform, so they compare planners where times cannot. Absent fields are those
/// that the planner does not have; they do not stand for 0.
#[derive(Debug, Clone, Default, Serialize)]
#[serde(rename_all = "camelCase")]
pub struct Stats {
    /// Nodes taken from the open list and processed.
    pub expanded: u32,
    /// Distinct nodes that ever entered the open list.
    pub generated: u32,
    /// All insertions into the open list.
    pub pushes: u32,
    /// Largest size of the open list.
    pub open_peak: u32,
    /// Bytes of the arrays that the planner held: what it kept of each node, its open list at its largest, and the
    /// rasters that it searched; not the scene. No part of the hash.
    #[serde(skip)]
    pub memory_bytes: u64,
    /// Grid planners: second expansions.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub deferred: Option<u32>,
    /// Grid planners: line-of-sight tests.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub los_calls: Option<u32>,
    /// Grid planners: exact cost, millionths of a cell.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub cost_micro: Option<i64>,
    /// Jump points: cells looked at along jumps.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub cells_scanned: Option<u32>,
    /// NBA*: cells that bounds excluded.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub rejected: Option<u32>,
    /// Redundant safety space: cells closed because they are too narrow.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub narrow: Option<u32>,
    /// Redundant safety space: cells closed because they are in a pocket.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub pocket: Option<u32>,
    /// Redundant safety space: closed cells given back to connect start and goal.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub restored: Option<u32>,
    /// Hybrid A*: the same number as `expanded`, by the name of its specification.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub expansions: Option<u32>,
    /// Hybrid A*: poses tested for collision.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub collision_checks: Option<u32>,
    /// Hybrid A*: level of the portfolio that gave the path, or was tried last.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub level: Option<u32>,
}

impl Stats {
    /// The counters that every planner has.
    pub(super) fn of(SearchStats { expanded, generated, pushes, open_peak, bytes }: SearchStats) -> Self {
        Self { expanded, generated, pushes, open_peak, memory_bytes: bytes, ..Self::default() }
    }
}

/// Figures of the path.
///
/// Of the path as it is answered, after post-processing; all are 0 without a path.
#[derive(Debug, Clone, Default, Serialize)]
#[serde(rename_all = "camelCase")]
pub struct Metrics {
    /// Length of the path, metres.
    pub length: f64,
    /// Gear changes along it.
    pub direction_changes: u32,
    /// Largest |curvature|, 1/m; `None` where the path has corners.
    pub max_curvature: Option<f64>,
    /// The car's limit, 1/m.
    pub curvature_limit: f64,
    /// Smallest distance from the body to an obstacle, metres.
    pub min_clearance: f64,
    /// Mean distance over the poses, metres.
    pub mean_clearance: f64,
    /// Length in which every part counts by the weight under the path, metres: under the middle of the rear axle, for
    /// `cost-map` under the middle of the car. `None` without weights.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub weighted_length: Option<f64>,
    /// Grid planners.
    #[serde(flatten, skip_serializing_if = "Option::is_none")]
    pub grid: Option<GridMetrics>,
    /// Hybrid A*.
    #[serde(flatten, skip_serializing_if = "Option::is_none")]
    pub hybrid: Option<HybridMetrics>,
    /// Cost-map A*.
    #[serde(flatten, skip_serializing_if = "json::is_left_out")]
    pub road: Option<crate::metrics::road::RoadMetrics>,
}

/// Metrics of a path of cells, lengths in cells.
///
/// The four lengths are those of the same search: raw ≥ pruned ≥ shortest on equal weights, and arcs shorten the
/// corners further.
#[derive(Debug, Clone, Default, Serialize)]
#[serde(rename_all = "camelCase")]
pub struct GridMetrics {
    /// As searched.
    pub length_raw: f64,
    /// After one greedy pruning pass.
    pub length_pruned: f64,
    /// Along the shortest way over its cells.
    pub length_dp: f64,
    /// After pruning and tangent arcs.
    pub length_smoothed: f64,
    /// Corners of the raw path.
    pub turns: u32,
    /// Sum of |heading change| of the raw path, degrees.
    pub turn_angle_deg: f64,
    /// Corners of the pruned path.
    pub turns_pruned: u32,
    /// Sum of |heading change| of the pruned path, degrees.
    pub turn_angle_deg_pruned: f64,
    /// Smallest distance of the path as answered, from its cells' centres to blocked cells' centres, at most 5 cells.
    pub min_clearance_cells: f64,
    /// Mean of that distance, sampled every quarter of a cell.
    pub mean_clearance_cells: f64,
    /// Corners that smoothing had to keep.
    pub sharp_corners: u32,
    /// Arcs that smoothing placed.
    pub arcs: u32,
    /// Smallest radius of those arcs, cells.
    pub min_radius: Option<f64>,
}

/// Metrics of a path of arcs.
#[derive(Debug, Clone, Default, Serialize)]
#[serde(rename_all = "camelCase")]
pub struct HybridMetrics {
    /// Cost of the path under the planner's settings.
    pub cost: f64,
    /// The margin planned with, metres. The path keeps it to 3 mm. It is less than asked where start or goal have
    /// less or only less leads there, 2 mm at least where they have that.
    pub margin: f64,
    /// Length of the shortest path without obstacles, metres.
    pub rs_bound: f64,
    /// How far the length is above that, percent. No planner can do better than 0.
    pub gap_percent: f64,
    /// Length in the parking paper's rounding, metres.
    pub paper_length: f64,
    /// Nodes in the parking paper's counting.
    pub paper_nodes: u32,
    /// Driving time at the parking paper's 2 m/s, seconds.
    pub paper_time: f64,
    /// Duration of the trajectory that [`optimise`](super::optimise()) makes of the path by default, seconds; where
    /// paths are chosen among.
    #[serde(skip_serializing_if = "json::is_left_out")]
    pub drive_time: Option<f64>,
}

/// The nodes that the search visited, for drawing.
///
/// Kept up to a million events; `dropped` counts the rest, so a drawing can say that it is not complete.
#[derive(Debug, Clone)]
pub enum PlanTrace {
    /// Cell indices in order of expansion.
    Cells {
        /// `y * width + x`.
        cells: Vec<u32>,
        /// Expansions beyond the cap.
        dropped: u64,
    },
    /// Arcs of the search tree, as driven.
    Arcs {
        /// x, y, heading, curvature, signed length, …
        arcs: Vec<f64>,
        /// Arcs beyond the cap.
        dropped: u64,
        /// Analytic connections that hit something.
        failed_expansions: FailedExpansions,
    },
}

/// Every event of a search.
///
/// Enough to step through the search and to say of each node why it was kept, improved or rejected.
#[derive(Debug, Clone)]
pub enum Recorded {
    /// Over the cells of a map.
    Cells {
        /// Columns of the map.
        width: u32,
        /// Rows of the map.
        height: u32,
        /// The events; node `y * width + x` is a cell.
        recording: Recording,
    },
    /// Over the poses of a car.
    Poses(PoseRecording),
}

/// A search of hybrid A*'s portfolio: the one that found the path or, where there is none, that went through everything
/// with the least margin, or was tried last.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
#[serde(rename_all = "camelCase")]
pub struct Member {
    /// Its level.
    pub level: u32,
    /// True if its tree grew from the goal, else from the start; false of a search from both ends.
    pub from_goal: bool,
    /// Side of a position cell, metres.
    pub xy_resolution: f64,
    /// Width of a heading bin, radians.
    pub heading_resolution: f64,
    /// Kept free around the body, metres.
    pub margin: f64,
}

/// A planner's answer.
#[derive(Debug, Clone)]
pub struct Plan {
    /// The planner's id.
    pub planner: &'static str,
    /// How it ended.
    pub outcome: Outcome,
    /// A finer word for the outcome.
    pub detail: Option<Detail>,
    /// For people, where there is no path.
    pub reason: Option<String>,
    /// The place that blocks the way, if there is no path and the place is known.
    pub obstruction: Option<Obstruction>,
    /// The goal that the path leads to, where the scene has several.
    pub goal: Option<GoalPose>,
    /// Poses, close together, from start to goal.
    pub path: Vec<Pose>,
    /// Per pose: gear of the way to the next one.
    pub directions: Vec<i8>,
    /// Per pose: signed curvature of the way to the next one, 1/m; NaN at a corner.
    pub curvatures: Vec<f64>,
    /// The planner's unprocessed path.
    pub raw_path: Vec<Point>,
    /// Counters of the search.
    pub stats: Stats,
    /// Figures of the path.
    pub metrics: Metrics,
    /// The independent validator's verdict.
    pub check: Check,
    /// Hybrid A*: which search of its portfolio answered.
    pub member: Option<Member>,
    /// The search trace, if requested.
    pub trace: Option<PlanTrace>,
    /// The search with all its events, if requested.
    pub recorded: Option<Box<Recorded>>,
    /// Grid planners: what each step after the search makes of the path, if the trace is asked for.
    pub stages: Option<super::Stages>,
    /// Hybrid A*, if asked for: the paths of which none is better in everything than another, this one among them, the
    /// shortest first; told apart by length and driving time to 1 %, by clearance to 5 cm.
    pub alternatives: Vec<Plan>,
}

impl Plan {
    /// Two FNV-1a-64 hashes, 16 hex digits each with a hyphen between them, equal on every platform: of the answer
    /// (planner, outcome, verdict, poses and gears of the path), and of the figures and counters (statistics, metrics,
    /// clearances, the path before post-processing). The trace and words for people are in neither.
    ///
    /// Plans that differ in one bit of a part have different hashes there, but for chance. It serves to compare
    /// platforms and versions, not as a defence against forgery. A new figure or counter changes the second part only.
    ///
    /// # Examples
    /// ```
    /// use parkade::plan::Planner;
    ///
    /// let scene = parkade::scenario::catalog::scenario("P2").unwrap();
    /// let plan = || Planner::new("hybrid", &scene, &Default::default()).unwrap().plan(Default::default());
    /// let (one, other) = (plan(), plan());
    /// assert_eq!(one.hash(), other.hash());
    /// assert_eq!((one.path.len(), one.path.len()), (one.directions.len(), one.curvatures.len()));
    /// ```
    pub fn hash(&self) -> String {
        format!("{}-{}", self.answer_hash().hex(), self.figures_hash().hex())
    }

    /// Of the answer itself: planner, outcome, verdict, poses and gears.
    fn answer_hash(&self) -> Fnv {
        let mut hash = Fnv::new();
        for word in [self.planner, self.outcome.as_str(), self.check.verdict.as_str()] {
            hash.add(word.as_bytes());
        }
        hash.add_numbers(self.path.iter().flat_map(|pose| [pose.x, pose.y, pose.heading]));
        self.directions.iter().for_each(|&d| hash.add(&d.to_le_bytes()));
        hash
    }

    /// Of everything that describes the answer: clearances, raw path, counters and metrics.
    fn figures_hash(&self) -> Fnv {
        let mut hash = Fnv::new();
        hash.add_numbers(self.check.clearances.iter().copied());
        hash.add_numbers(self.raw_path.iter().flat_map(|p| [p.x, p.y]));
        for value in [serde_json::to_value(&self.stats), serde_json::to_value(&self.metrics)] {
            hash.add(value.unwrap_or_default().to_string().as_bytes());
        }
        hash
    }
}

/// The gear changes along `directions`.
pub(super) fn direction_changes(directions: &[i8]) -> u32 {
    directions.windows(2).filter(|d| d[0] != d[1]).count() as u32
}

/// Length of a way through poses along its arcs, metres. A corner has none.
pub(super) fn path_length(path: &[Pose]) -> f64 {
    // Not `sum`, which starts from −0.
    path.windows(2).fold(0.0, |sum, pair| {
        let chord = (pair[1].point() - pair[0].point()).norm();
        sum + arcs::length_over(chord, math::turn(pair[0].heading, pair[1].heading))
    })
}

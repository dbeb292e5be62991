//! The answer of hybrid A\*.
//!
//! [`Status`] is finer than the outcome of other planners, because a car can fail in more ways than a point: it may
//! touch something where it stands, have no gap wide enough, no room to turn, or no manoeuvre within the budget. Each
//! carries the figure that a person needs. [`Report`] has the path as arcs and what the search did; it knows nothing
//! of poses in time, clearances or words.

use super::analytic_expansion::FailedExpansions;
use super::recording::PoseRecording;
use crate::geometry::Pose;
use crate::geometry::arcs::Arc;
use crate::planners::{Detail, Gap, Obstruction, Outcome};
use crate::search::SearchStats;

/// How planning ended, with its figures. [`outcome`](Self::outcome) and [`detail`](Self::detail) are the words that all
/// planners share.
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

impl Status {
    /// True if there is a path.
    pub fn is_found(self) -> bool {
        matches!(self, Self::Found | Self::Suboptimal)
    }

    /// The word of all planners for it.
    pub fn outcome(self) -> Outcome {
        match self {
            Self::Found | Self::Suboptimal => Outcome::Found,
            Self::StartInCollision(_) => Outcome::StartBlocked,
            Self::GoalInCollision(_) => Outcome::GoalBlocked,
            Self::Unreachable
            | Self::TooNarrow(_)
            | Self::NoRoom
            | Self::NoPath
            | Self::BoxedIn { .. }
            | Self::VerificationFailed => Outcome::NoPath,
            Self::BudgetExhausted(_) => Outcome::BudgetSpent,
        }
    }

    /// The finer word, where there is one.
    pub fn detail(self) -> Option<Detail> {
        match self {
            Self::Suboptimal => Some(Detail::Suboptimal),
            Self::Unreachable => Some(Detail::Unreachable),
            Self::TooNarrow(_) => Some(Detail::TooNarrow),
            Self::NoRoom => Some(Detail::NoRoom),
            Self::BoxedIn { .. } => Some(Detail::BoxedIn),
            Self::VerificationFailed => Some(Detail::VerificationFailed),
            _ => None,
        }
    }
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
    pub from_goal: bool,
    /// Side of that tree's position cells, metres, and width of its heading bins, radians.
    pub resolution: (f64, f64),
    /// The counters of all levels. Bytes are those of the obstacles' rasters and buckets, the estimate's raster, and of
    /// the level that kept most of its nodes and open list.
    pub stats: SearchStats,
    /// Poses tested for collision.
    pub collision_checks: u32,
    /// The expanded pose with the least estimate to go: how near the search came.
    pub closest: Option<Pose>,
    /// True if the search ended early, as a coarse one had found start and goal apart.
    pub(super) are_apart: bool,
    /// The obstruction between the car and its goal, if known.
    pub obstruction: Option<Obstruction>,
    /// Arcs of the search tree as driven, in order of expansion: x, y, heading, curvature, signed length, ….
    pub tree: Vec<f64>,
    /// Tree arcs beyond the cap.
    pub tree_dropped: u64,
    /// Connections that hit something, of the same search.
    pub failed_expansions: FailedExpansions,
    /// The events of the same search, where [`Scratch::record`](super::Scratch::record) asks for them.
    pub recorded: Option<std::sync::Arc<PoseRecording>>,
}

impl Report {
    /// No path, before any work.
    pub(super) fn empty(rs_bound: f64) -> Self {
        Self {
            status: Status::NoPath,
            arcs: Vec::new(),
            cost: 0.0,
            rs_bound,
            level: 0,
            margin: 0.0,
            from_goal: false,
            resolution: (0.0, 0.0),
            stats: SearchStats::default(),
            collision_checks: 0,
            closest: None,
            are_apart: false,
            obstruction: None,
            tree: Vec::new(),
            tree_dropped: 0,
            failed_expansions: FailedExpansions::default(),
            recorded: None,
        }
    }

    /// No path, after as much work.
    #[inline(never)]
    pub(super) fn counters(&self) -> Self {
        Self { stats: self.stats, ..Self::empty(self.rs_bound) }
    }

    /// The answer of an earlier search, after as much work.
    #[inline(never)]
    pub(super) fn with_path_of(&self, known: Self) -> Self {
        Self { stats: self.stats, ..known }
    }
}

//! A question to hybrid A\*: as it is asked, and as one search of it is made.
//!
//! A [`Query`] has poses in world coordinates. Each search of it is a `Search`: the same poses in the coordinates of
//! the obstacles, at one margin, with a direction in which the tree grows. `Work` is what the searches of one plan
//! share: the answer so far and the memory.

use core::cell::RefCell;

use super::config::Config;
use super::cost::CostModel;
use super::flood_memory::FloodMemory;
use super::obstacle_heuristic::ObstacleHeuristic;
use super::pose_heuristic::PoseHeuristic;
use super::report::Report;
use super::state::State;
use super::state_index::StateIndex;
use crate::IS_COMPLETE;
use crate::geometry::Pose;
use crate::geometry::arcs;
use crate::geometry::arcs::Arc;
use crate::geometry::math;
use crate::scenario::resolve::{Form, Geometry};
use crate::search::Progress;
use crate::vehicle::Vehicle;
use crate::vehicle::collision::{CollisionChecker, Edge, Obstacles, Solid};

/// The least margin where start and goal have it, metres: what passes unseen between two checks.
pub(super) const MIN_MARGIN: f64 = 0.002;
/// Less clearance than this at start or goal is tight, metres.
pub(super) const TIGHT_CLEARANCE: f64 = 0.4;

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

/// The memory of hybrid A*, reused between queries.
#[derive(Debug, Default)]
pub struct Scratch {
    pub(super) search: crate::search::Scratch<f64, State>,
    pub(super) keys: RefCell<StateIndex>,
    pub(super) floods: FloodMemory,
    /// Of the other tree, where two grow.
    pub(super) other: Option<Box<Self>>,
    pub(super) recorded_steps: Option<usize>,
}

impl Scratch {
    /// Memory that shares its floods with other planners.
    pub fn sharing(floods: FloodMemory) -> Self {
        Self { floods, ..Self::default() }
    }

    /// From now on searches from one end write down all that they do, each at most so many steps.
    pub fn record(&mut self, limit: Option<usize>) {
        self.recorded_steps = limit;
    }
}

/// State shared by the levels: the answer so far, the memory, and the observer of expansions.
pub(super) struct Work<'a, 'p> {
    /// The answer so far, with the counters of all searches.
    pub(super) report: &'a mut Report,
    /// Memory of the search, used again by each level.
    pub(super) scratch: &'a mut Scratch,
    /// Told of expansions; it may end the plan between two of them.
    pub(super) progress: &'a mut Option<Progress<'p>>,
}

/// One question at one margin.
///
/// Poses are in the obstacles' coordinates. `root` and `target` are the ends of the tree, `start` and `goal` those of
/// the path: the same two poses, swapped where the search is `mirrored`.
#[derive(Clone, Copy)]
pub(super) struct Search<'a> {
    /// Obstacles, car and poses in world coordinates.
    pub(super) query: &'a Query<'a>,
    /// The settings that are asked for; a level may replace costs and resolution.
    pub(super) config: &'a Config,
    /// Counts all collision checks of the plan.
    pub(super) checker: &'a CollisionChecker<'a>,
    /// The ways around obstacles to `target`, for a disc with the margin of this search.
    pub(super) flood: &'a ObstacleHeuristic,
    /// Where the tree begins.
    pub(super) root: Pose,
    /// Where the tree shall arrive.
    pub(super) target: Pose,
    /// True if the tree grows from the goal.
    pub(super) mirrored: bool,
    pub(super) start: Pose,
    pub(super) goal: Pose,
    /// True if start or goal have little room around them.
    pub(super) tight: bool,
    /// True to keep the search tree and the failed analytic expansions.
    pub(super) trace: bool,
    /// The costs from poses to `target`, where the search is guided by them.
    pub(super) poses: Option<&'a PoseHeuristic>,
    /// Of several goals, those that are searched from at once; `goal` is then the one that the path at hand comes from.
    pub(super) goals: &'a [Pose],
}

impl<'a> Search<'a> {
    /// The same question from the other end.
    pub(super) fn swapped(self, flood: &'a ObstacleHeuristic) -> Self {
        Self { flood, root: self.target, target: self.root, mirrored: !self.mirrored, ..self }
    }

    /// Cost of the path as driven.
    pub(super) fn costs(&self) -> CostModel {
        CostModel::driven(self.config, self.query.vehicle.min_turning_radius(), [self.start, self.goal])
    }

    /// The same question, asked of the one goal at which a path ends.
    pub(super) fn arrived(&self, arcs: &[Arc]) -> Self {
        if IS_COMPLETE && !self.goals.is_empty() {
            return Self { goal: self.goals[nearest(self.goals, arcs::end(self.start, arcs))], ..*self };
        }
        *self
    }

    /// The world position of the local origin.
    pub(super) fn origin(&self) -> Pose {
        let at = self.query.start.point() - self.start.point();
        Pose::new(at.x, at.y, 0.0)
    }

    /// A local pose in world coordinates: shifted by the origin, never turned.
    pub(super) fn world(&self, pose: Pose) -> Pose {
        let origin = self.origin();
        Pose::new(pose.x + origin.x, pose.y + origin.y, pose.heading)
    }
}

/// Which of some goals is nearest to a pose. A radian counts as a metre.
pub(super) fn nearest(goals: &[Pose], to: Pose) -> usize {
    let apart = |goal: &Pose| {
        let turn = math::turn(goal.heading, to.heading);
        (goal.point() - to.point()).norm_squared() + turn * turn
    };
    math::argmin(&goals.iter().map(apart).collect::<Vec<_>>())
}

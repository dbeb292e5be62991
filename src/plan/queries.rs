//! Other ends than the scene's, and the search of a grid planner alone.
//!
//! A planner is prepared for a map, not for one question. Ends are therefore options of a plan; only what depends on
//! them (a risk field, closed dead ends) is made anew. Ends are checked for finite coordinates alone: a start inside a
//! wall or off the map is an outcome, because it can happen to anybody who drags it there.

use super::{Options, Outcome, Plan, Planner};
use crate::IS_COMPLETE;
use crate::error::{Error, ErrorCode};
use crate::geometry::{Point, Pose};
use crate::planners::registry::Family;
use crate::scenario::checks::finite_pose;

/// Start and goal of a plan; a missing one is the scene's.
#[derive(Debug, Clone, Copy, Default)]
pub struct Ends {
    /// Start pose.
    pub start: Option<Pose>,
    /// Goal pose.
    pub goal: Option<Pose>,
}

/// The result of a bare search: cells and counters, without driving, checks and metrics.
#[derive(Debug, Clone)]
pub struct Found {
    /// How it ended.
    pub outcome: Outcome,
    /// Centres of the cells from start to goal, metres: every cell, or the turning points of any-angle paths.
    pub path: Vec<Point>,
    /// The moves' exact cost, millionths of a cell.
    pub cost_micro: i64,
    /// Cells taken from the open list and processed.
    pub expanded: u32,
    /// Distinct cells that entered it.
    pub generated: u32,
}

/// Refuses a pose with a number that is not finite or out of range, by the name of the end.
fn checked(path: &str, pose: Pose) -> Result<Pose, Error> {
    finite_pose(pose).map(|()| pose).map_err(|e| e.within(path).with_code(ErrorCode::Input))
}

impl Planner {
    /// [`Planner::plan`] between other poses than the scene's. Rasters and explanations are between these, too, until
    /// the next plan.
    ///
    /// # Errors
    /// [`ErrorCode::Input`] when a coordinate is not a finite number, within the range of scenes, and when a planner
    /// other than hybrid A* is asked for a choice.
    ///
    /// # Examples
    /// ```
    /// use parkade::geometry::Pose;
    /// use parkade::plan::{Ends, Options, Outcome, Planner};
    ///
    /// let scene = parkade::scenario::catalog::scenario("perpendicular").unwrap();
    /// let mut planner = Planner::new("eight", &scene, &Default::default()).unwrap();
    /// let far = Ends { start: None, goal: Some(Pose::new(-50.0, 0.0, 0.0)) };
    /// assert_eq!(planner.plan_between(far, Options::default()).unwrap().outcome, Outcome::GoalOutside);
    /// let nowhere = Ends { start: Some(Pose::new(f64::NAN, 0.0, 0.0)), goal: None };
    /// assert!(planner.plan_between(nowhere, Options::default()).is_err());
    /// ```
    pub fn plan_between(&mut self, ends: Ends, options: Options) -> Result<Plan, Error> {
        let start = ends.start.map(|pose| checked("start", pose)).transpose()?;
        let goal = ends.goal.map(|pose| checked("goal", pose)).transpose()?;
        if IS_COMPLETE && let Some(choice) = options.choice().filter(|_| self.kind.family() != Family::Hybrid)
        {
            let message = message!("{} finds one path; hybrid has others to choose from", self.kind.id());
            return Err(Error::new(ErrorCode::Input, choice, message));
        }
        Ok(self.between(start.unwrap_or(self.own_ends[0]), goal, options))
    }

    /// Takes over the last path of a hybrid planner of the scene as it was before an edit, for [`Options::stickiness`].
    /// On a map with another floor there is none.
    ///
    /// The old planner gives its path away and plans afterwards as if it had none.
    pub fn continue_from(&mut self, before: &mut Self) {
        if let (Some(last), Some(before_last)) = (self.engine.last(), before.engine.last())
            && self.world.geometry.boundary == before.world.geometry.boundary
        {
            *last = before_last.take();
        }
    }

    /// Takes over the path of a plan of hybrid A* for this scene, as if it were the last one: x, y and heading of its
    /// poses, their gears and curvatures. Other planners take nothing over.
    ///
    /// # Errors
    /// [`ErrorCode::Input`] when the lists do not belong together, and for numbers that are not finite.
    pub fn continue_along(
        &mut self,
        path: &[f64],
        directions: &[i8],
        curvatures: &[f64],
    ) -> Result<(), Error> {
        let wrong = |rule: &'static str| Error::new(ErrorCode::Input, "before", rule);
        let count = path.len() / 3;
        if count == 0 || path.len() != 3 * count || directions.len() != count || curvatures.len() != count {
            return Err(wrong("must have a path, and a direction and a curvature for each of its poses"));
        }
        if path.iter().chain(curvatures).any(|number| !number.is_finite()) {
            return Err(wrong("must be a path without corners, of finite numbers"));
        }
        let poses: Vec<Pose> = path.chunks_exact(3).map(|at| Pose::new(at[0], at[1], at[2])).collect();
        self.engine.continue_along(&poses, directions, curvatures);
        Ok(())
    }

    /// The search of a grid planner between two points, and nothing else: no car follows the path, nothing is checked
    /// or measured. A second search on the same map costs what it touches.
    ///
    /// For many questions on one map, such as a table of distances. The cost is exact in millionths of a cell.
    ///
    /// # Examples
    /// ```
    /// use parkade::plan::Planner;
    ///
    /// let scene = parkade::scenario::catalog::scenario("perpendicular").unwrap();
    /// let mut planner = Planner::new("eight", &scene, &Default::default()).unwrap();
    /// let at = planner.geometry().start.point();
    /// let found = planner.search(at, at).unwrap();
    /// assert_eq!((found.cost_micro, found.path.len()), (0, 1));
    /// ```
    ///
    /// # Errors
    /// [`ErrorCode::Input`] when a coordinate is not a finite number, and for planners other than grid planners.
    pub fn search(&mut self, start: Point, goal: Point) -> Result<Found, Error> {
        let pose = |point: Point| Pose::new(point.x, point.y, 0.0);
        let (start, goal) = (checked("start", pose(start))?, checked("goal", pose(goal))?);
        let Some(report) = self.engine.search(&self.world, [start, goal]) else {
            let message = message!("{} has no bare search; grid planners have", self.kind.id());
            return Err(Error::new(ErrorCode::Input, "", message));
        };
        Ok(Found {
            outcome: report.outcome,
            path: report.cells.iter().map(|&cell| self.world.frame.center(cell)).collect(),
            cost_micro: report.cost_micro,
            expanded: report.stats.expanded,
            generated: report.stats.generated,
        })
    }

    /// Length of the shortest any-angle path between the centres of the last plan's start and goal cells (before any
    /// plan, the scene's), metres, with this grid planner's safety space: what no path over cells is shorter than, but
    /// for rounded corners. `None` where there is no path, and for planners other than grid planners.
    ///
    /// # Examples
    /// ```
    /// let scene = parkade::scenario::catalog::scenario("perpendicular").unwrap();
    /// let mut planner = parkade::plan::Planner::new("eight", &scene, &Default::default()).unwrap();
    /// let plan = planner.plan(Default::default());
    /// let raw = plan.metrics.grid.unwrap().length_raw * scene.map.resolution;
    /// assert!(planner.any_angle_length().unwrap() <= raw + 1e-9);
    /// ```
    pub fn any_angle_length(&self) -> Option<f64> {
        self.engine.any_angle_length(&self.world)
    }
}

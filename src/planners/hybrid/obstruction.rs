//! Finding where it fails.
//!
//! A failed plan that says only "no path" leaves the reader to guess. The place where it fails is usually known from
//! the search itself: a region that the flood could not leave, or a pose from which no arc leads far. These functions
//! put such a place into words and world coordinates. They run only where a plan has failed.

use super::obstacle_heuristic::ObstacleHeuristic;
use super::question::Query;
use crate::geometry::Pose;
use crate::geometry::arcs::Arc;
use crate::planners::{Obstruction, Region};
use crate::vehicle::collision::CollisionChecker;

/// Beyond what stops the car, to see what that is, metres.
const PROBE_DEPTH: f64 = 0.01;

/// The smaller of the regions around start and goal that no way joins; local poses.
/// The region is in world coordinates, as runs of cells; the smaller one is the easier to see, and more often the
/// cause.
pub(super) fn enclosed(query: &Query, [start, goal]: [Pose; 2], margin: f64) -> Obstruction {
    let flood = |pose| ObstacleHeuristic::new(query.obstacles, query.vehicle, pose, margin, None);
    let (from_start, from_goal) = (flood(start), flood(goal));
    let at_start = from_start.reached() <= from_goal.reached();
    let Region { cell, runs } = if at_start { from_start } else { from_goal }.region();
    let shift = query.start.point() - start.point();
    Obstruction::Enclosed {
        at_start,
        region: Region { cell, runs: runs.into_iter().map(|(at, n)| (at + shift, n)).collect() },
    }
}

/// How far the car gets from a local pose that it can hardly leave, and what stops it.
/// At most six pairs of a pose and an obstacle's owner: full lock left, straight, full lock right, ahead and in
/// reverse. Poses are in world coordinates. Directions in which the car gets a whole metre are left out.
pub(super) fn stops(checker: &CollisionChecker, query: &Query, pose: Pose, margin: f64) -> Vec<(Pose, u32)> {
    let limit = query.vehicle.max_curvature();
    let shift = query.start.point() - query.obstacles.local(query.start).point();
    let mut stops = Vec::new();
    for length in [1.0, -1.0] {
        for curvature in [-limit, 0.0, limit] {
            let far = checker.free_length(pose, &Arc { curvature, length }, PROBE_DEPTH, margin);
            let at = |far: f64| pose.advance(curvature, far.copysign(length));
            if let Some(owner) = checker.hit(at(far + PROBE_DEPTH), margin) {
                let end = at(far);
                stops.push((Pose::new(end.x + shift.x, end.y + shift.y, end.heading), owner));
            }
        }
    }
    stops
}

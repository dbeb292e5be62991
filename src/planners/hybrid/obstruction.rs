//! Finding where it fails.

use super::Query;
use super::obstacle_heuristic::ObstacleHeuristic;
use crate::geometry::Pose;
use crate::geometry::arcs::Arc;
use crate::planners::{Obstruction, Region};
use crate::vehicle::collision::CollisionChecker;

/// Beyond what stops the car, to see what that is, metres.
const PROBE_DEPTH: f64 = 0.01;

/// The smaller of the regions around start and goal that no way joins; local poses.
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
pub(super) fn stops(probe: &CollisionChecker, query: &Query, pose: Pose, margin: f64) -> Vec<(Pose, u32)> {
    let limit = query.vehicle.max_curvature();
    let shift = query.start.point() - query.obstacles.local(query.start).point();
    let mut stops = Vec::new();
    for length in [1.0, -1.0] {
        for curvature in [-limit, 0.0, limit] {
            let far = probe.free_length(pose, &Arc { curvature, length }, PROBE_DEPTH, margin);
            let at = |far: f64| pose.advance(curvature, far.copysign(length));
            if let Some(owner) = probe.hit(at(far + PROBE_DEPTH), margin) {
                let end = at(far);
                stops.push((Pose::new(end.x + shift.x, end.y + shift.y, end.heading), owner));
            }
        }
    }
    stops
}

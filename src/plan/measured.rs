//! A path checked and measured: the plan that any planner's path becomes.

use super::outcome::{Metrics, Outcome, Plan, Stats, direction_changes, path_length};
use super::world::World;
use crate::geometry::Pose;
use crate::metrics::check;

/// Poses of a path are this close together, metres.
pub(super) const STEP: f64 = 0.1;
/// How far from the goal a car's path may end, metres.
pub(super) const NEAR: f64 = 1e-3;

/// Poses of a path, whatever made it.
///
/// One item per pose in each column, as in [`Plan`].
#[derive(Debug, Default)]
pub(super) struct Driven {
    pub(super) poses: Vec<Pose>,
    pub(super) directions: Vec<i8>,
    pub(super) curvatures: Vec<f64>,
}

/// The plan of a path, checked and measured.
///
/// `near` is how far from the goal the path may end, metres: a millimetre for a car, a cell for a path of cells.
pub(super) fn measured(world: &World, outcome: Outcome, driven: Driven, near: f64) -> Plan {
    let Driven { poses, directions, curvatures } = driven;
    let check = check(&world.geometry, &world.body, &poses, &directions, near);
    let corner = check.tightest_radius == 0.0;
    let max_curvature = curvatures.iter().filter(|k| !k.is_nan()).fold(0.0_f64, |max, k| max.max(k.abs()));
    let metrics = Metrics {
        length: path_length(&poses),
        direction_changes: direction_changes(&directions),
        max_curvature: (!corner).then_some(max_curvature),
        curvature_limit: world.geometry.vehicle.max_curvature(),
        min_clearance: check.min_clearance,
        mean_clearance: check.mean_clearance,
        weighted_length: world.paint().map(|paint| {
            poses.windows(2).fold(0.0, |sum, pair| sum + paint.along(pair[0].point(), pair[1].point()))
        }),
        grid: None,
        hybrid: None,
        road: None,
    };
    Plan {
        planner: "",
        outcome,
        detail: None,
        reason: None,
        obstruction: None,
        goal: None,
        path: poses,
        directions,
        curvatures,
        raw_path: Vec::new(),
        stats: Stats::default(),
        metrics,
        check,
        trace: None,
        recorded: None,
        member: None,
        stages: None,
        alternatives: Vec::new(),
    }
}

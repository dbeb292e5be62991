//! Plans as JSON, native only: in wasm they leave as typed arrays.
//!
//! The command, the Python package and Rust callers get the same names as JavaScript does, so a plan saved by one can
//! be read by the others. Numbers are written with the digits that give back the same bits. What JSON cannot say is
//! `null`: an infinite radius, a curvature at a corner, a figure that the planner does not have.

use serde::{Serialize, Serializer};

use super::outcome::Detail;
use super::{Metrics, Plan, Stats};
use crate::geometry::Pose;
use crate::scenario::GoalPose;

/// The fields of the JS API's plan, but for its trace and what names things of the scene.
///
/// Optional parts are left out rather than written as `null`, as in the JS API.
#[derive(Serialize)]
#[serde(rename_all = "camelCase")]
struct Fields<'a> {
    planner: &'a str,
    outcome: &'a str,
    detail: Option<&'a str>,
    reason: Option<&'a str>,
    #[serde(skip_serializing_if = "Option::is_none")]
    goal: Option<&'a GoalPose>,
    path: Vec<f64>,
    directions: &'a [i8],
    curvatures: &'a [f64],
    clearances: &'a [f64],
    raw_path: Vec<f64>,
    stats: &'a Stats,
    metrics: &'a Metrics,
    check: Check<'a>,
    #[serde(skip_serializing_if = "Option::is_none")]
    member: Option<super::Member>,
    #[serde(skip_serializing_if = "<[_]>::is_empty")]
    alternatives: &'a [Plan],
    hash: String,
}

/// The verdict and its reasons; clearances are beside the path.
#[derive(Serialize)]
#[serde(rename_all = "camelCase")]
struct Check<'a> {
    verdict: &'a str,
    drivable: bool,
    hits: usize,
    hit_poses: &'a [u32],
    first_hit: Option<Pose>,
    tight_turns: u32,
    slips: u32,
    /// JSON has no infinity.
    tightest_radius: Option<f64>,
    start_heading_error: f64,
    goal_heading_error: f64,
    goal_distance: f64,
}

impl Serialize for Plan {
    /// As the JS API's plan, with its names: `path` is x, y, heading, …, `rawPath` x, y, …. Left out are the trace, and
    /// what names things of the scene (`obstruction`, the obstacle of `check.firstHit`, which is a pose here).
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let check = &self.check;
        Fields {
            planner: self.planner,
            outcome: self.outcome.as_str(),
            detail: self.detail.map(Detail::as_str),
            reason: self.reason.as_deref(),
            goal: self.goal.as_ref(),
            path: self.path.iter().flat_map(|p| [p.x, p.y, p.heading]).collect(),
            directions: &self.directions,
            curvatures: &self.curvatures,
            clearances: &check.clearances,
            raw_path: self.raw_path.iter().flat_map(|p| [p.x, p.y]).collect(),
            stats: &self.stats,
            metrics: &self.metrics,
            check: Check {
                verdict: check.verdict.as_str(),
                drivable: check.drivable(),
                hits: check.hit_poses.len(),
                hit_poses: &check.hit_poses,
                first_hit: check.first_hit.map(|(_, pose)| pose),
                tight_turns: check.tight_turns,
                slips: check.slips,
                tightest_radius: check.tightest_radius.is_finite().then_some(check.tightest_radius),
                start_heading_error: check.start_heading_error,
                goal_heading_error: check.goal_heading_error,
                goal_distance: check.goal_distance,
            },
            member: self.member,
            alternatives: &self.alternatives,
            hash: self.hash(),
        }
        .serialize(serializer)
    }
}

#[cfg(test)]
mod tests {
    use serde_json::Map;

    use crate::plan::{Options, Planner};
    use crate::scenario::catalog;

    #[test]
    fn a_plan_is_json_with_the_names_of_the_js_api() {
        let scene = catalog::scenario("perpendicular").unwrap();
        let plan = Planner::new("hybrid", &scene, &Map::new()).unwrap().plan(Options::default());
        let json = serde_json::to_value(&plan).unwrap();
        assert_eq!(json["outcome"], "found");
        assert_eq!(json["check"]["verdict"], "ok");
        assert_eq!(json["path"].as_array().unwrap().len(), 3 * plan.path.len());
        assert_eq!(json["path"][3 * plan.path.len() - 1].as_f64(), plan.path.last().map(|p| p.heading));
        assert_eq!(json["metrics"]["directionChanges"], plan.metrics.direction_changes);
        assert_eq!(json["hash"], plan.hash());
    }
}

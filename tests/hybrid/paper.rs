//! What the parking paper says of its search: moves, estimate, first connection.

use std::collections::BTreeSet;

use parkade::geometry::{Pose, math};
use parkade::plan::{Options, Outcome, PlanTrace, Planner};
use parkade::planners::hybrid::{Config, Heuristic};
use parkade::scenario::{Goal, catalog};
use parkade::vehicle::Vehicle;
use serde_json::json;

use super::lot::Lot;
use super::rows::MUST_REACH;

/// Figure 7 of the parking paper: the range of steering angles is divided evenly.
#[cfg_attr(target_arch = "wasm32", wasm_bindgen_test::wasm_bindgen_test)]
#[cfg_attr(not(target_arch = "wasm32"), test)]
fn five_steering_angles_in_each_gear_make_the_moves() {
    let step = 1.2;
    let settings = json!({ "steerSamples": 2, "motionPrimitiveLength": step, "firstShot": false });
    let mut moves = BTreeSet::new();
    for id in ["P2", "P4", "L0", "L2"] {
        let scene = catalog::scenario(id).unwrap();
        let mut planner = Planner::new("hybrid-classic", &scene, settings.as_object().unwrap()).unwrap();
        let plan = planner.plan(Options { trace: true, ..Options::default() });
        let Some(PlanTrace::Arcs { arcs, .. }) = plan.trace else { panic!("no trace") };
        moves.extend(arcs.chunks_exact(5).map(|arc| {
            let steer = math::atan2(arc[3] * Vehicle::PAPER.wheelbase, 1.0) / Vehicle::PAPER.max_steer;
            ((steer * 1e6).round() as i64, (arc[4] / step * 1e6).round() as i64)
        }));
    }
    let angles = [-2, -1, 0, 1, 2].map(|k| k * 500_000);
    let expected = [-1_000_000, 1_000_000].into_iter().flat_map(|gear| angles.map(|angle| (angle, gear)));
    assert_eq!(moves, expected.collect());
}

/// Equation 12 of the parking paper, and its first connection that fits.
#[cfg_attr(target_arch = "wasm32", wasm_bindgen_test::wasm_bindgen_test)]
#[cfg_attr(not(target_arch = "wasm32"), test)]
fn the_straight_line_guides_to_the_rows_and_the_first_connection_is_no_shorter() {
    let [mut best, mut straight, mut first] = [0; 3];
    for (id, _, length, changes) in MUST_REACH {
        let lot = Lot::of(id);
        let (shortest, _, report) = lot.solve(id, &Config::default());
        best += report.stats.expanded;
        let config = Config { heuristic: Heuristic::Euclid, ..Config::default() };
        let (got, got_changes, report) = lot.solve(id, &config);
        assert!(got <= length * 1.05 && got_changes <= changes + 1, "{id}: {got} m, {got_changes} changes");
        straight += report.stats.expanded;
        let (got, _, report) = lot.solve(id, &Config { first_shot: true, ..Config::default() });
        assert!(got >= shortest - 0.05, "{id}: {got} m, {shortest} m");
        first += report.stats.expanded;
    }
    println!("expansions: {best}, with the straight line {straight}, to the first connection {first}");
    assert!(straight > best && first < best, "{best} {straight} {first}");
}

/// Where one connection is the whole path, it changes gear no more often than connections may.
#[cfg_attr(target_arch = "wasm32", wasm_bindgen_test::wasm_bindgen_test)]
#[cfg_attr(not(target_arch = "wasm32"), test)]
fn connections_change_gear_no_more_often_than_allowed() {
    let mut scene = catalog::scenario("park-free").unwrap();
    let start = scene.start;
    let mut alone = [0; 4];
    for i in 0..40 {
        let turn = f64::from(i % 8) * 0.8;
        scene.goal =
            Goal::Pose(Pose::new(start.x - 1.5 - f64::from(i / 8), start.y + 2.0, start.heading + turn));
        for (most, alone) in alone.iter_mut().enumerate() {
            let settings = json!({ "maxDirectionChanges": most, "firstShot": true });
            let mut planner = Planner::new("hybrid-classic", &scene, settings.as_object().unwrap()).unwrap();
            let plan = planner.plan(Options::default());
            if plan.outcome == Outcome::Found && plan.stats.expanded <= 1 {
                assert!(plan.metrics.direction_changes as usize <= most, "{turn} {most}: {:?}", plan.metrics);
                *alone += 1;
            }
        }
    }
    assert!(alone[0] < alone[1] && alone[1] < alone[2] && alone[2] <= alone[3], "{alone:?}");
}

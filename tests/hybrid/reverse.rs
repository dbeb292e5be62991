//! The car does not reverse across a whole lot where driving forwards costs a few metres more.

use std::f64::consts::{FRAC_PI_2, PI};

use parkade::geometry::arcs::{self, Arc};
use parkade::plan::{Options, Planner};
use parkade::planners::hybrid::{Config, Profile};
use parkade::scenario::catalog;
use serde_json::Map;

use super::lot::{Lot, ROWS, pose, random_scenes};

fn shortest() -> Config {
    Config { profile: Profile::Shortest, ..Config::default() }
}

fn reversed(path: &[Arc]) -> f64 {
    path.iter().map(|arc| (-arc.length).max(0.0)).sum()
}

/// Metres in reverse more than 10 m from start and goal.
fn far_reversed(lot: &Lot, path: &[Arc]) -> f64 {
    let (start, goal) = (pose(lot.start), pose(lot.goal));
    let points = arcs::sample(start, path, goal, 0.01);
    let far = |at: &parkade::geometry::Pose| {
        [start, goal].iter().all(|end| (at.point() - end.point()).norm() > 10.0)
    };
    let steps = points.windows(2).filter(|step| step[1].gear < 0 && far(&step[1].pose));
    steps.map(|step| (step[1].pose.point() - step[0].pose.point()).norm()).sum()
}

/// A long hall with a bay at its far end; the car faces the bay's end of the hall or the other.
fn hall(length: f64, heading: f64, goal_heading: f64) -> Lot {
    let floor = vec![
        [0.0, 0.0],
        [length - 8.0, 0.0],
        [length - 8.0, -6.0],
        [length - 4.0, -6.0],
        [length - 4.0, 0.0],
        [length, 0.0],
        [length, 14.0],
        [0.0, 14.0],
    ];
    let rear = if goal_heading > 0.0 { -4.6 } else { -1.1 };
    Lot { floor, solids: Vec::new(), start: [8.0, 7.0, heading], goal: [length - 6.0, rear, goal_heading] }
}

#[cfg_attr(target_arch = "wasm32", wasm_bindgen_test::wasm_bindgen_test)]
#[cfg_attr(not(target_arch = "wasm32"), test)]
fn long_halls_are_driven_forwards() {
    let mut spared = 0;
    for length in [90.0, 140.0] {
        for heading in [0.0, 0.4, FRAC_PI_2, PI] {
            for goal in [FRAC_PI_2, -FRAC_PI_2] {
                let lot = hall(length, heading, goal);
                let name = format!("{length} m, from {heading} to {goal}");
                let [before, report] = [shortest(), Config::default()].map(|config| lot.plan(&config));
                lot.check(&name, &report.arcs);
                let [short, metres] = [&before, &report].map(|report| arcs::length(&report.arcs));
                let far = far_reversed(&lot, &report.arcs);
                assert!(far < 12.0, "{name}: {far} m in reverse");
                assert!(metres < short + 15.0, "{name}: {metres} m, shortest {short} m");
                spared += u32::from(reversed(&before.arcs) > reversed(&report.arcs) + 20.0);
            }
        }
    }
    assert!(spared >= 4, "{spared} halls were reversed through");
}

#[cfg_attr(target_arch = "wasm32", wasm_bindgen_test::wasm_bindgen_test)]
#[cfg_attr(not(target_arch = "wasm32"), test)]
fn the_profile_costs_no_path_and_never_more_than_it_saves() {
    let config = Config { max_expansions: Some(3000), ladder: false, ..Config::default() };
    for seed in 0..40 {
        let lot = random_scenes(seed);
        let short = lot.plan(&Config { profile: Profile::Shortest, ..config });
        let report = lot.plan(&config);
        assert_eq!(short.arcs.is_empty(), report.arcs.is_empty(), "seed {seed}");
        if !report.status.is_found() {
            continue;
        }
        lot.check(&format!("seed {seed}"), &report.arcs);
        let far = far_reversed(&lot, &short.arcs);
        let many = arcs::direction_changes(&short.arcs).saturating_sub(2);
        assert!(report.cost <= short.cost + 0.5 * far + 4.0 * f64::from(many) + 0.5, "seed {seed}");
    }
}

#[cfg_attr(target_arch = "wasm32", wasm_bindgen_test::wasm_bindgen_test)]
#[cfg_attr(not(target_arch = "wasm32"), test)]
fn the_papers_rows_are_the_same_in_both_profiles() {
    for id in ROWS {
        let lot = Lot::of(id);
        let [usual, short] = [Config::default(), shortest()].map(|config| lot.plan(&config).arcs);
        let is_same = |(a, b): (&Arc, &Arc)| a.curvature == b.curvature && (a.length - b.length).abs() < 1e-9;
        assert!(
            usual.len() == short.len() && usual.iter().zip(&short).all(is_same),
            "{id}: {usual:?} {short:?}"
        );
    }
}

#[cfg_attr(target_arch = "wasm32", wasm_bindgen_test::wasm_bindgen_test)]
#[cfg_attr(not(target_arch = "wasm32"), test)]
fn no_preset_is_reversed_through() {
    for info in catalog::scenes().filter(|info| info.group != "paper") {
        let scene = catalog::scenario(info.id).unwrap();
        let plan = Planner::new("hybrid", &scene, &Map::new()).unwrap().plan(Options::default());
        let steps = plan.path.windows(2).zip(plan.directions.iter().skip(1)).filter(|step| *step.1 < 0);
        let reversed: f64 = steps.map(|(pair, _)| (pair[1].point() - pair[0].point()).norm()).sum();
        assert!(reversed < 12.0, "{}: {reversed} of {} m in reverse", info.id, plan.metrics.length);
    }
}

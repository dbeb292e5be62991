//! Paths to choose from, and paths held against those of other settings.

use std::ops::ControlFlow;

use parkade::plan::{Ends, Options, Plan, Planner, Prefer, check_path};
use parkade::scenario::Scenario;
use parkade::scenario::catalog::scenario;
use serde_json::{Map, Value, json};

const ROWS: [&str; 6] = ["L0", "L2", "P0", "P4", "perpendicular", "par-7.2"];

fn planner(id: &str, settings: &Value) -> Planner {
    let scene = scenario(id).unwrap();
    let settings: Map<String, Value> = settings.as_object().unwrap().clone();
    Planner::new("hybrid", &scene, &settings).unwrap()
}

fn by<'a>(prefer: Prefer) -> Options<'a> {
    Options { prefer: Some(prefer), ..Options::default() }
}

fn figures(plan: &Plan) -> [f64; 4] {
    let time = plan.metrics.hybrid.as_ref().and_then(|figures| figures.drive_time).unwrap();
    [plan.metrics.length, f64::from(plan.metrics.direction_changes), -plan.metrics.min_clearance, time]
}

fn cost(id: &str, settings: &Value) -> f64 {
    planner(id, settings).plan(Options::default()).metrics.hybrid.unwrap().cost
}

#[cfg_attr(target_arch = "wasm32", wasm_bindgen_test::wasm_bindgen_test)]
#[cfg_attr(not(target_arch = "wasm32"), test)]
fn no_ordinary_path_with_less_margin_has_fewer_changes_than_the_one_with_the_fewest() {
    for id in ROWS {
        let fewest = planner(id, &json!({})).plan(by(Prefer::FewestChanges)).metrics.direction_changes;
        for margin in [0.03, 0.01, 0.002] {
            let close = planner(id, &json!({ "margin": margin })).plan(Options::default());
            let changes = close.metrics.direction_changes;
            assert!(fewest <= changes, "{id}: {fewest}, {changes} with {margin} m");
        }
    }
}

#[cfg_attr(target_arch = "wasm32", wasm_bindgen_test::wasm_bindgen_test)]
#[cfg_attr(not(target_arch = "wasm32"), test)]
fn what_is_preferred_is_no_worse_than_the_ordinary_path_and_no_alternative_beats_it() {
    for id in ROWS {
        let mut planner = planner(id, &json!({}));
        let ordinary = planner.plan(Options::default());
        assert!(
            ordinary.alternatives.is_empty()
                && ordinary.metrics.hybrid.as_ref().unwrap().drive_time.is_none()
        );
        for (at, prefer) in
            [Prefer::Shortest, Prefer::FewestChanges, Prefer::Widest, Prefer::Fastest].into_iter().enumerate()
        {
            let alone = planner.plan(by(prefer));
            let among = planner.plan(Options { alternatives: true, ..by(prefer) });
            assert!(alone.check.drivable() && among.check.drivable(), "{id}");
            assert!(alone.alternatives.is_empty());
            let [mine, best] = [&alone, &among].map(|plan| figures(plan)[at]);
            let theirs = match at {
                0 => ordinary.metrics.length,
                1 => f64::from(ordinary.metrics.direction_changes),
                2 => -ordinary.metrics.min_clearance,
                _ => f64::INFINITY,
            };
            assert!(
                mine <= theirs && best <= mine + 1e-9,
                "{id}, {prefer:?}: {mine}, {best}, ordinary {theirs}"
            );
            for other in &among.alternatives {
                assert!(figures(other)[at] >= best, "{id}, {prefer:?}");
                assert_eq!(other.planner, "hybrid");
            }
        }
    }
}

/// A fine lattice alone, without the estimate's extra weight, by the length and by the ordinary costs.
#[cfg_attr(target_arch = "wasm32", wasm_bindgen_test::wasm_bindgen_test)]
#[cfg_attr(not(target_arch = "wasm32"), test)]
fn no_fine_lattice_alone_has_a_path_much_shorter_than_the_shortest() {
    for id in ["L2", "P4", "perpendicular"] {
        let shortest = planner(id, &json!({})).plan(by(Prefer::Shortest)).metrics.length;
        for change in [0.0, 1.0] {
            let settings = json!({
                "ladder": false, "profile": "shortest", "directionChangeCost": change, "heuristicWeight": 1,
                "xyResolution": 0.1, "headingResolution": 0.0175, "motionPrimitiveLength": 0.15, "steerSamples": 1,
                "maxExpansions": 40_000,
            });
            let alone = planner(id, &settings).plan(Options::default());
            assert!(alone.reason.is_none(), "{id}, {change}: {:?}", alone.reason);
            let length = alone.metrics.length;
            assert!(shortest <= 1.005 * length, "{id}, {change}: {shortest}, {length}");
        }
    }
}

/// Duration of the trajectory that is made of a plan, seconds.
fn trajectory(id: &str, plan: &Plan) -> f64 {
    let path: Vec<f64> = plan.path.iter().flat_map(|p| [p.x, p.y, p.heading]).collect();
    let columns = (&path[..], Some(&plan.directions[..]), Some(&plan.curvatures[..]));
    let options = parkade::optimise::Options::default();
    parkade::plan::optimise(&scenario(id).unwrap(), columns, &options).unwrap().states.duration()
}

#[cfg_attr(target_arch = "wasm32", wasm_bindgen_test::wasm_bindgen_test)]
#[cfg_attr(not(target_arch = "wasm32"), test)]
fn the_fastest_path_is_that_of_the_fastest_trajectory() {
    for id in ROWS {
        let plan = planner(id, &json!({})).plan(Options { alternatives: true, ..by(Prefer::Fastest) });
        for one in &plan.alternatives {
            assert_eq!(figures(one)[3], trajectory(id, one), "{id}");
        }
        assert!(
            figures(&plan)[3] <= trajectory(id, &planner(id, &json!({})).plan(Options::default())),
            "{id}"
        );
        assert_eq!(figures(&plan)[3], trajectory(id, &plan), "{id}");
    }
    let widest = planner("L0", &json!({})).plan(by(Prefer::Widest));
    assert_eq!(figures(&widest)[3], trajectory("L0", &widest));
}

#[cfg_attr(target_arch = "wasm32", wasm_bindgen_test::wasm_bindgen_test)]
#[cfg_attr(not(target_arch = "wasm32"), test)]
fn alternatives_are_a_pareto_set_with_the_answer_in_it() {
    let mut several = 0;
    for id in ROWS {
        let plan = planner(id, &json!({})).plan(Options { alternatives: true, ..Options::default() });
        let all: Vec<[f64; 4]> = plan.alternatives.iter().map(figures).collect();
        assert!(all.contains(&figures(&plan)), "{id}");
        assert!(all.windows(2).all(|pair| pair[0][0] <= pair[1][0]), "{id}: the shortest first");
        for (i, one) in all.iter().enumerate() {
            let beaten = |other: &[f64; 4]| other != one && (0..4).all(|k| other[k] <= one[k]);
            // The answer itself may cost less by the planner's own measure.
            assert!(!all.iter().any(beaten) || *one == figures(&plan), "{id}: {i} of {all:?}");
        }
        assert!(plan.alternatives.iter().all(|one| one.check.drivable() && one.alternatives.is_empty()));
        several += usize::from(all.len() > 1);
    }
    assert!(several >= 3, "{several}");
    // A loop in the open against a gear change.
    let fewest = planner("L2", &json!({})).plan(by(Prefer::FewestChanges));
    assert_eq!(fewest.metrics.direction_changes, 0);
}

#[cfg_attr(target_arch = "wasm32", wasm_bindgen_test::wasm_bindgen_test)]
#[cfg_attr(not(target_arch = "wasm32"), test)]
fn each_improvement_is_told_and_the_first_one_can_be_enough() {
    let mut planner = planner("par-7.2", &json!({}));
    let ordinary = planner.plan(Options::default());
    let mut told = Vec::new();
    let mut improved = |plan: &Plan| {
        told.push(plan.metrics.direction_changes);
        ControlFlow::Continue(())
    };
    let last = planner.plan(Options { improved: Some(&mut improved), ..by(Prefer::FewestChanges) });
    assert_eq!(
        (told[0], told.last()),
        (ordinary.metrics.direction_changes, Some(&last.metrics.direction_changes))
    );
    assert!(told.windows(2).all(|pair| pair[1] <= pair[0]), "{told:?}");
    assert_eq!(last.hash(), planner.plan(by(Prefer::FewestChanges)).hash());
    let mut calls = 0;
    let mut once = |_: &Plan| {
        calls += 1;
        ControlFlow::Break(())
    };
    let first = planner.plan(Options { improved: Some(&mut once), ..by(Prefer::FewestChanges) });
    assert_eq!((calls, first.path), (1, ordinary.path));
}

#[cfg_attr(target_arch = "wasm32", wasm_bindgen_test::wasm_bindgen_test)]
#[cfg_attr(not(target_arch = "wasm32"), test)]
fn planners_with_one_path_refuse_a_choice() {
    let scene = scenario("perpendicular").unwrap();
    let mut eight = Planner::new("eight", &scene, &Map::new()).unwrap();
    let refused = eight.plan_between(Ends::default(), by(Prefer::Widest)).unwrap_err();
    assert_eq!((refused.path.as_str(), refused.message().contains("eight finds one path")), ("prefer", true));
    let wish = Options { alternatives: true, ..Options::default() };
    assert_eq!(eight.plan_between(Ends::default(), wish).unwrap_err().path, "alternatives");
}

#[cfg_attr(target_arch = "wasm32", wasm_bindgen_test::wasm_bindgen_test)]
#[cfg_attr(not(target_arch = "wasm32"), test)]
fn a_price_of_obstacles_and_less_margin_cost_no_more_than_what_other_settings_find() {
    // What the path without the price costs with it.
    for (row, most) in [("L0", 31.74), ("L2", 25.83)] {
        let cost = cost(row, &json!({ "obstacleCost": 1 }));
        assert!(cost <= most * 1.01, "{row}: {cost}");
    }
    assert!(cost("L0", &json!({ "profile": "comfort" })) <= 32.84 * 1.01);
    for id in ROWS {
        let costs = [0.0, 0.02, 0.05, 0.1].map(|margin| cost(id, &json!({ "margin": margin })));
        assert!(costs.windows(2).all(|pair| pair[0] <= pair[1] * 1.01), "{id}: {costs:?}");
    }
}

/// How far a pose of one path is from the other path, at most, metres.
fn strays(one: &Plan, other: &Plan) -> f64 {
    let nearest = |p: &parkade::geometry::Pose| {
        other.path.iter().map(|q| (p.point() - q.point()).norm()).fold(f64::INFINITY, f64::min)
    };
    one.path.iter().map(nearest).fold(0.0, f64::max)
}

#[cfg_attr(target_arch = "wasm32", wasm_bindgen_test::wasm_bindgen_test)]
#[cfg_attr(not(target_arch = "wasm32"), test)]
fn under_the_hand_a_path_changes_sides_only_where_that_saves_its_share() {
    let scene = json!({
        "version": 1,
        "map": { "origin": [0, 0], "width": 72, "height": 52, "resolution": 0.5 },
        "obstacles": [{ "type": "rectangle", "center": [18, 13], "size": [5, 6] }],
        "vehicle": "sedan",
        "start": { "x": 5, "y": 13, "heading": 0 },
        "goal": { "x": 29, "y": 13, "heading": 0 },
    });
    let scene = Scenario::from_json(&scene).unwrap();
    let dragged = |stickiness: f64| {
        let mut planner = Planner::new("hybrid", &scene, &Map::new()).unwrap();
        let (mut idle, mut worth, mut last): (u32, u32, Option<Plan>) = (0, 0, None);
        for step in 0..120 {
            // To and fro across the middle.
            let y = 13.0
                + 1.5 * parkade::geometry::math::sin(f64::from(step) * 0.21)
                + 0.015 * f64::from(step) / 2.0;
            let start = parkade::geometry::Pose::new(5.0, y, 0.0);
            let ends = Ends { start: Some(start), goal: None };
            let plan = planner.plan_between(ends, Options { stickiness, ..Options::default() }).unwrap();
            assert!(plan.check.drivable());
            if let Some(last) = &last
                && strays(&plan, last) > 2.0
            {
                let ratio = plan.metrics.length / last.metrics.length;
                if (0.97..1.03).contains(&ratio) { idle += 1 } else { worth += 1 }
            }
            last = Some(plan);
        }
        (idle, worth)
    };
    let (loose, _) = dragged(0.0);
    let (idle, worth) = dragged(0.05);
    println!("flips without: {loose}, with: {idle} idle, {worth} worth it");
    assert!(loose >= 4 && idle == 0, "{loose}, {idle}");
    let mut planner = Planner::new("hybrid", &scene, &Map::new()).unwrap();
    let alone = planner.plan(Options::default()).hash();
    planner
        .plan_between(
            Ends { start: Some(parkade::geometry::Pose::new(5.0, 16.0, 0.0)), goal: None },
            Options::default(),
        )
        .unwrap();
    assert_eq!(
        planner.plan(Options::default()).hash(),
        alone,
        "without it a plan does not depend on the one before"
    );
}

/// A lot with an island in the way from one side to the other, and something beside it.
fn island(beside: &Value) -> Scenario {
    let scene = json!({
        "version": 1,
        "map": { "origin": [0, 0], "width": 72, "height": 52, "resolution": 0.5 },
        "obstacles": [{ "type": "rectangle", "center": [18, 12.9], "size": [5, 6] }, beside],
        "vehicle": "sedan",
        "start": { "x": 5, "y": 13, "heading": 0 },
        "goal": { "x": 29, "y": 13, "heading": 0 },
    });
    Scenario::from_json(&scene).unwrap()
}

fn around(beside: &Value) -> Planner {
    Planner::new("hybrid", &island(beside), &Map::new()).unwrap()
}

fn post(x: f64, y: f64) -> Value {
    json!({ "type": "rectangle", "center": [x, y], "size": [1, 1] })
}

/// How far a post stands out of the island's far side where both ways around are about as good.
fn balance() -> f64 {
    let is_beyond = |y: f64| {
        let plan = around(&post(18.0, y)).plan(Options::default());
        let middle = plan.path.iter().find(|pose| pose.x >= 18.0).unwrap();
        middle.y > 12.9
    };
    let (mut low, mut high) = (14.0, 18.0);
    assert!(is_beyond(low) && !is_beyond(high));
    for _ in 0..12 {
        let middle = f64::midpoint(low, high);
        *if is_beyond(middle) { &mut low } else { &mut high } = middle;
    }
    f64::midpoint(low, high)
}

#[cfg_attr(target_arch = "wasm32", wasm_bindgen_test::wasm_bindgen_test)]
#[cfg_attr(not(target_arch = "wasm32"), test)]
fn while_an_obstacle_is_dragged_a_path_stays_where_the_other_side_becomes_a_little_shorter() {
    let balance = balance();
    // The post moves into the island's far side and out of it.
    let dragged = |stickiness: f64| {
        let (mut idle, mut before): (u32, Option<(Planner, Plan)>) = (0, None);
        for step in 0..60 {
            let y = balance + 0.2 * parkade::geometry::math::cos(f64::from(step) * 0.42);
            let mut planner = around(&post(18.0, y));
            if let Some((last, _)) = &mut before {
                planner.continue_from(last);
            }
            let plan = planner.plan(Options { stickiness, ..Options::default() });
            assert!(plan.check.drivable());
            if let Some((_, last)) = &before
                && strays(&plan, last) > 2.0
            {
                idle += u32::from((0.97..1.03).contains(&(plan.metrics.length / last.metrics.length)));
            }
            before = Some((planner, plan));
        }
        idle
    };
    let (loose, idle) = (dragged(0.0), dragged(0.05));
    println!("balance: {balance}, idle flips without: {loose}, with: {idle}");
    assert!(loose > 0 && idle == 0, "{loose}, {idle}");
}

#[cfg_attr(target_arch = "wasm32", wasm_bindgen_test::wasm_bindgen_test)]
#[cfg_attr(not(target_arch = "wasm32"), test)]
fn a_path_that_is_taken_over_keeps_the_margin_among_the_new_obstacles_or_goes() {
    let sticky = || Options { stickiness: 1.0, ..Options::default() };
    let far = post(0.5, 0.5);
    let last = around(&far).plan(sticky());
    let path: Vec<f64> = last.path.iter().flat_map(|pose| [pose.x, pose.y, pose.heading]).collect();
    let middle = last.path[last.path.len() / 2];
    let (mut stayed, mut went) = (0, 0);
    // From well beside the last path to where its middle is.
    for step in 0..30 {
        let beside = post(middle.x, middle.y + 3.0 - 0.1 * f64::from(step));
        let room = check_path(&island(&beside).geometry().unwrap(), &path, Some(&last.directions))
            .unwrap()
            .min_clearance;
        let ordinary = around(&beside).plan(Options::default());
        let margin = ordinary.metrics.hybrid.unwrap().margin.min(ordinary.metrics.min_clearance);
        let (mut before, mut planner) = (around(&far), around(&beside));
        before.plan(sticky());
        planner.continue_from(&mut before);
        let plan = planner.plan(sticky());
        assert!(plan.check.drivable() && plan.metrics.min_clearance >= margin - 1e-6, "{step}");
        let keeps = room >= margin - 1e-6;
        assert!(plan.path == last.path || !keeps, "{step}: {room} of {margin}");
        *if plan.path == last.path { &mut stayed } else { &mut went } += 1;
    }
    assert!(stayed > 0 && went > 0, "{stayed} {went}");
    // Other planners take nothing over.
    let scene = scenario("perpendicular").unwrap();
    let mut grid = Planner::new("eight", &scene, &Map::new()).unwrap();
    let alone = grid.plan(Options::default()).hash();
    grid.continue_from(&mut around(&far));
    assert_eq!(grid.plan(Options::default()).hash(), alone);
}

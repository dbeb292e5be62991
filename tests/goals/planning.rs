//! Which goal is taken, and what is said where none can be.

use std::f64::consts::PI;
use std::ops::ControlFlow;

use parkade::geometry::{Pose, math};
use parkade::plan::{Ends, Options, Outcome, Plan, Planner, Prefer, check_path};
use parkade::planners::registry::planners;
use parkade::scenario::{Entry, GoalPose, HEADING_TOLERANCE, Scenario};
use serde_json::{Map, Value, json};

/// An aisle along y = 6 … 12 with slots below it: a, b, c, d from west to east. `b` is taken.
fn aisle(goal: &Value) -> Scenario {
    let slot = |(i, id): (usize, &&str)| {
        json!({ "id": id, "kind": "perpendicular", "x": 10.0 + 8.0 * i as f64, "y": 6.0, "heading": -PI / 2.0,
            "width": 3.0, "length": 5.5, "occupied": *id == "b" })
    };
    let slots: Vec<Value> = ["a", "b", "c", "d"].iter().enumerate().map(slot).collect();
    Scenario::from_json(&json!({
        "version": 1,
        "map": { "origin": [0.0, 0.0], "width": 88, "height": 26, "resolution": 0.5 },
        "obstacles": [{ "type": "wall", "id": "kerb", "points": [[38.0, 0.0], [38.0, 5.5]] }],
        "slots": slots,
        "vehicle": "sedan",
        "start": { "x": 12.0, "y": 9.0, "heading": 0.0 },
        "goal": goal,
    }))
    .unwrap()
}

fn planned(id: &str, scene: &Scenario) -> Plan {
    Planner::new(id, scene, &Map::new()).unwrap().plan(Options::default())
}

fn taken(plan: &Plan) -> &GoalPose {
    plan.goal.as_ref().unwrap_or_else(|| panic!("{}: {:?} {:?}", plan.planner, plan.outcome, plan.reason))
}

const HYBRIDS: [&str; 4] = ["hybrid", "hybrid-forward", "hybrid-bidirectional", "hybrid-classic"];

#[cfg_attr(target_arch = "wasm32", wasm_bindgen_test::wasm_bindgen_test)]
#[cfg_attr(not(target_arch = "wasm32"), test)]
fn a_free_slot_is_taken_and_the_path_ends_in_it() {
    let scene = aisle(&json!({ "slots": "free", "entry": "either" }));
    for id in HYBRIDS {
        let plan = planned(id, &scene);
        let goal = taken(&plan);
        assert!(goal.slot.as_deref().is_some_and(|slot| slot != "b"), "{id}");
        assert_eq!(scene.slots[goal.index].id, goal.slot);
        assert_eq!(
            scene.slots[goal.index].pose(goal.entry.unwrap(), &parkade::vehicle::Vehicle::SEDAN),
            goal.pose
        );
        let last = *plan.path.last().unwrap();
        assert!((last.point() - goal.pose.point()).norm() < 1e-3, "{id}");
        assert_eq!(plan.check.verdict.as_str(), "ok", "{id}");
    }
}

#[cfg_attr(target_arch = "wasm32", wasm_bindgen_test::wasm_bindgen_test)]
#[cfg_attr(not(target_arch = "wasm32"), test)]
fn named_slots_and_the_entry_asked_for_are_kept_to() {
    for (entry, expected) in [("head-in", Entry::HeadIn), ("reverse-in", Entry::ReverseIn)] {
        let plan = planned("hybrid", &aisle(&json!({ "slots": ["b", "d"], "entry": entry })));
        let goal = taken(&plan);
        assert_eq!((goal.slot.as_deref(), goal.index, goal.entry), (Some("d"), 3, Some(expected)));
    }
}

#[cfg_attr(target_arch = "wasm32", wasm_bindgen_test::wasm_bindgen_test)]
#[cfg_attr(not(target_arch = "wasm32"), test)]
fn every_planner_takes_the_cheapest_of_some_poses() {
    let poses = [(40.0, 9.0), (20.0, 9.0), (38.0, 2.0), (30.0, 9.0)];
    let list: Vec<Value> = poses.iter().map(|(x, y)| json!({ "x": x, "y": y, "heading": 0.0 })).collect();
    let scene = aisle(&json!(list));
    for info in planners() {
        let mut planner = Planner::new(info.id, &scene, &Map::new()).unwrap();
        let plan = planner.plan(Options::default());
        assert_eq!((taken(&plan).index, taken(&plan).pose.x), (1, 20.0), "{}", info.id);
        let alone = planner
            .plan_between(Ends { start: None, goal: Some(Pose::new(20.0, 9.0, 0.0)) }, Options::default());
        let [any, alone] = [&plan, &alone.unwrap()].map(|plan| plan.metrics.length);
        assert!((any - alone).abs() < 1e-9, "{}: {any} and {alone}", info.id);
    }
}

/// What is preferred, the less the better.
fn figure(plan: &Plan, prefer: Prefer) -> f64 {
    match prefer {
        Prefer::Shortest => plan.metrics.length,
        Prefer::FewestChanges => f64::from(plan.metrics.direction_changes),
        Prefer::Widest => -plan.metrics.min_clearance,
        Prefer::Fastest => plan.metrics.hybrid.as_ref().unwrap().drive_time.unwrap(),
    }
}

#[cfg_attr(target_arch = "wasm32", wasm_bindgen_test::wasm_bindgen_test)]
#[cfg_attr(not(target_arch = "wasm32"), test)]
fn what_is_preferred_chooses_among_the_goals_too() {
    let slots = aisle(&json!({ "slots": "free", "entry": "either" })).slots;
    let slot = |at: usize, entry| slots[at].pose(entry, &parkade::vehicle::Vehicle::SEDAN);
    let goals = [
        Pose::new(18.0, 8.0, PI),
        slot(2, Entry::HeadIn),
        slot(3, Entry::ReverseIn),
        Pose::new(36.0, 9.0, 0.0),
    ];
    let poses: Vec<Value> =
        goals.iter().map(|pose| json!({ "x": pose.x, "y": pose.y, "heading": pose.heading })).collect();
    let mut planner = Planner::new("hybrid", &aisle(&json!(poses)), &Map::new()).unwrap();
    for prefer in [Prefer::Shortest, Prefer::FewestChanges, Prefer::Widest, Prefer::Fastest] {
        let wish = || Options { prefer: Some(prefer), ..Options::default() };
        let mut improved = |plan: &Plan| {
            assert_eq!(plan.goal.as_ref().map(|goal| goal.pose), plan.path.last().copied());
            ControlFlow::Continue(())
        };
        let any = planner.plan(Options { improved: Some(&mut improved), ..wish() });
        let singles = goals.map(|pose| {
            let plan = planner.plan_between(Ends { start: None, goal: Some(pose) }, wish()).unwrap();
            assert_eq!(plan.outcome, Outcome::Found, "{pose:?}");
            plan
        });
        let best = singles.iter().map(|plan| figure(plan, prefer)).fold(f64::INFINITY, f64::min);
        let mine = figure(&any, prefer);
        assert!(mine <= best + 0.05 * best.abs(), "{prefer:?}: {mine}, of single goals {best}");
        assert!(any.check.drivable());
        assert_eq!(any.goal.as_ref().map(|goal| goal.pose), any.path.last().copied());
    }
    let plan = planner.plan(Options { alternatives: true, ..Options::default() });
    for one in &plan.alternatives {
        assert_eq!(one.goal.as_ref().map(|goal| goal.pose), one.path.last().copied());
    }
}

#[cfg_attr(target_arch = "wasm32", wasm_bindgen_test::wasm_bindgen_test)]
#[cfg_attr(not(target_arch = "wasm32"), test)]
fn a_single_goal_in_a_list_gives_the_plan_of_that_goal() {
    let pose = json!({ "x": 30.0, "y": 8.0, "heading": 0.3 });
    for info in planners() {
        let [one, list] = [&pose, &json!([pose])].map(|goal| planned(info.id, &aisle(goal)));
        assert_eq!((one.hash(), one.goal), (list.hash(), None), "{}", info.id);
        assert_eq!(list.goal.unwrap().index, 0);
    }
}

#[cfg_attr(target_arch = "wasm32", wasm_bindgen_test::wasm_bindgen_test)]
#[cfg_attr(not(target_arch = "wasm32"), test)]
fn a_car_leaves_its_slot_for_a_region() {
    let region = [[6.0, 6.2], [40.0, 6.2], [40.0, 12.8], [6.0, 12.8]];
    for heading in [None, Some(0.0), Some(PI)] {
        let mut scene = aisle(&json!({ "region": region, "heading": heading }));
        scene.start = scene.slots[2].pose(Entry::HeadIn, &parkade::vehicle::Vehicle::SEDAN);
        for id in HYBRIDS {
            let plan = planned(id, &scene);
            let (goal, last) = (taken(&plan), *plan.path.last().unwrap());
            assert_eq!((goal.index, &goal.slot, goal.entry), (0, &None, None));
            for corner in parkade::vehicle::Vehicle::SEDAN.outline(last) {
                assert!(
                    (6.0..=40.0).contains(&corner.x) && (6.2 - 1e-3..=12.8 + 1e-3).contains(&corner.y),
                    "{id}"
                );
            }
            let turned = heading.map_or(0.0, |heading| math::turn(heading, last.heading).abs());
            assert!(turned <= HEADING_TOLERANCE + 1e-3, "{id}: {turned}");
            assert!(plan.metrics.length < 16.0, "{id}: {}", plan.metrics.length);
            assert_eq!(plan.check.verdict.as_str(), "ok", "{id}");
        }
    }
}

#[cfg_attr(target_arch = "wasm32", wasm_bindgen_test::wasm_bindgen_test)]
#[cfg_attr(not(target_arch = "wasm32"), test)]
fn goals_that_nothing_can_meet_are_blocked_for_a_reason() {
    let why = |goal: Value| {
        let plan = planned("hybrid", &aisle(&goal));
        assert_eq!((plan.goal, plan.path.len()), (None, 0));
        (plan.outcome, plan.reason.unwrap())
    };
    let (outcome, reason) = why(json!({ "slots": ["b"], "entry": "either" }));
    assert_eq!(
        (outcome, &reason[..]),
        (Outcome::GoalBlocked, "None of the goal's slots is free. Free one, or name another.")
    );
    let (outcome, reason) = why(json!({ "region": [[20, 7], [24, 7], [24, 11]] }));
    assert_eq!(
        (outcome, &reason[..]),
        (Outcome::GoalBlocked, "The car does not fit into the goal's region. Make the region larger.")
    );
    let (outcome, reason) =
        why(json!([{ "x": 38, "y": 3, "heading": 0 }, { "x": 99, "y": 3, "heading": 0 }]));
    assert_eq!(outcome, Outcome::GoalBlocked);
    assert_eq!(
        reason,
        "No path to any goal. At (38.00, 3.00): The car overlaps kerb at the goal. Move one of them."
    );
    for info in planners() {
        let plan = planned(
            info.id,
            &aisle(&json!([{ "x": 99, "y": 3, "heading": 0 }, { "x": 98, "y": 3, "heading": 0 }])),
        );
        assert!(matches!(plan.outcome, Outcome::GoalBlocked | Outcome::GoalOutside), "{}", info.id);
    }
}

/// Goals behind a wall, of which only the last is open.
#[cfg_attr(target_arch = "wasm32", wasm_bindgen_test::wasm_bindgen_test)]
#[cfg_attr(not(target_arch = "wasm32"), test)]
fn a_goal_that_cannot_be_reached_leaves_the_others() {
    let pose = |x: f64| json!({ "x": x, "y": 9.0, "heading": 0.0 });
    let mut scene = aisle(&json!([pose(30.0), pose(34.0), pose(4.0)]));
    let wall = json!({ "type": "wall", "points": [[24.0, 0.0], [24.0, 13.0]] });
    let mut value = serde_json::to_value(&scene).unwrap();
    value["obstacles"].as_array_mut().unwrap().push(wall);
    scene = Scenario::from_json(&value).unwrap();
    for info in planners() {
        assert_eq!(taken(&planned(info.id, &scene)).index, 2, "{}", info.id);
    }
    value["goal"].as_array_mut().unwrap().pop();
    scene = Scenario::from_json(&value).unwrap();
    for info in planners() {
        let plan = planned(info.id, &scene);
        let reason = plan.reason.unwrap();
        // Random trees and generations never know that there is no path.
        let is_random = ["rrt", "genetic"].contains(&info.id);
        let outcome = if is_random { Outcome::BudgetSpent } else { Outcome::NoPath };
        assert_eq!((plan.outcome, plan.goal), (outcome, None), "{}: {reason}", info.id);
        if is_random {
            continue;
        }
        assert!(reason.starts_with("No path to any goal. At (3"), "{}: {reason}", info.id);
    }
}

#[cfg_attr(target_arch = "wasm32", wasm_bindgen_test::wasm_bindgen_test)]
#[cfg_attr(not(target_arch = "wasm32"), test)]
fn paths_are_checked_against_the_nearest_goal() {
    let check = |goal: &Value, x: f64| {
        let path = [12.0, 9.0, 0.0, x, 9.0, 0.0];
        check_path(&aisle(goal).geometry().unwrap(), &path, None).unwrap()
    };
    let pose = |x: f64| json!({ "x": x, "y": 9.0, "heading": 0.0 });
    let list = json!([pose(20.0), pose(30.0)]);
    assert_eq!((check(&list, 30.0).verdict.as_str(), check(&list, 30.0).goal_distance), ("ok", 0.0));
    let short = check(&list, 28.0);
    assert_eq!((short.verdict.as_str(), short.goal_distance), ("arrives-turned", 2.0));
    let region = json!({ "region": [[20, 6], [33, 6], [33, 12], [20, 12]] });
    // Between the sample's poses.
    assert_eq!(check(&region, 24.123).verdict.as_str(), "ok");
    assert_ne!(check(&region, 18.0).verdict.as_str(), "ok");
    let none = json!({ "slots": ["b"], "entry": "either" });
    assert_eq!(check(&none, 30.0).verdict.as_str(), "arrives-turned");
}

#[cfg_attr(target_arch = "wasm32", wasm_bindgen_test::wasm_bindgen_test)]
#[cfg_attr(not(target_arch = "wasm32"), test)]
fn progress_counts_all_searches_and_can_stop_them() {
    let pose = |x: f64, y: f64| json!({ "x": x, "y": y, "heading": 0.0 });
    let scene = aisle(&json!([pose(30.0, 9.0), pose(34.0, 9.0), pose(40.0, 3.0)]));
    for info in planners() {
        let mut told = Vec::new();
        let mut tell = |count: u32| {
            told.push(count);
            ControlFlow::Continue(())
        };
        let mut planner = Planner::new(info.id, &scene, &Map::new()).unwrap();
        let plan = planner.plan(Options { trace: false, progress: Some(&mut tell), ..Options::default() });
        assert!(told.is_sorted(), "{}: {told:?}", info.id);
        assert_eq!(told.last(), Some(&plan.stats.expanded), "{}", info.id);
        assert_eq!(plan.hash(), planner.plan(Options::default()).hash(), "{}", info.id);
    }
}

/// The goal with less room lowers the margin of the common search, but not of a path to another goal.
#[cfg_attr(target_arch = "wasm32", wasm_bindgen_test::wasm_bindgen_test)]
#[cfg_attr(not(target_arch = "wasm32"), test)]
fn a_tight_goal_takes_no_margin_from_the_others() {
    let scene =
        aisle(&json!([{ "x": 24.0, "y": 9.0, "heading": 0.0 }, { "x": 30.0, "y": 1.0, "heading": 0.0 }]));
    let plan = planned("hybrid", &scene);
    assert_eq!(taken(&plan).index, 0);
    assert_eq!(plan.metrics.hybrid.unwrap().margin, 0.1);
}

/// Of two goals with little room the common search keeps what the tighter one has, and so does its answer: the goal
/// that is taken could be reached with 1 cm by itself, as the tail swings towards the wall.
#[cfg_attr(target_arch = "wasm32", wasm_bindgen_test::wasm_bindgen_test)]
#[cfg_attr(not(target_arch = "wasm32"), test)]
fn a_tighter_goal_takes_no_margin_from_a_tight_one() {
    let pose = |x: f64, y: f64, heading: f64| json!({ "x": x, "y": y, "heading": heading });
    let half = parkade::vehicle::Vehicle::SEDAN.width / 2.0;
    let goals = [pose(39.0, 9.0, PI), pose(28.0, half + 0.06, 0.0), pose(32.0, half + 0.02, 0.0)];
    let scene = aisle(&json!(goals));
    let plan = planned("hybrid", &scene);
    let margin = plan.metrics.hybrid.as_ref().unwrap().margin;
    assert_eq!((taken(&plan).index, plan.check.verdict.as_str()), (1, "ok"));
    assert!(margin >= 0.02 - 1e-6 && plan.metrics.min_clearance >= margin - 1e-6, "{margin}");
}

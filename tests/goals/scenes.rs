//! What scenes may say of their goals.

use parkade::geometry::Pose;
use parkade::plan::{Ends, Options, Planner};
use parkade::scenario::{Goal, Scenario};
use serde_json::{Map, Value, json};

use super::lots::lot;

fn with_goal(goal: &Value) -> Result<Scenario, String> {
    let mut scene = serde_json::to_value(lot(1, 5)).unwrap();
    scene["goal"] = goal.clone();
    Scenario::from_json(&scene).map_err(|error| error.to_string())
}

#[cfg_attr(target_arch = "wasm32", wasm_bindgen_test::wasm_bindgen_test)]
#[cfg_attr(not(target_arch = "wasm32"), test)]
fn every_set_survives_a_round_trip() {
    for goal in [
        json!({ "slots": "free", "entry": "either" }),
        json!({ "slots": ["slot-1", "slot-7"], "entry": "head-in" }),
        json!([{ "x": 9.0, "y": 9.0, "heading": 0.5 }]),
        json!({ "region": [[0.0, 0.0], [9.0, 0.0], [9.0, 9.0]] }),
        json!({ "region": [[0.0, 0.0], [9.0, 0.0], [9.0, 9.0]], "heading": 1.5 }),
    ] {
        let scene = with_goal(&goal).unwrap();
        assert!(matches!(scene.goal, Goal::Set(_)));
        let written = serde_json::to_value(&scene).unwrap();
        assert_eq!(written["goal"], goal);
        assert_eq!(Scenario::from_json(&written).unwrap(), scene);
    }
}

#[cfg_attr(target_arch = "wasm32", wasm_bindgen_test::wasm_bindgen_test)]
#[cfg_attr(not(target_arch = "wasm32"), test)]
fn what_is_wrong_with_a_set_is_said_by_field_value_and_rule() {
    let cases = [
        (json!([]), "goal: must have 1 to 1000 items, got 0"),
        (json!([{ "x": 1, "y": 2, "heading": 0 }, { "x": 1, "y": 2 }]), "goal[1].heading: missing field"),
        (json!([{ "x": 1e99, "y": 2, "heading": 0 }]), "goal[0].x: must be finite, within"),
        (json!({ "slots": [], "entry": "either" }), "goal.slots: must have 1 to 1000 items, got 0"),
        (
            json!({ "slots": "all", "entry": "either" }),
            "goal.slots: must be \"free\" or a list of slots' ids, got \"all\"",
        ),
        (
            json!({ "slots": ["slot-1", "x"], "entry": "either" }),
            "goal.slots[1]: must be the id of a slot, got \"x\"",
        ),
        (
            json!({ "slots": ["slot-1", "slot-2", "slot-1"], "entry": "either" }),
            "goal.slots[2]: must be named once, got \"slot-1\" again",
        ),
        (json!({ "slots": "free" }), "goal.entry: missing field"),
        (
            json!({ "slots": "free", "entry": "sideways" }),
            "goal.entry: must be either or reverse-in or head-in, got \"sideways\"",
        ),
        (
            json!({ "slots": "free", "entry": "either", "x": 1 }),
            "goal.x: unknown field; there are slots, entry",
        ),
        (json!({ "region": [[0, 0], [9, 0]] }), "goal.region: must have 3 to 2000 points, got 2"),
        (
            json!({ "region": [[0, 0], [9, 9], [9, 0], [0, 9]] }),
            "goal.region: must not cross itself: edges 0 and 2 meet",
        ),
        (json!({ "region": [[0, 0], [9, 0], [9, 9]], "heading": "east" }), "goal.heading: must be a number"),
    ];
    for (goal, expected) in cases {
        let got = with_goal(&goal).unwrap_err();
        assert!(got.starts_with(expected), "{got}\nis not\n{expected}");
    }
}

#[cfg_attr(target_arch = "wasm32", wasm_bindgen_test::wasm_bindgen_test)]
#[cfg_attr(not(target_arch = "wasm32"), test)]
fn one_goal_asked_for_takes_the_place_of_the_set() {
    let scene = lot(1, 5);
    let mut planner = Planner::new("hybrid", &scene, &Map::new()).unwrap();
    let goal = Pose { x: scene.start.x + 4.0, ..scene.start };
    let ends = Ends { start: None, goal: Some(goal) };
    let plan = planner.plan_between(ends, Options::default()).unwrap();
    assert_eq!((plan.goal, plan.path.last().map(|pose| pose.x)), (None, Some(goal.x)));
    assert!(planner.plan(Options::default()).goal.is_some());
    let goal = Goal::Set(match scene.goal.clone() {
        Goal::Set(set) => set,
        _ => panic!("a set"),
    });
    assert_eq!(
        scene.goal_pose(&goal).unwrap_err().to_string(),
        "must be one pose or slot, got a set of goals"
    );
}

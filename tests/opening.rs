//! The page's first scene shows what sets its four planners apart.

use parkade::geometry::Pose;
use parkade::metrics::Verdict;
use parkade::plan::{Options, Outcome, Plan, PlanTrace, Planner};
use parkade::scenario::resolve::Owner;
use parkade::scenario::{Obstacle, Scenario, SlotKind, catalog};
use parkade::vehicle::Vehicle;
use serde_json::Map;

#[cfg(target_arch = "wasm32")]
use wasm_bindgen_test::wasm_bindgen_test as test;

/// Between the goal and the middle of its cell.
const NEAR: f64 = 1e-9;
/// Numbers per arc of a search tree: x, y, heading, curvature, signed length.
const ARC_FIELDS: usize = 5;

fn scene() -> Scenario {
    catalog::scenario("perpendicular").unwrap()
}

fn plan(planner: &str) -> Plan {
    let options = Options { trace: true, ..Options::default() };
    Planner::new(planner, &scene(), &Map::new()).unwrap().plan(options)
}

fn first_hit(plan: &Plan) -> Owner {
    plan.check.first_hit.unwrap().0
}

#[test]
fn four_directions_hit_the_planter_and_eight_a_parked_car() {
    let (four, eight) = (plan("four"), plan("eight"));
    assert_eq!(four.check.verdict, Verdict::Collides);
    let Owner::Obstacle(planter) = first_hit(&four) else { panic!("{:?}", four.check.first_hit) };
    assert!(
        matches!(&scene().obstacles[planter], Obstacle::Polygon { id, .. } if id.as_deref() == Some("planter"))
    );
    assert_eq!(eight.check.verdict, Verdict::Collides);
    let Owner::Slot(bay) = first_hit(&eight) else { panic!("{:?}", eight.check.first_hit) };
    assert!(scene().slots[bay].occupied);
}

#[test]
fn the_risk_field_can_be_driven_and_arrives_tail_in() {
    let plan = plan("risk-field");
    assert_eq!(plan.check.verdict, Verdict::ArrivesTurned);
    assert!(plan.check.drivable());
    assert!(plan.check.goal_heading_error.to_degrees() > 150.0, "{}", plan.check.goal_heading_error);
}

#[test]
fn hybrid_parks_with_one_gear_change_after_a_search_worth_watching() {
    let plan = plan("hybrid");
    assert_eq!(plan.check.verdict, Verdict::Ok);
    assert_eq!(plan.metrics.direction_changes, 1);
    let Some(PlanTrace::Arcs { arcs, .. }) = &plan.trace else { panic!("no search tree") };
    let count = arcs.len() / ARC_FIELDS;
    assert!((30..=300).contains(&count), "{count}");
}

#[test]
fn every_planner_ends_at_the_goal() {
    let geometry = scene().geometry().unwrap();
    for planner in ["four", "eight", "risk-field", "hybrid", "hybrid-classic"] {
        let plan = plan(planner);
        assert_eq!(plan.outcome, Outcome::Found, "{planner}");
        let end: &Pose = plan.path.last().unwrap();
        assert!((end.point() - geometry.goal.point()).norm() < NEAR, "{planner}: {end:?}");
    }
}

#[test]
fn bays_fit_the_car() {
    let (scene, car) = (scene(), Vehicle::PAPER);
    assert_eq!(scene.slots.len(), 6);
    assert_eq!(scene.slots.iter().filter(|slot| slot.occupied).count(), 4);
    for slot in scene.slots {
        assert_eq!(slot.kind, SlotKind::Perpendicular);
        assert!(slot.length >= car.length() + 0.5 && slot.width >= car.width + 0.6);
    }
}

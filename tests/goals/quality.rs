//! One search for many goals against one plan for each of them, on lots by seed.

use parkade::geometry::Pose;
use parkade::plan::{Ends, Options, Plan, Planner, Prefer};
use parkade::scenario::{GoalPose, Scenario};
use serde_json::{Map, json};

use super::lots::{Random, lot};

/// Twenty plans a lot take their time without optimization.
const LOTS: u64 = if cfg!(debug_assertions) { 20 } else { 100 };
/// So many more may be dearer by chance where the lots are few.
const BY_CHANCE: u64 = if cfg!(debug_assertions) { 1 } else { 0 };

fn cost(plan: &Plan) -> f64 {
    plan.metrics.hybrid.as_ref().map_or(f64::INFINITY, |hybrid| hybrid.cost)
}

fn alone(planner: &mut Planner, goal: &GoalPose) -> Plan {
    planner.plan_between(Ends { start: None, goal: Some(goal.pose) }, Options::default()).unwrap()
}

/// Ten free slots, each of which may be entered either way: as cheap as the best of twenty plans, within a twentieth,
/// on 95 % of the lots; and no dearer than the plan for the goal that is taken, within a hundredth, but for one lot in
/// fifty: a single goal is searched with less weight on the estimate.
#[test]
fn the_cheapest_of_ten_slots_is_taken_at_little_more_work_than_one() {
    let (mut near, mut dearer, mut work) = (0, 0, Vec::new());
    let (mut checks, mut one, mut some) = (0_u64, 0_u64, 0_u64);
    for seed in 0..LOTS {
        let scene = lot(seed, 10);
        let goals = scene.geometry().unwrap().goals.unwrap().poses;
        let mut planner = Planner::new("hybrid", &scene, &Map::new()).unwrap();
        let plan = planner.plan(Options::default());
        let taken = plan.goal.as_ref().unwrap_or_else(|| panic!("lot {seed}: {:?}", plan.reason));
        let mut plans: Vec<Plan> = goals.iter().map(|goal| alone(&mut planner, goal)).collect();
        let best = plans.iter().map(cost).fold(f64::INFINITY, f64::min);
        near += u64::from(cost(&plan) <= 1.05 * best);
        let own = &plans[goals.iter().position(|goal| goal == taken).unwrap()];
        dearer += u64::from(cost(&plan) > cost(own) * 1.01);
        assert!(cost(&plan) <= cost(own) * 1.05, "lot {seed}: {} and alone {}", cost(&plan), cost(own));
        let counted = |plan: &Plan| u64::from(plan.stats.collision_checks.unwrap());
        (checks, one) = (checks + counted(&plan), one + counted(own));
        work.push(counted(&plan) as f64 / counted(own) as f64);
        plans.sort_by_key(counted);
        some += counted(&plans[plans.len() / 2]);
    }
    work.sort_by(f64::total_cmp);
    let median = work[work.len() / 2];
    let [taken, middle] = [one, some].map(|sum| checks as f64 / sum as f64);
    println!(
        "within 5 %: {near} of {LOTS}; collision checks against the goal taken, alone: median {median:.2}, sum \
         {taken:.2}; against the middle goal: {middle:.3}"
    );
    assert!(50 * dearer <= LOTS, "{dearer} of {LOTS} cost more than their own goal alone");
    assert!(100 * (near + BY_CHANCE) >= 95 * LOTS, "{near} of {LOTS} are within 5 % of the best");
    assert!(median <= 1.5 && middle <= 0.5, "{median} {middle}");
}

/// On a dozen lots: of four free slots, and on half of the lots of three places in the aisle too, the one with the
/// widest path is taken. No plan for a single goal stays farther away, by more than a twentieth.
#[test]
fn the_widest_path_is_the_widest_to_any_goal() {
    let wish = || Options { prefer: Some(Prefer::Widest), ..Options::default() };
    let clearance = |plan: &Plan| if plan.path.is_empty() { 0.0 } else { plan.metrics.min_clearance };
    let mut wider = 0;
    for seed in 100..112 {
        let (scene, poses) = lot_with_places(seed, if seed % 2 == 0 { &[-9.0, 4.0, 11.0] } else { &[] });
        let mut planner = Planner::new("hybrid", &scene, &Map::new()).unwrap();
        let [any, ordinary] = [wish(), Options::default()].map(|options| planner.plan(options));
        let mut alone = |&pose| planner.plan_between(Ends { start: None, goal: Some(pose) }, wish()).unwrap();
        let best = poses.iter().map(|pose| clearance(&alone(pose))).fold(0.0, f64::max);
        assert!(best > 0.0 && any.check.drivable(), "lot {seed}");
        assert!(clearance(&any) >= 0.95 * best, "lot {seed}: {} m of {best} m", clearance(&any));
        assert_eq!(any.goal.as_ref().map(|goal| goal.pose), any.path.last().copied());
        wider += u32::from(clearance(&any) > 1.2 * clearance(&ordinary));
    }
    assert!(wider >= 6, "wider than the ordinary path on {wider} lots");
}

/// A lot with four free slots and some more goals so far ahead of the car, and the poses of all.
fn lot_with_places(seed: u64, ahead: &[f64]) -> (Scenario, Vec<Pose>) {
    let (scene, mut random) = (lot(seed, 4), Random::new(seed));
    let free = scene.geometry().unwrap().goals.unwrap().poses;
    let mut poses: Vec<Pose> = free.iter().map(|goal| goal.pose).collect();
    for &ahead in ahead {
        let place = scene.start.advance(0.0, ahead);
        poses.push(Pose::new(place.x, place.y + random.between(-1.0, 1.0), place.heading));
    }
    let pose = |pose: &Pose| json!({ "x": pose.x, "y": pose.y, "heading": pose.heading });
    let mut value = serde_json::to_value(&scene).unwrap();
    value["goal"] = poses.iter().map(pose).collect();
    (Scenario::from_json(&value).unwrap(), poses)
}

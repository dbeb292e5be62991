//! Hybrid A*'s recorded searches against its own answers, and g and h reckoned anew from poses and arcs.

use std::collections::BTreeMap;

use parkade::geometry::{Pose, reeds_shepp};
use parkade::plan::{Options, Plan, Planner, Recorded};
use parkade::planners::hybrid::PoseRecording;
use parkade::scenario::Scenario;
use parkade::scenario::generate::SplitMix64;
use parkade::search::{BACKWARD, Fate, StepKind};
use serde_json::{Map, Value, json};

const SCENES: u64 = 100;
const CHANGE: f64 = 1.5;
const REVERSE: f64 = 1.25;

/// A floor of 30 m by 24 m with blocks on it, and maybe a wall across it with a gap.
fn random_scene(random: &mut SplitMix64, has_wall: bool) -> Scenario {
    let mut runs: Vec<_> =
        (0..10).map(|_| json!([random.below(26), random.below(20), 1 + random.below(4)])).collect();
    let gap = random.below(20);
    if has_wall {
        runs.extend((0..24).filter(|y| !(gap..gap + 4).contains(y)).map(|y| json!([14, y, 1])));
    }
    let heading = f64::from(random.below(600)) / 100.0 - 3.0;
    Scenario::from_json(&json!({
        "version": 1,
        "map": { "origin": [0, 0], "width": 30, "height": 24, "resolution": 1 },
        "obstacles": [{ "type": "cells", "runs": runs }],
        "slots": [],
        "vehicle": "paper",
        "start": { "x": 5, "y": 5, "heading": 0.3 },
        "goal": { "x": 24, "y": 18, "heading": heading },
    }))
    .unwrap()
}

fn settings(from: &str) -> Map<String, Value> {
    let all = json!({
        "searchFrom": from, "profile": "shortest", "heuristic": "reeds-shepp", "heuristicWeight": 1,
        "directionChangeCost": CHANGE, "reverseCost": REVERSE, "maxExpansions": 600, "ladder": false,
    });
    all.as_object().unwrap().clone()
}

fn planned(scene: &Scenario, from: &str, record: Option<usize>) -> (Plan, [Pose; 2]) {
    let mut planner = Planner::new("hybrid", scene, &settings(from)).unwrap();
    let plan = planner.plan(Options { record, ..Options::default() });
    (plan, [planner.geometry().start, planner.geometry().goal])
}

fn pose(all: &[f64], at: usize) -> Pose {
    Pose::new(all[3 * at], all[3 * at + 1], all[3 * at + 2])
}

/// What is known of a node: cost, whether it is closed, pose, and the signed length of the arc that led there.
type Known = BTreeMap<u32, (f64, bool, Pose, f64)>;

/// Order, costs and estimates follow from the arcs alone.
fn follows_the_rules(p: &PoseRecording, [start, goal]: [Pose; 2], radius: f64) {
    let r = &p.recording;
    let roots = if p.from_goal { [goal, start] } else { [start, goal] };
    assert_eq!(p.roots, roots[..p.roots.len()]);
    let estimate = |side: usize, at: Pose| reeds_shepp::distance(at, roots[1 - side], radius);
    let mut sides = [0, 1].map(|side| {
        let first = r.kinds.iter().position(|&kind| usize::from(kind / BACKWARD) == side);
        let node = first.map_or(0, |step| r.nodes[step]);
        let open = vec![(estimate(side, roots[side]), 0, node)];
        (Known::from([(node, (0.0, false, roots[side], 0.0))]), open)
    });
    for step in 0..r.nodes.len() {
        let side = usize::from(r.kinds[step] / BACKWARD);
        let from_goal = p.from_goal != (side == 1);
        let (known, open) = &mut sides[side];
        open.retain(|one| !known[&one.2].1);
        let first = *open.iter().min_by(|a, b| a.0.total_cmp(&b.0).then(a.1.cmp(&b.1))).unwrap();
        let node = r.nodes[step];
        assert!(first.2 == node || (first.0 - r.f[step]).abs() < 1e-9, "step {step}");
        let (g, _, at, led) = known[&node];
        assert_eq!((g, g + r.h[step]), (r.g[step], r.f[step]));
        assert!((r.h[step] - estimate(side, at)).abs() < 1e-9);
        known.get_mut(&node).unwrap().1 = true;
        for one in r.first[step] as usize..r.first[step + 1] as usize {
            let (target, cost, fate) = (r.targets[one], r.target_g[one], r.fates[one]);
            let [curvature, length] = [p.arcs[2 * one], p.arcs[2 * one + 1]];
            let end = at.advance(curvature, length);
            assert!((end.point() - pose(&p.poses, one).point()).norm() < 1e-6);
            let old = known.get(&target).copied();
            if fate == Fate::Blocked as u8 {
                assert!(old.is_none_or(|old| !old.1));
                continue;
            }
            let backwards = (length < 0.0) != from_goal;
            let change = if led * length < 0.0 { CHANGE } else { 0.0 };
            let expected = length.abs() * if backwards { REVERSE } else { 1.0 } + change;
            assert!((cost - g - expected).abs() < 1e-9, "{cost} {g} {expected}");
            match (fate, old) {
                (0, None) | (8, _) | (3, Some((_, true, ..))) => {}
                (1, Some((old, false, ..))) => assert!(cost < old),
                (2, Some((old, false, ..))) => assert!(cost >= old),
                other => panic!("step {step}: {other:?}"),
            }
            if fate < 2 {
                known.insert(target, (cost, false, end, length));
                open.retain(|one| one.2 != target);
                open.push((cost + r.target_h[one], one + 1, target));
            }
        }
    }
}

#[test]
fn searches_for_a_car_are_recorded_as_they_are() {
    let mut random = SplitMix64::new(26);
    let (mut steps, mut blocked, mut found) = (0, 0, 0);
    for number in 0..SCENES {
        let from = ["goal", "start", "both"][number as usize % 3];
        let scene = random_scene(&mut random, number % 2 == 0);
        let (plan, ends) = planned(&scene, from, Some(usize::MAX));
        let (plain, _) = planned(&scene, from, None);
        assert_eq!(plan.hash(), plain.hash());
        assert_eq!(plan.stats.expanded, plain.stats.expanded);
        assert_eq!(plan.stats.collision_checks, plain.stats.collision_checks);
        let Some(Recorded::Poses(poses)) = plan.recorded.as_deref() else { continue };
        let r = &poses.recording;
        assert_eq!(r.stats.expanded as usize, r.nodes.len());
        assert!(r.stats.expanded <= plan.stats.expanded);
        follows_the_rules(poses, ends, scene.geometry().unwrap().vehicle.min_turning_radius());
        steps += r.nodes.len();
        blocked += poses.owners.iter().filter(|&&owner| owner != PoseRecording::NOBODY).count();
        let completes =
            |kind: &u8| [StepKind::Goal as u8, StepKind::Joined as u8].contains(&(kind % BACKWARD));
        found += usize::from(r.kinds.iter().any(completes));
    }
    assert!(steps > 1000 && blocked > 100 && found > 5, "{steps} {blocked} {found}");
}

//! Cost-map A*'s recorded searches against its own trace and counters, and g and h reckoned anew from the cells.

use std::collections::BTreeMap;

use crate::recordings::{follows_the_rules, offers};
use parkade::plan::{LayerData, Options, Plan, PlanTrace, Planner, Recorded};
use parkade::scenario::Scenario;
use parkade::scenario::generate::SplitMix64;
use parkade::search::{Fate, Recording};
use serde_json::{Value, json};

const SCENES: u64 = 100;
const SIDES: [u32; 2] = [40, 30];
/// Half the car's width, metres; cells are a metre.
const HALF_WIDTH: f64 = 0.9;

/// A floor with blocks on it, and maybe a wall across it with a gap of 3 to 5 m.
fn random_scene(random: &mut SplitMix64, has_wall: bool) -> Scenario {
    let [width, height] = SIDES;
    let mut runs: Vec<_> =
        (0..9).map(|_| json!([random.below(width - 6), random.below(height), 1 + random.below(5)])).collect();
    let gap = random.below(height - 5);
    if has_wall {
        let wide = 3 + random.below(3);
        runs.extend((0..height).filter(|y| !(gap..gap + wide).contains(y)).map(|y| json!([width / 2, y, 1])));
    }
    Scenario::from_json(&json!({
        "version": 1,
        "map": { "origin": [-3, 2], "width": width, "height": height, "resolution": 1 },
        "obstacles": [{ "type": "cells", "runs": runs }],
        "slots": [],
        "vehicle": "paper",
        "start": { "x": 2, "y": 7.0 + f64::from(random.below(20)), "heading": 0 },
        "goal": { "x": 31, "y": 7.0 + f64::from(random.below(20)), "heading": 0 },
    }))
    .unwrap()
}

fn recorded(scene: &Scenario, settings: &Value, limit: usize) -> (Plan, Recording, Vec<f32>) {
    let mut planner = Planner::new("cost-map", scene, settings.as_object().unwrap()).unwrap();
    let plan = planner.plan(Options { trace: true, record: Some(limit), ..Options::default() });
    let LayerData::Floats(costs) = planner.layer("cost", 1).unwrap().data else { panic!("no costs") };
    let Some(Recorded::Cells { width, height, recording }) = plan.recorded.as_deref() else {
        panic!("no recording")
    };
    assert_eq!([*width, *height], SIDES);
    let recording = recording.clone();
    (plan, recording, costs)
}

/// The way between two cells that touch, in columns and rows.
fn step(from: u32, to: u32) -> (i32, i32) {
    let [a, b] = [from, to].map(|cell| ((cell % SIDES[0]) as i32, (cell / SIDES[0]) as i32));
    (b.0 - a.0, b.1 - a.1)
}

/// Costs and estimates follow from the cells and the layer of costs.
fn costs_are_those_of_the_cells(r: &Recording, costs: &[f32], is_steps: bool) {
    let goal = r.nodes.last().copied().filter(|_| r.kinds.last() == Some(&3));
    let mut known = BTreeMap::from([(r.nodes[0], 0.0)]);
    for at in 0..r.nodes.len() {
        let node = r.nodes[at];
        assert!((r.g[at] - known[&node]).abs() < 1e-9);
        if let Some(goal) = goal {
            let [dx, dy] = [step(node, goal).0, step(node, goal).1].map(|d| f64::from(d.abs()));
            let expected = if is_steps {
                (dx * dx + dy * dy).sqrt()
            } else {
                dx.max(dy) + (2f64.sqrt() - 1.0) * dx.min(dy)
            };
            assert!((r.h[at] - expected).abs() < 1e-9);
        }
        let moves: Vec<_> = offers(r, at).collect();
        let has_goal = Some(node) == goal;
        let inside = |d: i32, cell: u32, side: u32| (0..side as i32).contains(&(cell as i32 + d));
        let around = (-1..=1).flat_map(|y| (-1..=1).map(move |x| (x, y))).filter(|d| *d != (0, 0));
        let count = around
            .filter(|d| inside(d.0, node % SIDES[0], SIDES[0]) && inside(d.1, node / SIDES[0], SIDES[1]));
        assert_eq!(moves.len(), if has_goal { 0 } else { count.count() });
        for (target, fate, g, _) in moves {
            let (dx, dy) = step(node, target);
            let room = |cell: u32| costs[cell as usize].is_finite();
            let beside = [node.wrapping_add_signed(dx), node.wrapping_add_signed(dy * SIDES[0] as i32)];
            let is_cut = dx != 0 && dy != 0 && !beside.into_iter().all(room);
            assert_eq!(fate == Fate::Blocked as u8, !room(target));
            assert_eq!(fate == Fate::Corner as u8, room(target) && is_cut);
            if matches!(fate, 4 | 5) {
                continue;
            }
            let far = if dx != 0 && dy != 0 { 2f64.sqrt() } else { 1.0 };
            let [a, b] = [node, target].map(|cell| f64::from(costs[cell as usize]));
            let expected = if is_steps { far } else { far * (1.0 + f64::midpoint(a, b)) };
            assert!((g - r.g[at] - expected).abs() < 1e-6, "{} {expected}", g - r.g[at]);
            if fate < 2 {
                known.insert(target, g);
            }
        }
    }
}

#[test]
fn searches_for_a_road_are_recorded_as_they_are() {
    let mut random = SplitMix64::new(26);
    let (mut steps, mut refused, mut found) = (0, 0, 0);
    for number in 0..SCENES {
        let scene = random_scene(&mut random, number % 2 == 0);
        let is_steps = number % 3 == 0;
        let settings = json!({ "margin": 0, "costs": if is_steps { "steps" } else { "metre" } });
        let (plan, r, costs) = recorded(&scene, &settings, usize::MAX);
        let Some(PlanTrace::Cells { cells, .. }) = &plan.trace else { panic!("no trace") };
        assert_eq!(&r.nodes, cells);
        let stats = &plan.stats;
        assert_eq!(
            [r.stats.expanded, r.stats.generated, r.stats.pushes, r.stats.open_peak],
            [stats.expanded, stats.generated, stats.pushes, stats.open_peak]
        );
        if r.nodes.is_empty() {
            continue;
        }
        assert_eq!(r.oldest_first, is_steps);
        follows_the_rules(&r, [r.nodes[0]; 2]);
        costs_are_those_of_the_cells(&r, &costs, is_steps);
        steps += r.nodes.len();
        refused += r.fates.iter().filter(|&&fate| matches!(fate, 4 | 5)).count();
        found += usize::from(r.kinds.last() == Some(&3));
    }
    assert!(steps > 10_000 && refused > 1000 && found > 50, "{steps} {refused} {found}");
}

/// With a margin there are up to two searches, and the last one is recorded: its steps are the trace's last.
#[test]
fn of_several_searches_the_last_is_recorded() {
    let mut random = SplitMix64::new(27);
    let mut several = 0;
    for _ in 0..SCENES {
        let scene = random_scene(&mut random, true);
        let (plan, r, _) = recorded(&scene, &json!({ "margin": HALF_WIDTH }), usize::MAX);
        let Some(PlanTrace::Cells { cells, .. }) = &plan.trace else { panic!("no trace") };
        assert_eq!(plan.stats.expanded as usize, cells.len());
        assert_eq!(r.stats.expanded as usize, r.nodes.len());
        assert!(cells.ends_with(&r.nodes));
        several += usize::from(cells.len() > r.nodes.len() && !r.nodes.is_empty());
        if !r.nodes.is_empty() {
            follows_the_rules(&r, [r.nodes[0]; 2]);
        }
    }
    assert!(several > 20, "{several}");
}

#[test]
fn a_limit_cuts_the_recording_of_a_road() {
    let scene = random_scene(&mut SplitMix64::new(5), false);
    let [whole, part] = [usize::MAX, 20].map(|limit| recorded(&scene, &json!({}), limit).1);
    assert!(part.is_cut && !whole.is_cut);
    assert_eq!((&part.nodes[..], part.stats.expanded), (&whole.nodes[..20], whole.stats.expanded));
}

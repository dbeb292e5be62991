//! Start, goal and obstacles under the hand: between two ways that are about as good no path leaps.

use parkade::geometry::{Pose, math};
use parkade::plan::{Ends, Options, Outcome, Plan, Planner, Prefer};
use parkade::scenario::Scenario;
use parkade::scenario::catalog::scenario;
use parkade::scenario::generate::SplitMix64;
use serde_json::{Map, Value, json};

/// What the page drags with.
const STICKINESS: f64 = 0.03;
/// Steps of a drag of the page's first scene, and of the others.
const STEPS: [u32; 2] = [200, if cfg!(debug_assertions) { 60 } else { 200 }];
/// A leap: some place of one path is farther than this from the other, metres, …
const ASTRAY: f64 = 1.0;
/// … and their lengths differ by less than this share.
const ALIKE: f64 = 0.03;

#[derive(Clone, Copy, Debug, PartialEq)]
enum Held {
    Start,
    Goal,
    Obstacle(usize),
}

/// A hand that wanders about where it took hold: at most so far, metres, a few centimetres a step.
struct Hand {
    random: SplitMix64,
    reach: f64,
    at: [f64; 2],
    heading: f64,
    turned: f64,
}

impl Hand {
    fn new(seed: u64, reach: f64) -> Self {
        let mut random = SplitMix64::new(seed.wrapping_mul(0x9e37_79b9_7f4a_7c15) ^ 0xd7a6);
        let heading = math::TAU * f64::from(random.below(1000)) / 1000.0;
        Self { random, reach, at: [0.0; 2], heading, turned: 0.0 }
    }

    fn between(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * f64::from(self.random.below(1 << 20)) / f64::from(1 << 20)
    }

    fn step(&mut self) {
        self.heading += self.between(-0.5, 0.5);
        let length = self.between(0.02, 0.25);
        let (sin, cos) = math::sin_cos(self.heading);
        let next = [self.at[0] + length * cos, self.at[1] + length * sin];
        if next[0] * next[0] + next[1] * next[1] > self.reach * self.reach {
            self.heading += 2.0;
        } else {
            self.at = next;
        }
        self.turned += self.between(-0.02, 0.02);
    }

    fn moved(&self, pose: Pose) -> Pose {
        Pose::new(pose.x + self.at[0], pose.y + self.at[1], pose.heading + self.turned)
    }

    fn moved_obstacle(&self, scene: &Value, index: usize) -> Scenario {
        let mut scene = scene.clone();
        let obstacle = &mut scene["obstacles"][index];
        let shift = |point: &mut Value| {
            let at = [0, 1].map(|axis| point[axis].as_f64().unwrap() + self.at[axis]);
            *point = json!(at);
        };
        match obstacle["type"].as_str().unwrap() {
            "rectangle" | "circle" => shift(&mut obstacle["center"]),
            "car" => {
                for (axis, name) in ["x", "y"].into_iter().enumerate() {
                    obstacle["pose"][name] = json!(obstacle["pose"][name].as_f64().unwrap() + self.at[axis]);
                }
            }
            _ => obstacle["points"].as_array_mut().unwrap().iter_mut().for_each(shift),
        }
        Scenario::from_json(&scene).unwrap()
    }
}

/// How far either path strays from the other, metres.
fn strays(one: &Plan, other: &Plan) -> f64 {
    let far = |from: &Plan, to: &Plan| {
        let nearest =
            |p: &Pose| to.path.iter().map(|q| (p.point() - q.point()).norm()).fold(f64::INFINITY, f64::min);
        from.path.iter().map(nearest).fold(0.0, f64::max)
    };
    far(one, other).max(far(other, one))
}

/// Leaps and plans of a drag.
fn drag(id: &str, held: Held, seed: u64, reach: f64, stickiness: f64) -> (u32, u32) {
    let scene = scenario(id).unwrap();
    let value = serde_json::to_value(&scene).unwrap();
    let geometry = scene.geometry().unwrap();
    let mut planner = Planner::new("hybrid", &scene, &Map::new()).unwrap();
    let mut hand = Hand::new(seed, reach);
    let (mut leaps, mut plans, mut last) = (0, 0, None::<Plan>);
    for step in 0..STEPS[usize::from(id != "perpendicular")] {
        hand.step();
        let options = Options { stickiness, ..Options::default() };
        let plan = match held {
            Held::Obstacle(index) => {
                let moved = hand.moved_obstacle(&value, index);
                let mut next = Planner::new("hybrid", &moved, &Map::new()).unwrap();
                next.continue_from(&mut planner);
                planner = next;
                planner.plan(options)
            }
            Held::Start => {
                let ends = Ends { start: Some(hand.moved(geometry.start)), goal: None };
                planner.plan_between(ends, options).unwrap()
            }
            Held::Goal => {
                let ends = Ends { start: None, goal: Some(hand.moved(geometry.goal)) };
                planner.plan_between(ends, options).unwrap()
            }
        };
        if plan.outcome != Outcome::Found {
            last = None;
            continue;
        }
        assert!(plan.check.drivable(), "{id} {held:?} {step}");
        plans += 1;
        if let Some(last) = &last {
            let share = (plan.metrics.length / last.metrics.length - 1.0).abs();
            let is_leap = share < ALIKE && strays(last, &plan) > ASTRAY;
            leaps += u32::from(is_leap);
            if is_leap && stickiness > 0.0 {
                println!(
                    "{id} {held:?} seed {seed} step {step}: {:.2} m, {} changes to {:.2} m, {}",
                    last.metrics.length,
                    last.metrics.direction_changes,
                    plan.metrics.length,
                    plan.metrics.direction_changes
                );
            }
        }
        last = Some(plan);
    }
    (leaps, plans)
}

const DRAGS: [(&str, Held, f64); 9] = [
    ("perpendicular", Held::Start, 2.0),
    ("perpendicular", Held::Goal, 0.3),
    ("perpendicular", Held::Obstacle(0), 2.0),
    ("L2", Held::Start, 5.0),
    ("L2", Held::Goal, 1.0),
    ("P4", Held::Start, 3.0),
    ("P4", Held::Goal, 2.0),
    ("reverse-in", Held::Start, 3.0),
    ("reverse-in", Held::Obstacle(0), 2.0),
];

fn all(seed: u64, stickiness: f64) -> (u32, u32) {
    // What is not kept leaps soonest where there is room.
    let drags = if stickiness > 0.0 { &DRAGS[..] } else { &DRAGS[3..] };
    let tally = drags.iter().map(|&(id, held, reach)| drag(id, held, seed, reach, stickiness));
    tally.fold((0, 0), |sum, one| (sum.0 + one.0, sum.1 + one.1))
}

#[test]
fn no_path_leaps_between_ways_that_are_about_as_good() {
    let seed = std::env::var("DRAGS").map_or(1, |text| text.parse().unwrap());
    let (loose, kept) = (all(seed, 0.0), all(seed, STICKINESS));
    println!("leaps without: {} of {}, with: {} of {}", loose.0, loose.1, kept.0, kept.1);
    assert!(loose.0 >= 5 && kept.1 >= 500, "{loose:?} {kept:?}");
    assert_eq!(kept.0, 0, "leaps");
}

/// A plan that was chosen stays under the hand, although the ordinary path is much shorter.
#[test]
fn a_chosen_path_stays_while_its_ends_are_dragged() {
    let scene = scenario("L2").unwrap();
    let mut planner = Planner::new("hybrid", &scene, &Map::new()).unwrap();
    let prefer = Some(Prefer::FewestChanges);
    let chosen = planner.plan(Options { prefer, ..Options::default() });
    let ordinary = planner.plan(Options::default());
    assert!(chosen.metrics.direction_changes == 0 && ordinary.metrics.direction_changes == 1);
    let path: Vec<f64> = chosen.path.iter().flat_map(|pose| [pose.x, pose.y, pose.heading]).collect();
    planner.continue_along(&path, &chosen.directions, &chosen.curvatures).unwrap();
    let start = scene.geometry().unwrap().start;
    for step in 1..=10 {
        let start = Pose::new(start.x + 0.05 * f64::from(step), start.y, start.heading);
        let ends = Ends { start: Some(start), goal: None };
        let options = Options { prefer, stickiness: STICKINESS, ..Options::default() };
        let plan = planner.plan_between(ends, options).unwrap();
        assert!(plan.check.drivable() && plan.metrics.direction_changes == 0, "{step}");
        assert!(strays(&plan, &chosen) < 2.0, "{step}: {}", strays(&plan, &chosen));
    }
    for (path, gears) in
        [(&path[1..], &chosen.directions[..]), (&path[..], &chosen.directions[1..]), (&[], &[])]
    {
        let refused = planner.continue_along(path, gears, &chosen.curvatures).unwrap_err();
        assert_eq!(refused.path, "before");
    }
}

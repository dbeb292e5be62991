//! Fewest gear changes in layers, against an exhaustive search by layers in small rooms.

use core::cell::RefCell;
use std::cmp::Ordering;
use std::collections::{BinaryHeap, HashMap, HashSet};

use super::super::domain::{Setting, StateLattice};
use super::super::obstacle_heuristic::ObstacleHeuristic;
use super::super::profile::Profile;
use super::super::state::State;
use super::super::state_index::StateIndex;
use super::*;
use crate::geometry::Point;
use crate::search::{self, Domain, End, Limits, NodeId, Relax, Visit, best_first};
use crate::vehicle::Vehicle;
use crate::vehicle::collision::{Obstacles, Solid};

const CHANGE_PRICE: f64 = 1000.0;
const CART: Vehicle = Vehicle {
    wheelbase: 1.2,
    width: 0.9,
    rear_to_front: 1.6,
    rear_to_back: 0.4,
    max_steer: 0.6,
    max_steer_rate: 0.5,
};

/// Numbers that are the same everywhere, from 0 to 1.
fn numbers(seed: u64) -> impl FnMut() -> f64 {
    let mut state = seed.wrapping_mul(0x9e37_79b9_7f4a_7c15) ^ 0x5bf0_3635;
    move || {
        state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (state >> 33) as f64 / (1_u64 << 31) as f64
    }
}

fn rectangle(x: f64, y: f64, width: f64, height: f64, owner: u32) -> Solid {
    let corners = [(x, y), (x + width, y), (x + width, y + height), (x, y + height)];
    Solid { outline: corners.map(|(x, y)| Point::new(x, y)).to_vec(), owner }
}

/// A small room with boxes in it and two poses without contact.
fn room(seed: u64) -> Option<(Obstacles, [Pose; 2])> {
    let mut next = numbers(seed);
    let (width, height) = (5.0 + 4.0 * next(), 4.0 + 3.0 * next());
    let mut boxes = Vec::new();
    for owner in 1..=(4.0 * next()) as u32 {
        boxes.push(rectangle(width * next(), height * next(), 0.3 + next(), 0.3 + next(), owner));
    }
    let obstacles = Obstacles::new(&[], &boxes, &rectangle(-0.5, -0.5, width + 1.0, height + 1.0, 0));
    let checker = CollisionChecker::new(&obstacles, &CART);
    let mut pose = || {
        Pose::new(width * next(), height * next(), core::f64::consts::TAU * next() - core::f64::consts::PI)
    };
    let ends = [pose(), pose()].map(|pose| obstacles.local(pose));
    let is_free = |&pose: &Pose| checker.hit(pose, 0.0).is_none() && obstacles.inside(pose.point()).is_none();
    ends.iter().all(is_free).then_some((obstacles, ends))
}

/// With `weight` 0 both searches expand in the same order, so that each cell has the same pose in both.
fn lattice<'a>(
    checker: &'a CollisionChecker<'a>,
    flood: &'a ObstacleHeuristic,
    keys: &'a RefCell<StateIndex>,
    target: Pose,
    weight: f64,
    bound: f64,
) -> StateLattice<'a> {
    let config = Config { profile: Profile::Shortest, max_direction_changes: 1, ..Config::default() };
    let level = Level {
        xy: 0.5,
        yaw: 0.35,
        step: 0.7,
        extra_change: CHANGE_PRICE - config.direction_change_cost,
        weight,
        bound,
        ..config.level(1)
    };
    let radius = CART.min_turning_radius();
    let costs = super::super::cost::CostModel::driven(&config, radius, [target, target]).searching(&level);
    let setting =
        Setting { checker, flood, keys, costs, mirrored: false, recorder: None, poses: None, roots: &[] };
    StateLattice::new(setting, &CART, &config, level, target, 0.02)
}

struct Moves(Vec<(NodeId, f64, State)>);

impl Relax<f64, State> for Moves {
    fn improves(&self, _: NodeId, _: f64) -> bool {
        true
    }

    fn emit(&mut self, target: NodeId, cost: f64, label: State) {
        self.0.push((target, cost, label));
    }
}

struct Waiting(f64, u32, NodeId, State);

impl PartialEq for Waiting {
    fn eq(&self, other: &Self) -> bool {
        self.cmp(other) == Ordering::Equal
    }
}

impl Eq for Waiting {}

impl Ord for Waiting {
    fn cmp(&self, other: &Self) -> Ordering {
        other.0.total_cmp(&self.0).then(other.1.cmp(&self.1))
    }
}

impl PartialOrd for Waiting {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

/// The fewest changes, by going through everything that can be reached with none, then with one, and so on.
fn exhaustive(lattice: &mut StateLattice, root: Pose) -> Option<u32> {
    let node = lattice.node(root, 0);
    let mut layers =
        vec![BinaryHeap::from([Waiting(0.0, 0, node, State { pose: root, ..State::default() })])];
    let (mut closed, mut shortest) = (HashSet::new(), HashMap::from([(node, (0, 0.0))]));
    let (mut best, mut ticket): (Option<u32>, u32) = (None, 0);
    for changes in 0.. {
        if changes >= layers.len() || best.is_some_and(|best| best <= changes as u32) {
            return best;
        }
        while let Some(Waiting(length, _, node, label)) = layers[changes].pop() {
            if shortest[&node] != (changes, length) || !closed.insert(node) {
                continue;
            }
            let at = Visit { node, label, g: length, parent: None };
            if let Some(finish) = lattice.finish(at, f64::INFINITY) {
                let all = changes as u32 + (finish.cost / CHANGE_PRICE) as u32;
                best = Some(best.map_or(all, |best| best.min(all)));
            }
            let mut moves = Moves(Vec::new());
            lattice.successors(at, &mut moves);
            for (target, cost, label) in moves.0 {
                let is_change = cost >= CHANGE_PRICE;
                let layer = changes + usize::from(is_change);
                let length = length + if is_change { cost - CHANGE_PRICE } else { cost };
                let is_better =
                    shortest.get(&target).is_none_or(|&(least, way)| (layer, length) < (least, way));
                if closed.contains(&target) || !is_better || lattice.heuristic(target, label) == f64::INFINITY
                {
                    continue;
                }
                shortest.insert(target, (layer, length));
                ticket += 1;
                if layers.len() <= layer {
                    layers.resize_with(layer + 1, BinaryHeap::new);
                }
                layers[layer].push(Waiting(length, ticket, target, label));
            }
        }
    }
    best
}

#[test]
fn a_price_above_every_way_finds_the_fewest_changes() {
    let limits = Limits { max_expansions: 1_000_000, first: false };
    let (mut rooms, mut tally, mut alike, mut fewer) = (0, [0; 6], 0, 0);
    for (obstacles, [root, target]) in (0..).filter_map(room) {
        let (checker, keys) = (CollisionChecker::new(&obstacles, &CART), RefCell::new(StateIndex::default()));
        let flood = ObstacleHeuristic::new(&obstacles, &CART, target, 0.02, None);
        if flood.distance(root).is_infinite() {
            continue;
        }
        let fewest = exhaustive(&mut lattice(&checker, &flood, &keys, target, 0.0, f64::INFINITY), root);
        let searched = |weight: f64, bound: f64| {
            let mut lattice = lattice(&checker, &flood, &keys, target, weight, bound);
            let begin = (lattice.node(root, 0), State { pose: root, ..State::default() });
            let found = best_first(&mut lattice, begin, limits, &mut search::Scratch::default(), &mut ());
            assert_ne!(found.end, End::BudgetSpent);
            found.found.map(|found| (found.1 / CHANGE_PRICE) as u32)
        };
        assert_eq!(searched(0.0, f64::INFINITY), fewest);
        // As the planner asks: with the estimate, then without it for fewer.
        let quick = searched(1.0, f64::INFINITY);
        alike += u32::from(quick == fewest);
        let bound = quick.map_or(f64::INFINITY, |quick| CHANGE_PRICE * f64::from(quick));
        let asked = searched(0.0, bound).or(quick);
        let none = u32::MAX;
        assert!(asked.unwrap_or(none) <= fewest.unwrap_or(none), "{asked:?}, exhaustive {fewest:?}");
        fewer += u32::from(asked != fewest);
        if let Some(fewest) = fewest {
            assert_eq!(searched(0.0, CHANGE_PRICE * f64::from(fewest)), None, "none with fewer");
            assert_eq!(searched(0.0, CHANGE_PRICE * f64::from(fewest + 1)), Some(fewest));
        }
        tally[fewest.map_or(5, |fewest| fewest.min(4) as usize)] += 1;
        rooms += 1;
        if rooms == 200 {
            break;
        }
    }
    println!(
        "changes 0 to 4, none: {tally:?}; with the estimate alone as many {alike} times of 200, \
         as asked fewer {fewer} times"
    );
    assert!(tally[..3].iter().all(|&rooms| rooms >= 20) && tally[5] >= 5, "{tally:?}");
    // Where the order differs, so may the pose that stands for a cell, by which a path may also save a change.
    assert!(alike >= 180 && fewer <= 20, "{alike} {fewer}");
}

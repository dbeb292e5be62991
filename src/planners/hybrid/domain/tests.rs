//! Rocks: where they end, what they cost, and how much room they need.

use core::cell::RefCell;

use super::*;
use crate::geometry::Point;
use crate::geometry::arcs;
use crate::planners::hybrid::cost::Motion;
use crate::planners::hybrid::state::tree_arcs;
use crate::vehicle::collision::{Edge, Obstacles, Solid};

struct Moves(Vec<(NodeId, f64, State)>);

impl Relax<f64, State> for Moves {
    fn improves(&self, _: NodeId, _: f64) -> bool {
        true
    }

    fn is_closed(&self, _: NodeId) -> bool {
        false
    }

    fn emit(&mut self, target: NodeId, cost: f64, label: State) {
        self.0.push((target, cost, label));
    }
}

/// What a rocking lattice can do from one pose of the sedan, which came there with a motion, between walls this far
/// from its nose and tail.
fn moves(gear: i8, room: f64, check: impl Fn(&StateLattice, &[(NodeId, f64, State)], State)) {
    let car = &Vehicle::SEDAN;
    let (tail, nose) = (20.0 - car.rear_to_back - room, 20.0 + car.rear_to_front + room);
    let wall = |x: f64| Edge { a: Point::new(x, 5.0), b: Point::new(x, 15.0), owner: 1 };
    let outline =
        [(0.0, 0.0), (40.0, 0.0), (40.0, 20.0), (0.0, 20.0)].map(|(x, y)| Point::new(x, y)).to_vec();
    let obstacles = Obstacles::new(&[wall(tail), wall(nose)], &[], &Solid { outline, owner: 0 });
    let [pose, target] = [(20.0, 10.0), (8.0, 10.0)].map(|(x, y)| obstacles.local(Pose::new(x, y, 0.0)));
    let checker = CollisionChecker::new(&obstacles, car);
    let flood = ObstacleHeuristic::new(&obstacles, car, target, 0.0, None);
    let keys = RefCell::default();
    let config = Config::default();
    let level = config.level(2).rocking(&config);
    let costs = CostModel::driven(&config, car.min_turning_radius(), [pose, target]).searching(&level);
    let (checker, flood, keys) = (&checker, &flood, &keys);
    let setting =
        Setting { checker, flood, keys, costs, mirrored: false, recorder: None, poses: None, roots: &[] };
    let lattice = StateLattice::new(setting, car, &config, level, target, 0.0);
    let from = State { pose, motion: Motion { gear, ..Motion::default() }, length: 0.0 };
    let mut moves = Moves(Vec::new());
    lattice.successors(Visit { node: 0, label: from, g: 0.0, parent: None }, &mut moves);
    check(&lattice, &moves.0, from);
}

#[test]
fn a_rock_turns_on_the_spot_and_its_arcs_lead_there() {
    for gear in [-1, 0, 1] {
        moves(gear, 1.0, |lattice, moves, from| {
            let mut turns = Vec::new();
            for &(node, cost, label) in moves.iter().filter(|(.., label)| label.motion.is_rock) {
                let arcs: Vec<Arc> = tree_arcs(&[(0, from), (node, label)]).collect();
                assert_eq!((arcs.len(), arcs::direction_changes(&arcs)), (3, 2));
                assert!(arcs[0].length * f64::from(gear) >= 0.0, "it goes on in the gear that is in");
                let end = arcs::end(from.pose, &arcs);
                assert!((end.point() - label.pose.point()).norm() < 1e-12);
                assert!((end.point() - from.pose.point()).norm() < 1e-3, "{end:?}");
                let mut before = from.motion;
                let sum = arcs.iter().fold(0.0, |sum, arc| {
                    let sum = sum + lattice.costs.arc(before, arc);
                    before = Motion::after(arc);
                    sum
                });
                assert!((sum - cost).abs() < 1e-12);
                turns.push(math::turn(from.pose.heading, end.heading));
            }
            let [left, right] = turns[..] else { panic!("{turns:?}") };
            assert!((left + right).abs() < 1e-12 && (left.abs() - lattice.level.rock).abs() < 1e-12);
        });
    }
}

#[test]
fn a_rock_needs_its_room_and_a_plain_move_ends_where_its_arc_does() {
    for (room, rocks) in [(0.03, 0), (0.12, 2)] {
        moves(1, room, |_, moves, from| {
            assert_eq!(moves.iter().filter(|(.., label)| label.motion.is_rock).count(), rocks, "{room} m");
            for &(node, _, label) in moves.iter().filter(|(.., label)| !label.motion.is_rock) {
                let arcs: Vec<Arc> = tree_arcs(&[(0, from), (node, label)]).collect();
                assert_eq!(arcs.len(), 1);
                assert!((arcs::end(from.pose, &arcs).point() - label.pose.point()).norm() < 1e-12);
            }
        });
    }
}

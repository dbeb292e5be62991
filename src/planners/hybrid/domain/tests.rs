//! Moves other than those of a fixed length. Rocks: where they end, what they cost, and how much room they need. Moves
//! that something blocks: where they end.

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

type Check<'a> = &'a dyn Fn(&StateLattice, &[(NodeId, f64, State)], State);

/// What a rocking lattice can do from one pose of the sedan, which came there with a motion, between walls this far
/// from its nose and tail.
fn moves(gear: i8, room: f64, check: impl Fn(&StateLattice, &[(NodeId, f64, State)], State)) {
    let config = Config::default();
    moves_on(&config, config.level(2).rocking(&config), (gear, room), &check);
}

/// The same of any lattice.
fn moves_on(config: &Config, level: Level, (gear, room): (i8, f64), check: Check) {
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
    let costs = CostModel::driven(config, car.min_turning_radius(), [pose, target]).searching(&level);
    let (checker, flood, keys) = (&checker, &flood, &keys);
    let setting =
        Setting { checker, flood, keys, costs, mirrored: false, recorder: None, poses: None, roots: &[] };
    let lattice = StateLattice::new(setting, car, config, level, target, 0.0);
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

#[test]
fn a_blocked_move_is_shortened_to_the_room_that_there_is() {
    // One and two steering angles to either side: what is known of motions at full lock does not hold for others.
    for steer_samples in [1, 2] {
        let config = Config { steer_samples: Some(steer_samples), ..Config::default() };
        let level = config.level(2);
        let (plain, precision) = (2 * (2 * steer_samples as usize + 1), level.spacing / 16.0);
        for (room, count, shortened) in [(1.0, plain, plain), (0.08, 0, plain), (0.015, 0, 0)] {
            moves_on(&config, level, (1, room), &|_, moves, _| assert_eq!(moves.len(), count, "{room} m"));
            moves_on(&config, level.shortening(), (1, room), &|lattice, moves, from| {
                assert_eq!(moves.len(), shortened, "{room} m");
                for &(node, cost, label) in moves {
                    let arcs: Vec<Arc> = tree_arcs(&[(0, from), (node, label)]).collect();
                    let [arc] = arcs[..] else { panic!("{arcs:?}") };
                    assert!((arcs::end(from.pose, &arcs).point() - label.pose.point()).norm() < 1e-12);
                    assert_eq!(cost, lattice.costs.arc(from.motion, &arc));
                    assert!(lattice.checker.arc_free(from.pose, &arc, 0.01, 0.0), "{arc:?}");
                    let longer = Arc { length: arc.length + precision.copysign(arc.length), ..arc };
                    let is_whole = (arc.length.abs() - level.step).abs() < 1e-12;
                    assert_eq!(is_whole, room > level.step, "{room} m, {arc:?}");
                    assert!(is_whole || !lattice.checker.arc_free(from.pose, &longer, 0.01, 0.0), "{arc:?}");
                }
            });
        }
    }
}

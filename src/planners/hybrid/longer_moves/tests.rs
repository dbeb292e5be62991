use super::*;
use crate::geometry::{Point, math};
use crate::planners::hybrid::config::Config;
use crate::planners::hybrid::cost::CostModel;
use crate::vehicle::Vehicle;
use crate::vehicle::collision::{CollisionChecker, Obstacles, Solid};

const MARGIN: f64 = 0.03;

/// A street of 6 m with a kerb slot of so many metres along it, which begins at x = 20 m; its kerb is at y = 10 m.
fn kerb_slot(length: f64) -> Obstacles {
    let solid = |x: f64, y: f64, width: f64, depth: f64, owner: u32| Solid {
        outline: [(0.0, 0.0), (width, 0.0), (width, depth), (0.0, depth)]
            .map(|(dx, dy)| Point::new(x + dx, y + dy))
            .to_vec(),
        owner,
    };
    let solids = [
        solid(10.0, 10.0, 10.0, 2.0, 1),
        solid(20.0 + length, 10.0, 10.0, 2.0, 2),
        solid(10.0, 9.0, 30.0, 1.0, 3),
        solid(10.0, 18.0, 30.0, 1.0, 4),
    ];
    Obstacles::new(&[], &solids, &solid(10.0, 9.0, 30.0, 10.0, 0))
}

/// A path that rocks out of a slot with moves of `step` metres at most, full lock each, until it can leave; the pose
/// where it begins comes with it.
fn rocking_out(checker: &CollisionChecker, car: &Vehicle, start: Pose, step: f64) -> Vec<Arc> {
    let (mut pose, mut arcs) = (start, Vec::new());
    for n in 0..200 {
        let curvature = if n % 2 == 0 { car.max_curvature() } else { -car.max_curvature() };
        let way = |length: f64| Arc { curvature, length };
        if n % 2 == 0 && checker.arc_free(pose, &way(3.5), 0.02, MARGIN) {
            arcs.push(way(3.5));
            return arcs;
        }
        let length = if n % 2 == 0 { step } else { -step };
        let free = checker.free_length(pose, &way(length), 0.02, MARGIN);
        if free > 0.0 {
            arcs.push(way(free.copysign(length)));
            pose = pose.advance(curvature, free.copysign(length));
        }
    }
    panic!("the car does not come out");
}

/// Slots from 0.9 to 1.5 m longer than the car, and rocks of 15 to 40 cm: the end stays, the path keeps its margin,
/// costs less and takes at most three fifths of the gear changes.
#[test]
fn short_rocks_become_fewer_long_ones() {
    let car = Vehicle::SEDAN;
    let [mut short, mut long] = [0; 2];
    for (slack, step) in
        [0.9, 1.1, 1.3, 1.5].into_iter().flat_map(|slack| [0.15, 0.25, 0.4].map(|s| (slack, s)))
    {
        let obstacles = kerb_slot(car.length() + slack);
        let checker = CollisionChecker::new(&obstacles, &car);
        let middle = 20.0 + slack / 2.0 + car.rear_to_back;
        let start = obstacles.local(Pose::new(middle, 10.0 + 0.3 + car.width / 2.0, 0.0));
        let path = rocking_out(&checker, &car, start, step);
        let end = arcs::end(start, &path);
        let costs = CostModel::driven(&Config::default(), car.min_turning_radius(), [start, end]);
        let rules = Rules { checker: &checker, costs: &costs, spacing: 0.04, margin: MARGIN };
        let [before, after] = [path.clone(), lengthen(rules, start, path)];
        let got = arcs::end(start, &after);
        assert!(
            (got.point() - end.point()).norm() < 1e-6 && math::turn(got.heading, end.heading).abs() < 1e-6
        );
        let mut pose = start;
        for arc in &after {
            assert!(checker.arc_free(pose, arc, 0.02, MARGIN - 0.001), "{slack} {step} {arc:?}");
            pose = pose.advance(arc.curvature, arc.length);
        }
        let [old, new] = [&before, &after].map(|arcs| costs.path(&checker, start, arcs));
        assert!(new <= old, "{slack} {step}: {old} {new}");
        let [old, new] = [&before, &after].map(|arcs| arcs::direction_changes(arcs));
        println!("{slack} m, {step} m: {old} to {new}");
        assert!(new <= old, "{slack} {step}: {old} {new}");
        (short, long) = (short + old, long + new);
    }
    assert!(5 * long <= 3 * short, "{short} {long}");
}

/// The same path and, where gear changes are few, no other.
#[test]
fn few_gear_changes_are_left_alone() {
    let car = Vehicle::SEDAN;
    let obstacles = kerb_slot(car.length() + 8.0);
    let checker = CollisionChecker::new(&obstacles, &car);
    let start = obstacles.local(Pose::new(24.0, 10.1 + car.width / 2.0, 0.0));
    let path = [1.0, -0.5, 1.0].map(|length| Arc { curvature: 0.0, length }).to_vec();
    let costs = CostModel::driven(&Config::default(), car.min_turning_radius(), [start; 2]);
    let rules = Rules { checker: &checker, costs: &costs, spacing: 0.05, margin: MARGIN };
    assert_eq!(lengthen(rules, start, path.clone()), path);
}

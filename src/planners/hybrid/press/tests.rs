use super::*;
use crate::geometry::math;
use crate::planners::hybrid::config::Config;
use crate::planners::hybrid::cost::CostModel;
use crate::planners::hybrid::descent::tests::{ground, rocking};
use crate::vehicle::Vehicle;
use crate::vehicle::collision::CollisionChecker;

/// Out of nearly each way of a car that rocks a move can be pressed. The end stays, the path keeps its margin and has
/// fewer gear changes.
#[test]
fn a_move_is_pressed_out_of_a_path_that_rocks() {
    let mut pressed = 0;
    let paths = rocking(|rules, start, arcs| {
        let Some(better) = (0..8).find_map(|number| press(rules, start, arcs, number)) else { return };
        pressed += 1;
        let [got, end] = [&better, arcs].map(|arcs| arcs::end(start, arcs));
        assert!((got.point() - end.point()).norm() < 1e-6);
        assert!(math::turn(got.heading, end.heading).abs() < 1e-6);
        let mut pose = start;
        for arc in &better {
            assert!(rules.checker.keeps_clearance(pose, arc, 0.01, (rules.margin, 0.001)));
            pose = pose.advance(arc.curvature, arc.length);
        }
        assert!(arcs::direction_changes(&better) < arcs::direction_changes(arcs));
    });
    assert!(paths > 20 && pressed * 10 >= paths * 9, "{pressed} of {paths}");
}

/// Nothing is pressed out of a path by a number that none of its moves has.
#[test]
fn a_move_that_is_not_there_cannot_be_pressed_out() {
    let obstacles = ground(60.0, &[]);
    let checker = CollisionChecker::new(&obstacles, &Vehicle::SEDAN);
    let start = obstacles.local(Pose::new(30.0, 30.0, 0.0));
    let arcs = [2.0, -3.0].map(|length| Arc { curvature: 0.0, length });
    let costs = CostModel::driven(&Config::default(), 5.5, [start, arcs::end(start, &arcs)]);
    let rules = Rules { checker: &checker, costs: &costs, spacing: 0.1, margin: 0.05 };
    assert!(press(rules, start, &arcs, 2).is_none());
}

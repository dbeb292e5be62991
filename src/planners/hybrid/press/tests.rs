use super::*;
use crate::geometry::math;
use crate::planners::hybrid::config::Config;
use crate::planners::hybrid::cost::CostModel;
use crate::planners::hybrid::descent::tests::{ground, is_free};
use crate::vehicle::Vehicle;
use crate::vehicle::collision::CollisionChecker;

/// A car that rocks on the spot, by seed, among posts: nearly always some move can be pressed out. The end stays, the
/// path keeps its margin and has fewer gear changes.
#[test]
fn a_move_is_pressed_out_of_a_path_that_rocks() {
    let car = Vehicle::SEDAN;
    let curvature = car.max_curvature();
    let (mut state, mut paths, mut pressed) = (3_u32, 0, 0);
    let mut random = || {
        state = state.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
        f64::from(state >> 8) / f64::from(1 << 24)
    };
    for _ in 0..60 {
        let posts: Vec<(f64, f64)> =
            (0..8).map(|_| (22.0 + 16.0 * random(), 22.0 + 16.0 * random())).collect();
        let obstacles = ground(60.0, &posts);
        let checker = CollisionChecker::new(&obstacles, &car);
        let start = obstacles.local(Pose::new(30.0, 30.0, 6.0 * random()));
        let arcs: Vec<Arc> = (0..8)
            .map(|n| {
                let gear = f64::from(1 - 2 * (n % 2));
                Arc { curvature: gear * curvature, length: gear * (0.3 + 0.6 * random()) }
            })
            .collect();
        let end = arcs::end(start, &arcs);
        let costs = CostModel::driven(&Config::default(), car.min_turning_radius(), [start, end]);
        let rules = Rules { checker: &checker, costs: &costs, spacing: 0.1, margin: 0.05 };
        if !is_free(rules, start, &arcs) {
            continue;
        }
        paths += 1;
        let Some(better) = (0..8).find_map(|number| press(rules, start, &arcs, number)) else { continue };
        pressed += 1;
        let got = arcs::end(start, &better);
        assert!((got.point() - end.point()).norm() < 1e-6);
        assert!(math::turn(got.heading, end.heading).abs() < 1e-6);
        let keeps = |pose, arc| checker.keeps_clearance(pose, arc, 0.01, (0.05, 0.001));
        let mut pose = start;
        for arc in &better {
            assert!(keeps(pose, arc), "{posts:?}");
            pose = pose.advance(arc.curvature, arc.length);
        }
        assert!(arcs::direction_changes(&better) < arcs::direction_changes(&arcs));
    }
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

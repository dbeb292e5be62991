use super::*;
use crate::geometry::math;
use crate::planners::hybrid::config::Config;
use crate::planners::hybrid::cost::CostModel;
use crate::planners::hybrid::descent::tests::{ground, is_free};
use crate::vehicle::Vehicle;
use crate::vehicle::collision::CollisionChecker;

/// A car that rocks on the spot, by seed, among posts: a move can be squeezed out. The end stays, the path is free,
/// costs less and has fewer gear changes. Nothing is tried where nothing may be.
#[test]
fn moves_are_squeezed_out_of_a_path_that_rocks() {
    let car = Vehicle::SEDAN;
    let curvature = car.max_curvature();
    let (mut state, mut paths) = (3_u32, 0);
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
        assert!(squeeze(rules, start, &arcs, &mut 0).is_none());
        let better = squeeze(rules, start, &arcs, &mut 8).unwrap();
        paths += 1;
        let got = arcs::end(start, &better);
        assert!((got.point() - end.point()).norm() < 1e-6);
        assert!(math::turn(got.heading, end.heading).abs() < 1e-6);
        assert!(is_free(rules, start, &better), "{posts:?}");
        assert!(arcs::direction_changes(&better) < arcs::direction_changes(&arcs));
        let [before, after] = [&arcs, &better].map(|arcs| costs.path(&checker, start, arcs));
        assert!(after < before, "{before} {after}");
    }
    assert!(paths > 20, "{paths}");
}

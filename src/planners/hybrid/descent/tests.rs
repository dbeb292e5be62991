use super::path::solve;
use super::*;
use crate::geometry::Point;
use crate::planners::hybrid::config::Config;
use crate::planners::hybrid::cost::CostModel;
use crate::vehicle::Vehicle;
use crate::vehicle::collision::{CollisionChecker, Obstacles, Solid};

/// A square of so many metres with square posts of half a metre in it.
pub(in crate::planners::hybrid) fn ground(size: f64, posts: &[(f64, f64)]) -> Obstacles {
    let square = |x: f64, y: f64, side: f64, owner: u32| Solid {
        outline: [(0.0, 0.0), (side, 0.0), (side, side), (0.0, side)]
            .map(|(dx, dy)| Point::new(x + dx, y + dy))
            .to_vec(),
        owner,
    };
    let solids: Vec<Solid> = posts.iter().zip(1..).map(|(&(x, y), owner)| square(x, y, 0.5, owner)).collect();
    Obstacles::new(&[], &solids, &square(0.0, 0.0, size, 0))
}

/// True if a path is free by finer checks than those of the rules.
pub(in crate::planners::hybrid) fn is_free(
    Rules { checker, margin, .. }: Rules,
    start: Pose,
    arcs: &[Arc],
) -> bool {
    let mut pose = start;
    arcs.iter().all(|arc| {
        let free = checker.arc_free(pose, arc, 0.05, margin);
        pose = pose.advance(arc.curvature, arc.length);
        free
    })
}

/// Hands over the ways of a car that rocks on the spot, by seed, among posts, as far as they are free; tells how many.
pub(in crate::planners::hybrid) fn rocking(mut see: impl FnMut(Rules, Pose, &[Arc])) -> u32 {
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
        let ends = [start, arcs::end(start, &arcs)];
        let costs = CostModel::driven(&Config::default(), car.min_turning_radius(), ends);
        let rules = Rules { checker: &checker, costs: &costs, spacing: 0.1, margin: 0.05 };
        if is_free(rules, start, &arcs) {
            paths += 1;
            see(rules, start, &arcs);
        }
    }
    paths
}

/// Winding paths with a gear change, by seed, among posts: the end stays, the path is free, has no more gear changes
/// and costs less than half of it in the mean.
#[test]
fn winding_paths_become_cheaper_and_keep_end_gears_and_margin() {
    let car = Vehicle::SEDAN;
    let curvature = car.max_curvature();
    let (mut state, mut paths, mut ratios) = (7_u32, 0, 0.0);
    let mut random = || {
        state = state.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
        f64::from(state >> 8) / f64::from(1 << 24)
    };
    for _ in 0..300 {
        let posts: Vec<(f64, f64)> = (0..6).map(|_| (8.0 + 44.0 * random(), 8.0 + 44.0 * random())).collect();
        let obstacles = ground(60.0, &posts);
        let checker = CollisionChecker::new(&obstacles, &car);
        let start = obstacles.local(Pose::new(30.0, 30.0, 6.0 * random()));
        let arcs: Vec<Arc> = (0..8)
            .map(|n| {
                let side = f64::from(n % 3 - 1);
                let gear = if n < 5 { 1.0 } else { -1.0 };
                Arc { curvature: side * curvature, length: gear * (0.5 + 2.5 * random()) }
            })
            .collect();
        let end = arcs::end(start, &arcs);
        let costs = CostModel::driven(&Config::default(), car.min_turning_radius(), [start, end]);
        let rules = Rules { checker: &checker, costs: &costs, spacing: 0.1, margin: 0.1 };
        if !is_free(rules, start, &arcs) {
            continue;
        }
        let better = descend(rules, start, arcs.clone());
        let got = arcs::end(start, &better);
        assert!(
            (got.point() - end.point()).norm() < 1e-6 && math::turn(got.heading, end.heading).abs() < 1e-6
        );
        assert!(is_free(rules, start, &better), "{posts:?}");
        assert!(arcs::direction_changes(&better) <= arcs::direction_changes(&arcs));
        let [before, after] = [&arcs, &better].map(|arcs| costs.path(&checker, start, arcs));
        assert!(after <= before, "{before} {after}");
        (paths, ratios) = (paths + 1, ratios + after / before);
    }
    println!("{paths} paths, {} of the cost", ratios / f64::from(paths));
    assert!(paths > 50 && ratios / f64::from(paths) < 0.5, "{paths} paths, {}", ratios / f64::from(paths));
}

/// Lengths that three columns make up, and none where two columns are one.
#[test]
fn a_sum_of_columns_is_solved_for() {
    let [a, b, c] = [[1.0, 0.5, 0.0], [0.0, 2.0, 0.3], [0.4, 0.0, 1.0]];
    let sum: Column = core::array::from_fn(|x| 2.0 * a[x] - b[x] + 0.5 * c[x]);
    let parts = solve([a, b, c], sum).unwrap();
    assert!(parts.iter().zip([2.0, -1.0, 0.5]).all(|(got, part)| (got - part).abs() < 1e-12), "{parts:?}");
    assert!(solve([a, a, c], sum).is_none());
    assert_eq!(triples(0, 8).count(), 56);
}

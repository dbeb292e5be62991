use super::*;
use crate::planners::hybrid::config::Config;
use crate::planners::hybrid::cost::CostModel;
use crate::planners::hybrid::descent::tests::ground;
use crate::planners::hybrid::widest;
use crate::vehicle::Vehicle;
use crate::vehicle::collision::CollisionChecker;

/// Winding ways past posts, by seed, that keep from two millimetres to three centimetres: nearly all keep five in the
/// end. The end stays, and so do the gears.
#[test]
fn a_winding_way_gives_way_to_posts() {
    let car = Vehicle::SEDAN;
    let margin = 0.05;
    let mut state = 5_u32;
    let mut random = || {
        state = state.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
        f64::from(state >> 8) / f64::from(1 << 24)
    };
    let (mut ways, mut wide) = (0, 0);
    for _ in 0..3000 {
        let posts: Vec<(f64, f64)> =
            (0..3).map(|_| (22.0 + 16.0 * random(), 22.0 + 16.0 * random())).collect();
        let obstacles = ground(60.0, &posts);
        let checker = CollisionChecker::new(&obstacles, &car);
        let start = obstacles.local(Pose::new(30.0, 30.0, 6.0 * random()));
        let arcs: Vec<Arc> = (0..8)
            .map(|n| {
                let (side, gear) = (f64::from(n % 3 - 1), if n < 5 { 1.0 } else { -1.0 });
                Arc { curvature: side * car.max_curvature(), length: gear * (0.5 + random()) }
            })
            .collect();
        let end = arcs::end(start, &arcs);
        let room = widest::clearance(&checker, start, &arcs);
        let at_ends = checker.clearance(start, 1.0).min(checker.clearance(end, 1.0));
        if !(0.002..0.03).contains(&room) || at_ends < margin {
            continue;
        }
        ways += 1;
        let costs = CostModel::driven(&Config::default(), car.min_turning_radius(), [start, end]);
        let rules = Rules { checker: &checker, costs: &costs, spacing: 0.1, margin };
        let Some(better) = regain(rules, start, &arcs) else { continue };
        wide += 1;
        let got = arcs::end(start, &better);
        assert!((got.point() - end.point()).norm() < 1e-6);
        assert!(math::turn(got.heading, end.heading).abs() < 1e-6);
        assert_eq!(arcs::direction_changes(&better), 1);
        assert!(widest::clearance(&checker, start, &better) >= margin - MARGIN_TOLERANCE, "{posts:?}");
    }
    assert!(ways > 10 && wide * 10 >= ways * 8, "{wide} of {ways}");
}

/// What is wide enough stays as it is, and what overlaps something is told.
#[test]
fn a_straight_way_stays_or_is_refused() {
    let car = Vehicle::SEDAN;
    let straight = [Arc { curvature: 0.0, length: 12.0 }];
    let way = |beside: f64| {
        let obstacles = ground(60.0, &[(18.0, 30.0 + beside)]);
        let checker = CollisionChecker::new(&obstacles, &car);
        let start = obstacles.local(Pose::new(10.0, 30.0, 0.0));
        let costs = CostModel::driven(&Config::default(), 5.5, [start, arcs::end(start, &straight)]);
        regain(Rules { checker: &checker, costs: &costs, spacing: 0.1, margin: 0.1 }, start, &straight)
    };
    assert_eq!(way(car.width / 2.0 + 0.2).unwrap(), straight);
    assert_eq!(way(0.0), None);
}

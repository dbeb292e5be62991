//! Short guided searches that go ahead of the others: what they find soon, and what they end early.

use parkade::geometry::{Point, Pose};
use parkade::planners::hybrid::{Config, Query, Report, Scratch, Status, plan};
use parkade::vehicle::Vehicle;
use parkade::vehicle::collision::{Edge, Obstacles, Solid};

use crate::tight_scenes::{Scene, cluttered, garage};

/// A hall of 30 m by 16 m. Its halves join where two walls leave `gap` metres between them, side by side for 6 m.
fn halves(gap: f64, config: &Config) -> Report {
    let corners = [(0.0, 0.0), (30.0, 0.0), (30.0, 16.0), (0.0, 16.0)];
    let floor = Solid { outline: corners.map(|(x, y)| Point::new(x, y)).to_vec(), owner: 0 };
    let wall = |x: f64, y: [f64; 2]| Edge { a: Point::new(x, y[0]), b: Point::new(x, y[1]), owner: 1 };
    let walls = [wall(14.0, [0.0, 11.0]), wall(14.0 + gap, [5.0, 16.0])];
    let obstacles = Obstacles::new(&walls, &[], &floor);
    let (start, goal) = (Pose::new(4.0, 4.0, 0.3), Pose::new(25.0, 12.0, 0.2));
    let query = Query { obstacles: &obstacles, vehicle: &Vehicle::SEDAN, start, goal };
    plan(&query, config, &mut Scratch::default(), false, &mut None)
}

#[test]
fn where_a_coarse_search_finds_two_wide_regions_apart_the_plan_ends_early() {
    assert!(!halves(6.0, &Config::default()).arcs.is_empty(), "a wide passage");
    let apart = halves(2.3, &Config::default());
    assert!(matches!(apart.status, Status::BudgetExhausted(_)), "{:?}", apart.status);
    assert!(apart.stats.expanded < 50_000, "{}", apart.stats.expanded);
    let asked = halves(2.3, &Config { max_expansions: Some(10_000), ..Config::default() });
    assert!(asked.stats.expanded > 80_000, "a budget that is asked for is spent: {}", asked.stats.expanded);
}

/// The levels needed over 150 000 expansions for a first path.
#[test]
fn what_the_levels_find_late_scouts_find_soon() {
    let scenes = [
        cluttered(&Vehicle::SEDAN, 151_022),
        garage(&Vehicle::PAPER, 151_061),
        garage(&Vehicle::PAPER, 151_087),
    ];
    for Scene { name, vehicle, obstacles, start, goal, .. } in &scenes {
        let query = Query { obstacles, vehicle, start: *start, goal: *goal };
        let report = plan(&query, &Config::default(), &mut Scratch::default(), false, &mut None);
        assert!(!report.arcs.is_empty() && report.margin >= 0.03, "{name}: {:?}", report.status);
        assert!(report.stats.expanded < 130_000, "{name}: {}", report.stats.expanded);
    }
}

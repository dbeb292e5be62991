//! Cells that cost more: the cheapest paths against an oracle, what comes after the search, every planner's use of
//! them.

use std::cmp::Reverse;
use std::collections::BinaryHeap;

use parkade::map::{Cell, Corner, Occupancy, Weights, line_of_sight};
use parkade::plan::{Options, Outcome, Plan, Planner};
use parkade::planners::grid_astar::{self, Config};
use parkade::planners::heuristics::Heuristic;
use parkade::planners::moves::{Neighbourhood, cost};
use parkade::planners::query::{GridScratch, Query};
use parkade::planners::registry;
use parkade::planners::{bidirectional, risk_field};
use parkade::post::SmoothMode;
use parkade::post::{Piece, prune, prune_dp, smooth};
use parkade::scenario::generate::SplitMix64;
use parkade::scenario::{Scenario, catalog};
use parkade::search::Stop;
use serde_json::{Value, json};

const CORNERS: [Corner; 3] = [Corner::Strict, Corner::NoSqueeze, Corner::Free];

/// A map with cells blocked and painted at random, start and goal free.
fn random_map(random: &mut SplitMix64) -> (Occupancy, Cell, Cell) {
    let (map, start, goal) = crate::random_maps::random_map(random, [2, 18], 35);
    let (width, height) = (map.width(), map.height());
    let mut weights = Weights::new(width, height);
    for _ in 0..random.below(30) {
        let (x, y) = (random.below(width), random.below(height));
        weights.paint(&[[x, y, 1 + random.below(width - x)]], 1 + random.below(10));
    }
    (map.weighing(weights), start, goal)
}

/// What a move costs by the cells under 120 places of it, none of them on a border for moves of up to three cells.
fn sampled(map: &Occupancy, from: Cell, to: Cell) -> i64 {
    let weights = map.weights().unwrap();
    let (dx, dy) = (to.x - from.x, to.y - from.y);
    let at = |from: i32, way: i32, k: i32| (240 * from + (2 * k + 1) * way + 120).div_euclid(240);
    let sum: i64 =
        (0..120).map(|k| i64::from(weights.at(Cell::new(at(from.x, dx, k), at(from.y, dy, k))))).sum();
    (cost(dx, dy) * sum + 119) / 120
}

/// Dijkstra's algorithm with nothing clever in it.
fn dijkstra(query: Query, neighbourhood: Neighbourhood, corner: Corner) -> Option<i64> {
    let mut best = vec![i64::MAX; query.map.len()];
    let mut open = BinaryHeap::from([Reverse((0, query.start))]);
    best[query.map.index(query.start) as usize] = 0;
    while let Some(Reverse((g, cell))) = open.pop() {
        if cell == query.goal {
            return Some(g);
        }
        for m in neighbourhood.moves() {
            let to = cell.offset(m.dx, m.dy);
            if line_of_sight(query.map, cell, to, corner) {
                let known = &mut best[query.map.index(to) as usize];
                let g = g + sampled(query.map, cell, to);
                if g < *known {
                    *known = g;
                    open.push(Reverse((g, to)));
                }
            }
        }
    }
    None
}

fn price(map: &Occupancy, path: &[Cell]) -> i64 {
    path.windows(2).map(|pair| sampled(map, pair[0], pair[1])).sum()
}

#[test]
fn paths_are_the_cheapest_by_weights() {
    let mut random = SplitMix64::new(7);
    let mut scratch = GridScratch::new();
    let mut found = 0;
    for round in 0..400_usize {
        let (map, start, goal) = random_map(&mut random);
        let query = Query { map: &map, start, goal };
        let (neighbourhood, corner) = (Neighbourhood::ALL[round % 5], CORNERS[round / 5 % 3]);
        let mut config = Config::new(neighbourhood);
        config.common.corner = corner;
        if round % 2 == 0 && neighbourhood != Neighbourhood::Four {
            config.heuristic = Heuristic::Euclid;
        }
        let best = dijkstra(query, neighbourhood, corner);
        let report = grid_astar::plan(query, neighbourhood, &config, &mut scratch, &mut ());
        assert_eq!(best.is_some(), report.outcome == Outcome::Found, "round {round}");
        let Some(best) = best else { continue };
        found += 1;
        assert_eq!((report.cost_micro, price(&map, &report.cells)), (best, best), "round {round}");

        for stop in [Stop::First, Stop::Best, Stop::Optimal] {
            let mut config = bidirectional::Config { neighbours: neighbourhood, stop, ..Default::default() };
            config.common.corner = corner;
            let report = bidirectional::plan(query, &config, &mut scratch, &mut ());
            assert_eq!(report.cost_micro, price(&map, &report.cells), "round {round}");
            assert!(report.cost_micro >= best);
            assert!(stop != Stop::Optimal || report.cost_micro == best, "round {round}");
        }
    }
    assert!(found > 250, "{found} of 400 maps had a path");
}

#[test]
fn the_risk_field_counts_weights() {
    let mut random = SplitMix64::new(11);
    let mut scratch = GridScratch::new();
    for round in 0..300_usize {
        let (map, start, goal) = random_map(&mut random);
        let query = Query { map: &map, start, goal };
        let best = dijkstra(query, Neighbourhood::Eight, Corner::Strict);
        for config in [risk_field::Config::PAPER, risk_field::Config::PLUS] {
            let report = risk_field::plan(query, &config, &mut scratch, &mut ());
            assert_eq!(best.is_some(), report.outcome == Outcome::Found, "round {round}");
            let Some(best) = best else { continue };
            // A straight line to the goal can be shorter than eight directions allow.
            assert!(config.goal_shot || report.cost_micro >= best, "round {round}");
            let moves =
                report.cells.windows(2).all(|p| (p[1].x - p[0].x).abs().max((p[1].y - p[0].y).abs()) <= 3);
            assert!(!moves || report.cost_micro == price(&map, &report.cells), "round {round}");
        }
    }
}

#[test]
fn nothing_after_the_search_makes_a_path_dearer() {
    let mut random = SplitMix64::new(3);
    let mut scratch = GridScratch::new();
    for round in 0..400_usize {
        let (map, start, goal) = random_map(&mut random);
        let query = Query { map: &map, start, goal };
        let neighbourhood = Neighbourhood::ALL[round % 5];
        let report =
            grid_astar::plan(query, neighbourhood, &Config::new(neighbourhood), &mut scratch, &mut ());
        if report.outcome != Outcome::Found {
            continue;
        }
        let weights = map.weights().unwrap();
        let point = |c: Cell| [f64::from(c.x), f64::from(c.y)];
        let along = |line: &[[f64; 2]]| -> f64 { line.windows(2).map(|p| weights.along(p[0], p[1])).sum() };
        let over = |path: &[Cell]| along(&path.iter().map(|&c| point(c)).collect::<Vec<_>>());
        let raw = over(&report.cells);
        let pruned = prune(&map, &report.cells, Corner::Strict);
        let shortest = prune_dp(&map, &report.cells, Corner::Strict);
        // Costs are rounded up to millionths.
        assert!(over(&pruned) <= raw + 1e-4, "round {round}");
        assert!(over(&shortest) <= over(&pruned) + 1e-4, "round {round}");
        let rounded = smooth(&map, &pruned, 0.5, SmoothMode::Dynamic);
        assert!(along(&Piece::polyline(&rounded.pieces, 0.1)) <= over(&pruned) + 1e-9, "round {round}");
    }
}

/// A floor of 30 m × 20 m in cells of half a metre, a car that drives east, and a stripe across most of its way.
fn striped(weight: u32, rows: u32) -> Scenario {
    let runs: Vec<Value> = (0..rows).map(|y| json!([28, y, 4])).collect();
    let scene = json!({
        "version": 1,
        "map": { "origin": [-3.0, 2.0], "width": 60, "height": 40, "resolution": 0.5 },
        "costs": [{ "id": "stripe", "runs": runs, "weight": weight }],
        "start": { "x": 1.25, "y": 10.25, "heading": 0.0 },
        "goal": { "x": 20.25, "y": 10.25, "heading": 0.0 },
    });
    Scenario::from_json(&scene).unwrap()
}

fn planned(id: &str, scene: &Scenario) -> Plan {
    Planner::new(id, scene, &serde_json::Map::new()).unwrap().plan(Options::default())
}

/// Planners for which all free cells cost the same.
const EQUAL: [&str; 5] = ["jump-point", "any-angle", "greedy", "rrt", "genetic"];

fn weighing() -> impl Iterator<Item = &'static str> {
    registry::planners().into_iter().map(|info| info.id).filter(|id| !EQUAL.contains(id))
}

/// Metres of the path in the stripe.
fn in_stripe(plan: &Plan, rows: u32) -> f64 {
    let inside = |x: f64, y: f64| (11.0..13.0).contains(&x) && y < 2.0 + f64::from(rows) / 2.0;
    let middles = plan.path.windows(2).map(|p| {
        (f64::midpoint(p[0].x, p[1].x), f64::midpoint(p[0].y, p[1].y), (p[1].point() - p[0].point()).norm())
    });
    middles.filter(|m| inside(m.0, m.1)).map(|m| m.2).sum()
}

#[test]
fn every_planner_that_can_goes_round_what_is_dear() {
    for id in weighing() {
        let (plain, dear) = (planned(id, &striped(1, 26)), planned(id, &striped(10, 26)));
        assert_eq!((plain.outcome, dear.outcome), (Outcome::Found, Outcome::Found), "{id}");
        // The first connection is taken whatever it costs.
        if id == "hybrid-classic" {
            assert!((dear.metrics.weighted_length.unwrap() - plain.metrics.length - 18.0).abs() < 0.05);
            continue;
        }
        assert!(in_stripe(&plain, 26) > 1.5, "{id}");
        // The rear axle cuts a corner that the car's middle goes round.
        let cut = if id == "cost-map" { 2.5 } else { 0.2 };
        assert!(in_stripe(&dear, 26) < cut, "{id}: {} m", in_stripe(&dear, 26));
        let weighted = dear.metrics.weighted_length.unwrap();
        // The paper's estimate is no lower bound: its path may cut a corner.
        let slack = if id == "risk-field" { 3.0 } else { 1.0 };
        assert!((0.0..slack).contains(&(weighted - dear.metrics.length + 1e-9)), "{id}: {weighted}");
        assert!(dear.metrics.length > plain.metrics.length, "{id}");
        assert!(weighted < plain.metrics.length + 9.0 * 2.0, "{id}");
    }
}

#[test]
fn a_detour_that_costs_more_is_not_taken() {
    for id in weighing() {
        let (plain, light) = (planned(id, &striped(1, 40)), planned(id, &striped(2, 40)));
        let expected = light.metrics.length + 2.0;
        assert!((light.metrics.weighted_length.unwrap() - expected).abs() < 0.05, "{id}");
        assert!((light.metrics.length - plain.metrics.length).abs() < 0.05, "{id}");
        if let (Some(before), Some(after)) = (plain.stats.cost_micro, light.stats.cost_micro) {
            // Four cells of half a metre.
            assert_eq!(after - before, 4_000_000, "{id}");
        }
        if let (Some(before), Some(after)) = (&plain.metrics.hybrid, &light.metrics.hybrid) {
            assert!((after.cost - before.cost - 2.0).abs() < 0.05, "{id}");
        }
    }
}

#[test]
fn a_weight_of_one_changes_nothing() {
    let scene = striped(1, 26);
    let bare = Scenario { costs: Vec::new(), ..scene.clone() };
    for id in registry::planners().into_iter().map(|info| info.id) {
        assert_eq!(planned(id, &scene).hash(), planned(id, &bare).hash(), "{id}");
    }
}

#[test]
fn planners_of_equal_costs_refuse_others() {
    for id in EQUAL {
        let error = Planner::new(id, &striped(4, 26), &serde_json::Map::new()).err().unwrap();
        let expected = format!("costs: must be empty for {id}, for which all free cells cost the same");
        assert_eq!(error.to_string(), expected);
    }
}

#[test]
fn costs_survive_and_are_refused_with_words() {
    let scene = striped(4, 3);
    assert_eq!(Scenario::from_json(&serde_json::to_value(&scene).unwrap()).unwrap(), scene);
    let packed = parkade::scenario::run_length::pack(&scene.costs[0].runs);
    let refused = |costs: Value| {
        let mut value = serde_json::to_value(&scene).unwrap();
        value["costs"] = costs;
        Scenario::from_json(&value).map(|scene| scene.costs).map_err(|e| e.to_string())
    };
    assert_eq!(refused(json!([{ "id": "stripe", "runs": packed, "weight": 4 }])).unwrap(), scene.costs);
    let cases = [
        (json!([{ "runs": [[0, 0, 1]] }]), "costs[0].weight: missing field"),
        (json!([{ "runs": [[0, 0, 1]], "weight": 11 }]), "costs[0].weight: must be 1 to 10, got 11"),
        (json!([{ "runs": [[0, 0, 1]], "weight": 0 }]), "costs[0].weight: must be 1 to 10, got 0"),
        (json!([{ "runs": [[0, 0, 1]], "weight": 2.5 }]), "costs[0].weight: must be a whole number"),
        (
            json!([{ "runs": [], "weight": 2 }, { "runs": [[58, 0, 3]], "weight": 2 }]),
            "costs[1].runs[0]: must lie on the 60 × 40 map, got [58, 0, 3]",
        ),
        (json!([{ "weight": 2 }]), "costs[0].runs: missing field"),
        (json!([{ "runs": [], "weight": 2, "wieght": 1 }]), "costs[0].wieght"),
        (json!({}), "costs: must be an array, got {}"),
    ];
    for (costs, message) in cases {
        let error = refused(costs).unwrap_err();
        assert!(error.starts_with(message), "{error}\nis not\n{message}");
    }
    let mut vast = serde_json::to_value(catalog::scenario("perpendicular").unwrap()).unwrap();
    (vast["map"]["width"], vast["map"]["height"]) = (json!(4096), json!(4096));
    vast["map"]["boundary"] = Value::Null;
    vast.as_object_mut().unwrap().get_mut("map").unwrap().as_object_mut().unwrap().remove("boundary");
    vast["costs"] = json!([{ "runs": [[0, 0, 1]], "weight": 10 }]);
    let error = Scenario::from_json(&vast).unwrap_err().to_string();
    assert_eq!(error, "costs: all cells times their weights must be at most 12000000, are 16777225");
}

#[test]
fn memory_is_told_and_the_same_again() {
    let scene = striped(1, 26);
    for id in registry::planners().into_iter().map(|info| info.id) {
        let mut planner = Planner::new(id, &scene, &serde_json::Map::new()).unwrap();
        let [first, again] = [0, 1].map(|_| planner.plan(Options::default()));
        assert_eq!(first.stats.memory_bytes, again.stats.memory_bytes, "{id}");
        // A byte a cell at least, and no more than a few hundred.
        assert!((2400..2_000_000).contains(&first.stats.memory_bytes), "{id}: {}", first.stats.memory_bytes);
    }
}

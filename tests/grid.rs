//! Grid planners against oracles that are too simple to be wrong.

use std::cmp::Reverse;
use std::collections::BinaryHeap;

use crate::random_maps::random_map;
use parkade::map::{Bits, Cell, Corner, Occupancy, line_of_sight};
use parkade::metrics::grid::length;
use parkade::planners::grid_astar::{self, Config};
use parkade::planners::heuristics::Heuristic;
use parkade::planners::moves::{Move, Neighbourhood, cost};
use parkade::planners::query::{GridReport, GridScratch, Query};
use parkade::planners::risk_field::{self, Fallback};
use parkade::planners::settings::Common;
use parkade::planners::{Detail, Outcome};
use parkade::planners::{any_angle, bidirectional, jump_point};
use parkade::post::SmoothMode;
use parkade::post::{prune, prune_dp, smooth};
use parkade::scenario::generate::SplitMix64;
use parkade::search::{Stop, Trace};

/// The least and the additional cells of a random map's sides.
const SIDES: [u32; 2] = [1, 24];
const CORNERS: [Corner; 3] = [Corner::Strict, Corner::NoSqueeze, Corner::Free];

/// Dijkstra's algorithm with nothing clever in it.
fn dijkstra(query: Query, neighbourhood: Neighbourhood, corner: Corner) -> Option<i64> {
    dijkstra_with(query, &neighbourhood.moves(), corner)
}

fn dijkstra_with(query: Query, moves: &[Move], corner: Corner) -> Option<i64> {
    let mut best = vec![i64::MAX; query.map.len()];
    let mut open = BinaryHeap::from([Reverse((0, query.start))]);
    best[query.map.index(query.start) as usize] = 0;
    while let Some(Reverse((g, cell))) = open.pop() {
        if cell == query.goal {
            return Some(g);
        }
        for m in moves {
            let to = cell.offset(m.dx, m.dy);
            if line_of_sight(query.map, cell, to, corner) {
                let known = &mut best[query.map.index(to) as usize];
                if g + m.cost < *known {
                    *known = g + m.cost;
                    open.push(Reverse((g + m.cost, to)));
                }
            }
        }
    }
    None
}

/// True if the report's path is joined, clear and costs what it says.
fn check_path(query: Query, corner: Corner, report: &GridReport) {
    assert_eq!((report.cells.first(), report.cells.last()), (Some(&query.start), Some(&query.goal)));
    let mut sum = 0;
    for pair in report.cells.windows(2) {
        assert!(line_of_sight(query.map, pair[0], pair[1], corner));
        sum += cost(pair[1].x - pair[0].x, pair[1].y - pair[0].y);
    }
    assert_eq!(sum, report.cost_micro);
    for path in [prune(query.map, &report.cells, corner), prune_dp(query.map, &report.cells, corner)] {
        assert!(length(&path) <= length(&report.cells) + 1e-9);
        assert!(path.windows(2).all(|pair| line_of_sight(query.map, pair[0], pair[1], corner)));
        assert_eq!((path.first(), path.last()), (Some(&query.start), Some(&query.goal)));
        for mode in [SmoothMode::Dynamic, SmoothMode::Paper] {
            let smoothed = smooth(query.map, &path, 0.5, mode);
            assert!(smoothed.min_radius.is_none_or(|r| r >= 0.5));
            assert!(
                (smoothed.length - smoothed.pieces.iter().map(parkade::post::Piece::length).sum::<f64>())
                    .abs()
                    < 1e-6
            );
        }
    }
}

#[cfg_attr(target_arch = "wasm32", wasm_bindgen_test::wasm_bindgen_test)]
#[cfg_attr(not(target_arch = "wasm32"), test)]
fn grid_searches_find_the_cheapest_path_or_none() {
    let mut random = SplitMix64::new(20);
    let mut scratch = GridScratch::new();
    let mut found = 0;
    for _ in 0..150 {
        let (map, start, goal) = random_map(&mut random, SIDES, 45);
        let query = Query { map: &map, start, goal };
        for (neighbourhood, corner) in Neighbourhood::ALL.iter().flat_map(|&n| CORNERS.map(|c| (n, c))) {
            let cheapest = dijkstra(query, neighbourhood, corner);
            for heuristic in [Heuristic::Manhattan, Heuristic::Euclid, Heuristic::Octile, Heuristic::Gauge] {
                let config =
                    Config { heuristic, common: Common { corner, ..Common::PLAIN }, ..Config::default() };
                assert_eq!(
                    config.validate_for(neighbourhood).is_ok(),
                    heuristic.is_admissible(neighbourhood)
                );
                if !heuristic.is_admissible(neighbourhood) {
                    continue;
                }
                let report = grid_astar::plan(query, neighbourhood, &config, &mut scratch, &mut ());
                if let Some(cheapest) = cheapest {
                    assert_eq!((report.outcome, report.cost_micro), (Outcome::Found, cheapest));
                    check_path(query, corner, &report);
                    found += 1;
                } else {
                    assert_eq!((report.outcome, report.detail), (Outcome::NoPath, Some(Detail::Unreachable)));
                }
            }
        }
    }
    assert!(found > 2000, "{found}");
}

#[cfg_attr(target_arch = "wasm32", wasm_bindgen_test::wasm_bindgen_test)]
#[cfg_attr(not(target_arch = "wasm32"), test)]
fn long_moves_that_short_ones_add_up_to_save_nothing() {
    let primitive = |m: &Move| (2..4).all(|k| m.dx % k != 0 || m.dy % k != 0);
    let all = Neighbourhood::FortyEight.moves();
    let some: Vec<Move> = all.iter().copied().filter(primitive).collect();
    assert_eq!(some.len(), 32);
    let mut random = SplitMix64::new(25);
    for _ in 0..1000 {
        let (map, start, goal) = random_map(&mut random, SIDES, 45);
        let query = Query { map: &map, start, goal };
        let cost = |moves: &[Move]| dijkstra_with(query, moves, Corner::Strict);
        assert_eq!(cost(&some), cost(&all));
        assert_eq!(cost(&Neighbourhood::Sixteen.moves()), cost(&Neighbourhood::TwentyFour.moves()));
    }
    println!("item 8: 24 = 16 and 48 = its 32 primitive moves, by plain Dijkstra on 1000 random maps");
}

#[cfg_attr(target_arch = "wasm32", wasm_bindgen_test::wasm_bindgen_test)]
#[cfg_attr(not(target_arch = "wasm32"), test)]
fn searches_from_both_ends_and_jumps_find_the_cheapest_path_or_none() {
    let mut random = SplitMix64::new(21);
    let mut scratch = GridScratch::new();
    let (mut found, mut dearer, mut missed) = (0, 0, 0);
    for _ in 0..1000 {
        let (map, start, goal) = random_map(&mut random, SIDES, 45);
        let query = Query { map: &map, start, goal };
        for (neighbours, corner) in Neighbourhood::ALL.iter().flat_map(|&n| CORNERS.map(|c| (n, c))) {
            let cheapest = grid_astar::plan(
                query,
                neighbours,
                &Config {
                    heuristic: Heuristic::Gauge,
                    common: Common { corner, ..Common::PLAIN },
                    ..Config::default()
                },
                &mut scratch,
                &mut (),
            );
            let costs = [Stop::Optimal, Stop::Best, Stop::First].map(|stop| {
                let common = Common { corner, ..Common::PLAIN };
                let config = bidirectional::Config { neighbours, stop, common };
                let report = bidirectional::plan(query, &config, &mut scratch, &mut ());
                assert_eq!((report.outcome, report.detail), (cheapest.outcome, cheapest.detail));
                if report.outcome == Outcome::Found {
                    check_path(query, corner, &report);
                    found += 1;
                }
                report.cost_micro
            });
            assert_eq!(costs[0], cheapest.cost_micro);
            assert!(costs[0] <= costs[1] && costs[1] <= costs[2]);
            let common = Common { corner, ..Common::PLAIN };
            let config = bidirectional::Config { neighbours, stop: Stop::Naive, common };
            let naive = bidirectional::plan(query, &config, &mut scratch, &mut ());
            match (naive.outcome, naive.detail) {
                (Outcome::Found, None) => {
                    check_path(query, corner, &naive);
                    dearer += u32::from(naive.cost_micro > costs[0]);
                    assert!(naive.cost_micro >= costs[0]);
                }
                (Outcome::NoPath, Some(Detail::Incomplete)) => {
                    missed += 1;
                    assert_eq!(cheapest.outcome, Outcome::Found);
                }
                other => assert_eq!(other, (cheapest.outcome, cheapest.detail)),
            }
        }
        let eight = grid_astar::plan(
            query,
            Neighbourhood::Eight,
            &Config::new(Neighbourhood::Eight),
            &mut scratch,
            &mut (),
        );
        let bits = Bits::new(&map);
        for prune in [false, true] {
            let config = jump_point::Config { prune, ..jump_point::Config::default() };
            let report = jump_point::plan(query, &bits, &config, &mut scratch, &mut ());
            assert_eq!((report.outcome, report.cost_micro), (eight.outcome, eight.cost_micro));
            if report.outcome == Outcome::Found {
                check_path(query, Corner::Strict, &report);
            }
        }
        let report = any_angle::plan(query, &any_angle::Config::default(), &mut scratch, &mut ());
        assert_eq!(report.outcome, eight.outcome);
        if report.outcome == Outcome::Found {
            check_path(query, Corner::Strict, &report);
        }
    }
    assert!(found > 20_000 && dearer > 1000 && missed > 10, "{found} {dearer} {missed}");
}

#[cfg_attr(target_arch = "wasm32", wasm_bindgen_test::wasm_bindgen_test)]
#[cfg_attr(not(target_arch = "wasm32"), test)]
fn risk_field_searches_are_complete_with_every_option() {
    use parkade::map::risk::{Attraction, ObstacleSet};
    use risk_field::Heuristic as Weighted;
    let (paper, plus) = (risk_field::Config::PAPER, risk_field::Config::PLUS);
    let configs = [
        paper,
        plus,
        risk_field::Config { fallback: Fallback::Lexicographic, ..paper },
        risk_field::Config { fallback: Fallback::Lexicographic, heuristic: Weighted::Printed, ..plus },
        risk_field::Config { heuristic: Weighted::Printed, obstacle_set: ObstacleSet::Sum, ..paper },
        risk_field::Config { heuristic: Weighted::Octile, obstacle_set: ObstacleSet::NearestFirst, ..paper },
        risk_field::Config { attraction: Attraction::Conic, ext_len: 0, penalty: 0.0, ..paper },
        risk_field::Config { w1: 0.5, w2: 3.25, wbar: 0.0, rho0: 5.5, k2: Some(40.0), ext_len: 5, ..paper },
        risk_field::Config { fallback: Fallback::StuckOnly, ..paper },
        risk_field::Config { fallback: Fallback::None, ..plus },
    ];
    let mut random = SplitMix64::new(30);
    let mut scratch = GridScratch::new();
    let (mut found, mut incomplete) = (0, 0);
    for _ in 0..300 {
        let (map, start, goal) = random_map(&mut random, SIDES, 45);
        let query = Query { map: &map, start, goal };
        for (mut config, corner) in configs.iter().flat_map(|&c| CORNERS.map(|corner| (c, corner))) {
            config.common.corner = corner;
            config.validate().unwrap();
            let reachable = dijkstra(query, Neighbourhood::Eight, corner).is_some();
            let report = risk_field::plan(query, &config, &mut scratch, &mut ());
            match (report.outcome, report.detail) {
                (Outcome::Found, None) => check_path(query, corner, &report),
                (Outcome::NoPath, Some(Detail::Unreachable)) => assert!(!reachable),
                (Outcome::NoPath, Some(Detail::Incomplete)) => {
                    assert!(reachable && matches!(config.fallback, Fallback::StuckOnly | Fallback::None));
                    incomplete += 1;
                }
                other => panic!("{other:?}"),
            }
            found += u32::from(reachable);
        }
    }
    assert!(found > 3000 && incomplete > 20, "{found} {incomplete}");
}

#[cfg_attr(target_arch = "wasm32", wasm_bindgen_test::wasm_bindgen_test)]
#[cfg_attr(not(target_arch = "wasm32"), test)]
fn questions_without_a_search() {
    let map = Occupancy::parse("....\n.##.\n....");
    let ask = |start, goal| {
        let query = Query { map: &map, start, goal };
        let eight = Neighbourhood::Eight;
        let grid = grid_astar::plan(query, eight, &Config::new(eight), &mut GridScratch::new(), &mut ());
        let risk = risk_field::plan(query, &risk_field::Config::PAPER, &mut GridScratch::new(), &mut ());
        assert_eq!(grid, risk);
        grid
    };
    let (corner, wall, outside) = (Cell::new(0, 0), Cell::new(1, 1), Cell::new(4, 0));
    for (start, goal, outcome) in [
        (wall, corner, Outcome::StartBlocked),
        (corner, wall, Outcome::GoalBlocked),
        (outside, wall, Outcome::StartOutside),
        (wall, outside, Outcome::GoalOutside),
        (Cell::new(0, -1), corner, Outcome::StartOutside),
    ] {
        let report = ask(start, goal);
        assert_eq!((report.outcome, report.stats.expanded, report.stats.generated), (outcome, 0, 0));
        assert!(report.cells.is_empty());
    }
    let here = ask(corner, corner);
    assert_eq!((here.outcome, here.stats.expanded, here.stats.generated), (Outcome::Found, 0, 1));
    assert_eq!(here.cells, [corner]);
}

#[cfg_attr(target_arch = "wasm32", wasm_bindgen_test::wasm_bindgen_test)]
#[cfg_attr(not(target_arch = "wasm32"), test)]
fn small_and_empty_maps() {
    let eight = Neighbourhood::Eight;
    let octile = Config { heuristic: Heuristic::Octile, ..Config::new(eight) };
    let map = Occupancy::new(12, 12);
    let query = Query { map: &map, start: Cell::new(0, 0), goal: Cell::new(11, 11) };
    let mut trace = Trace::new(5);
    let report = grid_astar::plan(query, eight, &octile, &mut GridScratch::new(), &mut trace);
    assert_eq!((report.stats.expanded, report.cost_micro), (12, 11 * 1_414_214));
    assert_eq!((trace.expanded, trace.dropped), (vec![0, 13, 26, 39, 52], 7));

    for (width, height) in [(9, 1), (1, 9)] {
        let map = Occupancy::new(width, height);
        let query = Query { map: &map, start: Cell::new(0, 0), goal: map.cell(8) };
        let risk = risk_field::plan(query, &risk_field::Config::PAPER, &mut GridScratch::new(), &mut ());
        let grid = grid_astar::plan(query, eight, &octile, &mut GridScratch::new(), &mut ());
        assert_eq!((risk.cost_micro, grid.cost_micro), (8_000_000, 8_000_000));
    }

    let budget = Config { common: Common { max_expansions: 3, ..Common::PLAIN }, ..octile };
    let report = grid_astar::plan(query, eight, &budget, &mut GridScratch::new(), &mut ());
    assert_eq!(
        (report.outcome, report.stats.expanded, report.closest),
        (Outcome::BudgetSpent, 3, Cell::new(2, 2))
    );
}

#[cfg_attr(target_arch = "wasm32", wasm_bindgen_test::wasm_bindgen_test)]
#[cfg_attr(not(target_arch = "wasm32"), test)]
fn settings_are_plain_data_and_mistakes_are_named() {
    let defaults = risk_field::Config::PAPER.to_json();
    assert_eq!(
        (&defaults["extLen"], &defaults["k2"], &defaults["post"]),
        (&1.into(), &().into(), &"smooth".into())
    );
    assert_eq!(risk_field::Config::PLUS.with(&defaults).unwrap(), risk_field::Config::PAPER);
    let parse = |text: &str| Config::default().with(&serde_json::from_str(text).unwrap());
    let config = parse(r#"{"minRadius": "vehicle", "corner": "no-squeeze", "weight": "distance"}"#).unwrap();
    assert_eq!(config.common.min_radius.in_cells(5.5, 0.5), 11.0);
    let refused = |text: &str| parse(text).unwrap_err().to_string();
    assert_eq!(
        refused(r#"{"minRadius": "car"}"#),
        "minRadius: must be a number of cells or \"vehicle\", got \"car\""
    );
    assert_eq!(
        refused(r#"{"post": "round"}"#),
        "post: must be none or prune or prune-dp or smooth, got \"round\""
    );
    assert!(
        refused(r#"{"hueristic": "octile"}"#)
            .starts_with("hueristic: no such setting; there are heuristic, weight")
    );
    let config = parse(r#"{"heuristic": "manhattan"}"#).unwrap();
    assert_eq!(
        config.validate_for(Neighbourhood::Eight).unwrap_err().to_string(),
        "heuristic: must be euclid or octile or gauge or chebyshev with 8 neighbours, got manhattan"
    );
    let bad = risk_field::Config { rho0: f64::NAN, ..risk_field::Config::PAPER };
    assert_eq!(bad.validate().unwrap_err().to_string(), "rho0: must be between 1 and 20, got NaN");
}

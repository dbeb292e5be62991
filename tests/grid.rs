//! Grid planners, rasters and distances against oracles that are too simple to be wrong.

mod random_maps;

use std::cmp::Reverse;
use std::collections::BinaryHeap;

use parkade::geometry::Point;
use parkade::map::{Bits, Cell, Corner, Frame, Occupancy, distance, inflation, line_of_sight, raster};
use parkade::metrics::grid::length;
use parkade::planners::Outcome;
use parkade::planners::grid_astar::{self, Config};
use parkade::planners::heuristics::Heuristic;
use parkade::planners::moves::{Move, Neighbourhood, cost};
use parkade::planners::query::{Detail, GridReport, GridScratch, Query};
use parkade::planners::risk_field::{self, Fallback};
use parkade::planners::settings::Common;
use parkade::planners::{any_angle, bidirectional, jump_point};
use parkade::post::SmoothMode;
use parkade::post::{prune, prune_dp, smooth};
use parkade::scenario::generate::SplitMix64;
use parkade::search::{Stop, Trace};
use random_maps::random_map;

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
                (Outcome::NoPath, Some(Detail::Stranded)) => {
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
    let (mut found, mut stranded) = (0, 0);
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
                (Outcome::NoPath, Some(Detail::Stranded)) => {
                    assert!(reachable && matches!(config.fallback, Fallback::StuckOnly | Fallback::None));
                    stranded += 1;
                }
                other => panic!("{other:?}"),
            }
            found += u32::from(reachable);
        }
    }
    assert!(found > 3000 && stranded > 20, "{found} {stranded}");
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
        assert_eq!((report.outcome, report.expanded, report.generated), (outcome, 0, 0));
        assert!(report.cells.is_empty());
    }
    let here = ask(corner, corner);
    assert_eq!((here.outcome, here.expanded, here.generated), (Outcome::Found, 0, 1));
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
    assert_eq!((report.expanded, report.cost_micro), (12, 11 * 1_414_214));
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
    assert_eq!((report.outcome, report.expanded, report.closest), (Outcome::BudgetSpent, 3, Cell::new(2, 2)));
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

/// The transform that roads use, on 200 grids of all shapes, some without obstacles and some with nothing else.
#[cfg_attr(target_arch = "wasm32", wasm_bindgen_test::wasm_bindgen_test)]
#[cfg_attr(not(target_arch = "wasm32"), test)]
fn distances_are_those_of_brute_force() {
    let mut random = SplitMix64::new(200);
    for round in 0..200 {
        let mut side = |only: usize| if round % 10 == only { 1 } else { 1 + random.below(40) };
        let mut map = Occupancy::new(side(1), side(2));
        let share = [0, 1, 2, 10, 50, 99, 100][round % 7];
        let cells: Vec<Cell> = (0..map.len() as u32).map(|i| map.cell(i)).collect();
        for &cell in &cells {
            map.set(cell, random.below(100) < share);
        }
        let blocked: Vec<Cell> = cells.iter().copied().filter(|&c| map.blocked(c)).collect();
        let centers = distance::to_centers(&map, |quarters| quarters as f32);
        for &at in &cells {
            let squared = |b: &Cell| 4 * (i64::from(b.x - at.x).pow(2) + i64::from(b.y - at.y).pow(2));
            let nearest = blocked.iter().map(squared).min().unwrap_or(distance::NONE);
            assert_eq!(centers.get(at), Some(nearest as f32), "round {round}, {at:?}");
        }
    }
}

#[cfg_attr(target_arch = "wasm32", wasm_bindgen_test::wasm_bindgen_test)]
#[cfg_attr(not(target_arch = "wasm32"), test)]
fn distances_and_inflation_are_exact() {
    let mut random = SplitMix64::new(40);
    for round in 0..60 {
        let (mut map, ..) = random_map(&mut random, SIDES, 45);
        if round == 0 {
            map = Occupancy::new(5, 4);
        }
        let blocked: Vec<Cell> =
            (0..map.len() as u32).map(|i| map.cell(i)).filter(|&c| map.blocked(c)).collect();
        let (centers, squares) = (distance::to_centers(&map, |d| d as f32), distance::to_squares(&map));
        let inflated = inflation::necessary(&map, 1.3);
        for index in 0..map.len() as u32 {
            let at = map.cell(index);
            let nearest = |side: fn(i64) -> i64| {
                let square =
                    |b: &Cell| side(i64::from(b.x - at.x)).pow(2) + side(i64::from(b.y - at.y)).pow(2);
                blocked.iter().map(square).min().unwrap_or(distance::NONE)
            };
            assert_eq!(centers.get(at), Some(nearest(|d| 2 * d) as f32));
            assert_eq!(squares.get(at), Some(nearest(|d| (2 * d.abs() - 1).max(0))));
            assert_eq!(
                inflated.blocked(at),
                (nearest(|d| (2 * d.abs() - 1).max(0)) as f64) < 4.0 * 1.3 * 1.3
            );
        }
    }
    let map = Occupancy::parse(".....\n.....\n..#..\n.....\n.....");
    let grown = [0.5, 0.51, 0.75, 1.5, 1.51].map(|radius| inflation::necessary(&map, radius).blocked_cells());
    assert_eq!(grown, [1, 5, 9, 9, 13]);
    let layer = inflation::layer(&map, &inflation::necessary(&map, 0.51));
    assert_eq!(
        (layer.get(Cell::new(2, 2)), layer.get(Cell::new(2, 3)), layer.get(Cell::new(3, 3))),
        (Some(1), Some(2), Some(0))
    );
}

/// Area of a simple polygon within a unit cell (Sutherland and Hodgman).
fn area_in_cell(outline: &[[f64; 2]], cell: Cell) -> f64 {
    let (x, y) = (f64::from(cell.x), f64::from(cell.y));
    let mut points = outline.to_vec();
    for (axis, bound, sign) in [(0, x, 1.0), (0, x + 1.0, -1.0), (1, y, 1.0), (1, y + 1.0, -1.0)] {
        let depth = |p: &[f64; 2]| sign * (p[axis] - bound);
        let mut kept = Vec::new();
        for (a, b) in points.iter().zip(points.iter().cycle().skip(1)) {
            let (da, db) = (depth(a), depth(b));
            if da >= 0.0 {
                kept.push(*a);
            }
            if (da > 0.0 && db < 0.0) || (da < 0.0 && db > 0.0) {
                let t = da / (da - db);
                kept.push([a[0] + t * (b[0] - a[0]), a[1] + t * (b[1] - a[1])]);
            }
        }
        points = kept;
    }
    let pairs = points.iter().zip(points.iter().cycle().skip(1));
    pairs.map(|(a, b)| a[0] * b[1] - b[0] * a[1]).sum::<f64>().abs() / 2.0
}

#[cfg_attr(target_arch = "wasm32", wasm_bindgen_test::wasm_bindgen_test)]
#[cfg_attr(not(target_arch = "wasm32"), test)]
fn outlines_block_what_they_overlap() {
    let frame = Frame { origin: Point::new(-3.7, 12.4), width: 20, height: 16, resolution: 0.3 };
    let mut random = SplitMix64::new(50);
    for round in 0..300 {
        // A star around a point is simple; every third one has corners on cell corners.
        let middle = [f64::from(random.below(24)) - 2.0, f64::from(random.below(20)) - 2.0];
        let outline: Vec<[f64; 2]> = (0..3 + random.below(8))
            .map(|_| (random.below(6283), 0.5 + f64::from(random.below(900)) / 100.0))
            .collect::<std::collections::BTreeMap<_, _>>()
            .into_iter()
            .map(|(angle, r)| {
                let (sin, cos) = parkade::geometry::math::sin_cos(f64::from(angle) / 1000.0);
                [middle[0] + r * cos, middle[1] + r * sin]
            })
            .map(|p| if round % 3 == 0 { p.map(f64::round) } else { p })
            .collect();
        let points: Vec<Point> = outline.iter().map(|p| frame.world([p[0] - 0.5, p[1] - 0.5])).collect();
        let (mut filled, mut outside) = (Occupancy::new(20, 16), Occupancy::new(20, 16));
        raster::fill(&mut filled, &frame, &points);
        raster::fill_outside(&mut outside, &frame, &points);
        for index in 0..filled.len() as u32 {
            let cell = filled.cell(index);
            let area = area_in_cell(&outline, cell);
            if area > 1e-6 {
                assert!(filled.blocked(cell), "{outline:?} {cell:?} {area}");
            } else if round % 3 != 0 && area == 0.0 {
                assert!(!filled.blocked(cell), "{outline:?} {cell:?}");
            }
            if area < 1.0 - 1e-6 {
                assert!(outside.blocked(cell), "{outline:?} {cell:?} {area}");
            } else if area > 1.0 - 1e-12 && round % 3 != 0 {
                assert!(!outside.blocked(cell), "{outline:?} {cell:?} {area}");
            }
        }
    }
}

#[cfg_attr(target_arch = "wasm32", wasm_bindgen_test::wasm_bindgen_test)]
#[cfg_attr(not(target_arch = "wasm32"), test)]
fn walls_touch_and_rectangles_on_edges_do_not_leak() {
    let frame = Frame { origin: Point::new(-0.05, -0.05), width: 8, height: 6, resolution: 0.1 };
    let corners = [(0.25, 0.15), (0.45, 0.15), (0.45, 0.35), (0.25, 0.35)].map(|(x, y)| Point::new(x, y));
    let mut map = Occupancy::new(8, 6);
    raster::fill(&mut map, &frame, &corners);
    assert_eq!(raster::to_runs(&map), [[3, 2, 2], [3, 3, 2]]);

    let mut outside = Occupancy::new(8, 6);
    raster::fill_outside(&mut outside, &frame, &corners);
    assert_eq!(outside.blocked_cells(), 44);

    // Along an edge a wall touches the cells of both sides, and the cells that share its ends' corners.
    let mut wall = Occupancy::new(8, 6);
    raster::wall(&mut wall, &frame, &[Point::new(0.25, 0.15), Point::new(0.45, 0.15)]);
    assert_eq!(raster::to_runs(&wall), [[2, 1, 4], [2, 2, 4]]);

    let mut diagonal = Occupancy::new(8, 6);
    raster::wall(&mut diagonal, &frame, &[Point::new(0.0, 0.0), Point::new(0.2, 0.2)]);
    assert_eq!(raster::to_runs(&diagonal), [[0, 0, 2], [0, 1, 3], [1, 2, 2]]);

    let mut brushed = Occupancy::new(8, 6);
    raster::runs(&mut brushed, &[[6, 0, 9], [0, 9, 1]]);
    assert_eq!(raster::to_runs(&brushed), [[6, 0, 2]]);
}

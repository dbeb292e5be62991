//! Planners to compare with: Dijkstra's search, greedy best-first search, RRT and a genetic algorithm.

use parkade::map::{Cell, Corner, Occupancy, line_of_sight};
use parkade::planners::dijkstra_greedy::{self, dijkstra, greedy};
use parkade::planners::moves::{Neighbourhood, cost};
use parkade::planners::query::{GridReport, GridScratch, Query};
use parkade::planners::settings::Common;
use parkade::planners::{Detail, Outcome};
use parkade::planners::{genetic, grid_astar, rrt};
use parkade::scenario::generate::{Family, occupancy};
#[cfg(target_arch = "wasm32")]
use wasm_bindgen_test::wasm_bindgen_test as test;

const CORNERS: [Corner; 3] = [Corner::Strict, Corner::NoSqueeze, Corner::Free];

/// True if the legs are free by their corner rule, join start and goal, and cost what is said.
fn check_path(query: Query, corner: Corner, report: &GridReport) {
    assert_eq!((report.cells.first(), report.cells.last()), (Some(&query.start), Some(&query.goal)));
    let legs = report.cells.windows(2);
    assert!(legs.clone().all(|leg| line_of_sight(query.map, leg[0], leg[1], corner)));
    assert_eq!(legs.map(|l| cost(l[1].x - l[0].x, l[1].y - l[0].y)).sum::<i64>(), report.cost_micro);
}

fn maps() -> impl Iterator<Item = Occupancy> {
    (1..=12)
        .flat_map(|seed| [Family::RANDOM, Family::Regular].map(|family| occupancy(family, 25, seed).unwrap()))
}

fn across(map: &Occupancy) -> Query<'_> {
    let end = map.width() as i32 - 1;
    Query { map, start: Cell::new(0, 0), goal: Cell::new(end, end) }
}

#[test]
fn dijkstra_costs_as_a_star_and_expands_no_less() {
    let mut scratch = GridScratch::new();
    let (mut more, mut asked) = (0, 0);
    for map in maps() {
        let query = across(&map);
        for (neighbours, corner) in Neighbourhood::ALL.iter().flat_map(|&n| CORNERS.map(|c| (n, c))) {
            let common = Common { corner, ..Common::PLAIN };
            let report =
                dijkstra(query, &dijkstra_greedy::Config { neighbours, common }, &mut scratch, &mut ());
            let config = grid_astar::Config { common, ..grid_astar::Config::new(neighbours) };
            let star = grid_astar::plan(query, neighbours, &config, &mut scratch, &mut ());
            assert_eq!((report.outcome, report.cost_micro), (star.outcome, star.cost_micro));
            if report.outcome == Outcome::Found {
                check_path(query, corner, &report);
                (more, asked) = (more + u32::from(report.stats.expanded > star.stats.expanded), asked + 1);
            }
        }
    }
    assert!(asked > 200 && more > asked * 9 / 10, "{more} of {asked}");
}

#[test]
fn greedy_finds_a_path_wherever_there_is_one_and_seldom_the_cheapest() {
    let mut scratch = GridScratch::new();
    let (mut dearer, mut asked) = (0, 0);
    for map in maps() {
        let query = across(&map);
        for (neighbours, corner) in Neighbourhood::ALL.iter().flat_map(|&n| CORNERS.map(|c| (n, c))) {
            let config = dijkstra_greedy::Config { neighbours, common: Common { corner, ..Common::PLAIN } };
            let [best, report] = [
                dijkstra(query, &config, &mut scratch, &mut ()),
                greedy(query, &config, &mut scratch, &mut ()),
            ];
            assert_eq!((report.outcome, report.detail), (best.outcome, best.detail));
            if report.outcome == Outcome::Found {
                check_path(query, corner, &report);
                assert!(
                    report.cost_micro >= best.cost_micro && report.stats.generated <= best.stats.generated
                );
                // No cell is taken up twice: a move costs nothing, so the first way to a cell stays.
                assert_eq!(report.stats.pushes, report.stats.generated);
                (dearer, asked) = (dearer + u32::from(report.cost_micro > best.cost_micro), asked + 1);
            }
        }
    }
    assert!(asked > 200 && dearer > asked / 2, "{dearer} of {asked}");
}

#[test]
fn both_tell_how_near_they_came() {
    let map = Occupancy::parse(".....\n....#\n...#.");
    let query = Query { map: &map, start: Cell::new(0, 2), goal: Cell::new(4, 0) };
    for search in [dijkstra::<()>, greedy::<()>] {
        let report = search(query, &dijkstra_greedy::Config::default(), &mut GridScratch::new(), &mut ());
        assert_eq!((report.outcome, report.detail), (Outcome::NoPath, Some(Detail::Unreachable)));
        assert_eq!(report.closest, Cell::new(3, 1));
    }
}

#[test]
fn random_trees_and_generations_keep_to_free_cells() {
    let mut scratch = GridScratch::new();
    let mut found = [0, 0];
    for (at, map) in maps().enumerate() {
        let (query, corner) = (across(&map), CORNERS[at % 3]);
        let shortest = dijkstra(
            query,
            &dijkstra_greedy::Config {
                neighbours: Neighbourhood::FortyEight,
                common: Common { corner, ..Common::PLAIN },
            },
            &mut scratch,
            &mut (),
        );
        for seed in 1..=2 {
            let (mut tree, mut genes) = (rrt::Config::DEFAULT, genetic::Config::DEFAULT);
            (tree.seed, tree.common.corner) = (seed, corner);
            (genes.seed, genes.common.corner, genes.common.max_expansions) = (seed, corner, 4000);
            let reports = [
                rrt::plan(query, &tree, &mut scratch, &mut ()),
                genetic::plan(query, &genes, &mut scratch, &mut ()),
            ];
            for (count, report) in found.iter_mut().zip(&reports) {
                if report.outcome == Outcome::Found {
                    check_path(query, corner, report);
                    *count += 1;
                    // Any angle saves at most 1.4 % of 48 neighbours' length.
                    assert!(report.cost_micro as f64 > 0.97 * shortest.cost_micro as f64);
                } else {
                    assert_eq!(report.outcome, Outcome::BudgetSpent);
                }
            }
        }
    }
    assert!(found[0] > 44 && found[1] > 40, "{found:?} of 48");
}

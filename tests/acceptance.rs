//! What the grid planners promise over many seeded maps, as figures, items 1 to 10:
//! `cargo test --release --test all -- golden acceptance --nocapture`. Item 1, the golden vectors, is `golden/`.
//!
//! 200 maps per row natively, fewer in wasm, where the same numbers come out of the same code.

use parkade::map::{Bits, Cell, Corner, Occupancy, line_of_sight};
use parkade::metrics::any_angle_length;
use parkade::metrics::grid::{length, turns};
use parkade::planners::Outcome;
use parkade::planners::grid_astar::{self, Config, Weight};
#[cfg(not(target_arch = "wasm32"))]
use parkade::planners::heuristics::Heuristic;
use parkade::planners::moves::{Neighbourhood, cost};
use parkade::planners::query::{GridReport, GridScratch, Query};
use parkade::planners::{bidirectional, jump_point, risk_field};
use parkade::post::SmoothMode;
use parkade::post::{Piece, prune, prune_dp, smooth};
use parkade::scenario::generate::{self, Family};
use parkade::search::Stop;

const SEEDS: u64 = if cfg!(target_arch = "wasm32") { 20 } else { 200 };
/// Maps per row on which the any-angle yardstick is computed, which is slow without optimisation.
const YARDSTICK_SEEDS: u64 = if cfg!(target_arch = "wasm32") {
    2
} else if cfg!(debug_assertions) {
    12
} else {
    SEEDS
};
const STRICT: Corner = Corner::Strict;

fn map(family: Family, size: u32, seed: u64) -> Occupancy {
    generate::occupancy(family, size, seed).unwrap()
}

fn query(map: &Occupancy) -> Query<'_> {
    let end = map.width() as i32 - 1;
    Query { map, start: Cell::new(0, 0), goal: Cell::new(end, end) }
}

fn astar(
    map: &Occupancy,
    neighbourhood: Neighbourhood,
    weight: Weight,
    scratch: &mut GridScratch,
) -> GridReport {
    let config = Config { weight, ..Config::new(neighbourhood) };
    grid_astar::plan(query(map), neighbourhood, &config, scratch, &mut ())
}

fn risk(map: &Occupancy, config: &risk_field::Config, scratch: &mut GridScratch) -> GridReport {
    let report = risk_field::plan(query(map), config, scratch, &mut ());
    assert_eq!(report.outcome, Outcome::Found);
    report
}

/// Sorted values, for quantiles.
struct Sample(Vec<f64>);

impl Sample {
    fn of(mut values: Vec<f64>) -> Self {
        values.sort_by(f64::total_cmp);
        Self(values)
    }

    fn quantile(&self, q: f64) -> f64 {
        self.0[((self.0.len() - 1) as f64 * q).round() as usize]
    }

    fn median(&self) -> f64 {
        self.quantile(0.5)
    }

    fn worst(&self) -> f64 {
        self.quantile(1.0)
    }
}

impl std::fmt::Display for Sample {
    fn fmt(&self, f: &mut std::fmt::Formatter) -> std::fmt::Result {
        write!(f, "{:.3} / {:.3} / {:.3}", self.median(), self.quantile(0.95), self.worst())
    }
}

fn yardstick(map: &Occupancy) -> f64 {
    let Query { start, goal, .. } = query(map);
    any_angle_length(map, start, goal).unwrap()
}

struct Row {
    family: Family,
    size: u32,
    /// Cells that the paper's improved planner generates.
    printed: f64,
    /// Bounds of the medians of generated cells against eight neighbours: risk, risk plus.
    share: (f64, f64),
}

fn rows() -> Vec<Row> {
    let shares = [(30, (0.26, 0.20)), (60, (0.16, 0.13)), (100, (0.11, 0.09))];
    let printed = [(Family::Regular, [81.0, 155.0, 260.0]), (Family::RANDOM, [83.0, 160.0, 248.0])];
    let row = |family, k: usize, printed| Row { family, size: shares[k].0, printed, share: shares[k].1 };
    printed.into_iter().flat_map(|(family, p)| (0..3).map(move |k| row(family, k, p[k]))).collect()
}

/// What is kept of one map.
struct Figures {
    risk: [f64; 4],
    plus: [f64; 2],
}

fn figures(map: &Occupancy, scratch: &mut GridScratch) -> Figures {
    let eight = astar(map, Neighbourhood::Eight, Weight::None, scratch);
    let weighted = astar(map, Neighbourhood::Eight, Weight::Distance, scratch);
    let generated = |report: &GridReport| f64::from(report.stats.generated);
    let pruned = |report: &GridReport| length(&prune(map, &report.cells, STRICT));
    let faithful = risk(map, &risk_field::Config::PAPER, scratch);
    let plus = risk(map, &risk_field::Config::PLUS, scratch);
    let shortest = prune_dp(map, &plus.cells, STRICT);
    Figures {
        risk: [
            generated(&faithful),
            generated(&faithful) / generated(&eight),
            generated(&faithful) / generated(&weighted),
            pruned(&faithful) / pruned(&eight),
        ],
        plus: [generated(&plus) / generated(&eight), length(&shortest) / pruned(&eight)],
    }
}

#[cfg_attr(target_arch = "wasm32", wasm_bindgen_test::wasm_bindgen_test)]
#[cfg_attr(not(target_arch = "wasm32"), test)]
fn risk_field_keeps_its_promises() {
    let mut scratch = GridScratch::new();
    for row in rows() {
        let all: Vec<Figures> =
            (1..=SEEDS).map(|seed| figures(&map(row.family, row.size, seed), &mut scratch)).collect();
        let risk = |k: usize| Sample::of(all.iter().map(|f| f.risk[k]).collect());
        let plus = |k: usize| Sample::of(all.iter().map(|f| f.plus[k]).collect());
        let [generated, share, weighted, pruned] = [0, 1, 2, 3].map(risk);
        let [plus_share, plus_length] = [0, 1].map(plus);
        println!(
            "items 2 to 6, {:?} {}: risk {generated}, of eight {share}, of weighted eight {weighted}, length {pruned}; \
             plus of eight {plus_share}, length {plus_length}",
            row.family, row.size
        );
        if SEEDS < 200 {
            continue;
        }
        assert!(share.median() <= row.share.0 && share.worst() <= 0.46);
        assert!(weighted.median() <= 0.63);
        assert!((generated.median() / row.printed - 1.0).abs() <= 0.15);
        assert!(pruned.median() <= 1.03);
        assert!(plus_share.median() <= row.share.1);
        assert!(
            plus_length.median() <= 1.0 && plus_length.quantile(0.95) <= 1.03 && plus_length.worst() <= 1.06
        );
    }
}

#[cfg_attr(target_arch = "wasm32", wasm_bindgen_test::wasm_bindgen_test)]
#[cfg_attr(not(target_arch = "wasm32"), test)]
fn risk_field_plus_is_near_the_any_angle_optimum() {
    let mut scratch = GridScratch::new();
    for row in rows() {
        let ratio = |seed| {
            let map = map(row.family, row.size, seed);
            let plus = risk(&map, &risk_field::Config::PLUS, &mut scratch);
            length(&prune_dp(&map, &plus.cells, STRICT)) / yardstick(&map)
        };
        let ratios = Sample::of((1..=YARDSTICK_SEEDS).map(ratio).collect());
        println!(
            "item 6, {:?} {}: plus over the yardstick {ratios}, {YARDSTICK_SEEDS} maps",
            row.family, row.size
        );
        // Two maps have no median worth the name.
        assert!(ratios.0[0] > 0.998 && (SEEDS < 200 || ratios.median() <= 1.012));
    }
}

#[cfg_attr(target_arch = "wasm32", wasm_bindgen_test::wasm_bindgen_test)]
#[cfg_attr(not(target_arch = "wasm32"), test)]
fn risk_field_never_loses_the_way() {
    let mut scratch = GridScratch::new();
    let dense = |density_permille| Family::Random { density_permille, block_min: 1, block_max: 3 };
    for family in [Family::Trap, dense(200), dense(250), dense(300)] {
        for (size, seed) in [30, 60, 100].into_iter().flat_map(|n| (1..=SEEDS).map(move |s| (n, s))) {
            let map = map(family, size, seed);
            risk(&map, &risk_field::Config::PAPER, &mut scratch);
            risk(&map, &risk_field::Config::PLUS, &mut scratch);
        }
    }
    println!("item 7: risk and risk plus found a path on all {} maps", SEEDS * 12);
}

/// What is kept of a map's searches by sixteen neighbours: over eight, and from both ends over from one.
struct BesideSixteen {
    length: f64,
    turning: f64,
    first: [f64; 2],
    best: f64,
    optimal: f64,
}

/// What must hold of the costs on every map: of the neighbourhoods, of searches from both ends, of jump points.
fn costs_agree(map: &Occupancy, scratch: &mut GridScratch) -> BesideSixteen {
    use Neighbourhood::{Eight, FortyEight, Four, Sixteen, TwentyFour};
    let all = [Four, Eight, Sixteen, TwentyFour, FortyEight];
    let reports = all.map(|n| astar(map, n, Weight::None, scratch));
    let [four, eight, sixteen, more, most] = [0, 1, 2, 3, 4].map(|k: usize| reports[k].cost_micro);
    assert_eq!(more, sixteen);
    assert!(most <= sixteen && sixteen <= eight && eight <= four);
    let both_ways: Vec<[GridReport; 3]> = all
        .into_iter()
        .zip(&reports)
        .map(|(neighbours, report)| {
            let both = [Stop::First, Stop::Best, Stop::Optimal].map(|stop| {
                let config = bidirectional::Config { neighbours, stop, ..bidirectional::Config::default() };
                let both = bidirectional::plan(query(map), &config, scratch, &mut ());
                assert_eq!(both.outcome, Outcome::Found);
                assert_eq!(both.cost_micro, walked(map, &both.cells));
                both
            });
            let [first, best, optimal] = [0, 1, 2].map(|k: usize| both[k].cost_micro);
            assert_eq!(optimal, report.cost_micro);
            assert!(report.cost_micro <= best && best <= first);
            assert_eq!(both[0].stats.expanded, both[1].stats.expanded);
            both
        })
        .collect();
    let [first, best, optimal] = &both_ways[2];
    let bits = Bits::new(map);
    for prune in [false, true] {
        let config = jump_point::Config { prune, ..jump_point::Config::default() };
        let jumps = jump_point::plan(query(map), &bits, &config, scratch, &mut ());
        assert_eq!((jumps.cost_micro, walked(map, &jumps.cells)), (eight, eight));
    }
    let [_, eight, sixteen, ..] = reports;
    let over = |report: &GridReport| length(&report.cells) / length(&sixteen.cells);
    let work = |report: &GridReport| f64::from(report.stats.expanded) / f64::from(sixteen.stats.expanded);
    BesideSixteen {
        length: length(&sixteen.cells) / length(&eight.cells),
        turning: turns(&sixteen.cells).angle_deg / turns(&eight.cells).angle_deg,
        first: [over(first), work(first)],
        best: over(best),
        optimal: work(optimal),
    }
}

/// What a path costs, every move of it checked.
fn walked(map: &Occupancy, path: &[Cell]) -> i64 {
    assert!(path.windows(2).all(|pair| line_of_sight(map, pair[0], pair[1], STRICT)));
    path.windows(2).map(|pair| cost(pair[1].x - pair[0].x, pair[1].y - pair[0].y)).sum()
}

#[cfg_attr(target_arch = "wasm32", wasm_bindgen_test::wasm_bindgen_test)]
#[cfg_attr(not(target_arch = "wasm32"), test)]
fn costs_agree_on_every_map() {
    let mut scratch = GridScratch::new();
    for row in rows() {
        let all: Vec<BesideSixteen> =
            (1..=SEEDS).map(|seed| costs_agree(&map(row.family, row.size, seed), &mut scratch)).collect();
        let sample = |figure: fn(&BesideSixteen) -> f64| Sample::of(all.iter().map(figure).collect());
        let (lengths, angles) = (sample(|f| f.length), sample(|f| f.turning));
        println!("item 9, {:?} {}: 16 against 8, length {lengths}, turning {angles}", row.family, row.size);
        assert!(lengths.median() <= 0.975);
        assert!(angles.median() <= 0.6);
        let (first, work) = (sample(|f| f.first[0]), sample(|f| f.first[1]));
        println!(
            "Y3, {:?} {}: 16 from both ends against from one, a path on all of {SEEDS} maps; first: length {first}, \
             longer on {}, expanded {work}; best: length {}; nba: equal, expanded {}",
            row.family,
            row.size,
            first.0.iter().filter(|ratio| **ratio > 1.0 + 1e-9).count(),
            sample(|f| f.best),
            sample(|f| f.optimal)
        );
        // The quality is kept in the median, not on every map.
        assert!(first.median() <= 1.006 && first.worst() <= 1.08 && (SEEDS < 200 || work.median() < 1.0));
    }
    // Traps and dense maps, where detours are long.
    let dense = Family::Random { density_permille: 300, block_min: 1, block_max: 3 };
    for (family, seed) in [Family::Trap, dense].into_iter().flat_map(|f| (1..=SEEDS).map(move |s| (f, s))) {
        costs_agree(&map(family, 60, seed), &mut scratch);
    }
    println!(
        "item 8: nba = a*, 24 = 16, jump-point = 8, 48 ≤ 16 ≤ 8 ≤ 4, nba ≤ best ≤ first on {} maps",
        SEEDS * 8
    );
}

#[cfg_attr(target_arch = "wasm32", wasm_bindgen_test::wasm_bindgen_test)]
#[cfg_attr(not(target_arch = "wasm32"), test)]
fn processed_paths_are_free_and_not_longer() {
    let mut scratch = GridScratch::new();
    let (mut paths, mut arcs) = (0, 0);
    for row in rows() {
        for seed in 1..=SEEDS {
            let map = map(row.family, row.size, seed);
            let eight = astar(&map, Neighbourhood::Eight, Weight::None, &mut scratch);
            for report in [eight, risk(&map, &risk_field::Config::PAPER, &mut scratch)] {
                let raw = length(&report.cells);
                let pruned = prune(&map, &report.cells, STRICT);
                for path in [&pruned, &prune_dp(&map, &report.cells, STRICT)] {
                    walked(&map, path);
                    assert!(length(path) <= raw + 1e-9);
                }
                let smoothed = smooth(&map, &pruned, 1.0, SmoothMode::Dynamic);
                for piece in &smoothed.pieces {
                    let samples = (piece.length() / 0.1).ceil().max(1.0) as u32;
                    let points = (0..=samples).map(|k| piece.point(f64::from(k) / f64::from(samples)));
                    // Straight pieces lie on the pruned path's, which have just been walked.
                    let arc = matches!(piece, Piece::Arc { .. });
                    arcs += u32::from(arc);
                    for [x, y] in points.filter(|_| arc) {
                        let cell = Cell::new((x + 0.5).floor() as i32, (y + 0.5).floor() as i32);
                        assert!(!map.blocked(cell));
                    }
                }
                paths += 1;
            }
        }
    }
    println!(
        "item 10: {paths} paths pruned, dp-pruned and smoothed ({arcs} arcs), none through an obstacle or longer"
    );
}

/// A sample of the `MovingAI` questions; `cargo run --release --example movingai -- check FOLDER` asks all.
#[cfg(not(target_arch = "wasm32"))]
#[test]
fn movingai_lengths_are_reached() {
    use std::path::PathBuf;
    let root = PathBuf::from(env!("CARGO_MANIFEST_DIR"));
    let data = std::env::var_os("PARKADE_DATA").map_or_else(|| root.join("../shared/data"), PathBuf::from);
    let folder = data.join("movingai");
    let names = ["Berlin_0_256", "brc202d", "random512-25-0", "maze512-4-0"];
    if !names.iter().all(|name| folder.join(format!("{name}.map.scen")).exists()) {
        println!(
            "skipped: no MovingAI maps in {}; put {} from movingai.com/benchmarks there, or set PARKADE_DATA",
            folder.display(),
            names.join(", ")
        );
        return;
    }
    let mut scratch = GridScratch::new();
    for name in names {
        let text = String::from_utf8(std::fs::read(folder.join(format!("{name}.map"))).unwrap()).unwrap();
        // Rows from the north downward, as the questions count them.
        let mut rows: Vec<&str> = text.lines().skip(4).filter(|l| !l.is_empty()).collect();
        rows.reverse();
        let map = Occupancy::parse(&rows.join("\n"));
        let bits = Bits::new(&map);
        let questions = std::fs::read_to_string(folder.join(format!("{name}.map.scen"))).unwrap();
        let lines: Vec<&str> = questions.lines().skip(1).filter(|l| !l.trim().is_empty()).collect();
        let mut asked = 0;
        for line in lines.iter().step_by(lines.len() / 12) {
            let words: Vec<&str> = line.split_whitespace().collect();
            let n = |k: usize| words[k].parse::<i32>().unwrap();
            let query = Query { map: &map, start: Cell::new(n(4), n(5)), goal: Cell::new(n(6), n(7)) };
            let printed: f64 = words[8].parse().unwrap();
            let eight = Neighbourhood::Eight;
            let config = Config { heuristic: Heuristic::Octile, ..Config::new(eight) };
            let plain = grid_astar::plan(query, eight, &config, &mut scratch, &mut ());
            let jumps = jump_point::plan(query, &bits, &jump_point::Config::default(), &mut scratch, &mut ());
            assert_eq!(jumps.cost_micro, plain.cost_micro);
            for report in [plain, jumps] {
                assert_eq!(walked(&map, &report.cells), report.cost_micro);
                assert!((length(&report.cells) - printed).abs() <= printed * 2e-5 + 0.006, "{name}: {line}");
            }
            asked += 1;
        }
        println!("{name}: {asked} questions answered with the printed length by eight and jump-point");
    }
}

//! What the risk-field planners promise over many seeded maps, and how the neighbourhoods compare.
//!
//! 200 maps per row natively, fewer in wasm, where the same numbers come out of the same code.

use std::cmp::Reverse;
use std::collections::BinaryHeap;

use parkade::map::{Cell, Corner, Occupancy, line_of_sight};
use parkade::metrics::grid::{length, turns};
use parkade::planners::grid_astar::{self, Config, Weight};
use parkade::planners::moves::Neighbourhood;
use parkade::planners::query::{GridReport, GridScratch, Query, Status};
use parkade::planners::risk_field;
use parkade::post::{prune, prune_dp};
use parkade::scenario::generate::{self, Family};

const SEEDS: u64 = if cfg!(target_arch = "wasm32") { 20 } else { 200 };
/// Maps per row on which the any-angle yardstick, which is slow, is computed.
const YARDSTICK_SEEDS: u64 = if cfg!(target_arch = "wasm32") { 2 } else { 12 };
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
    assert_eq!(report.status, Status::Found);
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

/// The shortest any-angle path over cells beside convex corners, to within a thousandth: visibility A*.
fn yardstick(map: &Occupancy) -> f64 {
    let Query { start, goal, .. } = query(map);
    let is_corner = |c: Cell| {
        !map.blocked(c)
            && [(1, 1), (1, -1), (-1, 1), (-1, -1)].iter().any(|&(dx, dy)| {
                map.is_obstacle(c.offset(dx, dy))
                    && !map.blocked(c.offset(dx, 0))
                    && !map.blocked(c.offset(0, dy))
            })
    };
    let is_node = |c: Cell| {
        let near = |k: i32| c.offset(k % 3 - 1, k / 3 - 1);
        !map.blocked(c) && (c == start || c == goal || (0..9).any(|k| is_corner(near(k))))
    };
    let nodes: Vec<Cell> = (0..map.len() as u32).map(|i| map.cell(i)).filter(|&c| is_node(c)).collect();
    let far = |a: Cell, b: Cell| f64::from((a.x - b.x).pow(2) + (a.y - b.y).pow(2)).sqrt();
    let mut best = vec![f64::INFINITY; nodes.len()];
    let mut done = vec![false; nodes.len()];
    let first = nodes.iter().position(|&c| c == start).unwrap();
    best[first] = 0.0;
    // Lengths are positive, so their bits are ordered as they are.
    let mut open = BinaryHeap::from([(Reverse(far(start, goal).to_bits()), first)]);
    while let Some((_, u)) = open.pop() {
        if nodes[u] == goal {
            return best[u];
        }
        if std::mem::replace(&mut done[u], true) {
            continue;
        }
        for v in 0..nodes.len() {
            let g = best[u] + far(nodes[u], nodes[v]);
            if !done[v] && g < best[v] && line_of_sight(map, nodes[u], nodes[v], STRICT) {
                best[v] = g;
                open.push((Reverse((g + far(nodes[v], goal)).to_bits()), v));
            }
        }
    }
    f64::INFINITY
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
    let generated = |report: &GridReport| f64::from(report.generated);
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
            "{:?} {}: risk {generated}, of eight {share}, of weighted eight {weighted}, length {pruned}; \
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
        println!("{:?} {}: plus over the yardstick {ratios}", row.family, row.size);
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
}

#[cfg_attr(target_arch = "wasm32", wasm_bindgen_test::wasm_bindgen_test)]
#[cfg_attr(not(target_arch = "wasm32"), test)]
fn more_neighbours_are_never_longer() {
    use Neighbourhood::{Eight, FortyEight, Four, Sixteen, TwentyFour};
    let mut scratch = GridScratch::new();
    for row in rows() {
        let (mut lengths, mut angles) = (Vec::new(), Vec::new());
        for seed in 1..=SEEDS {
            let map = map(row.family, row.size, seed);
            let [four, eight, sixteen, more, most] = [Four, Eight, Sixteen, TwentyFour, FortyEight]
                .map(|n| astar(&map, n, Weight::None, &mut scratch));
            assert_eq!(more.cost_micro, sixteen.cost_micro);
            assert!(most.cost_micro <= sixteen.cost_micro && sixteen.cost_micro <= eight.cost_micro);
            assert!(eight.cost_micro <= four.cost_micro);
            lengths.push(length(&sixteen.cells) / length(&eight.cells));
            angles.push(turns(&sixteen.cells).angle_deg / turns(&eight.cells).angle_deg);
        }
        let (lengths, angles) = (Sample::of(lengths), Sample::of(angles));
        println!("{:?} {}: 16 against 8, length {lengths}, turning {angles}", row.family, row.size);
        assert!(lengths.median() <= 0.975);
        assert!(angles.median() <= 0.6);
    }
}

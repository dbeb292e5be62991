//! What holds of every path.

use std::f64::consts::{PI, TAU};

use parkade::geometry::{Pose, arcs, math, reeds_shepp};
use parkade::planners::hybrid::{Config, Last, Query, Report, Scratch, stay};

use super::lot::{CAR, Lot, pose, random, random_scenes};

#[cfg_attr(target_arch = "wasm32", wasm_bindgen_test::wasm_bindgen_test)]
#[cfg_attr(not(target_arch = "wasm32"), test)]
fn random_lots_give_drivable_paths() {
    let mut found = 0;
    for seed in 0..40 {
        let lot = random_scenes(seed);
        let name = format!("seed {seed}");
        let config = Config { ladder: false, max_expansions: Some(3000), ..Config::default() };
        let report = lot.plan(&config);
        if !report.status.is_found() {
            continue;
        }
        found += 1;
        lot.check(&name, &report.arcs);
        let length = arcs::length(&report.arcs);
        assert!(length >= report.rs_bound - 1e-6, "{name}");
        let again = lot.plan(&config);
        assert_eq!(
            (again.arcs, again.stats.expanded),
            (report.arcs.clone(), report.stats.expanded),
            "{name}"
        );
        let mut turned = lot.clone();
        (turned.start[2], turned.goal[2]) = (lot.start[2] + TAU, lot.goal[2] - TAU);
        let turned = turned.plan(&config);
        assert!((arcs::length(&turned.arcs) - length).abs() < 1e-6, "{name}: turned by 2π");
    }
    assert!(found >= 30, "{found}");
}

#[cfg_attr(target_arch = "wasm32", wasm_bindgen_test::wasm_bindgen_test)]
#[cfg_attr(not(target_arch = "wasm32"), test)]
fn far_from_the_origin_the_answer_is_the_same() {
    for id in ["P2", "L1", "L2"] {
        let near = Lot::of(id);
        let (length, changes, _) = near.solve(id, &Config::default());
        let far = |p: &[f64; 2]| [p[0] + 1e9, p[1] - 1e9];
        let mut lot = Lot { floor: near.floor.iter().map(far).collect(), ..near.clone() };
        for at in [&mut lot.start, &mut lot.goal] {
            (at[0], at[1]) = (at[0] + 1e9, at[1] - 1e9);
        }
        let report = lot.plan(&Config::default());
        near.check(id, &report.arcs);
        assert!((arcs::length(&report.arcs) - length).abs() < 1e-5, "{id}");
        assert_eq!(arcs::direction_changes(&report.arcs), changes, "{id}");
    }
}

#[cfg_attr(target_arch = "wasm32", wasm_bindgen_test::wasm_bindgen_test)]
#[cfg_attr(not(target_arch = "wasm32"), test)]
fn the_mirror_image_is_as_long() {
    for id in ["P2", "L0", "L4"] {
        let lot = Lot::of(id);
        let flip = |[x, y, heading]: [f64; 3]| [-x, y, PI - heading];
        let mirror = Lot::of("P0").between(flip(lot.start), flip(lot.goal));
        let (one, _, _) = lot.solve(id, &Config::default());
        let (other, _, _) = mirror.solve(id, &Config::default());
        assert!((one - other).abs() <= 0.02 * one, "{id}: {one} {other}");
    }
}

#[cfg_attr(target_arch = "wasm32", wasm_bindgen_test::wasm_bindgen_test)]
#[cfg_attr(not(target_arch = "wasm32"), test)]
fn a_hundred_thousand_words_arrive() {
    let mut state = 1_u64;
    let radius = CAR.min_turning_radius();
    for _ in 0..100_000 {
        let mut any = || {
            let [x, y, t] = [(); 3].map(|()| random(&mut state));
            Pose::new(x * 30.0 - 15.0, y * 30.0 - 15.0, t * TAU - PI)
        };
        let (from, to) = (any(), any());
        let mut least = f64::INFINITY;
        reeds_shepp::words(from, to, radius, |word| {
            least = least.min(word.length(radius));
            let end = word.arcs(radius).fold(from, |at, arc| at.advance(arc.curvature, arc.length));
            assert!((end.point() - to.point()).norm() < 1e-6, "{from:?} {to:?} {word:?}");
            assert!(math::turn(end.heading, to.heading).abs() < 1e-6, "{from:?} {to:?} {word:?}");
        });
        let distance = reeds_shepp::distance(from, to, radius);
        assert!((distance - least).abs() < 1e-9);
        assert!((reeds_shepp::distance(to, from, radius) - distance).abs() < 1e-6);
        assert!(distance >= (to.point() - from.point()).norm() - 1e-9);
    }
}

#[cfg_attr(target_arch = "wasm32", wasm_bindgen_test::wasm_bindgen_test)]
#[cfg_attr(not(target_arch = "wasm32"), test)]
fn an_obstacle_more_makes_no_path_shorter() {
    for seed in 0..25 {
        let full = random_scenes(seed);
        let mut fewer = full.clone();
        fewer.solids.pop();
        let config = Config { ladder: false, max_expansions: Some(3000), ..Config::default() };
        let cost = |lot: &Lot| Some(lot.plan(&config)).filter(|r| !r.arcs.is_empty()).map(|r| r.cost);
        if let (Some(more), Some(less)) = (cost(&full), cost(&fewer)) {
            assert!(more >= 0.98 * less, "seed {seed}: {more} with, {less} without");
        }
    }
}

/// What a path costs under other settings, if it keeps the margin of their answer.
fn price(lot: &Lot, path: &Report, config: &Config, answer: &Report) -> Option<f64> {
    let obstacles = lot.obstacles();
    let query = Query { obstacles: &obstacles, vehicle: &CAR, start: pose(lot.start), goal: pose(lot.goal) };
    let (last, asked) = (Last::of(&query, path), (answer, f64::INFINITY, false));
    stay(&query, config, &last, asked, &mut Scratch::default(), &mut |_| true).map(|path| path.cost)
}

/// Less margin than 5 or 10 cm costs no more than these, by 1 %; nor does an answer under a price of obstacles cost
/// more than the ordinary path does under it.
#[cfg_attr(target_arch = "wasm32", wasm_bindgen_test::wasm_bindgen_test)]
#[cfg_attr(not(target_arch = "wasm32"), test)]
fn more_freedom_and_a_price_lose_nothing_by_their_own_measure() {
    let (mut tight, mut priced) = (0, 0);
    for seed in 500..530 {
        let lot = random_scenes(seed);
        let plan = |config: Config| lot.plan(&config);
        let ordinary = plan(Config::default());
        if ordinary.arcs.is_empty() || ordinary.margin < 0.1 {
            continue;
        }
        let [none, some] = [0.0, 0.05].map(|margin| plan(Config { margin, ..Config::default() }).cost);
        assert!(
            none <= some * 1.01 && some <= ordinary.cost * 1.01,
            "{seed}: {none} {some} {}",
            ordinary.cost
        );
        tight += 1;
        let config = Config { obstacle_cost: 1.0, ..Config::default() };
        let answer = plan(config);
        if let Some(price) = price(&lot, &ordinary, &config, &answer) {
            assert!(answer.cost <= price * 1.01, "{seed}: {} where {price} is known", answer.cost);
            priced += 1;
        }
    }
    println!("{tight} scenes with less margin, {priced} with a price of obstacles");
    assert!(tight >= 15 && priced >= 12, "{tight} {priced}");
}

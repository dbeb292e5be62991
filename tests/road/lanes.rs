//! Lanes and the margin: what plans keep on the catalog's roads and on roads by seed.

#[cfg(target_arch = "wasm32")]
use wasm_bindgen_test::wasm_bindgen_test as test;

use parkade::metrics::Verdict;
use parkade::metrics::road::RoadMetrics;
use parkade::plan::{Detail, Options, Outcome, Plan, Planner};
use parkade::scenario::{Scenario, catalog};
use serde_json::{Value, json};

use super::random_roads::road;
use super::{IDS, plain};

fn plan(scene: &Scenario, settings: &Value) -> Plan {
    let mut planner = Planner::new("cost-map", scene, settings.as_object().unwrap()).unwrap();
    let plan = planner.plan(Options::default());
    assert_eq!(plan.outcome, Outcome::Found, "{:?}: {:?}", scene.name, plan.reason);
    plan
}

fn measured(scene: &Scenario, settings: &Value) -> RoadMetrics {
    plan(scene, settings).metrics.road.unwrap()
}

#[test]
fn lanes_are_kept_better_than_by_plain_cells() {
    for id in IDS {
        let scene = catalog::scenario(id).unwrap();
        let old = measured(&scene, &plain()).figures;
        for base in ["inverse", "exponential"] {
            let new = measured(&scene, &json!({ "base": base })).figures;
            let [deviation, before] = [&new, &old].map(|f| f.lane_deviation_mean.unwrap());
            let [left, left_before] = [&new, &old].map(|f| f.lane_left_share.unwrap());
            println!("{id} {base}: {deviation:.2} m for {before:.2}, {left:.3} left for {left_before:.3}");
            let is_straight = id == "road-straight";
            assert!(
                deviation < 0.75 * before || is_straight && deviation == 0.0,
                "{id}: {deviation} {before}"
            );
            assert!(left <= left_before, "{id}: {left} {left_before}");
        }
    }
}

/// A lane change takes 20 m and an obstacle in the lane is passed with 0.8 m to spare, where plain cells do neither: so
/// not each of the roads is better, but each is on which a car can drive plain cells, nearly all are, and all together
/// by far.
#[test]
fn lanes_are_kept_on_roads_by_seed() {
    let (mut better, mut sums, mut lefts, mut kept, mut proven) = (0, [0.0; 2], [0.0; 2], 0, 0);
    let count = if cfg!(debug_assertions) { 12 } else { 40 };
    for seed in 101..=100 + count {
        let scene = road(seed);
        let old = measured(&scene, &plain()).figures;
        let after = plan(&scene, &json!({}));
        assert!(
            matches!(after.check.verdict, Verdict::Ok | Verdict::ArrivesTurned),
            "seed {seed}: {:?}",
            after.check.verdict
        );
        let road = after.metrics.road.clone().unwrap();
        let new = road.figures;
        // A margin that is not kept is said, with what is kept.
        let is_kept = road.margin_kept >= road.margin - 2e-3;
        assert_eq!(is_kept, after.detail.is_none(), "seed {seed}: {:?}", after.detail);
        assert!(road.margin_kept >= after.check.min_clearance.min(road.margin) - 1e-12);
        kept += u64::from(is_kept);
        proven += u64::from(road.margin_excluded);
        assert!(new.middle_length <= old.middle_length * 1.001, "seed {seed}");
        for (k, figures) in [&old, &new].into_iter().enumerate() {
            sums[k] += figures.lane_deviation_mean.unwrap();
            lefts[k] += figures.lane_left_share.unwrap();
        }
        let is_nearer = new.lane_deviation_mean <= old.lane_deviation_mean;
        better += u64::from(is_nearer);
        // Where plain cells are nearer, no car drives them: they touch something or turn more tightly than it can.
        if !is_nearer {
            let verdict = plan(&scene, &plain()).check.verdict;
            let [curve, cells] = [&new, &old].map(|figures| figures.lane_deviation_mean.unwrap());
            println!("seed {seed}: {curve:.2} m, on plain cells {cells:.2} m: {verdict:?}");
            assert!(matches!(verdict, Verdict::Collides | Verdict::TooTight), "seed {seed}: {verdict:?}");
        }
    }
    println!(
        "better on {better} of {count}, {sums:?} m, left {lefts:?}, margin kept on {kept}, impossible on {proven}"
    );
    // Among them are roads of one lane whose bends leave the car less than the margin.
    assert!(proven > 0 && kept + proven <= count, "{kept} {proven}");
    assert!(better * 4 >= count * 3, "{better} of {count}");
    assert!(sums[1] < 0.5 * sums[0], "{sums:?}");
    assert!(lefts[1] < 0.5 * lefts[0], "{lefts:?}");
}

#[test]
fn the_margin_is_kept_or_less_is_said() {
    // The road's lane leaves 0.8 m, the gaps of the narrow road as much while nobody turns.
    for (id, least, all) in [
        ("road-straight", 0.8, true),
        ("road-curve", 0.75, false),
        ("road-crossing", 0.5, false),
        ("road-narrow", 0.6, false),
    ] {
        let scene = catalog::scenario(id).unwrap();
        let plan = plan(&scene, &json!({}));
        let road = plan.metrics.road.unwrap();
        println!("{id}: {:.3} of {} m, {:?}", road.margin_kept, road.margin, plan.detail);
        assert_eq!(road.margin, 0.8);
        assert!(road.margin_kept >= least - 2e-3, "{id}: {}", road.margin_kept);
        assert!(!all || plan.detail.is_none(), "{id}");
        assert_eq!(plan.detail, (road.margin_kept < 0.798).then_some(Detail::LessMargin), "{id}");
    }
    // Plain cells and the manuscript's curves are asked for none.
    let scene = catalog::scenario("road-narrow").unwrap();
    for settings in [plain(), json!({ "costs": "paper", "pruning": "los", "smoothing": "paper" })] {
        let plan = plan(&scene, &settings);
        assert_eq!((plan.metrics.road.unwrap().margin, plan.detail), (0.0, None));
    }
    // More room is kept where there is more: two lanes wide and nothing on them.
    let mut wide = catalog::scenario("road-narrow").unwrap();
    wide.obstacles.clear();
    for margin in [0.0, 0.5, 1.2, 2.0] {
        let plan = plan(&wide, &json!({ "margin": margin }));
        assert!(plan.check.min_clearance >= margin - 2e-3 && plan.detail.is_none(), "{margin}");
    }
    let plan = plan(&wide, &json!({ "margin": 5.0 }));
    assert_eq!(plan.detail, Some(Detail::LessMargin));
    let road = plan.metrics.road.unwrap();
    assert!((road.margin_kept - 2.3).abs() < 0.01 && road.margin_excluded);
}

/// What is proven impossible is: no other margin's plan keeps it, and where a plan keeps the margin nothing is proven.
#[test]
fn a_margin_is_excluded_only_where_no_path_keeps_it() {
    let (mut proven, mut kept) = (0, 0);
    for seed in 201..=if cfg!(debug_assertions) { 204 } else { 216 } {
        let scene = road(seed);
        let all = [0.3, 0.8, 2.2, 3.0].map(|margin| measured(&scene, &json!({ "margin": margin })));
        let most = all.iter().fold(0.0, |most: f64, road| most.max(road.margin_kept));
        for road in &all {
            let is_kept = road.margin_kept >= road.margin - 2e-3;
            assert!(!(is_kept && road.margin_excluded), "seed {seed}: {}", road.margin);
            assert!(!road.margin_excluded || road.margin > most, "seed {seed}: {} {most}", road.margin);
            (proven, kept) = (proven + u32::from(road.margin_excluded), kept + u32::from(is_kept));
        }
        // What excludes a margin excludes a larger one.
        assert!(
            all.windows(2).all(|pair| !pair[0].margin_excluded || pair[1].margin_excluded),
            "seed {seed}"
        );
    }
    println!("{proven} proven, {kept} kept");
    assert!(proven > 0 && kept > 0, "{proven} {kept}");
}

//! The same numbers in whole plans and explanations.

use parkade::map::{Bits, Cell, Occupancy};
use parkade::plan::{Options, Planner};
use parkade::planners::query::{GridScratch, Query};
use parkade::planners::settings::Common;
use parkade::planners::{jump_point, risk_field};
use parkade::scenario::generate;
use serde_json::Value;

use super::maps;

/// §10's figures, by the names of the JS API.
#[cfg_attr(target_arch = "wasm32", wasm_bindgen_test::wasm_bindgen_test)]
#[cfg_attr(not(target_arch = "wasm32"), test)]
fn plans_report_the_golden_figures() {
    for golden in maps() {
        let record = &golden.record;
        let scene =
            generate::generate(golden.family, golden.map.width(), record["seed"].as_u64().unwrap()).unwrap();
        for post in ["none", "prune", "prune-dp", "smooth"] {
            let mut settings = serde_json::Map::new();
            settings.insert("post".to_owned(), post.into());
            let plan = Planner::new("risk-field", &scene, &settings).unwrap().plan(Options::default());
            let (stats, metrics) =
                (serde_json::to_value(&plan.stats).unwrap(), serde_json::to_value(&plan.metrics).unwrap());
            for key in ["expanded", "generated", "deferred"] {
                golden.equal(&format!("/risk/{key}"), stats[key].as_i64().unwrap());
            }
            golden.equal("/risk/cost_micro", stats["costMicro"].as_i64().unwrap());
            for (key, name) in [("length_pruned", "lengthPruned"), ("length_dp", "lengthDp")] {
                golden.near(&format!("/risk/{key}"), metrics[name].as_f64().unwrap());
            }
            golden.near("/risk_smoothed/dynamic_rmin1/length", metrics["lengthSmoothed"].as_f64().unwrap());
            golden.near("/risk_smoothed/dynamic_rmin1/min_radius", metrics["minRadius"].as_f64().unwrap());
            golden.equal("/risk_smoothed/dynamic_rmin1/arcs", metrics["arcs"].as_i64().unwrap());
            golden.equal("/risk_smoothed/dynamic_rmin1/sharp", metrics["sharpCorners"].as_i64().unwrap());
            let kept = match post {
                "none" => "lengthRaw",
                "prune" => "lengthPruned",
                "prune-dp" => "lengthDp",
                _ => "lengthSmoothed",
            };
            assert!((plan.metrics.length - metrics[kept].as_f64().unwrap()).abs() < 1e-6, "{post}");
            for key in ["pushes", "losCalls"] {
                assert!(stats[key].as_u64().unwrap() > 0, "{key}");
            }
            for key in ["turns", "turnAngleDeg", "turnsPruned", "turnAngleDegPruned", "lengthRaw"] {
                assert!(metrics[key].as_f64().unwrap() > 0.0, "{key}");
            }
            let (least, mean) =
                (metrics["minClearanceCells"].as_f64(), metrics["meanClearanceCells"].as_f64());
            assert!(least.unwrap() >= 1.0 && mean.unwrap() >= least.unwrap() && mean.unwrap() <= 5.0);
        }
    }
}

/// What only some planners count.
#[cfg_attr(target_arch = "wasm32", wasm_bindgen_test::wasm_bindgen_test)]
#[cfg_attr(not(target_arch = "wasm32"), test)]
fn plans_count_what_was_rejected_and_scanned() {
    let stats = |id, scene: &_, settings: &[(&str, Value)]| {
        let settings = settings.iter().map(|(key, value)| ((*key).to_owned(), value.clone())).collect();
        let plan = Planner::new(id, scene, &settings).unwrap().plan(Options::default());
        serde_json::to_value(&plan.stats).unwrap()
    };
    let mut rejected = 0;
    for golden in maps() {
        let seed = golden.record["seed"].as_u64().unwrap();
        let scene = generate::generate(golden.family, golden.map.width(), seed).unwrap();
        let number = |stats: &Value, key: &str| stats[key].as_u64().unwrap();
        for stop in ["first", "best"] {
            assert!(stats("sixteen-bidirectional", &scene, &[("stop", stop.into())])["rejected"].is_null());
        }
        let optimal = stats("sixteen-bidirectional", &scene, &[("stop", "nba".into())]);
        // Both sides took each cell once at most, and either expanded or rejected it.
        assert!(number(&optimal, "expanded") + number(&optimal, "rejected") <= number(&optimal, "pushes"));
        rejected += number(&optimal, "rejected");

        let eight = stats("eight", &scene, &[]);
        assert!(eight["rejected"].is_null() && eight["cellsScanned"].is_null());
        for prune in [false, true] {
            let jumps = stats("jump-point", &scene, &[("prune", prune.into())]);
            assert!(number(&jumps, "expanded") < number(&eight, "expanded"));
            assert!(number(&jumps, "cellsScanned") > number(&jumps, "expanded"));
        }
    }
    assert!(rejected > 0);
    // Along a corridor: every cell from the start to the wall behind the goal.
    for length in [5, 50, 130] {
        let map = Occupancy::new(length, 1);
        let query = Query { map: &map, start: Cell::new(0, 0), goal: Cell::new(length as i32 - 1, 0) };
        let config = jump_point::Config::default();
        let report = jump_point::plan(query, &Bits::new(&map), &config, &mut GridScratch::new(), &mut ());
        assert_eq!(report.cells_scanned, Some(length));
    }
}

/// The planner's own defaults, not only its list of them.
#[cfg_attr(target_arch = "wasm32", wasm_bindgen_test::wasm_bindgen_test)]
#[cfg_attr(not(target_arch = "wasm32"), test)]
fn risk_field_plus_plans_with_its_own_settings() {
    for golden in maps() {
        let seed = golden.record["seed"].as_u64().unwrap();
        let scene = generate::generate(golden.family, golden.map.width(), seed).unwrap();
        let none = serde_json::Map::new();
        let plan = Planner::new("risk-field-plus", &scene, &none).unwrap().plan(Options::default());
        golden.equal("/risk_plus/cost_micro", plan.stats.cost_micro.unwrap());
        golden.equal("/risk_plus/expanded", plan.stats.expanded);
        golden.equal("/risk_plus/generated", plan.stats.generated);
        golden.near("/risk_plus/length_dp", plan.metrics.length);
    }
}

#[cfg_attr(target_arch = "wasm32", wasm_bindgen_test::wasm_bindgen_test)]
#[cfg_attr(not(target_arch = "wasm32"), test)]
fn estimates_are_equations_10_to_12() {
    use parkade::map::Occupancy;
    use parkade::planners::risk_field::{Heuristic, explain};

    let map = Occupancy::new(60, 60);
    let (root, [w1, w2]) = (2_f64.sqrt(), [2.0, 1.0]);
    let mut modes = [0, 0];
    for (x, y) in (0..60_i32).step_by(7).flat_map(|x| (0..60_i32).step_by(5).map(move |y| (x, y))) {
        let query = Query { map: &map, start: Cell::new(3, 1), goal: Cell::new(50, 40) };
        let (dx, dy) = (f64::from((50 - x).abs()), f64::from((40 - y).abs()));
        let (d1, d2) = (dx.max(dy), dx.min(dy));
        let [h1, h2, h3] = [root * d2, d1 + d2, d1 - d2];
        // Most of the way is diagonal, or straight.
        let [diagonal, straight] = if h1 >= h3 { [w1, w2] } else { [w2, w1] };
        modes[usize::from(h1 >= h3)] += 1;
        for (heuristic, expected) in [
            (Heuristic::Printed, diagonal * root * h1 + straight * (h2 - 2.0 * h1)),
            (Heuristic::Corrected, diagonal * h1 + straight * h3),
        ] {
            let config = risk_field::Config { heuristic, ..risk_field::Config::PAPER };
            let told = explain(query, &config, Cell::new(x, y)).unwrap();
            assert!((told.estimate as f64 - expected * 1e6).abs() < 300.0, "{heuristic:?} {x} {y} {told:?}");
            let weight = 1.0 + (dx * dx + dy * dy).sqrt() / (47.0_f64 * 47.0 + 39.0 * 39.0).sqrt();
            let off = told.weighted as f64 - weight * told.estimate as f64;
            assert!(off.abs() < 1e-6 * told.estimate.abs().max(1_000_000) as f64, "{x} {y} {told:?}");
        }
    }
    assert!(modes[0] > 20 && modes[1] > 20, "{modes:?}");
}

/// Regions by angles instead of products, and candidates by what a single expansion generates.
#[cfg_attr(target_arch = "wasm32", wasm_bindgen_test::wasm_bindgen_test)]
#[cfg_attr(not(target_arch = "wasm32"), test)]
fn explanations_are_the_papers_tables() {
    use parkade::geometry::math;
    use parkade::planners::risk_field::{Fallback, explain};
    use std::collections::BTreeSet;

    let mut seen = BTreeSet::new();
    for golden in maps() {
        for config in [risk_field::Config::PAPER, risk_field::Config::PLUS] {
            let end = golden.query().goal;
            let goals = [(0, 0), (end.x, 0), (0, end.y), (end.x, end.y)].map(|(x, y)| Cell::new(x, y));
            for index in (0..golden.map.len() as u32).step_by(golden.map.len() / 300) {
                let start = golden.map.cell(index);
                let goal = goals[index as usize % 4];
                if golden.map.blocked(goal) {
                    continue;
                }
                let query = Query { start, goal, ..golden.query() };
                let Some(told) = explain(query, &config, start) else {
                    assert!(golden.map.blocked(start));
                    continue;
                };
                let [x, y] = told.force;
                if told.force == [0.0, 0.0] {
                    // As F_x ≥ 0 and F_y ≥ 0.
                    assert_eq!((told.region, told.slope), ("2", None));
                    continue;
                }
                let degrees = math::atan2(y, x).to_degrees().rem_euclid(360.0);
                let third = math::atan2(1.0, 3.0).to_degrees();
                let region = if told.mode == "oblique" {
                    // Axes within 18.4°, diagonals between; bounds belong to the diagonals.
                    let quarter = (degrees / 90.0).round();
                    let aside = (degrees - 90.0 * quarter).abs();
                    let k = if aside < third - 1e-9 {
                        2 * (quarter as usize % 4)
                    } else {
                        2 * ((degrees / 90.0).floor() as usize) + 1
                    };
                    ["1", "2", "3", "4", "5", "6", "7", "8"][k]
                } else {
                    ["A", "B", "C", "D"][((degrees / 90.0).round() as usize) % 4]
                };
                // On a bound the last digit of F decides.
                let within = degrees.rem_euclid(90.0);
                let on_bound = [third, 45.0, 90.0 - third].iter().any(|bound| (within - bound).abs() < 1e-9);
                assert!(told.region == region || on_bound, "{told:?} {region}");
                seen.insert(told.region);
                let (dx, dy) = ((goal.x - start.x).abs(), (goal.y - start.y).abs());
                let (long, short) = (f64::from(dx.max(dy)), f64::from(dx.min(dy)));
                assert_eq!(told.mode == "oblique", 2_f64.sqrt() * short >= long - short);
                let directions: Vec<_> = told.candidates[..3].iter().map(|c| c.direction).collect();
                assert_eq!(told.candidates.iter().filter(|c| c.role == "held-back").count(), 5);
                assert!(told.candidates[..3].iter().all(|c| c.role == "primary"), "{directions:?}");
                // Figure 4: another cell beyond a diagonal one, or beyond a straight one.
                let by = |c: &risk_field::Candidate| [c.cell[0] - start.x, c.cell[1] - start.y];
                let primary: Vec<_> = told.candidates[..3].iter().map(by).collect();
                for [dx, dy] in told.candidates.iter().filter(|c| c.role == "extension").map(by) {
                    let steps = dx.abs().max(dy.abs());
                    assert!((2..=config.ext_len as i32 + 1).contains(&steps), "{told:?}");
                    assert!(primary.contains(&[dx / steps, dy / steps]), "{told:?}");
                    assert_eq!(dx.abs() == dy.abs(), told.mode == "oblique", "{told:?}");
                }
                let once = risk_field::Config {
                    fallback: Fallback::None,
                    goal_shot: false,
                    common: Common { max_expansions: 1, ..Common::PLAIN },
                    ..config
                };
                let report = risk_field::plan(query, &once, &mut GridScratch::new(), &mut ());
                let tried = |c: &&risk_field::Candidate| c.free && c.role != "held-back";
                assert_eq!(report.stats.generated as usize, 1 + told.candidates.iter().filter(tried).count());
            }
        }
    }
    assert_eq!(seen.into_iter().collect::<String>(), "12345678ABCD");
}

//! The numbers that two independent programs agree on: maps, costs and counters to the last integer.

use std::cell::Cell as Counter;
use std::rc::Rc;

use parkade::map::{Bits, Cell, Corner, Occupancy, RedundantSettings, inflation, redundant};
use parkade::metrics::any_angle_length;
use parkade::metrics::grid::length;
use parkade::plan::{Options, Planner};
use parkade::planners::grid_astar::{self, Config};
use parkade::planners::heuristics::Heuristic;
use parkade::planners::moves::Neighbourhood;
use parkade::planners::query::{GridReport, GridScratch, Query, Status};
use parkade::planners::settings::{Common, SmoothMode};
use parkade::planners::{any_angle, bidirectional, jump_point, risk_field};
use parkade::post::{prune, prune_dp, smooth};
use parkade::scenario::generate::{self, Family};
use parkade::search::Stop;
use serde_json::Value;

const GOLDEN: &str = include_str!("data/grid-golden-vectors.json");

/// A golden map and its record.
struct Golden {
    map: Occupancy,
    record: Value,
    name: String,
    family: Family,
    /// How many values have been compared.
    compared: Rc<Counter<u32>>,
}

impl Golden {
    fn query(&self) -> Query<'_> {
        let end = self.map.width() as i32 - 1;
        Query { map: &self.map, start: Cell::new(0, 0), goal: Cell::new(end, end) }
    }

    fn astar(&self, neighbourhood: Neighbourhood, heuristic: Heuristic) -> GridReport {
        let config = Config { heuristic, ..Config::new(neighbourhood) };
        config.validate(neighbourhood).unwrap();
        let report = grid_astar::plan(self.query(), neighbourhood, &config, &mut GridScratch::new(), &mut ());
        assert_eq!(report.status, Status::Found);
        report
    }

    /// Compares an integer with the field at `path`.
    fn equal(&self, path: &str, got: impl TryInto<i64>) {
        self.compared.set(self.compared.get() + 1);
        let want = self.record.pointer(path).unwrap_or_else(|| panic!("{path}"));
        assert_eq!(got.try_into().ok(), want.as_i64(), "{} {path}", self.name);
    }

    /// Compares a length with the field at `path`.
    fn near(&self, path: &str, got: f64) {
        self.compared.set(self.compared.get() + 1);
        let want = self.record.pointer(path).unwrap().as_f64().unwrap();
        assert!((got - want).abs() <= 1e-6, "{} {path}: {got} against {want}", self.name);
    }

    fn hash(&self, path: &str, map: &Occupancy) {
        self.compared.set(self.compared.get() + 1);
        let want = self.record.pointer(path).unwrap().as_str().unwrap();
        assert_eq!(format!("{:016x}", map.fnv1a64()), want, "{} {path}", self.name);
    }
}

/// The golden maps; says at the end how many values were compared with theirs.
struct Maps {
    maps: std::vec::IntoIter<Golden>,
    compared: Rc<Counter<u32>>,
}

impl Iterator for Maps {
    type Item = Golden;

    fn next(&mut self) -> Option<Golden> {
        self.maps.next()
    }
}

impl Drop for Maps {
    fn drop(&mut self) {
        if self.compared.get() > 0 {
            println!("item 1: {} golden values compared", self.compared.get());
        }
    }
}

fn maps() -> Maps {
    let compared = Rc::new(Counter::new(0));
    let file: Value = serde_json::from_str(GOLDEN).unwrap();
    let records = file["maps"].as_array().unwrap();
    let golden = |record: &Value| {
        let number = |key: &str| record["params"][key].as_u64().unwrap() as u32;
        let family = match record["family"].as_str().unwrap() {
            "random" => Family::Random {
                density_permille: number("density_permille"),
                block_min: number("block_min"),
                block_max: number("block_max"),
            },
            "regular" => Family::Regular,
            _ => Family::Trap,
        };
        let (size, seed) = (record["n"].as_u64().unwrap() as u32, record["seed"].as_u64().unwrap());
        let map = generate::occupancy(family, size, seed).unwrap();
        Golden {
            map,
            record: record.clone(),
            name: format!("{} {size} seed {seed}", record["family"]),
            family,
            compared: compared.clone(),
        }
    };
    let maps = records.iter().map(golden).collect::<Vec<_>>().into_iter();
    Maps { maps, compared }
}

#[cfg_attr(target_arch = "wasm32", wasm_bindgen_test::wasm_bindgen_test)]
#[cfg_attr(not(target_arch = "wasm32"), test)]
fn maps_are_drawn_bit_for_bit() {
    let maps = maps();
    assert_eq!(maps.maps.len(), 11);
    for golden in maps {
        golden.equal("/blocked_cells", golden.map.blocked_cells());
        golden.hash("/map_fnv1a64", &golden.map);
    }
}

#[cfg_attr(target_arch = "wasm32", wasm_bindgen_test::wasm_bindgen_test)]
#[cfg_attr(not(target_arch = "wasm32"), test)]
fn inflation_blocks_the_same_cells() {
    for golden in maps() {
        let inflated = inflation::necessary(&golden.map, 0.9);
        golden.equal("/inflated_rho_0_9/blocked", inflated.blocked_cells());
        golden.hash("/inflated_rho_0_9/map_fnv1a64", &inflated);
    }
}

#[cfg_attr(target_arch = "wasm32", wasm_bindgen_test::wasm_bindgen_test)]
#[cfg_attr(not(target_arch = "wasm32"), test)]
fn redundant_space_is_the_same() {
    for golden in maps() {
        let Query { map, start, goal } = golden.query();
        let closed = redundant(map, start, goal, RedundantSettings { min_passage: 2, trap_mouth: 5 });
        golden.equal("/safety_space_m2_q5/narrow", closed.narrow);
        golden.equal("/safety_space_m2_q5/pocket", closed.pocket);
        golden.equal("/safety_space_m2_q5/restored", closed.restored);
        golden.hash("/safety_space_m2_q5/map_fnv1a64_with_redundant_blocked", &closed.map);
    }
}

#[cfg_attr(target_arch = "wasm32", wasm_bindgen_test::wasm_bindgen_test)]
#[cfg_attr(not(target_arch = "wasm32"), test)]
fn grid_searches_count_and_cost_the_same() {
    let planners = [
        ("a4_manhattan", "a4", Neighbourhood::Four, Heuristic::Manhattan),
        ("a8_euclid", "a8", Neighbourhood::Eight, Heuristic::Euclid),
        ("a8_octile", "a8", Neighbourhood::Eight, Heuristic::Octile),
        ("a16", "a16", Neighbourhood::Sixteen, Heuristic::Gauge),
        ("a24", "a24", Neighbourhood::TwentyFour, Heuristic::Gauge),
        ("a48", "a48", Neighbourhood::FortyEight, Heuristic::Gauge),
    ];
    for golden in maps() {
        for (name, cost, neighbourhood, heuristic) in planners {
            let report = golden.astar(neighbourhood, heuristic);
            golden.equal(&format!("/optimal_cost_micro/{cost}"), report.cost_micro);
            golden.equal(&format!("/expanded/{name}"), report.expanded);
            if !matches!(name, "a24" | "a48") {
                golden.equal(&format!("/generated/{name}"), report.generated);
            }
        }
    }
}

#[cfg_attr(target_arch = "wasm32", wasm_bindgen_test::wasm_bindgen_test)]
#[cfg_attr(not(target_arch = "wasm32"), test)]
fn searches_from_both_ends_cost_the_same() {
    for golden in maps() {
        for (name, stop) in [("nba", Stop::Optimal), ("first", Stop::First), ("best", Stop::Best)] {
            let config = bidirectional::Config { stop, ..bidirectional::Config::default() };
            let report = bidirectional::plan(golden.query(), &config, &mut GridScratch::new(), &mut ());
            assert_eq!(report.status, Status::Found);
            golden.equal(&format!("/bidirectional16_cost_micro/{name}"), report.cost_micro);
        }
    }
}

#[cfg_attr(target_arch = "wasm32", wasm_bindgen_test::wasm_bindgen_test)]
#[cfg_attr(not(target_arch = "wasm32"), test)]
fn jump_points_expand_the_same() {
    for golden in maps() {
        for prune in [false, true] {
            let config = jump_point::Config { prune, ..jump_point::Config::default() };
            let bits = Bits::new(&golden.map);
            let report = jump_point::plan(golden.query(), &bits, &config, &mut GridScratch::new(), &mut ());
            golden.equal("/optimal_cost_micro/a8", report.cost_micro);
            if !prune {
                golden.equal("/jps_expanded", report.expanded);
            }
        }
    }
}

#[cfg_attr(target_arch = "wasm32", wasm_bindgen_test::wasm_bindgen_test)]
#[cfg_attr(not(target_arch = "wasm32"), test)]
fn any_angle_paths_are_as_long() {
    for golden in maps() {
        let config = any_angle::Config::default();
        let report = any_angle::plan(golden.query(), &config, &mut GridScratch::new(), &mut ());
        golden.near("/theta_star_length", length(&report.cells));
        let Query { map, start, goal } = golden.query();
        golden.near("/yardstick_L_aa", any_angle_length(map, start, goal).unwrap());
    }
}

#[cfg_attr(target_arch = "wasm32", wasm_bindgen_test::wasm_bindgen_test)]
#[cfg_attr(not(target_arch = "wasm32"), test)]
fn risk_searches_count_and_cost_the_same() {
    let planners = [("risk", risk_field::Config::PAPER), ("risk_plus", risk_field::Config::PLUS)];
    for golden in maps() {
        for (name, config) in planners {
            config.validate().unwrap();
            let report = risk_field::plan(golden.query(), &config, &mut GridScratch::new(), &mut ());
            assert_eq!(report.status, Status::Found);
            golden.equal(&format!("/{name}/cost_micro"), report.cost_micro);
            golden.equal(&format!("/{name}/expanded"), report.expanded);
            golden.equal(&format!("/{name}/generated"), report.generated);
            if name == "risk" {
                golden.equal("/risk/deferred", report.deferred);
            }
            let shortest = prune_dp(&golden.map, &report.cells, Corner::Strict);
            golden.near(&format!("/{name}/length_dp"), length(&shortest));
        }
    }
}

#[cfg_attr(target_arch = "wasm32", wasm_bindgen_test::wasm_bindgen_test)]
#[cfg_attr(not(target_arch = "wasm32"), test)]
fn pruned_and_smoothed_paths_are_as_long() {
    for golden in maps() {
        let eight = golden.astar(Neighbourhood::Eight, Heuristic::Euclid);
        let pruned = prune(&golden.map, &eight.cells, Corner::Strict);
        golden.near("/a8_euclid_length_pruned", length(&pruned));

        let config = risk_field::Config::PAPER;
        let risk = risk_field::plan(golden.query(), &config, &mut GridScratch::new(), &mut ());
        let pruned = prune(&golden.map, &risk.cells, Corner::Strict);
        golden.near("/risk/length_pruned", length(&pruned));

        let dynamic = smooth(&golden.map, &pruned, 1.0, SmoothMode::Dynamic);
        golden.near("/risk_smoothed/dynamic_rmin1/length", dynamic.length);
        golden.near("/risk_smoothed/dynamic_rmin1/min_radius", dynamic.min_radius.unwrap());
        golden.equal("/risk_smoothed/dynamic_rmin1/arcs", dynamic.arcs);
        golden.equal("/risk_smoothed/dynamic_rmin1/sharp", dynamic.sharp);
        let paper = smooth(&golden.map, &pruned, 0.0, SmoothMode::Paper);
        golden.near("/risk_smoothed/paper_mode_rmin0/length", paper.length);
        golden.equal("/risk_smoothed/paper_mode_rmin0/arcs", paper.arcs);
    }
}

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
#[cfg(feature = "complete")]
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
        assert_eq!(report.cells_scanned, length);
    }
}

/// The planner's own defaults, not only its list of them.
#[cfg(feature = "complete")]
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

/// Regions by angles instead of products, and candidates by what a single expansion generates.
#[cfg(feature = "complete")]
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
                let once = risk_field::Config {
                    fallback: Fallback::None,
                    goal_shot: false,
                    common: Common { max_expansions: 1, ..Common::PLAIN },
                    ..config
                };
                let report = risk_field::plan(query, &once, &mut GridScratch::new(), &mut ());
                let tried = |c: &&risk_field::Candidate| c.free && c.role != "held-back";
                assert_eq!(report.generated as usize, 1 + told.candidates.iter().filter(tried).count());
            }
        }
    }
    assert_eq!(seen.into_iter().collect::<String>(), "12345678ABCD");
}

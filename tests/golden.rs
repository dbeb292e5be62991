//! The numbers that two independent programs agree on: maps, costs and counters to the last integer.

use parkade::map::{Cell, Corner, Occupancy, RedundantSettings, inflation, redundant};
use parkade::metrics::grid::length;
use parkade::planners::grid_astar::{self, Config};
use parkade::planners::heuristics::Heuristic;
use parkade::planners::moves::Neighbourhood;
use parkade::planners::query::{GridReport, GridScratch, Query, Status};
use parkade::planners::risk_field;
use parkade::planners::settings::SmoothMode;
use parkade::post::{prune, prune_dp, smooth};
use parkade::scenario::generate::{self, Family};
use serde_json::Value;

const GOLDEN: &str = include_str!("data/grid-golden-vectors.json");

/// A golden map and its record.
struct Golden {
    map: Occupancy,
    record: Value,
    name: String,
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
        let want = self.record.pointer(path).unwrap_or_else(|| panic!("{path}"));
        assert_eq!(got.try_into().ok(), want.as_i64(), "{} {path}", self.name);
    }

    /// Compares a length with the field at `path`.
    fn near(&self, path: &str, got: f64) {
        let want = self.record.pointer(path).unwrap().as_f64().unwrap();
        assert!((got - want).abs() <= 1e-6, "{} {path}: {got} against {want}", self.name);
    }

    fn hash(&self, path: &str, map: &Occupancy) {
        let want = self.record.pointer(path).unwrap().as_str().unwrap();
        assert_eq!(format!("{:016x}", map.fnv1a64()), want, "{} {path}", self.name);
    }
}

fn maps() -> Vec<Golden> {
    let file: Value = serde_json::from_str(GOLDEN).unwrap();
    let records = file["maps"].as_array().unwrap();
    records
        .iter()
        .map(|record| {
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
            Golden { map, record: record.clone(), name: format!("{} {size} seed {seed}", record["family"]) }
        })
        .collect()
}

#[cfg_attr(target_arch = "wasm32", wasm_bindgen_test::wasm_bindgen_test)]
#[cfg_attr(not(target_arch = "wasm32"), test)]
fn maps_are_drawn_bit_for_bit() {
    let maps = maps();
    assert_eq!(maps.len(), 11);
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

//! The numbers that two independent programs agree on: maps, costs and counters to the last integer.

use parkade::map::{Cell, Occupancy, inflation};
use parkade::planners::grid_astar::{self, Config};
use parkade::planners::heuristics::Heuristic;
use parkade::planners::moves::Neighbourhood;
use parkade::planners::query::{GridReport, GridScratch, Query, Status};
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

    /// Compares an integer with the field at `path`, where the record has it.
    fn equal(&self, path: &str, got: impl TryInto<i64>) {
        let got = got.try_into().ok().unwrap();
        if let Some(want) = self.record.pointer(path) {
            assert_eq!(got, want.as_i64().unwrap(), "{} {path}", self.name);
        }
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
            golden.equal(&format!("/generated/{name}"), report.generated);
        }
    }
}

//! The numbers that two independent programs agree on: maps, costs and counters to the last integer.

use std::cell::Cell as Counter;
use std::rc::Rc;

use parkade::map::{Cell, Occupancy};
use parkade::planners::Outcome;
use parkade::planners::grid_astar::{self, Config};
use parkade::planners::heuristics::Heuristic;
use parkade::planners::moves::Neighbourhood;
use parkade::planners::query::{GridReport, GridScratch, Query};
use parkade::scenario::generate::{self, Family};
use serde_json::Value;

mod maps;
mod plans;
mod searches;

const GOLDEN: &str = include_str!("../data/grid-golden-vectors.json");

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
        config.validate_for(neighbourhood).unwrap();
        let report = grid_astar::plan(self.query(), neighbourhood, &config, &mut GridScratch::new(), &mut ());
        assert_eq!(report.outcome, Outcome::Found);
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

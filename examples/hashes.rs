//! Prints the hash of every planner's plan on every preset, `tests/data/plan-hashes.json`, or those of random scenes.
//!
//! ```sh
//! cargo run --release --example hashes > tests/data/plan-hashes.json
//! cargo run --release --example hashes random > tests/data/random-scene-hashes.json
//! ```

use parkade::plan::{Options, Planner};
use parkade::planners::registry::planners;
use parkade::scenario::catalog;
use serde_json::{Map, json};

#[path = "../tests/random_scenes/mod.rs"]
mod random_scenes;

fn main() {
    if std::env::args().nth(1).as_deref() == Some("random") {
        let hashes: Vec<String> = (0..40).map(|seed| random_scenes::plan(seed).hash()).collect();
        println!("{:#}", json!(hashes));
        return;
    }
    let mut scenes = Map::new();
    for info in catalog::scenes().filter(|s| s.group == "parking" || s.group == "grid") {
        let scene = catalog::scenario(info.id).expect("a scene of the catalog");
        let mut hashes = Map::new();
        for planner in planners() {
            let mut session = Planner::new(planner.id, &scene, &Map::new()).expect("valid defaults");
            let plan = session.plan(Options::default());
            eprintln!("{} {} {} {:.2}", info.id, planner.id, plan.outcome.as_str(), plan.metrics.length);
            hashes.insert(planner.id.to_owned(), json!(plan.hash()));
        }
        scenes.insert(info.id.to_owned(), hashes.into());
    }
    println!("{:#}", json!(scenes));
}

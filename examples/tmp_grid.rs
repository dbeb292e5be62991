//! Plans the parking paper's rows and the tight slots, and prints what was reached.
//!
//! ```sh
//! cargo run --release --example parking
//! ```

use std::time::Instant;

use parkade::plan::{Options, Planner};
use parkade::scenario::catalog;

fn main() {
    println!("| scene | length m | changes | clearance m | expanded | level | ms | verdict |");
    println!("| --- | --- | --- | --- | --- | --- | --- | --- |");
    for info in catalog::SCENES.iter().filter(|s| s.group == "grid") {
        let scene = catalog::scenario(info.id).expect("a scene of the catalog");
        let mut planner = Planner::new("hybrid", &scene, &serde_json::Map::new()).expect("valid defaults");
        let begin = Instant::now();
        let plan = planner.plan(Options::default());
        let millis = begin.elapsed().as_secs_f64() * 1e3;
        println!(
            "| {} | {:.2} | {} | {:.2} | {} | {} | {millis:.1} | {} {} |",
            info.id,
            plan.metrics.length,
            plan.metrics.direction_changes,
            plan.metrics.min_clearance,
            plan.stats.expanded,
            plan.stats.level.unwrap_or(0),
            plan.check.verdict.as_str(),
            plan.reason.unwrap_or_default(),
        );
    }
}

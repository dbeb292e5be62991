//! Plans random scenes and holds every answer against what is promised: no panic, no path that the validator refuses, a
//! reason for every failure.
//!
//! ```sh
//! cargo run --release --example strew [scenes, default 10 000] [first seed, default 0]
//! cargo run --release --example strew hashes > tests/data/strewn-hashes.json
//! cargo run --release --example strew lines 1000 | node tests/bench/strewn.mjs
//! ```

use std::collections::BTreeMap;
use std::time::Instant;

#[path = "../tests/strewn/mod.rs"]
mod strewn;

fn main() {
    if std::env::args().nth(1).as_deref() == Some("hashes") {
        let hashes: Vec<String> = (0..40).map(|seed| strewn::plan(seed).hash()).collect();
        println!("{:#}", serde_json::json!(hashes));
        return;
    }
    if std::env::args().nth(1).as_deref() == Some("lines") {
        let count = std::env::args().nth(2).map_or(1000, |n| n.parse().expect("a whole number"));
        for seed in 0..count {
            let (scene, config) = strewn::scene(seed);
            let hash = strewn::plan(seed).hash();
            println!(
                "{}",
                serde_json::json!({ "seed": seed, "scene": scene, "config": config, "hash": hash })
            );
        }
        return;
    }
    let mut arguments = std::env::args().skip(1).map(|a| a.parse::<u64>().expect("a whole number"));
    let (count, first) = (arguments.next().unwrap_or(10_000), arguments.next().unwrap_or(0));
    let mut outcomes = BTreeMap::new();
    let mut slowest = (0.0, 0);
    let begin = Instant::now();
    for seed in first..first + count {
        let from = Instant::now();
        let plan = strewn::plan(seed);
        let millis = from.elapsed().as_secs_f64() * 1e3;
        slowest = if millis > slowest.0 { (millis, seed) } else { slowest };
        *outcomes.entry((plan.outcome.as_str(), plan.detail.unwrap_or(""))).or_insert(0) += 1;
    }
    for ((outcome, detail), number) in outcomes {
        println!("{number:6} {outcome} {detail}");
    }
    println!(
        "{count} scenes in {:.1} s, slowest {:.0} ms (seed {})",
        begin.elapsed().as_secs_f64(),
        slowest.0,
        slowest.1
    );
}

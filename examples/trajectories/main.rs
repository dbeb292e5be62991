//! Judges the trajectories of all planners on the built-in parking scenes and on the cases of the TPCAP competition,
//! and prints the tables of `benches/TRAJECTORIES.md`; or, as JSON, `tests/data/trajectory-hashes.json`; or what became
//! of random scenes or of tight ones.
//!
//! ```sh
//! PARKADE_DATA=folder cargo run --release --example trajectories
//! cargo run --release --example trajectories hashes > tests/data/trajectory-hashes.json
//! cargo run --release --example trajectories scenes
//! cargo run --release --example trajectories references
//! cargo run --release --example trajectories random 0 1000
//! cargo run --release --example trajectories limits 0 1000
//! cargo run --release --example trajectories tight 1 101
//! ```

#[path = "../clock/mod.rs"]
mod clock;
mod made;
#[path = "../../tests/random_scenes/mod.rs"]
#[expect(dead_code, reason = "plans are checked elsewhere")]
mod random_scenes;
mod seeded;
mod tables;
#[path = "../../tests/tight_scenes/mod.rs"]
#[expect(dead_code, reason = "scenes are planned as scenarios")]
mod tight_scenes;

use serde_json::{Map, json};

fn main() {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    match arguments.iter().map(String::as_str).collect::<Vec<_>>()[..] {
        ["hashes"] => print_hashes(),
        [kind, from, to] => {
            let number = |text: &str| text.parse().expect("a whole number");
            let seeds = number(from)..number(to);
            match kind {
                "random" | "limits" => seeded::print_random(seeds, kind),
                _ => seeded::print_tight(&seeds),
            }
        }
        ["scenes"] => tables::print_scenes(&made::scenes()),
        ["references"] => tables::print_references(),
        _ => tables::print_tables(),
    }
}

fn print_hashes() {
    let mut hashes = Map::new();
    for (name, scene) in made::built_in() {
        if let Some(made) = made::make("hybrid", &scene, &Map::new()).driven {
            hashes.insert(name, made.states.hash().into());
        }
    }
    println!("{:#}", json!(hashes));
}

//! Random input to Parkade, by seed, and what its answers are held against.
//!
//! A [`Target`] makes its input from a seed and fails in words when an answer is wrong: a planner's path that an
//! independent walk refuses, a cost that differs from plain Dijkstra's, an error without a field. `cargo xtask fuzz`
//! runs them by the million; the test suite runs the first seeds of each.

mod configs;
mod grid_model;
mod mutate;
mod oracles;
mod parsers;
mod random;
#[path = "../../tests/random_scenes/mod.rs"]
mod random_scenes;
mod soak;
mod trajectories;

use parkade::planners::registry::planners;
use parkade::scenario::catalog::{scenario, scenes};
use serde_json::{Map, Value, json};
use std::cell::Cell;
use std::panic::{self, AssertUnwindSafe, catch_unwind};

/// Something that can be asked a million random questions.
pub struct Target {
    /// Its name on the command line.
    pub name: &'static str,
    /// What is asked, and what the answers are held against.
    pub about: &'static str,
    /// How many seeds the test suite asks.
    pub sample: u64,
    run: fn(u64) -> Outcome,
}

/// A word for the statistics, or what is wrong with the answer.
pub type Outcome = Result<&'static str, String>;

/// All of them.
pub const TARGETS: &[Target] = &[
    Target {
        name: "grid",
        about: "every grid planner on small random maps, against Dijkstra, a flood fill and an independent walk; maps \
            reversed, moved, turned and filled further",
        sample: 150,
        run: oracles::grid,
    },
    Target {
        name: "hybrid",
        about: "hybrid A* among random obstacles, far from the origin too, against the validator and the Reeds-Shepp \
            bound",
        sample: 20,
        run: |seed| Ok(random_scenes::plan(seed).outcome.as_str()),
    },
    Target {
        name: "planners",
        about: "every planner on random scenes with random settings, good and bad",
        sample: 60,
        run: configs::planners,
    },
    Target {
        name: "edits",
        about: "brush strokes on a planner's map, against the same map made anew",
        sample: 60,
        run: soak::edits,
    },
    Target {
        name: "trajectories",
        about: "hybrid A*'s paths among random obstacles as trajectories, against the same paths with stops, by the \
            referee; and among moving boxes, each contact against a look every 5 ms",
        sample: 20,
        run: trajectories::optimised,
    },
    Target { name: "scene", about: "mutated scene JSON", sample: 400, run: parsers::scene },
    Target { name: "movingai", about: "mutated .map and .scen files", sample: 400, run: parsers::movingai },
    Target { name: "rosmap", about: "mutated .yaml and .pgm files", sample: 400, run: parsers::rosmap },
    Target { name: "tpcap", about: "mutated TPCAP cases", sample: 400, run: parsers::tpcap },
    Target { name: "lots", about: "mutated lots of lines and polygons", sample: 400, run: parsers::lots },
];

/// Asks one of the parsers what a fuzzer that watches the program made up.
///
/// # Panics
/// With what is wrong with the answer, and for names that are none of a parser's.
pub fn guided(parser: &str, bytes: &[u8]) {
    let outcome = match parser {
        "scene" => parsers::guided_scene(bytes),
        "movingai" => parsers::guided(&["room.map", "room.map.scen"], bytes),
        "rosmap" => parsers::guided(&["lot.yaml", "lot.pgm"], bytes),
        "tpcap" => parsers::guided(&["case.csv"], bytes),
        "lots" => parsers::guided(&["lot.json"], bytes),
        _ => Err(format!("{parser}: no parser")),
    };
    if let Err(wrong) = outcome {
        panic!("{wrong}");
    }
}

/// Every planner on every built-in scene, then as many random questions: planner, scene, settings, and the hashes
/// of the plan and of what is made of it, or the error's words.
pub fn questions(random: u64) -> impl Iterator<Item = Value> {
    let none = Map::new();
    let built_in = scenes().filter_map(|info| scenario(info.id).ok()).flat_map(move |scene| {
        let none = none.clone();
        planners().into_iter().map(move |planner| configs::answer(planner.id, &scene, &none))
    });
    built_in.chain((0..random).map(configs::asked))
}

/// Hybrid A* in its random scenes of these seeds, each answer held against what is promised, as [`questions`] are.
pub fn parking(seeds: core::ops::Range<u64>) -> impl Iterator<Item = Value> {
    seeds.map(|seed| {
        let (scene, settings) = random_scenes::scene(seed);
        let question = json!({ "planner": "hybrid", "scene": scene, "settings": settings });
        configs::with_answers(question, &scene, &random_scenes::plan(seed))
    })
}

thread_local! {
    static LAST_PANIC: Cell<String> = const { Cell::new(String::new()) };
}

/// Keeps panics quiet: [`Target::ask`] reports them with their place.
pub fn catch_panics() {
    panic::set_hook(Box::new(|panic| LAST_PANIC.set(panic.to_string().replace('\n', " "))));
}

impl Target {
    /// Asks the question of a seed; a panic is an answer that is wrong.
    ///
    /// # Errors
    /// What is wrong with the answer.
    pub fn ask(&self, seed: u64) -> Outcome {
        catch_unwind(AssertUnwindSafe(|| (self.run)(seed))).unwrap_or_else(|_| Err(LAST_PANIC.take()))
    }
}

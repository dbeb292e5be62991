//! Plans tight manoeuvres by seed, for the sedan and the parking paper's car, and prints for each kind how many are
//! solved, what became of the others, and what an answer takes.
//!
//! ```sh
//! cargo run --release --example tight [all|promised|KIND] [count] [first seed] [members] [work] \
//!     [verbose] [setting=value …]
//! cargo run --release --example tight monotone [count] [first seed] [setting=value …]
//! cargo run --release --example tight fewest [count] [first seed] [KIND]
//! cargo run --release --example tight json [scenes per cell] [every]
//! cargo run --release --example tight scenes [count] [first seed]
//! ```
//!
//! `all` takes every kind in turn, the cars by turns; `promised` the kerb slots that the sedan must enter. `members`
//! asks, for each scene without a path, whether a single lattice with a far larger budget finds one. `work`
//! compares, in every fifth scene with a path, the planner's collision checks with those of the best single lattice.
//! `verbose` prints a line a scene. `monotone` makes each kerb slot longer bit by bit and counts the lengths at which
//! the car changes gear more than once more often than in a shorter one. `fewest` asks for the fewest gear changes, in
//! kerb slots with at least 1.5 m to spare unless it is given a kind, and prints where a single search takes fewer.
//! `json`, for `cargo xtask bench tight`: how tight it can be over two sizes, every so-many-th cell, and 100 scenes of
//! each kind. `scenes`, for `cargo xtask bench kerb`: the kerb slots of `promised`, one in JSON a line.

mod answer;
#[path = "../clock/mod.rs"]
mod clock;
mod fewest;
mod maps;
mod members;
mod monotone;
mod tally;
#[path = "../../tests/tight_scenes/mod.rs"]
mod tight_scenes;

use parkade::planners::hybrid::Config;
use parkade::vehicle::Vehicle;
use serde_json::{Value, json};

use answer::{Answer, Ending};
use tally::Tally;
use tight_scenes::{KINDS, Make, kerb};

type Kind = (&'static str, Make);
type Car = (&'static str, Vehicle);

/// Work is compared in every so-many-th scene of a car.
const WORK_EVERY: u64 = 5;

const CARS: [Car; 2] = [("sedan", Vehicle::SEDAN), ("paper", Vehicle::PAPER)];

/// Kerb slots which the sedan enters with 3 cm of margin or more, each.
const PROMISED: [Kind; 2] = [
    ("kerb +1.2..2.5", |car, seed| kerb(car, seed, (1.2, 2.5), (4.2, 6.5))),
    ("kerb +0.85..1.2", |car, seed| kerb(car, seed, (0.85, 1.2), (4.2, 6.5))),
];

/// Kerb slots in which no single search may take fewer gear changes than what is found for `prefer`.
const ROOMY: [Kind; 1] = [("kerb +1.5..2.5", |car, seed| kerb(car, seed, (1.5, 2.5), (4.2, 6.5)))];

fn main() {
    let (settings, words): (Vec<String>, Vec<String>) =
        std::env::args().skip(1).partition(|argument| argument.contains('='));
    let (flags, words): (Vec<String>, Vec<String>) =
        words.into_iter().partition(|word| ["members", "work", "verbose"].contains(&word.as_str()));
    let what = words.first().map_or("all", String::as_str);
    let number = |at: usize, default: u64| {
        words.get(at).map_or(default, |word| word.parse().unwrap_or_else(|_| panic!("{word} is no number")))
    };
    if what == "json" {
        return print_json(number(1, 20), number(2, 1));
    }
    let has = |name: &str| flags.iter().any(|flag| flag == name);
    let run = Run {
        config: config(&settings),
        seeds: number(2, 1)..number(2, 1) + number(1, 100),
        has_members: has("members"),
        has_work: has("work"),
        is_verbose: has("verbose"),
    };
    if what == "monotone" {
        return monotone::print(&run);
    }
    if what == "scenes" {
        return print_scenes(&run);
    }
    if what == "fewest" {
        let named =
            |name: &str| KINDS.into_iter().filter(|(kind, _)| *kind == name || name == "all").collect();
        return fewest::print(&run, &words.get(3).map_or(ROOMY.to_vec(), |kind| named(kind)), &CARS);
    }
    let (kinds, cars): (Vec<_>, _) = match what {
        "all" => (KINDS.to_vec(), &CARS[..]),
        "promised" => (PROMISED.to_vec(), &CARS[..1]),
        kind => (KINDS.into_iter().filter(|(name, _)| *name == kind).collect(), &CARS[..]),
    };
    assert!(
        !kinds.is_empty(),
        "there are all, promised, monotone, fewest, json, scenes and {}",
        KINDS.map(|(name, _)| name).join(", ")
    );
    run.table(&kinds, cars);
}

fn print_json(count: u64, every: u64) {
    let run = Run {
        config: Config::default(),
        seeds: 1..101,
        has_members: false,
        has_work: false,
        is_verbose: false,
    };
    println!("{}", json!({ "count": count, "maps": maps::measure(count, every), "kinds": run.figures() }));
}

fn print_scenes(run: &Run) {
    for seed in run.seeds.clone() {
        for (kind, make) in PROMISED {
            println!("{}", json!({ "kind": kind, "scene": make(&CARS[0].1, seed).scenario() }));
        }
    }
}

fn config(settings: &[String]) -> Config {
    let pairs = settings.iter().filter_map(|setting| setting.split_once('='));
    let value = |text: &str| serde_json::from_str(text).unwrap_or_else(|_| text.into());
    let map = pairs.map(|(name, text)| (name.to_owned(), value(text))).collect();
    Config::default().with(&map).expect("settings of hybrid A*")
}

struct Run {
    config: Config,
    seeds: std::ops::Range<u64>,
    has_members: bool,
    has_work: bool,
    is_verbose: bool,
}

impl Run {
    /// The answers of each kind for each car; the cars take the seeds in turn.
    fn tallies(&self, kinds: &[Kind], cars: &[Car]) -> Vec<(&'static str, &'static str, Tally)> {
        let mut tallies = Vec::new();
        for &(kind, make) in kinds {
            for (at, (car, vehicle)) in (0..).zip(cars) {
                let mut tally = Tally::default();
                for seed in self.seeds.clone().filter(|seed| seed % cars.len() as u64 == at) {
                    self.measure(make, vehicle, seed, &mut tally);
                }
                tallies.push((kind, *car, tally));
            }
        }
        tallies
    }

    fn table(&self, kinds: &[Kind], cars: &[Car]) {
        let tallies = self.tallies(kinds, cars);
        println!("{}", tally::HEAD);
        let mut all = Tally::default();
        for (kind, car, tally) in tallies {
            println!("{}", tally.row(&format!("{kind}, {car}")));
            all.add(tally);
        }
        println!("{}", all.row("all"));
    }

    /// Every kind in figures that are the same in every run.
    fn figures(&self) -> Vec<Value> {
        let figures = |(kind, car, tally): (&str, &str, Tally)| {
            json!({
                "kind": kind, "vehicle": car, "scenes": tally.answers.len(), "solved": tally.count(Ending::Solved),
                "undecided": tally.undecided(), "changes": tally.changes(0.5), "margin": tally.margin(),
            })
        };
        self.tallies(&KINDS, &CARS).into_iter().map(figures).collect()
    }

    fn measure(&self, make: Make, vehicle: &Vehicle, seed: u64, tally: &mut Tally) {
        let scene = make(vehicle, seed);
        let answer = Answer::of(&scene, &self.config);
        if self.is_verbose {
            println!("{}, seed {seed}: {answer}", scene.name);
        }
        if self.has_members && !answer.is_solved() {
            let solver = members::solver(&scene);
            if let Some((member, other)) = &solver {
                println!("{}, seed {seed}: {answer}; but {member}: {other}", scene.name);
            }
            tally.members.push(solver.is_some());
        }
        let is_sample = (seed / CARS.len() as u64).is_multiple_of(WORK_EVERY);
        if self.has_work && is_sample && answer.is_solved() {
            let work = members::work(&scene, &answer);
            if self.is_verbose {
                println!("work {work:.2}: {}, seed {seed}: {answer}", scene.name);
            }
            tally.work.push(work);
        }
        tally.answers.push(answer);
    }
}

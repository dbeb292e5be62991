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

#[path = "clock/mod.rs"]
mod clock;
#[path = "../tests/random_scenes/mod.rs"]
#[expect(dead_code, reason = "plans are checked elsewhere")]
mod random_scenes;
#[path = "../tests/tight_scenes/mod.rs"]
#[expect(dead_code, reason = "scenes are planned as scenarios")]
mod tight_scenes;

use std::ops::Range;
use std::path::Path;

use parkade::drive::{Limits, Route, Steps, trajectory};
use parkade::import::tpcap;
use parkade::metrics::Body;
use parkade::optimise::{Optimised, Options, Stage, fallback, optimise, stop_and_steer};
use parkade::plan::{Plan, Planner};
use parkade::planners::registry::planners;
use parkade::referee::{MotionLimits, Submission, judge, track};
use parkade::scenario::resolve::Geometry;
use parkade::scenario::{Scenario, catalog};
use parkade::vehicle::Vehicle;
use serde_json::{Map, Value, json};

type Settings = Map<String, Value>;

/// A plan, what was made of it, and the milliseconds that both took.
struct Made {
    geometry: Geometry,
    plan: Plan,
    route: Option<Route>,
    driven: Option<Optimised>,
    millis: (f64, f64),
}

fn main() {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    match arguments.iter().map(String::as_str).collect::<Vec<_>>()[..] {
        ["hashes"] => print_hashes(),
        [kind, from, to] => {
            let number = |text: &str| text.parse().expect("a whole number");
            let seeds = number(from)..number(to);
            match kind {
                "random" | "limits" => print_random(seeds, kind),
                _ => print_tight(&seeds),
            }
        }
        ["scenes"] => print_scenes(&built_in().into_iter().chain(public()).collect::<Vec<_>>()),
        ["references"] => print_references(),
        _ => print_tables(),
    }
}

fn built_in() -> Vec<(String, Scenario)> {
    let parking = catalog::scenes().filter(|s| ["parking", "tight", "paper"].contains(&s.group));
    parking.map(|s| (s.id.to_owned(), catalog::scenario(s.id).expect("a scene of the catalog"))).collect()
}

fn public() -> Vec<(String, Scenario)> {
    let folder = std::env::var("PARKADE_DATA").unwrap_or_else(|_| "../shared/data".to_owned());
    let read = |number: u32| {
        let name = format!("Case{number}");
        let text = std::fs::read_to_string(Path::new(&folder).join(format!("tpcap/{name}.csv"))).ok()?;
        let scene = tpcap::scene(&name, &text).unwrap_or_else(|error| panic!("{name}: {error}"));
        Some((name, scene))
    };
    (1..=20).filter_map(read).collect()
}

fn make(planner: &str, scene: &Scenario, settings: &Settings) -> Made {
    made_with(planner, scene, settings, &Options::default())
}

fn made_with(planner: &str, scene: &Scenario, settings: &Settings, options: &Options) -> Made {
    let mut planner = Planner::new(planner, scene, settings).expect("valid settings");
    let begin = clock::now();
    let plan = planner.plan(parkade::plan::Options::default());
    let planned = clock::now();
    let geometry = planner.geometry().clone();
    let is_drivable = plan.path.len() > 1 && plan.check.drivable();
    let route = |plan: &Plan| {
        Route::new(&geometry.vehicle, &plan.path, &plan.directions, Some(&plan.curvatures)).ok()
    };
    let route = is_drivable.then(|| route(&plan)).flatten();
    let driven = route.as_ref().map(|route| {
        let clearance = plan.metrics.min_clearance;
        optimise(&geometry, route, clearance, options).expect("valid options")
    });
    Made { geometry, plan, route, driven, millis: (planned - begin, clock::now() - planned) }
}

fn median(values: &mut [f64]) -> f64 {
    values.sort_by(f64::total_cmp);
    values.get(values.len() / 2).copied().unwrap_or(f64::NAN)
}

fn print_hashes() {
    let mut hashes = Map::new();
    for (name, scene) in built_in() {
        if let Some(made) = make("hybrid", &scene, &Map::new()).driven {
            hashes.insert(name, made.states.hash().into());
        }
    }
    println!("{:#}", json!(hashes));
}

/// Plans and trajectories of scenes of one kind.
#[derive(Default)]
struct Seeded {
    plans: u32,
    optimised: u32,
    passing: u32,
    /// Durations above those of `slow`.
    longer: u32,
    /// Durations as shares of `slow`'s.
    shares: Vec<f64>,
    /// How far a simulated car strays at most, metres.
    strays: f64,
    /// How often a car brakes and speeds up again without a stop.
    dips: Vec<f64>,
    millis: Vec<f64>,
}

impl Seeded {
    fn add(&mut self, name: &str, made: &Made, limits: &MotionLimits) {
        let (Some(route), Some(driven)) = (&made.route, &made.driven) else { return };
        let (slow, duration) = (slow(&made.geometry, route, limits), driven.check.figures.duration);
        let is_optimised = driven.stage == Stage::Optimised;
        self.plans += 1;
        self.optimised += u32::from(is_optimised);
        self.passing += u32::from(driven.check.passes());
        self.longer += u32::from(duration > slow);
        self.shares.push(duration / slow);
        self.strays = self.strays.max(strays(&made.geometry, driven));
        self.dips.push(f64::from(dips(driven)));
        self.millis.push(made.millis.1);
        if !is_optimised || !driven.check.passes() || duration > slow {
            println!(
                "{name}: {}, {duration:.2} s, slow {slow:.2} s, passes: {}, {} gear changes, clearance {:.3} m",
                driven.stage.as_str(),
                driven.check.passes(),
                made.plan.metrics.direction_changes,
                made.plan.metrics.min_clearance,
            );
        }
    }

    fn print(&mut self, kind: &str) {
        let worst = self.millis.iter().copied().fold(0.0, f64::max);
        println!(
            "{kind}: {} plans, {} optimised, {} pass, {} longer than slow; of slow's time {:.2} in the median, {:.2} at most; a \
             car strays {:.1} mm at most; it brakes and speeds up again {} times in the median; optimise {:.1} ms in \
             the median, {worst:.1} at most",
            self.plans,
            self.optimised,
            self.passing,
            self.longer,
            median(&mut self.shares),
            self.shares.last().copied().unwrap_or(f64::NAN),
            1000.0 * self.strays,
            median(&mut self.dips),
            median(&mut self.millis),
        );
    }
}

/// How far a simulated car strays from a trajectory at most, metres.
fn strays(geometry: &Geometry, driven: &Optimised) -> f64 {
    track(&geometry.vehicle, &Body::new(geometry), &driven.states).max_lateral
}

/// How often a car brakes and speeds up again without a stop: by more than a centimetre a second.
fn dips(driven: &Optimised) -> u32 {
    let (mut count, mut low, mut high) = (0, 0.0, 0.0);
    for speed in driven.states.speed.iter().map(|speed| speed.abs()) {
        if speed == 0.0 {
            (low, high) = (0.0, 0.0);
        } else if low < high - 0.01 && speed > low + 0.01 {
            count += 1;
            (low, high) = (speed, speed);
        } else if speed > high {
            (low, high) = (speed, speed);
        } else if speed < low {
            low = speed;
        }
    }
    count
}

/// Seconds of `slow` along the plan's own path within the same limits.
fn slow(geometry: &Geometry, route: &Route, limits: &MotionLimits) -> f64 {
    let vehicle = Vehicle { max_steer_rate: limits.steering_rate_of(&geometry.vehicle), ..geometry.vehicle };
    let limits = Limits {
        speed: limits.speed,
        acceleration: limits.acceleration,
        deceleration: limits.deceleration,
        lateral_acceleration: limits.lateral_acceleration.unwrap_or(100.0),
        steps: Steps::Slow,
        ..Limits::default()
    };
    trajectory(&vehicle, route, &limits).expect("a drivable path").duration
}

fn print_random(seeds: Range<u64>, kind: &str) {
    let mut seeded = Seeded::default();
    for seed in seeds {
        let (scene, settings) = random_scenes::scene(seed);
        let limits = if kind == "limits" { some_limits(seed) } else { MotionLimits::default() };
        let options = Options { limits: limits.clone(), ..Options::default() };
        seeded.add(&format!("seed {seed}"), &made_with("hybrid", &scene, &settings, &options), &limits);
    }
    seeded.print(kind);
}

/// Limits of which some are as usual and the others anything from slow to fast.
fn some_limits(seed: u64) -> MotionLimits {
    let mut state = seed.wrapping_mul(0x9e37_79b9_7f4a_7c15);
    let mut draw = |usual: f64, low: f64, high: f64| {
        state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        let share = (state >> 33) as f64 / f64::from(1_u32 << 31);
        if share < 0.5 { usual } else { low + (high - low) * (2.0 * share - 1.0) }
    };
    let lateral = draw(0.0, 0.2, 3.0);
    MotionLimits {
        speed: draw(2.5, 0.3, 6.0),
        acceleration: draw(1.0, 0.2, 4.0),
        deceleration: draw(1.0, 0.2, 4.0),
        steering_rate: draw(0.5, 0.1, 2.0),
        lateral_acceleration: (lateral > 0.0).then_some(lateral),
    }
}

/// The cars take the seeds in turn.
fn print_tight(seeds: &Range<u64>) {
    for (kind, draw) in tight_scenes::KINDS {
        let mut seeded = Seeded::default();
        for seed in seeds.clone() {
            let car = [Vehicle::SEDAN, Vehicle::PAPER][seed as usize % 2];
            let scene = draw(&car, seed).scenario();
            let made = make("hybrid", &scene, &Map::new());
            seeded.add(&format!("{kind} {seed}"), &made, &MotionLimits::default());
        }
        seeded.print(kind);
    }
}

/// Seconds that an interior-point solver needed with 0.6 rad/s and a margin of 3 cm.
const REFERENCES: [(&str, f64); 6] = [
    ("P0", 11.70),
    ("reverse-in", 14.03),
    ("L0", 14.35),
    ("L2", 12.39),
    ("P2", 14.59),
    ("perp-tail-3.2", 15.93),
];

fn print_references() {
    println!(
        "\n## Against an interior-point solver\n\nDirect multiple shooting with 0.6 rad/s and a margin of 3 cm.\n"
    );
    println!("| scene | reference s | s | |\n| --- | --- | --- | --- |");
    let limits = MotionLimits { steering_rate: 0.6, ..MotionLimits::default() };
    let options = Options { limits, margin: 0.03 };
    for (id, reference) in REFERENCES {
        let scene = catalog::scenario(id).expect("a scene of the catalog");
        let made = made_with("hybrid", &scene, &Map::new(), &options).driven.expect("a drivable path");
        let duration = made.check.figures.duration;
        println!(
            "| {id} | {reference:.2} | {duration:.2} | {:+.1} % |",
            100.0 * (duration / reference - 1.0)
        );
    }
}

fn print_tables() {
    let scenes: Vec<(String, Scenario)> = built_in().into_iter().chain(public()).collect();
    println!("# Trajectories\n\nWritten by `cargo xtask bench judge`.\n");
    print_scenes(&scenes);
    print_references();
    print_planners(&scenes);
}

/// Seconds from rest to rest over a length without a stop.
fn bound(limits: &MotionLimits, length: f64) -> f64 {
    let inverse = 1.0 / limits.acceleration + 1.0 / limits.deceleration;
    let peak = limits.speed.min((2.0 * length / inverse).sqrt());
    length / peak + peak / 2.0 * inverse
}

fn print_scenes(scenes: &[(String, Scenario)]) {
    println!("## Hybrid A*'s plans, optimised\n");
    println!(
        "2.5 m/s, 1 m/s², 0.5 rad/s. `slow` and stop-and-steer drive the plan's own path within the same limits, as \
         does what is left where nothing optimised passes (fallback); the bound is \
         the length at those limits without a stop. Track: how far a simulated car strays at most. \
         Dips: how often it brakes and speeds up again without a stop.\n"
    );
    println!(
        "| scene | made by | s | bound s | `slow` s | stop-and-steer s | fallback s | length m (plan's) | gear \
         changes (plan's) | clearance m | track mm | dips | passes | smoothness | TPCAP cost |"
    );
    println!("| --- | --- | --- | --- | --- | --- | --- | --- | --- | --- | --- | --- | --- | --- | --- |");
    let (mut plans, mut optimised_plans, mut passing) = (0, 0, 0);
    let (mut saved, mut millis, mut worst) = (Vec::new(), Vec::new(), 0.0_f64);
    for (name, scene) in scenes {
        let Made { geometry, plan, route, driven: made, millis: (planned, optimised) } =
            make("hybrid", scene, &Map::new());
        let (Some(made), Some(route)) = (made, route) else {
            println!("| {name} | no path |");
            continue;
        };
        let options = Options::default();
        let slow = slow(&geometry, &route, &options.limits);
        let plain = stop_and_steer(&geometry.vehicle, &route, &options.limits).duration();
        let own = fallback(&geometry, &route, &options.limits).expect("valid limits");
        let figures = &made.check.figures;
        println!(
            "| {name} | {} | {:.2} | {:.2} | {slow:.2} | {plain:.2} | {:.2} | {:.2} ({:.2}) | {} ({}) | {:.3} | {:.1} | {} | {} | \
             {:.1} | {:.0} |",
            made.stage.as_str(),
            figures.duration,
            bound(&options.limits, figures.length),
            own.check.figures.duration,
            figures.length,
            plan.metrics.length,
            figures.gear_changes,
            plan.metrics.direction_changes,
            made.check.contacts.min_clearance,
            1000.0 * strays(&geometry, &made),
            dips(&made),
            if made.check.passes() { "yes" } else { "no" },
            figures.smoothness(),
            figures.tpcap_cost(),
        );
        plans += 1;
        optimised_plans += u32::from(made.stage == Stage::Optimised);
        passing += u32::from(made.check.passes());
        saved.push(1.0 - figures.duration / slow);
        millis.push(planned + optimised);
        worst = worst.max(optimised);
    }
    println!(
        "\n{optimised_plans} of {plans} plans are optimised, {passing} pass. Against `slow`: {:.0} % less in the median, {:.0} % at least.",
        100.0 * median(&mut saved),
        100.0 * saved.iter().copied().fold(f64::INFINITY, f64::min)
    );
    eprintln!(
        "plan and optimise: median {:.1} ms; optimise alone: at most {worst:.1} ms",
        median(&mut millis)
    );
}

/// What a planner reached.
#[derive(Default)]
struct Tally {
    attained: u32,
    untouched: u32,
    both: u32,
    seconds: Vec<f64>,
    smoothness: Vec<f64>,
}

impl Tally {
    fn add(&mut self, found: &parkade::referee::Judgement) {
        let is_free = found.contacts.touching_frames == 0;
        self.attained += u32::from(found.attained);
        self.untouched += u32::from(is_free);
        self.both += u32::from(found.attained && is_free);
        self.seconds.push(found.figures.duration);
        self.smoothness.push(found.figures.smoothness());
    }

    fn cells(&mut self) -> String {
        if self.seconds.is_empty() {
            return "– | – | – | – | –".to_owned();
        }
        let (seconds, smoothness) = (median(&mut self.seconds), median(&mut self.smoothness));
        format!("{} | {} | {} | {seconds:.1} | {smoothness:.0}", self.attained, self.untouched, self.both)
    }
}

fn print_planners(scenes: &[(String, Scenario)]) {
    println!(
        "\n## All planners\n\nOf {} scenes. Each path is timed and driven by the closed-loop follower as the",
        scenes.len()
    );
    println!(
        "protocol says (first row), and optimised where a car can drive it (second row). Medians of s and smoothness.\n"
    );
    println!("| planner | driven | paths | attained | no touching frame | both | s | smoothness |");
    println!("| --- | --- | --- | --- | --- | --- | --- | --- |");
    for planner in planners() {
        let (mut paths, mut plans, mut followed, mut optimised) = (0, 0, Tally::default(), Tally::default());
        for (_, scene) in scenes {
            let Made { geometry, plan, driven, .. } = make(planner.id, scene, &Map::new());
            if plan.path.len() > 1 {
                paths += 1;
                let gears = Some(plan.directions.clone());
                let submission = Submission::Path { poses: plan.path.clone(), gears };
                if let Ok(found) = judge(&geometry, &submission, &MotionLimits::default()) {
                    followed.add(&found);
                }
            }
            if let Some(made) = driven {
                plans += 1;
                optimised.add(&made.check);
            }
        }
        println!("| {} | by the follower | {paths} | {} |", planner.id, followed.cells());
        println!("| {} | optimised | {plans} | {} |", planner.id, optimised.cells());
    }
}

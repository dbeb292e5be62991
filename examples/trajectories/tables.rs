//! The tables of `benches/TRAJECTORIES.md`.

use parkade::optimise::{Options, Stage, fallback, slow_duration, stop_and_steer};
use parkade::planners::registry::planners;
use parkade::referee::{Judgement, MotionLimits, Submission, judge};
use parkade::scenario::{Scenario, catalog};
use serde_json::Map;

use crate::made::{Made, dips, made_with, make, median, scenes, strays};

/// Seconds that an interior-point solver needed with 0.6 rad/s and a margin of 3 cm.
const REFERENCES: [(&str, f64); 6] = [
    ("P0", 11.70),
    ("reverse-in", 14.03),
    ("L0", 14.35),
    ("L2", 12.39),
    ("P2", 14.59),
    ("perp-tail-3.2", 15.93),
];

pub(crate) fn print_references() {
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

pub(crate) fn print_tables() {
    let scenes = scenes();
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

pub(crate) fn print_scenes(scenes: &[(String, Scenario)]) {
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
        let slow = slow_duration(&geometry.vehicle, &route, &options.limits);
        let plain = stop_and_steer(&geometry.vehicle, &route, &options.limits).duration();
        let own = fallback(&geometry, &route, &options.limits).expect("valid limits");
        let figures = &made.check.figures;
        println!(
            "| {name} | {} | {:.2} | {:.2} | {slow:.2} | {plain:.2} | {:.2} | {:.2} ({:.2}) | {} ({}) | {:.3} | \
             {:.1} | {} | {} | {:.1} | {:.0} |",
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
        "\n{optimised_plans} of {plans} plans are optimised, {passing} pass. Against `slow`: \
         {:.0} % less in the median, {:.0} % at least.",
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
    fn add(&mut self, found: &Judgement) {
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

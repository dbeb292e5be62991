//! Plans tight manoeuvres by seed and prints, for each kind, how many are solved, with how much margin and how fast.
//!
//! ```sh
//! cargo run --release --example tight [count] [first seed] [setting=value …]
//! ```

use std::collections::BTreeMap;
use std::time::Instant;

use parkade::geometry::arcs;
use parkade::planners::hybrid::{Config, Query, Scratch, Status, plan};

#[path = "../tests/tight_scenes/mod.rs"]
mod tight_scenes;
use tight_scenes::{CAR, Scene, bay, corner, kerb};

type Make = fn(u64) -> Scene;

#[derive(Default)]
struct Tally {
    solved: u32,
    statuses: BTreeMap<String, u32>,
    margins: BTreeMap<String, u32>,
    changes: Vec<f64>,
    millis: Vec<f64>,
    failing: Vec<f64>,
    expanded: Vec<f64>,
}

fn main() {
    let (settings, numbers): (Vec<String>, Vec<String>) =
        std::env::args().skip(1).partition(|a| a.contains('='));
    let number = |i: usize, default: u64| numbers.get(i).map_or(default, |n| n.parse().expect("a number"));
    let (count, first) = (number(0, 40), number(1, 1));
    let mut map = serde_json::Map::new();
    let mut verbose = false;
    for argument in settings {
        let (name, value) = argument.split_once('=').expect("name=value");
        if name == "verbose" {
            verbose = true;
            continue;
        }
        map.insert(name.to_owned(), serde_json::from_str(value).unwrap_or_else(|_| value.into()));
    }
    let config = Config::default().with(&map).expect("settings of hybrid A*");
    let kinds: [(&str, Make); 6] = [
        ("kerb +1.2..2.5", |s| kerb(s, (1.2, 2.5), (4.2, 6.5))),
        ("kerb +0.85..1.2", |s| kerb(s, (0.85, 1.2), (4.2, 6.5))),
        ("kerb +0.4..0.85", |s| kerb(s, (0.4, 0.85), (3.5, 6.5))),
        ("bay +0.5..1.2", |s| bay(s, (0.5, 1.2), (4.5, 7.0))),
        ("bay +0.3..0.5", |s| bay(s, (0.3, 0.5), (4.0, 6.0))),
        ("corner 2.2..4.5", |s| corner(s, (2.2, 4.5))),
    ];
    println!(
        "| kind | solved | statuses | margins cm | changes | ms p50 | p95 | failing p50 | worst | expanded p50 | p95 |"
    );
    println!("| --- | --- | --- | --- | --- | --- | --- | --- | --- | --- | --- |");
    for (name, make) in kinds {
        let mut tally = Tally::default();
        for seed in first..first + count {
            measure(&make(seed), &config, verbose, &mut tally);
        }
        let at = |values: &mut Vec<f64>, share: f64| {
            values.sort_by(f64::total_cmp);
            if values.is_empty() {
                f64::NAN
            } else {
                values[((values.len() - 1) as f64 * share).round() as usize]
            }
        };
        println!(
            "| {name} | {}/{count} | {:?} | {:?} | {:.0} | {:.1} | {:.1} | {:.1} | {:.1} | {:.0} | {:.0} |",
            tally.solved,
            tally.statuses,
            tally.margins,
            at(&mut tally.changes, 0.5),
            at(&mut tally.millis, 0.5),
            at(&mut tally.millis, 0.95),
            at(&mut tally.failing, 0.5),
            at(&mut tally.millis, 1.0),
            at(&mut tally.expanded, 0.5),
            at(&mut tally.expanded, 0.95),
        );
    }
}

fn measure(scene: &Scene, config: &Config, verbose: bool, tally: &mut Tally) {
    let query = Query { obstacles: &scene.obstacles, vehicle: &CAR, start: scene.start, goal: scene.goal };
    let begin = Instant::now();
    let report = plan(&query, config, &mut Scratch::default(), false, &mut None);
    let millis = begin.elapsed().as_secs_f64() * 1e3;
    let solved = matches!(report.status, Status::Found | Status::Suboptimal);
    let status = format!("{:?}", report.status);
    let status = status.split(['(', ' ', '{']).next().unwrap_or("").to_owned();
    if verbose {
        println!(
            "{}: {status}, margin {:.3}, {} changes, {} expanded, {millis:.0} ms, level {}",
            scene.name,
            report.margin,
            arcs::direction_changes(&report.arcs),
            report.expanded,
            report.level
        );
    }
    *tally.statuses.entry(status).or_default() += 1;
    tally.expanded.push(f64::from(report.expanded));
    tally.millis.push(millis);
    if solved {
        tally.solved += 1;
        tally.changes.push(f64::from(arcs::direction_changes(&report.arcs)));
        *tally.margins.entry(format!("{:04.1}", report.margin * 100.0)).or_default() += 1;
    } else {
        tally.failing.push(millis);
    }
}

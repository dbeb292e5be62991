//! Plans the cases of the TPCAP competition and the lots of `parking_scenes`, and prints what was reached and how fast.
//!
//! ```sh
//! PARKADE_DATA=folder cargo run --release --example tpcap [case or lot …] [setting=value …]
//! PARKADE_DATA=folder cargo run --release --example tpcap preferred [setting=value …]
//! PARKADE_DATA=folder cargo run --release --example tpcap json
//! PARKADE_DATA=folder cargo run --release --example tpcap time scene
//! ```
//!
//! `preferred` asks for the fewest gear changes and for the shortest path, and prints them beside those of the ordinary
//! answer and the best known.
//! `json` and `time`, for `cargo xtask bench parking`: these, the parking paper's rows and the tight slots with their
//! scenes, by the usual settings and by those that the best known are compared with.
//!
//! The folder holds `tpcap/Case*.csv` and `parking_scenes/scenes.json`. Every path is checked by the validator, which
//! tests the exact body every 2 cm. Times are of the processor, the least of several runs: preparing the obstacles,
//! then search, shortcut and verification of one query.

#[path = "clock/mod.rs"]
mod clock;

use std::path::Path;

use parkade::import::{lots, tpcap};
use parkade::metrics::Verdict;
use parkade::plan::{Options, Plan, Planner};
use parkade::planners::hybrid::{Config, Prefer, Query, Report, Scratch, obstacles, plan};
use parkade::scenario::{Scenario, catalog};
use serde_json::{Map, Value, json};

/// Best of the public planners that were tried on these scenes: shortest valid path, m; fewest gear changes; least
/// milliseconds.
const BEST: [(&str, f64, u32, f64); 18] = [
    ("Case1", 10.5, 2, 3.1),
    ("Case3", 18.3, 1, 4.7),
    ("Case5", 9.0, 0, 0.1),
    ("Case9", 33.1, 1, 20.8),
    ("Case11", 31.4, 0, 4.5),
    ("Case13", 13.3, 2, 2.5),
    ("Case15", 18.3, 1, 3.0),
    ("Case17", 8.0, 0, 0.1),
    ("Case19", 45.7, 2, 13.9),
    ("perp_w4", 26.5, 0, 13.1),
    ("perp_w3.2", 28.7, 0, 12.8),
    ("perp_orig20", 22.4, 0, 0.7),
    ("par_orig20", 31.2, 0, 28.9),
    ("par_7.5", 44.8, 4, 13.9),
    ("par_9", 41.8, 2, 24.2),
    ("wh_master", 19.0, 1, 0.7),
    ("wh_first-2", 25.3, 1, 8.5),
    ("slot12_parallel", 33.5, 1, 40.2),
];

/// Where the path with the fewest gear changes is another one: its length, m.
const FEWEST: [(&str, f64); 1] = [("Case19", 63.4)];

/// A batch of queries lasts this long, milliseconds, or has `MOST` of them.
const BATCH: f64 = 40.0;
const MOST: u32 = 1024;

/// The best known come from programs that keep no margin: as near as this, metres, and as dear a gear change, metres,
/// one setting has both short paths and few gear changes.
const NEAR: (f64, f64) = (0.03, 1.5);

fn main() {
    let (settings, wanted): (Vec<String>, Vec<String>) =
        std::env::args().skip(1).partition(|a| a.contains('='));
    let folder = std::env::var("PARKADE_DATA").unwrap_or_else(|_| "../shared/data".to_owned());
    let mut scenes = cases(&Path::new(&folder).join("tpcap"));
    scenes.extend(numbered(&Path::new(&folder).join("parking_scenes/scenes.json")));
    match wanted.iter().map(String::as_str).collect::<Vec<_>>()[..] {
        ["json"] => return print_json(&scenes),
        ["time", name] => return print_time(&scenes, name),
        ["preferred"] => return print_preferred(&scenes, &config(&settings)),
        _ => {}
    }
    if scenes.is_empty() {
        println!(
            "no cases in {folder}: set PARKADE_DATA to a folder with tpcap/Case1.csv (libai1943/TPCAP_benchmarks)"
        );
        return;
    }
    let config = config(&settings);
    println!(
        "| scene | valid | length m (best known) | bound m | changes | clearance | level | margin | expanded | \
         prepare ms | plan ms (best known) |"
    );
    println!("| --- | --- | --- | --- | --- | --- | --- | --- | --- | --- | --- |");
    let mut times = Vec::new();
    for scene in &scenes {
        let name = scene.name.clone().unwrap_or_default();
        if wanted.is_empty() || wanted.contains(&name) {
            let millis = row(&name, scene, &config);
            if name.starts_with("Case") {
                times.push(millis);
            }
        }
    }
    times.sort_by(f64::total_cmp);
    if let (Some(median), Some(worst)) = (times.get(times.len() / 2), times.last()) {
        println!("\nTPCAP: median {median:.2} ms, worst {worst:.2} ms");
    }
}

/// Everything that the benchmark shows, but for WebAssembly.
fn print_json(scenes: &[Scenario]) {
    let built_in = |group| {
        let of = catalog::scenes().filter(move |s| s.group == group);
        of.map(move |s| (group, s.id.to_owned(), catalog::scenario(s.id).expect("a scene of the catalog")))
    };
    let named = |s: &Scenario| {
        let name = s.name.clone().unwrap_or_default();
        (if name.starts_with("Case") { "tpcap" } else { "lots" }, name, s.clone())
    };
    let all = scenes.iter().map(named).chain(built_in("paper")).chain(built_in("tight"));
    let rows: Vec<Value> = all.map(|(group, name, scene)| entry(group, &name, &scene)).collect();
    let (margin, change) = NEAR;
    println!("{}", json!({ "near": { "margin": margin, "directionChangeCost": change }, "rows": rows }));
}

/// Milliseconds of one scene's whole plan, so that both sides can be timed in turns.
fn print_time(scenes: &[Scenario], name: &str) {
    let found = scenes.iter().find(|s| s.name.as_deref() == Some(name));
    let scene = found.cloned().unwrap_or_else(|| catalog::scenario(name).expect("a scene"));
    let mut planner = Planner::new("hybrid", &scene, &Map::new()).expect("valid settings");
    println!("{}", least(|| planner.plan(Options::default())).1);
}

fn entry(group: &str, name: &str, scene: &Scenario) -> Value {
    let (plan, report, prepare, query) = run(scene, &Map::new());
    let best = BEST.iter().find(|b| b.0 == name);
    let near = (best.is_some() || group == "tpcap").then(|| {
        let settings = [("margin", NEAR.0), ("directionChangeCost", NEAR.1)];
        let settings = settings.into_iter().map(|(name, value)| (name.to_owned(), json!(value))).collect();
        let (plan, _, _, query) = run(scene, &settings);
        json!({
            "verdict": plan.check.verdict.as_str(),
            "length": plan.metrics.length, "changes": plan.metrics.direction_changes,
            "query": query,
        })
    });
    let length_of_fewest = FEWEST.iter().find(|known| known.0 == name).map(|known| known.1);
    json!({
        "group": group, "name": name, "scene": scene, "hash": plan.hash(),
        "verdict": plan.check.verdict.as_str(),
            "length": plan.metrics.length, "changes": plan.metrics.direction_changes,
        "clearance": plan.metrics.min_clearance, "bound": report.rs_bound, "level": report.level,
        "margin": report.margin, "expanded": report.stats.expanded,
        "prepare": prepare, "query": query,
        "best": best.map(|b| json!({
            "length": b.1, "changes": b.2, "milliseconds": b.3, "lengthOfFewest": length_of_fewest,
        })),
        "near": near,
    })
}

/// Gear changes and lengths: of the ordinary answer, of the one with the fewest changes, of the shortest with the
/// ordinary margin, and of the best known.
fn print_preferred(scenes: &[Scenario], settings: &Map<String, Value>) {
    println!(
        "| scene | ordinary: changes | m | margin | fewest changes | m | margin | shortest: changes | m | margin | \
         best known: changes | m | bound, m |"
    );
    println!("|{}", " --- |".repeat(13));
    for scene in scenes {
        let name = scene.name.clone().unwrap_or_default();
        let mut planner = Planner::new("hybrid", scene, settings).expect("valid settings");
        let mut told = |prefer: Option<Prefer>| {
            let plan = planner.plan(Options { prefer, ..Options::default() });
            assert_eq!(plan.check.verdict, Verdict::Ok, "{name}, {prefer:?}");
            let hybrid = plan.metrics.hybrid.as_ref().expect("a plan of hybrid A*");
            format!("{} | {:.2} | {}", plan.metrics.direction_changes, plan.metrics.length, hybrid.margin)
        };
        let plans = [None, Some(Prefer::FewestChanges), Some(Prefer::Shortest)].map(&mut told).join(" | ");
        let best = BEST.iter().find(|best| best.0 == name);
        let best = best.map_or(String::from("– | –"), |best| format!("{} | {}", best.2, best.1));
        let bound = run(scene, settings).1.rs_bound;
        println!("| {name} | {plans} | {best} | {bound:.2} |");
    }
}

/// Plans a scene and prints its row; the milliseconds of one query.
fn row(name: &str, scene: &Scenario, config: &Map<String, Value>) -> f64 {
    let (whole, report, prepare, millis) = run(scene, config);
    let best = BEST.iter().find(|b| b.0 == name);
    println!(
        "| {name} | {} | {:.2} ({}) | {:.2} | {} ({}) | {:.3} | {} | {:.2} | {} | {prepare:.2} | {millis:.2} ({}) | {}",
        if whole.check.verdict == Verdict::Ok { "yes" } else { whole.check.verdict.as_str() },
        whole.metrics.length,
        best.map_or(String::from("–"), |b| b.1.to_string()),
        report.rs_bound,
        whole.metrics.direction_changes,
        best.map_or(String::from("–"), |b| b.2.to_string()),
        whole.metrics.min_clearance,
        report.level,
        report.margin,
        report.stats.expanded,
        best.map_or(String::from("–"), |b| b.3.to_string()),
        whole.reason.unwrap_or_default(),
    );
    millis
}

fn run(scene: &Scenario, config: &Map<String, Value>) -> (Plan, Report, f64, f64) {
    let mut planner = Planner::new("hybrid", scene, config).expect("valid settings");
    let whole = planner.plan(Options::default());
    let geometry = scene.geometry().expect("a valid scene");
    let settings = Config::default().with(config).expect("settings of hybrid A*");
    let (obstacles, prepare) = least(|| obstacles(&geometry));
    let vehicle = &geometry.vehicle;
    let query = Query { obstacles: &obstacles, vehicle, start: geometry.start, goal: geometry.goal };
    // Nothing is known from a query before.
    let (report, millis) = least(|| plan(&query, &settings, &mut Scratch::default(), false, &mut None));
    (whole, report, prepare, millis)
}

fn config(arguments: &[String]) -> Map<String, Value> {
    let pair = |a: &String| {
        let (name, value) = a.split_once('=').expect("name=value");
        (name.to_owned(), serde_json::from_str(value).unwrap_or_else(|_| value.into()))
    };
    arguments.iter().map(pair).collect()
}

/// The cases of a folder by number.
fn cases(folder: &Path) -> Vec<Scenario> {
    let read = |number: u32| {
        let name = format!("Case{number}");
        let text = std::fs::read_to_string(folder.join(format!("{name}.csv"))).ok()?;
        Some(tpcap::scene(&name, &text).unwrap_or_else(|error| panic!("{name}: {error}")))
    };
    (1..=20).filter_map(read).collect()
}

/// Every lot in a file, however deep; candidates inherit what stands beside them.
fn numbered(file: &Path) -> Vec<Scenario> {
    let Ok(text) = std::fs::read_to_string(file) else { return Vec::new() };
    let mut scenes = Vec::new();
    collect(&serde_json::from_str(&text).expect("JSON"), &Map::new(), &mut scenes);
    scenes
}

fn collect(value: &Value, outer: &Map<String, Value>, scenes: &mut Vec<Scenario>) {
    match value {
        Value::Array(items) => items.iter().for_each(|item| collect(item, outer, scenes)),
        Value::Object(own) => {
            let mut all = outer.clone();
            all.extend(
                own.iter()
                    .filter(|f| !f.0.ends_with('s') || f.0 == "lines")
                    .map(|(k, v)| (k.clone(), v.clone())),
            );
            if own.contains_key("id") {
                all.extend(own.clone());
                scenes.extend(lots::scenes(&all.into()).unwrap_or_else(|error| panic!("{error}")));
            } else {
                own.values().for_each(|inner| collect(inner, &all, scenes));
            }
        }
        _ => {}
    }
}

/// The least of some batches, each long enough for a coarse clock: the system may tell a thread's time only when it
/// interrupts it, every few milliseconds.
fn least<T>(mut run: impl FnMut() -> T) -> (T, f64) {
    let mut value = run();
    let mut batch = |runs: u32| {
        let begin = clock::now();
        (0..runs).for_each(|_| value = run());
        clock::now() - begin
    };
    let mut runs = 1;
    while batch(runs) < BATCH && runs < MOST {
        runs *= 2;
    }
    let best = (0..3).map(|_| batch(runs)).fold(f64::INFINITY, f64::min) / f64::from(runs);
    (value, best)
}

//! The road manuscript's tables beside plain A*, ours and its own method taken literally.

use std::fmt::Write as _;
use std::time::Instant;

use parkade::metrics::risk::{self, Risk};
use parkade::metrics::road::RoadMetrics;
use parkade::plan::{Options, Planner, collision_risk};
use parkade::scenario::catalog;
use serde_json::{Value, json};

const SCENES: [(&str, &str); 4] =
    [("S1", "road-straight"), ("S2", "road-curve"), ("S3", "road-crossing"), ("S4", "road-narrow")];
/// Rounds of which the fastest counts.
const ROUNDS: u32 = 5;

/// What one planner makes of a scene.
struct Line {
    name: &'static str,
    verdict: &'static str,
    metrics: RoadMetrics,
    risk: Risk,
    milliseconds: f64,
}

/// A promise and whether it is kept.
struct Item {
    scene: &'static str,
    text: &'static str,
    found: String,
    kept: bool,
}

pub(crate) fn print(as_json: bool) {
    let printed: Value = serde_json::from_str(include_str!("../../tests/data/paper-tables-road.json"))
        .expect("valid JSON in the repository");
    let tables: Vec<(&str, &str, Vec<Line>)> = SCENES.map(|(row, id)| (row, id, lines(id))).into();
    let items: Vec<Item> = tables.iter().flat_map(|(row, _, lines)| promises(row, lines)).collect();
    if as_json {
        let line = |l: &Line| json!({ "planner": l.name, "verdict": l.verdict, "metrics": l.metrics, "risk": l.risk, "milliseconds": l.milliseconds });
        let tables: Vec<Value> = tables
            .iter()
            .map(|(row, id, lines)| json!({ "row": row, "scene": id, "lines": lines.iter().map(line).collect::<Vec<_>>() }))
            .collect();
        let items: Vec<Value> = items
            .iter()
            .map(|i| json!({ "scene": i.scene, "text": i.text, "found": i.found, "kept": i.kept }))
            .collect();
        println!(
            "{:#}",
            json!({ "printed": printed["tables"], "tables": tables, "promises": items, "flags": printed["flags"] })
        );
        return;
    }
    print!("{}", markdown(&printed, &tables, &items));
}

fn lines(id: &'static str) -> Vec<Line> {
    [
        ("plain A*", json!({ "costs": "steps", "pruning": "none", "smoothing": "none" })),
        ("cost map, K/(d+ε)", json!({})),
        ("cost map, A·exp(−B·d)", json!({ "base": "exponential" })),
        ("the manuscript's, literally", json!({ "costs": "paper", "pruning": "los", "smoothing": "paper" })),
    ]
    .map(|(name, settings)| line(id, name, &settings))
    .into()
}

fn line(id: &str, name: &'static str, settings: &Value) -> Line {
    let scene = catalog::scenario(id).expect("a scene of the catalog");
    let settings = settings.as_object().expect("an object");
    let mut milliseconds = f64::INFINITY;
    let mut last = None;
    for _ in 0..ROUNDS {
        let start = Instant::now();
        let mut planner = Planner::new("cost-map", &scene, settings).expect("valid settings");
        let plan = planner.plan(Options::default());
        milliseconds = milliseconds.min(start.elapsed().as_secs_f64() * 1e3);
        last = Some(plan);
    }
    let plan = last.expect("at least one round");
    let path: Vec<f64> = plan.path.iter().flat_map(|p| [p.x, p.y, p.heading]).collect();
    let risk = collision_risk(&scene, &path, &risk::Options::default()).expect("a path");
    let metrics = plan.metrics.road.expect("a path");
    Line { name, verdict: plan.check.verdict.as_str(), metrics, risk, milliseconds }
}

/// What is promised of a scene.
fn promises(scene: &'static str, lines: &[Line]) -> Vec<Item> {
    let (old, new) = (&lines[0], &lines[1]);
    let (was, is) = (&old.metrics.figures, &new.metrics.figures);
    let percent = |new: f64, old: f64| (new / old - 1.0) * 100.0;
    let item = |text, found: String, kept| Item { scene, text, found, kept };
    let cut = percent(is.curvature_variation, was.curvature_variation);
    let turns = percent(f64::from(new.metrics.turns_pruned), f64::from(old.metrics.turns_pruned));
    let (least, mean) = (is.body_clearance_min, is.body_clearance_mean);
    let mut items = vec![item(
        "no longer than plain A*",
        format!("{:.1} m, plain {:.1} m", is.middle_length, was.middle_length),
        is.middle_length <= was.middle_length + 1e-6,
    )];
    if scene == "S1" {
        items.push(item(
            "2 turning points",
            new.metrics.turns_pruned.to_string(),
            new.metrics.turns_pruned == 2,
        ));
        items.push(item("body clearance ≥ 0.79 m", format!("{least:.2} m"), least >= 0.79));
    } else {
        let found = format!("{} of {}, {turns:.0} %", new.metrics.turns_pruned, old.metrics.turns_pruned);
        items.push(if scene == "S4" {
            item("≤ 11 turning points", found, new.metrics.turns_pruned <= 11)
        } else {
            item("turning points −55 %", found, turns <= -55.0)
        });
        let found =
            format!("{:.2} after {:.2} 1/m, {cut:.1} %", is.curvature_variation, was.curvature_variation);
        items.push(item("curvature variation −75 %", found, cut <= -75.0));
        let found = format!("{mean:.2} / {least:.2} m");
        items.push(item("body clearance mean ≥ 0.8, least ≥ 0.5 m", found, mean >= 0.8 && least >= 0.5));
        let found = format!("{} after {} of 1000", new.risk.hits, old.risk.hits);
        items.push(item("hits ≤ 5 % of plain A*", found, new.risk.hits * 20 <= old.risk.hits));
    }
    items.push(item(
        "curvature ≤ 0.1818 1/m",
        format!("{:.3} 1/m", is.middle_curvature),
        is.middle_curvature <= 0.1818,
    ));
    items.push(item("the checker's verdict", new.verdict.to_owned(), new.verdict == "ok"));
    items
}

fn markdown(printed: &Value, tables: &[(&str, &str, Vec<Line>)], items: &[Item]) -> String {
    let mut text = String::from(
        "# Road navigation manuscript, section 4\n\nBody clearances are mean (at most 1.2 m each) and least; hits are of 1000 drives beside the path by chance, in brackets for a disc.\nMilliseconds are of everything, rasters and checks included, here and natively.\n",
    );
    for (row, id, lines) in tables {
        let of = |table: &str, column: usize| printed["tables"][table][row][column].to_string();
        let _ = writeln!(
            text,
            "\n## {row}: `{id}`\n\n| | length, m | turning points | body clearance, m | curvature variation, 1/m | hits | lane deviation, m | kB | ms | check |\n| --- | --- | --- | --- | --- | --- | --- | --- | --- | --- |"
        );
        for (name, column) in [("printed, plain", 0), ("printed, improved", 1)] {
            let _ = writeln!(
                text,
                "| {name} | {} | {} | {} ⚠ | – | {} | – | {} MB | {} s | – |",
                of("path_length", column),
                of("turning_points", column),
                of("safety_distance", column),
                of("collisions_per_1000", column),
                of("memory", column),
                of("time", column),
            );
        }
        for line in lines {
            let (m, f) = (&line.metrics, &line.metrics.figures);
            let _ = writeln!(
                text,
                "| {} | {:.1} | {} | {:.2} / {:.2} | {:.2} | {} ({}) | {:.2} / {:.2} | {} | {:.1} | {} |",
                line.name,
                f.middle_length,
                m.turns_pruned,
                f.body_clearance_mean,
                f.body_clearance_min,
                f.curvature_variation,
                line.risk.hits,
                line.risk.disc_hits,
                f.lane_deviation_mean.unwrap_or(0.0),
                f.lane_deviation_max.unwrap_or(0.0),
                m.bytes / 1000,
                line.milliseconds,
                line.verdict,
            );
        }
    }
    text.push_str("\n## Promises\n\n| | promised | found | kept |\n| --- | --- | --- | --- |\n");
    for Item { scene, text: promise, found, kept } in items {
        let _ = writeln!(text, "| {scene} | {promise} | {found} | {} |", if *kept { "yes" } else { "no" });
    }
    text.push_str("\n## ⚠ What the manuscript's numbers cannot be\n\n");
    for flag in printed["flags"].as_array().into_iter().flatten().filter_map(Value::as_str) {
        let _ = writeln!(text, "* {flag}");
    }
    text
}

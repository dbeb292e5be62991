//! Audits of drawn lots: how long they take, what they find, and the standards' smallest bays and aisles.
//!
//! `cargo run --release --example audit -- lots [FROM TO] [threads] [ROWS BAYS]`, `… -- presets [threads] [ID]`,
//! `… -- goals [seeds] [threads] [BAYS]`, `… -- moves [FROM TO]`, `… -- standards`

use std::ops::ControlFlow;
use std::time::Instant;

use parkade::Error;
use parkade::audit::standards::CASES;
use parkade::audit::{Auditor, Known, Options, Row, affected};
use parkade::scenario::lot::{Lot, PRESETS};
use parkade::scenario::{Entry, Obstacle, Scenario};
use serde_json::{Value, json};

fn main() -> Result<(), Error> {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let number = |at: usize, default: u64| arguments.get(at).and_then(|n| n.parse().ok()).unwrap_or(default);
    match arguments.first().map(String::as_str) {
        Some("standards") => standards()?,
        Some("moves") => moves(number(1, 1), number(2, 4))?,
        Some("presets") => {
            for preset in PRESETS.iter().filter(|one| arguments.get(2).is_none_or(|id| id == one.id)) {
                report(preset.id, &preset.lot, number(1, 2) as usize)?;
            }
        }
        Some("goals") => {
            let lots = [("60 bays", 4, 15), ("240 bays", 8, 30)];
            let is_asked = |count: u64| number(3, count) == count;
            for (name, rows, bays) in lots.into_iter().filter(|&(_, rows, bays)| is_asked(rows * bays)) {
                for seed in 1..=number(1, 3) {
                    let fields = json!({ "seed": seed, "rows": rows, "bays": bays });
                    report(
                        &format!("{name}, seed {seed}"),
                        &Lot::from_json(&fields)?,
                        number(2, 2) as usize,
                    )?;
                }
            }
        }
        _ => {
            for seed in number(1, 1)..number(2, 11) {
                let mut fields = json!({ "seed": seed });
                if let (rows @ 1.., bays @ 1..) = (number(4, 0), number(5, 0)) {
                    (fields["rows"], fields["bays"]) = (rows.into(), bays.into());
                }
                report(&format!("seed {seed}"), &Lot::from_json(&fields)?, number(3, 2) as usize)?;
            }
        }
    }
    Ok(())
}

/// The standards' sizes, and what a narrower aisle costs.
fn standards() -> Result<(), Error> {
    println!("| standard | vehicle | angle | entry | bay | aisle | moves | with 80 % of the aisle |");
    println!("|---|---|---|---|---|---|---|---|");
    for case in CASES {
        let told = |aisle: f64| -> Result<String, Error> {
            let way = case.ask(aisle)?;
            Ok(if way.reachable { way.moves.to_string() } else { way.outcome.to_owned() })
        };
        let entry = if case.entry == Entry::HeadIn { "head-in" } else { "reverse-in" };
        let [width, length] = case.bay;
        let (full, cut) = (told(case.aisle)?, told(0.8 * case.aisle)?);
        println!(
            "| {} | {} | {}° | {entry} | {width:.2} × {length:.2} m | {:.2} m | {full} | {cut} |",
            case.source, case.vehicle, case.degrees, case.aisle
        );
    }
    Ok(())
}

/// Audits a lot and prints a line.
fn report(name: &str, lot: &Lot, threads: usize) -> Result<(), Error> {
    let drawn = lot.draw()?;
    let from = Instant::now();
    let rows = in_threads(&drawn.scene, &json!({ "whatIf": "each-free" }), threads)?;
    let seconds = from.elapsed().as_secs_f64();
    let count = |is: &dyn Fn(&Row) -> bool| rows.iter().filter(|row| is(row)).count();
    let moves: Vec<usize> = (1..=3).map(|k| count(&|row| row.way.moves == k)).collect();
    println!(
        "{name}: {} bays, {:.0}°, aisle {:.1} m: {seconds:.2} s; in {moves:?} and {} more, {} out of reach; \
         out {} out of reach; budget ended {} + {}",
        drawn.scene.slots.len(),
        lot.angle.to_degrees(),
        lot.aisle,
        count(&|row| row.way.moves > 3),
        count(&|row| !row.way.reachable),
        count(&|row| row.out.as_ref().is_some_and(|out| !out.reachable)),
        count(&|row| row.way.outcome == "budget-spent"),
        count(&|row| row.out.as_ref().is_some_and(|out| out.outcome == "budget-spent")),
    );
    if std::env::var("VERBOSE").is_ok() {
        for row in &rows {
            println!("  {row:?}");
        }
    }
    Ok(())
}

/// Moves columns of lots of 60 bays, and asks the rows again that this can touch.
fn moves(from: u64, to: u64) -> Result<(), Error> {
    for seed in from..to {
        let fields = json!({ "seed": seed, "rows": 4, "bays": 15, "columns": 3 });
        let scene = Lot::from_json(&fields)?.draw()?.scene;
        let options = Options::of(&scene, &json!({ "whatIf": "each-free" }))?;
        let rows = in_threads(&scene, &json!({ "whatIf": "each-free" }), 1)?;
        let known: Vec<Known> = rows.iter().map(|row| Known::of(row, &options)).collect();
        let is_column = |one: &Obstacle| match one {
            Obstacle::Rectangle { id, .. } => id.as_ref().is_some_and(|id| id.starts_with("column")),
            _ => false,
        };
        let places = 0..scene.obstacles.len();
        let columns: Vec<usize> = places.filter(|&at| is_column(&scene.obstacles[at])).collect();
        let each = (columns.len() / 4).max(1);
        for (k, &at) in columns.iter().step_by(each).enumerate() {
            let mut after = scene.clone();
            if let Obstacle::Rectangle { center, .. } = &mut after.obstacles[at] {
                center[k % 2] += [1.0, -0.5][k / 2 % 2];
            }
            let touched = affected(&scene, &after, &options, &known)?;
            let before = processor_seconds();
            let mut auditor = Auditor::new(&after, &options)?;
            for (row, _) in rows.iter().zip(&touched).filter(|(_, is_touched)| **is_touched) {
                let part = Options { bays: vec![row.index], entries: vec![row.entry], ..options.clone() };
                auditor.rows(&part, &mut |_| ControlFlow::Continue(()))?;
            }
            let count = touched.iter().filter(|is_touched| **is_touched).count();
            println!(
                "seed {seed}, column {at}: {count} of {} rows, {:.2} processor seconds",
                rows.len(),
                processor_seconds() - before
            );
        }
    }
    Ok(())
}

/// What this thread has used of a processor; elsewhere than on Linux, 0.
fn processor_seconds() -> f64 {
    let text = std::fs::read_to_string("/proc/thread-self/schedstat").unwrap_or_default();
    text.split(' ').next().and_then(|n| n.parse().ok()).unwrap_or(0.0) * 1e-9
}

/// The rows of an audit, whose bays some threads share.
fn in_threads(scene: &Scenario, options: &Value, threads: usize) -> Result<Vec<Row>, Error> {
    let whole = Options::of(scene, options)?;
    let next = std::sync::atomic::AtomicUsize::new(0);
    let mut parts: Vec<Row> = std::thread::scope(|scope| {
        let work = || {
            let mut auditor = Auditor::new(scene, &whole)?;
            let mut rows = Vec::new();
            loop {
                let at = next.fetch_add(4, std::sync::atomic::Ordering::Relaxed);
                let bays: Vec<usize> = whole.bays.iter().copied().skip(at).take(4).collect();
                if bays.is_empty() {
                    return Ok(rows);
                }
                let part = Options { bays, ..whole.clone() };
                rows.extend(auditor.rows(&part, &mut |_| ControlFlow::Continue(()))?);
            }
        };
        let handles: Vec<_> = (0..threads).map(|_| scope.spawn(work)).collect();
        let parts: Result<Vec<Vec<Row>>, Error> =
            handles.into_iter().map(|one| one.join().expect("no panic")).collect();
        parts.map(|parts| parts.into_iter().flatten().collect())
    })?;
    parts.sort_by_key(|row| row.index);
    Ok(parts)
}

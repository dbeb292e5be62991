//! The road manuscript's tables beside plain A*, ours and its own method taken literally.

use std::fmt::Write as _;
use std::time::Instant;

use parkade::papers::road::{Line, Promise, ROWS, Table, measure};
use serde_json::{Value, json};

/// Rounds of which the fastest counts.
const ROUNDS: u32 = 5;

/// Milliseconds that everything may take in wasm.
const PROMISED: [(&str, f64); 4] = [("S1", 60.0), ("S2", 250.0), ("S3", 250.0), ("S4", 60.0)];

/// The same figures measured in wasm, and by how many bytes a module of its own grew for each scene.
struct Other {
    tables: Vec<Value>,
    grown: Vec<Option<f64>>,
}

impl Other {
    fn read(path: &str) -> Self {
        let text = std::fs::read_to_string(path).unwrap_or_else(|error| panic!("{path}: {error}"));
        let value: Value = serde_json::from_str(&text).unwrap_or_else(|error| panic!("{path}: {error}"));
        let list = |name: &str| value[name].as_array().cloned().unwrap_or_default();
        Self { tables: list("tables"), grown: list("grown").iter().map(Value::as_f64).collect() }
    }

    fn found(&self, table: usize, promise: usize) -> Option<f64> {
        self.tables.get(table)?["promises"][promise]["found"].as_f64()
    }

    fn milliseconds(&self, table: usize) -> Option<f64> {
        self.tables.get(table)?["lines"][1]["milliseconds"].as_f64()
    }
}

/// Prints everything; tells whether all is kept that does not depend on a clock, and is the same in wasm.
pub(crate) fn print(as_json: bool, wasm: Option<&str>) -> bool {
    let printed: Value = serde_json::from_str(include_str!("../../tests/data/paper-tables-road.json"))
        .expect("valid JSON in the repository");
    let start = Instant::now();
    let mut clock = || start.elapsed().as_secs_f64() * 1e3;
    let tables: Result<Vec<Table>, _> = ROWS.iter().map(|row| measure(row, ROUNDS, &mut clock)).collect();
    let tables = tables.expect("the rows of the manuscript can be measured");
    let wasm = wasm.map(Other::read);
    if as_json {
        let others = wasm.as_ref().map(|wasm| &wasm.tables);
        println!("{:#}", json!({ "tables": tables, "wasm": others, "flags": printed["flags"] }));
    } else {
        print!("{}", markdown(&tables, wasm.as_ref(), &printed["flags"]));
    }
    let same = |t: usize, p: usize, found: f64| {
        wasm.as_ref().is_none_or(|wasm| wasm.found(t, p).is_some_and(|other| is_same(other, found)))
    };
    tables.iter().enumerate().all(|(t, table)| {
        table.promises.iter().enumerate().all(|(p, promise)| promise.kept && same(t, p, promise.found))
    })
}

/// True if a number that was read is the one found here; the reader of JSON can miss by a unit in the last place.
fn is_same(read: f64, found: f64) -> bool {
    serde_json::from_str::<f64>(&json!(found).to_string())
        .is_ok_and(|found| found.to_bits() == read.to_bits())
}

fn markdown(tables: &[Table], wasm: Option<&Other>, flags: &Value) -> String {
    let mut text = String::from(
        "# Road navigation manuscript, section 4\n\nPercentages compare with plain A*, printed with printed and ours \
         with ours. Body clearances are mean, mean with each sample\ncapped at 1.2 m, and minimum, otherwise without \
         caps; side clearances, mean and minimum, are centre clearance minus half the width. Hits are of \
         1,000 simulated drives with random offsets, in\nbrackets for a \
         disc. Milliseconds cover everything, rasters and checks included, here and natively.\n",
    );
    for table in tables {
        text.push_str(&scene(table));
    }
    text.push_str(
        "\n## Promises\n\n| | figure | bound | natively | in wasm | plain A* | kept |\n| --- | --- | --- | \
        --- | --- | --- | --- |\n",
    );
    let shown = |value: Option<f64>| value.map_or_else(|| "–".to_owned(), |v| format!("{v:.2}"));
    for (t, table) in tables.iter().enumerate() {
        for (p, Promise { figure, at_least, bound, found, plain, kept }) in table.promises.iter().enumerate()
        {
            let sign = if *at_least { '≥' } else { '≤' };
            let other = wasm.map(|wasm| wasm.found(t, p));
            let same = other.is_none_or(|other| other.is_some_and(|other| is_same(other, *found)));
            let _ = writeln!(
                text,
                "| {} | {figure} | {sign} {bound:.2} | {found:.2} | {} | {plain:.2} | {} |",
                table.row.id,
                shown(other.flatten()),
                if !same {
                    "not the same"
                } else if *kept {
                    "yes"
                } else {
                    "no"
                }
            );
        }
    }
    if let Some(wasm) = wasm {
        text.push_str(&times(tables, wasm));
    }
    text.push_str("\n## ⚠ What the manuscript's numbers cannot be\n\n");
    for flag in flags.as_array().into_iter().flatten().filter_map(Value::as_str) {
        let _ = writeln!(text, "* {flag}");
    }
    text
}

fn times(tables: &[Table], wasm: &Other) -> String {
    let mut text = format!(
        "\n## Time and memory\n\nOf the whole plan with the inverse cost, the fastest of {ROUNDS}. Bytes are of \
         rasters, nodes and open list; the module is one of its\nown, all that it grew by.\n\n| | ms natively | ms in \
         wasm | promised | goal | kept | bytes a cell | module, bytes a cell |\n| --- | --- | --- | --- | --- | --- | \
         --- | --- |\n"
    );
    for (t, table) in tables.iter().enumerate() {
        let Some((id, promised)) = PROMISED.iter().find(|(id, _)| *id == table.row.id) else { continue };
        let (line, ms) = (&table.lines[1], wasm.milliseconds(t).unwrap_or(f64::NAN));
        let cells = f64::from(table.cells);
        let _ = writeln!(
            text,
            "| {id} | {:.1} | {ms:.1} | {promised} | {} | {} | {:.1} | {:.1} |",
            line.milliseconds,
            promised / 2.0,
            if ms <= promised / 2.0 {
                "goal"
            } else if ms <= *promised {
                "yes"
            } else {
                "no"
            },
            line.metrics.bytes as f64 / cells,
            wasm.grown.get(t).copied().flatten().unwrap_or(f64::NAN) / cells,
        );
    }
    text
}

fn scene(table: &Table) -> String {
    let row = &table.row;
    let mut text = format!(
        "\n## {}: `{}`{}\n\n| | length, m | turning points | body clearance, m | side clearance, m | curvature \
         variation, 1/m | hits | lane deviation, m | B/cell | ms | check |\n| --- | --- | --- | --- | --- | --- | --- \
         | --- | --- | --- | --- |\n",
        row.id,
        row.scene,
        if row.ship { ", ten times as large, with the ship" } else { "" }
    );
    let share = |now: f64, was: f64| {
        if was == 0.0 { String::new() } else { format!(" ({:+.1} %)", (now / was - 1.0) * 100.0) }
    };
    let p = &row.printed;
    for (k, name) in ["printed, plain", "printed, improved"].into_iter().enumerate() {
        let of = |values: [f64; 2]| {
            format!("{}{}", values[k], if k == 0 { String::new() } else { share(values[1], values[0]) })
        };
        let _ = writeln!(
            text,
            "| {name} | {} | {} | {} ⚠ | – | – | {} | – | {} MB | {} s | – |",
            of(p.length),
            of(p.turns),
            of(p.safety),
            of(p.collisions),
            of(p.memory),
            of(p.time),
        );
    }
    let plain = &table.lines[0];
    for (k, line) in table.lines.iter().enumerate() {
        let (m, f) = (&line.metrics, &line.metrics.figures);
        let of = |value: &dyn Fn(&Line) -> f64| {
            if k == 0 { String::new() } else { share(value(line), value(plain)) }
        };
        let _ = writeln!(
            text,
            "| {}{} | {:.1}{} | {}{} | {:.2} / {:.2} / {:.2} | {:.2} / {:.2} | {:.2}{} | {} ({}){} | {:.2} / {:.2} | \
             {:.1} | {:.1} | {} |",
            line.id,
            if line.fell_back { ", chords" } else { "" },
            f.middle_length,
            of(&|l| l.metrics.figures.middle_length),
            m.turns_pruned,
            of(&|l| f64::from(l.metrics.turns_pruned)),
            f.body_clearance_mean,
            f.body_clearance_mean_capped,
            f.body_clearance_min,
            f.side_clearance_mean,
            f.side_clearance_min,
            f.curvature_variation,
            of(&|l| l.metrics.figures.curvature_variation),
            line.risk.hits,
            line.risk.disc_hits,
            of(&|l| f64::from(l.risk.hits)),
            f.lane_deviation_mean.unwrap_or(0.0),
            f.lane_deviation_max.unwrap_or(0.0),
            m.bytes as f64 / f64::from(table.cells),
            line.milliseconds,
            line.verdict,
        );
    }
    text
}

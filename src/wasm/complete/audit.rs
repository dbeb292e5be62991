//! Audits of lots, for JS.
//!
//! An audit of a lot plans a way into each bay for each vehicle and may take minutes. Rows therefore leave one by
//! one: the callback is given each as soon as it is known and may end the audit; the rows so far are the answer then.
//!
//! After an edit only some rows can change. Rows cross the border as flat numbers, four for each row and three for
//! each swept pose, because thousands of objects would cost more than the test itself.

use std::cell::RefCell;
use std::ops::ControlFlow;

use js_sys::Array;
use serde_json::json;
use wasm_bindgen::prelude::*;

use crate::audit::{Auditor, Known, Options, Row, Way, affected};
use crate::error::{Error, ErrorCode};
use crate::geometry::Pose;
use crate::scenario::lot::{Lot, PRESETS, Preset};
use crate::vehicle::library;
use crate::wasm::codec::{f64s, object, set, write};
use crate::wasm::{JsResult, codec, goes_on, optional, read_scene};

/// A result for JavaScript: an error becomes a `ParkadeError`.
fn js<T>(result: Result<T, Error>) -> Result<T, JsValue> {
    result.map_err(|e| codec::js_error(&e))
}

/// The poses that the body passes, three numbers each.
/// One array for each way, as in a plan.
fn poses(way: &Way) -> JsValue {
    f64s(&way.swept.iter().flat_map(|p| [p.x, p.y, p.heading]).collect::<Vec<_>>())
}

/// Puts a way's fields into an object.
/// Columns and words are those of a row of the audit, as in `types/audit.d.ts`.
fn fill(target: &JsValue, way: &Way) {
    let text = |text: Option<&str>| text.map_or(JsValue::NULL, JsValue::from);
    let fields = [
        ("reachable", way.reachable.into()),
        ("outcome", way.outcome.into()),
        ("detail", text(way.detail)),
        ("reason", text(way.reason.as_deref())),
        (
            "place",
            way.place
                .map_or(JsValue::NULL, |[x, y]| [x, y].map(JsValue::from).iter().collect::<Array>().into()),
        ),
        ("blocker", text(way.blocker.as_deref())),
        ("moves", way.moves.into()),
        ("length", way.length.into()),
        ("driveTime", way.drive_time.map_or(JsValue::NULL, JsValue::from)),
        ("clearance", way.clearance.into()),
        ("hash", way.hash.as_str().into()),
        ("swept", poses(way)),
    ];
    for (name, value) in fields {
        set(target, name, &value);
    }
}

/// One row as an object; `out` is null where no way out was asked for.
fn row(row: &Row) -> JsValue {
    let answer = object(&[
        ("bay", row.bay.as_str().into()),
        ("index", (row.index as u32).into()),
        ("vehicle", row.vehicle.as_str().into()),
        ("entrance", row.entrance.as_str().into()),
        ("entry", row.entry_word().into()),
        ("overhang", row.overhang.into()),
    ]);
    fill(&answer, &row.way);
    let out = row.out.as_ref().map_or(JsValue::NULL, |out| {
        let target = object(&[]);
        fill(&target, out);
        target
    });
    set(&answer, "out", &out);
    answer
}

thread_local! {
    /// What the last audit prepared: workers are asked for one part of a lot after another.
    static LAST: RefCell<Option<Auditor>> = const { RefCell::new(None) };
}

/// The rows of an audit; `each` is given each row, and answers whether to go on.
#[wasm_bindgen(js_name = audit)]
#[expect(clippy::needless_pass_by_value, reason = "optional functions arrive as values of their own")]
pub fn js_audit(scene: JsValue, options: JsValue, each: Option<js_sys::Function>) -> JsResult {
    let scene = read_scene(scene)?;
    let fields = optional(options, ErrorCode::Input)?;
    let options = js(Options::of(&scene, &fields.into()))?;
    // Taken out, because `each` may ask for another audit.
    let last = LAST.take().filter(|last| last.serves(&scene, &options));
    let mut auditor = last.map_or_else(|| js(Auditor::new(&scene, &options)), Ok)?;
    let rows = Array::new();
    js(auditor.rows(&options, &mut |one| {
        let one = row(one);
        rows.push(&one);
        each.as_ref().map_or(ControlFlow::Continue(()), |each| goes_on(each, &one))
    }))?;
    LAST.set(Some(auditor));
    Ok(rows.into())
}

/// Which rows an edit can touch: 1 for those. Of each row its bay, its vehicle in the options, whether all its ways
/// were found, and how many numbers of `swept` are its own.
#[wasm_bindgen(js_name = affectedRows)]
pub fn affected_rows(
    before: JsValue,
    after: JsValue,
    options: JsValue,
    rows: &[u32],
    swept: &[f64],
) -> Result<Vec<u8>, JsValue> {
    let (before, after) = (read_scene(before)?, read_scene(after)?);
    let options = js(Options::of(&before, &optional(options, ErrorCode::Input)?.into()))?;
    let mut from = 0;
    let known = rows.chunks_exact(4).map(|row| {
        let own = &swept[from..from + row[3] as usize];
        from += own.len();
        Known {
            bay: row[0] as usize,
            vehicle: row[1] as usize,
            reachable: row[2] == 1,
            swept: own.chunks_exact(3).map(|p| Pose::new(p[0], p[1], p[2])).collect(),
        }
    });
    let known: Vec<Known> = known.collect();
    js(affected(&before, &after, &options, &known)).map(|all| all.into_iter().map(u8::from).collect())
}

/// Draws a parking lot.
#[wasm_bindgen(js_name = generateLot)]
pub fn generate_lot(fields: JsValue) -> JsResult {
    let drawn = codec::json(fields, ErrorCode::Input).and_then(|value| Lot::from_json(&value)?.draw());
    drawn
        .map(|drawn| write(&json!({ "scene": drawn.scene, "entrances": drawn.entrances })))
        .map_err(|e| codec::js_error(&e))
}

/// The lots that have a name.
#[wasm_bindgen(js_name = lotPresets)]
pub fn lot_presets() -> JsValue {
    let entry = |preset: &Preset| {
        let [en, zh] = preset.title;
        json!({ "id": preset.id, "title": { "en": en, "zh": zh }, "bays": preset.lot.rows * preset.lot.bays })
    };
    write(&PRESETS.iter().map(entry).collect::<Vec<_>>())
}

/// The library of vehicles.
#[wasm_bindgen]
pub fn vehicles() -> JsValue {
    let entry = |entry: &library::LibraryVehicle| {
        let mut value = json!(entry);
        value["vehicle"] = json!(entry.vehicle());
        value
    };
    write(&library::all().iter().map(entry).collect::<Vec<_>>())
}

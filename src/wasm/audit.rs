//! Audits of lots, for JS.

use std::ops::ControlFlow;

use js_sys::Array;
use serde_json::json;
use wasm_bindgen::prelude::*;

use super::codec::{f64s, object, set, write};
use super::{JsResult, codec, goes_on, optional, read_scene};
use crate::audit::{Options, Row, Way, audit};
use crate::error::{Error, ErrorCode};
use crate::vehicle::library;

fn js<T>(result: Result<T, Error>) -> Result<T, JsValue> {
    result.map_err(|e| codec::js_error(&e))
}

fn poses(way: &Way) -> JsValue {
    f64s(&way.swept.iter().flat_map(|p| [p.x, p.y, p.heading]).collect::<Vec<_>>())
}

/// Puts a way's fields into an object.
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

/// The rows of an audit; `each` is given each row, and answers whether to go on.
#[wasm_bindgen(js_name = audit)]
pub fn js_audit(scene: JsValue, options: JsValue, each: Option<js_sys::Function>) -> JsResult {
    let scene = read_scene(scene)?;
    let fields = optional(options, ErrorCode::Input)?;
    let options = js(Options::of(&scene, &fields.into()))?;
    let rows = Array::new();
    js(audit(&scene, &options, &mut |one| {
        let one = row(one);
        rows.push(&one);
        each.as_ref().map_or(ControlFlow::Continue(()), |each| goes_on(each, &one))
    }))?;
    Ok(rows.into())
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

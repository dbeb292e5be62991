//! Exports of the complete module that `core` lacks: maps of other programs, generated scenes, bare searches, edits,
//! the papers' tables.
//!
//! These exports serve the papers' pages, the importer and the editor. `core` lacks them, so the first picture loads
//! without their code.
//!
//! Arguments and answers are flat where they are many: files are a list of names and one of bytes, figures of tables
//! are arrays of numbers whose columns the first answer names. Measurements are given a clock by the page, as the
//! module itself has none.

mod audit;
mod drive;
mod referee;

use std::cell::Cell;
use std::ops::ControlFlow;

use serde_json::{Value, json};
use wasm_bindgen::prelude::*;

use super::{JsResult, RawPlanner, answer, codec, goes_on, optional, read_scene};
use crate::error::{Error, ErrorCode};
use crate::geometry::{Point, Pose, reeds_shepp};
use crate::import::{self, Question};
use crate::metrics::random_drives;
use crate::papers::{claims, grid, incomplete, parking, road, verdicts, volumes};
use crate::plan;
use crate::scenario::{Obstacle, Scenario, generate, run_length};

/// Runs of one obstacle beyond which they cross the border run-length encoded.
const MANY: usize = 200;

/// Reads the files of another program; their bytes in the order of their names.
#[wasm_bindgen(js_name = importScene)]
#[expect(clippy::needless_pass_by_value, reason = "arrays of values arrive owned")]
pub fn import_scene(names: Vec<String>, bytes: Vec<js_sys::Uint8Array>, options: JsValue) -> JsResult {
    let fields = optional(options, ErrorCode::Input)?;
    let options = import::Options::from_json(&fields).map_err(|e| codec::js_error(&e))?;
    let bytes: Vec<Vec<u8>> = bytes.iter().map(js_sys::Uint8Array::to_vec).collect();
    let files: Vec<import::File> =
        names.iter().zip(&bytes).map(|(name, bytes)| import::File { name, bytes }).collect();
    let imported = import::import(&files, &options).map_err(|e| codec::js_error(&e))?;
    drop(bytes);
    let scenes: Vec<Value> = imported.scenes.into_iter().map(scene).collect();
    Ok(codec::write(&json!({
        "format": imported.format,
        "scenes": scenes,
        "queries": imported.queries.iter().map(question).collect::<Vec<_>>(),
        "notes": imported.notes,
    })))
}

/// Draws a scene of a seeded family.
#[wasm_bindgen(js_name = generateScenario)]
pub fn generate_scenario(fields: JsValue) -> JsResult {
    let drawn = codec::json(fields, ErrorCode::Input).and_then(|value| generate::from_json(&value));
    drawn.map(|drawn| codec::write(&scene(drawn))).map_err(|e| codec::js_error(&e))
}

#[wasm_bindgen]
impl RawPlanner {
    /// Explains the risk field at the cell of a point.
    pub fn explain(&self, x: f64, y: f64) -> JsResult {
        self.planner.explain(x, y).map(|answer| codec::write(&answer)).map_err(|e| codec::js_error(&e))
    }

    /// The search alone: the outcome's number, cost in micro-cells, expanded, generated, and x, y of each cell. One
    /// array, because every property of an object costs more than a short search.
    pub fn search(&mut self, x0: f64, y0: f64, x1: f64, y1: f64) -> Result<Vec<f64>, JsValue> {
        let found =
            self.planner.search(Point::new(x0, y0), Point::new(x1, y1)).map_err(|e| codec::js_error(&e))?;
        let mut numbers = vec![0.0; 4 + 2 * found.path.len()];
        numbers[..4].copy_from_slice(&[
            f64::from(found.outcome as u8),
            found.cost_micro as f64,
            f64::from(found.expanded),
            f64::from(found.generated),
        ]);
        for (place, point) in numbers[4..].chunks_exact_mut(2).zip(&found.path) {
            place.copy_from_slice(&[point.x, point.y]);
        }
        Ok(numbers)
    }

    /// As `plan`; `improved` is given the first plan and each better one, and answers whether to go on; `expanded` is
    /// given expansions while a search runs. No callback may throw.
    #[wasm_bindgen(js_name = watched)]
    pub fn watched(
        &mut self,
        options: JsValue,
        tell: Option<js_sys::Function>,
        improved: Option<js_sys::Function>,
        expanded: Option<js_sys::Function>,
    ) -> JsResult {
        let (mut options, ends) = self.options(options)?;
        let mut told = move |expanded: u32| {
            tell.as_ref().map_or(ControlFlow::Continue(()), |tell| goes_on(tell, &expanded.into()))
        };
        options.progress = Some(&mut told);
        let (scene, geometry) = (self.planner.scenario().clone(), self.planner.geometry().clone());
        let mut better = improved.map(|improved| {
            move |plan: &plan::Plan| goes_on(&improved, &answer::plan(&scene, &geometry, plan))
        });
        options.improved = better.as_mut().map(|better| better as plan::Improved);
        let searches = Cell::new(0_u32);
        let tell_expanded = expanded.map(|expanded| {
            move |some: plan::Expansions<'_>| {
                searches.set(searches.get() + u32::from(some.is_first));
                // It cannot end the search; `tell` does.
                let _ = expanded.call1(&JsValue::NULL, &expansions(searches.get() - 1, some));
            }
        });
        options.trace |= tell_expanded.is_some();
        options.expansions = tell_expanded.as_ref().map(|tell| tell as plan::ExpansionCallback);
        let plan = self.planner.plan_between(ends, options).map_err(|e| codec::js_error(&e))?;
        Ok(answer::plan(self.planner.scenario(), self.planner.geometry(), &plan))
    }

    /// Takes over the last path of another planner.
    #[wasm_bindgen(js_name = continueFrom)]
    pub fn continue_from(&mut self, before: &mut Self) {
        self.planner.continue_from(&mut before.planner);
    }

    /// Takes over the path of a plan.
    #[wasm_bindgen(js_name = continueAlong)]
    pub fn continue_along(
        &mut self,
        path: &[f64],
        directions: &[i8],
        curvatures: &[f64],
    ) -> Result<(), JsValue> {
        self.planner.continue_along(path, directions, curvatures).map_err(|e| codec::js_error(&e))
    }

    /// The any-angle yardstick, metres.
    #[wasm_bindgen(js_name = anyAngleLength)]
    pub fn any_angle_length(&self) -> Option<f64> {
        self.planner.any_angle_length()
    }

    /// Blocks runs of cells or frees them: column, row, count, ….
    pub fn brush(&mut self, runs: &[u32], blocked: bool) -> Result<(), JsValue> {
        let runs: Vec<[u32; 3]> = runs.chunks_exact(3).map(|r| [r[0], r[1], r[2]]).collect();
        self.planner.brush(&runs, blocked).map_err(|e| codec::js_error(&e))
    }
}

/// All Reeds–Shepp words between two poses (x, y, heading), the shortest first.
#[wasm_bindgen(js_name = reedsShepp)]
pub fn reeds_shepp(from: &[f64], to: &[f64], radius: f64) -> JsValue {
    let [from, to] = [from, to].map(|p| Pose::new(p[0], p[1], p[2]));
    let mut words = reeds_shepp::list_below(from, to, radius, f64::INFINITY);
    words.sort_by(|a, b| a.length(radius).total_cmp(&b.length(radius)));
    let words: Vec<Value> = words.iter().map(|word| curve(word, from, radius)).collect();
    codec::write(&words)
}

/// A word as letters, length, gear changes, and its arcs from `from` on, five numbers each.
fn curve(word: &reeds_shepp::Word, from: Pose, radius: f64) -> Value {
    let mut pose = from;
    let mut arcs = Vec::new();
    for arc in word.arcs(radius) {
        arcs.push([pose.x, pose.y, pose.heading, arc.curvature, arc.length]);
        pose = pose.advance(arc.curvature, arc.length);
    }
    json!({
        "word": word.letters(),
        "length": word.length(radius),
        "directionChanges": word.direction_changes(),
        "arcs": arcs,
    })
}

/// Figures of a path on a scene's road.
#[wasm_bindgen(js_name = roadFigures)]
pub fn road_figures(scene: JsValue, path: &[f64]) -> JsResult {
    let scene = read_scene(scene)?;
    let figures = plan::road_figures(&scene, path).map_err(|e| codec::js_error(&e.within("plan")))?;
    Ok(codec::write(&figures))
}

/// How often a path ends in a collision when nobody drives exactly along it.
#[wasm_bindgen(js_name = collisionRisk)]
pub fn collision_risk(scene: JsValue, path: &[f64], options: JsValue) -> JsResult {
    let scene = read_scene(scene)?;
    let fields = optional(options, ErrorCode::Input)?;
    let options = random_drives::Options::from_json(&fields).map_err(|e| codec::js_error(&e))?;
    let risk =
        plan::collision_risk(&scene, path, &options).map_err(|e| codec::js_error(&e.within("plan")))?;
    Ok(codec::write(&risk))
}

/// The band that the car stays in during those drives.
#[wasm_bindgen(js_name = driveEnvelope)]
pub fn drive_envelope(scene: JsValue, path: &[f64], options: JsValue) -> JsResult {
    let scene = read_scene(scene)?;
    let fields = optional(options, ErrorCode::Input)?;
    let options = random_drives::Options::from_json(&fields).map_err(|e| codec::js_error(&e))?;
    let band =
        plan::drive_envelope(&scene, path, &options).map_err(|e| codec::js_error(&e.within("plan")))?;
    Ok(codec::f64s(&band))
}

/// The rows of the risk-field paper's tables, and what is measured of them.
#[wasm_bindgen(js_name = paperGridRows)]
pub fn paper_grid_rows() -> JsValue {
    let straight = |row: &grid::Row| {
        let mut value = json!(row);
        value["straight"] = row.straight().into();
        value
    };
    let rows: Vec<Value> = grid::ROWS.iter().map(straight).collect();
    codec::write(&json!({ "rows": rows, "planners": grid::PLANNERS, "columns": grid::COLUMNS }))
}

/// The figures of one row on the maps of some seeds; `clock` tells milliseconds.
#[wasm_bindgen(js_name = paperGrid)]
pub fn paper_grid(row: &str, from: f64, to: f64, clock: &js_sys::Function) -> JsResult {
    let figures = whole("from", from).and_then(|from| {
        let to = whole("to", to)?;
        grid::measure(grid::row(row)?, from, to, &mut clock_of(clock))
    });
    figures.map(|figures| codec::f64s(&figures)).map_err(|e| codec::js_error(&e))
}

/// The rows of the parking paper's tables.
#[wasm_bindgen(js_name = paperParkingRows)]
pub fn paper_parking_rows() -> JsValue {
    codec::write(&parking::ROWS)
}

/// A row of the parking paper, planned; `clock` tells milliseconds.
#[wasm_bindgen(js_name = paperParking)]
pub fn paper_parking(row: &str, rounds: f64, clock: &js_sys::Function) -> JsResult {
    let rounds = whole("rounds", rounds).map_err(|e| codec::js_error(&e))?;
    let table = parking::measure(row, u32::try_from(rounds).unwrap_or(u32::MAX), &mut clock_of(clock));
    table.map(|table| codec::write(&table)).map_err(|e| codec::js_error(&e))
}

/// A whole number that JavaScript has as a float; larger ones than 9·10¹⁵ are not exact there.
fn whole(name: &str, value: f64) -> Result<u64, Error> {
    let whole = value.fract() == 0.0 && (0.0..9e15).contains(&value);
    let rule =
        || Error::new(ErrorCode::Input, name, message!("must be a whole number from 0, got {}", value));
    whole.then_some(value as u64).ok_or_else(rule)
}

/// Tables and claims from the figures of rows, in the order of the rows' ids.
#[wasm_bindgen(js_name = paperGridSummary)]
#[expect(clippy::needless_pass_by_value, reason = "arrays of values arrive owned")]
pub fn paper_grid_summary(rows: Vec<String>, figures: Vec<js_sys::Float64Array>) -> JsResult {
    let table = |(row, figures): (&String, &js_sys::Float64Array)| {
        grid::summary(grid::row(row)?, &figures.to_vec()).map_err(|e| e.within(row))
    };
    let tables: Result<Vec<_>, Error> = rows.iter().zip(&figures).map(table).collect();
    let tables = tables.map_err(|e| codec::js_error(&e))?;
    Ok(codec::write(&json!({ "tables": tables, "claims": claims(&tables) })))
}

/// The rows of the road manuscript's tables.
#[wasm_bindgen(js_name = paperRoadRows)]
pub fn paper_road_rows() -> JsValue {
    codec::write(&json!(road::ROWS))
}

/// Measures one of them; `clock` returns milliseconds.
#[wasm_bindgen(js_name = paperRoad)]
pub fn paper_road(row: &str, rounds: f64, clock: &js_sys::Function) -> JsResult {
    let mut clock = clock_of(clock);
    // Numbers that are no whole ones from 1 are refused like 0.
    let rounds = if rounds.fract() == 0.0 { rounds as u32 } else { 0 };
    let table = road::row(row).and_then(|row| road::measure(row, rounds, &mut clock));
    table.map(|table| codec::write(&table)).map_err(|e| codec::js_error(&e))
}

/// The parking paper's and the road manuscript's claims, from tables as [`paper_parking`] and [`paper_road`] give them.
#[wasm_bindgen(js_name = paperVerdicts)]
pub fn paper_verdicts(parking: JsValue, road: JsValue) -> JsResult {
    let tables = |value, name: &str| match codec::json(value, ErrorCode::Input)? {
        Value::Array(tables) => Ok(tables),
        _ => Err(Error::new(ErrorCode::Input, name, "must be an array")),
    };
    let judged = tables(parking, "parking").and_then(|parking| {
        let road = tables(road, "road")?;
        let named = |name: &'static str| move |e: Error| e.within(name);
        let saved = verdicts::saved(&parking).map_err(named("parking"))?;
        let all = verdicts::parking_claims(&parking).map_err(named("parking"))?;
        let roads = verdicts::road_claims(&road).map_err(named("road"))?;
        Ok(json!({ "parking": all, "road": roads, "saved": saved }))
    });
    judged.map(|judged| codec::write(&judged)).map_err(|e| codec::js_error(&e))
}

/// Seeds of a row's maps on which the literal risk field is incomplete.
#[wasm_bindgen(js_name = paperIncomplete)]
pub fn paper_incomplete(row: &str, from: f64, to: f64) -> JsResult {
    let seeds =
        whole("from", from).and_then(|from| incomplete::incomplete(grid::row(row)?, from, whole("to", to)?));
    seeds.map(|seeds| codec::write(&seeds)).map_err(|e| codec::js_error(&e))
}

/// Volumes around the car on poses of a seed; `clock` tells milliseconds.
#[wasm_bindgen(js_name = paperVolumes)]
pub fn paper_volumes(scene: &str, poses: f64, seed: f64, rounds: f64, clock: &js_sys::Function) -> JsResult {
    let count = |name, value| whole(name, value).map(|n| u32::try_from(n).unwrap_or(u32::MAX));
    let compared = count("poses", poses).and_then(|poses| {
        let (seed, rounds) = (whole("seed", seed)?, count("rounds", rounds)?);
        volumes::compare(scene, poses, seed, rounds, &mut clock_of(clock))
    });
    compared.map(|compared| codec::write(&compared)).map_err(|e| codec::js_error(&e))
}

/// A clock of JavaScript's as a function. Only what is measured for tables depends on it; no search does.
fn clock_of(clock: &js_sys::Function) -> impl FnMut() -> f64 {
    || clock.call0(&JsValue::NULL).ok().and_then(|v| v.as_f64()).unwrap_or(0.0)
}

/// A question of an imported map as an object.
fn question(question: &Question) -> Value {
    let Question { bucket, start, goal, length } = question;
    json!({ "bucket": bucket, "start": start, "goal": goal, "length": length })
}

/// A scene as JSON, long lists of cells run-length encoded: `api.js` unpacks them faster than the border passes their
/// numbers.
/// Short lists stay as they are, so that scenes of a few obstacles can be read by people.
fn scene(mut scene: Scenario) -> Value {
    let long: Vec<Option<String>> = scene
        .obstacles
        .iter_mut()
        .map(|obstacle| match obstacle {
            Obstacle::Cells { runs, .. } if runs.len() > MANY => {
                Some(run_length::pack(&std::mem::take(runs)))
            }
            _ => None,
        })
        .collect();
    let mut value = json!(scene);
    for (i, text) in long.into_iter().enumerate().filter_map(|(i, text)| text.map(|text| (i, text))) {
        value["obstacles"][i]["runs"] = text.into();
    }
    value
}

/// Some of a search's expansions; a grid's are nodes.
fn expansions(search: u32, some: plan::Expansions<'_>) -> JsValue {
    let [kind, events] = if some.numbers.is_empty() {
        ["cells".into(), codec::u32s(some.nodes)]
    } else {
        ["arcs".into(), codec::f64s(some.numbers)]
    };
    let name = kind.clone();
    let fields = codec::object(&[("kind", kind), ("search", search.into())]);
    let _ = js_sys::Reflect::set(&fields, &name, &events);
    fields
}

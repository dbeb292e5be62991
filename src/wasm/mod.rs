//! The JS border: exported functions and the planner session. Types are in `packages/parkade/types`.
//!
//! A function here does three things and no more: it reads its arguments, calls the crate, and writes the answer.
//! Errors leave as thrown `ParkadeError`s with a code and the path of the field; a panic is a bug and ends the
//! module. An exception that a callback throws is caught here and means "stop"; the package's JavaScript keeps it and
//! throws it again.
//!
//! The module keeps no state between calls but in [`RawPlanner`]: settings are checked and the map is prepared once,
//! and each plan reuses its memory.
#![expect(unreachable_pub, reason = "wasm-bindgen exports only items marked pub")]

mod answer;
mod codec;
// Exports keep alive what they lead to, so the small module must not have them.
#[cfg(feature = "complete")]
mod complete;

use std::ops::ControlFlow;

use serde_json::{Value, json as object};
use wasm_bindgen::prelude::*;

use crate::IS_COMPLETE;
use crate::error::{Error, ErrorCode, Message};
use crate::json;
use crate::json::Words;
use crate::plan::{self, Planner};
use crate::planners::registry;
use crate::scenario::{Scenario, catalog, parse, places};

/// An answer, or the error that JavaScript is thrown.
type JsResult = Result<JsValue, JsValue>;

#[wasm_bindgen(start)]
fn start() {
    console_error_panic_hook::set_once();
}

/// The crate's version.
#[wasm_bindgen]
pub fn version() -> String {
    env!("CARGO_PKG_VERSION").to_owned()
}

/// All planners with their parameters.
#[wasm_bindgen]
pub fn planners() -> JsValue {
    codec::write(&registry::planners())
}

/// A planner's settings.
#[wasm_bindgen(js_name = defaultConfig)]
pub fn default_config(planner: &str) -> JsResult {
    let config = registry::default_config(planner).map_err(|e| codec::js_error(&e))?;
    Ok(codec::write(&config))
}

/// All built-in scenes.
#[wasm_bindgen]
pub fn scenarios() -> JsValue {
    let both = |[en, zh]: [&str; 2]| object!({ "en": en, "zh": zh });
    let entry = |s: &catalog::Info| {
        object!({
            "id": s.id, "group": s.group, "title": both(s.title), "question": both(s.question),
        })
    };
    codec::write(&catalog::scenes().map(entry).collect::<Vec<_>>())
}

/// A built-in scene.
#[wasm_bindgen]
pub fn scenario(id: &str) -> JsResult {
    let scene = catalog::scenario(id).map_err(|e| codec::js_error(&e))?;
    Ok(codec::write(&scene))
}

/// A scene resolved to geometry.
#[wasm_bindgen(js_name = sceneGeometry)]
pub fn scene_geometry(scene: JsValue) -> JsResult {
    let scene = read_scene(scene)?;
    let geometry = scene.geometry().map_err(|e| codec::js_error(&e))?;
    Ok(codec::write(&answer::geometry(&scene, &geometry)))
}

/// Re-checks a path against a scene.
#[wasm_bindgen(js_name = checkPath)]
#[expect(clippy::needless_pass_by_value, reason = "an optional array arrives as a vector of its own")]
pub fn check_path(scene: JsValue, path: &[f64], directions: Option<Vec<i8>>) -> JsResult {
    let scene = read_scene(scene)?;
    let geometry = scene.geometry().map_err(|e| codec::js_error(&e))?;
    let check = plan::check_path(&geometry, path, directions.as_deref()).map_err(|e| codec::js_error(&e))?;
    let answer = answer::check(&scene, &geometry, &check);
    if IS_COMPLETE {
        codec::set(&answer, "clearances", &codec::f64s(&check.clearances));
    }
    Ok(answer)
}

/// A scene from JavaScript, read and validated; every function that takes a scene begins with it.
fn read_scene(scene: JsValue) -> Result<Scenario, JsValue> {
    codec::json(scene, ErrorCode::Scenario)
        .and_then(|v| Scenario::from_json(&v))
        .map_err(|e| codec::js_error(&e))
}

/// An object that may be left out.
/// `undefined` and `null` are an empty object.
fn optional(value: JsValue, code: ErrorCode) -> Result<serde_json::Map<String, Value>, JsValue> {
    if value.is_undefined() || value.is_null() {
        return Ok(serde_json::Map::new());
    }
    match codec::json(value, code).map_err(|e| codec::js_error(&e))? {
        Value::Object(fields) => Ok(fields),
        other => Err(codec::js_error(&Error::new(code, "", message!("must be an object, got {}", other)))),
    }
}

/// An error about an option.
fn refused(path: &str, message: impl Into<Message>) -> JsValue {
    codec::js_error(&Error::new(ErrorCode::Input, path, message))
}

/// A planner on one scene: settings checked once, map prepared once.
#[wasm_bindgen]
pub struct RawPlanner {
    planner: Planner,
}

#[wasm_bindgen]
impl RawPlanner {
    /// Checks scene and settings and prepares the map.
    #[wasm_bindgen(constructor)]
    pub fn new(id: &str, scene: JsValue, config: JsValue) -> Result<RawPlanner, JsValue> {
        let scene = read_scene(scene)?;
        let config = optional(config, ErrorCode::Config)?;
        let planner = Planner::owning(id, scene, &config).map_err(|e| codec::js_error(&e))?;
        Ok(Self { planner })
    }

    /// Plans. `tell` is told of the expansions so far, and answers whether to go on; it must not throw.
    pub fn plan(&mut self, options: JsValue, tell: Option<js_sys::Function>) -> JsResult {
        let (mut options, ends) = self.options(options)?;
        let mut told = tell.map(|tell| move |expanded: u32| goes_on(&tell, &expanded.into()));
        options.progress = told.as_mut().map(|told| told as plan::ProgressCallback);
        let plan = self.planner.plan_between(ends, options).map_err(|e| codec::js_error(&e))?;
        Ok(answer::plan(self.planner.scenario(), self.planner.geometry(), &plan))
    }

    /// A raster for drawing.
    pub fn layer(&mut self, name: &str, options: JsValue) -> JsResult {
        let mut every = 1;
        for (option, value) in optional(options, ErrorCode::Input)? {
            if option != "every" {
                return Err(refused(&option, "no option of layer; there is every"));
            }
            let rule = || refused(&option, message!("must be a whole number from 1, got {}", value));
            every = value.as_u64().and_then(|n| u32::try_from(n).ok()).filter(|&n| n > 0).ok_or_else(rule)?;
        }
        self.planner
            .layer(name, every)
            .map(|layer| answer::layer(&layer, every))
            .map_err(|e| codec::js_error(&e))
    }
}

/// Interprets a callback's return value.
/// An exception counts as "stop", as does every value that is not truthy.
fn goes_on(callback: &js_sys::Function, value: &JsValue) -> ControlFlow<()> {
    match callback.call1(&JsValue::NULL, value) {
        Ok(goes_on) if goes_on.is_truthy() => ControlFlow::Continue(()),
        _ => ControlFlow::Break(()),
    }
}

impl RawPlanner {
    /// The options of a plan, but for callbacks, and its ends.
    ///
    /// # Errors
    /// An option that is not known or has another type, by name.
    fn options<'o>(&self, options: JsValue) -> Result<(plan::Options<'o>, plan::Ends), JsValue> {
        let (mut asked, mut ends) = (plan::Options::default(), plan::Ends::default());
        let mut is_full = false;
        for (name, value) in optional(options, ErrorCode::Input)? {
            let wrong = |e: Error| codec::js_error(&e.within(&name).with_code(ErrorCode::Input));
            match name.as_str() {
                "trace" if IS_COMPLETE && value == "full" => {
                    (asked.trace, asked.record) = (true, Some(asked.record.unwrap_or(plan::RECORDED_STEPS)));
                    is_full = true;
                }
                "traceLimit" if IS_COMPLETE => {
                    let limit = value.as_u64().filter(|limit| (1..=1_000_000).contains(limit));
                    let rule = || {
                        refused(&name, message!("must be a whole number from 1 to 1000000, got {}", value))
                    };
                    asked.record = Some(limit.ok_or_else(rule)? as usize);
                }
                "trace" => asked.trace = json::flag(&value).map_err(wrong)?,
                "alternatives" if IS_COMPLETE => asked.alternatives = json::flag(&value).map_err(wrong)?,
                "stickiness" if IS_COMPLETE => {
                    let share = json::number(&value).ok().filter(|share| (0.0..=1.0).contains(share));
                    let rule = || refused(&name, message!("must be between 0 and 1, got {}", value));
                    asked.stickiness = share.ok_or_else(rule)?;
                }
                "prefer" if IS_COMPLETE && value.is_null() => {}
                "prefer" if IS_COMPLETE => {
                    asked.prefer = Some(json::word(plan::Prefer::WORDS)(&value).map_err(wrong)?);
                }
                "start" | "goal" => {
                    let pose = if IS_COMPLETE {
                        parse::goal(&value).and_then(|goal| self.planner.scenario().goal_pose(&goal))
                    } else {
                        places::pose(&value)
                    };
                    *(if name == "start" { &mut ends.start } else { &mut ends.goal }) =
                        Some(pose.map_err(wrong)?);
                }
                _ => {
                    let message = if IS_COMPLETE {
                        "no option of plan; there are trace, traceLimit, start, goal, onProgress, prefer, \
                         alternatives, onImproved, onExpanded, stickiness"
                    } else {
                        "no option of plan; there are trace, start, goal, onProgress"
                    };
                    return Err(refused(&name, message));
                }
            }
        }
        if !is_full {
            asked.record = None;
        }
        Ok((asked, ends))
    }
}

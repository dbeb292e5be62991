//! Verdicts on trajectories, for JS.
//!
//! Trajectories of other programs come as text or as columns and are judged by the same rules as this crate's own:
//! replayed, checked for collisions and measured. How they were made is not asked.
//!
//! Text is CSV with a head; columns are what a program has in memory already. Options are limits of the motion:
//! speeds in m/s, accelerations in m/s², angles and rates in radians.

use wasm_bindgen::prelude::*;

use crate::error::{Error, ErrorCode};
use crate::plan;
use crate::referee::{MotionLimits, Submission, TimedRows, judge, read};
use crate::wasm::{JsResult, codec, optional, read_scene};

/// A result for JavaScript: an error becomes a `ParkadeError`.
fn js<T>(result: Result<T, Error>) -> Result<T, JsValue> {
    result.map_err(|e| codec::js_error(&e))
}

/// Judges a submission on a scene; options replace the limits of motion.
fn judged(scene: JsValue, submission: &Submission, options: JsValue) -> JsResult {
    let scene = read_scene(scene)?;
    let geometry = js(scene.geometry())?;
    let limits = js(MotionLimits::default().with(&optional(options, ErrorCode::Config)?))?;
    let found = js(judge(&geometry, submission, &limits))?;
    Ok(codec::write(&found.to_json(&scene)))
}

/// Judges a trajectory or a path that is CSV.
#[wasm_bindgen(js_name = judgeText)]
pub fn judge_text(scene: JsValue, text: &str, options: JsValue) -> JsResult {
    judged(scene, &js(read(text))?, options)
}

/// Judges columns: a trajectory where there are times, else a path.
#[wasm_bindgen(js_name = judgeColumns)]
pub fn judge_columns(
    scene: JsValue,
    path: &[f64],
    t: Option<Vec<f64>>,
    speed: Option<Vec<f64>>,
    steering: Option<Vec<f64>>,
    gears: Option<Vec<i8>>,
    options: JsValue,
) -> JsResult {
    let poses = js(plan::path_poses(path).map_err(|e| e.within("trajectory")))?;
    let submission = match t {
        Some(t) => Submission::Timed(TimedRows { t, poses, speed, steering }),
        None => Submission::Path { poses, gears },
    };
    judged(scene, &submission, options)
}

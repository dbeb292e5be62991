//! Verdicts on trajectories, for JS.

use serde_json::{Value, json};
use wasm_bindgen::prelude::*;

use super::{JsResult, answer, codec, optional, read_scene};
use crate::error::{Error, ErrorCode};
use crate::plan;
use crate::referee::{Judgement, MotionLimits, Submission, TimedRows, judge, read};
use crate::scenario::Scenario;

fn js<T>(result: Result<T, Error>) -> Result<T, JsValue> {
    result.map_err(|e| codec::js_error(&e))
}

/// A verdict as plain data.
pub(super) fn judgement(scene: &Scenario, found: &Judgement) -> Value {
    let (figures, contacts) = (&found.figures, &found.contacts);
    let first = contacts.first.map(|(t, owner, pose)| {
        let mut hit = answer::hit(scene, owner, pose);
        hit["t"] = t.into();
        hit
    });
    json!({
        "passes": found.passes(),
        "attained": found.attained,
        "keepsLimits": found.keeps_limits,
        "frames": contacts.frames,
        "touchingFrames": contacts.touching_frames,
        "uncertified": contacts.uncertified,
        "firstContact": first,
        "minClearance": contacts.min_clearance,
        "duration": figures.duration,
        "length": figures.length,
        "effort": figures.effort,
        "steeringEffort": figures.steering,
        "gearChanges": figures.gear_changes,
        "smoothness": figures.smoothness(),
        "tpcapCost": figures.tpcap_cost(),
        "maxSpeed": figures.max_speed,
        "maxAcceleration": figures.max_acceleration,
        "maxDeceleration": figures.max_deceleration,
        "maxSteering": figures.max_steering,
        "maxSteeringRate": figures.max_steering_rate,
        "maxLateralAcceleration": figures.max_lateral_acceleration,
        "startError": { "distance": found.start_error.0, "heading": found.start_error.1 },
        "endError": { "x": found.end_error.0, "y": found.end_error.1, "heading": found.end_error.2 },
        "endSpeed": found.end_speed,
        "modelError": { "distance": found.model_error.0, "heading": found.model_error.1 },
    })
}

fn judged(scene: JsValue, submission: &Submission, options: JsValue) -> JsResult {
    let scene = read_scene(scene)?;
    let geometry = js(scene.geometry())?;
    let limits = js(MotionLimits::default().with(&optional(options, ErrorCode::Config)?))?;
    let found = js(judge(&geometry, submission, &limits))?;
    Ok(codec::write(&judgement(&scene, &found)))
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

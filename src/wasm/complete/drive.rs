//! Driving in time, for JS: trajectories, following, waiting.
//!
//! All functions take a scene, a path as flat poses, and options; those that drive along a path read them in one
//! place (`Question`). A path without gears is driven forwards, and one without curvatures gets those of its poses.
//! Times are seconds, speeds metres per second and signed, steering angles radians, and the columns of an answer have
//! one entry for each time.

use serde_json::json;
use wasm_bindgen::prelude::*;

use crate::drive::{
    Controller, Encounter, Limits, Mover, Route, Rows, Tracking, WaitOptions, stop_wait_go, track, trajectory,
};
use crate::error::{Error, ErrorCode};
use crate::geometry::Pose;
use crate::json;
use crate::metrics::Body;
use crate::optimise;
use crate::plan;
use crate::referee::{States, Submission, TimedRows};
use crate::scenario::Scenario;
use crate::scenario::resolve::Geometry;
use crate::wasm::codec::{f64s, object, write};
use crate::wasm::{JsResult, answer, codec, optional, read_scene};

/// What every function here is asked: a path on a scene and the options of a drive.
struct Question {
    /// The scene, for the names of what is touched.
    scene: Scenario,
    /// The same in metres.
    geometry: Geometry,
    /// The path as arcs with gears and the speed limits along it.
    route: Route,
    /// What is left of the options for the function itself.
    options: serde_json::Map<String, serde_json::Value>,
}

/// A result for JavaScript: an error becomes a `ParkadeError`.
fn js<T>(result: Result<T, Error>) -> Result<T, JsValue> {
    result.map_err(|e| codec::js_error(&e))
}

impl Question {
    /// Reads and checks scene, path and options; an error of the path is told as one of the field `plan`.
    fn read(
        scene: JsValue,
        path: &[f64],
        directions: Option<&[i8]>,
        curvatures: Option<&[f64]>,
        options: JsValue,
    ) -> Result<Self, JsValue> {
        let scene = read_scene(scene)?;
        let geometry = js(scene.geometry())?;
        let route = js(plan::route(&geometry, path, directions, curvatures).map_err(|e| e.within("plan")))?;
        let route = route.with_speed_limits(&scene.all_speed_limits());
        Ok(Self { scene, geometry, route, options: optional(options, ErrorCode::Config)? })
    }
}

/// Three numbers for each pose.
fn poses(poses: &[Pose]) -> JsValue {
    f64s(&poses.iter().flat_map(|p| [p.x, p.y, p.heading]).collect::<Vec<_>>())
}

/// The columns of a drive, and more fields.
/// All columns have one entry for each time; the hash is that of the rows, the same in Rust and in JavaScript.
fn drive(rows: &Rows, more: &[(&str, JsValue)]) -> JsValue {
    let columns = [
        ("t", f64s(&rows.t)),
        ("path", poses(&rows.poses)),
        ("stations", f64s(&rows.station)),
        ("speeds", f64s(&rows.speed)),
        ("accelerations", f64s(&rows.acceleration)),
        ("steering", f64s(&rows.steering)),
        ("hash", rows.hash().into()),
    ];
    object(&columns.iter().chain(more).cloned().collect::<Vec<_>>())
}

/// A path in time.
#[wasm_bindgen(js_name = trajectory)]
#[expect(clippy::needless_pass_by_value, reason = "optional arrays arrive as vectors of their own")]
pub fn js_trajectory(
    scene: JsValue,
    path: &[f64],
    directions: Option<Vec<i8>>,
    curvatures: Option<Vec<f64>>,
    options: JsValue,
) -> JsResult {
    let asked = Question::read(scene, path, directions.as_deref(), curvatures.as_deref(), options)?;
    let limits = js(Limits::default().with(&asked.options))?;
    let driven = js(trajectory(&asked.geometry.vehicle, &asked.route, &limits))?;
    Ok(drive(
        &driven.rows,
        &[
            ("duration", driven.duration.into()),
            ("length", driven.length.into()),
            ("dwell", driven.dwell.into()),
            ("maxLateralAcceleration", driven.max_lateral_acceleration.into()),
        ],
    ))
}

/// A path as a trajectory that a car can follow to the centimetre.
#[wasm_bindgen(js_name = optimise)]
#[expect(clippy::needless_pass_by_value, reason = "optional arrays arrive as vectors of their own")]
pub fn js_optimise(
    scene: JsValue,
    path: &[f64],
    directions: Option<Vec<i8>>,
    curvatures: Option<Vec<f64>>,
    options: JsValue,
) -> JsResult {
    let scene = read_scene(scene)?;
    let options = js(optimise::Options::default().with(&optional(options, ErrorCode::Config)?))?;
    let columns = (path, directions.as_deref(), curvatures.as_deref());
    let made = js(plan::optimise(&scene, columns, &options))?;
    let states = &made.states;
    let (accelerations, rates) = states.controls();
    Ok(object(&[
        ("t", f64s(&states.t)),
        ("path", poses(&states.poses)),
        ("stations", f64s(&states.stations())),
        ("speeds", f64s(&states.speed)),
        ("accelerations", f64s(&accelerations)),
        ("steering", f64s(&states.steering)),
        ("steeringRates", f64s(&rates)),
        ("duration", states.duration().into()),
        ("length", made.check.figures.length.into()),
        ("dwell", states.dwell().into()),
        ("maxLateralAcceleration", made.check.figures.max_lateral_acceleration.into()),
        ("stage", made.stage.as_str().into()),
        ("check", write(&made.check.to_json(&scene))),
        ("hash", states.hash().into()),
    ]))
}

/// The states of a trajectory's columns.
///
/// # Errors
/// Columns of different lengths, times that do not grow, or numbers that are no poses.
fn states(path: &[f64], t: Vec<f64>, speed: Vec<f64>, steering: Vec<f64>) -> Result<States, Error> {
    let poses = plan::path_poses(path)?;
    let rows = TimedRows { t, poses, speed: Some(speed), steering: Some(steering) };
    Submission::Timed(rows.clone()).validate()?;
    let TimedRows { t, poses, speed, steering } = rows;
    Ok(States { t, poses, speed: speed.unwrap_or_default(), steering: steering.unwrap_or_default() })
}

/// How closely a simulated car follows a trajectory, at its own speeds.
#[wasm_bindgen(js_name = trackStates)]
pub fn js_track_states(
    scene: JsValue,
    path: &[f64],
    t: Vec<f64>,
    speed: Vec<f64>,
    steering: Vec<f64>,
) -> JsResult {
    let scene = read_scene(scene)?;
    let geometry = js(scene.geometry())?;
    let states = js(states(path, t, speed, steering).map_err(|e| e.within("plan")))?;
    let got = crate::referee::track(&geometry.vehicle, &Body::new(&geometry), &states);
    Ok(tracking(&scene, &got))
}

/// How closely a simulated car follows a path.
#[wasm_bindgen(js_name = track)]
#[expect(clippy::needless_pass_by_value, reason = "optional arrays arrive as vectors of their own")]
pub fn js_track(
    scene: JsValue,
    path: &[f64],
    directions: Option<Vec<i8>>,
    curvatures: Option<Vec<f64>>,
    options: JsValue,
) -> JsResult {
    let mut asked = Question::read(scene, path, directions.as_deref(), curvatures.as_deref(), options)?;
    let mut controller = Controller::default();
    if let Some(value) = asked.options.remove("controller") {
        let fields = [("controller".to_owned(), value)].into_iter().collect();
        js(json::overlay(&mut [("controller", &mut controller)], &fields))?;
    }
    let limits = js(Limits::default().with(&asked.options))?;
    let body = Body::new(&asked.geometry);
    let got = js(track(&asked.geometry.vehicle, &body, &asked.route, &limits, controller))?;
    Ok(tracking(&asked.scene, &got))
}

/// Deviations of a simulated car from its path, metres and radians, and the obstacle that it touches, if any.
fn tracking(scene: &Scenario, got: &Tracking) -> JsValue {
    let hit = got.hit.map(|(owner, pose)| answer::hit(scene, owner, pose));
    object(&[
        ("t", f64s(&got.t)),
        ("path", poses(&got.poses)),
        ("lateral", f64s(&got.lateral)),
        ("steering", f64s(&got.steering)),
        ("maxLateral", got.max_lateral.into()),
        ("maxHeading", got.max_heading.into()),
        ("endDistance", got.end_distance.into()),
        ("endHeading", got.end_heading.into()),
        ("hit", write(&hit)),
        ("passes", got.passes().into()),
        ("hash", got.hash().into()),
    ])
}

/// A drive among the scene's moving obstacles.
#[wasm_bindgen(js_name = stopWaitGo)]
#[expect(clippy::needless_pass_by_value, reason = "optional arrays arrive as vectors of their own")]
pub fn js_stop_wait_go(
    scene: JsValue,
    path: &[f64],
    directions: Option<Vec<i8>>,
    curvatures: Option<Vec<f64>>,
    options: JsValue,
) -> JsResult {
    let asked = Question::read(scene, path, directions.as_deref(), curvatures.as_deref(), options)?;
    let options = js(WaitOptions::default().with(&asked.options))?;
    let movers = movers(&asked.scene);
    let met = js(stop_wait_go(&asked.geometry.vehicle, &asked.route, &movers, &options))?;
    Ok(encounter(&asked.scene, &movers, &met))
}

/// A trajectory among the scene's moving obstacles.
#[wasm_bindgen(js_name = stopWaitGoStates)]
pub fn js_stop_wait_go_states(
    scene: JsValue,
    path: &[f64],
    t: Vec<f64>,
    speed: Vec<f64>,
    steering: Vec<f64>,
    options: JsValue,
) -> JsResult {
    let scene = read_scene(scene)?;
    let geometry = js(scene.geometry())?;
    let states = js(states(path, t, speed, steering).map_err(|e| e.within("plan")))?;
    let options = js(WaitOptions::default().with(&optional(options, ErrorCode::Config)?))?;
    let movers = movers(&scene);
    let met = js(optimise::stop_wait_go(&geometry.vehicle, &states, &movers, &options))?;
    Ok(encounter(&scene, &movers, &met))
}

/// The scene's moving boxes as functions of time.
fn movers(scene: &Scenario) -> Vec<Mover> {
    scene.moving.iter().map(Mover::new).collect()
}

/// A drive among moving boxes. `boxes` has the pose of every box at every time, time by time.
fn encounter(scene: &Scenario, movers: &[Mover], met: &Encounter) -> JsValue {
    let boxes: Vec<Pose> = met.rows.t.iter().flat_map(|&t| movers.iter().map(move |m| m.pose(t))).collect();
    let waits: Vec<_> = met
        .waits
        .iter()
        .map(|w| json!({ "pose": w.pose, "station": w.station, "from": w.from, "to": w.to }))
        .collect();
    let contact = met.contact.map(|c| {
        let id = scene.moving[c.obstacle].id.as_deref().unwrap_or("moving");
        json!({ "obstacle": id, "index": c.obstacle, "t": c.t, "pose": c.pose, "standing": c.standing })
    });
    drive(
        &met.rows,
        &[
            ("ending", met.ending.as_str().into()),
            ("clearances", f64s(&met.clearances)),
            ("timesToCollision", f64s(&met.times_to_collision)),
            ("boxes", poses(&boxes)),
            ("waits", write(&waits)),
            ("contact", write(&contact)),
            ("duration", met.duration.into()),
            ("freeDuration", met.free_duration.into()),
        ],
    )
}

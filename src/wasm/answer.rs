//! Plans, checks and layers as JS objects with typed arrays.
//!
//! Everything that has many numbers becomes one typed array per column; everything small becomes plain objects by way
//! of JSON. A property of a JavaScript object costs more than a short search, so poses are x, y, heading in a row and
//! not objects.
//!
//! Frames and units are those of the crate: world metres, radians, micro-cells where grid costs are meant. Obstacles
//! are told by name for people and by index in the scene's list for programs: −1 is the border or a parked car of a
//! slot, −2 in arrays that nothing is hit.
//!
//! `core` and the complete module share this file. Parts that only the complete one knows, as the chosen goal,
//! alternatives or a recorded search, are added to the same object, so that programs can move from one to the other.

use serde_json::{Value, json};
use wasm_bindgen::JsValue;

use super::codec::{f32s, f64s, i8s, i32s, object, set, u8s, u32s, write};
use crate::IS_COMPLETE;
use crate::geometry::{Point, Pose};
use crate::metrics::Check;
use crate::metrics::Narrowest;
use crate::plan::Recorded;
use crate::plan::{Layer, LayerData, Plan, PlanTrace, Stats};
use crate::planners::hybrid::PoseRecording;
use crate::planners::{Gap, Obstruction};
use crate::scenario::Scenario;
use crate::scenario::resolve::{Geometry, Owner, PARKED};
use crate::search::Recording;
use crate::vehicle::Vehicle;

/// A plan as `types/plan.d.ts` describes it; optional parts are set only where the plan has them.
pub(super) fn plan(scene: &Scenario, geometry: &Geometry, plan: &Plan) -> JsValue {
    let poses: Vec<f64> = plan.path.iter().flat_map(|p| [p.x, p.y, p.heading]).collect();
    let raw: Vec<f64> = plan.raw_path.iter().flat_map(|p| [p.x, p.y]).collect();
    let answer = object(&[
        ("planner", plan.planner.into()),
        ("outcome", plan.outcome.as_str().into()),
        ("detail", plan.detail.map_or(JsValue::NULL, |detail| detail.as_str().into())),
        ("reason", plan.reason.as_deref().map_or(JsValue::NULL, JsValue::from)),
        ("path", f64s(&poses)),
        ("directions", i8s(&plan.directions)),
        ("curvatures", f64s(&plan.curvatures)),
        ("clearances", f64s(&plan.check.clearances)),
        ("rawPath", f64s(&raw)),
        ("stats", stats(&plan.stats)),
        ("metrics", write(&plan.metrics)),
        ("check", check(scene, geometry, &plan.check)),
        ("obstruction", write(&plan.obstruction.as_ref().map(|o| obstruction(scene, geometry, o)))),
        ("trace", trace_of(geometry, plan)),
        ("hash", plan.hash().into()),
    ]);
    if IS_COMPLETE && let Some(member) = &plan.member {
        set(&answer, "member", &write(member));
    }
    if IS_COMPLETE && let Some(stages) = &plan.stages {
        set(&answer, "stages", &write(stages));
    }
    if IS_COMPLETE && let Some(goal) = &plan.goal {
        set(&answer, "goal", &write(goal));
    }
    if IS_COMPLETE && !plan.alternatives.is_empty() {
        let all: js_sys::Array =
            plan.alternatives.iter().map(|one| self::plan(scene, geometry, one)).collect();
        set(&answer, "alternatives", &all);
    }
    answer
}

/// Counters, with the bytes as a JavaScript number.
fn stats(stats: &Stats) -> JsValue {
    let answer = write(stats);
    set(&answer, "memoryBytes", &(stats.memory_bytes as f64).into());
    answer
}

/// Where a plan fails, by kind; places and poses are in world coordinates.
fn obstruction(scene: &Scenario, geometry: &Geometry, obstruction: &Obstruction) -> Value {
    let end = |at_start| if at_start { "start" } else { "goal" };
    let named = |(pose, owner)| hit(scene, geometry.owner(owner), pose);
    match obstruction {
        Obstruction::Contact { at_start, owner } => {
            let pose = if *at_start { geometry.start } else { geometry.goal };
            json!({ "kind": "contact", "end": end(*at_start), "hit": named((pose, *owner)) })
        }
        Obstruction::Gap(Gap { width, at }) => {
            let needed = geometry.vehicle.width;
            json!({ "kind": "gap", "x": at.x, "y": at.y, "width": width, "needed": needed })
        }
        Obstruction::Enclosed { at_start, region } => {
            let runs: Vec<_> = region.runs.iter().map(|&(at, n)| (at.x, at.y, n)).collect();
            json!({ "kind": "enclosed", "end": end(*at_start), "cell": region.cell, "runs": runs })
        }
        Obstruction::BoxedIn { at_start, stops } => {
            let stops: Vec<_> = stops.iter().map(|&stop| named(stop)).collect();
            json!({ "kind": "boxed-in", "end": end(*at_start), "stops": stops })
        }
        Obstruction::Nearest { at, heading } => {
            json!({ "kind": "nearest", "x": at.x, "y": at.y, "heading": heading })
        }
    }
}

/// Of a plan: the recorded search, or what else is kept of it.
/// Null where neither was asked for.
fn trace_of(geometry: &Geometry, plan: &Plan) -> JsValue {
    if IS_COMPLETE && let Some(search) = &plan.recorded {
        return recorded(geometry, plan, search);
    }
    plan.trace.as_ref().map_or(JsValue::NULL, |t| trace(geometry, t))
}

/// A trace as columns: cells of a grid, or arcs with the connections that failed.
fn trace(geometry: &Geometry, trace: &PlanTrace) -> JsValue {
    match trace {
        PlanTrace::Cells { cells, dropped } => {
            object(&[("kind", "cells".into()), ("cells", u32s(cells)), ("dropped", (*dropped as f64).into())])
        }
        PlanTrace::Arcs { arcs, dropped, failed_expansions: failed } => object(&[
            ("kind", "arcs".into()),
            ("arcs", f64s(arcs)),
            ("dropped", (*dropped as f64).into()),
            (
                "failedExpansions",
                object(&[
                    ("first", u32s(&failed.first)),
                    ("arcs", f64s(&failed.arcs)),
                    ("hits", f64s(&failed.hits)),
                    (
                        "obstacles",
                        i32s(&failed.owners.iter().map(|&o| geometry.owner(o).index()).collect::<Vec<_>>()),
                    ),
                    ("expansions", u32s(&failed.expansions)),
                    ("dropped", (failed.dropped as f64).into()),
                ]),
            ),
        ]),
    }
}

/// A recorded search with what its moves mean: the grid's size, or poses, arcs and obstacles.
fn recorded(geometry: &Geometry, plan: &Plan, recorded: &Recorded) -> JsValue {
    match recorded {
        Recorded::Cells { width, height, recording } => {
            let answer = events("search", recording);
            set(&answer, "width", &(*width).into());
            set(&answer, "height", &(*height).into());
            answer
        }
        Recorded::Poses(poses) => {
            let answer = events("poses", &poses.recording);
            let owner = |&owner: &u32| {
                if owner == PoseRecording::NOBODY { NO_OWNER } else { geometry.owner(owner).index() }
            };
            set(&answer, "roots", &write(&poses.roots));
            set(&answer, "fromGoal", &poses.from_goal.into());
            set(&answer, "poses", &f64s(&poses.poses));
            set(&answer, "arcs", &f64s(&poses.arcs));
            set(&answer, "obstacles", &i32s(&poses.owners.iter().map(owner).collect::<Vec<_>>()));
            set(&answer, "tree", &plan.trace.as_ref().map_or(JsValue::NULL, |t| trace(geometry, t)));
            answer
        }
    }
}

/// The events' columns as typed arrays, copied once.
fn events(kind: &str, r: &Recording) -> JsValue {
    object(&[
        ("kind", kind.into()),
        ("kinds", u8s(&r.kinds)),
        ("nodes", u32s(&r.nodes)),
        ("g", f64s(&r.g)),
        ("h", f64s(&r.h)),
        ("f", f64s(&r.f)),
        ("first", u32s(&r.first)),
        ("targets", u32s(&r.targets)),
        ("targetG", f64s(&r.target_g)),
        ("targetH", f64s(&r.target_h)),
        ("fates", u8s(&r.fates)),
        ("oldestFirst", r.oldest_first.into()),
        ("unit", r.unit.into()),
        ("penalty", r.penalty.into()),
        ("cut", r.is_cut.into()),
        (
            "counters",
            object(&[
                ("expanded", r.stats.expanded.into()),
                ("generated", r.stats.generated.into()),
                ("pushes", r.stats.pushes.into()),
                ("openPeak", r.stats.open_peak.into()),
            ]),
        ),
    ])
}

/// The verdict of a path. Numbers that JSON cannot express, as the radius of a straight path, become null.
pub(super) fn check(scene: &Scenario, geometry: &Geometry, check: &Check) -> JsValue {
    let small = json!({
        "verdict": check.verdict.as_str(),
        "drivable": check.drivable(),
        "hits": check.hit_poses.len(),
        "firstHit": check.first_hit.map(|(owner, pose)| hit(scene, owner, pose)),
        "tightTurns": check.tight_turns,
        "slips": check.slips,
        "tightestRadius": check.tightest_radius.is_finite().then_some(check.tightest_radius),
        "minTurningRadius": geometry.vehicle.min_turning_radius(),
        "startHeadingError": check.start_heading_error,
        "goalHeadingError": check.goal_heading_error,
        "goalDistance": check.goal_distance,
    });
    let answer = write(&small);
    set(&answer, "hitPoses", &u32s(&check.hit_poses));
    if IS_COMPLETE && let Some(Narrowest { index, body, obstacle, owner }) = check.narrowest {
        let (name, at) = (scene.name_of(owner), owner.index());
        let [body, point] = [body, obstacle].map(|p| [p.x, p.y]);
        let place = json!({ "pose": index, "body": body, "point": point, "obstacle": name, "index": at });
        set(&answer, "narrowest", &write(&place));
    }
    answer
}

/// An obstacle by name and index, and the pose at which the body meets it.
pub(super) fn hit(scene: &Scenario, owner: Owner, pose: Pose) -> Value {
    json!({ "obstacle": scene.name_of(owner), "index": owner.index(), "pose": pose })
}

/// Among indices of obstacles: nothing is hit.
/// −1 is taken: it stands for the border and for parked cars of slots.
const NO_OWNER: i32 = -2;

/// A raster row by row from the south; each of its cells stands for `every` × `every` cells of the map.
pub(super) fn layer(layer: &Layer, every: u32) -> JsValue {
    let data = match &layer.data {
        LayerData::Bytes(bytes) => u8s(bytes),
        LayerData::Floats(floats) => f32s(floats),
    };
    object(&[
        ("width", layer.width.into()),
        ("height", layer.height.into()),
        ("every", every.into()),
        ("data", data),
    ])
}

/// Dimensions and the turning radius that follows from them.
fn vehicle(vehicle: &Vehicle) -> Value {
    let mut value = json!(vehicle);
    value["minTurningRadius"] = json!(vehicle.min_turning_radius());
    value
}

/// A scene's outlines, poses and slots, for drawing.
pub(super) fn geometry(scene: &Scenario, geometry: &Geometry) -> Value {
    let points = |list: &[Point]| list.iter().map(|p| [p.x, p.y]).collect::<Vec<_>>();
    let parked =
        |&(slot, pose): &(usize, Pose)| json!({ "slot": slot, "pose": pose, "vehicle": vehicle(&PARKED) });
    let mut answer = json!({
        "start": geometry.start,
        "goal": geometry.goal,
        "vehicle": vehicle(&geometry.vehicle),
        "boundary": points(&geometry.boundary),
        "slots": scene.slots.iter().map(|s| points(&s.outline())).collect::<Vec<_>>(),
        "parkedCars": geometry.parked.iter().map(parked).collect::<Vec<_>>(),
    });
    if IS_COMPLETE && let Some(goals) = &geometry.goals {
        answer["goals"] = json!(goals.poses);
    }
    answer
}

//! Plans, checks and layers as JS objects with typed arrays.

use serde_json::{Value, json};
use wasm_bindgen::JsValue;

use super::codec::{f32s, f64s, i8s, object, set, u8s, u32s, write};
use crate::geometry::{Point, Pose};
use crate::metrics::Check;
use crate::plan::{Layer, LayerData, Plan, PlanTrace};
use crate::scenario::Scenario;
use crate::scenario::resolve::{Geometry, Owner, PARKED};
use crate::vehicle::Vehicle;

pub(super) fn plan(scene: &Scenario, geometry: &Geometry, plan: &Plan) -> JsValue {
    let poses: Vec<f64> = plan.path.iter().flat_map(|p| [p.x, p.y, p.heading]).collect();
    let raw: Vec<f64> = plan.raw_path.iter().flat_map(|p| [p.x, p.y]).collect();
    object(&[
        ("planner", plan.planner.into()),
        ("outcome", plan.outcome.as_str().into()),
        ("detail", plan.detail.map_or(JsValue::NULL, JsValue::from)),
        ("reason", plan.reason.as_deref().map_or(JsValue::NULL, JsValue::from)),
        ("path", f64s(&poses)),
        ("directions", i8s(&plan.directions)),
        ("curvatures", f64s(&plan.curvatures)),
        ("clearances", f64s(&plan.check.clearances)),
        ("rawPath", f64s(&raw)),
        ("stats", write(&plan.stats)),
        ("metrics", write(&plan.metrics)),
        ("check", check(scene, geometry, &plan.check)),
        ("trace", plan.trace.as_ref().map_or(JsValue::NULL, trace)),
        ("hash", plan.hash().into()),
    ])
}

fn trace(trace: &PlanTrace) -> JsValue {
    match trace {
        PlanTrace::Cells { cells, dropped } => {
            object(&[("kind", "cells".into()), ("cells", u32s(cells)), ("dropped", (*dropped as f64).into())])
        }
        PlanTrace::Arcs { arcs, dropped } => {
            object(&[("kind", "arcs".into()), ("arcs", f32s(arcs)), ("dropped", (*dropped as f64).into())])
        }
    }
}

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
    answer
}

pub(super) fn hit(scene: &Scenario, owner: Owner, pose: Pose) -> Value {
    let index = match owner {
        Owner::Obstacle(i) => i as i64,
        Owner::Border | Owner::Slot(_) => -1,
    };
    json!({ "obstacle": scene.name_of(owner), "index": index, "pose": pose })
}

pub(super) fn layer(layer: &Layer) -> JsValue {
    let data = match &layer.data {
        LayerData::Bytes(bytes) => u8s(bytes),
        LayerData::Floats(floats) => f32s(floats),
    };
    object(&[("width", layer.width.into()), ("height", layer.height.into()), ("data", data)])
}

fn vehicle(vehicle: &Vehicle) -> Value {
    let mut value = json!(vehicle);
    value["minTurningRadius"] = json!(vehicle.min_turning_radius());
    value
}

pub(super) fn geometry(scene: &Scenario, geometry: &Geometry) -> Value {
    let points = |list: &[Point]| list.iter().map(|p| [p.x, p.y]).collect::<Vec<_>>();
    let parked =
        |&(slot, pose): &(usize, Pose)| json!({ "slot": slot, "pose": pose, "vehicle": vehicle(&PARKED) });
    json!({
        "start": geometry.start,
        "goal": geometry.goal,
        "vehicle": vehicle(&geometry.vehicle),
        "boundary": points(&geometry.boundary),
        "slots": scene.slots.iter().map(|s| points(&s.outline())).collect::<Vec<_>>(),
        "parkedCars": geometry.parked.iter().map(parked).collect::<Vec<_>>(),
    })
}

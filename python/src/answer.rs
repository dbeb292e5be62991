//! Plans and checks as dictionaries of arrays and plain values.

use numpy::PyArray1;
use parkade::metrics::Check;
use parkade::plan::{Detail, Plan, PlanTrace};
use parkade::scenario::Scenario;
use parkade::scenario::resolve::Geometry;
use pyo3::prelude::*;
use pyo3::types::{PyDict, PyList};
use serde_json::{Value, json};

use crate::value::{poses, rows, write};

/// The fields of `parkade.Plan`.
pub(crate) fn plan<'py>(
    py: Python<'py>,
    scene: &Scenario,
    geometry: &Geometry,
    plan: &Plan,
) -> PyResult<Bound<'py, PyDict>> {
    let fields = PyDict::new(py);
    let data = |value: Value| write(py, &value);
    fields.set_item("planner", plan.planner)?;
    fields.set_item("outcome", plan.outcome.as_str())?;
    fields.set_item("detail", plan.detail.map(Detail::as_str))?;
    fields.set_item("reason", plan.reason.as_deref())?;
    fields.set_item("path", poses(py, &plan.path)?)?;
    fields.set_item("directions", PyArray1::from_slice(py, &plan.directions))?;
    fields.set_item("curvatures", PyArray1::from_slice(py, &plan.curvatures))?;
    fields.set_item("clearances", PyArray1::from_slice(py, &plan.check.clearances))?;
    fields.set_item("raw_path", rows(py, plan.raw_path.iter().flat_map(|p| [p.x, p.y]).collect(), 2)?)?;
    let mut stats = json!(plan.stats);
    stats["memoryBytes"] = plan.stats.memory_bytes.into();
    fields.set_item("stats", data(stats)?)?;
    fields.set_item("metrics", data(json!(plan.metrics))?)?;
    fields.set_item("check", check(py, scene, geometry, &plan.check)?)?;
    fields.set_item("goal", data(json!(plan.goal))?)?;
    fields.set_item("member", data(json!(plan.member))?)?;
    fields.set_item("trace", plan.trace.as_ref().map(|one| trace(py, one)).transpose()?)?;
    let alternatives: Vec<_> =
        plan.alternatives.iter().map(|one| self::plan(py, scene, geometry, one)).collect::<PyResult<_>>()?;
    fields.set_item("alternatives", PyList::new(py, alternatives)?)?;
    fields.set_item("hash", plan.hash())?;
    Ok(fields)
}

/// A verdict, with the names that the JavaScript API has.
pub(crate) fn check<'py>(
    py: Python<'py>,
    scene: &Scenario,
    geometry: &Geometry,
    check: &Check,
) -> PyResult<Bound<'py, PyAny>> {
    let hit =
        |(owner, pose)| json!({ "obstacle": scene.name_of(owner), "index": owner.index(), "pose": pose });
    let mut fields = json!({
        "verdict": check.verdict.as_str(),
        "drivable": check.drivable(),
        "hits": check.hit_poses.len(),
        "hitPoses": check.hit_poses,
        "firstHit": check.first_hit.map(hit),
        "tightTurns": check.tight_turns,
        "slips": check.slips,
        "tightestRadius": check.tightest_radius.is_finite().then_some(check.tightest_radius),
        "minTurningRadius": geometry.vehicle.min_turning_radius(),
        "startHeadingError": check.start_heading_error,
        "goalHeadingError": check.goal_heading_error,
        "goalDistance": check.goal_distance,
    });
    if let Some(place) = check.narrowest {
        fields["narrowest"] = json!({
            "pose": place.index,
            "body": [place.body.x, place.body.y],
            "point": [place.obstacle.x, place.obstacle.y],
            "obstacle": scene.name_of(place.owner),
            "index": place.owner.index(),
        });
    }
    write(py, &fields)
}

fn trace<'py>(py: Python<'py>, trace: &PlanTrace) -> PyResult<Bound<'py, PyDict>> {
    let fields = PyDict::new(py);
    let dropped = match trace {
        PlanTrace::Cells { cells, dropped } => {
            fields.set_item("kind", "cells")?;
            fields.set_item("cells", PyArray1::from_slice(py, cells))?;
            dropped
        }
        PlanTrace::Arcs { arcs, dropped, .. } => {
            fields.set_item("kind", "arcs")?;
            fields.set_item("arcs", rows(py, arcs.clone(), 5)?)?;
            dropped
        }
    };
    fields.set_item("dropped", *dropped)?;
    Ok(fields)
}

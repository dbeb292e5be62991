//! Functions over scenes, and the lists of planners and built-in scenes.

use std::path::Path;

use numpy::PyArray1;
use parkade::error::{Error, ErrorCode};
use parkade::import::{self, File};
use parkade::plan;
use parkade::planners::registry;
use parkade::scenario::{Scenario, catalog, generate};
use pyo3::prelude::*;
use pyo3::types::PyDict;
use serde_json::{Value, json};

use crate::answer;
use crate::planner::scene as read_scene;
use crate::value::{gears, numbers, optional, read, refused, write};

/// The version of the package and of the crate, which are published together.
pub(crate) const VERSION: &str = env!("CARGO_PKG_VERSION");

pub(crate) fn register(module: &Bound<'_, PyModule>) -> PyResult<()> {
    module.add_function(wrap_pyfunction!(planners, module)?)?;
    module.add_function(wrap_pyfunction!(default_config, module)?)?;
    module.add_function(wrap_pyfunction!(scenarios, module)?)?;
    module.add_function(wrap_pyfunction!(scenario, module)?)?;
    module.add_function(wrap_pyfunction!(generate_scenario, module)?)?;
    module.add_function(wrap_pyfunction!(normalise, module)?)?;
    module.add_function(wrap_pyfunction!(import_scene, module)?)?;
    module.add_function(wrap_pyfunction!(check_path, module)?)
}

/// All planners with their settings.
#[pyfunction]
fn planners(py: Python<'_>) -> PyResult<Bound<'_, PyAny>> {
    write(py, &json!(registry::planners()))
}

/// A planner's settings.
#[pyfunction]
fn default_config<'py>(py: Python<'py>, planner: &str) -> PyResult<Bound<'py, PyAny>> {
    let config = registry::default_config(planner).map_err(|e| refused(py, &e))?;
    write(py, &Value::Object(config))
}

/// All built-in scenes.
#[pyfunction]
fn scenarios(py: Python<'_>) -> PyResult<Bound<'_, PyAny>> {
    let both = |[en, zh]: [&str; 2]| json!({ "en": en, "zh": zh });
    let entry = |s: &catalog::Info| -> Value {
        json!({ "id": s.id, "group": s.group, "title": both(s.title), "question": both(s.question) })
    };
    write(py, &Value::Array(catalog::scenes().map(entry).collect()))
}

fn written(py: Python<'_>, scene: Result<Scenario, Error>) -> PyResult<Bound<'_, PyAny>> {
    write(py, &json!(scene.map_err(|e| refused(py, &e))?))
}

/// A built-in scene.
#[pyfunction]
fn scenario<'py>(py: Python<'py>, id: &str) -> PyResult<Bound<'py, PyAny>> {
    written(py, catalog::scenario(id))
}

/// A scene of a seeded family.
#[pyfunction]
fn generate_scenario<'py>(py: Python<'py>, fields: &Bound<'py, PyDict>) -> PyResult<Bound<'py, PyAny>> {
    written(py, read(fields, ErrorCode::Input).and_then(|value| generate::from_json(&value)))
}

/// A scene as JSON text in one form, whatever form it came in.
#[pyfunction]
fn normalise(py: Python<'_>, scene: &Bound<'_, PyAny>) -> PyResult<String> {
    read_scene(py, scene).map(|scene| json!(scene).to_string())
}

/// Scenes from the files of another program.
#[pyfunction]
fn import_scene<'py>(
    py: Python<'py>,
    files: Vec<(String, Vec<u8>)>,
    options: Option<&Bound<'py, PyAny>>,
) -> PyResult<Bound<'py, PyAny>> {
    let made = optional(options, ErrorCode::Input, "options").and_then(|fields| {
        let options = import::Options::from_json(&fields)?;
        let base = |name: &str| {
            Path::new(name).file_name().map_or(name.to_owned(), |n| n.to_string_lossy().into_owned())
        };
        let names: Vec<String> = files.iter().map(|(name, _)| base(name)).collect();
        let files: Vec<File<'_>> =
            names.iter().zip(&files).map(|(name, (_, bytes))| File { name, bytes }).collect();
        py.detach(|| import::import(&files, &options))
    });
    let made = made.map_err(|e| refused(py, &e))?;
    let query = |q: &import::Question| -> Value {
        json!({ "bucket": q.bucket, "start": q.start, "goal": q.goal, "length": q.length })
    };
    let queries: Vec<Value> = made.queries.iter().map(query).collect();
    write(
        py,
        &json!({ "format": made.format, "scenes": made.scenes, "queries": queries, "notes": made.notes }),
    )
}

/// What the independent checker says of a path.
#[pyfunction]
fn check_path<'py>(
    py: Python<'py>,
    scene: &Bound<'py, PyAny>,
    path: &Bound<'py, PyAny>,
    directions: Option<&Bound<'py, PyAny>>,
) -> PyResult<Bound<'py, PyAny>> {
    let scene = read_scene(py, scene)?;
    let made = numbers(path, "path").and_then(|path| {
        let gears = directions.filter(|d| !d.is_none()).map(|d| gears(d, "directions")).transpose()?;
        let geometry = scene.geometry()?;
        let check = py.detach(|| plan::check_path(&geometry, &path, gears.as_deref()))?;
        Ok((geometry, check))
    });
    let (geometry, check) = made.map_err(|e| refused(py, &e))?;
    let answer = answer::check(py, &scene, &geometry, &check)?;
    answer.set_item("clearances", PyArray1::from_slice(py, &check.clearances))?;
    Ok(answer)
}

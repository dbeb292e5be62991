//! Trajectories: the optimiser's, and the referee's verdict on any.

use numpy::PyArray1;
use parkade::error::{Error, ErrorCode};
use parkade::optimise::{Optimised, Options};
use parkade::plan;
use parkade::referee::{MotionLimits, Submission, TimedRows, judge as verdict, read as read_csv};
use parkade::scenario::Scenario;
use pyo3::prelude::*;
use pyo3::types::PyDict;

use crate::planner::scene as read_scene;
use crate::value::{gears, numbers, optional, poses, refused, write};

pub(crate) fn register(module: &Bound<'_, PyModule>) -> PyResult<()> {
    module.add_function(wrap_pyfunction!(optimise, module)?)?;
    module.add_function(wrap_pyfunction!(judge, module)?)
}

/// Some of a dictionary's columns.
struct Columns<'a, 'py>(&'a Bound<'py, PyDict>, &'static str);

impl<'py> Columns<'_, 'py> {
    /// A column by `read`, which is told its path; `None` counts as missing.
    fn get<T>(
        &self,
        name: &str,
        read: impl Fn(&Bound<'py, PyAny>, &str) -> Result<T, Error>,
    ) -> Result<Option<T>, Error> {
        let path = format!("{}.{name}", self.1);
        let unreadable = |e: PyErr| Error::new(ErrorCode::Input, &path, format!("cannot be read: {e}"));
        let value = self.0.get_item(name).map_err(unreadable)?.filter(|value| !value.is_none());
        value.map(|value| read(&value, &path)).transpose()
    }

    fn numbers(&self, name: &str) -> Result<Option<Vec<f64>>, Error> {
        self.get(name, numbers)
    }

    fn path(&self) -> Result<Vec<f64>, Error> {
        let missing = || Error::new(ErrorCode::Input, format!("{}.path", self.1), "missing field");
        self.numbers("path")?.ok_or_else(missing)
    }

    fn gears(&self) -> Result<Option<Vec<i8>>, Error> {
        self.get("directions", gears)
    }
}

/// The fields of `parkade.Trajectory`.
#[pyfunction]
fn optimise<'py>(
    py: Python<'py>,
    scene: &Bound<'py, PyAny>,
    plan: &Bound<'py, PyDict>,
    options: &Bound<'py, PyDict>,
) -> PyResult<Bound<'py, PyDict>> {
    let scene = read_scene(py, scene)?;
    let columns = Columns(plan, "plan");
    let made = optional(Some(options), ErrorCode::Config, "options").and_then(|fields| {
        let options = Options::default().with(&fields)?;
        let (path, gears, curvatures) = (columns.path()?, columns.gears()?, columns.numbers("curvatures")?);
        py.detach(|| plan::optimise(&scene, (&path, gears.as_deref(), curvatures.as_deref()), &options))
    });
    let made = made.map_err(|e| refused(py, &e))?;
    trajectory(py, &scene, &made)
}

fn trajectory<'py>(py: Python<'py>, scene: &Scenario, made: &Optimised) -> PyResult<Bound<'py, PyDict>> {
    let states = &made.states;
    let (accelerations, rates) = states.controls();
    let fields = PyDict::new(py);
    let columns = [
        ("t", &states.t),
        ("stations", &states.stations()),
        ("speeds", &states.speed),
        ("accelerations", &accelerations),
        ("steering", &states.steering),
        ("steering_rates", &rates),
    ];
    for (name, values) in columns {
        fields.set_item(name, PyArray1::from_slice(py, values))?;
    }
    fields.set_item("path", poses(py, &states.poses)?)?;
    fields.set_item("duration", states.duration())?;
    fields.set_item("length", made.check.figures.length)?;
    fields.set_item("stage", made.stage.as_str())?;
    fields.set_item("check", write(py, &made.check.to_json(scene))?)?;
    fields.set_item("hash", states.hash())?;
    Ok(fields)
}

/// The referee's verdict on CSV or on columns.
#[pyfunction]
fn judge<'py>(
    py: Python<'py>,
    scene: &Bound<'py, PyAny>,
    trajectory: &Bound<'py, PyAny>,
    limits: &Bound<'py, PyDict>,
) -> PyResult<Bound<'py, PyAny>> {
    let scene = read_scene(py, scene)?;
    let judged = optional(Some(limits), ErrorCode::Config, "limits").and_then(|fields| {
        let limits = MotionLimits::default().with(&fields)?;
        let submission = submission(trajectory)?;
        let geometry = scene.geometry()?;
        py.detach(|| verdict(&geometry, &submission, &limits))
    });
    let judged = judged.map_err(|e| refused(py, &e))?;
    write(py, &judged.to_json(&scene))
}

/// CSV, or columns: a trajectory where there are times, else a path.
fn submission(trajectory: &Bound<'_, PyAny>) -> Result<Submission, Error> {
    if let Ok(text) = trajectory.extract::<&str>() {
        return read_csv(text);
    }
    let Ok(columns) = trajectory.cast::<PyDict>() else {
        let rule =
            format!("must be CSV, a plan, a trajectory or a dict, got {}", crate::value::kind_of(trajectory));
        return Err(Error::new(ErrorCode::Input, "trajectory", rule));
    };
    let columns = Columns(columns, "trajectory");
    let poses = plan::path_poses(&columns.path()?).map_err(|e| e.within("trajectory"))?;
    Ok(match columns.numbers("t")? {
        Some(t) => {
            let (speed, steering) = (columns.numbers("speeds")?, columns.numbers("steering")?);
            Submission::Timed(TimedRows { t, poses, speed, steering })
        }
        None => Submission::Path { poses, gears: columns.gears()? },
    })
}

//! `Planner`: settings checked once, map prepared once.

use std::ops::ControlFlow;
use std::sync::{Mutex, MutexGuard, PoisonError, TryLockError};

use numpy::{PyArray1, PyArrayMethods as _};
use parkade::error::ErrorCode;
use parkade::plan::{self, LayerData, Options};
use parkade::scenario::Scenario;
use pyo3::exceptions::PyRuntimeError;
use pyo3::prelude::*;
use pyo3::types::PyDict;

use crate::answer;
use crate::value::{optional, read_object, refused};

/// Reports of progress between two looks at signals, such as Ctrl-C.
const SIGNALS: u32 = 32;

/// A planner on one scene.
#[pyclass(frozen, module = "parkade._native")]
pub(crate) struct Planner {
    inner: Mutex<plan::Planner>,
}

/// Reads a scene: a dictionary or JSON text.
pub(crate) fn scene(py: Python<'_>, value: &Bound<'_, PyAny>) -> PyResult<Scenario> {
    let read =
        read_object(value, ErrorCode::Scenario, "a scene").and_then(|value| Scenario::from_json(&value));
    read.map_err(|e| refused(py, &e))
}

#[pymethods]
impl Planner {
    #[new]
    fn new(
        py: Python<'_>,
        id: &str,
        scene: &Bound<'_, PyAny>,
        settings: Option<&Bound<'_, PyAny>>,
    ) -> PyResult<Self> {
        let scene = self::scene(py, scene)?;
        let settings = optional(settings, ErrorCode::Config, "settings").map_err(|e| refused(py, &e))?;
        let planner = py.detach(|| plan::Planner::new(id, &scene, &settings)).map_err(|e| refused(py, &e))?;
        Ok(Self { inner: Mutex::new(planner) })
    }

    /// Plans; `options` are those of the JavaScript API's `plan`.
    fn plan<'py>(
        &self,
        py: Python<'py>,
        options: &Bound<'py, PyDict>,
        on_progress: Option<Py<PyAny>>,
    ) -> PyResult<Bound<'py, PyDict>> {
        let fields = optional(Some(options), ErrorCode::Input, "options").map_err(|e| refused(py, &e))?;
        let mut guard = self.lock()?;
        let planner: &mut plan::Planner = &mut guard;
        let mut listener = Listener { on_progress, reports: 0, raised: None };
        let made = py.detach(|| {
            let (mut options, ends) = Options::from_json(planner.scenario(), &fields)?;
            let mut report = |expanded| listener.report(expanded);
            options.progress = Some(&mut report);
            planner.plan_between(ends, options)
        });
        let plan = made.map_err(|e| refused(py, &e))?;
        match listener.raised {
            Some(error) => Err(error),
            None => answer::plan(py, planner.scenario(), planner.geometry(), &plan),
        }
    }

    /// A raster, a row of the map per row of the array, from the south; two numbers per cell have an axis of their own.
    fn layer<'py>(&self, py: Python<'py>, name: &str, every: u32) -> PyResult<Bound<'py, PyAny>> {
        let mut guard = self.lock()?;
        let planner: &mut plan::Planner = &mut guard;
        let layer = py.detach(move || planner.layer(name, every)).map_err(|e| refused(py, &e))?;
        let (rows, columns) = (layer.height as usize, layer.width as usize);
        Ok(match layer.data {
            LayerData::Bytes(bytes) => PyArray1::from_vec(py, bytes).reshape([rows, columns])?.into_any(),
            LayerData::Floats(values) if values.len() == rows * columns => {
                PyArray1::from_vec(py, values).reshape([rows, columns])?.into_any()
            }
            LayerData::Floats(values) => {
                let depth = values.len() / (rows * columns).max(1);
                PyArray1::from_vec(py, values).reshape([rows, columns, depth])?.into_any()
            }
        })
    }
}

impl Planner {
    /// One plan at a time: waiting for another thread, or for a callback of the same one, might never end.
    fn lock(&self) -> PyResult<MutexGuard<'_, plan::Planner>> {
        match self.inner.try_lock() {
            Ok(planner) => Ok(planner),
            Err(TryLockError::Poisoned(poisoned)) => Ok(PoisonError::into_inner(poisoned)),
            Err(TryLockError::WouldBlock) => Err(PyRuntimeError::new_err(
                "this planner is in use already: give each thread a Planner of its own",
            )),
        }
    }
}

/// What a plan's progress is told to.
struct Listener {
    on_progress: Option<Py<PyAny>>,
    reports: u32,
    /// What the callback or a signal raised.
    raised: Option<PyErr>,
}

impl Listener {
    fn report(&mut self, expanded: u32) -> ControlFlow<()> {
        self.reports += 1;
        if self.on_progress.is_none() && !self.reports.is_multiple_of(SIGNALS) {
            return ControlFlow::Continue(());
        }
        self.raised = Python::attach(|py| {
            py.check_signals()?;
            self.on_progress.as_ref().map_or(Ok(()), |tell| tell.call1(py, (expanded,)).map(|_| ()))
        })
        .err();
        if self.raised.is_some() { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
    }
}

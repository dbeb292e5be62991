//! The wheel's native part: the crate `parkade` for Python. The package in `parkade/` gives it its names and types.

mod answer;
mod drive;
mod planner;
mod scenes;
mod value;

use pyo3::prelude::*;

#[pymodule]
fn _native(module: &Bound<'_, PyModule>) -> PyResult<()> {
    module.add("VERSION", scenes::VERSION)?;
    module.add_class::<planner::Planner>()?;
    drive::register(module)?;
    scenes::register(module)
}

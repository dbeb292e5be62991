//! `cargo xtask fuzz`: random questions by the million.

use anyhow::Result;

use crate::tools::{cargo, run};

pub(crate) fn fuzz(arguments: &[String]) -> Result<()> {
    let package = ["run", "--quiet", "--locked", "--profile", "fuzz", "--package", "parkade-fuzz", "--"];
    run(cargo().args(package).args(arguments))
}

//! `cargo xtask consumers`: the packed package in bundlers and frameworks, which come from the registry.

use anyhow::Result;

use crate::tools::{node, run};
use crate::{browser, site};

/// Builds, then installs the package into a folder for each consumer and compares the plan's hash.
pub(crate) fn consumers(names: &[String]) -> Result<()> {
    site::assemble()?;
    run(node().arg("tests/consumers/run.mjs").args(names).env("CHROME_PATH", browser::find_or_install()?))
}

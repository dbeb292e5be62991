//! `cargo xtask paper grid` and `paper road`: the papers' tables beside ours.

use anyhow::Result;

use crate::tools::{cargo, run};

pub(crate) fn paper(arguments: &[String]) -> Result<()> {
    run(cargo().args(["run", "--quiet", "--release", "--locked", "--example", "paper", "--"]).args(arguments))
}

//! `cargo xtask paper grid`, `paper road` and `paper parking`: the papers' tables beside ours.

use anyhow::Result;

use crate::tools::{cargo, run};

pub(crate) fn paper(arguments: &[String]) -> Result<()> {
    run(cargo().args(["run", "--quiet", "--release", "--locked", "--example", "paper", "--"]).args(arguments))
}

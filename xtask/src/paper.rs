//! `cargo xtask paper grid`, `paper road` and `paper parking`: the papers' tables beside ours.

use std::fs;

use anyhow::{Context as _, Result};

use crate::site;
use crate::tools::{Workspace, capture, cargo, node, run};

pub(crate) fn paper(arguments: &[String]) -> Result<()> {
    let mut example = cargo();
    example.args(["run", "--quiet", "--release", "--locked", "--example", "paper", "--"]).args(arguments);
    if arguments.first().is_some_and(|word| word == "road") {
        // The same figures in WebAssembly, which the example prints beside its own.
        site::package()?;
        let file = Workspace::load()?.target.join("paper-road-wasm.json");
        fs::write(&file, capture(node().arg("tests/bench/road.mjs"))?)
            .with_context(|| file.display().to_string())?;
        example.arg("--wasm").arg(file);
    }
    run(&mut example)
}

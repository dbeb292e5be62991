//! `cargo xtask paper grid`, `road` and `parking`: the papers' tables beside ours; `settings` and `volumes` beside
//! them; `comparison`: the road manuscript's comparison with other algorithms; `verdicts`: every claim and how it is
//! judged, the same bytes on any machine; `all`: everything with figures, as one Markdown and one HTML file.

use std::fs;

use anyhow::{Context as _, Result};

use crate::site;
use crate::tools::{Workspace, capture, cargo, node, run};

pub(crate) fn paper(arguments: &[String]) -> Result<()> {
    if let [word, rest @ ..] = arguments
        && word == "all"
    {
        site::package()?;
        let folder = Workspace::load()?.target.join("papers");
        return run(node().arg("tests/bench/papers.mjs").arg(folder).args(rest));
    }
    if let [word, rest @ ..] = arguments
        && (word == "verdicts" || word == "comparison" && rest.is_empty())
    {
        site::package()?;
        return run(node().arg("tests/bench/papers.mjs").arg(word).args(rest));
    }
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

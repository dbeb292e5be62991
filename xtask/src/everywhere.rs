//! `cargo xtask everywhere`: the same plans, byte by byte, wherever they are made.

use anyhow::{Context as _, Result, ensure};

use crate::tools::{Workspace, capture, cargo, node, run};
use crate::{browser, site};

/// Random questions, when no number is given.
const RANDOM: &str = "2000";

/// Fails where an answer differs from the native one.
pub(crate) fn everywhere(arguments: &[String]) -> Result<()> {
    ensure!(arguments.len() <= 1, "there is `everywhere [random scenes]`");
    let random = arguments.first().map_or(RANDOM, String::as_str);
    random.parse::<u32>().with_context(|| format!("must be a whole number, got {random}"))?;
    site::assemble()?;
    let questions = Workspace::load()?.target.join("everywhere.jsonl");
    let package =
        ["run", "--quiet", "--release", "--locked", "--package", "parkade-fuzz", "--", "--print", random];
    std::fs::write(&questions, capture(cargo().args(package))?)?;
    run(node().arg("tests/everywhere/run.js").arg(&questions).env("CHROME_PATH", browser::find_or_install()?))
}

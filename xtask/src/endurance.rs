//! `cargo xtask endurance`: what takes longer than a test may, on the built page in a real browser.

use anyhow::{Result, ensure};

use crate::tools::{node, run};
use crate::{browser, site};

const TRIALS: [&str; 4] = ["kills", "soak", "damaged", "monkey"];

/// Fails where the page does not recover from a killed worker, its memory grows, or anything from outside or any hand
/// breaks it.
pub(crate) fn endurance(arguments: &[String]) -> Result<()> {
    let (trial, rest) = arguments.split_first().map_or(("", &[][..]), |(first, rest)| (first.as_str(), rest));
    ensure!(
        TRIALS.contains(&trial) && rest.len() <= 2 && rest.iter().all(|one| one.parse::<u32>().is_ok()),
        "say `endurance kills [count] [seed]`, `endurance soak [minutes] [seed]`, `endurance damaged [count] [seed]` \
         or `endurance monkey [minutes] [seed]`"
    );
    site::assemble()?;
    let script = format!("tests/endurance/{trial}.mjs");
    run(node().arg(script).args(rest).env("CHROME_PATH", browser::find_or_install()?))
}

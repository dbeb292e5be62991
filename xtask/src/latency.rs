//! `cargo xtask latency`: how soon the built page answers a drag, in a real browser.

use anyhow::{Result, ensure};

use crate::tools::{node, run};
use crate::{browser, site};

/// Prints figures; never fails on slow ones, which say as much of the machine as of the page.
pub(crate) fn latency(arguments: &[String]) -> Result<()> {
    ensure!(arguments.is_empty(), "`latency` takes no arguments");
    site::assemble()?;
    run(node().arg("tests/latency/latency.mjs").env("CHROME_PATH", browser::find_or_install()?))
}

//! `cargo xtask picture`: pictures of the page in README and in the documentation.

use anyhow::{Result, ensure};

use crate::tools::{node, run};
use crate::{browser, site};

/// Builds the page and photographs it into `docs/public/playground.png` and `docs/public/questions`.
pub(crate) fn picture(arguments: &[String]) -> Result<()> {
    ensure!(arguments.is_empty(), "`picture` takes no arguments");
    site::assemble()?;
    run(node().arg("tests/picture/picture.mjs").env("CHROME_PATH", browser::find_or_install()?))
}

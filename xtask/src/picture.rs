//! `cargo xtask picture`: README's picture of the page.

use anyhow::{Result, ensure};

use crate::tools::{node, run};
use crate::{browser, site};

/// Builds the page and photographs it into `docs/public/playground.png`.
pub(crate) fn picture(arguments: &[String]) -> Result<()> {
    ensure!(arguments.is_empty(), "`picture` takes no arguments");
    site::assemble()?;
    run(node().arg("tests/picture/picture.mjs").env("CHROME_PATH", browser::find_or_install()?))
}

//! `cargo xtask docs`: the documentation site in `docs/.vitepress/dist/`, around the package and the page as built.

use anyhow::{Result, ensure};

use crate::site;
use crate::tools::{node_tool, run};

pub(crate) fn docs(arguments: &[String]) -> Result<()> {
    ensure!(arguments.is_empty(), "`docs` takes no arguments");
    site::assemble()?;
    generate()?;
    println!("\ndocs/.vitepress/dist: put it beside the page, as the folder docs");
    Ok(())
}

/// Builds the site from a package that is there. A dead link is an error.
pub(crate) fn generate() -> Result<()> {
    run(node_tool("vitepress/bin/vitepress.js").args(["build", "docs"]))
}

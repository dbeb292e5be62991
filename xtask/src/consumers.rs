//! `cargo xtask consumers`: the packed package in bundlers and frameworks, and the page in documentation hosts, which
//! come from their registries.

use anyhow::Result;

use crate::tools::{node, run};
use crate::{browser, docs, site};

/// Builds, then installs the package into a folder for each consumer and compares the plan's hash; with `hosts`, builds
/// the examples of documentation hosts and looks at their pages in Chromium and Firefox.
pub(crate) fn consumers(names: &[String]) -> Result<()> {
    site::assemble()?;
    let (script, names, mdbook) = match names.split_first() {
        Some((first, hosts)) if first == "hosts" => ("hosts", hosts, Some(docs::mdbook()?)),
        _ => ("run", names, None),
    };
    let mut drive = node();
    drive
        .arg(format!("tests/consumers/{script}.mjs"))
        .args(names)
        .env("CHROME_PATH", browser::find_or_install()?);
    if let Some(program) = mdbook {
        drive.env("MDBOOK", program);
    }
    run(&mut drive)
}

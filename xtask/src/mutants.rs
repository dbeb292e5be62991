//! `cargo xtask mutants`: whether a test fails where the code is changed.

use anyhow::{Context as _, Result, ensure};

use crate::tools::{cargo, run};

/// What it is run on, and the modules' files.
const MODULES: [(&str, &str); 3] =
    [("geometry", "src/geometry/**"), ("search", "src/search/**"), ("collision", "src/vehicle/collision/**")];

/// Changes one module, or all; further arguments go to cargo-mutants. Fails where a change is missed.
pub(crate) fn mutants(arguments: &[String]) -> Result<()> {
    let version = cargo().args(["mutants", "--version"]).output();
    if !version.is_ok_and(|output| output.status.success()) {
        run(cargo().args(["install", "--locked", "cargo-mutants@27.1.0"])).context("cargo-mutants")?;
    }
    let (name, rest) = match arguments.split_first() {
        Some((name, rest)) if !name.starts_with('-') => (name.as_str(), rest),
        _ => ("", arguments),
    };
    let files: Vec<&str> =
        MODULES.iter().filter(|(module, _)| name.is_empty() || name == *module).map(|m| m.1).collect();
    ensure!(!files.is_empty(), "say `mutants [geometry|search|collision] [options of cargo-mutants]`");
    let files = files.iter().flat_map(|file| ["--file", file]);
    run(cargo().arg("mutants").args(files).args(rest))
}

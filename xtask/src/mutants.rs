//! `cargo xtask mutants`: whether a test fails where the code is changed.

use anyhow::{Result, ensure};

use crate::tools::{cargo_tool, command, run};

const CARGO_MUTANTS: &str = "27.1.0";

/// What it is run on, and the modules' files.
const MODULES: [(&str, &[&str]); 4] = [
    ("geometry", &["src/geometry/**"]),
    ("search", &["src/search/**"]),
    ("collision", &["src/vehicle/collision/**"]),
    ("curves", &["src/drive/jerk_limited.rs", "src/post/smooth.rs"]),
];

/// Changes one module, or all; further arguments go to cargo-mutants. Fails where a change is missed.
pub(crate) fn mutants(arguments: &[String]) -> Result<()> {
    let (name, rest) = match arguments.split_first() {
        Some((name, rest)) if !name.starts_with('-') => (name.as_str(), rest),
        _ => ("", arguments),
    };
    let chosen = MODULES.iter().filter(|(module, _)| name.is_empty() || name == *module);
    let files: Vec<_> =
        chosen.flat_map(|(_, files)| files.iter().flat_map(|file| ["--file", file])).collect();
    ensure!(!files.is_empty(), "say `mutants [geometry|search|collision|curves] [options of cargo-mutants]`");
    let program = cargo_tool("cargo-mutants", CARGO_MUTANTS, &[])?;
    run(command(program).arg("mutants").args(files).args(rest))
}

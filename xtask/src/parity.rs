//! `cargo xtask parity`: the same plans, byte by byte, wherever they are made.

use anyhow::{Context as _, Result, bail};

use crate::tools::{Workspace, capture, cargo, node, run};
use crate::{browser, python, site};

/// Random questions, when no number is given.
const RANDOM: &str = "2000";

/// Fails where an answer differs from the native one.
pub(crate) fn parity(arguments: &[String]) -> Result<()> {
    let words: Vec<&str> = arguments.iter().map(String::as_str).collect();
    let asked = match words[..] {
        [] => vec!["--print", RANDOM],
        ["parking"] => vec!["--print-parking", "0", RANDOM],
        ["parking", count] => vec!["--print-parking", "0", count],
        ["parking", count, first] => vec!["--print-parking", first, count],
        [count] => vec!["--print", count],
        _ => bail!("there are `parity [random scenes]` and `parity parking [random scenes [first seed]]`"),
    };
    for number in &asked[1..] {
        number.parse::<u32>().with_context(|| format!("must be a whole number, got {number}"))?;
    }
    site::assemble()?;
    let questions = Workspace::load()?.target.join("parity.jsonl");
    let package = ["run", "--quiet", "--release", "--locked", "--package", "parkade-fuzz", "--"];
    std::fs::write(&questions, capture(cargo().args(package).args(&asked))?)?;
    let vectorised = site::vectorised()?;
    match python::Environment::ready()? {
        Ok(environment) if asked[0] == "--print" => {
            python::install(&environment)?;
            run(environment.program("python").arg("python/tests/parity.py").arg(&questions))?;
        }
        Ok(_) => {}
        Err(reason) => println!("not compared in Python: {reason}"),
    }
    run(node()
        .arg("tests/engines/run.js")
        .args([&questions, &vectorised])
        .env("CHROME_PATH", browser::find_or_install()?))
}

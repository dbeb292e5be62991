//! `cargo xtask test`: every check and test, whatever fails before; totals last.

use std::fmt;
use std::fs;
use std::path::Path;
use std::process::Command;
use std::time::{Duration, Instant};

use anyhow::{Context as _, Result, bail, ensure};
use serde_json::Value;

use crate::tools::{self, WASM_TARGET, Workspace, cargo, node_tool, tee};
use crate::{browser, docs, site};

/// Selects this program, in the profile in which it is built anyway.
const TOOL: &[&str] = &["--package", "xtask", "--profile", "tool"];
const FUZZ: &[&str] = &["--package", "parkade-fuzz"];

/// Tests of one suite; a check without tests of its own counts as one.
#[derive(Clone, Copy, Default)]
struct Counts {
    passed: u64,
    failed: u64,
    skipped: u64,
    repeated: u64,
}

struct Suite {
    name: &'static str,
    counts: Counts,
    time: Duration,
    remark: Option<String>,
}

pub(crate) fn test(arguments: &[String]) -> Result<()> {
    ensure!(
        arguments.is_empty(),
        "`test` takes no arguments; single suites have their own commands, see README.md"
    );
    let mut suites = vec![suite("build", || check(site::assemble()))];
    let built = suites[0].counts.failed == 0;
    suites.push(suite("format", || cargo_check(&["fmt", "--all", "--check"])));
    suites.push(suite("lint, native", || lint(&["--all-targets"])));
    suites.push(suite("lint, tool", || lint(&[TOOL, &["--all-targets"]].concat())));
    suites.push(suite("lint, fuzz", || lint(&[FUZZ, &["--all-targets"]].concat())));
    suites.push(suite("lint, wasm", || lint(&["--target", WASM_TARGET, "--lib", "--tests"])));
    suites.push(suite("lint, core", || lint(&["--target", WASM_TARGET, "--lib", "--no-default-features"])));
    suites.push(suite("Rust, native", || rust_tests(&[])));
    suites.push(suite("Rust, tool", || rust_tests(TOOL)));
    suites.push(suite("Rust, random input", || rust_tests(FUZZ)));
    suites.push(suite("Rust, wasm in Node", || rust_tests(&["--target", WASM_TARGET, "--tests"])));
    let mut on_build = |name, run: fn() -> Result<Counts>| {
        suites.push(suite(name, || if built { run() } else { bail!("not run: the build failed") }));
    };
    on_build("sizes", || check(site::check_sizes()));
    on_build("types, page", || type_check("www"));
    on_build("types, package and tests", || type_check("tests"));
    on_build("documentation", || check(docs::generate()));
    on_build("JavaScript", vitest);
    on_build("page in a browser", playwright);
    let total = conclude(&suites);
    if total.failed > 0 {
        // The totals stay the last line: no error message after them.
        std::process::exit(1);
    }
    Ok(())
}

fn suite(name: &'static str, run: impl FnOnce() -> Result<Counts>) -> Suite {
    let start = Instant::now();
    println!("\n=== {name}");
    let (counts, remark) = match run() {
        Ok(counts) => (counts, None),
        Err(error) => (Counts { failed: 1, ..Counts::default() }, Some(format!("{error:#}"))),
    };
    if let Some(remark) = &remark {
        eprintln!("error: {remark}");
    }
    Suite { name, counts, time: start.elapsed(), remark }
}

/// Prints a line per suite and, as the very last one, the totals.
fn conclude(suites: &[Suite]) -> Counts {
    println!();
    let mut total = Counts::default();
    for suite in suites {
        println!("{suite}");
        total.passed += suite.counts.passed;
        total.failed += suite.counts.failed;
        total.skipped += suite.counts.skipped;
        total.repeated += suite.counts.repeated;
    }
    println!("\n{total}");
    total
}

fn check(result: Result<()>) -> Result<Counts> {
    result.map(|()| Counts { passed: 1, ..Counts::default() })
}

fn cargo_check(arguments: &[&str]) -> Result<Counts> {
    check(tools::run(cargo().args(arguments)))
}

fn lint(scope: &[&str]) -> Result<Counts> {
    check(tools::run(cargo().args(["clippy", "--locked"]).args(scope).args(["--", "-D", "warnings"])))
}

fn type_check(project: &str) -> Result<Counts> {
    check(tools::run(node_tool("typescript/bin/tsc").args(["-p", project])))
}

fn rust_tests(scope: &[&str]) -> Result<Counts> {
    let (status, output) = tee(cargo().args(["test", "--locked", "--no-fail-fast"]).args(scope))?;
    judge(status.success(), libtest_counts(&output))
}

fn vitest() -> Result<Counts> {
    let report = Workspace::load()?.target.join("vitest.json");
    let mut output = std::ffi::OsString::from("--outputFile.json=");
    output.push(&report);
    let command = &mut node_tool("vitest/vitest.mjs");
    command.args(["run", "--reporter=default", "--reporter=json"]).arg(output);
    with_report(command, &report, vitest_counts)
}

fn playwright() -> Result<Counts> {
    let report = Workspace::load()?.target.join("playwright.json");
    let command = &mut node_tool("@playwright/test/cli.js");
    command.args(["test", "--reporter=list,json"]);
    command.env("CHROME_PATH", browser::find_or_install()?).env("PLAYWRIGHT_JSON_OUTPUT_FILE", &report);
    with_report(command, &report, playwright_counts)
}

/// Runs a JavaScript test tool and counts by the JSON report that it leaves.
fn with_report(command: &mut Command, report: &Path, count: fn(&Value) -> Option<Counts>) -> Result<Counts> {
    if report.exists() {
        fs::remove_file(report)?;
    }
    let outcome = tools::run(command);
    let Ok(text) = fs::read_to_string(report) else {
        outcome?;
        bail!("{} was not written", report.display());
    };
    let counts = count(&serde_json::from_str(&text)?)
        .with_context(|| format!("{}: unknown form", report.display()))?;
    judge(outcome.is_ok(), counts)
}

/// A suite that fails without a failed test, or passes without any test, has failed.
fn judge(success: bool, counts: Counts) -> Result<Counts> {
    if !success && counts.failed == 0 {
        Ok(Counts { failed: 1, ..counts })
    } else if success && counts.passed == 0 {
        bail!("no tests ran")
    } else {
        Ok(counts)
    }
}

/// Adds up the lines `test result: ok. 2 passed; 0 failed; 1 ignored; …`.
fn libtest_counts(output: &str) -> Counts {
    let mut counts = Counts::default();
    for line in output.lines().filter(|line| line.starts_with("test result:")) {
        for part in line.split([';', '.']) {
            let mut words = part.split_whitespace();
            let (Some(Ok(number)), Some(word)) = (words.next().map(str::parse::<u64>), words.next()) else {
                continue;
            };
            match word {
                "passed" => counts.passed += number,
                "failed" => counts.failed += number,
                "ignored" => counts.skipped += number,
                _ => {}
            }
        }
    }
    counts
}

fn vitest_counts(report: &Value) -> Option<Counts> {
    Some(Counts {
        passed: report["numPassedTests"].as_u64()?,
        failed: report["numFailedTests"].as_u64()?,
        skipped: report["numPendingTests"].as_u64()? + report["numTodoTests"].as_u64()?,
        repeated: 0,
    })
}

/// Tests that pass only when repeated pass, and are counted apart: a loaded machine can stall a browser.
fn playwright_counts(report: &Value) -> Option<Counts> {
    let stats = &report["stats"];
    let repeated = stats["flaky"].as_u64()?;
    Some(Counts {
        passed: stats["expected"].as_u64()? + repeated,
        failed: stats["unexpected"].as_u64()?,
        skipped: stats["skipped"].as_u64()?,
        repeated,
    })
}

impl fmt::Display for Counts {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{} passed, {} failed", self.passed, self.failed)?;
        if self.skipped > 0 {
            write!(f, ", {} skipped", self.skipped)?;
        }
        if self.repeated > 0 {
            write!(f, ", {} of the passed at the second try", self.repeated)?;
        }
        Ok(())
    }
}

impl fmt::Display for Suite {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{:<26}{:>6.1} s  {}", self.name, self.time.as_secs_f64(), self.counts)?;
        match &self.remark {
            Some(remark) => write!(f, " ({remark})"),
            None => Ok(()),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn adds_up_libtest_summaries() {
        let output = "running 3 tests\n\
            test result: ok. 2 passed; 0 failed; 1 ignored; 0 measured; 0 filtered out; finished in 0.02s\n\
            test result: FAILED. 4 passed; 3 failed; 0 ignored; 0 filtered out; finished in 1.50s\n";
        let counts = libtest_counts(output);
        assert_eq!((counts.passed, counts.failed, counts.skipped), (6, 3, 1));
    }

    #[test]
    fn silence_is_no_success() {
        assert!(judge(true, Counts::default()).is_err());
        assert!(
            judge(false, Counts { passed: 7, ..Counts::default() }).is_ok_and(|counts| counts.failed == 1)
        );
    }
}

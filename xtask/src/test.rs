//! `cargo xtask test`: every check and test, whatever fails before; totals last.

use std::fmt;
use std::fs;
use std::path::Path;
use std::process::Command;
use std::time::{Duration, Instant};

use anyhow::{Context as _, Result, bail, ensure};
use serde_json::Value;

use crate::tools::{self, WASM_TARGET, Workspace, cargo, node_tool, tee};
use crate::{browser, docs, python, site};

/// Selects this program, in the profile in which it is built anyway.
const TOOL: &[&str] = &["--package", "xtask", "--profile", "tool"];
const FUZZ: &[&str] = &["--package", "parkade-fuzz"];

/// Tests of one suite; a check without tests of its own counts as one.
#[derive(Default)]
struct Counts {
    passed: u64,
    failed: u64,
    skipped: u64,
    repeated: u64,
    /// What failed, a line each: the end of a long log is often all that is kept of it.
    failures: Vec<String>,
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
    suites.push(suite("lint, wheel", || check(python::lint_native())));
    suites.push(suite("lint, documentation", rustdoc));
    suites.push(suite("format and lint, JavaScript", || {
        check(tools::run(node_tool("@biomejs/biome/bin/biome").args(["ci", "--diagnostic-level=error"])))
    }));
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
    on_build("Python", wheel);
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

/// Prints a line per suite, what failed and, as the very last line, the totals.
fn conclude(suites: &[Suite]) -> Counts {
    println!();
    let mut total = Counts::default();
    for suite in suites {
        println!("{suite}");
        suite.counts.failures.iter().for_each(|failure| println!("  failed: {failure}"));
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

fn rustdoc() -> Result<Counts> {
    let mut command = cargo();
    command.args(["doc", "--locked", "--no-deps"]).env("RUSTDOCFLAGS", "-D warnings");
    check(tools::run(&mut command))
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

/// The wheel in Python, where there is one that can install what the tests need.
fn wheel() -> Result<Counts> {
    let environment = match python::Environment::ready()? {
        Ok(environment) => environment,
        Err(reason) => {
            println!("the wheel is not tested: {reason}");
            return Ok(Counts { skipped: 1, ..Counts::default() });
        }
    };
    python::lint(&environment)?;
    python::playground()?;
    python::install(&environment)?;
    let (status, output) = tee(&mut python::pytest(&environment))?;
    judge(status.success(), pytest_counts(&output))
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
    // `test a::b ... FAILED`, and `FAIL` in wasm
    let failed = |line: &str| Some(line.strip_prefix("test ")?.split_once(" ... FAIL")?.0.to_owned());
    counts.failures = output.lines().filter_map(failed).collect();
    counts
}

/// Adds up the line `2 failed, 8 passed, 1 skipped in 1.93s`; `FAILED` lines name what failed.
fn pytest_counts(output: &str) -> Counts {
    let mut counts = Counts::default();
    let summary =
        output.lines().rfind(|line| line.contains(" in ") && line.ends_with('s')).unwrap_or_default();
    for part in summary.split(" in ").next().unwrap_or_default().split(", ") {
        let Some((Ok(number), word)) =
            part.split_once(' ').map(|(number, word)| (number.parse::<u64>(), word))
        else {
            continue;
        };
        match word {
            "passed" => counts.passed += number,
            "failed" | "error" | "errors" => counts.failed += number,
            "skipped" => counts.skipped += number,
            _ => {}
        }
    }
    let failed = |line: &str| Some(line.strip_prefix("FAILED ")?.to_owned());
    counts.failures = output.lines().filter_map(failed).collect();
    counts
}

/// The first line of a message, without the codes that colour it.
fn first_line(message: &Value) -> String {
    let mut plain = String::new();
    let mut rest = message.as_str().unwrap_or_default().lines().next().unwrap_or_default();
    while let Some((text, code)) = rest.split_once('\u{1b}') {
        plain.push_str(text);
        rest = code.split_once('m').map_or("", |(_, after)| after);
    }
    plain + rest
}

fn vitest_counts(report: &Value) -> Option<Counts> {
    let tests = report["testResults"].as_array()?.iter().flat_map(|file| {
        file["assertionResults"].as_array().into_iter().flatten().map(move |test| (&file["name"], test))
    });
    let failed = tests.filter(|(_, test)| test["status"] == "failed").map(|(file, test)| {
        let file = file.as_str().map_or("", |name| name.rsplit('/').next().unwrap_or(name));
        format!(
            "{file}: {}: {}",
            test["fullName"].as_str().unwrap_or_default(),
            first_line(&test["failureMessages"][0])
        )
    });
    Some(Counts {
        failures: failed.collect(),
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
    let specs =
        report["suites"].as_array()?.iter().flat_map(|file| file["specs"].as_array().into_iter().flatten());
    let failed = specs.filter(|spec| spec["ok"] == false).map(|spec| {
        let [file, title] = ["file", "title"].map(|key| spec[key].as_str().unwrap_or_default());
        format!("{file}: {title}: {}", first_line(&spec["tests"][0]["results"][0]["errors"][0]["message"]))
    });
    Some(Counts {
        failures: failed.collect(),
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
            test a::b ... ok\n\
            test a::c ... FAILED\n\
            test result: FAILED. 4 passed; 3 failed; 0 ignored; 0 filtered out; finished in 1.50s\n";
        let counts = libtest_counts(output);
        assert_eq!((counts.passed, counts.failed, counts.skipped), (6, 3, 1));
        assert_eq!(counts.failures, ["a::c"]);
    }

    #[test]
    fn adds_up_the_summary_of_pytest() {
        let output = "..Fs\nFAILED tests/test_plans.py::test_a - assert 1 == 2\n1 failed, 2 passed, 1 skipped in 1.93s\n";
        let counts = pytest_counts(output);
        assert_eq!((counts.passed, counts.failed, counts.skipped), (2, 1, 1));
        assert_eq!(counts.failures, ["tests/test_plans.py::test_a - assert 1 == 2"]);
        assert_eq!(pytest_counts("no tests ran in 0.01s\n").passed, 0);
    }

    #[test]
    fn names_what_failed_in_javascript() {
        let report = serde_json::json!({
            "numPassedTests": 1, "numFailedTests": 1, "numPendingTests": 0, "numTodoTests": 0,
            "testResults": [{ "name": "/a/b/pool.test.ts", "assertionResults": [
                { "status": "passed", "fullName": "works", "failureMessages": [] },
                { "status": "failed", "fullName": "waits",
                "failureMessages": ["\u{1b}[31mexpected 1\u{1b}[39m to be 2\nat"] },
            ] }],
        });
        assert_eq!(vitest_counts(&report).unwrap().failures, ["pool.test.ts: waits: expected 1 to be 2"]);
        let report = serde_json::json!({
            "stats": { "expected": 0, "unexpected": 1, "flaky": 0, "skipped": 0 },
            "suites": [{ "specs": [{ "ok": false, "file": "grid.spec.ts", "title": "drags",
                "tests": [{ "results": [{ "errors": [{ "message": "Timeout\nmore" }] }] }] }] }],
        });
        assert_eq!(playwright_counts(&report).unwrap().failures, ["grid.spec.ts: drags: Timeout"]);
    }

    #[test]
    fn silence_is_no_success() {
        assert!(judge(true, Counts::default()).is_err());
        assert!(
            judge(false, Counts { passed: 7, ..Counts::default() }).is_ok_and(|counts| counts.failed == 1)
        );
    }
}

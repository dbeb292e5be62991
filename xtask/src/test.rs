//! `cargo xtask test`: every check and test, whatever fails before; totals last.

use std::path::{Path, PathBuf};
use std::process::{Child, Command, Stdio};
use std::time::Instant;
use std::{env, fmt, fs};

use anyhow::{Context as _, Result, bail};
use serde::{Deserialize, Serialize};
use serde_json::Value;

use crate::counts::{Counts, judge, libtest_counts, playwright_counts, pytest_counts, vitest_counts};
use crate::tools::{self, WASM_TARGET, Workspace, cargo, command, node_tool, tee};
use crate::{browser, docs, processor, python, site};

/// Selects this program, in the profile in which it is built anyway.
const TOOL: &[&str] = &["--package", "xtask", "--profile", "tool"];
/// With the library: alone its dependencies have other features, and everything is compiled once more.
const LIBRARY_AND_FUZZ: &[&str] = &["--package", "parkade", "--package", "parkade-fuzz"];

struct Suite {
    name: &'static str,
    needs: Needs,
    run: fn() -> Result<Counts>,
}

#[derive(PartialEq)]
enum Needs {
    /// Nothing that is built. When all are run, these run beside the others.
    Sources,
    /// The package and the page, built.
    Build,
}

/// Makes what the suites of `Needs::Build` need.
const BUILD: Suite = suite("build", Needs::Sources, || check(site::assemble()));
/// Those of a kind run in this order. What uses several cores by itself comes last, when nothing runs beside it.
const SUITES: &[Suite] = &[
    BUILD,
    suite("sizes", Needs::Build, || check(site::check_sizes())),
    suite("format and lint, JavaScript", Needs::Build, || {
        check(tools::run(node_tool("@biomejs/biome/bin/biome").args(["ci", "--diagnostic-level=error"])))
    }),
    suite("types, page", Needs::Build, || type_check("www")),
    suite("types, package and tests", Needs::Build, || type_check("tests")),
    suite("documentation", Needs::Build, || check(docs::generate())),
    suite("Python", Needs::Build, wheel),
    suite("JavaScript", Needs::Build, vitest),
    suite("page in a browser", Needs::Build, playwright),
    suite("format", Needs::Sources, || cargo_check(&["fmt", "--all", "--check"])),
    suite("lint, native", Needs::Sources, || lint(&[LIBRARY_AND_FUZZ, &["--all-targets"]].concat())),
    suite("lint, tool", Needs::Sources, lint_tool),
    suite("lint, wasm", Needs::Sources, || lint(&["--target", WASM_TARGET, "--lib", "--tests"])),
    suite("lint, core", Needs::Sources, || {
        lint(&["--target", WASM_TARGET, "--lib", "--no-default-features"])
    }),
    suite("format, wheel", Needs::Sources, || check(python::check_format())),
    suite("lint, documentation", Needs::Sources, rustdoc),
    suite("Rust, wasm in Node", Needs::Sources, || rust_tests(&["--target", WASM_TARGET, "--test", "all"])),
    suite("Rust, native", Needs::Sources, || rust_tests(&[LIBRARY_AND_FUZZ, &["--lib", "--tests"]].concat())),
    suite("Rust, examples of the documentation", Needs::Sources, || rust_tests(&["--doc"])),
    suite("Rust, tool", Needs::Sources, || rust_tests(TOOL)),
];
/// Before the file that a run beside another leaves its results in.
const REPORT: &str = "--report";

const fn suite(name: &'static str, needs: Needs, run: fn() -> Result<Counts>) -> Suite {
    Suite { name, needs, run }
}

#[derive(Serialize, Deserialize)]
struct Outcome {
    suite: String,
    counts: Counts,
    seconds: f64,
    processor_seconds: Option<f64>,
    remark: Option<String>,
}

pub(crate) fn test(arguments: &[String]) -> Result<()> {
    let (report, names) = match arguments {
        [option, report, names @ ..] if option == REPORT => (Some(report), names),
        names => (None, names),
    };
    let known = |name: &String| SUITES.iter().any(|suite| suite.name == name);
    if let Some(name) = names.iter().find(|name| !known(name)) {
        let all: Vec<_> = SUITES.iter().map(|suite| format!("  \"{}\"", suite.name)).collect();
        bail!("no suite is called \"{name}\"; the suites are\n{}", all.join("\n"));
    }
    let outcomes = if names.is_empty() {
        run_all()
    } else {
        let chosen = SUITES.iter().filter(|suite| names.iter().any(|name| name == suite.name));
        chosen.map(|suite| Outcome::of(suite.name, suite.run)).collect()
    };
    if let Some(report) = report {
        return fs::write(report, serde_json::to_string(&outcomes)?).context("the results");
    }
    if conclude(&outcomes).failed > 0 {
        // The totals stay the last line: no error message after them.
        std::process::exit(1);
    }
    Ok(())
}

fn run_all() -> Vec<Outcome> {
    let names = |needs| SUITES.iter().filter(move |suite| suite.needs == needs).map(|suite| suite.name);
    let beside: Vec<_> = names(Needs::Sources).filter(|name| *name != BUILD.name).collect();
    let company = Company::start(&beside);
    let build = Outcome::of(BUILD.name, BUILD.run);
    let built = build.counts.failed == 0;
    let mut outcomes = vec![build];
    outcomes.extend(SUITES.iter().filter(|suite| suite.needs == Needs::Build).map(|suite| {
        Outcome::of(suite.name, || if built { (suite.run)() } else { bail!("not run: the build failed") })
    }));
    outcomes.extend(company.and_then(Company::results).unwrap_or_else(|error| {
        beside.iter().map(|name| Outcome::of(name, || bail!("not run: {error:#}"))).collect()
    }));
    outcomes
}

/// Suites in a process of lower priority: a browser that waits fails its tests. What they print is shown when they have
/// ended.
struct Company {
    process: Child,
    log: PathBuf,
    report: PathBuf,
}

impl Company {
    fn start(suites: &[&str]) -> Result<Self> {
        let folder = Workspace::load()?.target;
        let [log, report] = ["txt", "json"].map(|kind| folder.join("tests-beside").with_extension(kind));
        if report.exists() {
            fs::remove_file(&report)?;
        }
        let output = fs::File::create(&log).with_context(|| log.display().to_string())?;
        let program = env::current_exe()?;
        let mut start = if cfg!(unix) {
            let mut nice = command("nice");
            nice.args(["-n", "19"]).arg(program);
            nice
        } else {
            command(program)
        };
        start.args(["test", REPORT]).arg(&report).args(suites);
        // Each crate is compiled once here: what would help the next change takes a quarter more time, and what a
        // debugger reads an eighth.
        start.env("CARGO_INCREMENTAL", "0").env("CARGO_PROFILE_DEV_DEBUG", "false");
        println!("\n=== beside what follows: {}", suites.join(", "));
        let process = start.stdin(Stdio::null()).stderr(output.try_clone()?).stdout(output).spawn()?;
        Ok(Self { process, log, report })
    }

    fn results(mut self) -> Result<Vec<Outcome>> {
        self.process.wait()?;
        print!("{}", String::from_utf8_lossy(&fs::read(&self.log)?));
        let text = fs::read_to_string(&self.report).context("the suites beside left no results")?;
        Ok(serde_json::from_str(&text)?)
    }
}

impl Outcome {
    fn of(suite: &str, run: impl FnOnce() -> Result<Counts>) -> Self {
        let (start, before) = (Instant::now(), processor::seconds());
        println!("\n=== {suite}");
        let (counts, remark) = match run() {
            Ok(counts) => (counts, None),
            Err(error) => (Counts { failed: 1, ..Counts::default() }, Some(format!("{error:#}"))),
        };
        if let Some(remark) = &remark {
            eprintln!("error: {remark}");
        }
        Self {
            suite: suite.to_owned(),
            counts,
            seconds: start.elapsed().as_secs_f64(),
            processor_seconds: processor::seconds().zip(before).map(|(after, before)| after - before),
            remark,
        }
    }
}

/// Prints a line per suite, what failed and, as the very last line, the totals.
fn conclude(outcomes: &[Outcome]) -> Counts {
    println!();
    let mut total = Counts::default();
    for outcome in outcomes {
        println!("{outcome}");
        outcome.counts.failures.iter().for_each(|failure| println!("  failed: {failure}"));
        total.passed += outcome.counts.passed;
        total.failed += outcome.counts.failed;
        total.skipped += outcome.counts.skipped;
        total.repeated += outcome.counts.repeated;
    }
    let processors: f64 = outcomes.iter().filter_map(|outcome| outcome.processor_seconds).sum();
    println!("\n{:.1} minutes of processors\n{total}", processors / 60.0);
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

fn lint_tool() -> Result<Counts> {
    // Windows does not replace a program that runs.
    let targets = if cfg!(windows) { "--tests" } else { "--all-targets" };
    check(tools::run(tools::linting(cargo().args(["build", "--locked", targets]).args(TOOL))))
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
            python::lint_native()?;
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

impl fmt::Display for Outcome {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{:<36}{:>6.1} s  ", self.suite, self.seconds)?;
        if let Some(seconds) = self.processor_seconds {
            write!(f, "{seconds:>6.1} s of processors  ")?;
        }
        self.counts.fmt(f)?;
        match &self.remark {
            Some(remark) => write!(f, " ({remark})"),
            None => Ok(()),
        }
    }
}

//! How many tests of a suite passed, read off what its runner printed or wrote.

use std::fmt;

use anyhow::{Result, bail};
use serde::{Deserialize, Serialize};
use serde_json::Value;

/// Tests of one suite; a check without tests of its own counts as one.
#[derive(Default, Serialize, Deserialize)]
pub(crate) struct Counts {
    pub(crate) passed: u64,
    pub(crate) failed: u64,
    pub(crate) skipped: u64,
    pub(crate) repeated: u64,
    /// What failed, a line each: the end of a long log is often all that is kept of it.
    pub(crate) failures: Vec<String>,
}

/// A suite that fails without a failed test, or passes without any test, has failed.
pub(crate) fn judge(success: bool, counts: Counts) -> Result<Counts> {
    if !success && counts.failed == 0 {
        Ok(Counts { failed: 1, ..counts })
    } else if success && counts.passed == 0 {
        bail!("no tests ran")
    } else {
        Ok(counts)
    }
}

/// Adds up the lines `test result: ok. 2 passed; 0 failed; 1 ignored; …`.
pub(crate) fn libtest_counts(output: &str) -> Counts {
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
pub(crate) fn pytest_counts(output: &str) -> Counts {
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

pub(crate) fn vitest_counts(report: &Value) -> Option<Counts> {
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
pub(crate) fn playwright_counts(report: &Value) -> Option<Counts> {
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
        let output = "..Fs\nFAILED tests/test_plans.py::test_a - assert 1 == 2\n\
            1 failed, 2 passed, 1 skipped in 1.93s\n";
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

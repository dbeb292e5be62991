//! The repository's commands: `cargo xtask <command>`.

mod bench;
mod browser;
mod consumers;
mod counts;
mod docs;
mod endurance;
mod fuzz;
mod latency;
mod mutants;
mod paper;
mod parity;
mod picture;
mod processor;
mod python;
mod serve;
mod site;
mod test;
mod tools;
mod wasm_runner;

use std::fmt::Write as _;
use std::process::ExitCode;

use anyhow::{Result, bail};

struct Command {
    name: &'static str,
    about: &'static str,
    run: fn(&[String]) -> Result<()>,
}

const COMMANDS: &[Command] = &[
    Command { name: "build", about: "build the npm package (pkg/) and the page (dist/)", run: site::build },
    Command { name: "docs", about: "build, then make the documentation site", run: docs::docs },
    Command {
        name: "wheel",
        about: "build, then make the Python wheel in target/wheels",
        run: python::wheel,
    },
    Command {
        name: "notebooks",
        about: "build, then drive the widget in JupyterLab and marimo: notebooks [folder for pictures]",
        run: python::notebooks,
    },
    Command {
        name: "consumers",
        about: "build, then try the package in bundlers, or the page in hosts: consumers [hosts] [name…]",
        run: consumers::consumers,
    },
    Command { name: "serve", about: "build, then serve the page locally", run: serve::serve },
    Command {
        name: "test",
        about: "build, then check and test everything; or only the suites named: test \"Rust, native\" Python",
        run: test::test,
    },
    Command {
        name: "latency",
        about: "build, then measure how soon the page answers a drag",
        run: latency::latency,
    },
    Command {
        name: "endurance",
        about: "build, then test endurance with killed workers, hours of edits, damaged input or random presses: \
            endurance kills|damaged [count] [seed], endurance soak|monkey [minutes] [seed]",
        run: endurance::endurance,
    },
    Command {
        name: "paper",
        about: "print a paper's tables beside ours: grid, road or parking; settings, volumes; comparison with other \
            algorithms; all [maps]: every table and figure as Markdown and HTML",
        run: paper::paper,
    },
    Command {
        name: "picture",
        about: "build, then photograph the page for README (docs/public/playground.png)",
        run: picture::picture,
    },
    Command {
        name: "bench",
        about: "build, then measure: bench grid [questions] [repeats], bench parking, bench tight [check], bench \
            kerb [count] [first seed], bench judge, bench batch",
        run: bench::bench,
    },
    Command {
        name: "parity",
        about: "compare plan hashes between native code, Node with and without SIMD, Python, Chromium and Firefox: \
            parity [parking] [random scenes]",
        run: parity::parity,
    },
    Command {
        name: "fuzz",
        about: "send random queries and check the answers: fuzz [target] [--count N] [--from SEED]",
        run: fuzz::fuzz,
    },
    Command {
        name: "mutants",
        about: "mutate the code and check that a test fails: mutants [geometry|search|collision|curves] [options of \
            cargo-mutants]",
        run: mutants::mutants,
    },
    Command {
        name: "wasm-test-runner",
        about: "run one wasm test file in Node (cargo calls this)",
        run: wasm_runner::run,
    },
];

/// Commands that were renamed since the last release: the former name, the present one.
const FORMER_NAMES: &[(&str, &str)] = &[("everywhere", "parity"), ("endure", "endurance")];

fn main() -> ExitCode {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    match dispatch(&arguments) {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            eprintln!("error: {error:#}");
            ExitCode::FAILURE
        }
    }
}

fn dispatch(arguments: &[String]) -> Result<()> {
    let Some((name, rest)) = arguments.split_first() else {
        bail!("no command given\n\n{}", help());
    };
    if matches!(name.as_str(), "help" | "--help" | "-h") {
        println!("{}", help());
        return Ok(());
    }
    let name = current_name(name);
    match COMMANDS.iter().find(|command| command.name == name) {
        Some(command) => (command.run)(rest),
        None => bail!("unknown command `{name}`\n\n{}", help()),
    }
}

/// The present name of a command; a former one is accepted with a notice.
fn current_name(name: &str) -> &str {
    let Some((_, current)) = FORMER_NAMES.iter().find(|(former, _)| *former == name) else { return name };
    eprintln!("note: `{name}` is now called `{current}`; the old name goes with the next release");
    current
}

fn help() -> String {
    let mut text = String::from("usage: cargo xtask <command>\n");
    for command in COMMANDS {
        let _ = write!(text, "\n  {:<18}{}", command.name, command.about);
    }
    text
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn former_names_lead_to_commands() {
        for (former, current) in FORMER_NAMES {
            assert_eq!(current_name(former), *current);
            assert!(COMMANDS.iter().any(|command| command.name == *current));
            assert!(COMMANDS.iter().all(|command| command.name != *former));
        }
        assert_eq!(current_name("test"), "test");
    }
}

//! `cargo xtask fuzz [target] [--count N] [--from SEED]`: asks random questions and keeps a record of how far it got.

use std::collections::BTreeMap;
use std::io::{IsTerminal as _, Write as _};
use std::path::PathBuf;
use std::sync::Mutex;
use std::sync::atomic::{AtomicU64, Ordering::Relaxed};
use std::{env, fs, thread};

use anyhow::{Context as _, Result, bail, ensure};
use parkade_fuzz::{TARGETS, Target, catch_panics, parking, questions};
use serde_json::Value;

const USAGE: &str = "fuzz [TARGET...] [--count N (10000)] [--from SEED]\n\
    Without --from, each target goes on after the last seed that was asked. Targets:";
/// How many wrong answers are reported.
const ENOUGH: usize = 20;
/// Seeds between two records.
const CHUNK: u64 = 500;

fn main() -> Result<()> {
    let (mut count, mut from, mut targets) = (10_000, None, Vec::new());
    let mut arguments = env::args().skip(1);
    while let Some(argument) = arguments.next() {
        let mut number = || -> Result<u64> {
            let text =
                arguments.next().with_context(|| format!("{argument}: must be followed by a number"))?;
            text.parse().with_context(|| format!("{argument}: must be a whole number, got {text}"))
        };
        match argument.as_str() {
            "--count" => count = number()?,
            // What `cargo xtask parity` asks other engines.
            "--print" => return print(questions(number()?)),
            "--print-parking" => {
                let first = number()?;
                return print(parking(first..first + number()?));
            }
            "--from" => from = Some(number()?),
            name => match TARGETS.iter().find(|target| target.name == name) {
                Some(target) => targets.push(target),
                None => return help(name),
            },
        }
    }
    if targets.is_empty() {
        targets.extend(TARGETS);
    }
    catch_panics();
    let mut wrong = 0;
    for target in targets {
        wrong += ask(target, count, from)?;
    }
    ensure!(wrong == 0, "{wrong} answers are wrong");
    Ok(())
}

fn print(questions: impl Iterator<Item = Value>) -> Result<()> {
    let mut out = std::io::BufWriter::new(std::io::stdout().lock());
    for question in questions {
        writeln!(out, "{question}")?;
    }
    Ok(())
}

fn help(name: &str) -> Result<()> {
    println!("{USAGE}");
    for Target { name, about, .. } in TARGETS {
        println!("  {name:<14}{about}");
    }
    if name == "--help" { Ok(()) } else { bail!("{name}: no target or option") }
}

fn ask(target: &Target, count: u64, from: Option<u64>) -> Result<usize> {
    let record = record(target.name)?;
    let first = match from {
        Some(seed) => seed,
        None => fs::read_to_string(&record).ok().and_then(|text| text.trim().parse().ok()).unwrap_or(0),
    };
    let next = AtomicU64::new(first);
    let words = Mutex::new(BTreeMap::new());
    let wrong = Mutex::new(Vec::new());
    let work = || {
        loop {
            let seed = next.fetch_add(1, Relaxed);
            if seed >= first + count || wrong.lock().is_ok_and(|wrong| wrong.len() >= ENOUGH) {
                break;
            }
            match target.ask(seed) {
                Ok(word) => {
                    *words.lock().expect("no panics outside of targets").entry(word).or_insert(0_u64) += 1;
                }
                Err(what) => wrong.lock().expect("no panics outside of targets").push((seed, what)),
            }
            if (seed + 1 - first).is_multiple_of(CHUNK) {
                progress(target.name, seed + 1 - first, count);
                // Only what lies this far back is asked for certain.
                let sure = (seed + 1).saturating_sub(64).max(first);
                let _ = fs::write(&record, sure.to_string());
            }
        }
    };
    thread::scope(|scope| {
        for _ in 0..thread::available_parallelism().map_or(1, usize::from) {
            scope.spawn(work);
        }
    });
    let (words, wrong) = (words.into_inner()?, wrong.into_inner()?);
    let asked = words.values().sum::<u64>() + wrong.len() as u64;
    if wrong.is_empty() {
        fs::write(&record, (first + asked).to_string())?;
    }
    let list: Vec<String> = words.iter().map(|(word, number)| format!("{word} {number}")).collect();
    println!(
        "\r{}: seeds {first}..{}: {} wrong; {}",
        target.name,
        first + asked,
        wrong.len(),
        list.join(", ")
    );
    for (seed, what) in &wrong {
        println!("  {} --from {seed} --count 1: {what}", target.name);
    }
    Ok(wrong.len())
}

fn progress(name: &str, done: u64, count: u64) {
    if std::io::stdout().is_terminal() {
        let bar = "#".repeat((done * 40 / count.max(1)) as usize);
        print!("\r{name:<10}[{bar:<40}] {done}/{count}");
        let _ = std::io::stdout().flush();
    }
}

/// The file that says how far a target got.
fn record(name: &str) -> Result<PathBuf> {
    let folder = env::var_os("CARGO_TARGET_DIR")
        .map_or_else(|| PathBuf::from("target"), PathBuf::from)
        .join("fuzz-seeds");
    fs::create_dir_all(&folder).with_context(|| folder.display().to_string())?;
    Ok(folder.join(name))
}

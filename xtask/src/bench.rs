//! `cargo xtask bench grid`: our grid planners against others, in one run; `bench parking`: hybrid A* on public cases,
//! natively and in WebAssembly, beside the best known; `bench tight`: how tight it can be, drawn into the
//! documentation; `bench kerb`: the package in kerb slots by seed; `bench judge`: the trajectories of all planners
//! before the referee; `bench batch`: the command over generated scenes, on two threads and on one.

use std::path::{Path, PathBuf};
use std::process::Command;
use std::{env, fs};

use anyhow::{Context as _, Result, bail};

use crate::site;
use crate::tools::{WASM_TARGET, Workspace, capture, cargo, node, npm, root, run};

/// Packages to compare with; installed into a temporary folder, no part of the product.
const PEERS: &[&str] = &["pathfinding@0.4.18", "ngraph.graph@20.1.2", "ngraph.path@1.6.1"];

/// Scenes of each size in `bench tight`: a percentage in steps of five.
const TIGHT_SCENES: &str = "20";
/// Every so-many-th size is checked: a prime, so that no row or column is left out.
const TIGHT_SAMPLE: &str = "13";

/// Prints figures with their floors and goals; never fails on slow ones, which say as much of the machine.
pub(crate) fn bench(arguments: &[String]) -> Result<()> {
    let data = env::var_os("PARKADE_DATA").map_or_else(|| root().join("../shared/data"), PathBuf::from);
    match arguments {
        [what, sizes @ ..] if what == "grid" && sizes.len() <= 3 => grid(&data, sizes),
        [what] if what == "parking" => parking(&data),
        [what] if what == "tight" => tight(false),
        [what, mode] if what == "tight" && mode == "check" => tight(true),
        [what, numbers @ ..] if what == "kerb" && numbers.len() <= 2 => kerb(numbers),
        [what] if what == "batch" => batch(),
        [what] if what == "judge" => judge(&data),
        _ => bail!(
            "there are `bench grid [questions] [repeats] [goals, as G6,G8]`, `bench parking`, `bench tight [check]`, \
             `bench kerb [count] [first seed]`, `bench judge` and `bench batch`"
        ),
    }
}

/// Hybrid A* natively and in WebAssembly, written to `benches/PARKING.md`; without the public cases, on the built-in
/// scenes alone.
fn parking(data: &Path) -> Result<()> {
    site::assemble()?;
    run(cargo().args(["build", "--release", "--locked", "--example", "tpcap", "--example", "goals"]))?;
    let examples = Workspace::load()?.target.join("release/examples");
    let (native, file) = (examples.join("tpcap"), examples.join("tpcap-results.json"));
    let results = capture(Command::new(&native).arg("json").env("PARKADE_DATA", data))?;
    fs::write(&file, results).with_context(|| file.display().to_string())?;
    let hopeless = examples.join("goals-results.md");
    let said = capture(Command::new(examples.join("goals")).env("PARKADE_DATA", data))?;
    fs::write(&hopeless, said).with_context(|| hopeless.display().to_string())?;
    run(node().arg("tests/bench/parking.mjs").args([&file, &native, &hopeless]).env("PARKADE_DATA", data))
}

/// The referee's leaderboard of all planners, written to `benches/TRAJECTORIES.md`; without the public cases, of the
/// built-in scenes.
fn judge(data: &Path) -> Result<()> {
    run(cargo().args(["build", "--release", "--locked", "--example", "trajectories"]))?;
    let example = Workspace::load()?.target.join("release/examples/trajectories");
    let tables = capture(Command::new(example).env("PARKADE_DATA", data))?;
    let file = root().join("benches/TRAJECTORIES.md");
    fs::write(&file, tables).with_context(|| file.display().to_string())
}

/// Slots and corners over their sizes, drawn and written into `docs/`; with `is_check`, every so-many-th size is
/// planned again and held against what is drawn.
fn tight(is_check: bool) -> Result<()> {
    run(cargo().args(["build", "--release", "--locked", "--example", "tight"]))?;
    let examples = Workspace::load()?.target.join("release/examples");
    let (count, every) = (TIGHT_SCENES, if is_check { TIGHT_SAMPLE } else { "1" });
    let results = capture(Command::new(examples.join("tight")).args(["json", count, every]))?;
    let file = examples.join("tight-results.json");
    fs::write(&file, results).with_context(|| file.display().to_string())?;
    run(node().arg("tests/bench/tight.mjs").arg(&file).args(is_check.then_some("check")))
}

/// How long the package takes over kerb slots that the sedan enters with 3 cm of margin.
fn kerb(numbers: &[String]) -> Result<()> {
    site::package()?;
    run(cargo().args(["build", "--release", "--locked", "--example", "tight"]))?;
    let examples = Workspace::load()?.target.join("release/examples");
    let scenes = capture(Command::new(examples.join("tight")).arg("scenes").args(numbers))?;
    let file = examples.join("kerb-scenes.jsonl");
    fs::write(&file, scenes).with_context(|| file.display().to_string())?;
    run(node().arg("tests/bench/kerb.mjs").arg(&file))
}

/// `parkade batch` with two jobs against one.
fn batch() -> Result<()> {
    site::package()?;
    run(node().arg("tests/bench/batch.mjs"))
}

fn grid(data: &Path, sizes: &[String]) -> Result<()> {
    let maps = data.join("movingai");
    if !maps.join("Berlin_0_256.map").exists() {
        println!(
            "skipped: no MovingAI maps in {}; put the .map and .map.scen files of movingai.com/benchmarks there, \
             or name another folder in PARKADE_DATA",
            maps.display()
        );
        return Ok(());
    }
    site::assemble()?;
    run(cargo().args(["build", "--release", "--locked", "--example", "movingai"]))?;
    let native = Workspace::load()?.target.join("release/examples/movingai");
    let peers = peers()?;
    run(node()
        .args(["--expose-gc", "--max-old-space-size=6000", "tests/bench/grid.mjs"])
        .args([&maps, &peers, &native])
        .args(sizes))
}

/// The folder with the installed peers.
fn peers() -> Result<PathBuf> {
    let folder = env::temp_dir().join("parkade-bench-peers");
    let sources = root().join("tests/bench/peers_rs");
    fs::create_dir_all(folder.join("src")).with_context(|| folder.display().to_string())?;
    fs::write(folder.join("package.json"), r#"{ "private": true }"#)?;
    for name in ["Cargo.toml", "src/lib.rs"] {
        fs::copy(sources.join(name), folder.join(name))?;
    }
    run(npm().args(["install", "--no-audit", "--no-fund"]).args(PEERS).current_dir(&folder))?;
    let target = folder.join("target");
    run(cargo()
        .args(["build", "--release", "--lib", "--target", WASM_TARGET])
        .current_dir(&folder)
        .env("CARGO_TARGET_DIR", &target))?;
    let wasm = target.join(WASM_TARGET).join("release/grid_peers.wasm");
    fs::copy(wasm, folder.join("grid_peers.wasm"))?;
    Ok(folder)
}

//! `cargo xtask build`: the npm package in `pkg/`, the page in `dist/`, and their sizes.

use std::collections::{BTreeMap, BTreeSet};
use std::path::{Path, PathBuf};
use std::{env, fs};

use anyhow::{Context as _, Result, ensure};

use crate::tools::{self, WASM_TARGET, Workspace, capture, cargo, node, node_tool, root, run};

/// Bytes after gzip: what a visitor downloads.
const CORE_LIMIT: u64 = 200_000;
const COMPLETE_LIMIT: u64 = 690_000;
const PAGE_LIMIT: u64 = 80_000;
const LATER_LIMIT: u64 = 318_000;
const LOADER_LIMIT: u64 = 6_000;

/// Prints, as a JSON array, the gzip sizes of the files named after it.
const GZIP_SIZES: &str = "const { readFileSync } = require('node:fs'); const { gzipSync } = require('node:zlib'); \
    console.log(JSON.stringify(process.argv.slice(1).map((file) => gzipSync(readFileSync(file), { level: 9 \
    }).length)))";

/// The chunks behind the first picture: the page, and the planners it loads at once.
const FIRST_CHUNKS: [&str; 2] = ["index.html", "src/planning/engine-core.ts"];

/// What other people's pages load.
const LOADER: &str = "parkade-playground.js";

const WASM_FILE: &str = "parkade_bg.wasm";

/// Level 2 with this threshold is smaller than level 3 with 50 and 225, and runs the searches no slower.
const COMPLETE_FLAGS: &[&str] = &["-C", "opt-level=2", "-C", "llvm-args=--inline-threshold=120"];
/// The first download shall be small; it plans for a few seconds only, until the complete module is there.
const CORE_FLAGS: &[&str] = &["-C", "opt-level=s", "-C", "llvm-args=--inline-threshold=5"];
/// Constants that are added to an address become part of the access. That asks for a first kilobyte of memory without
/// data: the stack lies there, and ends with a trap when it is full.
const ADDRESSES: &[&str] = &["--low-memory-unused", "--optimize-added-constants-propagate"];
/// The complete module shall be fast, …
const COMPLETE_AIMS: &[&str] = &["--gufa", "-O3"];
/// … and the first download small. Of functions with one caller only those of up to so many instructions become part
/// of it: large ones pack better on their own, and are no slower. Those so small that a call is no shorter become part
/// of every caller. Loops and branches that are made anew from the graph of the flow are shorter, and no slower.
const CORE_AIMS: &[&str] = &[
    "--one-caller-inline-max-function-size=375",
    "--always-inline-max-function-size=5",
    "-O3",
    "--flatten",
    "--rereloop",
    "-Oz",
    "--gufa",
    "-Oz",
];
/// Lets the compiler use WebAssembly's vectors, which the package does without.
const VECTORS: &[&str] = &["-C", "target-feature=+simd128"];

/// What stands in the package's manifest for the crate's version.
const NO_VERSION: &str = r#""version": "0.0.0""#;

/// The folder of the package for the module without the cargo feature `complete`: the page's first download.
const CORE: &str = "core";
/// Copied into the package as they are, and into its folder [`CORE`].
const PACKAGE_SOURCES: &[&str] = &["index.js", "node.js", "api.js", "cells.js", "runtime.js"];
/// What the complete module has beyond `core`; `core` has a file of that name in its own folder, which is empty.
const COMPLETE_SOURCE: &str = "complete.js";
/// What that file takes from others.
const COMPLETE_PARTS: &[&str] = &["audit.js", "columns.js", "drive.js", "occupancy.js", "picture.js"];
/// The entry that has the complete module within.
const INLINE_SOURCE: &str = "inline.js";
/// Writes a file's bytes as text into a module.
const TO_TEXT: &str = "const { readFileSync, writeFileSync } = require('node:fs'); const [from, to] = \
    process.argv.slice(1); \
    writeFileSync(to, `export const base64 = \"${readFileSync(from).toString('base64')}\";\n`)";
/// The types of `index.d.ts`, by family.
const TYPES: &str = "types";
/// Types of the entry for site plans.
const SITE_PLAN_TYPES: &str = "siteplan.d.ts";
/// The folder of the command `parkade`.
const COMMAND: &str = "cli";
/// Types of the element, whose script is the page's.
const ELEMENT_TYPES: &str = "element.d.ts";
/// Types of the element for frameworks.
const ELEMENT_FRAMEWORKS: &str = "element";
/// The package's planners in workers.
const WORKER: &str = "worker";
const PACKAGE_PAPERS: &[&str] = &["README.md", "CHANGELOG.md", "LICENSE-MIT", "LICENSE-APACHE"];
/// The scenes' JSON Schema, published with the package and beside the page.
const SCHEMA: &str = "scenario.schema.json";

pub(crate) fn build(arguments: &[String]) -> Result<()> {
    ensure!(arguments.is_empty(), "`build` takes no arguments");
    assemble()?;
    check_sizes()
}

/// Builds the package and the page.
pub(crate) fn assemble() -> Result<()> {
    package()?;
    if root().join("www/index.html").exists() {
        run(node_tool("vite/bin/vite.js").arg("build"))?;
        copy(&root().join("src/scenario").join(SCHEMA), &root().join("dist").join(SCHEMA))?;
    }
    Ok(())
}

/// Builds the package alone.
pub(crate) fn package() -> Result<()> {
    tools::check_node()?;
    tools::ensure_wasm_target()?;
    tools::ensure_node_modules()?;
    build_package(&Workspace::load()?)
}

/// Prints what visitors download; too much of it is an error.
pub(crate) fn check_sizes() -> Result<()> {
    let package = root().join("pkg");
    let mut fits = vec![
        report("wasm, core", &[package.join(CORE).join(WASM_FILE)], CORE_LIMIT)?,
        report("wasm, complete", &[package.join(WASM_FILE)], COMPLETE_LIMIT)?,
    ];
    let site = root().join("dist");
    if site.exists() {
        let (first, later) = page_files(&site)?;
        fits.push(report("page, to the first picture", &first, PAGE_LIMIT)?);
        fits.push(report("page, later", &later, LATER_LIMIT)?);
        fits.push(report("embedded, before it is near", &[site.join(LOADER)], LOADER_LIMIT)?);
    }
    ensure!(fits.into_iter().all(|fits| fits), "the build is larger than its limit");
    Ok(())
}

/// The package once more, compiled to vector instructions: its folder.
pub(crate) fn vectorised() -> Result<PathBuf> {
    let workspace = Workspace::load()?;
    let package = workspace.target.join("vectorised");
    copy_folder(&root().join("pkg"), &package)?;
    build_module(&workspace, &package, &[], &[COMPLETE_FLAGS, VECTORS].concat())?;
    Ok(package)
}

fn build_package(workspace: &Workspace) -> Result<()> {
    let package = root().join("pkg");
    if package.exists() {
        fs::remove_dir_all(&package).with_context(|| format!("cannot clear {}", package.display()))?;
    }
    let sources = root().join("packages/parkade");
    build_module(workspace, &package.join(CORE), &["--no-default-features"], CORE_FLAGS)?;
    copy(&sources.join(CORE).join(COMPLETE_SOURCE), &package.join(CORE).join(COMPLETE_SOURCE))?;
    build_module(workspace, &package, &[], COMPLETE_FLAGS)?;
    for name in [COMPLETE_SOURCE].iter().chain(COMPLETE_PARTS) {
        copy(&sources.join(name), &package.join(name))?;
    }
    copy_folder(&sources.join(COMMAND), &package.join(COMMAND))?;
    copy_folder(&sources.join(WORKER), &package.join(WORKER))?;
    copy(&sources.join(INLINE_SOURCE), &package.join(INLINE_SOURCE))?;
    run(node().args(["-e", TO_TEXT, "--"]).arg(package.join(WASM_FILE)).arg(package.join("bytes.js")))?;
    copy(&root().join("src/scenario").join(SCHEMA), &package.join(SCHEMA))?;
    for name in PACKAGE_PAPERS {
        copy(&root().join(name), &package.join(name))?;
    }
    // The page's drawing and its reader of site plans, for programs without a page.
    for config in ["vite.picture.config.ts", "vite.siteplan.config.ts"] {
        run(node_tool("vite/bin/vite.js").args(["build", "--config", config]))?;
    }
    copy(&sources.join(SITE_PLAN_TYPES), &package.join(SITE_PLAN_TYPES))?;
    write_types(&sources, &package)?;
    let editors = root().join("xtask/element-manifest.mjs");
    run(node().arg(editors).arg(sources.join(ELEMENT_TYPES)).arg(&package).arg(&workspace.version))?;
    write_manifest(&workspace.version, &package)?;
    // Last, as it bundles what is there.
    run(node_tool("vite/bin/vite.js").args(["build", "--config", "vite.require.config.ts"]))
}

/// Compiles the module with these arguments for cargo and rustc, and puts it, its glue and the API's sources into
/// `folder`.
fn build_module(workspace: &Workspace, folder: &Path, features: &[&str], flags: &[&str]) -> Result<()> {
    let build =
        ["rustc", "--release", "--locked", "--lib", "--crate-type", "cdylib", "--target", WASM_TARGET];
    run(cargo().args(remapped_sources()).args(build).args(features).arg("--").args(flags))?;
    let compiled = workspace.target.join(WASM_TARGET).join("release/parkade.wasm");
    fs::create_dir_all(folder)?;
    bind(&compiled, folder)?;
    let wasm = folder.join(WASM_FILE);
    let aims = if features.is_empty() { COMPLETE_AIMS } else { CORE_AIMS };
    run(node_tool("binaryen/bin/wasm-opt").args(ADDRESSES).args(aims).arg(&wasm).arg("-o").arg(&wasm))?;
    for name in PACKAGE_SOURCES {
        copy(&root().join("packages/parkade").join(name), &folder.join(name))?;
    }
    Ok(())
}

/// The option that names the sources of dependencies alike on every machine. Messages of panics name them, so the
/// module's size would depend on where the machine keeps them.
fn remapped_sources() -> Option<String> {
    let home =
        env::var_os("CARGO_HOME").map(PathBuf::from).or_else(|| Some(env::home_dir()?.join(".cargo")))?;
    let folders = fs::read_dir(home.join("registry/src")).ok()?;
    let flags: Vec<String> = folders
        .filter_map(|folder| Some(format!("'--remap-path-prefix={}=crates'", folder.ok()?.path().display())))
        .collect();
    Some(format!("--config=target.{WASM_TARGET}.rustflags=[{}]", flags.join(",")))
}

/// Writes the JavaScript glue and the `.wasm` file that belongs to it.
fn bind(compiled: &Path, package: &Path) -> Result<()> {
    let options =
        ["--target", "web", "--no-typescript", "--remove-name-section", "--remove-producers-section"];
    let arguments = std::iter::once("wasm-bindgen".into()).chain(options.map(Into::into)).chain([
        "--out-dir".into(),
        package.as_os_str().to_owned(),
        compiled.as_os_str().to_owned(),
    ]);
    wasm_bindgen_cli::wasm_bindgen::run_cli_with_args::<_, std::ffi::OsString>(arguments)
        .context("wasm-bindgen")
}

/// Derives the settings' types from each module's registry, into the sources, and copies all types; `require` needs its
/// own.
fn write_types(sources: &Path, package: &Path) -> Result<()> {
    copy(&sources.join(ELEMENT_TYPES), &package.join(ELEMENT_TYPES))?;
    copy_folder(&sources.join(ELEMENT_FRAMEWORKS), &package.join(ELEMENT_FRAMEWORKS))?;
    for folder in ["", CORE] {
        let module = package.join(folder).join("node.js");
        let settings = capture(node().arg(root().join("xtask/settings-types.mjs")).arg(module))?;
        fs::write(sources.join(folder).join("settings.d.ts"), settings).context("settings.d.ts")?;
        for name in ["index.d.ts", "settings.d.ts"] {
            copy(&sources.join(folder).join(name), &package.join(folder).join(name))?;
        }
    }
    copy_folder(&sources.join(TYPES), &package.join(TYPES))?;
    for name in ["index.d.ts", "settings.d.ts"] {
        write_required(&package.join(name))?;
    }
    for file in fs::read_dir(sources.join(TYPES))? {
        write_required(&package.join(TYPES).join(file?.file_name()))?;
    }
    Ok(())
}

/// Writes a file of types for `require` beside the one for `import`.
fn write_required(types: &Path) -> Result<()> {
    let text = fs::read_to_string(types).with_context(|| types.display().to_string())?;
    Ok(fs::write(types.with_extension("cts"), text.replace(".js\"", ".cjs\""))?)
}

/// Writes the package's manifest: the one beside its sources, with the crate's version.
fn write_manifest(version: &str, package: &Path) -> Result<()> {
    let template = root().join("packages/parkade/package.json");
    let text = fs::read_to_string(&template).with_context(|| template.display().to_string())?;
    ensure!(text.contains(NO_VERSION), "{}: must hold {NO_VERSION}", template.display());
    let text = text.replacen(NO_VERSION, &format!("\"version\": \"{version}\""), 1);
    fs::write(package.join("package.json"), text).context("pkg/package.json")
}

fn copy(from: &Path, to: &Path) -> Result<()> {
    fs::copy(from, to).with_context(|| format!("cannot copy {} to {}", from.display(), to.display()))?;
    Ok(())
}

/// Copies the files of a folder that has no folders.
fn copy_folder(from: &Path, to: &Path) -> Result<()> {
    fs::create_dir_all(to)?;
    for entry in fs::read_dir(from).with_context(|| from.display().to_string())? {
        let entry = entry?;
        let target = to.join(entry.file_name());
        if entry.file_type()?.is_dir() {
            copy_folder(&entry.path(), &target)?;
        } else {
            copy(&entry.path(), &target)?;
        }
    }
    Ok(())
}

/// What stands in Vite's manifest for one of its chunks.
#[derive(serde::Deserialize)]
#[serde(rename_all = "camelCase", default)]
#[derive(Default)]
struct Chunk {
    file: String,
    imports: Vec<String>,
    css: Vec<String>,
}

/// Scripts, styles and documents of the page: those that its first picture needs, and the rest.
fn page_files(site: &Path) -> Result<(Vec<PathBuf>, Vec<PathBuf>)> {
    let manifest = fs::read_to_string(site.join(".vite/manifest.json")).context("the page's manifest")?;
    let chunks: BTreeMap<String, Chunk> = serde_json::from_str(&manifest)?;
    let mut first = BTreeSet::from([site.join("index.html")]);
    let mut open = FIRST_CHUNKS.map(str::to_owned).to_vec();
    while let Some(name) = open.pop() {
        let chunk = chunks.get(&name).with_context(|| format!("the page has no chunk {name}"))?;
        if first.insert(site.join(&chunk.file)) {
            first.extend(chunk.css.iter().map(|css| site.join(css)));
            open.extend(chunk.imports.iter().cloned());
        }
    }
    let mut all = Vec::new();
    list_page_files(site, &mut all)?;
    let later = all.into_iter().filter(|file| !first.contains(file)).collect();
    Ok((first.into_iter().collect(), later))
}

/// Scripts, styles and documents below `folder`.
fn list_page_files(folder: &Path, files: &mut Vec<PathBuf>) -> Result<()> {
    for entry in fs::read_dir(folder)? {
        let path = entry?.path();
        if path.is_dir() {
            list_page_files(&path, files)?;
        } else if path.extension().is_some_and(|kind| kind == "js" || kind == "css" || kind == "html") {
            files.push(path);
        }
    }
    Ok(())
}

/// Prints one line of sizes; returns whether they keep the limit.
fn report(name: &str, files: &[PathBuf], limit: u64) -> Result<bool> {
    let mut raw = 0;
    for file in files {
        raw += file.metadata().with_context(|| file.display().to_string())?.len();
    }
    let sizes = capture(node().args(["-e", GZIP_SIZES, "--"]).args(files))?;
    let gzip: u64 = serde_json::from_str::<Vec<u64>>(&sizes)?.iter().sum();
    let verdict = if gzip <= limit { "ok" } else { "TOO LARGE" };
    println!(
        "{name}: {} kB, {} kB with gzip; limit {} kB: {verdict}",
        kilobytes(raw),
        kilobytes(gzip),
        kilobytes(limit)
    );
    Ok(gzip <= limit)
}

/// One decimal, rounded up, so that no size over a limit reads like the limit.
fn kilobytes(bytes: u64) -> String {
    let tenths = bytes.div_ceil(100);
    format!("{}.{}", tenths / 10, tenths % 10)
}

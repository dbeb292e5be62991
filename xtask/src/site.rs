//! `cargo xtask build`: the npm package in `pkg/`, the page in `dist/`, and their sizes.

use std::fs;
use std::path::{Path, PathBuf};

use anyhow::{Context as _, Result, ensure};

use crate::tools::{self, WASM_TARGET, Workspace, capture, cargo, node, node_tool, root, run};

/// Bytes after gzip: what a visitor downloads.
const WASM_LIMIT: u64 = 200_000;
const PAGE_LIMIT: u64 = 80_000;

/// Prints, as a JSON array, the gzip sizes of the files named after it.
const GZIP_SIZES: &str = "const { readFileSync } = require('node:fs'); const { gzipSync } = require('node:zlib'); \
    console.log(JSON.stringify(process.argv.slice(1).map((file) => gzipSync(readFileSync(file), { level: 9 }).length)))";

const WASM_FILE: &str = "parkade_bg.wasm";

/// What stands in the package's manifest for the crate's version.
const NO_VERSION: &str = r#""version": "0.0.0""#;

/// Copied into the package as they are.
const PACKAGE_SOURCES: &[&str] = &["index.js", "node.js", "api.js", "core.js", "index.d.ts"];
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
    tools::check_node()?;
    tools::ensure_wasm_target()?;
    tools::ensure_node_modules()?;
    build_package(&Workspace::load()?)?;
    if root().join("www/index.html").exists() {
        run(node_tool("vite/bin/vite.js").arg("build"))?;
        copy(&root().join("src/scenario").join(SCHEMA), &root().join("dist").join(SCHEMA))?;
    }
    Ok(())
}

/// Prints what visitors download; too much of it is an error.
pub(crate) fn check_sizes() -> Result<()> {
    let wasm = [root().join("pkg").join(WASM_FILE)];
    let mut page = Vec::new();
    if root().join("dist").exists() {
        list_page_files(&root().join("dist"), &mut page)?;
    }
    println!();
    let wasm_fits = report("wasm", &wasm, WASM_LIMIT)?;
    let page_fits = report("page", &page, PAGE_LIMIT)?;
    ensure!(wasm_fits && page_fits, "the build is larger than its limit");
    Ok(())
}

fn build_package(workspace: &Workspace) -> Result<()> {
    run(cargo().args(["build", "--release", "--locked", "--lib", "--target", WASM_TARGET]))?;
    let compiled = workspace.target.join(WASM_TARGET).join("release/parkade.wasm");
    let package = root().join("pkg");
    if package.exists() {
        fs::remove_dir_all(&package).with_context(|| format!("cannot clear {}", package.display()))?;
    }
    fs::create_dir_all(&package)?;
    bind(&compiled, &package)?;
    let wasm = package.join(WASM_FILE);
    run(node_tool("binaryen/bin/wasm-opt").args(["-O3", "-Oz"]).arg(&wasm).arg("-o").arg(&wasm))?;
    for name in PACKAGE_SOURCES {
        copy(&root().join("src/wasm/npm").join(name), &package.join(name))?;
    }
    copy(&root().join("src/scenario").join(SCHEMA), &package.join(SCHEMA))?;
    for name in PACKAGE_PAPERS {
        copy(&root().join(name), &package.join(name))?;
    }
    write_manifest(&workspace.version, &package)
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

/// Writes the package's manifest: the one beside its sources, with the crate's version.
fn write_manifest(version: &str, package: &Path) -> Result<()> {
    let template = root().join("src/wasm/npm/package.json");
    let text = fs::read_to_string(&template).with_context(|| template.display().to_string())?;
    ensure!(text.contains(NO_VERSION), "{}: must hold {NO_VERSION}", template.display());
    let text = text.replacen(NO_VERSION, &format!("\"version\": \"{version}\""), 1);
    fs::write(package.join("package.json"), text).context("pkg/package.json")
}

fn copy(from: &Path, to: &Path) -> Result<()> {
    fs::copy(from, to).with_context(|| format!("cannot copy {} to {}", from.display(), to.display()))?;
    Ok(())
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

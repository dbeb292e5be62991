//! `cargo xtask docs`: the documentation site in `docs/.vitepress/dist/`, around the package and the page as built.

use std::fs;
use std::path::{Path, PathBuf};

use anyhow::{Result, ensure};

use crate::site;
use crate::tools::{cargo_tool, command, node_tool, root, run};

/// Makes the example book; nothing else needs it, so it is installed beside what is built.
const MDBOOK: &str = "0.5.4";

pub(crate) fn docs(arguments: &[String]) -> Result<()> {
    ensure!(arguments.is_empty(), "`docs` takes no arguments");
    site::assemble()?;
    generate()?;
    println!("\ndocs/.vitepress/dist: put it beside the page, as the folder docs");
    Ok(())
}

/// Builds the site, and the example book around the page, from a package and a page that are there. A dead link is an
/// error.
pub(crate) fn generate() -> Result<()> {
    run(node_tool("vitepress/bin/vitepress.js").args(["build", "docs"]))?;
    book()
}

/// The program that makes books. Three pages are made with it: it compiles twice as fast without optimisation, and in
/// three quarters of that time without what a debugger reads.
pub(crate) fn mdbook() -> Result<PathBuf> {
    cargo_tool("mdbook", MDBOOK, &["--no-default-features", "--debug", "--config", "profile.dev.debug=false"])
}

fn book() -> Result<()> {
    let program = mdbook()?;
    let example = root().join("examples/mdbook");
    let page = example.join("src/parkade");
    if page.exists() {
        fs::remove_dir_all(&page)?;
    }
    copy_folder(&root().join("dist"), &page)?;
    run(command(program).arg("build").arg(example))
}

fn copy_folder(from: &Path, to: &Path) -> Result<()> {
    fs::create_dir_all(to)?;
    for entry in fs::read_dir(from)? {
        let entry = entry?;
        let (path, target) = (entry.path(), to.join(entry.file_name()));
        if path.is_dir() { copy_folder(&path, &target)? } else { fs::copy(&path, &target).map(drop)? }
    }
    Ok(())
}

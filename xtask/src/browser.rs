//! A browser for the page's tests: the one that is there, or one installed now.

use std::path::Path;

use anyhow::{Result, bail};

use crate::tools::{capture, command, node, node_tool, run};

const REMEDY: &str = "no browser for the page's tests: install Chromium or Google Chrome, \
                      or name one in the environment variable CHROME_PATH";

/// The path of a Chromium or Chrome. Installs one if there is none.
pub(crate) fn find_or_install() -> Result<String> {
    if let Some(path) = find()? {
        return Ok(path);
    }
    for install in [install_with_playwright, install_with_apt] {
        if let Err(error) = install() {
            eprintln!("{error:#}");
        }
        if let Some(path) = find()? {
            return Ok(path);
        }
    }
    bail!(REMEDY)
}

fn find() -> Result<Option<String>> {
    let path = capture(node().arg("tests/e2e/browser.js"))?;
    Ok(Some(path.trim().to_owned()).filter(|path| !path.is_empty()))
}

fn install_with_playwright() -> Result<()> {
    run(node_tool("@playwright/test/cli.js").args(["install", "--only-shell", "chromium"]))
}

/// A Chromium without a user interface: the tests take a third less processor time. Old releases of Debian have none.
const SHELL: &str = "chromium-headless-shell";

/// Debian and its relatives, as root only.
fn install_with_apt() -> Result<()> {
    let is_root = || capture(command("id").arg("-u")).is_ok_and(|user| user.trim() == "0");
    if !Path::new("/usr/bin/apt-get").exists() || !is_root() {
        return Ok(());
    }
    let apt = |arguments: &[&str]| {
        let mut apt = command("apt-get");
        apt.args(["-o", "DPkg::Lock::Timeout=600"]).args(arguments);
        run(apt.env("DEBIAN_FRONTEND", "noninteractive"))
    };
    let install = |package| apt(&["install", "-y", "--no-install-recommends", package]);
    install(SHELL)
        .or_else(|_| apt(&["update"]).and_then(|()| install(SHELL)))
        .or_else(|_| install("chromium"))
}

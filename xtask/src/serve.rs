//! `cargo xtask serve`: the built page on this machine.

use anyhow::{Result, ensure};

use crate::{site, tools};

const PORT: &str = "4173";

pub(crate) fn serve(arguments: &[String]) -> Result<()> {
    ensure!(arguments.is_empty(), "`serve` takes no arguments");
    site::build(&[])?;
    println!("\nhttp://127.0.0.1:{PORT}/ (Ctrl+C ends it)");
    tools::run(tools::node_tool("vite/bin/vite.js").args([
        "preview",
        "--host",
        "127.0.0.1",
        "--port",
        PORT,
        "--strictPort",
    ]))
}

//! The wheel: its lints and tests, where there is a Python for them, and `cargo xtask wheel`.

use std::path::PathBuf;
use std::process::Command;
use std::{env, fs};

use anyhow::{Context as _, Result};

use crate::tools::{Workspace, cargo, command, linting, node, node_tool, root, run};
use crate::{browser, site};

/// The oldest Python that the wheel runs in: major, minor.
const OLDEST: (u32, u32) = (3, 10);
const MANIFEST: &str = "python/Cargo.toml";
/// What is installed into the tests' environment, versions pinned.
const REQUIREMENTS: &str = "python/requirements-test.txt";

/// Python's programs in an environment below `target/`.
pub(crate) struct Environment {
    folder: PathBuf,
    target: PathBuf,
}

impl Environment {
    /// The environment, made and filled where it is not; the reason where that cannot be done here.
    pub(crate) fn ready() -> Result<Result<Self, String>> {
        let oldest = format!("{}.{}", OLDEST.0, OLDEST.1);
        let Some(python) = interpreter() else {
            return Ok(Err(format!("no Python {oldest} or newer was found")));
        };
        let target = Workspace::load()?.target;
        let environment = Self { folder: target.join("python-environment"), target: target.join("python") };
        let wanted = fs::read_to_string(root().join(REQUIREMENTS)).context(REQUIREMENTS)?;
        let record = environment.folder.join("installed.txt");
        if fs::read_to_string(&record).is_ok_and(|installed| installed == wanted) {
            return Ok(Ok(environment));
        }
        let installed = run(command(&python).args(["-m", "venv", "--clear"]).arg(&environment.folder))
            .and_then(|()| {
                run(environment.program("python").args([
                    "-m",
                    "pip",
                    "install",
                    "--quiet",
                    "--requirement",
                    REQUIREMENTS,
                ]))
            });
        if let Err(error) = installed {
            return Ok(Err(format!("{REQUIREMENTS} cannot be installed: {error:#}")));
        }
        fs::write(&record, wanted).with_context(|| record.display().to_string())?;
        Ok(Ok(environment))
    }

    /// One of its programs, run in `python/`.
    pub(crate) fn program(&self, name: &str) -> Command {
        let programs = self.folder.join(if cfg!(windows) { "Scripts" } else { "bin" });
        let mut command = command(programs.join(format!("{name}{}", env::consts::EXE_SUFFIX)));
        let others = env::var_os("PATH").unwrap_or_default();
        let path = env::join_paths([programs].into_iter().chain(env::split_paths(&others))).unwrap_or(others);
        command.env("VIRTUAL_ENV", &self.folder).env("PATH", path).env("CARGO_TARGET_DIR", &self.target);
        command.env_remove("PYTHONHOME").env_remove("PYTHONPATH");
        command
    }
}

/// The playground for notebooks, in the package's folder; the npm package must be there.
pub(crate) fn playground() -> Result<()> {
    let made = root().join("python/parkade/static");
    if made.exists() {
        fs::remove_dir_all(&made)?;
    }
    for script in ["page", "worker"] {
        let build = ["build", "--logLevel", "warn", "--config", "vite.widget.config.ts", "--mode", script];
        run(node_tool("vite/bin/vite.js").args(build))?;
    }
    let module = "parkade_bg.wasm";
    fs::copy(root().join("pkg").join(module), made.join(module)).map(|_| ()).context(module)
}

/// `cargo xtask wheel`: the wheel of this machine, in `target/wheels`.
pub(crate) fn wheel(arguments: &[String]) -> Result<()> {
    let environment = Environment::ready()?.map_err(anyhow::Error::msg)?;
    site::package()?;
    playground()?;
    let out = Workspace::load()?.target.join("wheels");
    let build = ["build", "--release", "--locked", "--manifest-path", MANIFEST, "--out"];
    run(environment.program("maturin").args(build).arg(out).args(arguments))
}

/// `cargo xtask notebooks`: the widget in two kinds of notebook, driven by a browser; pictures into a folder if named.
pub(crate) fn notebooks(pictures: &[String]) -> Result<()> {
    let environment = Environment::ready()?.map_err(anyhow::Error::msg)?;
    site::package()?;
    playground()?;
    install(&environment)?;
    let servers = ["-m", "pip", "install", "--quiet", "--requirement", "python/requirements-notebooks.txt"];
    run(environment.program("python").args(servers))?;
    let mut drive = node();
    drive.arg("tests/notebooks/notebooks.mjs").arg(&environment.folder).args(pictures);
    run(drive.env("CHROME_PATH", browser::find_or_install()?))
}

/// Format of the wheel's Rust.
pub(crate) fn check_format() -> Result<()> {
    run(cargo().args(["fmt", "--manifest-path", MANIFEST, "--check"]))
}

/// Lints of the wheel's Rust where there is no Python for its tests, which are built with lints.
pub(crate) fn lint_native() -> Result<()> {
    let mut clippy = cargo();
    clippy.args(["clippy", "--locked", "--manifest-path", MANIFEST, "--", "-D", "warnings"]);
    run(clippy.env("CARGO_TARGET_DIR", Workspace::load()?.target.join("python")))
}

/// Format, lints and types of the wheel's Python.
pub(crate) fn lint(environment: &Environment) -> Result<()> {
    run(environment.program("ruff").args(["format", "--check", "python"]))?;
    run(environment.program("ruff").args(["check", "python"]))?;
    run(environment.program("mypy").args(["--config-file", "python/pyproject.toml", "python/parkade"]))
}

/// Installs the wheel as the tests use it: linted, built fast, and with the optimiser's help where plans take time.
pub(crate) fn install(environment: &Environment) -> Result<()> {
    let develop = ["develop", "--locked", "--profile", "tested", "--manifest-path", MANIFEST];
    run(linting(environment.program("maturin").args(develop)))
}

/// Pytest's command; its last lines name what failed and count.
pub(crate) fn pytest(environment: &Environment) -> Command {
    let mut command = environment.program("pytest");
    command.args([
        "-q",
        "-rf",
        "--no-header",
        "--color=no",
        "--config-file",
        "python/pyproject.toml",
        "python/tests",
    ]);
    command
}

fn interpreter() -> Option<PathBuf> {
    let program = "import sys; print(sys.version_info[0], sys.version_info[1], sys.executable)";
    ["python3", "python"].into_iter().find_map(|name| {
        let output = Command::new(name).args(["-c", program]).output().ok()?;
        let text = String::from_utf8(output.stdout).ok()?;
        let mut words = text.trim().splitn(3, ' ');
        let version = (words.next()?.parse().ok()?, words.next()?.parse().ok()?);
        (version >= OLDEST).then(|| words.next().map(PathBuf::from)).flatten()
    })
}

//! Running other programs, with errors that say what to do.

use std::env;
use std::ffi::OsStr;
use std::fmt::Write as _;
use std::io::{BufRead as _, BufReader, ErrorKind, Write as _};
use std::path::{Path, PathBuf};
use std::process::{Command, ExitStatus, Stdio};
use std::sync::LazyLock;

use anyhow::{Context as _, Result, bail, ensure};

/// The oldest Node.js that every tool in `package-lock.json` accepts: major, minor.
const OLDEST_NODE: (u32, u32) = (20, 19);

pub(crate) const WASM_TARGET: &str = "wasm32-unknown-unknown";

/// The repository's folder.
pub(crate) fn root() -> &'static Path {
    // As cargo says when it runs this: two checkouts may share a target folder, and then this was built in either.
    static ROOT: LazyLock<PathBuf> = LazyLock::new(|| {
        let here = env::var_os("CARGO_MANIFEST_DIR").unwrap_or_else(|| env!("CARGO_MANIFEST_DIR").into());
        let mut root = PathBuf::from(here);
        root.pop();
        root
    });
    &ROOT
}

/// A command that starts in the repository's folder.
pub(crate) fn command(program: impl AsRef<OsStr>) -> Command {
    let mut command = Command::new(program);
    command.current_dir(root());
    command
}

/// The cargo that runs this program.
pub(crate) fn cargo() -> Command {
    command(env::var_os("CARGO").unwrap_or_else(|| "cargo".into()))
}

/// Has a build of cargo lint the workspace's own crates, warnings being errors, while it compiles them. Their libraries
/// are compiled once, where `cargo clippy` reads them all again.
pub(crate) fn linting(build: &mut Command) -> &mut Command {
    build.env("RUSTC_WORKSPACE_WRAPPER", "clippy-driver").env("CLIPPY_ARGS", "-Dwarnings")
}

pub(crate) fn node() -> Command {
    command("node")
}

/// A tool from `node_modules`, started without the detour through npx.
pub(crate) fn node_tool(script: &str) -> Command {
    let mut command = node();
    command.arg(Path::new("node_modules").join(script));
    command
}

pub(crate) fn npm() -> Command {
    if cfg!(windows) {
        let mut command = command("cmd");
        command.args(["/C", "npm"]);
        command
    } else {
        command("npm")
    }
}

/// Runs to the end, output shown as it comes. An exit code other than 0 is an error.
pub(crate) fn run(command: &mut Command) -> Result<()> {
    announce(command);
    let status = command.status().map_err(|error| not_started(command, &error))?;
    ensure!(status.success(), "`{}` failed ({status})", line(command));
    Ok(())
}

/// Runs to the end in silence and returns what it printed.
pub(crate) fn capture(command: &mut Command) -> Result<String> {
    let output = command.stderr(Stdio::inherit()).output().map_err(|error| not_started(command, &error))?;
    ensure!(output.status.success(), "`{}` failed ({})", line(command), output.status);
    String::from_utf8(output.stdout).with_context(|| format!("output of `{}`", line(command)))
}

/// Runs to the end, showing standard output as it comes and returning it as well.
pub(crate) fn tee(command: &mut Command) -> Result<(ExitStatus, String)> {
    announce(command);
    let mut child = command.stdout(Stdio::piped()).spawn().map_err(|error| not_started(command, &error))?;
    let mut seen = String::new();
    if let Some(stdout) = child.stdout.take() {
        for line in BufReader::new(stdout).split(b'\n') {
            let line = String::from_utf8_lossy(&line?).into_owned();
            println!("{line}");
            seen.push_str(&line);
            seen.push('\n');
        }
    }
    Ok((child.wait()?, seen))
}

/// The program of a crate at this version, installed under `target/tools` where it is not there.
pub(crate) fn cargo_tool(name: &str, version: &str, options: &[&str]) -> Result<PathBuf> {
    let folder = Workspace::load()?.target.join("tools").join(format!("{name}-{version}"));
    let program = folder.join("bin").join(format!("{name}{}", env::consts::EXE_SUFFIX));
    if !program.exists() {
        let install = ["install", "--locked", name, "--version", version];
        run(cargo().args(install).args(options).arg("--root").arg(&folder))?;
    }
    Ok(program)
}

pub(crate) fn check_node() -> Result<()> {
    let version = capture(node().arg("--version"))?;
    let version = version.trim();
    match node_version(version) {
        Some(found) if found >= OLDEST_NODE => Ok(()),
        _ => bail!("Node.js {version} is too old: {} or newer is needed (https://nodejs.org)", oldest_node()),
    }
}

/// Adds the wasm target to the toolchain in use, when it is not there.
pub(crate) fn ensure_wasm_target() -> Result<()> {
    let folder = capture(command("rustc").args(["--print", "target-libdir", "--target", WASM_TARGET]))?;
    if Path::new(folder.trim()).is_dir() {
        return Ok(());
    }
    run(command("rustup").args(["target", "add", WASM_TARGET])).with_context(|| {
        format!(
            "the Rust target {WASM_TARGET} is missing; with a Rust that does not come from rustup, \
             install your distribution's package for it"
        )
    })
}

/// Installs the packages of `package-lock.json`, when that has not been done since it last changed.
pub(crate) fn ensure_node_modules() -> Result<()> {
    let changed = |path: &str| root().join(path).metadata().and_then(|file| file.modified());
    let locked = changed("package-lock.json").context("package-lock.json")?;
    if changed("node_modules/.package-lock.json").is_ok_and(|installed| installed >= locked) {
        return Ok(());
    }
    run(npm().args(["ci", "--no-audit", "--no-fund"]))
}

/// What `cargo metadata` knows and paths alone do not tell.
pub(crate) struct Workspace {
    /// Cargo's output folder.
    pub(crate) target: PathBuf,
    /// The library's version.
    pub(crate) version: String,
}

impl Workspace {
    pub(crate) fn load() -> Result<Self> {
        let text = capture(cargo().args(["metadata", "--locked", "--no-deps", "--format-version", "1"]))?;
        let metadata: serde_json::Value = serde_json::from_str(&text).context("cargo metadata")?;
        let target = metadata["target_directory"].as_str().context("cargo metadata: no target_directory")?;
        let version = metadata["packages"]
            .as_array()
            .and_then(|packages| packages.iter().find(|package| package["name"] == "parkade"))
            .and_then(|package| package["version"].as_str())
            .context("cargo metadata: no package `parkade`")?;
        Ok(Self { target: target.into(), version: version.to_owned() })
    }
}

/// Shows the command line that comes next.
fn announce(command: &Command) {
    // A closed standard error is no reason to stop the work.
    let _ = writeln!(std::io::stderr(), "\n$ {}", line(command));
}

fn line(command: &Command) -> String {
    let mut line = Path::new(command.get_program())
        .file_stem()
        .unwrap_or(command.get_program())
        .to_string_lossy()
        .into_owned();
    for argument in command.get_args() {
        let _ = write!(line, " {}", argument.to_string_lossy());
    }
    line
}

fn not_started(command: &Command, error: &std::io::Error) -> anyhow::Error {
    let program = command.get_program().to_string_lossy();
    let remedy = match (error.kind(), program.as_ref()) {
        (ErrorKind::NotFound, "node" | "npm") => {
            format!(": install Node.js {} or newer (https://nodejs.org)", oldest_node())
        }
        (ErrorKind::NotFound, "rustc" | "rustup") => ": install Rust with https://rustup.rs".to_owned(),
        _ => String::new(),
    };
    anyhow::anyhow!("cannot start `{program}` ({error}){remedy}")
}

fn oldest_node() -> String {
    format!("{}.{}", OLDEST_NODE.0, OLDEST_NODE.1)
}

fn node_version(text: &str) -> Option<(u32, u32)> {
    let mut numbers = text.strip_prefix('v')?.split('.').map(str::parse);
    Some((numbers.next()?.ok()?, numbers.next()?.ok()?))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn node_versions_compare_by_number() {
        assert!(node_version("v20.9.0").is_some_and(|found| found < OLDEST_NODE));
        assert!(node_version("v20.19.0").is_some_and(|found| found >= OLDEST_NODE));
        assert!(node_version("v100.0.0").is_some_and(|found| found >= OLDEST_NODE));
        assert_eq!(node_version("20.19.0"), None);
    }
}

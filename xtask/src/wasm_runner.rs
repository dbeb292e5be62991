//! The wasm test runner, at the version that `Cargo.lock` names.

use anyhow::Result;

/// Runs the tests of one `.wasm` file; `arguments` are those that cargo hands to a runner.
pub(crate) fn run(arguments: &[String]) -> Result<()> {
    let program = "wasm-bindgen-test-runner".to_owned();
    let arguments = std::iter::once(program).chain(arguments.iter().cloned());
    wasm_bindgen_cli::wasm_bindgen_test_runner::run_cli_with_args(arguments)
}

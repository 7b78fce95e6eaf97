//! Cargo's runner for tests compiled to wasm: under node, or in Chromium where `WASM_BINDGEN_USE_BROWSER` is set.

use std::process::ExitCode;

fn main() -> ExitCode {
    match wasm_bindgen_cli::wasm_bindgen_test_runner::run_cli_with_args(std::env::args_os()) {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            eprintln!("wasm test runner: {error:#}");
            ExitCode::FAILURE
        }
    }
}

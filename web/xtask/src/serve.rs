//! `serve`: the page, the server, and the server's run.

use crate::bundle;
use crate::shell::{Outcome, cargo, run, step};
use std::process::Command;

/// Builds the page and the server and runs `wheelover ARGS`.
///
/// # Errors
/// Something does not build, or the server ends with an error.
pub(crate) fn serve(release: bool, arguments: &[String]) -> Outcome {
    bundle::build(release)?;
    step("server", || run(&mut server("build", release)))?;
    run(server("run", release).arg("--").args(arguments))
}

/// `cargo build` or `cargo run` of the server.
pub(crate) fn server(verb: &str, release: bool) -> Command {
    let mut command = cargo(&[verb, "--package", "wheelover"]);
    if release {
        command.arg("--release");
    }
    if verb == "run" {
        command.arg("--quiet");
    }
    command
}

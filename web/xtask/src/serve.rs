//! `serve`: the page, the server, and the server's run.

use crate::bundle;
use crate::shell::{Failure, Outcome, cargo, run, step};
use std::process::Command;

/// Builds the page and the server and runs `wheelover ARGS`.
///
/// # Errors
/// Something does not build, or the server ends with an error.
pub(crate) fn serve(release: bool, arguments: &[String]) -> Outcome {
    // The server's library does not wait for the page; only the program embeds it.
    let mut library = server("build", release);
    library.args(["--lib", "--quiet"]);
    let library = std::thread::spawn(move || run(&mut library));
    bundle::build(release)?;
    step("server", || {
        library
            .join()
            .unwrap_or_else(|_| Err(Failure::new("the server's build was lost")))?;
        run(&mut server("build", release))
    })?;
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

//! `serve`: the page, the server, and the server's run.

use crate::page;
use std::process::Command;
use xtask::shell::{Beside, Outcome, beside, cargo, root, run, step};

/// Builds the page and the server and runs `wheelover ARGS`.
///
/// # Errors
/// Something does not build, or the server ends with an error.
pub(crate) fn serve(release: bool, arguments: &[String]) -> Outcome {
    // The server's library does not wait for the page, only the program embeds it. Two builds side by side keep many cores
    // busy; two cores are sooner done with one after the other.
    let cores = std::thread::available_parallelism().map_or(1, usize::from);
    let library = (cores > 2).then(|| {
        let mut library = server("build", release);
        library.args(["--lib", "--quiet"]);
        beside(library)
    });
    page::build(release)?;
    step("server", || {
        library.map_or(Ok(()), Beside::done)?;
        run(&mut server("build", release))
    })?;
    run(server("run", release).arg("--").args(arguments))
}

/// `cargo build` or `cargo run` of the server.
pub(crate) fn server(verb: &str, release: bool) -> Command {
    let mut command = cargo(&[verb, "--package", "wheelover"]);
    // Which page is embedded: the program, and only it, is built again for another one.
    let page = std::fs::read_to_string(root().join("web/dist/build.txt")).unwrap_or_default();
    command.env("WHEELOVER_PAGE", page.trim());
    if release {
        command.arg("--release");
    }
    if verb == "run" {
        command.arg("--quiet");
    }
    command
}

//! `serve`: the page, the server, and the server's run.

use crate::page;
use crate::tools::wasm_target;
use std::process::Command;
use xtask::cores::Cores;
use xtask::shell::{Beside, Outcome, beside, cargo, root, run, step};

/// Builds the page and the server and runs `wheelover ARGS`.
///
/// # Errors
/// Something does not build, or the server ends with an error.
pub(crate) fn serve(release: bool, arguments: &[String]) -> Outcome {
    wasm_target()?;
    step("page, its bundler and the server, side by side", || {
        compile(release)
    })?;
    page::build(release)?;
    step("server", || run(&mut server("build", release)))?;
    run(server("run", release).arg("--").args(arguments))
}

/// Compiles what does not wait for each other: only the program embeds the page, the server's library does not know it.
fn compile(release: bool) -> Outcome {
    let cores = Cores::shared();
    let mut library = server("build", release);
    library.args(["--lib", "--quiet"]);
    let others = [page::bundler("build"), library].map(|other| beside(cores.give(other)));
    let page = run(&mut cores.give(page::compiler(release)));
    let others = others.map(Beside::done);
    page.and(others.into_iter().collect())
}

/// `cargo build` or `cargo run` of the server.
pub(crate) fn server(verb: &str, release: bool) -> Command {
    let mut command = cargo(&[verb, "--package", "wheelover"]);
    // Without a page the empty table is embedded; the program, and only it, is built again for another one.
    let page = root().join("web/dist/page.rs");
    if page.is_file() {
        command.env("WHEELOVER_PAGE", page);
    }
    if release {
        command.arg("--release");
    }
    if verb == "run" {
        command.arg("--quiet");
    }
    command
}

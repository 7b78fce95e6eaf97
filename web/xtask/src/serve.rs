//! `serve` and `ship`: the page, the server that embeds it, and the server's run.

use crate::page;
use crate::tools::wasm_target;
use std::process::Command;
use xtask::shell::{Outcome, beside, cargo, root, run, step, target};

/// How the server is built.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Profile {
    /// For a debugger.
    Debug,
    /// As fast as one build can be had: only the core is optimised.
    Quick,
    /// What is shipped.
    Release,
}

impl Profile {
    fn name(self) -> &'static str {
        match self {
            Self::Debug => "dev",
            Self::Quick => "quick",
            Self::Release => "release",
        }
    }
}

/// Builds the page and the server and runs `wheelover ARGS`.
///
/// # Errors
/// Something does not build, or the server ends with an error.
pub(crate) fn serve(release: bool, arguments: &[String]) -> Outcome {
    let profile = if release {
        Profile::Quick
    } else {
        Profile::Debug
    };
    build(profile)?;
    run(server("run", profile).arg("--").args(arguments))
}

/// Builds what is shipped: one program with the page in it.
///
/// # Errors
/// Something does not build.
pub(crate) fn ship() -> Outcome {
    build(Profile::Release)?;
    eprintln!("{}", target().join("release/wheelover").display());
    Ok(())
}

fn build(profile: Profile) -> Outcome {
    let release = profile != Profile::Debug;
    wasm_target()?;
    // Only the program embeds the page, the server's library does not know it. A page ends with one long step on one core,
    // so that two lanes take less time than one, and need no agreement about the cores.
    step("page, beside its bundler and the server", || {
        let mut library = server("build", profile);
        library.args(["--lib", "--quiet"]);
        beside(
            move || run(&mut page::bundler("build")).and_then(|()| run(&mut library)),
            || run(&mut page::compiler(release)),
        )
    })?;
    page::build(release)?;
    step("server", || run(&mut server("build", profile)))
}

/// `cargo build` or `cargo run` of the server.
pub(crate) fn server(verb: &str, profile: Profile) -> Command {
    let mut command = cargo(&[verb, "--package", "wheelover", "--profile", profile.name()]);
    // Without a page the empty table is embedded; the program, and only it, is built again for another one.
    let page = root().join("web/dist/page.rs");
    if page.is_file() {
        command.env("WHEELOVER_PAGE", page);
    }
    if verb == "run" {
        command.arg("--quiet");
    }
    command
}

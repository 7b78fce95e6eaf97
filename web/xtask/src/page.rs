//! `build`: compiles the program that bundles the page, then the page, and has it bundled.

use crate::tools::{WASM, wasm_target};
use std::process::Command;
use xtask::shell::{Failure, Outcome, answer, cargo, run, step, target};

/// What a browser may load before the page works, brotli, bytes: the product promises 200,000, and what is still to be built
/// needs the rest.
const FIRST_LOAD_BUDGET: u64 = 194_000;

/// Builds the page into `web/dist`.
///
/// # Errors
/// It does not compile.
pub(crate) fn build(release: bool) -> Outcome {
    make(release).map(|_| ())
}

/// Builds the page as it is released; one over its budget is a failure.
///
/// # Errors
/// It does not compile, or is too large.
pub(crate) fn build_within_budget() -> Outcome {
    match make(true)? {
        size if size > FIRST_LOAD_BUDGET => Err(Failure::new(format!(
            "a first load is {size} bytes brotli, its budget {FIRST_LOAD_BUDGET}"
        ))),
        _ => Ok(()),
    }
}

/// Builds the page; gives back the bytes of a first load.
fn make(release: bool) -> Result<u64, Failure> {
    let mut first_load = 0;
    step("page", || {
        wasm_target()?;
        run(&mut bundler("build"))?;
        run(&mut compiler(release))?;
        let mut bundle = bundler("run");
        bundle
            .arg("--")
            .arg(target().join(WASM).join(profile(release)));
        if release {
            bundle.arg("--release");
        }
        let size = answer(&mut bundle)?;
        first_load = size
            .parse()
            .map_err(|_| Failure::new(format!("the bundle's size is not a number: `{size}`")))?;
        eprintln!("first load: {first_load} bytes brotli, of {FIRST_LOAD_BUDGET}");
        if release && first_load > FIRST_LOAD_BUDGET {
            eprintln!("the first load is over its budget");
        }
        Ok(())
    })?;
    Ok(first_load)
}

fn profile(release: bool) -> &'static str {
    if release { "web-release" } else { "web-dev" }
}

/// `cargo build` of the page.
pub(crate) fn compiler(release: bool) -> Command {
    let mut command = cargo(&[
        "build",
        "--package",
        "wheelover-web",
        "--bins",
        "--target",
        WASM,
        "--profile",
        profile(release),
    ]);
    if release {
        // Views other than the bridge become parts of their own.
        command.args(["--features", "split"]);
    }
    command
}

/// `cargo build` or `cargo run` of the program that bundles.
pub(crate) fn bundler(verb: &str) -> Command {
    cargo(&[
        verb,
        "--quiet",
        "--package",
        "xtask",
        "--features",
        "bundle",
        "--bin",
        "bundle",
    ])
}

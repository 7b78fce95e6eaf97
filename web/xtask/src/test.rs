//! `test`: everything that must hold before a change is taken, step by step, each with its name and time.

use crate::deny;
use crate::page;
use crate::serve::{Profile, server};
use crate::tools::{BARE, WASM, browser, fonts, gpsd, has_target, wasm_target};
use std::time::Instant;
use xtask::shell::{Failure, Outcome, cargo, has, output, run, step, target};

/// Installs what the tests need, checks and tests everything; the first failure ends it.
///
/// # Errors
/// The step that failed.
pub(crate) fn test() -> Outcome {
    let started = Instant::now();
    step(
        "tools: wasm target, Chromium, chromedriver, fonts, gpsd",
        || {
            wasm_target()
                .and_then(|()| browser())
                .and_then(|()| fonts())
                .and_then(|()| gpsd())
        },
    )?;
    step("format", || run(&mut cargo(&["fmt", "--all", "--check"])))?;
    let mut not_run = None;
    step("dependencies: licences, sources, advisories", || {
        not_run = deny::dependencies()?;
        Ok(())
    })?;
    step("clippy, native", || {
        run(cargo(&[
            "clippy",
            "--workspace",
            "--all-targets",
            "--features",
            "xtask/bundle",
            "--",
            "-D",
            "warnings",
        ])
        .env_remove("RUSTFLAGS"))
    })?;
    step("clippy, wasm", || {
        run(&mut cargo(&[
            "clippy",
            "-p",
            "wheelover-web",
            "-p",
            "wheelover-core",
            "--target",
            WASM,
            "--lib",
            "--bins",
            "--tests",
            "--",
            "-D",
            "warnings",
        ]))
    })?;
    step("the core alone, without std", core_alone)?;
    step("documents", || {
        run(cargo(&["doc", "--workspace", "--no-deps"]).env("RUSTDOCFLAGS", "-D warnings"))?;
        run(cargo(&[
            "doc",
            "-p",
            "wheelover-web",
            "--lib",
            "--no-deps",
            "--target",
            WASM,
        ])
        .env("RUSTDOCFLAGS", "-D warnings"))
    })?;
    step("unit tests", || {
        run(&mut cargo(&[
            "test",
            "--workspace",
            "--exclude",
            "wheelover-tests",
            "--features",
            "xtask/bundle",
        ]))
    })?;
    page::build_within_budget()?;
    step("server", || run(&mut server("build", Profile::Debug)))?;
    step("tests in wasm", wasm_tests)?;
    step("integration and browser tests", || {
        let binary = target()
            .join("debug")
            .join(format!("wheelover{}", std::env::consts::EXE_SUFFIX));
        run(cargo(&["test", "-p", "wheelover-tests"]).env("WHEELOVER_BIN", binary))
    })?;
    eprintln!(
        "everything {} in {:.1} min",
        if not_run.is_some() {
            "that was run passed"
        } else {
            "passed"
        },
        started.elapsed().as_secs_f64() / 60.0
    );
    if let Some(not_run) = not_run {
        eprintln!("{not_run}");
    }
    Ok(())
}

/// A workspace build unifies features and would hide a dependency's `std`.
fn core_alone() -> Outcome {
    if has_target(BARE) {
        return run(&mut cargo(&[
            "check",
            "-p",
            "wheelover-core",
            "--lib",
            "--target",
            BARE,
        ]));
    }
    run(&mut cargo(&[
        "check",
        "-p",
        "wheelover-core",
        "--lib",
        "--no-default-features",
    ]))?;
    let mut tree = cargo(&[
        "tree",
        "-p",
        "wheelover-core",
        "-e",
        "features,no-proc-macro,no-dev,no-build",
        "--prefix",
        "none",
    ]);
    let tree = output(&mut tree).ok_or_else(|| Failure::new("`cargo tree` failed"))?;
    match tree.lines().find(|line| line.contains("feature \"std\"")) {
        Some(line) => Err(Failure::new(format!("the core's tree has `{line}`"))),
        None => Ok(()),
    }
}

/// The same voyage natively and in wasm must give the same bytes.
fn wasm_tests() -> Outcome {
    let mut native = cargo(&[
        "test",
        "-p",
        "wheelover-web",
        "--test",
        "same_voyage",
        "--",
        "--nocapture",
    ]);
    let native = output(&mut native).ok_or_else(|| Failure::new("the voyage fails natively"))?;
    let digest = native.lines().find_map(|line| line.split_once("VOYAGE "));
    let (_, digest) = digest.ok_or_else(|| Failure::new("the native voyage printed no digest"))?;
    let mut command = cargo(&["test", "-p", "wheelover-web", "--target", WASM]);
    command.env("WHEELOVER_NATIVE_VOYAGE", digest.trim());
    if !has("node") {
        command.env("WASM_BINDGEN_USE_BROWSER", "1");
    }
    run(&mut command)
}

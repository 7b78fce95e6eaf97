//! What the build and the tests need from the machine: the wasm target, a browser and its driver, gpsd's decoder.

use std::path::{Path, PathBuf};
use std::process::Command;
use xtask::shell::{Failure, Outcome, cargo, has, output, root, run, target};

/// The target of the page.
pub(crate) const WASM: &str = "wasm32-unknown-unknown";

/// A target without operating system, to prove that the core needs none.
pub(crate) const BARE: &str = "thumbv7em-none-eabihf";

/// Whether the compiler has a standard library for `target`.
pub(crate) fn has_target(target: &str) -> bool {
    let mut rustc = Command::new("rustc");
    rustc
        .args(["--print", "target-libdir", "--target", target])
        .current_dir(root());
    output(&mut rustc).is_some_and(|folder| Path::new(&folder).is_dir())
}

/// Adds the wasm target where it is missing.
///
/// # Errors
/// It is missing and cannot be added.
pub(crate) fn wasm_target() -> Outcome {
    if has_target(WASM) {
        return Ok(());
    }
    eprintln!("adding the target {WASM}");
    let added = run(Command::new("rustup")
        .args(["target", "add", WASM])
        .current_dir(root()));
    if added.is_ok() && has_target(WASM) {
        return Ok(());
    }
    Err(Failure::new(format!(
        "the compiler cannot build for {WASM}, and `rustup target add {WASM}` did not help.\n\
         With rustup: run that command where the network is reachable.\n\
         Without rustup: install your system's package of the Rust standard library for wasm \
         (Debian: libstd-rust-dev-wasm32, with a rustc of the version in rust-toolchain.toml)."
    )))
}

/// Installs Chromium and its driver where they are missing and the system's packages can be installed.
///
/// # Errors
/// They are missing and cannot be installed.
pub(crate) fn browser() -> Outcome {
    if has("chromedriver") && (has("chromium") || has("chromium-browser") || has("google-chrome")) {
        return Ok(());
    }
    install(
        &["chromium", "chromium-driver"],
        "the browser tests need Chromium and chromedriver on the path; install both",
    )
}

/// Installs the fonts in which the layout is tested, where they are missing and the system's packages can be installed.
///
/// # Errors
/// They are missing and cannot be installed.
pub(crate) fn fonts() -> Outcome {
    let known = output(Command::new("fc-list").args([":", "family"])).unwrap_or_default();
    let here = |family: &str| known.lines().any(|line| line.starts_with(family));
    if ["Roboto", "Noto Sans", "DejaVu Sans"].into_iter().all(here) {
        return Ok(());
    }
    install(
        &[
            "fontconfig",
            "fonts-roboto",
            "fonts-noto-core",
            "fonts-dejavu",
        ],
        "the layout tests need the fonts Roboto, Noto Sans and DejaVu Sans; install them",
    )
}

/// Installs gpsd's decoder where it is missing and the system's packages can be installed (FB14).
///
/// # Errors
/// It is missing and cannot be installed.
pub(crate) fn gpsd() -> Outcome {
    if has("gpsdecode") {
        return Ok(());
    }
    install(
        &["gpsd-clients"],
        "the comparison with gpsd needs gpsdecode on the path; install gpsd's command-line tools",
    )
}

/// The version of `cargo deny` whose findings a run repeats.
const CARGO_DENY: &str = "0.20.2";

/// The program that checks the dependencies: the one on the path, or one that is built once into the folder of what may be deleted.
///
/// # Errors
/// It is missing and cannot be built.
pub(crate) fn cargo_deny() -> Result<PathBuf, Failure> {
    let name = format!("cargo-deny{}", std::env::consts::EXE_SUFFIX);
    if has(&name) {
        return Ok(PathBuf::from(name));
    }
    let folder = target().join("tools");
    let program = folder.join("bin").join(&name);
    let same = |said: String| said.ends_with(CARGO_DENY);
    if output(Command::new(&program).arg("--version")).is_some_and(same) {
        return Ok(program);
    }
    eprintln!("building cargo-deny {CARGO_DENY}");
    let mut install = cargo(&["install", "--quiet", "--locked", "cargo-deny"]);
    // It runs for two seconds: built without optimisation and without what it needs to stand alone, it is there in a minute.
    install.args(["--version", CARGO_DENY, "--debug", "--no-default-features"]);
    install.arg("--root").arg(&folder);
    install.arg("--target-dir").arg(folder.join("build"));
    run(install.env("CARGO_PROFILE_DEV_DEBUG", "0"))?;
    Ok(program)
}

/// Installs packages of the system; `by_hand` says what to do where that fails.
fn install(packages: &[&str], by_hand: &str) -> Outcome {
    if !has("apt-get") {
        return Err(Failure::new(by_hand));
    }
    eprintln!("installing {}", packages.join(" and "));
    let with_reason = |failure| Failure::new(format!("{failure}\n{by_hand}"));
    apt(&["update"]).map_err(with_reason)?;
    let mut arguments = vec!["install", "-y", "--no-install-recommends"];
    arguments.extend(packages);
    apt(&arguments).map_err(with_reason)
}

fn apt(arguments: &[&str]) -> Outcome {
    let is_root = output(Command::new("id").arg("-u")).is_some_and(|id| id == "0");
    let mut command = Command::new(if is_root { "apt-get" } else { "sudo" });
    if !is_root {
        command.arg("apt-get");
    }
    command
        .args(["-o", "DPkg::Lock::Timeout=300"])
        .args(arguments);
    run(command.env("DEBIAN_FRONTEND", "noninteractive"))
}

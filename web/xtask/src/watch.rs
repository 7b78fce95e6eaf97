//! `watch`: builds and runs again what was edited. The page of a development build reloads itself.

use crate::page;
use crate::serve::{Profile, server};
use std::collections::BTreeMap;
use std::path::{Path, PathBuf};
use std::process::{Child, Command};
use std::time::{Duration, SystemTime};
use xtask::shell::{Failure, Outcome, root, run, step};

const PAGE: [&str; 4] = ["web/src", "static", "core/src", "Cargo.toml"];
const SERVER: [&str; 3] = ["server", "core/src", "Cargo.toml"];

type Times = BTreeMap<PathBuf, SystemTime>;

/// Builds page and server, runs the server, and on every edit builds what was edited and runs it anew. Ends with the terminal.
///
/// # Errors
/// The first build fails or the server cannot be started. A later build that fails is shown and waited for.
pub(crate) fn watch(arguments: &[String]) -> Outcome {
    page::build(false)?;
    build_server()?;
    let mut child = start(arguments)?;
    let (mut page, mut engine) = (times(&PAGE), times(&SERVER));
    eprintln!("watching web/, static/, core/ and server/");
    loop {
        std::thread::sleep(Duration::from_millis(300));
        let (page_now, engine_now) = (times(&PAGE), times(&SERVER));
        let (page_edited, engine_edited) = (page_now != page, engine_now != engine);
        (page, engine) = (page_now, engine_now);
        if page_edited && !reported(page::build(false)) {
            continue;
        }
        // The page is embedded: another one is another program.
        if (page_edited || engine_edited) && reported(build_server()) {
            stop(&mut child);
            child = start(arguments)?;
        }
    }
}

fn build_server() -> Outcome {
    step("server", || run(&mut server("build", Profile::Debug)))
}

fn start(arguments: &[String]) -> Result<Child, Failure> {
    server("run", Profile::Debug)
        .arg("--")
        .args(arguments)
        .spawn()
        .map_err(|error| Failure::new(format!("server: {error}")))
}

/// Ends cargo's child and what it started.
fn stop(child: &mut Child) {
    // `cargo run` replaces itself by the program on Unix, so the child is the server.
    let ended = Command::new("kill").arg(child.id().to_string()).status();
    if !ended.is_ok_and(|status| status.success()) {
        // It has ended by itself; waiting collects it.
        eprintln!("the server had ended");
    }
    if let Err(error) = child.wait() {
        eprintln!("server: {error}");
    }
}

fn reported(outcome: Outcome) -> bool {
    if let Err(failure) = &outcome {
        eprintln!("{failure}\nwaiting for the next edit");
    }
    outcome.is_ok()
}

fn times(places: &[&str]) -> Times {
    let mut times = Times::new();
    for place in places {
        collect(&root().join(place), &mut times);
    }
    times
}

fn collect(path: &Path, times: &mut Times) {
    if let Ok(entries) = std::fs::read_dir(path) {
        for entry in entries.flatten() {
            collect(&entry.path(), times);
        }
    } else if let Ok(time) = path.metadata().and_then(|facts| facts.modified()) {
        times.insert(path.to_owned(), time);
    }
}

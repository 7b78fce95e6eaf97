//! Running other programs: a step with a name and a time, or a failure that says which step.

use std::fmt;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};
use std::time::Instant;

/// What a task gives back.
pub type Outcome = Result<(), Failure>;

/// Why a task stopped, in one message for the reader.
#[derive(Debug)]
pub struct Failure(String);

impl Failure {
    /// With its message.
    pub fn new(text: impl Into<String>) -> Self {
        Self(text.into())
    }

    /// An I/O error and the file that it is about.
    pub fn file(path: &Path, error: &std::io::Error) -> Self {
        Self(format!("{}: {error}", path.display()))
    }
}

impl fmt::Display for Failure {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.0)
    }
}

/// The root of the repository: two folders above this package.
pub fn root() -> PathBuf {
    let package = PathBuf::from(env!("CARGO_MANIFEST_DIR"));
    package
        .ancestors()
        .nth(2)
        .map_or_else(|| PathBuf::from("."), PathBuf::from)
}

/// The folder into which cargo builds.
pub fn target() -> PathBuf {
    std::env::var_os("CARGO_TARGET_DIR").map_or_else(|| root().join("target"), PathBuf::from)
}

/// A cargo command in the repository's root.
pub fn cargo(arguments: &[&str]) -> Command {
    let mut command = Command::new(std::env::var_os("CARGO").unwrap_or_else(|| "cargo".into()));
    command.args(arguments).current_dir(root());
    // What cargo set for this very process must not reach another package's build.
    for (name, _) in std::env::vars_os() {
        if name.to_string_lossy().starts_with("CARGO_PKG_") || name == "CARGO_MANIFEST_DIR" {
            command.env_remove(name);
        }
    }
    command
}

/// Runs `command` to its end.
///
/// # Errors
/// It cannot be started, or ends with anything but success.
pub fn run(command: &mut Command) -> Outcome {
    let shown = show(command);
    let status = command
        .status()
        .map_err(|error| Failure::new(format!("`{shown}`: {error}")))?;
    if status.success() {
        Ok(())
    } else {
        Err(Failure::new(format!("`{shown}`: {status}")))
    }
}

/// The standard output of `command`, if it succeeds.
pub fn output(command: &mut Command) -> Option<String> {
    printed(command).ok()
}

/// What `command` prints; its errors are shown as they come.
///
/// # Errors
/// It cannot be started, or ends with anything but success.
pub fn answer(command: &mut Command) -> Result<String, Failure> {
    printed(command.stderr(Stdio::inherit()))
}

fn printed(command: &mut Command) -> Result<String, Failure> {
    let shown = show(command);
    let failed = |why: &dyn fmt::Display| Failure::new(format!("`{shown}`: {why}"));
    let output = command.output().map_err(|error| failed(&error))?;
    if output.status.success() {
        Ok(String::from_utf8_lossy(&output.stdout).trim().to_owned())
    } else {
        Err(failed(&output.status))
    }
}

/// Reads a text.
///
/// # Errors
/// It cannot be read, or is no UTF-8.
pub fn text(path: &Path) -> Result<String, Failure> {
    std::fs::read_to_string(path).map_err(|error| Failure::file(path, &error))
}

/// Does one thing beside another.
///
/// # Errors
/// What the first failed with, else the second.
pub fn beside(one: impl FnOnce() -> Outcome + Send, other: impl FnOnce() -> Outcome) -> Outcome {
    std::thread::scope(|scope| {
        let one = scope.spawn(one);
        let other = other();
        let lost = |_| Err(Failure::new("what ran beside was lost"));
        one.join().unwrap_or_else(lost).and(other)
    })
}

/// Whether a program of this name is on the path.
pub fn has(program: &str) -> bool {
    let paths = std::env::var_os("PATH").unwrap_or_default();
    std::env::split_paths(&paths).any(|folder| folder.join(program).is_file())
}

/// A named part of a task; its time is printed.
///
/// # Errors
/// What `body` failed with, under the name of the step.
pub fn step(name: &str, body: impl FnOnce() -> Outcome) -> Outcome {
    eprintln!("── {name}");
    let started = Instant::now();
    match body() {
        Ok(()) => {
            eprintln!(
                "── {name}: done in {:.1} s\n",
                started.elapsed().as_secs_f64()
            );
            Ok(())
        }
        Err(failure) => Err(Failure::new(format!("step \"{name}\" failed: {failure}"))),
    }
}

fn show(command: &Command) -> String {
    let mut text = command.get_program().to_string_lossy().into_owned();
    for argument in command.get_args() {
        text.push(' ');
        text.push_str(&argument.to_string_lossy());
    }
    text
}

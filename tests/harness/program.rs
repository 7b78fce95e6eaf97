//! The real binary as a child process on a port of its own.

use crate::folder;
use crate::serial::Line;
use std::io::{BufRead, BufReader};
use std::net::SocketAddr;
use std::path::PathBuf;
use std::process::{Child, Command, Stdio};
use std::sync::OnceLock;
use std::sync::mpsc::{Receiver, channel};
use std::time::{Duration, Instant};

/// How long a program may take to begin.
const BEGINS: Duration = Duration::from_secs(30);

/// The binary: from `WHEELOVER_BIN`, else built once by this harness.
///
/// # Panics
/// It cannot be built.
#[must_use]
pub fn binary() -> PathBuf {
    static BINARY: OnceLock<PathBuf> = OnceLock::new();
    BINARY.get_or_init(|| built("dev", "debug")).clone()
}

/// The binary of a profile: from `WHEELOVER_BIN`, else built now, with the page where the build task has laid one.
///
/// # Panics
/// It cannot be built.
#[must_use]
pub fn built(profile: &str, folder: &str) -> PathBuf {
    if let Some(path) = std::env::var_os("WHEELOVER_BIN") {
        return PathBuf::from(path);
    }
    let root = PathBuf::from(concat!(env!("CARGO_MANIFEST_DIR"), "/.."));
    let mut build = Command::new(env!("CARGO"));
    build.args(["build", "--package", "wheelover", "--profile", profile]);
    let page = root.join("web/dist/page.rs");
    if page.is_file() {
        build.env("WHEELOVER_PAGE", page);
    }
    let done = build.current_dir(&root).status();
    assert!(done.is_ok_and(|status| status.success()), "{build:?}");
    let target =
        std::env::var_os("CARGO_TARGET_DIR").map_or_else(|| root.join("target"), PathBuf::from);
    target.join(folder).join("wheelover")
}

/// A running `wheelover serve`; it ends with this value.
#[derive(Debug)]
pub struct Program {
    child: Child,
    /// Where its page is.
    pub address: SocketAddr,
    /// What it said before its address, on either output.
    early: std::cell::RefCell<Vec<String>>,
    said: Receiver<String>,
}

impl Program {
    /// Starts the server on a free port of this machine and waits until it says where it is.
    ///
    /// # Panics
    /// It does not start within 30 s.
    #[must_use]
    #[allow(clippy::unwrap_used)]
    pub fn start(arguments: &[&str]) -> Self {
        Self::start_with(arguments, &[])
    }

    /// Starts an autopilot that sends nothing, with one serial port of this profile; its far end comes with it. `name` is
    /// that of the folder.
    ///
    /// # Panics
    /// It does not start within 30 s.
    #[must_use]
    #[allow(clippy::unwrap_used)]
    pub fn beside(name: &str, profile: &str) -> (Self, Line) {
        let folder = folder(name);
        let line = Line::new(&folder.join(profile));
        let text = format!(
            "roles = [\"autopilot\"]\nallow_output = false\n[[port]]\nname = \"{profile}\"\nkind = \"serial\"\n\
             path = \"{}\"\nbaud = 38400\nprofile = \"{profile}\"\n",
            line.name().display()
        );
        let file = folder.join("wheelover.toml");
        std::fs::write(&file, text).unwrap();
        let program = Self::start(&["--config", &file.display().to_string()]);
        (program, line)
    }

    /// As `start`, with variables of its environment.
    ///
    /// # Panics
    /// It does not start within 30 s.
    #[must_use]
    #[allow(clippy::unwrap_used)]
    pub fn start_with(arguments: &[&str], variables: &[(&str, &str)]) -> Self {
        let binary = binary();
        let began = crate::alone();
        let mut child = Command::new(binary)
            .args(["serve", "--listen", "127.0.0.1:0"])
            .args(arguments)
            .envs(variables.iter().copied())
            .stdin(Stdio::null())
            .stdout(Stdio::piped())
            .stderr(Stdio::piped())
            .spawn()
            .unwrap();
        drop(began);
        let (sender, said) = channel();
        let errors = sender.clone();
        let (out, err) = (child.stdout.take().unwrap(), child.stderr.take().unwrap());
        std::thread::spawn(move || {
            for line in BufReader::new(out).lines().map_while(Result::ok) {
                let _ = sender.send(line);
            }
        });
        std::thread::spawn(move || {
            for line in BufReader::new(err).lines().map_while(Result::ok) {
                let _ = errors.send(line);
            }
        });
        let end = Instant::now() + BEGINS;
        let mut all = Vec::new();
        loop {
            let line = said.recv_timeout(end.saturating_duration_since(Instant::now()));
            let Ok(line) = line else {
                let _ = child.kill();
                let _ = child.wait();
                panic!("the program did not begin: {all:?}");
            };
            if let Some(address) = address_in(&line) {
                return Self {
                    child,
                    address,
                    early: std::cell::RefCell::new(all),
                    said,
                };
            }
            all.push(line);
        }
    }

    /// Its process number.
    #[must_use]
    pub fn id(&self) -> u32 {
        self.child.id()
    }

    /// Resident memory, kilobytes.
    ///
    /// # Panics
    /// The process is gone.
    #[must_use]
    #[allow(clippy::unwrap_used)]
    pub fn memory_kb(&self) -> u64 {
        let text = std::fs::read_to_string(format!("/proc/{}/status", self.id())).unwrap();
        let line = text
            .lines()
            .find(|line| line.starts_with("VmRSS:"))
            .unwrap();
        line.split_whitespace().nth(1).unwrap().parse().unwrap()
    }

    /// What it has said since this was last asked.
    #[must_use]
    pub fn said(&self) -> Vec<String> {
        let mut said = self.early.take();
        said.extend(self.said.try_iter());
        said
    }

    /// Asks it to end, as a service manager does, and waits.
    ///
    /// # Panics
    /// It does not end within 20 s.
    #[allow(clippy::unwrap_used)]
    pub fn stop(&mut self) -> Option<i32> {
        use nix::sys::signal::{Signal, kill};
        let id = nix::unistd::Pid::from_raw(i32::try_from(self.child.id()).unwrap());
        let _ = kill(id, Signal::SIGTERM);
        self.ended()
    }

    /// Waits until it ends by itself; gives its exit code.
    ///
    /// # Panics
    /// It does not end within 20 s.
    #[allow(clippy::unwrap_used)]
    pub fn ended(&mut self) -> Option<i32> {
        let end = Instant::now() + Duration::from_secs(20);
        loop {
            if let Some(status) = self.child.try_wait().unwrap() {
                return status.code();
            }
            assert!(Instant::now() < end, "the program does not end");
            std::thread::sleep(Duration::from_millis(20));
        }
    }

    /// Ends it as a lost supply does: without warning.
    pub fn kill(&mut self) {
        let _ = self.child.kill();
        let _ = self.child.wait();
    }

    /// Every further line that it says until it is gone.
    #[must_use]
    pub fn last_words(&self) -> Vec<String> {
        let mut said = self.early.take();
        said.extend(self.said.iter());
        said
    }
}

impl Drop for Program {
    fn drop(&mut self) {
        self.kill();
    }
}

/// The address in a line such as `… http://127.0.0.1:4711`.
fn address_in(line: &str) -> Option<SocketAddr> {
    let rest = line.split("http://").nth(1)?;
    let end = rest
        .find(|c: char| !(c.is_ascii_digit() || c == '.' || c == ':'))
        .unwrap_or(rest.len());
    rest[..end].trim_end_matches(['.', ':']).parse().ok()
}

/// What the program says, on both outputs, in its first `time`; it is killed then.
///
/// # Panics
/// It cannot be started.
#[must_use]
#[allow(clippy::unwrap_used)]
pub fn said_within(arguments: &[&str], time: Duration) -> Vec<String> {
    let mut child = Command::new(binary())
        .args(arguments)
        .stdin(Stdio::null())
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .unwrap();
    std::thread::sleep(time);
    let _ = child.kill();
    let said = child.wait_with_output().unwrap();
    let texts = [said.stdout, said.stderr].map(|text| String::from_utf8_lossy(&text).into_owned());
    texts
        .iter()
        .flat_map(|text| text.lines().map(str::to_string))
        .collect()
}

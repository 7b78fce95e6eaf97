//! Serial lines without hardware: pseudo-terminals behind a name that can be pointed elsewhere, and null modems.

use nix::fcntl::{FcntlArg, FdFlag, OFlag, fcntl};
use nix::poll::{PollFd, PollFlags, PollTimeout, poll};
use nix::pty::openpty;
use nix::sys::termios::{SetArg, cfmakeraw, tcgetattr, tcsetattr};
use std::fs::File;
use std::io::{Read, Write};
use std::os::fd::{AsFd, OwnedFd};
use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::{Arc, Weak};
use std::thread::JoinHandle;
use std::time::{Duration, Instant};

/// The far end of a serial line; a program opens the near end by the name.
#[derive(Debug)]
pub struct Line {
    name: PathBuf,
    master: Option<Arc<File>>,
    /// Kept open, so that the far end does not see a hang-up before the program comes.
    near: Option<OwnedFd>,
    heard: Vec<u8>,
}

impl Line {
    /// A line whose near end has this name (a symbolic link, as under `/dev/serial/by-id`).
    #[must_use]
    pub fn new(name: &Path) -> Self {
        let mut line = Self {
            name: name.to_path_buf(),
            master: None,
            near: None,
            heard: Vec::new(),
        };
        line.plug();
        line
    }

    /// Makes a new device and points the name to it.
    ///
    /// # Panics
    /// The system gives no pseudo-terminal.
    #[allow(clippy::unwrap_used)]
    pub fn plug(&mut self) {
        let made = crate::alone();
        let pair = openpty(None, None).unwrap();
        for end in [pair.master.as_fd(), pair.slave.as_fd()] {
            fcntl(end, FcntlArg::F_SETFD(FdFlag::FD_CLOEXEC)).unwrap();
        }
        drop(made);
        let mut modes = tcgetattr(&pair.slave).unwrap();
        cfmakeraw(&mut modes);
        tcsetattr(&pair.slave, SetArg::TCSANOW, &modes).unwrap();
        let device = nix::unistd::ttyname(&pair.slave).unwrap();
        fcntl(pair.master.as_fd(), FcntlArg::F_SETFL(OFlag::O_NONBLOCK)).unwrap();
        let _ = std::fs::remove_file(&self.name);
        std::os::unix::fs::symlink(device, &self.name).unwrap();
        self.master = Some(Arc::new(File::from(pair.master)));
        self.near = Some(pair.slave);
        self.heard.clear();
    }

    /// Takes the device away, as a pulled plug does.
    pub fn unplug(&mut self) {
        let _ = std::fs::remove_file(&self.name);
        self.master = None;
        self.near = None;
    }

    /// Its name.
    #[must_use]
    pub fn name(&self) -> &Path {
        &self.name
    }

    /// Sends bytes; waits for the other side to take them.
    ///
    /// # Panics
    /// The other side takes nothing for 20 s, or the line is unplugged.
    #[allow(clippy::unwrap_used)]
    pub fn send(&mut self, bytes: &[u8]) {
        assert!(
            write_all(self.master.as_ref().unwrap(), bytes),
            "nobody takes the bytes"
        );
    }

    /// Says what `next` gives, ten times a second, until the returned value is dropped or the line unplugged.
    #[must_use]
    pub fn talk(&self, mut next: impl FnMut(u64) -> Vec<String> + Send + 'static) -> Talker {
        let master = self.master.as_ref().map_or_else(Weak::new, Arc::downgrade);
        let stop = Arc::new(AtomicBool::new(false));
        let stopped = stop.clone();
        std::thread::spawn(move || {
            let begun = Instant::now();
            for tick in 0.. {
                let due = begun + Duration::from_millis(tick * 100);
                std::thread::sleep(due.saturating_duration_since(Instant::now()));
                let Some(master) = master.upgrade() else {
                    return;
                };
                if stopped.load(Ordering::Relaxed) {
                    return;
                }
                for line in next(tick) {
                    write_all(&master, format!("{line}\r\n").as_bytes());
                }
            }
        });
        Talker(stop)
    }

    /// Sends a sentence: its body without `$`, checksum and line end.
    pub fn say(&mut self, body: &str) {
        self.send(format!("{}\r\n", crate::with_checksum(body)).as_bytes());
    }

    /// The next whole line that the program sends within that time.
    pub fn hear(&mut self, within: Duration) -> Option<(Instant, String)> {
        let end = Instant::now() + within;
        loop {
            if let Some(at) = self.heard.iter().position(|byte| *byte == b'\n') {
                let line: Vec<u8> = self.heard.drain(..=at).collect();
                let text = String::from_utf8_lossy(&line).trim_end().to_string();
                return Some((Instant::now(), text));
            }
            let now = Instant::now();
            if now >= end {
                return None;
            }
            let mut master: &File = self.master.as_ref()?;
            let mut buffer = [0; 4096];
            match master.read(&mut buffer) {
                Ok(count) if count > 0 => self.heard.extend_from_slice(&buffer[..count]),
                _ => wait(master, PollFlags::POLLIN, end - now),
            }
        }
    }

    /// All lines within that time.
    pub fn listen(&mut self, time: Duration) -> Vec<(Instant, String)> {
        let end = Instant::now() + time;
        let mut lines = Vec::new();
        while let Some(line) = self.hear(end.saturating_duration_since(Instant::now())) {
            lines.push(line);
        }
        lines
    }
}

/// A thread that speaks on a line; it ends with this value.
#[derive(Debug)]
pub struct Talker(Arc<AtomicBool>);

impl Drop for Talker {
    fn drop(&mut self) {
        self.0.store(true, Ordering::Relaxed);
    }
}

/// Whether the other side took everything within 20 s.
fn write_all(mut master: &File, mut bytes: &[u8]) -> bool {
    let end = Instant::now() + Duration::from_secs(20);
    while !bytes.is_empty() {
        if Instant::now() > end {
            return false;
        }
        match master.write(bytes) {
            Ok(count) => bytes = &bytes[count..],
            Err(_) => wait(master, PollFlags::POLLOUT, Duration::from_millis(200)),
        }
    }
    true
}

impl Drop for Line {
    fn drop(&mut self) {
        let _ = std::fs::remove_file(&self.name);
    }
}

/// Waits for an event, at most that long and at most 200 ms.
fn wait(file: &File, what: PollFlags, time: Duration) {
    let milliseconds = u16::try_from(time.as_millis().clamp(1, 200)).unwrap_or(200);
    let mut set = [PollFd::new(file.as_fd(), what)];
    if poll(&mut set, PollTimeout::from(milliseconds)).is_ok()
        && set[0]
            .revents()
            .is_some_and(|seen| seen.contains(PollFlags::POLLHUP))
    {
        // Nobody has the near end open: do not spin.
        std::thread::sleep(Duration::from_millis(5));
    }
}

/// What becomes of a whole line on its way, without its line end; none where it is lost.
pub type Tap = Box<dyn FnMut(&str) -> Option<String> + Send>;

/// Two serial devices joined by a thread: what one program sends, the other hears.
#[derive(Debug)]
pub struct NullModem {
    /// Name of one end.
    pub a: PathBuf,
    /// Name of the other end.
    pub b: PathBuf,
    stop: Arc<AtomicBool>,
    bridge: Option<JoinHandle<()>>,
}

impl NullModem {
    /// A null modem with ends `NAME.a` and `NAME.b` in a folder.
    #[must_use]
    pub fn new(folder: &Path, name: &str) -> Self {
        Self::tapped(folder, name, None)
    }

    /// The same; what `NAME.a` says passes the tap line by line.
    #[must_use]
    pub fn tapped(folder: &Path, name: &str, mut tap: Option<Tap>) -> Self {
        let (a, b) = (
            folder.join(format!("{name}.a")),
            folder.join(format!("{name}.b")),
        );
        let (mut left, right) = (Line::new(&a), Line::new(&b));
        let stop = Arc::new(AtomicBool::new(false));
        let stopped = stop.clone();
        let bridge = std::thread::spawn(move || {
            before_others();
            while !stopped.load(Ordering::Relaxed) {
                let there = match &mut tap {
                    Some(tap) => pass_tapped(&mut left, &right, tap),
                    None => pass(&left, &right),
                };
                let moved = there + pass(&right, &left);
                if moved == 0 {
                    wait_either(&left, &right);
                }
            }
        });
        Self {
            a,
            b,
            stop,
            bridge: Some(bridge),
        }
    }
}

impl Drop for NullModem {
    fn drop(&mut self) {
        self.stop.store(true, Ordering::Relaxed);
        if let Some(bridge) = self.bridge.take() {
            let _ = bridge.join();
        }
    }
}

/// A real cable waits for no processor: the calling thread goes before ordinary work, where the system permits it.
fn before_others() {
    let thread = nix::unistd::gettid().to_string();
    let _made = crate::alone();
    let _ = std::process::Command::new("chrt")
        .args(["--fifo", "--pid", "5", &thread])
        .stdout(std::process::Stdio::null())
        .stderr(std::process::Stdio::null())
        .status();
}

/// Whole lines only; what is left waits for its end.
fn pass_tapped(from: &mut Line, to: &Line, tap: &mut Tap) -> usize {
    let mut buffer = [0; 4096];
    let (Some(mut source), Some(mut sink)) = (from.master.as_deref(), to.master.as_deref()) else {
        return 0;
    };
    let count = source.read(&mut buffer).unwrap_or(0);
    from.heard.extend_from_slice(&buffer[..count]);
    while let Some(end) = from.heard.iter().position(|byte| *byte == b'\n') {
        let line: Vec<u8> = from.heard.drain(..=end).collect();
        if let Some(said) = tap(String::from_utf8_lossy(&line).trim_end()) {
            let _ = sink.write(format!("{said}\r\n").as_bytes());
        }
    }
    count
}

fn pass(from: &Line, to: &Line) -> usize {
    let mut buffer = [0; 4096];
    let (Some(mut source), Some(mut sink)) = (from.master.as_deref(), to.master.as_deref()) else {
        return 0;
    };
    let count = source.read(&mut buffer).unwrap_or(0);
    // A full line loses bytes, as a serial line without handshake does.
    let _ = sink.write(&buffer[..count]);
    count
}

fn wait_either(left: &Line, right: &Line) {
    if let (Some(a), Some(b)) = (&left.master, &right.master) {
        let mut set = [
            PollFd::new(a.as_fd(), PollFlags::POLLIN),
            PollFd::new(b.as_fd(), PollFlags::POLLIN),
        ];
        let _ = poll(&mut set, PollTimeout::from(100_u16));
    }
}

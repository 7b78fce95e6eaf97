//! Whether the machine's pseudo-terminals carry bytes in time: in a trial at another pace the clock waits for them.
//!
//! The system carries them by ordinary threads of its own, which on a busy machine come late by tenths of a second: seconds on
//! board at ten times the clock's pace, in which the ships would sail on and hear nothing.

use crate::clock::Clock;
use crate::realtime;
use nix::sys::termios::{SetArg, cfmakeraw, tcgetattr, tcsetattr};
use std::fs::File;
use std::io::{Read, Result, Write};
use std::sync::atomic::{AtomicU64, Ordering};
use std::sync::{Arc, Weak};
use std::time::Duration;

/// Between a byte that is back and the next.
const PAUSE: Duration = Duration::from_millis(5);

/// Processors that are looked at.
const PROCESSORS: usize = 16;

/// Bytes that go to and fro on pseudo-terminals of their own, one a processor: what one of them hands on, its own thread of the
/// system carries, and a program at the other end of a line may run on any.
#[derive(Debug)]
pub(crate) struct Lines {
    clock: Clock,
    /// When the byte that is on its way was sent, microseconds; 0: none is.
    sent: Vec<Arc<AtomicU64>>,
}

impl Lines {
    /// Begins; the bytes go until this value is gone.
    ///
    /// # Errors
    /// The system gives no pseudo-terminal, or no thread.
    pub(crate) fn begin() -> Result<Self> {
        let clock = Clock::start();
        let processors = std::thread::available_parallelism().map_or(1, usize::from);
        let sent: Result<Vec<_>> = (0..processors.min(PROCESSORS))
            .map(|processor| look(clock, processor))
            .collect();
        Ok(Self { clock, sent: sent? })
    }

    /// For how long the slowest byte has been on its way, microseconds.
    pub(crate) fn behind(&self) -> u64 {
        let now = self.clock.micros();
        let behind = |sent: &Arc<AtomicU64>| match sent.load(Ordering::Relaxed) {
            0 => 0,
            sent => now.saturating_sub(sent),
        };
        self.sent.iter().map(behind).max().unwrap_or(0)
    }
}

/// Begins to look at the lines of one processor.
fn look(clock: Clock, processor: usize) -> Result<Arc<AtomicU64>> {
    let pair = nix::pty::openpty(None, None)?;
    let mut modes = tcgetattr(&pair.slave)?;
    cfmakeraw(&mut modes);
    tcsetattr(&pair.slave, SetArg::TCSANOW, &modes)?;
    let (far, near) = (File::from(pair.master), File::from(pair.slave));
    let sent = Arc::new(AtomicU64::new(0));
    let told = Arc::downgrade(&sent);
    std::thread::Builder::new()
        .name("lines".to_owned())
        .spawn(move || {
            realtime::ask(realtime::PORTS);
            stay(processor);
            // Without a line there is nothing to wait for.
            let _ = go(clock, &told, far, near);
            if let Some(sent) = told.upgrade() {
                sent.store(0, Ordering::Relaxed);
            }
        })?;
    Ok(sent)
}

/// Keeps the calling thread on a processor, where the system permits it.
#[cfg(target_os = "linux")]
fn stay(processor: usize) {
    use nix::sched::{CpuSet, sched_setaffinity};
    let mut set = CpuSet::new();
    if set.set(processor).is_ok() {
        let _ = sched_setaffinity(nix::unistd::Pid::from_raw(0), &set);
    }
}

/// Elsewhere it runs where it runs.
#[cfg(not(target_os = "linux"))]
fn stay(_processor: usize) {}

fn go(clock: Clock, told: &Weak<AtomicU64>, mut far: File, mut near: File) -> Result<()> {
    let mut byte = [b'*'];
    while let Some(sent) = told.upgrade() {
        sent.store(clock.micros().max(1), Ordering::Relaxed);
        far.write_all(&byte)?;
        near.read_exact(&mut byte)?;
        near.write_all(&byte)?;
        far.read_exact(&mut byte)?;
        sent.store(0, Ordering::Relaxed);
        drop(sent);
        std::thread::sleep(PAUSE);
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_byte_comes_back_and_is_sent_again() {
        let lines = Lines::begin().unwrap();
        // On its way at some time, and back at another.
        let (mut away, mut back) = (false, false);
        for _ in 0..100_000 {
            match lines.sent[0].load(Ordering::Relaxed) {
                0 => back = true,
                _ => away = true,
            }
            if away && back {
                break;
            }
            std::thread::sleep(Duration::from_micros(50));
        }
        assert!(away && back);
    }
}

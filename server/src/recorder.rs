//! `--record`: everything that happens and everything that comes of it, written by a thread of its own (CFG-1).
//!
//! **Invariant:** the control thread never waits for the disk. Where the disk cannot follow, the recording
//! ends there, and what was written replays.

use crate::error::{Error, reason};
use std::fs::File;
use std::io::{BufRead, BufReader, BufWriter, Write};
use std::path::Path;
use std::sync::mpsc::{Receiver, RecvTimeoutError, SyncSender, TrySendError, sync_channel};
use std::thread::JoinHandle;
use std::time::Duration;
use wheelover_core::recording::{self, Replay, Replayed};
use wheelover_core::time::Stamp;
use wheelover_core::voyage::{Event, VoyageConfig, VoyageOutput};

/// Entries that may wait for the disk: some seconds at the fastest pace.
const QUEUE: usize = 32_768;

/// Version of this program, as it stands in a recording.
const VERSION: &str = env!("CARGO_PKG_VERSION");

/// What is written.
enum Entry {
    Event(Stamp, Event),
    Output(Stamp, VoyageOutput),
}

/// The control thread's end.
pub(crate) struct Recorder {
    sender: Option<SyncSender<Entry>>,
    writer: Option<JoinHandle<()>>,
}

impl Recorder {
    /// Begins a recording of a voyage that is made so.
    ///
    /// # Errors
    /// The file cannot be written.
    pub(crate) fn begin(path: &Path, made: &VoyageConfig) -> Result<Self, Error> {
        let failed = |source| Error::File {
            path: path.display().to_string(),
            source,
        };
        let mut file = BufWriter::new(File::create(path).map_err(failed)?);
        writeln!(file, "{}", recording::beginning(made, VERSION))
            .and_then(|()| file.flush())
            .map_err(failed)?;
        let (sender, receiver) = sync_channel(QUEUE);
        let name = path.display().to_string();
        let writer = std::thread::Builder::new()
            .name("recorder".to_owned())
            .spawn(move || {
                if let Err(error) = write(file, &receiver) {
                    tracing::warn!("{name}: the recording ends here: {}", reason(&error));
                }
            })
            .map_err(failed)?;
        Ok(Self {
            sender: Some(sender),
            writer: Some(writer),
        })
    }

    /// Notes an event before it takes effect.
    pub(crate) fn event(&mut self, at: Stamp, event: &Event) {
        self.put(|| Entry::Event(at, event.clone()));
    }

    /// Notes an output.
    pub(crate) fn output(&mut self, at: Stamp, output: &VoyageOutput) {
        self.put(|| Entry::Output(at, output.clone()));
    }

    fn put(&mut self, entry: impl FnOnce() -> Entry) {
        let Some(sender) = &self.sender else { return };
        match sender.try_send(entry()) {
            Ok(()) => {}
            Err(TrySendError::Full(_)) => {
                tracing::warn!("the disk does not follow: the recording ends here");
                self.sender = None;
            }
            Err(TrySendError::Disconnected(_)) => self.sender = None,
        }
    }
}

impl Drop for Recorder {
    fn drop(&mut self) {
        self.sender = None;
        if let Some(writer) = self.writer.take() {
            let _ = writer.join();
        }
    }
}

fn write(mut file: BufWriter<File>, entries: &Receiver<Entry>) -> std::io::Result<()> {
    loop {
        match entries.recv_timeout(Duration::from_millis(500)) {
            Ok(Entry::Event(at, event)) => writeln!(file, "{}", recording::event(at, &event))?,
            Ok(Entry::Output(at, output)) => writeln!(file, "{}", recording::output(at, &output))?,
            Err(RecvTimeoutError::Timeout) => file.flush()?,
            Err(RecvTimeoutError::Disconnected) => return file.flush(),
        }
    }
}

/// Runs a recording again; the exit code is 1 where the outputs differ, and what is said is one line, after the
/// settings that this program does not know.
///
/// # Errors
/// The file cannot be read, or is no recording that this program can run.
pub(crate) fn replay(path: &Path, quiet: bool) -> Result<i32, Error> {
    let name = path.display().to_string();
    let unread = |source| Error::File {
        path: name.clone(),
        source,
    };
    let mut file = BufReader::new(File::open(path).map_err(unread)?);
    let mut replay = Replay::default();
    let mut line = String::new();
    loop {
        line.clear();
        file.read_line(&mut line).map_err(unread)?;
        // A recording that was cut off ends within a line.
        let Some(whole) = line.strip_suffix('\n') else {
            break;
        };
        replay
            .take(whole)
            .map_err(|error| Error::Other(format!("{name}: {error}")))?;
    }
    let done = replay
        .end()
        .map_err(|error| Error::Other(format!("{name}: {error}")))?;
    for note in &done.notes {
        println!("{name}: {note}");
    }
    if let Some(difference) = &done.difference {
        println!("{name}: {difference} ({})", whose(&done));
        return Ok(1);
    }
    if !quiet {
        let (events, outputs) = (done.events, done.outputs);
        println!("{name}: {events} events and {outputs} outputs: all the same");
    }
    Ok(0)
}

/// What a difference is due to, as far as it can be told.
fn whose(done: &Replayed) -> String {
    match done.program.as_str() {
        VERSION => format!("recorded by this version, {VERSION}"),
        "" => format!(
            "recorded in format {} by an earlier version; this is {VERSION}, which may do otherwise",
            done.format
        ),
        other => format!("recorded by version {other}; this is {VERSION}, which may do otherwise"),
    }
}

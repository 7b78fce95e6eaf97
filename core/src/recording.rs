//! A log of inputs and outputs that can be run again (CFG-1). JSON lines: how it began, then what happened and what came of it.
//!
//! In: a voyage's configuration and its events. Out: text lines, and from them the same voyage again. A recording begins
//! where its stations begin, so that it needs no image of them and outlives every change of their insides; one that is
//! begun later has what happened before, without what came of it. Ticks need no record: [`Voyage::handle`] runs
//! everything due before an event takes effect. The format is described in `docs/recording.md`.

mod entry;
mod first_format;
mod form;

use crate::time::Stamp;
use crate::voyage::{Event, Voyage, VoyageConfig, VoyageOutput};
use alloc::collections::VecDeque;
use alloc::string::{String, ToString};
use alloc::vec::Vec;
use core::fmt;
use entry::{Entry, Taken, Timed};
use form::Beginning;
pub use form::FORMAT;
use serde::Serialize;

/// First line of a recording: how the voyage is made, and the version of the program that runs it.
#[must_use]
pub fn beginning(config: &VoyageConfig, program: &str) -> String {
    text(&Beginning::of(config, program))
}

/// Line of an event.
#[must_use]
pub fn event(at: Stamp, event: &Event) -> String {
    text(&Timed(at, event.clone().into()))
}

/// Line of an output; `at` is the voyage's time after the call that gave it.
#[must_use]
pub fn output(at: Stamp, output: &VoyageOutput) -> String {
    text(&Timed(at, output.clone().into()))
}

/// Line that says: outputs until `at` were not written, from here on they are.
#[must_use]
pub fn outputs_begin(at: Stamp) -> String {
    text(&Timed(at, Entry::OutputsBegin))
}

/// What a recording turned out to be.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Replayed {
    /// Its format as written.
    pub format: u32,
    /// Version of the program that wrote it; empty where that is not known.
    pub program: String,
    /// Events fed in.
    pub events: u64,
    /// Outputs that came out as recorded, up to the first difference.
    pub outputs: u64,
    /// Settings that this program does not know or allow.
    pub notes: Vec<String>,
    /// The first output that is not as recorded.
    pub difference: Option<Difference>,
}

/// An output that differs from the recorded one.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Difference {
    /// Number of the recorded line, from 1.
    pub line: usize,
    /// Time of the recorded output, milliseconds.
    pub at: u64,
    /// What was recorded.
    pub recorded: String,
    /// What was computed; empty where nothing was.
    pub computed: String,
}

impl fmt::Display for Difference {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let computed = match self.computed.as_str() {
            "" => "nothing",
            computed => computed,
        };
        let at = self.at as f64 / 1000.0;
        let (line, recorded) = (self.line, &self.recorded);
        write!(
            f,
            "line {line}, {at:.3} s: recorded {recorded}, computed {computed}"
        )
    }
}

/// Why a recording cannot be run.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum RecordingError {
    /// The first line is not one of a recording.
    NoRecording,
    /// A later program wrote it.
    Newer {
        /// Its format.
        format: u64,
    },
    /// It begins with the image of a program in the middle of a voyage (format 1).
    Image,
    /// A line cannot be read.
    Unreadable {
        /// Its number, from 1.
        line: usize,
        /// What is wrong with it.
        text: String,
    },
}

impl fmt::Display for RecordingError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::NoRecording => f.write_str("line 1: this is no recording"),
            Self::Newer { format } => write!(
                f,
                "line 1: format {format}, this program reads up to {FORMAT}: replay it with a later version"
            ),
            Self::Image => f.write_str(
                "line 1: format 1 with an image from the middle of a voyage: replay it with the version that wrote it",
            ),
            Self::Unreadable { line, text } => write!(f, "line {line}: {text}"),
        }
    }
}

/// A recording that is run again, line by line.
#[derive(Debug, Default)]
pub struct Replay {
    voyage: Option<Voyage>,
    line: usize,
    computed: VecDeque<VoyageOutput>,
    fresh: Vec<VoyageOutput>,
    replayed: Replayed,
}

impl Replay {
    /// Takes the next line, without its end.
    ///
    /// # Errors
    /// It cannot be read; nothing more can be taken then.
    pub fn take(&mut self, line: &str) -> Result<(), RecordingError> {
        self.line += 1;
        if self.voyage.is_none() {
            return self.begin(line);
        }
        let read = if self.replayed.format == 1 {
            first_format::entry(line)
        } else {
            serde_json::from_str(line)
        };
        let entry = read.map_err(|error| self.unreadable(&error))?;
        self.entry(entry);
        Ok(())
    }

    /// The voyage as far as it has come; none before the first line.
    #[must_use]
    pub const fn voyage(&self) -> Option<&Voyage> {
        self.voyage.as_ref()
    }

    /// What it turned out to be.
    ///
    /// # Errors
    /// No line was taken.
    pub fn end(self) -> Result<Replayed, RecordingError> {
        match self.voyage {
            Some(_) => Ok(self.replayed),
            None => Err(RecordingError::NoRecording),
        }
    }

    fn begin(&mut self, line: &str) -> Result<(), RecordingError> {
        let first: serde_json::Value =
            serde_json::from_str(line).map_err(|_| RecordingError::NoRecording)?;
        let mut behind = None;
        let (form, format) = if first.get("checkpoint").is_some() {
            let (form, entry) = first_format::beginning(&first).ok_or(RecordingError::Image)?;
            behind = entry;
            (form, 1)
        } else {
            let format = first.get("recording").and_then(serde_json::Value::as_u64);
            match format.ok_or(RecordingError::NoRecording)? {
                format if format > u64::from(FORMAT) => {
                    return Err(RecordingError::Newer { format });
                }
                _ => (first, FORMAT),
            }
        };
        let form: Beginning =
            serde_json::from_value(form).map_err(|error| self.unreadable(&error))?;
        self.replayed.format = format;
        self.replayed.program.clone_from(&form.program);
        let (config, notes) = form.voyage().map_err(|fault| self.unreadable(&fault))?;
        self.replayed.notes = notes;
        self.voyage = Some(Voyage::configured(config));
        behind.into_iter().for_each(|entry| self.entry(entry));
        Ok(())
    }

    fn unreadable(&self, why: &dyn fmt::Display) -> RecordingError {
        RecordingError::Unreadable {
            line: self.line,
            text: why.to_string(),
        }
    }

    fn entry(&mut self, Timed(at, entry): Timed) {
        match entry.taken() {
            Taken::In(event) => {
                self.run(at, event);
                self.replayed.events += 1;
            }
            Taken::OutputsBegin => {
                self.run(at, Event::Tick);
                self.computed.clear();
            }
            Taken::Out(recorded) => self.compare(at, &recorded),
        }
    }

    fn run(&mut self, at: Stamp, event: Event) {
        if let Some(voyage) = &mut self.voyage {
            voyage.handle(at, event, &mut self.fresh);
        }
        self.computed.extend(self.fresh.drain(..));
        if self.replayed.difference.is_some() {
            self.computed.clear();
        }
    }

    fn compare(&mut self, at: Stamp, recorded: &VoyageOutput) {
        if self.replayed.difference.is_some() {
            return;
        }
        if self.computed.is_empty() {
            self.run(at, Event::Tick);
        }
        let computed = self.computed.pop_front();
        if computed.as_ref() == Some(recorded) {
            self.replayed.outputs += 1;
            return;
        }
        let words = |output: &VoyageOutput| text(&Entry::from(output.clone()));
        self.replayed.difference = Some(Difference {
            line: self.line,
            at: at.0,
            recorded: words(recorded),
            computed: computed.as_ref().map_or_else(String::new, words),
        });
    }
}

/// Runs a recording again and compares every output; what comes after a difference is run, not compared.
///
/// # Errors
/// The first line that cannot be read.
pub fn replay<'a>(lines: impl IntoIterator<Item = &'a str>) -> Result<Replayed, RecordingError> {
    let mut replay = Replay::default();
    for line in lines {
        replay.take(line)?;
    }
    replay.end()
}

fn text<T: Serialize>(value: &T) -> String {
    // Every state is finite numbers, texts and lists of them, which always have a text.
    serde_json::to_string(value).unwrap_or_default()
}

#[cfg(test)]
mod tests;

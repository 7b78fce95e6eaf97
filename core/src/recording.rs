//! A log of inputs and outputs that can be run again (CFG-1). JSON lines: a checkpoint, then what happened.
//!
//! In: a voyage and its events. Out: text lines, and from them the same voyage again. Ticks need no
//! record: [`Voyage::handle`] runs everything due before an event takes effect.

use crate::time::Stamp;
use crate::voyage::{Event, Voyage, VoyageOutput};
use alloc::boxed::Box;
use alloc::collections::VecDeque;
use alloc::string::{String, ToString};
use alloc::vec::Vec;
use core::fmt;
use serde::{Deserialize, Serialize};

/// Raised whenever an older recording can no longer be read.
pub const FORMAT: u32 = 1;

/// One line of a recording.
#[derive(Clone, Debug, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
enum Entry {
    /// The state at the start.
    Checkpoint {
        /// [`FORMAT`].
        format: u32,
        /// The whole voyage.
        voyage: Box<Voyage>,
    },
    /// An event and its time.
    Event(Stamp, Event),
    /// An output and the time of the step that gave it.
    Output(Stamp, VoyageOutput),
}

/// What a recording turned out to be.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Replayed {
    /// Events fed in.
    pub events: u64,
    /// Outputs that came out as recorded.
    pub outputs: u64,
}

/// Why a recording could not be run to its end.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum RecordingError {
    /// The first line is no checkpoint of this format.
    NoCheckpoint,
    /// A line cannot be read.
    Unreadable {
        /// Its number, from 1.
        line: usize,
        /// What is wrong with it.
        text: String,
    },
    /// An output differs from the recorded one.
    Different {
        /// Number of the recorded line, from 1.
        line: usize,
        /// Time of the recorded output, milliseconds.
        at: u64,
        /// What was recorded.
        recorded: String,
        /// What was computed; empty where nothing was.
        computed: String,
    },
}

impl fmt::Display for RecordingError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::NoCheckpoint => write!(f, "line 1: no checkpoint of format {FORMAT}"),
            Self::Unreadable { line, text } => write!(f, "line {line}: {text}"),
            Self::Different {
                line,
                at,
                recorded,
                computed,
            } => write!(
                f,
                "line {line}, {:.3} s: recorded {recorded}, computed {}",
                *at as f64 / 1000.0,
                if computed.is_empty() {
                    "nothing"
                } else {
                    computed
                }
            ),
        }
    }
}

/// First line of a recording: the voyage as it is.
#[must_use]
pub fn checkpoint(voyage: &Voyage) -> String {
    text(&Entry::Checkpoint {
        format: FORMAT,
        voyage: Box::new(voyage.clone()),
    })
}

/// Line of an event. A tick needs none.
#[must_use]
pub fn event(at: Stamp, event: &Event) -> String {
    text(&Entry::Event(at, event.clone()))
}

/// Line of an output; `at` is the voyage's time after the call that gave it.
#[must_use]
pub fn output(at: Stamp, output: &VoyageOutput) -> String {
    text(&Entry::Output(at, output.clone()))
}

/// Runs a recording again and compares every output.
///
/// # Errors
/// The first line that cannot be read, or the first difference.
pub fn replay<'a>(lines: impl IntoIterator<Item = &'a str>) -> Result<Replayed, RecordingError> {
    let mut voyage: Option<Voyage> = None;
    let mut computed = VecDeque::new();
    let mut fresh = Vec::new();
    let mut replayed = Replayed {
        events: 0,
        outputs: 0,
    };
    for (index, line) in lines.into_iter().enumerate() {
        let number = index + 1;
        let entry = serde_json::from_str(line);
        let entry = match (entry, &voyage) {
            (Ok(entry), _) => entry,
            (Err(_), None) => return Err(RecordingError::NoCheckpoint),
            (Err(error), Some(_)) => {
                return Err(RecordingError::Unreadable {
                    line: number,
                    text: error.to_string(),
                });
            }
        };
        match (entry, &mut voyage) {
            (
                Entry::Checkpoint {
                    format: FORMAT,
                    voyage: start,
                },
                slot @ None,
            ) => *slot = Some(*start),
            (_, None) => return Err(RecordingError::NoCheckpoint),
            (Entry::Checkpoint { .. }, Some(_)) => {
                let text = "a second checkpoint".to_string();
                return Err(RecordingError::Unreadable { line: number, text });
            }
            (Entry::Event(at, event), Some(voyage)) => {
                voyage.handle(at, event, &mut fresh);
                computed.extend(fresh.drain(..));
                replayed.events += 1;
            }
            (Entry::Output(at, recorded), Some(voyage)) => {
                if computed.is_empty() {
                    voyage.handle(at, Event::Tick, &mut fresh);
                    computed.extend(fresh.drain(..));
                }
                let found = computed.pop_front();
                if found.as_ref() != Some(&recorded) {
                    return Err(RecordingError::Different {
                        line: number,
                        at: at.0,
                        recorded: text(&recorded),
                        computed: found.as_ref().map_or_else(String::new, text),
                    });
                }
                replayed.outputs += 1;
            }
        }
    }
    match voyage {
        Some(_) => Ok(replayed),
        None => Err(RecordingError::NoCheckpoint),
    }
}

fn text<T: Serialize>(value: &T) -> String {
    // Every state is finite numbers, texts and lists of them, which always have a text.
    serde_json::to_string(value).unwrap_or_default()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::command::{FaultKind, Order, Origin};

    fn record(seconds: u64) -> Vec<String> {
        let mut voyage = Voyage::embedded(3);
        let mut out = Vec::new();
        // The checkpoint is taken under way, so that every state is in it.
        voyage.handle(Stamp(130_000), Event::Tick, &mut out);
        let mut lines = alloc::vec![checkpoint(&voyage)];
        let fault = |cable: &str, kind, on| Order::Fault {
            cable: cable.into(),
            kind,
            on,
        };
        for second in 1..=seconds {
            let now = Stamp(130_000 + second * 1_000);
            let action = match second {
                20 => Some(fault("ecdis", FaultKind::Silent, true)),
                60 => Some(fault("ecdis", FaultKind::Silent, false)),
                200 => Some(fault("gyro1", FaultKind::Jump, true)),
                260 => Some(fault("gyro1", FaultKind::Jump, false)),
                400 => Some(fault("gps", FaultKind::Jump, true)),
                _ => None,
            };
            let happened = action.map_or(Event::Tick, |action| Event::Order {
                id: second,
                by: Origin::Officer,
                order: action,
            });
            if happened != Event::Tick {
                lines.push(event(now, &happened));
            }
            out.clear();
            voyage.handle(now, happened, &mut out);
            lines.extend(out.iter().map(|o| output(now, o)));
        }
        lines
    }

    // CFG-1
    #[test]
    fn a_recorded_voyage_with_faults_replays_with_identical_outputs() {
        let lines = record(500);
        let replayed = replay(lines.iter().map(String::as_str)).unwrap();
        assert_eq!(replayed.events, 5);
        assert_eq!(replayed.outputs + 6, lines.len() as u64);
    }

    #[test]
    fn the_first_difference_is_named_with_line_and_time() {
        let mut lines = record(2);
        let index = lines
            .iter()
            .position(|line| line.contains("AGHTD"))
            .unwrap();
        lines[index] = lines[index].replace("AGHTD", "AGHTX");
        let error = replay(lines.iter().map(String::as_str)).unwrap_err();
        assert!(matches!(error, RecordingError::Different { line, .. } if line == index + 1));
        assert_eq!(replay(["nonsense"]), Err(RecordingError::NoCheckpoint));
    }
}

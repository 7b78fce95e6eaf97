//! What the checker of a dialogue collects: one second of the chart system, and breaches with the moment they belong to.

use crate::nmea::{Gll, Htc, Pney1, Pney2, Xte};
use alloc::string::String;
use alloc::vec::Vec;
use serde::{Deserialize, Serialize};

/// A breach of the rules of the dialogue.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Breach {
    /// Time of the line, seconds; null where the lines have no time.
    pub at: Option<f64>,
    /// Number of the line at which it was seen.
    pub line: u64,
    /// The rule, by its ID.
    pub rule: String,
    /// Situation in force; null in heading control and before the first HTC.
    pub situation: Option<u8>,
    /// What is wrong.
    pub text: String,
}

/// A situation and how long it lasted.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Span {
    /// 1 to 6.
    pub situation: u8,
    /// Time of its first burst, seconds.
    pub from: Option<f64>,
    /// Time of its last burst, seconds.
    pub to: Option<f64>,
}

/// What the chart system said in one second.
#[derive(Clone, Debug, Default, Serialize, Deserialize)]
pub(super) struct Burst {
    pub(super) line: u64,
    pub(super) at: Option<f64>,
    pub(super) last: Option<f64>,
    pub(super) heard: Vec<String>,
    pub(super) htc: Option<Htc>,
    pub(super) xte: Option<Xte>,
    pub(super) pney1: Option<Pney1>,
    pub(super) pney2: Option<Pney2>,
    pub(super) gll: Option<Gll>,
}

/// Collects breaches with the moment they belong to.
pub(super) struct Report<'a> {
    pub(super) at: Option<f64>,
    pub(super) line: u64,
    pub(super) situation: Option<u8>,
    pub(super) breaches: &'a mut Vec<Breach>,
}

impl Report<'_> {
    pub(super) fn breach(&mut self, rule: &str, text: impl Into<String>) {
        self.breaches.push(Breach {
            at: self.at,
            line: self.line,
            rule: rule.into(),
            situation: self.situation,
            text: text.into(),
        });
    }
}

//! The port doctor: what is wrong with a line, from what is heard of it, and what to change.
//!
//! In: bytes heard at one rate or several, the rate that is set, what was said on the line. Out: findings in a fitter's words.
//! Nothing is ever sent.

mod heard;
mod inverted;

pub use heard::Heard;

use alloc::format;
use alloc::string::String;
use alloc::vec::Vec;
use serde::Serialize;

/// A line in use by more than this is too full (FB12), per cent.
const FULL_PERCENT: u64 = 80;
/// A line with more damage than this is a bad one, per cent.
const DAMAGED_PERCENT: u64 = 3;

/// What is found of a line.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum Finding {
    /// Sentences come as they should.
    Good,
    /// Nothing comes.
    Silent,
    /// Something comes that is no sentence at any rate.
    Noise,
    /// Sentences come at another rate than is set.
    OtherRate {
        /// The rate, baud.
        baud: u32,
    },
    /// The two wires are changed.
    Swapped,
    /// What is heard is what was said here.
    Echo,
    /// The line is full.
    Overloaded {
        /// How full, per cent.
        percent: u64,
    },
    /// Sentences come damaged.
    Damaged {
        /// How many, per cent.
        percent: u64,
    },
    /// The adapter does not go at the rate that is set.
    RateRefused {
        /// The rate at which it goes, baud.
        baud: u32,
    },
}

impl Finding {
    /// What it is and what to change.
    #[must_use]
    pub fn text(self) -> String {
        match self {
            Self::Good => "good".into(),
            Self::Silent => "nothing comes: look at the wires, at the sender's output and at its supply".into(),
            Self::Noise => "bytes come that are no sentence at any rate: look at the ground wire and the shield, and whether \
                            the device speaks NMEA 0183"
                .into(),
            Self::OtherRate { baud } => format!("it speaks at {baud} baud: set baud = {baud}"),
            Self::Swapped => "A and B are changed: change the two wires at one end".into(),
            Self::Echo => "it hears what is said here: take the sending wire off the receiving one, or the adapter's echo off".into(),
            Self::Overloaded { percent } => format!(
                "the line is {percent} % full: have the sender say less or less often, or take 38400 baud at both ends"
            ),
            Self::Damaged { percent } => format!(
                "{percent} % come damaged: look at the contacts, the ground wire and the length of the line"
            ),
            Self::RateRefused { baud } => {
                format!("the adapter goes at {baud} baud whatever is set: take another adapter")
            }
        }
    }
}

/// What is found of a line.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Diagnosis {
    /// What is wrong, the first thing to change first; only [`Finding::Good`] where nothing is.
    pub findings: Vec<Finding>,
    /// What was heard at the rate at which most was understood; at the set one where nothing was.
    pub heard: Heard,
}

/// Bytes that were heard at a rate.
#[derive(Clone, Copy, Debug)]
pub struct Sample<'a> {
    /// The rate that was asked of the device, baud.
    pub baud: u32,
    /// The rate at which it then went, baud.
    pub goes: u32,
    /// For how long it was listened to, milliseconds.
    pub ms: u64,
    /// What came.
    pub bytes: &'a [u8],
}

/// What is wrong with a line. `set`: its rate in the configuration, where there is one; `said`: the lines said on it meanwhile.
#[must_use]
pub fn diagnose(set: Option<u32>, samples: &[Sample<'_>], said: &[Vec<u8>]) -> Diagnosis {
    let mut findings = Vec::new();
    let asked = samples.iter().find(|sample| Some(sample.baud) == set);
    if let Some(sample) = asked.filter(|sample| sample.goes != sample.baud) {
        findings.push(Finding::RateRefused { baud: sample.goes });
    }
    let heard = samples.iter().flat_map(|sample| {
        let (ms, bytes) = (sample.ms, sample.bytes);
        [
            Heard::of(sample.goes, ms, bytes),
            Heard::of_swapped(sample.goes, ms, bytes),
        ]
    });
    let heard: Vec<Heard> = heard.collect();
    let best = heard.iter().filter(|heard| heard.is_understood());
    let best = best
        .max_by_key(|heard| heard.valid * 1000 / heard.ms.max(1))
        .cloned();
    let Some(best) = best else {
        let silent = heard.iter().all(|heard| heard.bytes == 0);
        findings.push(if silent {
            Finding::Silent
        } else {
            Finding::Noise
        });
        let at_set = heard
            .into_iter()
            .find(|heard| set.is_none_or(|set| heard.baud == set));
        return Diagnosis {
            findings,
            heard: at_set.unwrap_or_default(),
        };
    };
    if best.swapped {
        findings.push(Finding::Swapped);
    }
    if set.is_some_and(|set| set != best.baud) && findings.is_empty() {
        findings.push(Finding::OtherRate { baud: best.baud });
    }
    if !best.swapped {
        if best.said(said) * 2 > best.valid {
            findings.push(Finding::Echo);
        }
        if best.load_percent() > FULL_PERCENT {
            let percent = best.load_percent();
            findings.push(Finding::Overloaded { percent });
        }
        if best.damaged_percent() > DAMAGED_PERCENT {
            let percent = best.damaged_percent();
            findings.push(Finding::Damaged { percent });
        }
    }
    if findings.is_empty() {
        findings.push(Finding::Good);
    }
    Diagnosis {
        findings,
        heard: best,
    }
}

#[cfg(test)]
mod tests;

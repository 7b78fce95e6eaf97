//! The checker beside a dialogue that has no end, and one of any length (CON-2): it counts every breach and keeps the last ones only.

use super::checker::Checker;
use super::report::{Breach, Span};
use alloc::collections::{BTreeMap, VecDeque};
use alloc::string::String;
use alloc::vec::Vec;
use serde::Serialize;

/// Breaches that are kept.
const BREACHES: usize = 50;
/// Situations that are kept.
const SPANS: usize = 40;

/// A checker that runs on and on in the same memory.
#[derive(Clone, Debug, Default)]
pub struct Live {
    checker: Checker,
    recent: VecDeque<Breach>,
    rules: BTreeMap<String, u64>,
}

/// What a running checker has found.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Found {
    /// Lines taken.
    pub lines: u64,
    /// Those of the dialogue between chart system and autopilot.
    pub sentences: u64,
    /// Breaches found.
    pub breaches: u64,
    /// How many of each rule, by its ID.
    pub rules: BTreeMap<String, u64>,
    /// The last breaches, the oldest first.
    pub recent: Vec<Breach>,
    /// Situation in force; null in heading control and before the first HTC.
    pub situation: Option<u8>,
    /// The last situations with their times, the oldest first.
    pub situations: Vec<Span>,
}

impl Live {
    /// Takes the next line; `at` in seconds, `number` as it is reported. Gives what it found in it.
    pub fn take(&mut self, number: u64, at: Option<f64>, text: &[u8]) -> Vec<Breach> {
        let mut found = Vec::new();
        self.checker.take(number, at, text, &mut found);
        self.keep(&found);
        found
    }

    /// The end of a recorded dialogue: judges the last burst.
    pub fn finish(&mut self) {
        let mut found = Vec::new();
        self.checker.finish(&mut found);
        self.keep(&found);
    }

    fn keep(&mut self, found: &[Breach]) {
        self.checker.forget(SPANS);
        for breach in found {
            *self.rules.entry(breach.rule.clone()).or_default() += 1;
            self.recent.push_back(breach.clone());
        }
        while self.recent.len() > BREACHES {
            self.recent.pop_front();
        }
    }

    /// What it has found so far.
    #[must_use]
    pub fn found(&self) -> Found {
        Found {
            lines: self.checker.lines(),
            sentences: self.checker.sentences(),
            breaches: self.checker.breaches(),
            rules: self.rules.clone(),
            recent: self.recent.iter().cloned().collect(),
            situation: self.checker.situation(),
            situations: self.checker.spans().to_vec(),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::nmea::with_checksum;

    /// A second of heading control, then one of track control, again and again: each is a breach or two, and a situation.
    fn run(seconds: u64) -> Live {
        let mut live = Live::default();
        for second in 0..seconds {
            let mode = if second % 2 == 0 { "T,R" } else { "S,N" };
            let body = alloc::format!("EIHTC,V,,,{mode},,,,,,,245.0,T,C");
            let (at, line) = (Some(second as f64), with_checksum(&body));
            live.take(second + 1, at, line.as_bytes());
        }
        live
    }

    // CON-2
    #[test]
    fn it_counts_all_and_keeps_the_last_in_the_same_memory() {
        let (short, long) = (run(300).found(), run(3_000).found());
        assert_eq!((short.lines, long.lines), (300, 3_000));
        assert!(long.breaches > short.breaches && short.breaches > BREACHES as u64);
        assert_eq!(
            (short.recent.len(), long.recent.len()),
            (BREACHES, BREACHES)
        );
        assert_eq!(
            (short.situations.len(), long.situations.len()),
            (SPANS, SPANS)
        );
        assert_eq!(long.rules.values().sum::<u64>(), long.breaches);
        assert_eq!(short.rules.len(), long.rules.len());
        let last = long.recent.last().expect("it is not empty");
        assert!(last.line >= 2_990, "{last:?}");
    }
}

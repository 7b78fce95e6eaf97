//! What is heard of a line at one rate and polarity, counted.

use super::inverted;
use crate::nmea::{self, Checksum, FrameKind, Framer};
use alloc::collections::BTreeMap;
use alloc::string::{String, ToString};
use alloc::vec::Vec;
use serde::Serialize;

/// What was heard.
#[derive(Clone, Debug, Default, PartialEq, Serialize)]
pub struct Heard {
    /// Line rate at which it was listened to, baud.
    pub baud: u32,
    /// With the two wires changed, as the bytes would then be.
    pub swapped: bool,
    /// For how long, milliseconds.
    pub ms: u64,
    /// Bytes.
    pub bytes: u64,
    /// Sentences with a right checksum, or without one.
    pub valid: u64,
    /// Sentences with a wrong checksum.
    pub wrong_checksum: u64,
    /// Pieces that are no sentence.
    pub garbage: u64,
    /// How many of each address, `HEHDT`.
    pub sentences: BTreeMap<String, u64>,
    #[serde(skip)]
    lines: Vec<Vec<u8>>,
}

impl Heard {
    /// Bytes that came at a rate in so many milliseconds.
    #[must_use]
    pub fn of(baud: u32, ms: u64, bytes: &[u8]) -> Self {
        let mut heard = Self {
            baud,
            ms,
            bytes: bytes.len() as u64,
            ..Self::default()
        };
        let mut framer = Framer::new();
        framer.push(bytes, &mut |frame| heard.take(frame.kind, frame.text));
        // What has no end yet was cut by the end of listening: it is no fault of the line.
        heard
    }

    /// What the same bytes are with the two wires changed; or where an adapter mends start and stop bits and not the others.
    #[must_use]
    pub fn of_swapped(baud: u32, ms: u64, bytes: &[u8]) -> Self {
        let mut heard = Self::of(baud, ms, &inverted::sentences(bytes));
        if heard.valid == 0 {
            let others: Vec<u8> = bytes.iter().map(|byte| !byte).collect();
            heard = Self::of(baud, ms, &others);
        }
        Self {
            swapped: true,
            bytes: bytes.len() as u64,
            ..heard
        }
    }

    fn take(&mut self, kind: FrameKind, text: &[u8]) {
        if kind == FrameKind::Garbage {
            self.garbage += 1;
            return;
        }
        let sentence = nmea::decode(text);
        match sentence.checksum {
            Checksum::Wrong { .. } => self.wrong_checksum += 1,
            _ if sentence.formatter.is_empty() => self.garbage += 1,
            _ => {
                self.valid += 1;
                let address = sentence.address().to_string();
                *self.sentences.entry(address).or_default() += 1;
                self.lines.push(text.to_vec());
            }
        }
    }

    /// Whether this is how the line speaks: sentences come, and more of them than of anything else.
    #[must_use]
    pub fn is_understood(&self) -> bool {
        self.valid >= 2 && self.valid > self.wrong_checksum + self.garbage
    }

    /// Part of what came that was damaged, per cent.
    #[must_use]
    pub fn damaged_percent(&self) -> u64 {
        let damaged = self.wrong_checksum + self.garbage;
        (100 * damaged)
            .checked_div(damaged + self.valid)
            .unwrap_or(0)
    }

    /// Part of the line's rate that is in use, per cent: ten bits a byte.
    #[must_use]
    pub fn load_percent(&self) -> u64 {
        let most = u64::from(self.baud) / 10 * self.ms / 1000;
        (100 * self.bytes).checked_div(most).unwrap_or(0)
    }

    /// Who speaks, and how they are called: `HE`.
    #[must_use]
    pub fn talkers(&self) -> Vec<String> {
        let mut talkers: Vec<String> = Vec::new();
        for address in self.sentences.keys() {
            let length = if address.starts_with('P') { 4 } else { 2 };
            let talker: String = address.chars().take(length).collect();
            if !talkers.contains(&talker) {
                talkers.push(talker);
            }
        }
        talkers
    }

    /// How many of the sentences are among those that were said.
    #[must_use]
    pub fn said(&self, said: &[Vec<u8>]) -> u64 {
        self.lines.iter().filter(|line| said.contains(line)).count() as u64
    }
}

//! Pololu Jrk G2, compact protocol (its user's guide, 10 to 12): a controller with analog feedback, told a duty cycle.
//!
//! Each step asks for the feedback (2 bytes at 06h) and for errors and current (9 bytes at 12h). The answers have no frame:
//! what has come by the next step is one answer of exactly eleven bytes with values in their ranges, or is thrown away. The
//! controller's own command timeout must be on, so that it stops by itself when nobody speaks to it.

use alloc::vec::Vec;
use serde::{Deserialize, Serialize};

/// Stops the motor, until it is told a duty cycle again.
pub const STOP: u8 = 0xFF;
/// Duty cycle target, -600 to 600, two bytes of seven bits follow; errors still stop the motor.
pub const DUTY: u8 = 0xF2;
/// Asks for variables; offset and length follow.
pub const ASK: u8 = 0xE5;
/// Feedback at the upper end of its range.
pub const FULL: u16 = 4_095;
/// The largest supply that it can tell of, 0.001 V.
const SUPPLY_MV: u16 = 60_000;
/// The full duty cycle.
const FULL_DUTY: f64 = 600.0;

/// What is asked for: offset and length.
pub const ASKED: [(u8, u8); 2] = [(0x06, 2), (0x12, 9)];
/// Bytes of both answers.
pub const ANSWER: usize = 11;

/// Bits of the errors that stop the motor.
pub mod error {
    /// No supply.
    pub const NO_POWER: u16 = 1 << 1;
    /// The motor's driver.
    pub const DRIVER: u16 = 1 << 2;
    /// The feedback is not connected.
    pub const NO_FEEDBACK: u16 = 1 << 5;
    /// Too much current, as set.
    pub const SOFT_CURRENT: u16 = 1 << 6;
    /// Too much current for the controller.
    pub const HARD_CURRENT: u16 = 1 << 13;
    /// All that there are.
    pub const ALL: u16 = (1 << 14) - 1;
}

/// What a controller answered.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Answer {
    /// Scaled feedback, 0 to 4095.
    pub feedback: u16,
    /// Errors that stop the motor.
    pub errors: u16,
    /// Supply, 0.001 V.
    pub voltage: u16,
    /// Current, 0.001 A.
    pub current: u16,
}

impl Answer {
    /// Its eleven bytes.
    #[must_use]
    pub fn bytes(self) -> [u8; ANSWER] {
        let [f0, f1] = self.feedback.to_le_bytes();
        let [e0, e1] = self.errors.to_le_bytes();
        let [v0, v1] = self.voltage.to_le_bytes();
        let [c0, c1] = self.current.to_le_bytes();
        [f0, f1, e0, e1, e0, e1, 0, v0, v1, c0, c1]
    }

    fn of(bytes: &[u8]) -> Option<Self> {
        let [f0, f1, e0, e1, o0, o1, _, v0, v1, c0, c1] = *bytes else {
            return None;
        };
        let occurred = u16::from_le_bytes([o0, o1]);
        let answer = Self {
            feedback: u16::from_le_bytes([f0, f1]),
            errors: u16::from_le_bytes([e0, e1]),
            voltage: u16::from_le_bytes([v0, v1]),
            current: u16::from_le_bytes([c0, c1]),
        };
        // What stops the motor has occurred; the supply is one that the controller can tell of.
        let whole = answer.feedback <= FULL
            && answer.errors & !error::ALL == 0
            && occurred & answer.errors == answer.errors
            && answer.voltage <= SUPPLY_MV;
        whole.then_some(answer)
    }
}

/// Says a speed from -1 to 1.
pub fn say_speed(part: f64, out: &mut Vec<u8>) {
    let duty = libm::round(FULL_DUTY * part.clamp(-1.0, 1.0)) as i16;
    out.extend([DUTY, (duty & 0x7F) as u8, ((duty >> 7) & 0x7F) as u8]);
}

/// The speed that two bytes of seven bits say, -1 to 1; absent beyond the full one.
#[must_use]
pub fn speed([low, high]: [u8; 2]) -> Option<f64> {
    let bits = i16::from(low) | (i16::from(high) << 7);
    let duty = f64::from((bits << 2) >> 2);
    let known = low < 0x80 && high < 0x80 && libm::fabs(duty) <= FULL_DUTY;
    known.then_some(duty / FULL_DUTY)
}

/// Asks for what [`Reader::take`] then gives.
pub fn ask(out: &mut Vec<u8>) {
    for (offset, length) in ASKED {
        out.extend([ASK, offset, length]);
    }
}

/// What has come since it was asked.
#[derive(Clone, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
pub struct Reader {
    part: Vec<u8>,
    /// Bytes that belonged to no answer.
    pub lost: u64,
}

impl Reader {
    /// Takes a byte; the answer that it ends, if it is the last one of an answer.
    pub fn take(&mut self, byte: u8) -> Option<Answer> {
        if self.part.len() <= ANSWER {
            self.part.push(byte);
        }
        let answer = Answer::of(&self.part);
        if answer.is_none() && self.part.len() >= ANSWER {
            self.lost += 1;
        }
        answer
    }

    /// Forgets what came, before it is asked again.
    pub fn begin(&mut self) {
        self.part.clear();
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    // The user's guide, 12: a duty cycle is 14 bits, the lower seven first.
    #[test]
    fn duty_cycles_are_said_and_heard() {
        for (part, bytes) in [
            (0.0, [DUTY, 0x00, 0x00]),
            (1.0, [DUTY, 0x58, 0x04]),
            (-1.0, [DUTY, 0x28, 0x7B]),
            (0.5, [DUTY, 0x2C, 0x02]),
        ] {
            let mut said = Vec::new();
            say_speed(part, &mut said);
            assert_eq!(said, bytes, "{part}");
            let heard = speed([bytes[1], bytes[2]]).expect("a duty cycle");
            assert!((heard - part).abs() < 1e-9, "{part}");
        }
        assert_eq!(speed([0x59, 0x04]), None, "601");
        assert_eq!(speed([0x80, 0x00]), None);
    }

    #[test]
    fn an_answer_is_whole_or_nothing() {
        let answer = Answer {
            feedback: 2_048,
            errors: error::NO_FEEDBACK,
            voltage: 12_600,
            current: 1_500,
        };
        let bytes = answer.bytes();
        let read = |bytes: &[u8]| {
            let mut reader = Reader::default();
            let found = bytes.iter().filter_map(|byte| reader.take(*byte)).last();
            (found, reader)
        };
        assert_eq!(read(&bytes).0, Some(answer));
        assert_eq!(read(&bytes[1..]).0, None, "a byte is lost");
        let mut wild = bytes;
        wild[1] = 0x40;
        assert_eq!(read(&wild).0, None, "feedback beyond its range");
        let (_, mut reader) = read(&bytes[3..]);
        reader.begin();
        let next = bytes.iter().filter_map(|byte| reader.take(*byte)).last();
        assert_eq!(next, Some(answer), "the next one is whole again");
    }
}

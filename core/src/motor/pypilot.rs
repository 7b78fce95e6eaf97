//! The open servo protocol of pypilot: packets of four bytes, `code, low, high, CRC`.
//!
//! CRC-8 over the first three bytes: polynomial `x^8 + x^5 + x^4 + 1` (31h), first value FFh, the highest bit first. There is
//! no other framing: a reader slides byte by byte until four agree. A command of 0 to 2000 is the motor's speed from full
//! one way to full the other, 1000 is none; feedback of 0 to 65472 is the range of the sensor, 65535 says that there is none.

use alloc::vec::Vec;
use serde::{Deserialize, Serialize};

/// What is said to a controller, and by it.
pub mod code {
    /// Speed, 0 to 2000; engages the clutch.
    pub const COMMAND: u8 = 0xC7;
    /// Forget a fault.
    pub const RESET: u8 = 0xE7;
    /// Largest current, 0.01 A.
    pub const MAX_CURRENT: u8 = 0x1E;
    /// Open the clutch, no current.
    pub const DISENGAGE: u8 = 0x68;
    /// Current, 0.01 A.
    pub const CURRENT: u8 = 0x1C;
    /// Supply, 0.01 V.
    pub const VOLTAGE: u8 = 0xB3;
    /// Where the rudder is.
    pub const RUDDER: u8 = 0xA7;
    /// What is the matter ([`super::flag`]).
    pub const FLAGS: u8 = 0x8F;
}

/// Bits of the flags.
pub mod flag {
    /// Too hot.
    pub const TOO_HOT: u16 = 1 << 1;
    /// Too much current.
    pub const OVER_CURRENT: u16 = 1 << 2;
    /// The clutch is closed.
    pub const ENGAGED: u16 = 1 << 3;
    /// End switch to port.
    pub const END_PORT: u16 = 1 << 5;
    /// End switch to starboard.
    pub const END_STARBOARD: u16 = 1 << 6;
    /// The supply is outside what it can use.
    pub const BAD_VOLTAGE: u16 = 1 << 7;
    /// Feedback at its least.
    pub const LEAST_RUDDER: u16 = 1 << 8;
    /// Feedback at its most.
    pub const MOST_RUDDER: u16 = 1 << 9;
}

/// Feedback at the upper end of its range.
pub const FULL: u16 = 65_472;
/// Feedback that says that there is none.
pub const NONE: u16 = 65_535;
/// Command of no speed.
const STILL: f64 = 1000.0;

/// A packet that came whole.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Packet {
    /// What it says.
    pub code: u8,
    /// How much.
    pub value: u16,
}

impl Packet {
    /// Its four bytes.
    #[must_use]
    pub fn bytes(self) -> [u8; 4] {
        let [low, high] = self.value.to_le_bytes();
        [self.code, low, high, crc(&[self.code, low, high])]
    }
}

/// The command of a speed from -1 to 1.
#[must_use]
pub fn speed(part: f64) -> Packet {
    Packet {
        code: code::COMMAND,
        value: (STILL * (1.0 + part.clamp(-1.0, 1.0)) + 0.5) as u16,
    }
}

/// The speed of a command, -1 to 1; absent where it is none.
#[must_use]
pub fn commanded(packet: Packet) -> Option<f64> {
    let said = packet.code == code::COMMAND && packet.value <= 2000;
    said.then(|| f64::from(packet.value) / STILL - 1.0)
}

/// What has come of a packet.
#[derive(Clone, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
pub struct Reader {
    part: Vec<u8>,
    /// Bytes that belonged to no packet.
    pub lost: u64,
}

impl Reader {
    /// The packet that a byte ends, if it ends one.
    pub fn take(&mut self, byte: u8) -> Option<Packet> {
        self.part.push(byte);
        let [code, low, high, check] = *self.part.as_slice() else {
            return None;
        };
        if crc(&[code, low, high]) == check {
            self.part.clear();
            return Some(Packet {
                code,
                value: u16::from_le_bytes([low, high]),
            });
        }
        self.part.remove(0);
        self.lost += 1;
        None
    }
}

fn crc(bytes: &[u8]) -> u8 {
    bytes.iter().fold(0xFF, |crc, byte| {
        (0..8).fold(crc ^ byte, |crc, _| {
            let shifted = crc << 1;
            if crc & 0x80 == 0 {
                shifted
            } else {
                shifted ^ 0x31
            }
        })
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    fn read(bytes: &[u8]) -> (Vec<Packet>, u64) {
        let mut reader = Reader::default();
        let packets = bytes.iter().filter_map(|byte| reader.take(*byte)).collect();
        (packets, reader.lost)
    }

    // The check value that is published for this CRC over "123456789" (CRC-8/NRSC-5: F7).
    #[test]
    fn the_crc_is_the_published_one() {
        assert_eq!(crc(b"123456789"), 0xF7);
    }

    #[test]
    fn speeds_are_said_and_heard() {
        for (part, value) in [
            (0.0, 1000),
            (1.0, 2000),
            (-1.0, 0),
            (0.5, 1500),
            (7.0, 2000),
        ] {
            let packet = speed(part);
            assert_eq!(packet.value, value);
            let back = commanded(packet).expect("a command");
            assert!((back - part.clamp(-1.0, 1.0)).abs() < 1e-9);
        }
        assert_eq!(
            commanded(Packet {
                code: code::COMMAND,
                value: 2001
            }),
            None
        );
        assert_eq!(
            commanded(Packet {
                code: code::RESET,
                value: 1000
            }),
            None
        );
    }

    #[test]
    fn a_packet_is_found_again_after_what_is_lost_or_added() {
        let first = speed(0.25);
        let second = Packet {
            code: code::RUDDER,
            value: 40_000,
        };
        let mut bytes = [first.bytes(), second.bytes()].concat();
        assert_eq!(read(&bytes), ([first, second].to_vec(), 0));
        bytes.remove(1);
        assert_eq!(read(&bytes).0, [second], "a lost byte costs its packet");
        bytes.splice(0..0, [0xC7, 0x00]);
        assert_eq!(read(&bytes).0, [second]);
        let mut damaged = second.bytes();
        damaged[2] ^= 0x10;
        assert_eq!(read(&damaged), (Vec::new(), 1));
    }
}

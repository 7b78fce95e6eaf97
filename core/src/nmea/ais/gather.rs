//! From sentences to messages: VDM, VDO, ABM, BBM and TTD of one port.

use super::fault::{MessageFault, MessageFaultKind};
use super::message::RadioMessage;
use super::tables::{APPROACH, TARGET};
use crate::nmea::{Assembler, Checksum, Message, Sentence};
use crate::time::Stamp;
use alloc::string::String;
use alloc::vec::Vec;

/// Joins the sentences of one port to messages.
#[derive(Clone, Debug, Default)]
pub struct Gatherer {
    assembler: Assembler,
}

/// What the sentences of a message carry.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Gathered {
    /// A message as it was on the radio (VDM), or as own station sent it (VDO).
    Radio {
        /// Six-bit armoured characters.
        payload: String,
        /// Bits of the last one that do not count.
        fill_bits: u32,
    },
    /// Something that an AIS unit is to send (ABM, BBM).
    ToSend {
        /// Station that is addressed; none in a BBM.
        destination: Option<u32>,
        /// Number of the radio message.
        number: u8,
        /// Six-bit armoured characters.
        payload: String,
        /// Bits of the last one that do not count.
        fill_bits: u32,
    },
    /// Tracked targets (TTD).
    Targets {
        /// Six-bit armoured characters.
        payload: String,
        /// Bits of the last one that do not count.
        fill_bits: u32,
    },
}

impl Gatherer {
    /// A gatherer that has heard nothing.
    #[must_use]
    pub fn new() -> Self {
        Self::default()
    }

    /// Takes a sentence; gives the message that it completes. A sentence with a wrong checksum gives none.
    pub fn push(&mut self, now: Stamp, sentence: &Sentence<'_>) -> Option<Gathered> {
        if !matches!(sentence.formatter, "VDM" | "VDO" | "ABM" | "BBM" | "TTD") {
            return None;
        }
        if number(sentence, 1) == Some(1) && number(sentence, 2) == Some(1) {
            return single(sentence);
        }
        match self.assembler.push(now, sentence)? {
            Message::Radio {
                payload, fill_bits, ..
            } => Some(Gathered::Radio { payload, fill_bits }),
            Message::ToSend {
                destination,
                number,
                payload,
                fill_bits,
            } => Some(Gathered::ToSend {
                destination,
                number: number?,
                payload,
                fill_bits,
            }),
            Message::Targets { payload, fill_bits } => {
                Some(Gathered::Targets { payload, fill_bits })
            }
            _ => None,
        }
    }
}

fn number(sentence: &Sentence<'_>, field: usize) -> Option<u32> {
    core::str::from_utf8(sentence.fields.get(field))
        .ok()?
        .parse()
        .ok()
}

/// The message of one sentence, with its faults.
fn single(sentence: &Sentence<'_>) -> Option<Gathered> {
    if matches!(sentence.checksum, Checksum::Wrong { .. }) {
        return None;
    }
    // Which fields are payload and fill bits.
    let (payload, fill) = match sentence.formatter {
        "ABM" => (7, 8),
        "BBM" => (6, 7),
        "TTD" => (4, 5),
        _ => (5, 6),
    };
    let payload = crate::nmea::explain::latin1(sentence.fields.get(payload));
    let fill_bits = match sentence.fields.get(fill) {
        [] => 0,
        // What is no number is a fault of its field, and of the message.
        _ => number(sentence, fill).unwrap_or(u32::MAX),
    };
    Some(match sentence.formatter {
        "ABM" => Gathered::ToSend {
            destination: number(sentence, 4),
            number: number(sentence, 6).and_then(|n| u8::try_from(n).ok())?,
            payload,
            fill_bits,
        },
        "BBM" => Gathered::ToSend {
            destination: None,
            number: number(sentence, 5).and_then(|n| u8::try_from(n).ok())?,
            payload,
            fill_bits,
        },
        "TTD" => Gathered::Targets { payload, fill_bits },
        _ => Gathered::Radio { payload, fill_bits },
    })
}

impl Gathered {
    /// Its armoured characters and fill bits.
    #[must_use]
    pub fn payload(&self) -> (&str, u32) {
        match self {
            Self::Radio { payload, fill_bits }
            | Self::ToSend {
                payload, fill_bits, ..
            }
            | Self::Targets { payload, fill_bits } => (payload, *fill_bits),
        }
    }

    /// The messages in it: one, or one a target; and what is wrong besides their own faults.
    #[must_use]
    pub fn messages(&self) -> (Vec<RadioMessage<'_>>, Vec<MessageFault>) {
        let (payload, fill_bits) = self.payload();
        let payload = payload.as_bytes();
        match self {
            Self::Radio { .. } => (
                alloc::vec![RadioMessage::decode(payload, fill_bits)],
                Vec::new(),
            ),
            Self::ToSend { number, .. } => (
                alloc::vec![RadioMessage::contents(*number, payload, fill_bits)],
                Vec::new(),
            ),
            Self::Targets { .. } => targets(payload, fill_bits),
        }
    }
}

/// The targets of a TTD. Each is a whole number of characters: 15 for a target, 7 for its closest approach.
fn targets(payload: &[u8], fill_bits: u32) -> (Vec<RadioMessage<'_>>, Vec<MessageFault>) {
    let mut targets = Vec::new();
    let mut faults = Vec::new();
    let mut fault = |kind| faults.push(MessageFault { field: None, kind });
    if fill_bits > 5 {
        fault(MessageFaultKind::BadFillBits(fill_bits));
    }
    let mut rest = payload;
    while let Some(&first) = rest.first() {
        let layout = match first {
            b'0'..=b'?' => &TARGET,
            b'@'..=b'O' => &APPROACH,
            0x50..=0x57 | 0x60..=0x77 => {
                let six = if first < 0x60 { first - 48 } else { first - 56 };
                fault(MessageFaultKind::UnknownType(six >> 4));
                break;
            }
            byte => {
                let place = payload.len() - rest.len() + 1;
                fault(MessageFaultKind::BadCharacter { place, byte });
                break;
            }
        };
        let length = layout.least / 6;
        if rest.len() < length {
            // Zeros fill up.
            if rest.iter().any(|&byte| byte != b'0') {
                let (found, least) = (rest.len() * 6, layout.least);
                fault(MessageFaultKind::TooShort { found, least });
            }
            break;
        }
        let (target, behind) = rest.split_at(length);
        targets.push(RadioMessage::target(target, layout));
        rest = behind;
    }
    if payload.is_empty() {
        fault(MessageFaultKind::Empty);
    }
    (targets, faults)
}

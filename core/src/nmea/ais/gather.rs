//! From sentences to messages: VDM, VDO, ABM, BBM and TTD of one port.

use super::fault::{MessageFault, MessageFaultKind};
use super::message::RadioMessage;
use super::tables::{APPROACH, TARGET};
use crate::nmea::{Assembler, Checksum, Message, Sentence};
use crate::time::Stamp;
use alloc::borrow::Cow;
use alloc::vec::Vec;

/// Joins the sentences of one port to messages.
#[derive(Clone, Debug, Default)]
pub struct Gatherer {
    assembler: Assembler,
}

/// What the sentences of a message carry. The data of a single sentence are borrowed from its line.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Gathered<'a> {
    /// A message as it was on the radio (VDM), or as own station sent it (VDO).
    Radio {
        /// Six-bit armoured characters.
        payload: Cow<'a, [u8]>,
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
        payload: Cow<'a, [u8]>,
        /// Bits of the last one that do not count.
        fill_bits: u32,
    },
    /// Tracked targets (TTD).
    Targets {
        /// Six-bit armoured characters.
        payload: Cow<'a, [u8]>,
        /// Bits of the last one that do not count.
        fill_bits: u32,
    },
}

/// The sentences that carry messages.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Carrier {
    Radio,
    Addressed,
    Broadcast,
    Targets,
}

impl Gatherer {
    /// A gatherer that has heard nothing.
    #[must_use]
    pub fn new() -> Self {
        Self::default()
    }

    /// Takes a sentence; gives the message that it completes. A sentence with a wrong checksum gives none.
    pub fn push<'a>(&mut self, now: Stamp, sentence: &Sentence<'a>) -> Option<Gathered<'a>> {
        let carrier = match sentence.formatter {
            "VDM" | "VDO" => Carrier::Radio,
            "ABM" => Carrier::Addressed,
            "BBM" => Carrier::Broadcast,
            "TTD" => Carrier::Targets,
            _ => return None,
        };
        let mut fields = sentence.fields.cursor();
        let mut next = || fields.part().text();
        if number(next()) == Some(1) && number(next()) == Some(1) {
            return single(carrier, sentence.checksum, next);
        }
        match self.assembler.push(now, sentence)? {
            Message::Radio {
                payload, fill_bits, ..
            } => Some(Gathered::Radio {
                payload: Cow::Owned(payload.into_bytes()),
                fill_bits,
            }),
            Message::ToSend {
                destination,
                number,
                payload,
                fill_bits,
            } => Some(Gathered::ToSend {
                destination,
                number: number?,
                payload: Cow::Owned(payload.into_bytes()),
                fill_bits,
            }),
            Message::Targets { payload, fill_bits } => Some(Gathered::Targets {
                payload: Cow::Owned(payload.into_bytes()),
                fill_bits,
            }),
            _ => None,
        }
    }
}

fn number(field: &[u8]) -> Option<u32> {
    match field {
        [digit @ b'0'..=b'9'] => Some(u32::from(digit - b'0')),
        _ => core::str::from_utf8(field).ok()?.parse().ok(),
    }
}

/// The message of one sentence, with its faults; `next` gives its fields from the third on.
fn single<'a>(
    carrier: Carrier,
    checksum: Checksum,
    mut next: impl FnMut() -> &'a [u8],
) -> Option<Gathered<'a>> {
    if matches!(checksum, Checksum::Wrong { .. }) {
        return None;
    }
    let _sequence = next();
    let destination = match carrier {
        Carrier::Addressed => number(next()),
        _ => None,
    };
    if carrier != Carrier::Targets {
        let _channel = next();
    }
    let message = match carrier {
        Carrier::Addressed | Carrier::Broadcast => Some(u8::try_from(number(next())?).ok()?),
        _ => None,
    };
    let payload = Cow::Borrowed(next());
    let fill_bits = match next() {
        [] => 0,
        // What is no number is a fault of its field, and of the message.
        field => number(field).unwrap_or(u32::MAX),
    };
    Some(match (carrier, message) {
        (Carrier::Targets, _) => Gathered::Targets { payload, fill_bits },
        (_, Some(number)) => Gathered::ToSend {
            destination,
            number,
            payload,
            fill_bits,
        },
        _ => Gathered::Radio { payload, fill_bits },
    })
}

impl Gathered<'_> {
    /// Its armoured characters and fill bits.
    #[must_use]
    pub fn payload(&self) -> (&[u8], u32) {
        match self {
            Self::Radio { payload, fill_bits }
            | Self::ToSend {
                payload, fill_bits, ..
            }
            | Self::Targets { payload, fill_bits } => (payload, *fill_bits),
        }
    }

    /// The same, with data of its own.
    #[must_use]
    pub fn into_owned(self) -> Gathered<'static> {
        let own = |payload: Cow<'_, [u8]>| Cow::Owned(payload.into_owned());
        match self {
            Self::Radio { payload, fill_bits } => Gathered::Radio {
                payload: own(payload),
                fill_bits,
            },
            Self::ToSend {
                destination,
                number,
                payload,
                fill_bits,
            } => Gathered::ToSend {
                destination,
                number,
                payload: own(payload),
                fill_bits,
            },
            Self::Targets { payload, fill_bits } => Gathered::Targets {
                payload: own(payload),
                fill_bits,
            },
        }
    }

    /// Gives the messages in it to `sink`, one, or one a target; and what is wrong besides their own faults to `faults`.
    #[inline]
    pub fn each<'s>(
        &'s self,
        mut sink: impl FnMut(&RadioMessage<'s>),
        faults: &mut Vec<MessageFault>,
    ) {
        let (payload, fill_bits) = self.payload();
        match self {
            Self::Radio { .. } => {
                // Read where it stands: a whole one that is moved has to be waited for.
                let mut message = RadioMessage::new(payload, fill_bits);
                message.take();
                sink(&message);
            }
            Self::ToSend { number, .. } => {
                sink(&RadioMessage::contents(*number, payload, fill_bits));
            }
            Self::Targets { .. } => targets(payload, fill_bits, &mut sink, faults),
        }
    }

    /// The messages in it, and what is wrong besides their own faults.
    #[must_use]
    pub fn messages(&self) -> (Vec<RadioMessage<'_>>, Vec<MessageFault>) {
        let (mut messages, mut faults) = (Vec::new(), Vec::new());
        self.each(|message| messages.push(message.clone()), &mut faults);
        (messages, faults)
    }
}

/// The targets of a TTD. Each is a whole number of characters: 15 for a target, 7 for its closest approach.
fn targets<'s>(
    payload: &'s [u8],
    fill_bits: u32,
    sink: &mut dyn FnMut(&RadioMessage<'s>),
    faults: &mut Vec<MessageFault>,
) {
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
        sink(&RadioMessage::target(target, layout));
        rest = behind;
    }
    if payload.is_empty() {
        fault(MessageFaultKind::Empty);
    }
}

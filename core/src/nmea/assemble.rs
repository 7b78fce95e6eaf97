//! Joins what is spread over several sentences: ALF, ALC, RTE, GSV, VDM, VDO, ABM, BBM and TTD. One assembler a port.
//!
//! **Invariant:** at most 16 messages and 32 KiB are held; the oldest goes first, and none is kept over 10 s.

use super::tables::{Alc, AlcEntry, Alf, Gsv, GsvSatellite, RouteMode, Rte};
use super::value::latin1;
use super::{Sentence, decode};
use crate::time::Stamp;
use alloc::string::String;
use alloc::vec::Vec;
use serde::{Deserialize, Serialize};

/// A whole message.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Message {
    /// An alert (ALF) with its description from the second sentence.
    Alert {
        /// The first sentence.
        alert: Alf,
        /// The text of the second one.
        description: Option<String>,
    },
    /// All entries of a cyclic alert list (ALC).
    AlertList(Vec<AlcEntry>),
    /// A route (RTE).
    Route {
        /// Its name.
        route: Option<String>,
        /// Whether it is the complete or the working route.
        mode: Option<RouteMode>,
        /// Its waypoints.
        waypoints: Vec<String>,
    },
    /// All satellites in view of a talker and signal (GSV).
    Satellites(Vec<GsvSatellite>),
    /// A radio message (VDM, VDO).
    Radio {
        /// Sent by own ship (VDO).
        own: bool,
        /// Its six-bit armoured data.
        payload: String,
        /// Bits of the last character that do not count.
        fill_bits: u32,
    },
    /// A message that an AIS unit is to send (ABM, BBM).
    ToSend {
        /// Station that is addressed; none in a BBM.
        destination: Option<u32>,
        /// Number of the radio message.
        number: Option<u8>,
        /// Its six-bit armoured data.
        payload: String,
        /// Bits of the last character that do not count.
        fill_bits: u32,
    },
    /// Tracked targets (TTD).
    Targets {
        /// Its six-bit armoured data.
        payload: String,
        /// Bits of the last character that do not count.
        fill_bits: u32,
    },
}

const MOST_MESSAGES: usize = 16;
const MOST_BYTES: usize = 32 * 1024;
const MOST_PARTS: u32 = 99;
const OLDEST_MS: u64 = 10_000;
/// Bytes of the fields that tell messages apart; more do not count.
const LONGEST_KEY: usize = 64;

/// Joins the sentences of one port.
///
/// ```
/// use wheelover_core::nmea::{decode, with_checksum, Assembler, Message};
/// use wheelover_core::time::Stamp;
/// let mut assembler = Assembler::new();
/// let mut message = None;
/// for body in ["GPRTE,2,1,c,HOME,WP1,WP2", "GPRTE,2,2,c,HOME,WP3"] {
///     let line = with_checksum(body);
///     message = assembler.push(Stamp(0), &decode(line.as_bytes()));
/// }
/// let Some(Message::Route { waypoints, .. }) = message else { panic!("a route") };
/// assert_eq!(waypoints, ["WP1", "WP2", "WP3"]);
/// ```
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Assembler {
    open: Vec<Open>,
}

#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
struct Open {
    key: Vec<u8>,
    total: u32,
    /// How many parts are there.
    parts: u32,
    /// Their payloads, or their lines (ISO 8859-1), each with a line end.
    text: String,
    destination: Option<u32>,
    message: Option<u8>,
    began: Stamp,
}

/// Its place in its message.
struct Place {
    key: Key,
    total: u32,
    number: u32,
}

/// The fields that tell messages apart.
struct Key {
    bytes: [u8; LONGEST_KEY],
    length: usize,
}

impl Assembler {
    /// An assembler that has heard nothing.
    #[must_use]
    pub fn new() -> Self {
        Self::default()
    }

    /// Bytes of memory that are held, with what the lists have in reserve (FB7).
    #[must_use]
    pub fn held(&self) -> usize {
        let one = |open: &Open| size_of::<Open>() + open.key.capacity() + open.text.capacity();
        self.open.iter().map(one).sum()
    }

    /// Takes a sentence; gives the message that it completes. A faulty or strange part ends its message.
    pub fn push(&mut self, now: Stamp, sentence: &Sentence<'_>) -> Option<Message> {
        let place = place(sentence)?;
        self.open.retain(|open| now.since(open.began) <= OLDEST_MS);
        let at = self
            .open
            .iter()
            .position(|open| open.key == place.key.bytes());
        let whole = !sentence.checksum.is_right() || !sentence.field_faults().is_empty();
        if whole
            || place.total == 0
            || place.number == 0
            || place.number > place.total
            || place.total > MOST_PARTS
        {
            at.map(|at| self.open.remove(at));
            return None;
        }
        if place.number == 1 {
            at.map(|at| self.open.remove(at));
            let open = Open::new(now, &place, sentence);
            if place.total == 1 {
                return open.close(sentence);
            }
            self.open.push(open);
            self.bound();
            return None;
        }
        let open = self.open.get_mut(at?)?;
        if open.total != place.total || open.parts + 1 != place.number {
            self.open.remove(at?);
            return None;
        }
        open.add(sentence);
        if place.number == place.total {
            return self.open.remove(at?).close(sentence);
        }
        self.bound();
        None
    }

    fn bound(&mut self) {
        while self.open.len() > MOST_MESSAGES || self.held() > MOST_BYTES {
            self.open.remove(0);
        }
    }
}

/// Which message a sentence is a part of, and which one.
fn place(sentence: &Sentence<'_>) -> Option<Place> {
    // Fields that tell messages apart, besides talker and formatter.
    let marks: &[usize] = match sentence.formatter {
        "ALF" | "ALC" | "TTD" | "ABM" | "BBM" => &[3],
        "RTE" => &[3, 4],
        "GSV" => &[],
        "VDM" | "VDO" => &[3, 4],
        _ => return None,
    };
    let radix = if sentence.formatter == "TTD" { 16 } else { 10 };
    let number = |n: usize| match sentence.fields.get(n) {
        [digit @ b'0'..=b'9'] => Some(u32::from(digit - b'0')),
        text => u32::from_str_radix(core::str::from_utf8(text).ok()?, radix).ok(),
    };
    let mut key = Key::new(sentence.address());
    for &mark in marks {
        key.add(sentence.fields.get(mark));
    }
    if sentence.formatter == "GSV" && sentence.fields.len().is_multiple_of(4) {
        key.add(sentence.fields.get(sentence.fields.len()));
    }
    Some(Place {
        key,
        total: number(1).unwrap_or(0),
        number: number(2).unwrap_or(0),
    })
}

impl Key {
    fn new(address: &str) -> Self {
        let mut key = Self {
            bytes: [0; LONGEST_KEY],
            length: 0,
        };
        key.add(address.as_bytes());
        key
    }

    fn add(&mut self, field: &[u8]) {
        for &byte in field.iter().chain(b",") {
            if let Some(place) = self.bytes.get_mut(self.length) {
                *place = byte;
                self.length += 1;
            }
        }
    }

    fn bytes(&self) -> &[u8] {
        &self.bytes[..self.length]
    }
}

/// The field of the six-bit characters, before that of the fill bits, in sentences that carry them.
fn payload_of(formatter: &str) -> Option<usize> {
    Some(match formatter {
        "VDM" | "VDO" => 5,
        "ABM" => 7,
        "BBM" => 6,
        "TTD" => 4,
        _ => return None,
    })
}

// The parts have no faults, so that their fields can be taken as they stand.
impl Open {
    fn new(now: Stamp, place: &Place, first: &Sentence<'_>) -> Self {
        let (destination, message) = match first.formatter {
            "ABM" => (number(first, 4), number(first, 6)),
            "BBM" => (None, number(first, 5)),
            _ => (None, None),
        };
        let mut open = Self {
            key: place.key.bytes().into(),
            total: place.total,
            parts: 0,
            text: String::with_capacity(128),
            destination,
            message: message.and_then(|number| u8::try_from(number).ok()),
            began: now,
        };
        open.add(first);
        open
    }

    fn add(&mut self, sentence: &Sentence<'_>) {
        self.parts += 1;
        match payload_of(sentence.formatter) {
            Some(field) => {
                let payload = core::str::from_utf8(sentence.fields.get(field));
                self.text.push_str(payload.unwrap_or(""));
            }
            None => {
                self.text.push_str(&latin1(sentence.text));
                self.text.push('\n');
            }
        }
    }

    /// The message that is complete with its last part.
    fn close(self, last: &Sentence<'_>) -> Option<Message> {
        let Some(field) = payload_of(last.formatter) else {
            return join(&self.text, self.parts);
        };
        let payload = self.text;
        let fill_bits = number(last, field + 1).unwrap_or(0);
        Some(match last.formatter {
            "TTD" => Message::Targets { payload, fill_bits },
            "ABM" | "BBM" => Message::ToSend {
                destination: self.destination,
                number: self.message,
                payload,
                fill_bits,
            },
            formatter => Message::Radio {
                own: formatter == "VDO",
                payload,
                fill_bits,
            },
        })
    }
}

/// The message in some lines.
fn join(text: &str, parts: u32) -> Option<Message> {
    let latin1: Vec<u8>;
    let bytes = if text.is_ascii() {
        text.as_bytes()
    } else {
        latin1 = text.chars().map(|c| u32::from(c) as u8).collect();
        &latin1
    };
    let mut sentences: Vec<Sentence<'_>> = Vec::with_capacity(parts as usize);
    sentences.extend(
        bytes
            .split(|&byte| byte == b'\n')
            .filter(|line| !line.is_empty())
            .map(decode),
    );
    let first = sentences.first()?;
    Some(match first.formatter {
        "ALF" => Message::Alert {
            alert: Alf::from_sentence(first)?,
            description: sentences
                .get(1)
                .and_then(Alf::from_sentence)
                .and_then(|alf| alf.text),
        },
        "ALC" => Message::AlertList(
            sentences
                .iter()
                .filter_map(Alc::from_sentence)
                .flat_map(|alc| alc.entries)
                .collect(),
        ),
        "RTE" => {
            let parts: Vec<Rte> = sentences.iter().filter_map(Rte::from_sentence).collect();
            let first = parts.first()?;
            Message::Route {
                route: first.route.clone(),
                mode: first.mode,
                waypoints: parts
                    .iter()
                    .flat_map(|part| &part.waypoints)
                    .filter_map(|waypoint| waypoint.waypoint.clone())
                    .collect(),
            }
        }
        "GSV" => Message::Satellites(
            sentences
                .iter()
                .filter_map(Gsv::from_sentence)
                .flat_map(|gsv| gsv.satellites)
                .collect(),
        ),
        _ => return None,
    })
}

fn number(sentence: &Sentence<'_>, field: usize) -> Option<u32> {
    let text = core::str::from_utf8(sentence.fields.get(field)).ok()?;
    text.parse().ok()
}

#[cfg(test)]
mod tests;

//! A line of a recording after the first: the time in milliseconds, and what happened or came of it.

use crate::command::{Answer, Order, Origin};
use crate::settings::Value;
use crate::station::{Contact, Role, Switch};
use crate::time::Stamp;
use crate::voyage::{Event, Line, VoyageOutput};
use alloc::string::String;
use alloc::vec::Vec;
use serde::de::Error;
use serde::{Deserialize, Deserializer, Serialize, Serializer};

/// Bytes as a text in which each character is one byte (Latin-1).
#[derive(Clone, Debug)]
pub(super) struct Bytes(pub(super) Vec<u8>);

impl Serialize for Bytes {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let text: String = self.0.iter().map(|byte| char::from(*byte)).collect();
        serializer.serialize_str(&text)
    }
}

impl<'de> Deserialize<'de> for Bytes {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        let text = String::deserialize(deserializer)?;
        let bytes = text.chars().map(u8::try_from).collect::<Result<_, _>>();
        bytes
            .map(Self)
            .map_err(|_| D::Error::custom("a character that is no byte"))
    }
}

/// What stands beside the time.
#[derive(Clone, Debug, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub(super) enum Entry {
    /// In: a port heard bytes.
    Heard(usize, Bytes),
    /// In: a port came or went.
    Up(usize, bool),
    /// In: an order, and who gave it.
    Order { id: u64, by: Origin, order: Order },
    /// In: a contact is so now; null where it cannot be read.
    Switch(Switch, Option<bool>),
    /// In: the caller was late by so many milliseconds.
    Stalled(u64),
    /// In: only time has passed.
    Tick,
    /// What came out until now was not written down.
    OutputsBegin,
    /// Out: bytes for a port.
    Sent(usize, Bytes),
    /// Out: a line of the station that is shown.
    Line(Line),
    /// Out: what became of an order.
    Answer(Answer),
    /// Out: a setting to be kept.
    Keep(String, Value),
    /// Out: a contact of a station closes or opens.
    Contact(Role, Contact, bool),
    /// Out: the route document has changed.
    Route,
    /// Out: the settings document has changed.
    Settings,
}

/// A line.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub(super) struct Timed(pub(super) Stamp, pub(super) Entry);

/// Which way an entry goes.
pub(super) enum Taken {
    In(Event),
    Out(VoyageOutput),
    OutputsBegin,
}

impl Entry {
    pub(super) fn taken(self) -> Taken {
        match self {
            Self::Heard(port, Bytes(bytes)) => Taken::In(Event::Bytes { port, bytes }),
            Self::Up(port, up) => Taken::In(Event::PortUp { port, up }),
            Self::Order { id, by, order } => Taken::In(Event::Order { id, by, order }),
            Self::Switch(switch, closed) => Taken::In(Event::Contact { switch, closed }),
            Self::Stalled(ms) => Taken::In(Event::Stalled { ms }),
            Self::Tick => Taken::In(Event::Tick),
            Self::OutputsBegin => Taken::OutputsBegin,
            Self::Sent(port, Bytes(bytes)) => Taken::Out(VoyageOutput::Send { port, bytes }),
            Self::Line(line) => Taken::Out(VoyageOutput::Line(line)),
            Self::Answer(answer) => Taken::Out(VoyageOutput::Answer(answer)),
            Self::Keep(key, value) => Taken::Out(VoyageOutput::Persist { key, value }),
            Self::Contact(station, contact, closed) => Taken::Out(VoyageOutput::Contact {
                station,
                contact,
                closed,
            }),
            Self::Route => Taken::Out(VoyageOutput::Route),
            Self::Settings => Taken::Out(VoyageOutput::Settings),
        }
    }
}

impl From<Event> for Entry {
    fn from(event: Event) -> Self {
        match event {
            Event::Bytes { port, bytes } => Self::Heard(port, Bytes(bytes)),
            Event::PortUp { port, up } => Self::Up(port, up),
            Event::Order { id, by, order } => Self::Order { id, by, order },
            Event::Contact { switch, closed } => Self::Switch(switch, closed),
            Event::Stalled { ms } => Self::Stalled(ms),
            Event::Tick => Self::Tick,
        }
    }
}

impl From<VoyageOutput> for Entry {
    fn from(output: VoyageOutput) -> Self {
        match output {
            VoyageOutput::Send { port, bytes } => Self::Sent(port, Bytes(bytes)),
            VoyageOutput::Line(line) => Self::Line(line),
            VoyageOutput::Answer(answer) => Self::Answer(answer),
            VoyageOutput::Persist { key, value } => Self::Keep(key, value),
            VoyageOutput::Contact {
                station,
                contact,
                closed,
            } => Self::Contact(station, contact, closed),
            VoyageOutput::Route => Self::Route,
            VoyageOutput::Settings => Self::Settings,
        }
    }
}

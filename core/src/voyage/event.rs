//! What happens to a voyage, and what it gives.

use super::line::Line;
use crate::command::{Answer, Order, Origin};
use crate::settings::Value;
use crate::station::{Contact, Role, Switch};
use alloc::string::String;
use alloc::vec::Vec;

/// What happens to a voyage. A log of `(time, event)` is the whole story (CFG-1).
#[derive(Clone, Debug, PartialEq)]
pub enum Event {
    /// Bytes heard on a real port.
    Bytes {
        /// Number of the port in the configuration.
        port: usize,
        /// The bytes.
        bytes: Vec<u8>,
    },
    /// A real port came or went.
    PortUp {
        /// Number of the port in the configuration.
        port: usize,
        /// Whether it is there.
        up: bool,
    },
    /// Somebody asks for something.
    Order {
        /// Number for the answer.
        id: u64,
        /// Who.
        by: Origin,
        /// What.
        order: Order,
    },
    /// A contact that is wired to the autopilot is so now.
    Contact {
        /// Which.
        switch: Switch,
        /// It is closed; absent where it cannot be read.
        closed: Option<bool>,
    },
    /// The caller's loop was late.
    Stalled {
        /// By so many milliseconds.
        ms: u64,
    },
    /// Only time has passed.
    Tick,
}

/// What a voyage gives.
#[derive(Clone, Debug, PartialEq)]
pub enum VoyageOutput {
    /// Bytes for a real port.
    Send {
        /// Number of the port in the configuration.
        port: usize,
        /// The bytes.
        bytes: Vec<u8>,
    },
    /// A line of the station that is shown.
    Line(Line),
    /// What became of a command.
    Answer(Answer),
    /// A setting to be kept.
    Persist {
        /// Name in the settings table.
        key: String,
        /// Value.
        value: Value,
    },
    /// A contact of a station closes or opens.
    Contact {
        /// Whose.
        station: Role,
        /// Which.
        contact: Contact,
        /// It closes.
        closed: bool,
    },
    /// The route document has changed.
    Route,
    /// The settings document has changed.
    Settings,
}

//! Alerts by IEC 62923: one table of numbers and texts, one state machine.

use serde::{Deserialize, Serialize};

/// Priority, highest first.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Priority {
    /// Needs immediate attention and action.
    Alarm,
    /// Needs immediate attention, not yet action.
    Warning,
    /// Needs attention out of the ordinary.
    Caution,
}

/// State of an alert.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum State {
    /// Raised, nobody has taken it: flashing and sounding.
    Unacknowledged,
    /// Raised, silent for 30 s.
    Silenced,
    /// Raised and taken.
    Acknowledged,
    /// Raised, answered for by another system.
    Transferred,
    /// Over, but nobody has taken it.
    RectifiedUnacknowledged,
    /// Not raised.
    Normal,
}

/// Where an alert may be acknowledged.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Serialize, Deserialize)]
pub enum Category {
    /// Only where its reason is shown.
    A,
    /// Anywhere.
    B,
}

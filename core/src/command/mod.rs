//! What can be asked of the stations, and the answer: orders, refusals, answers.

mod htc;

use crate::settings::Value;
use alloc::string::String;
pub use htc::{Remote, htc};
use serde::{Deserialize, Serialize};

/// What is asked: of the autopilot, of our chart-system side, of the embedded voyage.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Order {
    /// Select a mode of the autopilot.
    Mode(ModeRequest),
    /// Set the heading of AUTO, degrees.
    SetHeading(f64),
    /// Change the set heading by so many degrees.
    AdjustHeading(f64),
    /// Acknowledge an alert by its number.
    Acknowledge(u16),
    /// Silence all alerts for 30 s.
    Silence(bool),
    /// Pace of the embedded voyage, 1 to 60.
    Speed(f64),
    /// Give the watch to the scripted officer, or take it.
    Officer(bool),
    /// Injure a cable of the embedded voyage.
    Fault {
        /// Its name.
        cable: String,
        /// How.
        kind: FaultKind,
        /// Begin or end.
        on: bool,
    },
    /// Current of the embedded voyage.
    Current {
        /// Direction towards which it sets, degrees.
        set: f64,
        /// Its speed, knots.
        drift: f64,
    },
    /// Control by our chart-system side.
    Chart(ChartRequest),
    /// Change a setting.
    Setting {
        /// Its name in the settings table.
        key: String,
        /// Its new value.
        value: Value,
    },
}

/// A mode that can be asked for.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum ModeRequest {
    /// STANDBY: always granted.
    Standby,
    /// AUTO on the present heading.
    Auto,
    /// AutoNAV, Tn or Ti as the chart system commands.
    Autonav,
    /// Withdraw a pending AutoNAV selection.
    Cancel,
    /// Follow APB.
    Track,
}

/// What our chart-system side can be asked for.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum ChartRequest {
    /// Track control, "Ti".
    Track,
    /// Remote heading control, "Tn".
    Heading,
    /// Stop controlling.
    Stop,
}

/// What can be done to a cable.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum FaultKind {
    /// Nothing comes through.
    Silent,
    /// Everything comes 3 s late.
    Delayed,
    /// Characters are damaged.
    Corrupt,
    /// Cut in both directions; the port is down.
    Cut,
    /// The value jumps: heading by 20 degrees, position by 0.2 nautical miles.
    Jump,
    /// The value stays as it is.
    Stuck,
}

/// Who asks, highest rank first (HTC-4). It stands in a recording beside each order.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Origin {
    /// An officer at a page, or a program in his place.
    Officer,
    /// The scripted officer of the embedded voyage.
    Script,
}

/// A command that was not done, with the reason an officer would give.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct Refusal {
    /// The field of the sentence that is at fault, from 1; none where it is no single field.
    pub field: Option<u8>,
    /// The reason.
    pub text: String,
}

impl Refusal {
    /// A refusal that is about no field.
    #[must_use]
    pub fn because(text: impl Into<String>) -> Self {
        Self {
            field: None,
            text: text.into(),
        }
    }
}

impl core::fmt::Display for Refusal {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        match self.field {
            Some(field) => write!(f, "field {field}: {}", self.text),
            None => f.write_str(&self.text),
        }
    }
}

/// What became of an order.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Answer {
    /// The order's number.
    pub id: u64,
    /// Whether it was done.
    pub ok: bool,
    /// What followed, or the reason for refusal.
    pub text: String,
}

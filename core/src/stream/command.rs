//! What comes up from the browser.

use alloc::string::String;
use serde::{Deserialize, Serialize};

/// A frame from the browser.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(tag = "type", rename_all = "snake_case")]
pub enum Up {
    /// A snapshot was taken; opens the window of three.
    Ack {
        /// Its number.
        frame: u64,
    },
    /// Send the lines from this number on.
    Resume {
        /// Number of the first line wanted.
        seq: u64,
    },
    /// What the client wants.
    Subscribe {
        /// Snapshots a second, 0 to 10.
        rate: f64,
        /// Whether lines are wanted.
        lines: bool,
    },
    /// Do something.
    Command {
        /// Chosen by the client; comes back in the answer.
        id: u64,
        /// What.
        #[serde(rename = "do")]
        action: Do,
    },
}

/// What can be commanded.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Do {
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
        value: f64,
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

//! What can be asked of the stations, and the answer: orders, refusals, answers.

mod apb;
mod hsc;
mod htc;
mod origin;
mod refusal;

use crate::settings::Value;
use alloc::string::String;
pub use apb::{Leg, Plotted, Said, apb};
pub use hsc::hsc;
pub use htc::{Remote, htc};
pub use origin::{Origin, STANDBY_RANK};
pub use refusal::Refusal;
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
    /// Set the rate of turn, degrees a minute, starboard positive; in AUTO that of its turns, without a side.
    SetRate(f64),
    /// Set the radius of AUTO's turns, nautical miles.
    SetRadius(f64),
    /// Order a rudder angle in FFU OVERRIDE, degrees, starboard positive.
    SetRudder(f64),
    /// Set the offset of DODGE, degrees, starboard positive.
    SetDodge(f64),
    /// Set the wind angle of WIND VANE, degrees from the bow, starboard positive.
    SetWindAngle(f64),
    /// Tack through the wind in WIND VANE, by a turn to that side.
    Tack(Side),
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
    /// Have our chart-system side monitor the route with this number that a plotter offers (TCS-13).
    LoadRoute(u64),
    /// Change a setting.
    Setting {
        /// Its name in the settings table.
        key: String,
        /// Its new value.
        value: Value,
    },
}

impl Order {
    /// Its rank where it comes from `by`: an operator's STANDBY goes before all but the NFU line (HTC-4).
    #[must_use]
    pub const fn rank(&self, by: Origin) -> u8 {
        match self {
            Self::Mode(ModeRequest::Standby) if by.rank() > STANDBY_RANK => STANDBY_RANK,
            _ => by.rank(),
        }
    }

    /// Whether it asks for another course of the ship, and so has to come from somebody who may (HTC-4).
    #[must_use]
    pub const fn steers(&self) -> bool {
        !matches!(
            self,
            Self::Acknowledge(_)
                | Self::Silence(_)
                | Self::Setting { .. }
                | Self::Speed(_)
                | Self::Officer(_)
                | Self::Fault { .. }
                | Self::Current { .. }
                | Self::Chart(_)
                | Self::LoadRoute(_)
        )
    }
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
    /// Withdraw a pending AutoNAV selection, or release DODGE.
    Cancel,
    /// Follow APB.
    Track,
    /// Hold the angle to the wind.
    WindVane,
    /// Turn at a rate.
    RiverPilot,
    /// Go round something, and back; asked for again it is released.
    Dodge,
    /// Order the rudder.
    FfuOverride,
    /// Install: no orders.
    Installation,
    /// Sail a bounded zigzag.
    Autotuning,
}

/// A side of the ship.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Side {
    /// Left.
    Port,
    /// Right.
    Starboard,
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
    /// The value stays as it is; of the gear, the single rudder or the starboard one of a pair sticks.
    Stuck,
    /// The port rudder of a pair sticks.
    StuckPort,
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

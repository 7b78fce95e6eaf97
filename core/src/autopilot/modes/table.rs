//! The table of the modes: a mode's row says its name, what it needs and what follows where that is lost.

use super::need::Need;
use crate::nmea::SteeringMode;
use crate::settings::{Role, Settings};
use serde::{Deserialize, Serialize};

/// The autopilot's mode as it is shown.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum ModeName {
    /// The autopilot gives no orders.
    Standby,
    /// The hardware override is in use.
    NfuOverride,
    /// Heading control.
    Auto,
    /// Remote heading control by a chart system.
    AutonavTn,
    /// Track control by a chart system.
    AutonavTi,
    /// Following APB.
    Track,
    /// Rudder frozen after a critical failure.
    RudderHold,
    /// The angle to the wind is held.
    WindVane,
    /// The rate of turn is held.
    RiverPilot,
    /// Round something, and back.
    Dodge,
    /// The rudder is ordered.
    FfuOverride,
    /// Being installed.
    Installation,
    /// A bounded zigzag.
    Autotuning,
}

/// What is fixed of a mode.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(in super::super) struct Row {
    /// Its name in frames and files.
    pub(in super::super) name: ModeName,
    /// Its name for people.
    pub(in super::super) title: &'static str,
    /// What it does.
    pub(in super::super) what: &'static str,
    /// Who selects it.
    pub(in super::super) role: Role,
    /// What the selection is refused without, at once.
    pub(in super::super) entry: &'static [Need],
    /// What it cannot do without: a selection waits for it, supervision watches it.
    pub(in super::super) needs: &'static [Need],
    /// What follows where a need that is watched is lost.
    pub(in super::super) on_loss: OnLoss,
    /// How far the rudder may go.
    pub(in super::super) limit: Limit,
    /// Steering mode that HTD says (AP-1); none where that is null.
    pub(in super::super) htd: Option<SteeringMode>,
    /// Why it is on, where the chart system commands it; absent where it does not.
    pub(in super::super) commanded: Option<&'static str>,
    /// What TRACK FAIL tells the officer of who steers now.
    pub(in super::super) steers: &'static str,
}

/// What follows where something needed is lost. A lost heading holds the rudder in every mode that needs one (FA7).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(in super::super) enum OnLoss {
    /// Nothing is needed.
    Nothing,
    /// The rudder is held as it is.
    RudderHold,
    /// AUTO holds the present heading, with an alarm.
    Auto,
    /// TRACK FAIL: AUTO holds the heading, or finishes the turn (TCS-8).
    TrackFail,
}

/// How far the rudder may go.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(in super::super) enum Limit {
    /// No orders are given.
    NoOrders,
    /// The operator's rudder limit.
    Set,
    /// The maximum of the gear (AP-8).
    Max,
}

impl Row {
    /// The rudder limit that is shown, degrees: where no orders are given, the one that AUTO will have.
    pub(in super::super) const fn rudder_limit(&self, settings: &Settings) -> f64 {
        match self.limit {
            Limit::NoOrders | Limit::Set => settings.rudder_limit,
            Limit::Max => settings.rudder_max,
        }
    }

    /// Whether the mode gives rudder orders.
    pub(in super::super) fn gives_orders(&self) -> bool {
        self.limit != Limit::NoOrders
    }

    /// Whether the mode needs this to go on.
    pub(in super::super) fn needs(&self, need: Need) -> bool {
        self.needs.contains(&need)
    }
}

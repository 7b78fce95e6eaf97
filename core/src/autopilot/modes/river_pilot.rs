//! RIVER PILOT: the rate of turn that the operator sets; it stays until he sets another (AP-21).
//!
//! Where no heading is usable it goes on by the measured rate of turn alone: the heading that the laws turn is then the last one,
//! carried on by that rate, and at no rate she keeps it as well as the sensor tells.

use super::need::Need;
use super::set_value::SetValue;
use super::state::{Listed, State};
use super::table::{Limit, ModeName, OnLoss, Row};
use crate::autopilot::facts::Facts;
use crate::autopilot::steering::Demand;
use crate::command::Refusal;
use crate::nmea::{Htd, SteeringMode, TurnMode};
use crate::settings::Role;
use crate::units::RateOfTurn;
use alloc::string::String;
use alloc::vec::Vec;
use serde::{Deserialize, Serialize};

/// The set rate of turn; none where the mode has just been selected.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct RiverPilot {
    /// Starboard positive.
    pub rate: RateOfTurn,
}

impl Listed for RiverPilot {
    const ROW: Row = Row {
        name: ModeName::RiverPilot,
        title: "RIVER PILOT",
        what: "The set rate of turn is held until another is set; at none, as at the selection, the heading that she has then. A measured rate of turn is enough, without a heading.",
        role: Role::Operator,
        entry: &[Need::HeadingOrRate, Need::NoOverride],
        needs: &[Need::HeadingOrRate],
        on_loss: OnLoss::RudderHold,
        limit: Limit::Set,
        htd: Some(SteeringMode::RudderControl),
        commanded: None,
        steers: "RIVER PILOT, the set rate of turn is steered",
    };

    fn examples() -> Vec<(&'static str, Self)> {
        alloc::vec![("RIVER PILOT", Self::default())]
    }
}

impl State for RiverPilot {
    fn demand(&mut self, _: &Facts<'_>) -> Option<Demand> {
        Some(Demand::Rate(self.rate))
    }

    fn htd(&self, _: &Facts<'_>, htd: &mut Htd) {
        htd.turn_mode = Some(TurnMode::Rate);
        htd.rate_of_turn = Some(self.rate.abs().deg_per_min());
    }

    fn set(&mut self, _: &Facts<'_>, set: SetValue) -> Result<String, Refusal> {
        let SetValue::Rate(rate) = set else {
            return Err(set.refused());
        };
        self.rate = RateOfTurn::from_deg_per_min(rate);
        Ok(set.done())
    }

    fn set_value(&self) -> Option<f64> {
        Some(self.rate.deg_per_min())
    }
}

//! FFU OVERRIDE: the rudder that the operator orders; it needs no heading (AP-21).

use super::need::Need;
use super::set_value::SetValue;
use super::state::{Listed, State};
use super::table::{Limit, ModeName, OnLoss, Row};
use crate::autopilot::facts::Facts;
use crate::autopilot::steering::Demand;
use crate::command::Refusal;
use crate::nmea::SteeringMode;
use crate::settings::Role;
use crate::time::Stamp;
use crate::units::RudderAngle;
use alloc::string::String;
use alloc::vec::Vec;
use serde::{Deserialize, Serialize};

/// The ordered rudder.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct FfuOverride {
    /// As it was ordered; where the mode was selected, as the rudder stood then.
    pub rudder: RudderAngle,
    /// A hand unit moves the tiller from STANDBY: until when, and STANDBY again (EMC-7).
    pub until: Option<Stamp>,
}

impl FfuOverride {
    /// This rudder, until the operator leaves the mode.
    pub(super) const fn on(rudder: RudderAngle) -> Self {
        Self {
            rudder,
            until: None,
        }
    }
}

impl Listed for FfuOverride {
    const ROW: Row = Row {
        name: ModeName::FfuOverride,
        title: "FFU OVERRIDE",
        what: "Follow-up: the ordered rudder angle is given; at first the one that the rudder has.",
        role: Role::Operator,
        entry: &[Need::NoOverride],
        needs: &[],
        on_loss: OnLoss::Nothing,
        limit: Limit::Max,
        htd: Some(SteeringMode::RudderControl),
        commanded: None,
        steers: "FFU OVERRIDE, the rudder is as ordered",
    };

    fn examples() -> Vec<(&'static str, Self)> {
        let rudder = RudderAngle::from_deg(5.0);
        alloc::vec![("FFU OVERRIDE", Self::on(rudder))]
    }
}

impl State for FfuOverride {
    fn demand(&mut self, _: &Facts<'_>) -> Option<Demand> {
        Some(Demand::Rudder(self.rudder))
    }

    fn set(&mut self, _: &Facts<'_>, set: SetValue) -> Result<String, Refusal> {
        let SetValue::Rudder(degrees) = set else {
            return Err(set.refused());
        };
        *self = Self::on(RudderAngle::from_deg(degrees));
        Ok(set.done())
    }

    fn set_value(&self) -> Option<f64> {
        Some(self.rudder.deg())
    }
}

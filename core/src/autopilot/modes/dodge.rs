//! DODGE: round something by an offset of the heading, and back to the mode before when it is released (AP-21).

use super::auto;
use super::former::Former;
use super::need::Need;
use super::set_value::SetValue;
use super::state::{Listed, State};
use super::table::{Limit, ModeName, OnLoss, Row};
use crate::autopilot::facts::Facts;
use crate::autopilot::steering::Demand;
use crate::command::Refusal;
use crate::nmea::SteeringMode;
use crate::settings::Role;
use crate::units::{Heading, SignedAngle};
use alloc::string::String;
use alloc::vec::Vec;
use serde::{Deserialize, Serialize};

/// An offset, and what it is an offset of.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Dodge {
    /// The heading that was steered when the mode was selected.
    pub base: Heading,
    /// Starboard positive; none at first.
    pub offset: SignedAngle,
    /// What follows when it is released.
    pub former: Former,
}

impl Dodge {
    /// Off that heading.
    pub(super) fn on(base: Heading, former: Former) -> Self {
        Self {
            base,
            offset: SignedAngle::default(),
            former,
        }
    }

    /// The heading to steer.
    fn heading(&self) -> Heading {
        self.base + self.offset
    }
}

impl Listed for Dodge {
    const ROW: Row = Row {
        name: ModeName::Dodge,
        title: "DODGE",
        what: "The heading that was steered, with the set offset, by AUTO's radius or rate; released, the mode before goes on with its set value, where its needs still hold.",
        role: Role::Operator,
        entry: &[Need::Heading, Need::NoOverride, Need::Dodgeable],
        needs: &[Need::Heading],
        on_loss: OnLoss::RudderHold,
        limit: Limit::Max,
        htd: Some(SteeringMode::RudderControl),
        commanded: None,
        steers: "DODGE, the heading is off the mode before",
    };

    fn examples() -> Vec<(&'static str, Self)> {
        let north = Heading::from_deg(0.0);
        alloc::vec![("DODGE", Self::on(north, Former::Auto(north)))]
    }
}

impl State for Dodge {
    fn demand(&mut self, facts: &Facts<'_>) -> Option<Demand> {
        Some(Demand::Heading {
            set: self.heading(),
            by: auto::turns_by(facts.settings),
        })
    }

    fn hts(&self, _: &Facts<'_>) -> Option<Heading> {
        Some(self.heading())
    }

    fn set(&mut self, _: &Facts<'_>, set: SetValue) -> Result<String, Refusal> {
        let SetValue::Dodge(offset) = set else {
            return Err(set.refused());
        };
        self.offset = SignedAngle::from_deg(offset);
        Ok(set.done())
    }

    fn set_value(&self) -> Option<f64> {
        Some(self.offset.deg())
    }
}

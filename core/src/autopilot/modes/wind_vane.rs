//! WIND VANE: the angle to the wind is held, apparent or true; a tack goes through the wind ahead (AP-21).

use super::auto;
use super::former::Former;
use super::need::Need;
use super::set_value::{SetValue, side_name};
use super::state::{Ended, Listed, State};
use super::table::{Limit, ModeName, OnLoss, Row};
use crate::alerts::Alert;
use crate::autopilot::facts::{Facts, Outlook};
use crate::autopilot::steering::Demand;
use crate::command::{Refusal, Side};
use crate::nmea::SteeringMode;
use crate::settings::Role;
use crate::units::{Heading, SignedAngle};
use alloc::format;
use alloc::string::String;
use alloc::vec::Vec;
use serde::{Deserialize, Serialize};

/// A wind farther aft is not tacked through, degrees from the bow.
const TACK_DEG: f64 = 85.0;

/// The set angle, and the wind that it is held to.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct WindVane {
    /// From the bow to where the wind comes from, starboard positive.
    pub angle: SignedAngle,
    /// To the apparent wind, else to the true one.
    pub apparent: bool,
    /// Where the wind comes from, by compass, low-passed.
    pub direction: Heading,
}

impl WindVane {
    /// The heading to steer.
    fn heading(&self) -> Heading {
        self.direction + -self.angle
    }

    /// Through the wind by a turn to that side: the same angle on the other one.
    fn tack(&mut self, side: Side) -> Result<(), Refusal> {
        let angle = self.angle.deg();
        let wind = if angle < 0.0 {
            Side::Port
        } else {
            Side::Starboard
        };
        if libm::fabs(angle) > TACK_DEG {
            return Err(Refusal::because(format!(
                "the set wind angle is {:.0} deg: a tack goes through the wind ahead, from {TACK_DEG} deg at most",
                libm::fabs(angle)
            )));
        }
        if side != wind {
            let wind = side_name(wind);
            return Err(Refusal::because(format!(
                "the wind is on the {wind} side: tack to {wind}"
            )));
        }
        self.angle = -self.angle;
        Ok(())
    }
}

impl Listed for WindVane {
    const ROW: Row = Row {
        name: ModeName::WindVane,
        title: "WIND VANE",
        what: "The set angle to the low-passed wind is held, to the apparent or the true one as `wind_true` was set at the selection; at first the angle that she has.",
        role: Role::Operator,
        entry: &[Need::Heading, Need::NoOverride, Need::Wind],
        needs: &[Need::Heading, Need::Wind],
        on_loss: OnLoss::Auto,
        limit: Limit::Set,
        htd: Some(SteeringMode::RudderControl),
        commanded: None,
        steers: "WIND VANE, the angle to the wind is steered",
    };

    fn examples() -> Vec<(&'static str, Self)> {
        let vane = Self {
            angle: SignedAngle::from_deg(40.0),
            apparent: true,
            direction: Heading::from_deg(40.0),
        };
        alloc::vec![("WIND VANE", vane)]
    }
}

impl State for WindVane {
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
        match set {
            SetValue::WindAngle(angle) => self.angle = SignedAngle::from_deg(angle),
            SetValue::Tack(side) => self.tack(side)?,
            _ => return Err(set.refused()),
        }
        Ok(set.done())
    }

    fn set_value(&self) -> Option<f64> {
        Some(self.angle.deg())
    }

    fn former(&self) -> Option<Former> {
        Some(Former::WindVane {
            angle: self.angle,
            apparent: self.apparent,
        })
    }

    fn watch(&mut self, outlook: &Outlook<'_>) -> Option<Ended> {
        match outlook.sight.wind(self.apparent) {
            Some(direction) => {
                self.direction = direction;
                None
            }
            None => Some(Ended {
                set: outlook.facts.heading,
                why: "no wind is heard: AUTO on the present heading".into(),
                alert: Some(Alert::WindLost),
            }),
        }
    }
}

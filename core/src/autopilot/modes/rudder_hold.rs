//! RUDDER HOLD: the rudder stays as it was when the heading was lost (FA7), or what turns it failed (FA11).

use super::state::{Listed, State};
use super::table::{Limit, ModeName, OnLoss, Row};
use crate::nmea::SteeringMode;
use crate::settings::Role;
use crate::units::RudderAngle;
use alloc::vec::Vec;
use serde::{Deserialize, Serialize};

/// The held order.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct RudderHold {
    /// The order as it was.
    pub order: RudderAngle,
}

impl Listed for RudderHold {
    const ROW: Row = Row {
        name: ModeName::RudderHold,
        title: "RUDDER HOLD",
        what: "The rudder is held as it was when the heading was lost or its motor failed; only the operator ends it.",
        role: Role::Operator,
        entry: &[],
        needs: &[],
        on_loss: OnLoss::Nothing,
        limit: Limit::Max,
        htd: Some(SteeringMode::RudderControl),
        commanded: None,
        steers: "rudder held, steer by hand",
    };

    fn examples() -> Vec<(&'static str, Self)> {
        let order = RudderAngle::from_deg(0.0);
        alloc::vec![("RUDDER HOLD", Self { order })]
    }
}

impl State for RudderHold {}

//! RUDDER HOLD: the rudder stays as it was when the heading was lost (FA7).

use super::state::State;
use super::table::{Limit, ModeName, OnLoss, Row};
use crate::nmea::SteeringMode;
use crate::units::RudderAngle;
use serde::{Deserialize, Serialize};

/// The held order.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct RudderHold {
    /// The order as it was.
    pub order: RudderAngle,
}

impl State for RudderHold {
    const ROW: Row = Row {
        name: ModeName::RudderHold,
        title: "RUDDER HOLD",
        what: "The rudder is held as it was when the heading was lost; only the operator ends it.",
        entry: &[],
        needs: &[],
        on_loss: OnLoss::Nothing,
        limit: Limit::Max,
        htd: SteeringMode::RudderControl,
    };
}

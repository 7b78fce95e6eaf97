//! STANDBY: the autopilot gives no orders. Always granted (AP-25).

use super::state::State;
use super::table::{Limit, ModeName, OnLoss, Row};
use crate::nmea::SteeringMode;
use serde::{Deserialize, Serialize};

/// Nothing is steered, nothing is remembered.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
pub struct Standby;

impl State for Standby {
    const ROW: Row = Row {
        name: ModeName::Standby,
        title: "STANDBY",
        what: "The autopilot gives no orders; the ship is steered by hand.",
        entry: &[],
        needs: &[],
        on_loss: OnLoss::Nothing,
        limit: Limit::NoOrders,
        htd: SteeringMode::Manual,
    };
}

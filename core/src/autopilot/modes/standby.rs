//! STANDBY: the autopilot gives no orders. Always granted (AP-25).

use super::state::{Listed, State};
use super::table::{Limit, ModeName, OnLoss, Row};
use crate::nmea::SteeringMode;
use crate::settings::Role;
use alloc::vec::Vec;
use serde::{Deserialize, Serialize};

/// Nothing is steered, nothing is remembered.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
pub struct Standby;

impl Listed for Standby {
    const ROW: Row = Row {
        name: ModeName::Standby,
        title: "STANDBY",
        what: "The autopilot gives no orders; the ship is steered by hand.",
        role: Role::Operator,
        entry: &[],
        needs: &[],
        on_loss: OnLoss::Nothing,
        limit: Limit::NoOrders,
        htd: Some(SteeringMode::Manual),
        commanded: None,
        steers: "STANDBY, steer by hand",
    };

    fn examples() -> Vec<(&'static str, Self)> {
        alloc::vec![("STANDBY", Self)]
    }
}

impl State for Standby {}

//! INSTALLATION: the engineer sets the autopilot up; it gives no orders (AP-18).

use super::need::Need;
use super::state::{Listed, State};
use super::table::{Limit, ModeName, OnLoss, Row};
use crate::settings::Role;
use alloc::vec::Vec;
use serde::{Deserialize, Serialize};

/// Nothing is steered.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
pub struct Installation;

impl Listed for Installation {
    const ROW: Row = Row {
        name: ModeName::Installation,
        title: "INSTALLATION",
        what: "The engineer sets the autopilot up; it gives no orders, and only STANDBY ends it.",
        role: Role::Engineer,
        entry: &[Need::InStandby],
        needs: &[],
        on_loss: OnLoss::Nothing,
        limit: Limit::NoOrders,
        htd: None,
        commanded: None,
        steers: "INSTALLATION, steer by hand",
    };

    fn examples() -> Vec<(&'static str, Self)> {
        alloc::vec![("INSTALLATION", Self)]
    }
}

impl State for Installation {}

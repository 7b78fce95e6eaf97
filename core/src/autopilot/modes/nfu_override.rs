//! NFU OVERRIDE: the hardware override steers, and no orders are given (AP-22, FA12).

use super::state::{Listed, State};
use super::table::{Limit, ModeName, OnLoss, Row};
use crate::autopilot::facts::Facts;
use crate::nmea::{Htd, OverrideStatus, SteeringMode};
use crate::settings::Role;
use alloc::vec::Vec;
use serde::{Deserialize, Serialize};

/// Nothing is steered, until the operator selects something once the line is released.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct NfuOverride {
    /// The line is in use; else it has been released.
    pub line: bool,
}

impl Listed for NfuOverride {
    const ROW: Row = Row {
        name: ModeName::NfuOverride,
        title: "NFU OVERRIDE",
        what: "The hardware override steers: no orders are given. Entered by its line only, left by the operator once that is released.",
        role: Role::Operator,
        entry: &[],
        needs: &[],
        on_loss: OnLoss::Nothing,
        limit: Limit::NoOrders,
        htd: Some(SteeringMode::Manual),
        commanded: None,
        steers: "NFU override, steer by hand",
    };

    fn examples() -> Vec<(&'static str, Self)> {
        alloc::vec![
            ("NFU OVERRIDE", Self { line: true }),
            ("NFU OVERRIDE, the line released", Self { line: false }),
        ]
    }
}

impl State for NfuOverride {
    fn htd(&self, _: &Facts<'_>, htd: &mut Htd) {
        if self.line {
            htd.override_status = Some(OverrideStatus::InUse);
        }
    }
}

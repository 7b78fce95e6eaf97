//! What the parts of the autopilot have to say of alerts, in the order in which it happened.

use crate::alerts::Alert;
use alloc::string::String;

/// What is said of one alert.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum Notice {
    /// It is raised with what happened; an empty text is the table's.
    Raised(Alert, String),
    /// Its condition is over.
    Rectified(Alert),
}

impl Notice {
    /// Raised with what happened, or over where nothing did.
    pub(super) fn of(alert: Alert, happened: Option<String>) -> Self {
        happened.map_or(Self::Rectified(alert), |text| Self::Raised(alert, text))
    }

    /// Raised as `condition` says.
    pub(super) fn when(condition: bool, alert: Alert) -> Self {
        Self::of(alert, condition.then(String::new))
    }
}

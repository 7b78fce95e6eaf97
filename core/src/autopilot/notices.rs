//! What the parts of the autopilot have to say of alerts, in the order in which it happened.

use crate::alerts::Alert;
use alloc::string::String;
use alloc::vec::Vec;

/// What is said of one alert.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum Notice {
    /// It is raised with what happened; an empty text is the table's.
    Raised(Alert, String),
    /// Its condition is over.
    Rectified(Alert),
    /// A raised one has a better text.
    Retold(Alert, String),
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

/// Notices for the machine that keeps the alerts.
#[derive(Debug)]
pub(super) struct Notices(Vec<Notice>);

impl Notices {
    /// Nothing is said yet.
    pub(super) fn new() -> Self {
        Self(Vec::with_capacity(8)) // what a step says of a mode
    }

    /// An alert is raised; an empty text is the table's.
    pub(super) fn raise(&mut self, alert: Alert, text: impl Into<String>) {
        self.0.push(Notice::Raised(alert, text.into()));
    }

    /// The condition of an alert is over.
    pub(super) fn rectify(&mut self, alert: Alert) {
        self.0.push(Notice::Rectified(alert));
    }

    /// Raised with what happened, or over where nothing did.
    pub(super) fn tell(&mut self, alert: Alert, happened: Option<String>) {
        self.0.push(Notice::of(alert, happened));
    }

    /// A raised alert has a better text.
    pub(super) fn retell(&mut self, alert: Alert, text: impl Into<String>) {
        self.0.push(Notice::Retold(alert, text.into()));
    }
}

impl IntoIterator for Notices {
    type Item = Notice;
    type IntoIter = alloc::vec::IntoIter<Notice>;

    fn into_iter(self) -> Self::IntoIter {
        self.0.into_iter()
    }
}

//! The alerts of the chart system, and which indications of a turn were given and confirmed (TCS-11).

use crate::alerts::{Alert, Alerts};
use crate::time::Stamp;
use serde::{Deserialize, Serialize};

/// What has been indicated and confirmed for the turn that comes or is sailed.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub(super) struct TurnIndications {
    pub(super) alerts: Alerts,
    /// Leg at whose end the turn is.
    pub(super) leg: Option<usize>,
    pub(super) confirmed: bool,
}

impl TurnIndications {
    /// Another route, or none: nothing of the former one is indicated any more.
    pub(super) fn begin_anew(&mut self, now: Stamp) {
        for alert in [
            Alert::CourseChange,
            Alert::CourseChangeSoon,
            Alert::WheelOver,
            Alert::LastWaypoint,
            Alert::CrossTrack,
            Alert::ChartPositionLost,
            Alert::AutopilotLeft,
            Alert::ManualSteering,
        ] {
            self.alerts.end(now, alert);
        }
        self.leg = None;
        self.confirmed = false;
    }

    pub(super) fn acknowledge(&mut self, now: Stamp, number: u16) -> bool {
        let course_change = [
            Alert::CourseChange.number(),
            Alert::CourseChangeSoon.number(),
            Alert::WheelOver.number(),
            Alert::BackupNavigator.number(),
        ];
        let taken = self.alerts.acknowledge(now, number);
        self.confirmed |= taken && course_change.contains(&number);
        // An event, not a condition that lasts: it is over once it is taken.
        if number == Alert::AutopilotLeft.number() {
            self.alerts.rectify(now, Alert::AutopilotLeft);
        }
        taken
    }

    pub(super) fn raise(&mut self, now: Stamp, alert: Alert, text: &str) {
        self.alerts.raise(now, alert, text);
    }

    pub(super) fn rectify(&mut self, now: Stamp, alert: Alert) {
        self.alerts.rectify(now, alert);
    }

    /// Silences what sounds for 30 s, or lets it sound again at once.
    pub(super) fn silence(&mut self, now: Stamp, on: bool) {
        if on {
            self.alerts.silence(now);
        } else {
            self.alerts.sound_again();
        }
    }

    pub(super) fn turn_over(&mut self, now: Stamp) {
        for alert in [Alert::CourseChange, Alert::CourseChangeSoon] {
            self.alerts.end(now, alert);
        }
        self.alerts.rectify(now, Alert::WheelOver);
        self.confirmed = false;
    }
}

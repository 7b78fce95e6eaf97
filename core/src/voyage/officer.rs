//! The scripted officer of the embedded voyage: presses the buttons that a person would press.

use crate::alerts::{Alert, Standing, State};
use crate::autopilot::ModeName;
use crate::command::{ChartRequest, ModeRequest, Order};
use crate::time::Stamp;
use serde::{Deserialize, Serialize};

/// How long an alert sounds before the officer takes it, milliseconds.
const TAKES_ALERT_MS: u64 = 8_000;
/// How long the officer looks into a failure before trying again, milliseconds.
const LOOKS_INTO_MS: u64 = 30_000;

/// What the officer sees.
pub(super) struct InView<'a> {
    /// Mode of the autopilot.
    pub(super) mode: ModeName,
    /// An AutoNAV selection is open.
    pub(super) pending: bool,
    /// Situation of the chart system.
    pub(super) situation: u8,
    /// The chart system commands.
    pub(super) commanded: bool,
    /// All alerts.
    pub(super) alerts: &'a [&'a Standing],
}

/// What the officer does.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum Action {
    /// Press a button.
    Command(Order),
    /// Load the route again.
    NewRound,
}

/// The officer's state: since when things are as they are.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub(super) struct Officer {
    /// Has the watch.
    pub(super) on: bool,
    seen: Option<(ModeName, u8, bool)>,
    since: Stamp,
}

impl Officer {
    /// An officer who comes on watch now, or goes.
    pub(super) const fn new(now: Stamp, on: bool) -> Self {
        Self {
            on,
            seen: None,
            since: now,
        }
    }

    /// The next button, once a second.
    pub(super) fn next(&mut self, now: Stamp, view: &InView<'_>) -> Option<Action> {
        if !self.on {
            return None;
        }
        let alert = view.alerts.iter().find(|alert| {
            matches!(
                alert.state,
                State::Unacknowledged | State::RectifiedUnacknowledged
            ) && now.since(alert.at) >= TAKES_ALERT_MS
        });
        if let Some(alert) = alert {
            return Some(Action::Command(Order::Acknowledge(alert.alert.number())));
        }
        let seen = (view.mode, view.situation, view.commanded);
        if self.seen != Some(seen) {
            self.seen = Some(seen);
            self.since = now;
        }
        let waited = |ms: u64| now.since(self.since) >= ms;
        let failed = view
            .alerts
            .iter()
            .any(|alert| alert.alert == Alert::TrackFail);
        let wait = if failed { LOOKS_INTO_MS } else { 3_000 };
        let action = match (view.mode, view.situation) {
            (ModeName::Standby, _) if waited(4_000) => {
                Action::Command(Order::Mode(ModeRequest::Auto))
            }
            (ModeName::RudderHold, _) if waited(15_000) => {
                Action::Command(Order::Mode(ModeRequest::Auto))
            }
            (ModeName::Auto, 6) if waited(20_000) => Action::NewRound,
            (ModeName::Auto, 1) if waited(6_000) => {
                Action::Command(Order::Chart(ChartRequest::Track))
            }
            (ModeName::Auto, 2 | 5) if view.commanded && !view.pending && waited(wait) => {
                Action::Command(Order::Mode(ModeRequest::Autonav))
            }
            _ => return None,
        };
        self.since = now;
        Some(action)
    }
}

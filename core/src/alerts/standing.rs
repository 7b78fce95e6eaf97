//! An alert that is not normal: its state, its text, its place in a list (IEC 62923-1, DSP-5).

use super::table::{Alert, Priority};
use crate::time::Stamp;
use alloc::string::{String, ToString};
use core::cmp::Reverse;
use serde::{Deserialize, Serialize};

/// State of an alert (IEC 62923-1).
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum State {
    /// Raised, nobody has taken it: flashing and sounding.
    Unacknowledged,
    /// Raised, silent for 30 s.
    Silenced,
    /// Raised and taken.
    Acknowledged,
    /// Raised, answered for by another system.
    Transferred,
    /// Over, but nobody has taken it.
    RectifiedUnacknowledged,
    /// Not raised.
    Normal,
}

/// An alert that is not normal.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Standing {
    /// Which.
    pub alert: Alert,
    /// Its state by IEC 62923.
    pub state: State,
    /// What happened this time; empty where the table's text says it.
    pub detail: String,
    /// When the state last changed.
    pub at: Stamp,
    /// Escalation counter: how often it was left without an answer for too long (0 to 9).
    pub escalation: u8,
    /// Until when a silenced one is silent.
    pub(super) silent_until: Stamp,
    /// Since when nobody has answered, or since it was last repeated.
    pub(super) unanswered: Stamp,
}

impl Standing {
    /// One that is raised now; a caution waits for nobody.
    pub(super) fn new(now: Stamp, alert: Alert, detail: &str) -> Self {
        Self {
            alert,
            state: match alert.definition().priority {
                Priority::Alarm | Priority::Warning => State::Unacknowledged,
                Priority::Caution => State::Acknowledged,
            },
            detail: detail.to_string(),
            at: now,
            escalation: 0,
            silent_until: now,
            unanswered: now,
        }
    }

    /// Whether its condition holds and nobody has taken it.
    #[must_use]
    pub const fn waits(&self) -> bool {
        matches!(self.state, State::Unacknowledged | State::Silenced)
    }

    /// What happened and what to do.
    #[must_use]
    pub fn text(&self) -> &str {
        if self.detail.is_empty() {
            self.alert.definition().text
        } else {
            &self.detail
        }
    }

    /// Where it stands in a list, lowest first (DSP-5): seven levels, what nobody has taken before what was taken and
    /// within that by priority, cautions last; within a level the newest first.
    #[must_use]
    pub const fn rank(&self) -> (u8, Reverse<Stamp>) {
        let level = match (self.alert.definition().priority, self.state) {
            (Priority::Alarm, State::Unacknowledged | State::Silenced) => 1,
            (Priority::Alarm, State::RectifiedUnacknowledged) => 2,
            (Priority::Warning, State::Unacknowledged | State::Silenced) => 3,
            (Priority::Warning, State::RectifiedUnacknowledged) => 4,
            (Priority::Alarm, State::Acknowledged | State::Transferred | State::Normal) => 5,
            (Priority::Warning, State::Acknowledged | State::Transferred | State::Normal) => 6,
            (Priority::Caution, _) => 7,
        };
        (level, Reverse(self.at))
    }
}

//! What the autopilot has times of.

use crate::talk::SECOND_MS;
use crate::time::Stamp;
use crate::timers::Timers;
use serde::{Deserialize, Serialize};

/// A control loop that kept its time for so long has recovered (FA16).
pub(super) const STALL_OVER_MS: u64 = 10_000;

/// The station's own times; each part has those of its own.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub(super) enum Timer {
    /// When the next control step is due.
    Step,
    /// When the next reports are due.
    Second,
    /// Since when the control loop keeps its time again (FA16).
    Stalled,
    /// When hand units were told last by themselves.
    HandUnit,
}

/// The times of a station that begins.
pub(super) fn begun(now: Stamp) -> Timers<Timer> {
    Timers::new(&[
        (Timer::Step, now + 100),
        (Timer::Second, now + SECOND_MS),
        (Timer::HandUnit, now),
    ])
}

//! Off the heading to steer: the alert waits while a turn brings the ship nearer (AP-5).

use crate::time::Stamp;
use crate::timers::Timers;
use crate::units::Heading;
use serde::{Deserialize, Serialize};

/// Off the set heading for so long before the alert, which a turn would else raise.
const OFF_HEADING_MS: u64 = 60_000;
/// A turn brings her nearer by at least so much, degrees.
const NEARER_DEG: f64 = 1.0;

/// How the ship comes to her heading.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub(super) struct OffHeading {
    /// How near the heading to steer she has come since she was off it, degrees, and that heading.
    nearest: Option<(f64, Heading)>,
    timers: Timers<Timer>,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
enum Timer {
    /// Since when she comes no nearer.
    Off,
}

impl Default for OffHeading {
    fn default() -> Self {
        Self {
            nearest: None,
            timers: Timers::new(&[]),
        }
    }
}

impl OffHeading {
    /// Another heading is set: the time counts anew.
    pub(super) fn restart(&mut self) {
        self.timers.stop(Timer::Off);
    }

    /// Takes how far she is off, degrees, and which heading; whether she has been off it for too long. One that goes round
    /// and round comes no nearer.
    pub(super) fn watch(&mut self, now: Stamp, off: Option<(f64, Heading)>) -> bool {
        let stays_off = |(off, hts): (f64, Heading)| {
            self.nearest.is_some_and(|(nearest, before)| {
                off > nearest - NEARER_DEG && (hts - before).abs().deg() <= NEARER_DEG
            })
        };
        if !off.is_some_and(stays_off) {
            self.timers.stop(Timer::Off);
            self.nearest = off;
        }
        let since = self.timers.begin(Timer::Off, now);
        off.is_some() && now.since(since) >= OFF_HEADING_MS
    }
}

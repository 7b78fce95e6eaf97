//! Off the track: the alarm waits until the ship has been on it (MSC.74(69) A2 5.3.6).

use crate::time::Stamp;
use serde::{Deserialize, Serialize};

/// Off the track for so long before the alarm.
const OFF_TRACK_MS: u64 = 5_000;

/// Whether the ship has left a track that she had come to.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
pub(in super::super) struct OffTrack {
    /// The ship has been within half the off-track limit since control of the track began.
    captured: bool,
    /// Since when she is off the track.
    since: Option<Stamp>,
}

impl OffTrack {
    /// She has not come to it yet.
    pub(super) const fn new() -> Self {
        Self {
            captured: false,
            since: None,
        }
    }

    /// The ship was on the track, and has been off it for long enough; `off` and `limit` in metres.
    pub(super) fn watch(&mut self, now: Stamp, off: Option<f64>, limit: f64) -> bool {
        let outside = off.is_some_and(|off| off > limit);
        self.captured |= off.is_some_and(|off| off < 0.5 * limit);
        if !outside || !self.captured {
            self.since = None;
            return false;
        }
        let since = *self.since.get_or_insert(now);
        now.since(since) >= OFF_TRACK_MS
    }
}

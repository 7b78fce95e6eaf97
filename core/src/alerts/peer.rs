//! The other side of a port by its heartbeat: alive, failed or not heard any more (HBT; F2).

use crate::nmea::{EquipmentStatus, Hbt};
use crate::time::Stamp;
use serde::{Deserialize, Serialize};

/// What HBT says of its repeat interval where it says nothing, milliseconds.
const INTERVAL_MS: f64 = 30_000.0;
/// A shorter interval than this counts as this, milliseconds.
const SHORTEST_MS: f64 = 1_000.0;
/// One heartbeat may be missed: so many intervals without one and it is lost.
const INTERVALS: f64 = 2.5;

/// Who was heard on a port.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub(super) struct Peer {
    /// When its heartbeat counts as lost.
    until: Stamp,
    /// It says of itself that it has failed.
    failed: bool,
}

impl Peer {
    /// The heartbeat that was just heard.
    pub(super) fn heard(now: Stamp, heartbeat: &Hbt) -> Self {
        let said = heartbeat.interval.filter(|seconds| *seconds > 0.0);
        let interval = said.map_or(INTERVAL_MS, |seconds| seconds * 1_000.0);
        Self {
            until: now + (INTERVALS * interval.max(SHORTEST_MS)) as u64,
            failed: heartbeat.status == Some(EquipmentStatus::Failed),
        }
    }

    /// What is wrong with it at `now`, if anything is.
    pub(super) fn trouble(&self, now: Stamp) -> Option<&'static str> {
        if now > self.until {
            Some("no heartbeat")
        } else if self.failed {
            Some("its heartbeat says system fail")
        } else {
            None
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_heartbeat_is_lost_by_its_own_interval() {
        let check = |interval, status, ms, trouble: Option<&str>| {
            let heartbeat = Hbt {
                interval,
                status,
                ..Hbt::default()
            };
            let peer = Peer::heard(Stamp(0), &heartbeat);
            assert_eq!(peer.trouble(Stamp(ms)), trouble, "{interval:?} {ms}");
        };
        let (fine, failed) = (Some(EquipmentStatus::Normal), Some(EquipmentStatus::Failed));
        let lost = Some("no heartbeat");
        check(Some(10.0), fine, 25_000, None);
        check(Some(10.0), fine, 25_001, lost);
        check(None, fine, 75_000, None);
        check(Some(0.0), fine, 75_001, lost);
        check(Some(0.1), fine, 2_500, None);
        check(Some(99.9), fine, 249_751, lost);
        check(Some(10.0), None, 1, None);
        check(
            Some(10.0),
            failed,
            1,
            Some("its heartbeat says system fail"),
        );
        check(Some(10.0), failed, 25_001, lost);
    }
}

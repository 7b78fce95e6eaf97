//! Whether the measured speed is steady: what AUTOTUNING asks for (AP-19).

use crate::time::Stamp;
use crate::units::Speed;
use serde::{Deserialize, Serialize};

/// Within so much, knots, for so long.
const STEADY_KN: f64 = 0.5;
const STEADY_MS: u64 = 30_000;

/// The speed that it has kept, and since when.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub(super) struct SteadySpeed {
    kept: Option<(Speed, Stamp)>,
}

impl SteadySpeed {
    /// Takes the speed that is measured, once a step.
    pub(super) fn look(&mut self, now: Stamp, speed: Option<Speed>) {
        let Some(speed) = speed else {
            self.kept = None;
            return;
        };
        let off = |kept: Speed| libm::fabs(speed.knots() - kept.knots());
        if self.kept.is_none_or(|(kept, _)| off(kept) > STEADY_KN) {
            self.kept = Some((speed, now));
        }
    }

    /// Whether it has been steady for long enough.
    pub(super) fn lasts(&self, now: Stamp) -> bool {
        self.kept
            .is_some_and(|(_, since)| now.since(since) >= STEADY_MS)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    // AP-19
    #[test]
    fn a_speed_is_steady_once_it_was_kept_for_half_a_minute() {
        let mut steady = SteadySpeed::default();
        let mut at = |seconds: u64, knots: Option<f64>| {
            let now = Stamp(seconds * 1_000);
            steady.look(now, knots.map(Speed::from_knots));
            steady.lasts(now)
        };
        assert!(!at(0, Some(12.0)) && !at(29, Some(12.4)));
        assert!(at(30, Some(11.6)));
        assert!(!at(31, Some(11.4)), "half a knot");
        assert!(!at(60, Some(11.4)) && at(61, Some(11.4)));
        assert!(!at(62, None) && !at(63, Some(11.4)));
    }
}

//! Whether a measured rate of turn is believed: it has to be the way the heading goes (AP-9).
//!
//! Both are smoothed alike and compared; a rate that is off for three seconds is calculated from the heading instead,
//! until it has agreed for ten.

use crate::time::Stamp;
use crate::units::{Heading, RateOfTurn};
use serde::{Deserialize, Serialize};

/// Time constant of what is calculated and compared, seconds.
const SMOOTH_S: f64 = 3.0;
/// Off by more is off: degrees a minute, and as a part of the rate.
const OFF: (f64, f64) = (30.0, 0.3);
/// Off for so long, it is not believed; in agreement for so long, it is again.
const DOUBT_MS: u64 = 3_000;
const TRUST_MS: u64 = 10_000;

/// Holds the measured rate of turn against the heading.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub(crate) struct RateGuard {
    /// Of the heading and of the sensor, smoothed alike, degrees a minute.
    turned: f64,
    said: f64,
    /// Since when agreement or disagreement lasts that is not yet believed.
    since: Option<Stamp>,
    doubted: bool,
}

impl RateGuard {
    /// Whether the sensor is not believed.
    pub(crate) const fn doubted(&self) -> bool {
        self.doubted
    }

    /// The rate of turn in use: the measured one, or the last one carried on by the heading. `change`: how the heading of
    /// one compass changed in this step.
    pub(crate) fn judge(
        &mut self,
        now: Stamp,
        measured: Option<RateOfTurn>,
        change: Option<(Heading, Heading)>,
        last: RateOfTurn,
        dt: f64,
    ) -> RateOfTurn {
        let share = dt / SMOOTH_S;
        let raw = change.map(|(before, after)| (after - before).deg() / dt * 60.0);
        let Some(said) = measured else {
            self.since = None;
            let raw = raw.unwrap_or_default();
            return RateOfTurn::from_deg_per_min(
                last.deg_per_min() + share * (raw - last.deg_per_min()),
            );
        };
        if let Some(raw) = raw {
            self.turned += share * (raw - self.turned);
            self.said += share * (said.deg_per_min() - self.said);
            let allowed = OFF.0.max(OFF.1 * libm::fabs(self.turned));
            let off = libm::fabs(self.said - self.turned) > allowed;
            if off == self.doubted {
                self.since = None;
            } else {
                let patience = if off { DOUBT_MS } else { TRUST_MS };
                if now.since(*self.since.get_or_insert(now)) >= patience {
                    (self.doubted, self.since) = (off, None);
                }
            }
        }
        if self.doubted {
            RateOfTurn::from_deg_per_min(self.turned)
        } else {
            said
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Turns at `rate`, degrees a minute, while the sensor says `said`; the rate in use at the end.
    fn after(guard: &mut RateGuard, from: u64, seconds: u64, rate: f64, said: f64) -> f64 {
        let mut used = RateOfTurn::default();
        for step in from * 10..(from + seconds) * 10 {
            let at = |step: u64| Heading::from_deg(rate / 600.0 * step as f64);
            let said = Some(RateOfTurn::from_deg_per_min(said));
            let change = Some((at(step), at(step + 1)));
            used = guard.judge(Stamp(step * 100), said, change, used, 0.1);
        }
        used.deg_per_min()
    }

    // AP-9
    #[test]
    fn a_rate_that_the_heading_does_not_follow_is_calculated_until_it_does() {
        let mut guard = RateGuard::default();
        assert_eq!(after(&mut guard, 0, 60, 40.0, 40.0), 40.0);
        let used = after(&mut guard, 60, 15, 40.0, 90.0);
        assert!(guard.doubted() && (used - 40.0).abs() < 1.0, "{used}");
        after(&mut guard, 75, 8, 40.0, 40.0);
        assert!(guard.doubted(), "not yet");
        assert_eq!(after(&mut guard, 83, 20, 40.0, 40.0), 40.0);
    }

    #[test]
    fn a_rate_that_is_a_little_off_is_used() {
        let mut guard = RateGuard::default();
        assert_eq!(after(&mut guard, 0, 100, 100.0, 125.0), 125.0);
        assert_eq!(after(&mut guard, 100, 100, 0.0, 20.0), 20.0);
    }
}

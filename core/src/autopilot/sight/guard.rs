//! Guards against a heading that cannot be true (FA8).
//!
//! In: readings with their time. Out: the reading, or the prediction for as long as it may stand in.

use crate::time::Stamp;
use crate::units::{Heading, RateOfTurn, SignedAngle};
use serde::{Deserialize, Serialize};

/// A rejected heading is bridged by the rate of turn for so long (FA8).
const HEADING_BRIDGE_MS: u64 = 1_000;
/// A source that jumped is believed again after so long without a jump.
const HEADING_TRUST_MS: u64 = 10_000;
/// Verdict on a heading.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum HeadingVerdict {
    /// Use it.
    Good(Heading),
    /// It jumped: the prediction stands in.
    Bridged(Heading),
    /// It jumped and did not come back: the source is invalid.
    Invalid,
}

/// Guards the heading in use.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub(crate) struct HeadingGuard {
    last: Option<(Heading, Stamp)>,
    rejecting: Option<Stamp>,
    /// The jumped source's own last reading and since when it has been steady.
    suspect: Option<(Heading, Stamp)>,
    invalid: bool,
}

impl HeadingGuard {
    /// Judges a reading; `step` is the largest change that is believed beyond the turn made, degrees.
    pub(crate) fn judge(
        &mut self,
        now: Stamp,
        read: Heading,
        rate: RateOfTurn,
        step: f64,
    ) -> HeadingVerdict {
        let Some((last, at)) = self.last else {
            self.last = Some((read, now));
            return HeadingVerdict::Good(read);
        };
        let dt = now.since(at) as f64 / 1000.0;
        let predicted = last + SignedAngle::from_deg(rate.deg_per_s() * dt);
        if self.invalid {
            return self.regain(now, read, step);
        }
        if (read - predicted).abs().deg() <= step + 0.5 * dt {
            self.last = Some((read, now));
            self.rejecting = None;
            return HeadingVerdict::Good(read);
        }
        let since = *self.rejecting.get_or_insert(now);
        if now.since(since) >= HEADING_BRIDGE_MS {
            self.invalid = true;
            self.suspect = Some((read, now));
            return HeadingVerdict::Invalid;
        }
        self.last = Some((predicted, now));
        HeadingVerdict::Bridged(predicted)
    }

    fn regain(&mut self, now: Stamp, read: Heading, step: f64) -> HeadingVerdict {
        match self.suspect {
            Some((before, since)) if (read - before).abs().deg() <= step => {
                if now.since(since) >= HEADING_TRUST_MS {
                    *self = Self {
                        last: Some((read, now)),
                        ..Self::default()
                    };
                    return HeadingVerdict::Good(read);
                }
                self.suspect = Some((read, since));
            }
            _ => self.suspect = Some((read, now)),
        }
        HeadingVerdict::Invalid
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    // FA8
    #[test]
    fn a_jump_of_the_gyro_is_bridged_for_a_second_then_invalid_then_regained() {
        let mut guard = HeadingGuard::default();
        let still = RateOfTurn::from_deg_per_min(0.0);
        let mut seen = alloc::vec::Vec::new();
        for step in 0..130_u64 {
            let read = Heading::from_deg(if step < 5 { 100.0 } else { 120.0 });
            seen.push(guard.judge(Stamp(step * 100), read, still, 8.0));
        }
        assert_eq!(seen[5], HeadingVerdict::Bridged(Heading::from_deg(100.0)));
        assert_eq!(seen[14], HeadingVerdict::Bridged(Heading::from_deg(100.0)));
        assert_eq!(seen[15], HeadingVerdict::Invalid);
        assert_eq!(seen[114], HeadingVerdict::Invalid);
        assert_eq!(seen[115], HeadingVerdict::Good(Heading::from_deg(120.0)));
    }
}

//! Which speed is believed: through the water, else over ground, else the set cruise speed (AP-9, FA10).
//!
//! Log and receiver may differ by a current. Where they differ by more, the one that left the speed in use is not believed
//! until both have agreed for ten seconds. Below the minimum no gains are made of it.

use crate::time::Stamp;
use crate::units::Speed;
use serde::{Deserialize, Serialize};

/// No current makes such a difference, knots.
const APART_KN: f64 = 8.0;
/// They agree again within so much, for so long.
const TOGETHER_KN: f64 = 4.0;
const TRUST_MS: u64 = 10_000;

/// What measures a speed.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub(crate) enum Measure {
    /// The log.
    Water,
    /// The receiver.
    Ground,
}

/// Holds the two measured speeds against each other.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub(crate) struct SpeedGuard {
    used: Option<Speed>,
    doubted: Option<Measure>,
    agree_since: Option<Stamp>,
    low: bool,
}

impl SpeedGuard {
    /// Takes what is fresh. `free`: nothing is steered, nothing is remembered.
    pub(crate) fn look(
        &mut self,
        now: Stamp,
        water: Option<Speed>,
        ground: Option<Speed>,
        minimum: Speed,
        free: bool,
    ) {
        if free {
            *self = Self::default();
        }
        let both = water.zip(ground);
        let apart = both.map(|(water, ground)| libm::fabs(water.knots() - ground.knots()));
        match (self.doubted, apart) {
            (None, Some(apart)) if apart > APART_KN => {
                self.doubted = both.map(|(water, ground)| self.liar(water, ground, minimum));
                self.agree_since = None;
            }
            (Some(_), Some(apart)) if apart <= TOGETHER_KN => {
                if now.since(*self.agree_since.get_or_insert(now)) >= TRUST_MS {
                    (self.doubted, self.agree_since) = (None, None);
                }
            }
            _ => self.agree_since = None,
        }
        let believed =
            |measure, speed: Option<Speed>| speed.filter(|_| self.doubted != Some(measure));
        let measured = believed(Measure::Water, water).or(believed(Measure::Ground, ground));
        self.low = measured.is_some_and(|speed| speed < minimum);
        self.used = measured;
    }

    /// Who left the speed in use; at the beginning, who says that the ship lies still, else the faster.
    fn liar(&self, water: Speed, ground: Speed, minimum: Speed) -> Measure {
        let water_lies = match self.used {
            Some(used) => {
                let off = |speed: Speed| libm::fabs(speed.knots() - used.knots());
                off(water) > off(ground)
            }
            None => water < minimum || ground >= minimum && water > ground,
        };
        if water_lies {
            Measure::Water
        } else {
            Measure::Ground
        }
    }

    /// The speed for the gains; absent where the set cruise speed stands in.
    pub(crate) fn for_gains(&self) -> Option<Speed> {
        self.used.filter(|_| !self.low)
    }

    /// The measured speed that is believed, however low.
    pub(crate) const fn measured(&self) -> Option<Speed> {
        self.used
    }

    /// Whether the speed is below the minimum.
    pub(crate) const fn low(&self) -> bool {
        self.low
    }

    /// Which of the two is not believed.
    pub(crate) const fn doubted(&self) -> Option<Measure> {
        self.doubted
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn look(guard: &mut SpeedGuard, second: u64, water: Option<f64>, ground: Option<f64>) -> f64 {
        let speed = |knots: Option<f64>| knots.map(Speed::from_knots);
        let least = Speed::from_knots(2.0);
        guard.look(
            Stamp(second * 1000),
            speed(water),
            speed(ground),
            least,
            false,
        );
        guard
            .for_gains()
            .map_or(f64::NAN, |speed| libm::round(speed.knots()))
    }

    // FA10, AP-9
    #[test]
    fn the_one_that_left_the_speed_in_use_is_not_believed_until_both_agree() {
        for (bad, doubted) in [(0.0, Measure::Water), (99.0, Measure::Water)] {
            let mut guard = SpeedGuard::default();
            assert_eq!(look(&mut guard, 0, Some(14.0), Some(15.0)), 14.0);
            assert_eq!(look(&mut guard, 1, Some(bad), Some(15.0)), 15.0, "{bad}");
            assert_eq!(guard.doubted(), Some(doubted));
            assert!(
                look(&mut guard, 2, Some(bad), None).is_nan(),
                "the cruise speed"
            );
            assert_eq!(look(&mut guard, 3, Some(14.0), Some(15.0)), 15.0);
            assert_eq!(look(&mut guard, 13, Some(14.0), Some(15.0)), 14.0);
        }
        let mut guard = SpeedGuard::default();
        look(&mut guard, 0, Some(14.0), Some(15.0));
        assert_eq!(look(&mut guard, 1, Some(14.0), Some(0.0)), 14.0);
        assert_eq!(guard.doubted(), Some(Measure::Ground));
    }

    // FA10
    #[test]
    fn below_the_minimum_the_cruise_speed_stands_in() {
        let mut guard = SpeedGuard::default();
        assert!(look(&mut guard, 0, Some(1.5), Some(2.5)).is_nan());
        assert!(guard.low());
        assert_eq!(look(&mut guard, 1, Some(3.0), Some(2.5)), 3.0);
        assert_eq!(look(&mut guard, 2, Some(5.0), Some(11.0)), 5.0, "a current");
    }
}

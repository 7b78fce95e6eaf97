//! The page's judgement of time: how old is what came, by a clock that nobody can set (FD5, FC4, FC6).
//!
//! Steady milliseconds come in as arguments; [`Clock`] maps them to the ship's time, so that it is tested without a browser.
//!
//! **Invariant:** the ship's time never goes back but by a hello, and a frame that waited while the page or the network
//! stood still makes nothing live.

use wheelover_core::time::Stamp;

/// A frame may be so late before the page lets the ship's time run on, milliseconds.
const BATCH: f64 = 300.0;

/// After a silence only a frame younger than this is believed, milliseconds (FC4).
const YOUNG: f64 = 1_000.0;

/// The ship's time as the page knows it.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Clock {
    /// When the last believed frame came, steady milliseconds.
    heard: Option<f64>,
    /// The ship's time then, milliseconds.
    ship: f64,
    /// Ship's time for each second.
    rate: f64,
}

impl Clock {
    /// Takes the time of a hello that came at `steady`: it is made when it is asked for, so it is always believed.
    pub fn greet(&mut self, steady: f64, at: u64, rate: f64) {
        *self = Self {
            heard: Some(steady),
            ship: at as f64,
            rate,
        };
    }

    /// Takes the time of a snapshot. False where it waited somewhere while time went on: then it is not believed.
    pub fn snapshot(&mut self, steady: f64, at: u64, rate: f64) -> bool {
        // Lines of the same moment may still be under way.
        let believed = self.hear(steady, at as f64, BATCH * rate);
        if believed {
            self.rate = rate;
        }
        believed
    }

    /// Takes the time of the newest line. False as for [`Self::snapshot`].
    pub fn line(&mut self, steady: f64, at: Stamp) -> bool {
        self.hear(steady, at.0 as f64, 0.0)
    }

    fn hear(&mut self, steady: f64, at: f64, under_way: f64) -> bool {
        let Some(heard) = self.heard else {
            return false;
        };
        let silent = steady - heard;
        if silent > YOUNG && at < self.ship + (silent - YOUNG) * self.rate {
            return false;
        }
        self.ship = self.now(steady).max(at - under_way);
        self.heard = Some(steady);
        true
    }

    /// The ship's time at `steady`, milliseconds: it runs on although nothing comes.
    fn now(&self, steady: f64) -> f64 {
        let silent = self.heard.map_or(0.0, |heard| steady - heard);
        self.ship + (silent - BATCH).max(0.0) * self.rate
    }

    /// The ship's time at `steady`.
    #[must_use]
    pub fn stamp(&self, steady: f64) -> Stamp {
        Stamp(self.now(steady) as u64)
    }

    /// Milliseconds since the last believed frame; none before the first.
    #[must_use]
    pub fn age(&self, steady: f64) -> Option<u64> {
        self.heard.map(|heard| (steady - heard).max(0.0) as u64)
    }

    /// The computer slept for so many milliseconds, and the steady clock with it: ages count them (FD6).
    pub fn slept(&mut self, milliseconds: f64) {
        self.heard = self.heard.map(|heard| heard - milliseconds);
    }
}

/// Finds out that the page did not run, or that its computer slept.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Wakefulness {
    last: Option<(f64, f64)>,
}

/// What a look at both clocks says.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Absence {
    /// Milliseconds for which the page did not run.
    pub stood: f64,
    /// Milliseconds that the steady clock has missed because the computer slept.
    pub slept: f64,
}

impl Wakefulness {
    /// Looks at the steady clock and the wall's. The wall's clock going back says nothing; going forward alone, it may have
    /// been set or the computer may have slept: the worse is believed until the next frame comes.
    pub fn look(&mut self, steady: f64, wall: f64) -> Absence {
        let (steady_then, wall_then) = self.last.replace((steady, wall)).unwrap_or((steady, wall));
        let stood = steady - steady_then;
        let missed = (wall - wall_then) - stood;
        Absence {
            stood,
            slept: if missed > YOUNG { missed } else { 0.0 },
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A page that was greeted at 10 s of its clock and 1,000 s of the ship's, with frames each 100 ms for a second.
    fn linked(rate: f64) -> Clock {
        let mut clock = Clock::default();
        clock.greet(10_000.0, 1_000_000, rate);
        for tick in 1..=10_u32 {
            let at = 1_000_000 + (f64::from(tick) * 100.0 * rate) as u64;
            assert!(clock.snapshot(10_000.0 + f64::from(tick) * 100.0, at, rate));
        }
        clock
    }

    #[test]
    fn ages_grow_although_nothing_comes() {
        let clock = linked(1.0);
        assert_eq!(clock.age(11_000.0), Some(0));
        assert_eq!(clock.age(16_000.0), Some(5_000));
        assert!(clock.stamp(16_000.0).0 > clock.stamp(11_000.0).0 + 4_500);
        assert_eq!(Clock::default().age(99.0), None);
    }

    #[test]
    fn frames_that_waited_while_the_page_was_frozen_make_nothing_live() {
        // FC4, FC6: thirty seconds later come the frames that followed the last one.
        for rate in [1.0, 60.0] {
            let mut clock = linked(rate);
            let woken = 11_000.0 + 30_000.0;
            for late in 1..=3 {
                let at = 1_000_000 + ((1_000 + late * 100) as f64 * rate) as u64;
                assert!(!clock.snapshot(woken, at, rate), "{rate}");
                assert!(!clock.line(woken, Stamp(at)), "{rate}");
                assert_eq!(clock.age(woken), Some(30_000));
            }
            // One of now is believed.
            let at = 1_000_000 + (31_000.0 * rate) as u64;
            assert!(clock.snapshot(woken, at, rate));
            assert_eq!(clock.age(woken), Some(0));
        }
    }

    #[test]
    fn a_short_silence_is_not_held_against_a_frame() {
        let mut clock = linked(1.0);
        assert!(clock.snapshot(11_900.0, 1_001_100, 1.0));
        // After a longer one those of the last second are believed.
        assert!(!clock.line(14_400.0, Stamp(1_001_200)));
        assert!(clock.line(14_400.0, Stamp(1_003_000)));
    }

    #[test]
    fn the_ships_time_never_goes_back_but_by_a_hello() {
        let mut clock = linked(1.0);
        let before = clock.stamp(11_900.0);
        assert!(clock.snapshot(11_900.0, 1_001_000, 1.0));
        assert!(clock.stamp(11_900.0) >= before);
        clock.greet(12_000.0, 5, 1.0);
        assert_eq!(clock.stamp(12_000.0), Stamp(5));
    }

    #[test]
    fn a_clock_on_the_wall_that_is_set_back_changes_nothing() {
        let mut wakefulness = Wakefulness::default();
        wakefulness.look(1_000.0, 500_000.0);
        let back = wakefulness.look(1_250.0, 500_250.0 - 3_600_000.0);
        assert_eq!((back.stood, back.slept), (250.0, 0.0));
        let later = wakefulness.look(1_500.0, 500_500.0 - 3_600_000.0);
        assert_eq!(later.slept, 0.0);
    }

    #[test]
    fn a_sleep_that_the_steady_clock_missed_counts() {
        let mut wakefulness = Wakefulness::default();
        wakefulness.look(1_000.0, 500_000.0);
        let woken = wakefulness.look(1_016.0, 530_016.0);
        assert_eq!(woken.slept, 30_000.0);
        let mut clock = linked(1.0);
        clock.slept(woken.slept);
        assert_eq!(clock.age(11_000.0), Some(30_000));
    }
}

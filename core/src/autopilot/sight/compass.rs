//! Which compass is believed: each is judged by itself, then the best good one is taken (AP-9, FA7, FA8).
//!
//! A compass that jumped is bridged by its prediction for a second, then it is invalid until it has been steady for
//! ten; one that stands still while the ship turns is stuck. The next good one is taken in the same step; the better
//! one is taken back after ten seconds of agreement.

use super::guard::{HeadingGuard, HeadingVerdict};
use crate::picture::Source;
use crate::time::Stamp;
use crate::units::{Course, Heading, RateOfTurn, SignedAngle};
use alloc::vec::Vec;
use serde::{Deserialize, Serialize};

/// The better compass is taken back after so long of agreement.
const TRUST_MS: u64 = 10_000;
/// A reading that stays within so many degrees stands still.
const STILL_DEG: f64 = 0.15;
/// The ship turned: by the rate of turn, by the course over ground, degrees.
const TURNED_DEG: f64 = 2.0;
const COURSE_TURNED_DEG: f64 = 6.0;
/// What turned longer ago does not count.
const STILL_WINDOW_MS: u64 = 30_000;

/// What a compass says now.
#[derive(Clone, Debug)]
pub(crate) struct Reading<'a> {
    /// Whose it is.
    pub(crate) source: &'a Source,
    /// Order of preference, the lowest first.
    pub(crate) rank: u8,
    /// As it was said.
    pub(crate) said: Heading,
    /// How old it is, seconds.
    pub(crate) age: f64,
}

/// What else tells whether the ship turns.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Turning {
    /// Rate of turn in use.
    pub(crate) rate: RateOfTurn,
    /// The rate is measured by a sensor of its own.
    pub(crate) measured: bool,
    /// Course over ground at steering speed.
    pub(crate) course: Option<Course>,
    /// Duration of a step, s.
    pub(crate) dt: f64,
}

/// Why a compass is not believed.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub(crate) enum Doubt {
    /// It jumped; for a second its prediction stands in.
    Jumped,
    /// It stands still while the ship turns.
    Stuck,
}

/// One compass and what is known of it.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
struct Compass {
    source: Source,
    guard: HeadingGuard,
    still: Option<Still>,
    heading: Option<Heading>,
    doubt: Option<Doubt>,
}

/// Since when a reading has stood still, and how far the ship turned meanwhile.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
struct Still {
    since: Stamp,
    at: Heading,
    turned: f64,
    course: Option<Course>,
    stuck: bool,
}

/// All compasses.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub(crate) struct Compasses {
    list: Vec<Compass>,
    in_use: Option<Source>,
    fallen_from: Option<Source>,
    agrees_since: Option<Stamp>,
}

impl Compasses {
    /// Judges every compass, chooses one, and gives its heading. `free`: nothing is steered, the best is taken at once.
    pub(crate) fn look(
        &mut self,
        now: Stamp,
        readings: &[Reading<'_>],
        turning: Turning,
        jump: f64,
        free: bool,
    ) -> Option<Heading> {
        self.list
            .retain(|compass| readings.iter().any(|r| *r.source == compass.source));
        for reading in readings {
            if !self.list.iter().any(|c| c.source == *reading.source) {
                self.list.push(Compass::new(reading.source.clone()));
            }
            if let Some(compass) = self.list.iter_mut().find(|c| c.source == *reading.source) {
                compass.judge(now, reading, turning, jump);
            }
        }
        self.choose(now, readings, jump, free);
        self.heading()
    }

    fn choose(&mut self, now: Stamp, readings: &[Reading<'_>], jump: f64, free: bool) {
        let rank = |source: &Source| {
            let found = readings.iter().find(|reading| reading.source == source);
            found.map_or(u8::MAX, |reading| reading.rank)
        };
        // Good ones first, then bridged or stuck ones, each by rank.
        let best = |good: bool| {
            self.list
                .iter()
                .filter(|compass| compass.heading.is_some() && compass.doubt.is_none() == good)
                .min_by_key(|compass| rank(&compass.source))
                .map(|compass| compass.source.clone())
        };
        let (good, doubtful) = (best(true), best(false));
        let used = self.in_use.as_ref().and_then(|source| self.find(source));
        let bridged = used.is_some_and(|c| c.heading.is_some() && c.doubt == Some(Doubt::Jumped));
        let sound = used.is_some_and(|c| c.heading.is_some() && c.doubt.is_none());
        let next = match (good, &self.in_use) {
            (Some(good), Some(used)) if sound && good != *used && !free => {
                if rank(&good) < rank(used) && self.agree(&good, used, jump) {
                    let since = *self.agrees_since.get_or_insert(now);
                    if now.since(since) >= TRUST_MS {
                        Some(good)
                    } else {
                        Some(used.clone())
                    }
                } else {
                    self.agrees_since = None;
                    Some(used.clone())
                }
            }
            (_, Some(used)) if bridged => Some(used.clone()),
            (Some(good), _) => Some(good),
            (None, _) => doubtful,
        };
        if next != self.in_use {
            self.agrees_since = None;
            let before = self.in_use.take();
            match &next {
                Some(next) if free || self.fallen_from.as_ref() == Some(next) => {
                    self.fallen_from = None;
                }
                Some(_) if self.fallen_from.is_none() => self.fallen_from = before,
                _ => {}
            }
            if next.is_none() && !free {
                // Nothing is left: what was used stays the one that was lost.
                self.fallen_from = None;
            }
            self.in_use = next;
        }
    }

    fn find(&self, source: &Source) -> Option<&Compass> {
        self.list.iter().find(|compass| compass.source == *source)
    }

    fn agree(&self, one: &Source, other: &Source, within: f64) -> bool {
        let heading = |source| self.find(source).and_then(|compass| compass.heading);
        heading(one)
            .zip(heading(other))
            .is_some_and(|(one, other)| (one - other).abs().deg() <= within)
    }

    /// Heading of the compass in use.
    pub(crate) fn heading(&self) -> Option<Heading> {
        self.find(self.in_use.as_ref()?)?.heading
    }

    /// The compass in use.
    pub(crate) const fn in_use(&self) -> Option<&Source> {
        self.in_use.as_ref()
    }

    /// The better compass that was left, until it is taken back.
    pub(crate) const fn fallen_from(&self) -> Option<&Source> {
        self.fallen_from.as_ref()
    }

    /// Compasses that are not believed, and why.
    pub(crate) fn doubted(&self) -> impl Iterator<Item = (&Source, Doubt)> {
        self.list
            .iter()
            .filter_map(|compass| Some((&compass.source, compass.doubt?)))
    }
}

impl Compass {
    fn new(source: Source) -> Self {
        Self {
            source,
            guard: HeadingGuard::default(),
            still: None,
            heading: None,
            doubt: None,
        }
    }

    fn judge(&mut self, now: Stamp, reading: &Reading<'_>, turning: Turning, jump: f64) {
        // A slow compass is carried on by the rate of turn until it is heard again.
        let carried = reading.said + SignedAngle::from_deg(turning.rate.deg_per_s() * reading.age);
        let verdict = self.guard.judge(now, carried, turning.rate, jump);
        let stuck = self.stands_still(now, reading.said, turning);
        (self.heading, self.doubt) = match verdict {
            HeadingVerdict::Good(heading) => (Some(heading), stuck.then_some(Doubt::Stuck)),
            HeadingVerdict::Bridged(heading) => (Some(heading), Some(Doubt::Jumped)),
            HeadingVerdict::Invalid => (None, Some(Doubt::Jumped)),
        };
    }

    /// FA8: the reading does not move, though the ship turns.
    fn stands_still(&mut self, now: Stamp, said: Heading, turning: Turning) -> bool {
        let new = Still {
            since: now,
            at: said,
            turned: 0.0,
            course: turning.course,
            stuck: false,
        };
        let still = self.still.get_or_insert(new);
        let window = now.since(still.since) > STILL_WINDOW_MS && !still.stuck;
        if (said - still.at).abs().deg() > STILL_DEG || window {
            *still = new;
            return false;
        }
        if turning.measured {
            still.turned += turning.rate.deg_per_s() * turning.dt;
        }
        let course = still.course.zip(turning.course);
        let course_turned = course.map_or(0.0, |(from, to)| (to - from).abs().deg());
        still.stuck |= libm::fabs(still.turned) >= TURNED_DEG || course_turned >= COURSE_TURNED_DEG;
        still.stuck
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn source(port: usize) -> Source {
        Source {
            port,
            talker: "HE".into(),
            formatter: "HDT".into(),
        }
    }

    struct Bench {
        compasses: Compasses,
        now: Stamp,
    }

    impl Bench {
        fn step(&mut self, said: &[Option<f64>], rate: f64) -> (Option<f64>, Option<usize>) {
            self.now = self.now + 100;
            let sources: Vec<_> = (0..said.len()).map(source).collect();
            let readings: Vec<_> = said
                .iter()
                .zip(&sources)
                .enumerate()
                .filter_map(|(rank, (said, source))| {
                    Some(Reading {
                        source,
                        rank: rank as u8,
                        said: Heading::from_deg((*said)?),
                        age: 0.0,
                    })
                })
                .collect();
            let turning = Turning {
                rate: RateOfTurn::from_deg_per_min(rate),
                measured: true,
                course: None,
                dt: 0.1,
            };
            let heading = self
                .compasses
                .look(self.now, &readings, turning, 8.0, false);
            let port = self.compasses.in_use().map(|source| source.port);
            (heading.map(Heading::deg), port)
        }
    }

    fn bench() -> Bench {
        Bench {
            compasses: Compasses::default(),
            now: Stamp(0),
        }
    }

    // AP-9: two and three compasses; the first jumps, the next good one is taken, and given back after ten seconds.
    #[test]
    fn a_jump_of_one_compass_leads_to_the_next_good_one() {
        for further in [1, 2] {
            let mut bench = bench();
            let all = |first: Option<f64>| {
                let mut all = alloc::vec![first];
                all.extend((0..further).map(|_| Some(101.0)));
                all
            };
            assert_eq!(bench.step(&all(Some(100.0)), 0.0).1, Some(0));
            let mut used = Vec::new();
            for _ in 0..12 {
                used.push(bench.step(&all(Some(120.0)), 0.0));
            }
            assert_eq!(used[8], (Some(100.0), Some(0)), "bridged for a second");
            assert_eq!(used[11], (Some(101.0), Some(1)), "then the next good one");
            assert_eq!(bench.compasses.fallen_from(), Some(&source(0)));
            for _ in 0..350 {
                used.push(bench.step(&all(Some(100.0)), 0.0));
            }
            assert_eq!(used.last(), Some(&(Some(100.0), Some(0))), "taken back");
            assert_eq!(bench.compasses.fallen_from(), None);
        }
    }

    // AP-9: silent, and the next one has another opinion by more than a jump.
    #[test]
    fn a_silent_compass_leads_to_the_next_however_much_it_differs() {
        let mut bench = bench();
        bench.step(&[Some(100.0), Some(110.0)], 0.0);
        assert_eq!(
            bench.step(&[None, Some(110.0)], 0.0),
            (Some(110.0), Some(1))
        );
        for _ in 0..200 {
            let back = bench.step(&[Some(100.0), Some(110.0)], 0.0);
            assert_eq!(back.1, Some(1), "not taken back without agreement");
        }
        assert_eq!(bench.step(&[None, None], 0.0), (None, None));
    }

    // FA8
    #[test]
    fn a_compass_that_stands_still_while_the_ship_turns_is_stuck_within_ten_seconds() {
        let mut bench = bench();
        let mut since = None;
        for step in 0..100 {
            let second = 100.0 + 0.025 * f64::from(step);
            let seen = bench.step(&[Some(100.0), Some(second)], 15.0);
            if bench.compasses.doubted().next().is_some() {
                since.get_or_insert(step);
                assert_eq!(seen.1, Some(1));
            }
        }
        assert!(since.is_some_and(|step| step < 100), "{since:?}");
    }

    #[test]
    fn a_steady_course_is_not_stuck() {
        let mut bench = bench();
        for _ in 0..6_000 {
            bench.step(&[Some(100.0)], 1.0);
        }
        assert_eq!(bench.compasses.doubted().count(), 0);
    }
}

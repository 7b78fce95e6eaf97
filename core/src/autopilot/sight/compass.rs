//! Which compass is believed: each is judged by itself, then the best good one is taken (AP-9, FA7, FA8).
//!
//! A compass that jumped is bridged by its prediction for a second, then it is invalid until it has been steady for
//! ten; one that stands still while the ship turns is stuck; one that goes its own way, while another goes as the rate of
//! turn says, drifts. The next good one is taken in the same step; the better one is taken back after ten seconds of
//! agreement.

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
/// A reading is held against the rate of turn over about so long, seconds.
const DRIFT_TIME_S: f64 = 20.0;
/// One compass that is off what the rate of turn says by this much drifts, where another is on it within that, degrees.
const DRIFT_DEG: f64 = 3.0;
const NO_DRIFT_DEG: f64 = 1.0;
/// Off for so long is a drift; shorter is noise.
const DRIFT_MS: u64 = 500;
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
    /// It goes its own way, while another compass goes as the rate of turn says.
    Drifts,
}

/// One compass and what is known of it.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
struct Compass {
    source: Source,
    guard: HeadingGuard,
    still: Option<Still>,
    /// What the rate of turn makes of its earlier readings.
    expected: Option<Heading>,
    /// Since when it is off that, and until when it counts as drifting.
    off_since: Option<Stamp>,
    drifts_until: Option<Stamp>,
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
        if turning.measured {
            self.hold_against_the_rate(now, turning);
        }
        self.choose(now, readings, jump, free);
        self.heading()
    }

    /// AP-9: who goes as the rate of turn says bears witness against who does not; nobody is judged alone.
    fn hold_against_the_rate(&mut self, now: Stamp, turning: Turning) {
        let off: Vec<_> = (self.list.iter_mut())
            .map(|compass| compass.off_the_rate(turning))
            .collect();
        let witness = off.iter().flatten().any(|off| *off <= NO_DRIFT_DEG);
        for (compass, off) in self.list.iter_mut().zip(off) {
            if !witness || off.is_none_or(|off| off <= DRIFT_DEG) {
                compass.off_since = None;
            } else if now.since(*compass.off_since.get_or_insert(now)) >= DRIFT_MS {
                compass.drifts_until = Some(now + TRUST_MS);
            }
            let drifts = compass.drifts_until.is_some_and(|until| now < until);
            if drifts && compass.doubt.is_none() {
                compass.doubt = Some(Doubt::Drifts);
            }
        }
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
                .min_by_key(|compass| {
                    let left = self.fallen_from.as_ref() == Some(&compass.source);
                    (rank(&compass.source), !left)
                })
                .map(|compass| compass.source.clone())
        };
        let (good, doubtful) = (best(true), best(false));
        let used = self.in_use.as_ref().and_then(|source| self.find(source));
        let bridged = used.is_some_and(|c| c.heading.is_some() && c.doubt == Some(Doubt::Jumped));
        let sound = used.is_some_and(|c| c.heading.is_some() && c.doubt.is_none());
        let next = match (good, &self.in_use) {
            (Some(good), Some(used)) if sound && good != *used && !free => {
                let better = rank(&good) < rank(used) || self.fallen_from.as_ref() == Some(&good);
                if better && self.agree(&good, used, jump) {
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
            expected: None,
            off_since: None,
            drifts_until: None,
            heading: None,
            doubt: None,
        }
    }

    /// How far the heading is off what the rate of turn makes of the earlier ones, degrees.
    fn off_the_rate(&mut self, turning: Turning) -> Option<f64> {
        let heading = self.heading?;
        let turned = turning.rate.deg_per_s() * turning.dt;
        let expected = self.expected.unwrap_or(heading) + SignedAngle::from_deg(turned);
        let off = heading - expected;
        let share = turning.dt / DRIFT_TIME_S;
        self.expected = Some(expected + SignedAngle::from_deg(share * off.deg()));
        Some(off.abs().deg())
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
mod tests;

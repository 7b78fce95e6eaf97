//! Heading and rate of turn that are believed, of every compass and rate sensor that is heard (AP-9, AP-10, FA7, FA8).

use super::compass::{Compasses, Doubt, Reading, Turning};
use super::monitor::HeadingMonitor;
use super::mounted;
use super::north::North;
use super::rate::RateGuard;
use super::sighted::Sighted;
use crate::alerts::Alert;
use crate::autopilot::notices::Notice;
use crate::limits::{Quantity, limits};
use crate::picture::{Picture, Source};
use crate::post::Seen;
use crate::settings::Settings;
use crate::time::Stamp;
use crate::units::{Heading, RateOfTurn, SignedAngle};
use alloc::format;
use alloc::string::String;
use alloc::vec::Vec;
use serde::{Deserialize, Serialize};

/// Below this speed a course over ground says nothing of the heading, knots.
const STEERING_KNOTS: f64 = 3.0;

/// The compasses, and what is believed of them.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub(super) struct Headings {
    pub(super) heading: Option<Heading>,
    pub(super) rate: RateOfTurn,
    pub(super) compasses: Compasses,
    /// Which north the headings are of.
    pub(super) north: North,
    pub(super) monitor: HeadingMonitor,
    pub(super) rates: RateGuard,
    /// The rate of turn where it is measured and believed.
    pub(super) measured_rate: Option<RateOfTurn>,
    /// The heading; where there is none, the last one carried on by the measured rate of turn: only turns of it count (AP-21).
    carried: Option<Heading>,
    /// It was carried on in the last step.
    carries: bool,
}

impl Headings {
    /// Heading and rate of turn (AP-9, FA7, FA8).
    pub(super) fn look(
        &mut self,
        seen: Seen<'_>,
        settings: &Settings,
        free: bool,
        sighted: &mut Vec<Sighted>,
    ) {
        let (now, picture) = (seen.now, seen.picture);
        let rate = mounted::rate(seen, settings);
        let ground = seen.ground();
        let believed = !self.rates.doubted();
        let turning = Turning {
            rate: rate.filter(|_| believed).unwrap_or(self.rate),
            measured: rate.is_some() && believed,
            course: ground
                .filter(|ground| ground.speed.knots() > STEERING_KNOTS)
                .and_then(|ground| ground.course),
            dt: settings.step_ms() as f64 / 1000.0,
        };
        let said: Vec<_> = picture
            .headings
            .iter()
            .filter_map(|heard| {
                let said = seen.fresh(Some(heard), Quantity::Heading)?;
                let said = mounted::bearing(picture, settings, &heard.source, said)?;
                Some((heard, said))
            })
            .collect();
        let variation = variation(picture, now, settings);
        let all = said.iter().map(|(_, said)| said);
        let north = self.north.look(all, variation, free);
        if north != self.north {
            // What was heard of one north is no measure for the other.
            (self.compasses, self.heading) = (Compasses::default(), None);
            self.north = north;
        }
        let readings: Vec<_> = said
            .into_iter()
            .filter_map(|(heard, said)| {
                Some(Reading {
                    source: &heard.source,
                    rank: picture.rank(&heard.source),
                    said: north.of(&said, variation)?,
                    age: now.since(heard.at) as f64 / 1000.0,
                })
            })
            .collect();
        let (before, source) = (self.heading, self.compasses.in_use().cloned());
        let jump = settings.heading_jump;
        self.heading = self.compasses.look(now, &readings, turning, jump, free);
        let changed = source.is_some() && self.compasses.in_use() != source.as_ref();
        let change = before.zip(self.heading).filter(|_| !changed);
        self.rate = self.rates.judge(now, rate, change, self.rate, turning.dt);
        self.measured_rate = rate.filter(|_| !self.rates.doubted());
        self.carry(turning.dt, sighted);
        sighted.push(Sighted::Notice(self.what_the_rate_does(seen)));
        if let (true, Some(before), Some(after)) = (changed, before, self.heading) {
            sighted.push(Sighted::OtherCompass(after - before));
        }
        sighted.extend(self.what_compasses_do(seen).map(Sighted::Notice));
        self.monitor
            .look(seen, self.compasses.in_use(), variation, settings);
        let apart = Notice::of(Alert::HeadingDifference, self.monitor.warning());
        sighted.push(Sighted::Notice(apart));
        let heard = !readings.is_empty();
        if self.heading.is_some() {
            sighted.push(Sighted::Heading);
        } else if !recovers(seen) {
            sighted.push(Sighted::NoHeading { heard });
        }
    }

    /// The heading that the rate of turn carries on; north where there never was one.
    pub(super) fn carried(&self) -> Heading {
        self.carried.unwrap_or(Heading::from_deg(0.0))
    }

    /// AP-21: without a heading the last one is carried on by the measured rate of turn; when one is back, it is said by how much
    /// that differs.
    fn carry(&mut self, dt: f64, sighted: &mut Vec<Sighted>) {
        match (self.heading, self.measured_rate) {
            (Some(heading), _) => {
                if self.carries {
                    sighted.push(Sighted::HeadingBack(heading - self.carried()));
                }
                self.carried = Some(heading);
            }
            (None, Some(rate)) => {
                let turned = SignedAngle::from_deg(rate.deg_per_s() * dt);
                self.carried = Some(self.carried() + turned);
            }
            (None, None) => {}
        }
        self.carries = self.heading.is_none() && self.measured_rate.is_some();
    }

    fn what_compasses_do(&self, seen: Seen<'_>) -> [Notice; 3] {
        let name = |source: &Source| seen.picture.source_name(source);
        let list = |doubt: Doubt| {
            let doubted = self.compasses.doubted().filter(|(_, why)| *why == doubt);
            doubted
                .map(|(source, _)| name(source))
                .collect::<Vec<_>>()
                .join(", ")
        };
        let mut jumped = list(Doubt::Jumped);
        let (stuck, drifts) = (list(Doubt::Stuck), list(Doubt::Drifts));
        if jumped.is_empty() {
            jumped = drifts;
        }
        let fallen = self.compasses.fallen_from().map(name);
        let left = fallen.map(|left| {
            let used = self.compasses.in_use().map(name).unwrap_or_default();
            format!("Heading from {used} instead of {left}")
        });
        let text = |what: String| {
            let text = || format!("The heading of {what} is not used: check the compass");
            (!what.is_empty()).then(text)
        };
        [
            Notice::of(Alert::HeadingJump, text(jumped)),
            Notice::of(Alert::HeadingStuck, text(stuck)),
            Notice::of(Alert::HeadingSource, left),
        ]
    }

    /// AP-9: a rate of turn that is calculated, though a sensor says one, is said.
    fn what_the_rate_does(&self, seen: Seen<'_>) -> Notice {
        let text = || {
            let rate = seen.picture.rate(seen.now);
            let name = rate.map(|rate| seen.picture.source_name(&rate.source));
            format!(
                "Rate of turn of {} is not used: the heading goes another way. It is calculated",
                name.unwrap_or_default()
            )
        };
        Notice::of(Alert::RateOfTurn, self.rates.doubted().then(text))
    }

    /// The heading before anything is judged: the best that is heard, of the north in use.
    pub(super) fn heard(
        &self,
        picture: &Picture,
        now: Stamp,
        settings: &Settings,
    ) -> Option<Heading> {
        let variation = variation(picture, now, settings);
        let heard = picture.heading(now)?;
        let said = mounted::bearing(picture, settings, &heard.source, heard.value)?;
        self.north.of(&said, variation)
    }
}

/// The variation that is heard, else the one that is set; degrees, east positive (AP-9).
pub(super) fn variation(picture: &Picture, now: Stamp, settings: &Settings) -> Option<f64> {
    picture.variation(now).or(settings.variation)
}

/// FA16: after a stall the order is frozen, and a heading is lost only when none comes again.
fn recovers(seen: Seen<'_>) -> bool {
    let (_, lost) = limits(Quantity::Heading);
    seen.stalled_at()
        .is_some_and(|after| seen.now.since(after) <= lost)
}

//! What a plotter says of the leg that TRACK follows: whose APB is taken, and what it is held against (AP-14, EMC-3, FB13).
//!
//! An APB is followed in three steps. `command::apb` makes it a leg or refuses it; here it is brought to the north of the
//! compass in use and held against the one before it (a leg jumps only with a new waypoint) and, in `others`, against all
//! else that its port says. What is refused moves nothing, is said, and is TRACK FAIL when it lasts.

mod leg;
mod others;

use super::facts::Outlook;
use super::remote::Authority;
use crate::command::{self, Refusal};
use crate::nmea::Sentence;
use crate::picture::Source;
use crate::station::PortIndex;
use crate::time::Stamp;
use alloc::format;
use alloc::string::String;
pub(super) use leg::{Leg, north};
use others::Others;
use serde::{Deserialize, Serialize};

/// The leg's course may change by so much without a new waypoint, degrees.
const COURSE_STEP_DEG: f64 = 5.0;
/// The course that was accepted follows so slowly, degrees a second, so that many small steps are a large one.
const COURSE_FOLLOWS: f64 = 0.1;
/// A heading to steer that changes by more at once counts when it is said twice, degrees.
const HEADING_STEP_DEG: f64 = 15.0;
/// Headings to steer within so many degrees are the same.
const SAME_DEG: f64 = 2.0;
/// The cross-track distance changes by no more than the way made, times this, and what two distances may differ by.
const WAY: f64 = 1.5;
/// Sentences of a plotter are not of one moment: what contradicts for less is not followed, and not yet said, milliseconds.
const PATIENCE_MS: u64 = 1_500;

/// What is known of the plotter that is followed.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub(super) struct Plotter {
    /// Whose APB are followed, and the last of them.
    pub(super) apb: Authority<Leg>,
    /// Course of the leg as it was accepted, degrees.
    course: Option<f64>,
    /// A waypoint that waits to be said again, and when it was first said.
    next: Option<(String, Stamp)>,
    /// A heading to steer that waits to be said again, degrees.
    stepped: Option<f64>,
    /// Since when something contradicts.
    contradicted: Option<Stamp>,
    others: Others,
}

/// Why an APB is not followed.
pub(super) enum Unfollowed {
    /// The plotter has no position: there is nothing to follow.
    NotValid(String),
    /// It is refused, and that is said.
    Refused(Refusal),
    /// It waits for the next one.
    Waits,
}

impl From<Refusal> for Unfollowed {
    fn from(refusal: Refusal) -> Self {
        Self::Refused(refusal)
    }
}

fn refuse<T>(field: u8, text: String) -> Result<T, Unfollowed> {
    Err(Unfollowed::Refused(Refusal {
        field: Some(field),
        text,
    }))
}

impl Plotter {
    /// The leg in force, of the north of the compass in use.
    pub(super) fn in_force(&self, outlook: &Outlook<'_>) -> Option<&Leg> {
        let ms = outlook.facts.settings.track_fail_ms();
        let leg = self.apb.command(outlook.facts.now, ms)?;
        (leg.magnetic == outlook.sight.is_magnetic()).then_some(leg)
    }

    /// Takes another sentence of the port: what it says is held against APB.
    pub(super) fn on_other(&mut self, now: Stamp, port: PortIndex, sentence: &Sentence<'_>) {
        self.others.take(now, port, sentence);
    }

    /// Takes an APB whose source has the authority.
    pub(super) fn on_apb(
        &mut self,
        outlook: &Outlook<'_>,
        source: Source,
        sentence: &Sentence<'_>,
    ) -> Result<(), Unfollowed> {
        let now = outlook.facts.now;
        let heard = self.judge(outlook, &source, sentence);
        match &heard {
            Ok(leg) => {
                self.apb.take(now, source, leg.clone());
                self.apb.prove(now);
            }
            Err(Unfollowed::NotValid(why)) => {
                self.apb.drop_command();
                self.apb.refuse(now, format!("APB refused: {why}"));
            }
            Err(Unfollowed::Refused(refusal)) => {
                self.apb.disprove();
                self.apb.refuse(now, format!("APB refused: {refusal}"));
            }
            Err(Unfollowed::Waits) => {}
        }
        heard.map(|_| ())
    }

    /// The leg of an APB, or why it is not followed.
    fn judge(
        &mut self,
        outlook: &Outlook<'_>,
        source: &Source,
        sentence: &Sentence<'_>,
    ) -> Result<Leg, Unfollowed> {
        let now = outlook.facts.now;
        let said = match command::apb(sentence)? {
            command::Plotted::Leg(said) => said,
            command::Plotted::NotValid(why) => return Err(Unfollowed::NotValid(why)),
        };
        let leg = Leg::of(said, outlook)?;
        leg.agrees_in_itself(outlook)?;
        let fresh = outlook.facts.settings.track_fail_ms();
        let before = self.apb.command(now, fresh);
        let before = before
            .filter(|before| before.magnetic == leg.magnetic)
            .cloned();
        let begun = match before {
            Some(before) if leg.is_of_another_waypoint(&before) => {
                self.another_waypoint(now, &leg)?
            }
            Some(before) => {
                self.next = None;
                self.same_waypoint(outlook, &before, &leg)?;
                before.begun
            }
            None => {
                (self.next, self.stepped) = (None, None);
                self.course = Some(leg.course.deg());
                now
            }
        };
        let leg = Leg { begun, ..leg };
        match self.others.contradiction(outlook, source.port, &leg) {
            None => self.contradicted = None,
            Some(text) => {
                let since = *self.contradicted.get_or_insert(now);
                if now.since(since) < PATIENCE_MS {
                    self.apb.disprove();
                    return Err(Unfollowed::Waits);
                }
                return Err(Refusal::because(text).into());
            }
        }
        Ok(leg)
    }

    /// A new waypoint is a new leg as soon as it is said twice.
    fn another_waypoint(&mut self, now: Stamp, leg: &Leg) -> Result<Stamp, Unfollowed> {
        match &self.next {
            Some((waypoint, since)) if *waypoint == leg.waypoint => {
                let since = *since;
                (self.next, self.stepped) = (None, None);
                self.course = Some(leg.course.deg());
                Ok(since)
            }
            _ => {
                self.next = Some((leg.waypoint.clone(), now));
                Err(Unfollowed::Waits)
            }
        }
    }

    /// Without a new waypoint nothing of the leg jumps.
    fn same_waypoint(
        &mut self,
        outlook: &Outlook<'_>,
        before: &Leg,
        leg: &Leg,
    ) -> Result<(), Unfollowed> {
        let seconds = outlook.facts.now.since(self.apb.heard_at()) as f64 / 1000.0;
        let accepted = self.course.unwrap_or(leg.course.deg());
        let turned = crate::units::wrap_180(leg.course.deg() - accepted);
        if libm::fabs(turned) > COURSE_STEP_DEG {
            return refuse(
                8,
                format!(
                    "the leg's course jumps from {accepted:05.1} to {:05.1} without a new waypoint",
                    leg.course.deg()
                ),
            );
        }
        let moved = libm::fabs(leg.cross_track.m() - before.cross_track.m());
        let resolution = leg.resolution.m() + before.resolution.m();
        let way = WAY * outlook.speed().mps() * seconds;
        if moved > way + resolution + outlook.facts.settings.leg_tolerance {
            return refuse(
                3,
                format!("the cross-track distance jumps by {moved:.0} m without a new waypoint"),
            );
        }
        if let (Some(from), Some(to)) = (before.heading_to_steer, leg.heading_to_steer) {
            let said_before = self.stepped.is_some_and(|stepped| {
                libm::fabs(crate::units::wrap_180(to.deg() - stepped)) <= SAME_DEG
            });
            let step = (to - from).abs().deg();
            if step > HEADING_STEP_DEG && !said_before {
                self.stepped = Some(to.deg());
                return refuse(
                    13,
                    format!("the heading to steer jumps by {step:.0}° without a new waypoint"),
                );
            }
            self.stepped = None;
        }
        let most = COURSE_FOLLOWS * seconds;
        self.course = Some(crate::units::wrap_360(accepted + turned.clamp(-most, most)));
        Ok(())
    }
}

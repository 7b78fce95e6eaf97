//! Selecting a mode: the operator's half at once, AutoNAV when both sides agree within 20 s (AP-6, AP-7, FA14).

use super::event::Event;
use super::mode::{Mode, row};
use super::need::Need;
use super::ordered::ANSWERED;
use super::part::Modes;
use super::table::ModeName;
use crate::alerts::Alert;
use crate::autopilot::facts::Outlook;
use crate::autopilot::notices::Notices;
use crate::command::{ModeRequest, Refusal, Remote};
use crate::time::Stamp;
use crate::units::{Heading, Radius, SignedAngle};
use alloc::format;
use alloc::string::{String, ToString};
use core::ops::RangeInclusive;

/// A selection of AutoNAV that waits for the chart system (AP-6).
const CONFIRM_MS: u64 = 20_000;

impl Modes {
    /// The operator selects a mode; his STANDBY is always granted.
    pub(in super::super) fn request(
        &mut self,
        outlook: &Outlook<'_>,
        request: ModeRequest,
        notices: &mut Notices,
    ) -> Result<String, Refusal> {
        match request {
            ModeRequest::Standby => {
                self.over_the_lever = true;
                for over in [Alert::HeadingLost, Alert::Override, Alert::WindLost] {
                    notices.rectify(over);
                }
                self.apply(&outlook.facts, &Event::Standby, "operator selected STANDBY");
                Ok("STANDBY".into())
            }
            ModeRequest::Auto => {
                self.may_select(outlook, request)?;
                for over in ANSWERED {
                    notices.rectify(over);
                }
                self.apply(&outlook.facts, &Event::Auto, "operator selected AUTO");
                let heading = self
                    .mode
                    .state()
                    .hts(&outlook.facts)
                    .map_or(0.0, Heading::deg);
                Ok(format!("AUTO on {heading:05.1}"))
            }
            ModeRequest::Autonav => self.request_autonav(outlook, notices),
            ModeRequest::Cancel => Ok(self.release(outlook).unwrap_or_else(|| {
                self.mode.select(None);
                "AutoNAV selection withdrawn".into()
            })),
            ModeRequest::Dodge => match self.release(outlook) {
                Some(released) => Ok(released),
                None => self.enter(outlook, request, notices),
            },
            ModeRequest::Track => self.follow_the_plotter(outlook, notices),
            _ => self.enter(outlook, request, notices),
        }
    }

    /// The operator sets a heading, degrees.
    pub(in super::super) fn request_heading(
        &mut self,
        outlook: &Outlook<'_>,
        degrees: f64,
    ) -> Result<String, Refusal> {
        let degrees = within("set heading", degrees, 0.0..=360.0)?;
        self.set_heading(outlook, Heading::from_deg(degrees))
    }

    /// The operator changes the set heading by so many degrees.
    pub(in super::super) fn request_change(
        &mut self,
        outlook: &Outlook<'_>,
        degrees: f64,
    ) -> Result<String, Refusal> {
        let Mode::Auto(auto) = &self.mode else {
            return Err(in_auto_only());
        };
        let set = auto.set;
        let degrees = within("change of the set heading", degrees, -180.0..=180.0)?;
        self.set_heading(outlook, set + SignedAngle::from_deg(degrees))
    }

    fn set_heading(&mut self, outlook: &Outlook<'_>, set: Heading) -> Result<String, Refusal> {
        if !matches!(self.mode, Mode::Auto(_)) {
            return Err(in_auto_only());
        }
        self.off_heading.restart();
        let event = Event::SetHeading(set);
        self.apply(&outlook.facts, &event, "operator set the heading");
        Ok(format!("set heading {:05.1}", set.deg()))
    }

    /// The operator's half of the selection.
    fn request_autonav(
        &mut self,
        outlook: &Outlook<'_>,
        notices: &mut Notices,
    ) -> Result<String, Refusal> {
        if let Err(refusal) = self.may_select(outlook, ModeRequest::Autonav) {
            // AP-7, App. B: it stands until STANDBY and another source.
            if refusal.text == Need::SpeedSource.missing() {
                self.speed_by_hand = true;
                notices.raise(Alert::ChangeSpeedSource, "");
            }
            return Err(refusal);
        }
        self.mode.select(Some(outlook.facts.now + CONFIRM_MS));
        self.why = "AutoNAV selected".into();
        Ok(self.waits_for(outlook))
    }

    /// Until when a selection of AutoNAV waits for its confirmation.
    pub(in super::super) const fn pending(&self) -> Option<Stamp> {
        self.mode.selected_until()
    }

    /// What a pending selection still waits for, in an officer's words.
    pub(in super::super) fn waits_for(&self, outlook: &Outlook<'_>) -> String {
        match self.wanted(outlook) {
            None => "waits for the chart system".into(),
            Some(wanted) => match self.missing(outlook, wanted) {
                Some(missing) => missing.to_string(),
                None => "waits for three commands in a row".into(),
            },
        }
    }

    /// Engages a pending selection as soon as both sides agree, or lets it lapse.
    pub(super) fn try_engage(&mut self, outlook: &Outlook<'_>, notices: &mut Notices) {
        let Some(until) = self.mode.selected_until() else {
            return;
        };
        let now = outlook.facts.now;
        if now >= until {
            let waits = self.waits_for(outlook);
            self.why = format!("AutoNAV not confirmed within 20 s: {waits}");
            self.mode.select(None);
            return;
        }
        if !self.has(outlook, Need::LegKnown, self.pending_mode(outlook)) {
            self.mode.select(None);
            self.why = "AutoNAV refused: not in the middle of a turn".into();
            return;
        }
        let proven = self.commands(outlook).is_proven(now);
        let Some(wanted) = self
            .wanted(outlook)
            .filter(|wanted| proven && self.missing(outlook, *wanted).is_none())
        else {
            return;
        };
        if let Some(event) = self.engagement(outlook, wanted) {
            self.remote.by_hsc = self.obeys_hsc(outlook);
            notices.rectify(Alert::TrackFail);
            self.apply(&outlook.facts, &event, why_of(wanted));
        }
    }

    /// The transition to what the chart system asks for.
    pub(super) fn engagement(&self, outlook: &Outlook<'_>, wanted: ModeName) -> Option<Event> {
        match (wanted, self.command(outlook)?) {
            (ModeName::AutonavTn, Remote::Heading { hts, track, rate }) => {
                Some(Event::EngageTn { hts, track, rate })
            }
            (ModeName::AutonavTi, Remote::Track { track, .. }) => Some(Event::EngageTi {
                path: self.charted(outlook).leg(track)?,
                radius: Radius::from_nm(outlook.facts.settings.set_radius),
            }),
            _ => None,
        }
    }
}

/// Why a mode that is commanded is on.
pub(super) fn why_of(mode: ModeName) -> &'static str {
    let why = row(mode).and_then(|row| row.commanded);
    why.unwrap_or_default()
}

fn in_auto_only() -> Refusal {
    Refusal::because("the heading is set in AUTO only")
}

/// A number within its range, in degrees.
fn within(what: &str, value: f64, range: RangeInclusive<f64>) -> Result<f64, Refusal> {
    if range.contains(&value) {
        return Ok(value);
    }
    let (low, high) = (range.start(), range.end());
    Err(Refusal::because(format!(
        "{what} is {value}, allowed are {low} to {high} deg"
    )))
}

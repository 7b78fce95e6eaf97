//! Selecting AutoNAV: both sides must agree within 20 s, and what each kind needs (AP-6, AP-7, FA14).

use super::modes::{self, Event, Need};
use super::{Autopilot, CONFIRM_MS, Mode, ModeName};
use crate::alerts::Alert;
use crate::command::{ModeRequest, Refusal, Remote};
use crate::limits::Quantity;
use crate::nmea::Pney1;
use crate::time::Stamp;
use crate::units::Radius;
use alloc::string::{String, ToString};

/// So many valid HTC in a row, within so long, before the first is obeyed (FA14).
const PROOFS: usize = 3;
const PROOF_WINDOW_MS: u64 = 5_000;

/// The mode that a command asks for; absent where it asks for no control.
pub(super) const fn mode_of(command: Remote) -> Option<ModeName> {
    match command {
        Remote::Heading { .. } => Some(ModeName::AutonavTn),
        Remote::Track { .. } => Some(ModeName::AutonavTi),
        Remote::Override | Remote::Stop(_) => None,
    }
}

/// Why such a mode is on.
pub(super) const fn why_of(mode: ModeName) -> &'static str {
    match mode {
        ModeName::AutonavTn => "heading controlled by the chart system",
        _ => "track controlled by the chart system",
    }
}

impl Autopilot {
    /// The operator's half of the selection.
    pub(super) fn request_autonav(&mut self, now: Stamp) -> Result<String, Refusal> {
        self.may_select(now, ModeRequest::Autonav)?;
        self.mode.select(Some(now + CONFIRM_MS));
        self.why = "AutoNAV selected".into();
        Ok(self.waits_for(now))
    }

    /// Whether a mode may be asked for now, or why not; STANDBY always (AP-25). A press and the page's button ask this one.
    ///
    /// # Errors
    /// The first need that the selection is refused without, in an officer's words (AP-6).
    pub fn may_select(&self, now: Stamp, request: ModeRequest) -> Result<(), Refusal> {
        let mode = match request {
            ModeRequest::Standby | ModeRequest::Cancel => return Ok(()),
            ModeRequest::Auto => ModeName::Auto,
            ModeRequest::Autonav if self.mode.is_autonav() => {
                return Err(Refusal::because("AutoNAV is active already"));
            }
            ModeRequest::Autonav => self.pending_mode(now),
            ModeRequest::Track => {
                return Err(Refusal::because("TRACK needs valid APB: none is heard"));
            }
        };
        self.can_enter(now, mode)
    }

    /// Whether a mode may be entered now, or why not.
    fn can_enter(&self, now: Stamp, mode: ModeName) -> Result<(), Refusal> {
        let entry = modes::row(mode).map_or(&[][..], |row| row.entry);
        let lacks = entry.iter().find(|need| !self.has(now, **need, mode));
        lacks.map_or(Ok(()), |need| Err(Refusal::because(need.missing())))
    }

    /// What a pending selection still waits for, in an officer's words.
    #[must_use]
    pub fn waits_for(&self, now: Stamp) -> String {
        match self.wanted(now) {
            None => "waits for the chart system".into(),
            Some(wanted) => match self.missing(now, wanted) {
                Some(missing) => missing.to_string(),
                None => "waits for three commands in a row".into(),
            },
        }
    }

    /// What a pending selection will be; Ti until the chart system has said.
    #[must_use]
    pub fn pending_mode(&self, now: Stamp) -> ModeName {
        self.wanted(now).unwrap_or(ModeName::AutonavTi)
    }

    /// Engages a pending selection as soon as both sides agree, or lets it lapse.
    pub(super) fn try_engage(&mut self, now: Stamp) {
        let Some(until) = self.mode.selected_until() else {
            return;
        };
        if now >= until {
            self.why = alloc::format!("AutoNAV not confirmed within 20 s: {}", self.waits_for(now));
            self.mode.select(None);
            return;
        }
        if !self.has(now, Need::LegKnown, self.pending_mode(now)) {
            self.mode.select(None);
            self.why = "AutoNAV refused: not in the middle of a turn".into();
            return;
        }
        let proven = self.remote.proofs.len() >= PROOFS
            && self
                .remote
                .proofs
                .front()
                .is_some_and(|first| now.since(*first) <= PROOF_WINDOW_MS);
        let Some(wanted) = self
            .wanted(now)
            .filter(|wanted| proven && self.missing(now, *wanted).is_none())
        else {
            return;
        };
        if let Some(event) = self.engagement(now, wanted) {
            self.alerts.machine.rectify(now, Alert::TrackFail);
            self.engage(now, &event, why_of(wanted));
        }
    }

    /// Notes a valid command for the proof of life.
    pub(super) fn prove(&mut self, now: Stamp) {
        let proofs = &mut self.remote.proofs;
        proofs.push_back(now);
        while proofs.len() > PROOFS {
            proofs.pop_front();
        }
    }

    pub(super) fn wanted(&self, now: Stamp) -> Option<ModeName> {
        mode_of(self.remote.command(now, self.settings.track_fail_ms())?)
    }

    fn override_heard(&self, now: Stamp) -> bool {
        self.remote.command(now, self.settings.track_fail_ms()) == Some(Remote::Override)
    }

    /// AP-7: the first thing that is missing.
    pub(super) fn missing(&self, now: Stamp, mode: ModeName) -> Option<&'static str> {
        let needs = modes::row(mode).map_or(&[][..], |row| row.needs);
        let lacks = needs.iter().find(|need| !self.has(now, **need, mode));
        lacks.map(|need| need.missing())
    }

    /// Whether a need of a mode is met, at its selection and at every command that is followed.
    fn has(&self, now: Stamp, need: Need, mode: ModeName) -> bool {
        let picture = &self.post.picture;
        match need {
            Need::Enabled => self.settings.external_tcs,
            Need::InAuto => matches!(self.mode, Mode::Auto(_)),
            Need::TrueHeading => !self.heading_is_magnetic(),
            Need::NoOverride => !self.override_heard(now),
            Need::LegKnown => self.commanded_radius(now).is_none(),
            Need::Heading => self.sight.heading().is_some(),
            Need::MeasuredSpeed => {
                let ground = self.fresh(picture.ground(now), Quantity::Ground);
                let water = self.fresh(picture.water_speed(now), Quantity::WaterSpeed);
                ground.is_some() || water.is_some()
            }
            Need::Command => self.wanted(now) == Some(mode),
            Need::ShipConstants => self.steering.settings().known,
            Need::Position => {
                self.sight.place(now).is_some()
                    && self.fresh(picture.fix(now), Quantity::Position).is_some()
            }
            Need::CrossTrack => {
                let valid = picture.xte.as_ref().filter(|xte| xte.not_valid.is_none());
                self.fresh(valid, Quantity::Control).is_some()
            }
            Need::ControlDistance => self.pney1().is_some(),
            Need::Leg => self.pney1().is_some_and(|said| said.cross_track.is_some()),
            Need::Centre => {
                let said = picture.pney2.as_ref();
                self.fresh(said, Quantity::Control).is_some()
            }
            Need::OnePosition => self.positions_agree().is_ok(),
            // Watched from when the mode is entered: what disagrees then is not followed.
            Need::Agreement => true,
        }
    }

    /// PNEY,001, fresh and with status A.
    fn pney1(&self) -> Option<Pney1> {
        let said = self.post.picture.pney1.as_ref();
        let valid = said.filter(|said| said.not_valid.is_none());
        self.fresh(valid, Quantity::Control)
    }

    /// The transition to what the chart system asks for.
    pub(super) fn engagement(&self, now: Stamp, wanted: ModeName) -> Option<Event> {
        match (
            wanted,
            self.remote.command(now, self.settings.track_fail_ms())?,
        ) {
            (ModeName::AutonavTn, Remote::Heading { hts, track, rate }) => {
                Some(Event::EngageTn { hts, track, rate })
            }
            (ModeName::AutonavTi, Remote::Track { track, .. }) => Some(Event::EngageTi {
                path: self.leg_line(track)?,
                radius: Radius::from_nm(self.settings.set_radius),
            }),
            _ => None,
        }
    }
}

//! Selecting AutoNAV: both sides must agree within 20 s, and what each kind needs (AP-6, AP-7, FA14).

use super::modes::Event;
use super::{Autopilot, CONFIRM_MS, Mode, ModeName};
use crate::alerts::Alert;
use crate::command::{Refusal, Remote};
use crate::limits::Quantity;
use crate::time::Stamp;
use crate::units::Radius;
use alloc::string::{String, ToString};

/// So many valid HTC in a row, within so long, before the first is obeyed (FA14).
const PROOFS: usize = 3;
const PROOF_WINDOW_MS: u64 = 5_000;

/// What the chart system asks for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Wanted {
    /// Remote heading control.
    Tn,
    /// Track control.
    Ti,
}

impl Wanted {
    /// What a command asks for; absent where it asks for no control.
    pub(super) const fn of(command: Remote) -> Option<Self> {
        match command {
            Remote::Heading { .. } => Some(Self::Tn),
            Remote::Track { .. } => Some(Self::Ti),
            Remote::Override | Remote::Stop(_) => None,
        }
    }

    /// Its mode.
    pub(super) const fn mode(self) -> ModeName {
        match self {
            Self::Tn => ModeName::AutonavTn,
            Self::Ti => ModeName::AutonavTi,
        }
    }

    /// What steers, in an officer's words.
    pub(super) const fn why(self) -> &'static str {
        match self {
            Self::Tn => "heading controlled by the chart system",
            Self::Ti => "track controlled by the chart system",
        }
    }
}

impl Autopilot {
    /// The operator's half of the selection.
    pub(super) fn request_autonav(&mut self, now: Stamp) -> Result<String, Refusal> {
        let refuse = |text: &str| Err(Refusal::because(text.to_string()));
        if self.mode.is_autonav() {
            return refuse("AutoNAV is active already");
        }
        if !self.settings.external_tcs {
            return refuse("AutoNAV is not enabled at installation");
        }
        if !matches!(self.mode, Mode::Auto { .. }) {
            return refuse("AutoNAV is selected from AUTO only");
        }
        if self.override_heard(now) {
            return refuse("override is in use");
        }
        if self.in_foreign_turn(now) {
            return refuse("not in the middle of a turn: the leg before it is unknown");
        }
        self.pending = Some(now + CONFIRM_MS);
        self.why = "AutoNAV selected".into();
        Ok(self.waits_for(now))
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
        self.wanted(now).unwrap_or(Wanted::Ti).mode()
    }

    /// Engages a pending selection as soon as both sides agree, or lets it lapse.
    pub(super) fn try_engage(&mut self, now: Stamp) {
        let Some(until) = self.pending else {
            return;
        };
        if now >= until {
            self.why = alloc::format!("AutoNAV not confirmed within 20 s: {}", self.waits_for(now));
            self.pending = None;
            return;
        }
        if self.in_foreign_turn(now) {
            self.pending = None;
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
            self.pending = None;
            self.alerts.rectify(now, Alert::TrackFail);
            self.engage(now, &event, wanted.why());
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

    pub(super) fn wanted(&self, now: Stamp) -> Option<Wanted> {
        Wanted::of(self.remote.command(now, self.fail_ms())?)
    }

    pub(super) fn override_heard(&self, now: Stamp) -> bool {
        self.remote.command(now, self.fail_ms()) == Some(Remote::Override)
    }

    /// Situations 3 and 4 cannot be entered (AP-6).
    fn in_foreign_turn(&self, now: Stamp) -> bool {
        self.commanded_radius(now).is_some()
    }

    /// AP-7: the first thing that is missing.
    pub(super) fn missing(&self, now: Stamp, wanted: Wanted) -> Option<&'static str> {
        let picture = &self.post.picture;
        if self.heading.is_none() {
            return Some("no heading");
        }
        if self.fresh(picture.ground(now), Quantity::Ground).is_none()
            && self
                .fresh(picture.water_speed(now), Quantity::WaterSpeed)
                .is_none()
        {
            return Some("no measured speed");
        }
        if self.wanted(now) != Some(wanted) {
            return Some("no valid HTC");
        }
        if wanted == Wanted::Tn {
            return None;
        }
        if !self.steering.settings().known {
            return Some("the ship's constants are not given: no track control (AP-20)");
        }
        if self.position_guard.dead_reckoning(now).is_none()
            || self.fresh(picture.fix(now), Quantity::Position).is_none()
        {
            return Some("no position");
        }
        // AP-7: fresh and with status A.
        let xte = picture.xte.as_ref().filter(|xte| xte.not_valid.is_none());
        let pney1 = picture
            .pney1
            .as_ref()
            .filter(|pney1| pney1.not_valid.is_none());
        if self.fresh(xte, Quantity::Control).is_none() {
            return Some("no valid XTE");
        }
        match self.fresh(pney1, Quantity::Control) {
            None => return Some("no valid PNEY,001"),
            Some(pney1) if pney1.cross_track.is_none() => {
                return Some("PNEY,001 has no distance: no leg");
            }
            Some(_) => {}
        }
        if self
            .fresh(picture.pney2.as_ref(), Quantity::Control)
            .is_none()
        {
            return Some("no valid PNEY,002");
        }
        if self.positions_agree().is_err() {
            return Some("own and the chart system's position are too far apart");
        }
        None
    }

    /// The transition to what the chart system asks for.
    pub(super) fn engagement(&self, now: Stamp, wanted: Wanted) -> Option<Event> {
        match (wanted, self.remote.command(now, self.fail_ms())?) {
            (Wanted::Tn, Remote::Heading { hts, track, rate }) => {
                Some(Event::EngageTn { hts, track, rate })
            }
            (Wanted::Ti, Remote::Track { track, .. }) => Some(Event::EngageTi {
                path: self.leg_line(track)?,
                radius: Radius::from_nm(self.settings.set_radius),
            }),
            _ => None,
        }
    }
}

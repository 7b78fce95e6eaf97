//! Selecting AutoNAV: both sides must agree within 20 s, and what each kind needs (AP-6, AP-7, FA14).

use super::modes::Event;
use super::steering::Path;
use super::{Autopilot, CONFIRM_MS, Mode};
use crate::alerts::Alert;
use crate::command::Refusal;
use crate::limits::Quantity;
use crate::nmea::{Htc, OverrideStatus, SteeringMode, TurnMode};
use crate::time::Stamp;
use crate::units::{Course, Heading, Radius, RateOfTurn};
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
        let proven = self.commands.len() >= PROOFS
            && self
                .commands
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
            self.followed = now;
            self.alerts.rectify(now, Alert::TrackFail);
            let why = match wanted {
                Wanted::Tn => "heading controlled by the chart system",
                Wanted::Ti => "track controlled by the chart system",
            };
            self.apply(now, &event, why);
        }
    }

    /// Notes a valid command for the proof of life.
    pub(super) fn prove(&mut self, now: Stamp) {
        self.commands.push_back(now);
        while self.commands.len() > PROOFS {
            self.commands.pop_front();
        }
    }

    /// The last HTC that may be obeyed and is fresh.
    pub(super) fn commanded(&self) -> Option<Htc> {
        self.fresh(self.post.picture.htc.as_ref(), Quantity::Control)
            .map(|commanded| commanded.htc)
            .filter(|htc| htc.status.is_some() || self.settings.accept_null_status)
    }

    pub(super) fn wanted(&self, _now: Stamp) -> Option<Wanted> {
        match self.commanded()?.steering_mode? {
            SteeringMode::HeadingControl => Some(Wanted::Tn),
            SteeringMode::TrackControl => Some(Wanted::Ti),
            SteeringMode::Manual | SteeringMode::StandAlone | SteeringMode::RudderControl => None,
        }
    }

    pub(super) fn override_heard(&self, _now: Stamp) -> bool {
        self.commanded()
            .is_some_and(|htc| htc.override_status == Some(OverrideStatus::InUse))
    }

    /// Situations 3 and 4 cannot be entered (AP-6).
    fn in_foreign_turn(&self, now: Stamp) -> bool {
        self.wanted(now) == Some(Wanted::Ti)
            && self.commanded().is_some_and(|htc| htc.radius.is_some())
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
        let Some(htc) = self.commanded() else {
            return Some("no valid HTC");
        };
        if wanted == Wanted::Tn {
            return htc
                .heading_to_steer
                .is_none()
                .then_some("HTC has no heading to steer");
        }
        if htc.track.is_none() {
            return Some("HTC has no track");
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
        None
    }

    /// The transition to what the chart system asks for.
    pub(super) fn engagement(&self, _now: Stamp, wanted: Wanted) -> Option<Event> {
        let htc = self.commanded()?;
        match wanted {
            Wanted::Tn => {
                let hts = Heading::from_deg(htc.heading_to_steer?);
                let track = htc.track.map_or(hts.as_course(), Course::from_deg);
                Some(Event::EngageTn {
                    hts,
                    track,
                    rate: turn_rate(&htc),
                })
            }
            Wanted::Ti => {
                let track = Course::from_deg(htc.track?);
                let path = Path::leg(self.leg_point(track)?, track);
                Some(Event::EngageTi {
                    path,
                    radius: Radius::from_nm(self.settings.set_radius),
                })
            }
        }
    }
}

/// The rate that Tn commands: with turn mode T only (AP-3, TCS-7).
pub(super) fn turn_rate(htc: &Htc) -> Option<RateOfTurn> {
    (htc.turn_mode == Some(TurnMode::Rate)).then_some(())?;
    htc.rate_of_turn.map(RateOfTurn::from_deg_per_min)
}

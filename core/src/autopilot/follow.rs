//! Following the chart system: its commands, its leg and arc, and their supervision (TCS-4 to TCS-10).

use super::entry::{Wanted, turn_rate};
use super::modes::{Cause, Event};
use super::steering::{Path, PathTurn};
use super::{Autopilot, Mode};
use crate::alerts::{Alert, Standing, State};
use crate::geo::Point;
use crate::limits::Quantity;
use crate::nmea::{OverrideStatus, Reference, SteeringMode};
use crate::time::Stamp;
use crate::units::{Course, Heading, METRES_PER_NAUTICAL_MILE, Radius};
use alloc::format;
use alloc::string::{String, ToString};

/// A stop is the end of the route if the cross-track distances vanish within this time (TCS-10).
const STOP_CAUSE_MS: u64 = 1_500;
/// Centres this far apart belong to different turns, metres.
const SAME_TURN_M: f64 = 50.0;

impl Autopilot {
    /// An HTC was heard on a port that may command.
    pub(super) fn on_htc(&mut self, now: Stamp) {
        let Some(heard) = self.post.picture.htc.clone() else {
            return;
        };
        let htc = heard.value.htc;
        if heard.refused.is_some_and(|refused| refused >= heard.at) {
            self.commands.clear();
            if let (Some(text), true) = (heard.value.refusal, self.pending.is_some()) {
                self.why = format!("HTC refused: {text}");
            }
            return;
        }
        if htc.status.is_none() && !self.settings.accept_null_status {
            // FA13
            self.commands.clear();
            self.why = "HTC refused: its status is null, which is not accepted here".into();
            return;
        }
        if htc.override_status == Some(OverrideStatus::InUse) {
            self.commands.clear();
            if self.mode != Mode::Standby {
                self.alerts.raise(now, Alert::Override, "");
                self.pending = None;
                self.apply(
                    now,
                    &Event::Override,
                    "override reported by the chart system",
                );
            }
            return;
        }
        if htc.reference == Some(Reference::Magnetic) {
            self.commands.clear();
            self.why = "HTC refused: its reference is magnetic, the autopilot's is true".into();
            return;
        }
        match htc.steering_mode {
            Some(SteeringMode::HeadingControl | SteeringMode::TrackControl) => self.prove(now),
            Some(mode) => {
                self.commands.clear();
                if self.mode.is_autonav() {
                    self.stopped(now, mode);
                }
                return;
            }
            None => return,
        }
        self.follow(now);
    }

    /// TCS-6: Tn and Ti may be switched without leaving AutoNAV.
    fn follow(&mut self, now: Stamp) {
        let Some(wanted) = self.wanted(now) else {
            return;
        };
        let engaged = match &self.mode {
            Mode::AutonavTn { .. } => Wanted::Tn,
            Mode::AutonavTi { .. } => Wanted::Ti,
            _ => {
                if self.pending.is_none() && self.missing(now, wanted).is_none() {
                    self.why = "the chart system offers control: select AutoNAV".into();
                }
                return;
            }
        };
        if let Some(missing) = self.missing(now, wanted) {
            self.why = format!("HTC not followed: {missing}");
            return;
        }
        self.followed = now;
        if engaged != wanted {
            if let Some(event) = self.engagement(now, wanted) {
                self.apply(now, &event, "switched by the chart system");
            }
        } else if let (Mode::AutonavTn { hts, track, rate }, Some(htc)) = (
            &mut self.mode,
            self.post.picture.htc.as_ref().map(|heard| &heard.value.htc),
        ) {
            if let Some(commanded) = htc.heading_to_steer {
                *hts = Heading::from_deg(commanded);
            }
            *track = htc.track.map_or(hts.as_course(), Course::from_deg);
            *rate = turn_rate(htc);
        }
    }

    /// TCS-9, TCS-10: the chart system commands another mode.
    fn stopped(&mut self, now: Stamp, mode: SteeringMode) {
        if mode == SteeringMode::StandAlone {
            self.stop_cause_until = Some(now + STOP_CAUSE_MS);
            self.track_fail(now, Cause::StandAlone, "stopped by chart system");
            self.name_stop(now);
        } else {
            let text = format!("HTC commands {}", mode.meaning());
            self.track_fail(now, Cause::ModeRefused(text.clone()), &text);
        }
    }

    /// TCS-10: without distances the stop was the end of the route.
    fn name_stop(&mut self, now: Stamp) {
        let Some(until) = self.stop_cause_until else {
            return;
        };
        let xte = self.fresh(self.post.picture.xte.as_ref(), Quantity::Control);
        let pney1 = self.fresh(self.post.picture.pney1.as_ref(), Quantity::Control);
        let ended = xte.is_some_and(|xte| xte.cross_track.is_none())
            && pney1.is_some_and(|pney1| pney1.cross_track.is_none());
        if ended {
            self.why = "end of route".into();
            self.alerts.retext(Alert::TrackFail, "end of route");
        }
        if ended || now >= until {
            self.stop_cause_until = None;
        }
    }

    /// TCS-8: TRACK FAIL, the prompt, and heading control at once.
    pub(super) fn track_fail(&mut self, now: Stamp, cause: Cause, text: &str) {
        self.alerts.rectify(now, Alert::TrackDataLate);
        self.alerts.rectify(now, Alert::NoDifferential);
        self.alerts.raise(now, Alert::TrackFail, text);
        self.commands.clear();
        self.apply(now, &Event::TrackFail(cause), text);
    }

    /// What an alert says. TRACK FAIL tells what steers now, so it changes with the mode.
    #[must_use]
    pub fn text_of(&self, standing: &Standing) -> String {
        let steering = match &self.mode {
            Mode::Auto {
                finish: Some(_), ..
            } => "AUTO finishes the turn, SWITCH TO AUTO",
            Mode::Auto { .. } => "AUTO steers, SWITCH TO AUTO",
            Mode::RudderHold { .. } => "rudder held, steer by hand",
            Mode::Standby => "STANDBY, steer by hand",
            Mode::AutonavTi { .. } | Mode::AutonavTn { .. } => "",
        };
        let text = standing.text();
        let over = standing.state == State::RectifiedUnacknowledged;
        if standing.alert != Alert::TrackFail || over || steering.is_empty() {
            return text.to_string();
        }
        format!("{text}: {steering}")
    }

    /// Once a step: the pending selection, the ages of what is followed, the path.
    pub(super) fn supervise(&mut self, now: Stamp) {
        self.try_engage(now);
        self.name_stop(now);
        if !self.mode.is_autonav() {
            self.alerts.rectify(now, Alert::TrackDataLate);
            return;
        }
        if self.fail_if_old(now) {
            return;
        }
        let (name, age) = self.oldest(now);
        let late = age >= self.settings.track_caution;
        let text = if late {
            format!("{name} is late")
        } else {
            String::new()
        };
        self.alerts.set(now, Alert::TrackDataLate, late, &text);
        self.update_path();
    }

    /// TRACK FAIL where the chart system controls and something that is followed is too old; whether it did.
    pub(super) fn fail_if_old(&mut self, now: Stamp) -> bool {
        let (name, age) = self.oldest(now);
        let old = self.mode.is_autonav() && age >= self.settings.track_fail;
        if old {
            let text = format!("{name} missing");
            self.track_fail(now, Cause::Missing(name.to_string()), &text);
        }
        old
    }

    /// The oldest of what is followed, seconds. In Tn only HTC is supervised.
    fn oldest(&self, now: Stamp) -> (&'static str, f64) {
        let age = |at: Option<Stamp>| at.map_or(f64::MAX, |at| now.since(at) as f64 / 1000.0);
        let mut oldest = ("HTC", age(Some(self.followed)));
        if matches!(self.mode, Mode::AutonavTi { .. }) {
            let picture = &self.post.picture;
            let fix = picture.fixes.iter().map(|fix| fix.at).max();
            let heard = [
                ("XTE", picture.xte.as_ref().map(|heard| heard.at)),
                ("PNEY,001", picture.pney1.as_ref().map(|heard| heard.at)),
                ("PNEY,002", picture.pney2.as_ref().map(|heard| heard.at)),
                ("position", fix),
            ];
            for (name, at) in heard {
                if age(at) > oldest.1 {
                    oldest = (name, age(at));
                }
            }
        }
        oldest
    }

    /// Where the commanded leg passes: the chart system's position less its cross-track distance.
    pub(super) fn leg_point(&self, track: Course) -> Option<Point> {
        let plane = self.position_guard.plane()?;
        let heard = self.post.picture.pney1.as_ref()?;
        let distance = heard.value.cross_track? * METRES_PER_NAUTICAL_MILE;
        let own = self.position_guard.dead_reckoning(self.now);
        let charted = self
            .post
            .picture
            .fixes
            .iter()
            .find(|fix| {
                fix.source.port == heard.source.port
                    && fix.at.since(heard.at).max(heard.at.since(fix.at)) <= 1_100
            })
            .map(|fix| plane.point(fix.value.position));
        Some(charted.or(own)?.towards(track.deg() + 90.0, -distance))
    }

    /// TCS-4: the leg, or the commanded arc about the commanded centre (HTC-3: its track may move).
    fn update_path(&mut self) {
        let Some(htc) = self.commanded() else {
            return;
        };
        let Some(track) = htc.track.map(Course::from_deg) else {
            return;
        };
        let centre = self
            .fresh(self.post.picture.pney2.as_ref(), Quantity::Control)
            .and_then(|pney2| pney2.centre);
        let centre = self
            .position_guard
            .plane()
            .zip(centre)
            .map(|(plane, centre)| plane.point(centre));
        let leg = self.leg_point(track);
        let Mode::AutonavTi { path, radius } = &mut self.mode else {
            return;
        };
        match (htc.radius.map(Radius::from_nm), centre, leg) {
            (Some(commanded), Some(centre), _) => {
                let course_in = match path.turn {
                    Some(PathTurn {
                        centre: before,
                        course_out,
                        ..
                    }) if before.distance(centre) > SAME_TURN_M => course_out,
                    _ => path.course_in,
                };
                *path = Path::turn(course_in, centre, commanded, track);
                *radius = Some(commanded);
            }
            (None, _, Some(point)) => *path = Path::leg(point, track),
            // The radius is there, its centre not yet (or the reverse): the path stays as it was.
            _ => {}
        }
    }

    /// Lays the local plane anew where the ship is: at once outside track control, on very long legs in it.
    pub(super) fn recentre(&mut self) {
        let metres = match &self.mode {
            Mode::Auto {
                finish: Some(_), ..
            }
            | Mode::AutonavTi {
                path: Path { turn: Some(_), .. },
                ..
            } => return,
            Mode::AutonavTi { .. } => 60_000.0,
            _ => 10_000.0,
        };
        let Some(old) = self.position_guard.recentre(metres) else {
            return;
        };
        if let (Mode::AutonavTi { path, .. }, Some(new)) =
            (&mut self.mode, self.position_guard.plane())
        {
            path.point = new.point(old.position(path.point));
        }
        if let Some(measured) = self.measured(self.now) {
            self.steering.engage(self.order, &measured);
        }
    }
}

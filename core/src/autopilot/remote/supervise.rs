//! The ages of what the chart system says, TRACK FAIL, and what it calls itself (TCS-8 to TCS-10).

use super::super::modes::{Auto, Cause, Event, Lost, Need, OnLoss};
use super::super::{Autopilot, Mode};
use crate::alerts::{Alert, Standing, State};
use crate::facts::Quantity;
use crate::time::Stamp;
use alloc::format;
use alloc::string::{String, ToString};
use alloc::vec::Vec;

/// Sentences that fail within so long of each other failed together, seconds.
const TOGETHER_S: f64 = 1.2;
/// A sentence that came spoilt within this time comes still, milliseconds.
const SPOILT_MS: u64 = 2_500;
/// Off the track for so long before the alarm.
const OFF_TRACK_MS: u64 = 5_000;

/// What is followed, and how old it is.
struct Followed {
    name: &'static str,
    age: f64,
}

impl Autopilot {
    /// Once a step: the pending selection, the ages of what is followed, the path.
    pub(in super::super) fn supervise(&mut self, now: Stamp) {
        self.try_engage(now);
        self.name_stop(now);
        let quiet = self.settings.track_fail_ms();
        if self.remote.other.is_none_or(|at| now.since(at) > quiet) {
            self.alerts.machine.rectify(now, Alert::HtcConflict);
        }
        self.compare_positions();
        if !self.mode.is_autonav() {
            self.alerts.machine.rectify(now, Alert::TrackDataLate);
            self.alerts.machine.rectify(now, Alert::TrackDataRefused);
            self.alerts.machine.rectify(now, Alert::OffTrack);
            return;
        }
        let disagreement = self.agree(now).err();
        if self.fail_if_old(now) {
            return;
        }
        let refused = disagreement
            .or_else(|| self.refused_since(self.remote_heard()))
            .or_else(|| self.remote.makeshift.clone());
        self.alerts
            .machine
            .tell(now, Alert::TrackDataRefused, refused);
        let caution = self.settings.track_caution;
        let late = self.oldest(now).age >= caution;
        let late = late.then(|| self.spoilt(now, &self.names(now, caution), "late"));
        self.alerts.machine.tell(now, Alert::TrackDataLate, late);
        self.watch_track(now);
    }

    /// When the last command was accepted.
    fn remote_heard(&self) -> Stamp {
        self.remote.command.map_or(Stamp(0), |(_, at)| at)
    }

    /// TRACK FAIL where the chart system controls and something that is followed is too old; whether it did.
    pub(in super::super) fn fail_if_old(&mut self, now: Stamp) -> bool {
        let fails = self.mode.row().on_loss == OnLoss::TrackFail;
        if !fails || self.oldest(now).age < self.settings.track_fail {
            return false;
        }
        let silent = self.names(now, self.settings.track_fail - TOGETHER_S);
        let text = match self.refused_since(self.remote_heard()) {
            Some(refused) if silent.starts_with("HTC") || silent == "agreement" => refused,
            _ if silent == "agreement" => self.disagreement(now),
            _ => self.spoilt(now, &silent, "missing"),
        };
        self.track_fail(now, Cause::Missing, &text);
        true
    }

    /// The names of everything older than `seconds`, in an officer's words.
    fn names(&self, now: Stamp, seconds: f64) -> String {
        let followed = self.followed(now);
        let mut old: Vec<&str> = followed
            .iter()
            .filter(|item| item.age >= seconds && item.name != "agreement")
            .map(|item| item.name)
            .collect();
        old.sort_by_key(|name| *name == "position"); // sentences first
        let sentences = ["HTC", "XTE", "PNEY,001", "PNEY,002"];
        if old.is_empty() {
            "agreement".into()
        } else if sentences.iter().all(|name| old.contains(name)) {
            "chart system: HTC, XTE, PNEY".into()
        } else {
            old.join(", ")
        }
    }

    /// What is wrong with a sentence that is not followed: what spoils it where it comes, else that it does not come.
    fn spoilt(&self, now: Stamp, name: &str, state: &str) -> String {
        let spoilt = self.remote.spoilt.get(name);
        match spoilt.filter(|(_, at)| now.since(*at) <= SPOILT_MS) {
            Some((why, _)) => format!("{name} refused: {why}"),
            None => format!("{name} {state}"),
        }
    }

    fn oldest(&self, now: Stamp) -> Followed {
        let none = Followed {
            name: "HTC",
            age: 0.0,
        };
        self.followed(now).into_iter().fold(
            none,
            |oldest, item| if item.age > oldest.age { item } else { oldest },
        )
    }

    /// What the mode needs and is watched, with its age. In Tn only HTC is supervised.
    fn followed(&self, now: Stamp) -> Vec<Followed> {
        let needs = self.mode.row().needs.iter();
        needs
            .filter_map(|need| match need.lost() {
                Lost::Watched(name) => Some(Followed {
                    name,
                    age: (self.last(now, *need))
                        .map_or(f64::MAX, |at| now.since(at) as f64 / 1000.0),
                }),
                Lost::AtEntry | Lost::RudderHold | Lost::NotFollowed => None,
            })
            .collect()
    }

    /// When a watched need was last met.
    fn last(&self, now: Stamp, need: Need) -> Option<Stamp> {
        let picture = &self.post.picture;
        match need {
            Need::Command => Some(self.remote_heard().min(now)),
            Need::Agreement => Some(self.remote.agreed),
            Need::CrossTrack => picture.xte.as_ref().map(|heard| heard.at),
            Need::ControlDistance => picture.pney1.as_ref().map(|heard| heard.at),
            Need::Centre => picture.pney2.as_ref().map(|heard| heard.at),
            Need::Position => picture.fixes.iter().map(|fix| fix.at).max(),
            _ => Some(now),
        }
    }

    /// TCS-10: without distances the stop was the end of the route.
    pub(super) fn name_stop(&mut self, now: Stamp) {
        let Mode::Auto(Auto {
            stop_cause_until: Some(until),
            ..
        }) = self.mode
        else {
            return;
        };
        let xte = self.fresh(self.post.picture.xte.as_ref(), Quantity::Control);
        let pney1 = self.fresh(self.post.picture.pney1.as_ref(), Quantity::Control);
        let ended = xte.is_some_and(|xte| xte.cross_track.is_none())
            && pney1.is_some_and(|pney1| pney1.cross_track.is_none());
        if ended {
            self.why = "end of route".into();
            self.alerts.machine.retext(Alert::TrackFail, "end of route");
        }
        if let (Mode::Auto(auto), true) = (&mut self.mode, ended || now >= until) {
            auto.stop_cause_until = None;
        }
    }

    /// TCS-8: TRACK FAIL, the prompt, and heading control at once.
    pub(in super::super) fn track_fail(&mut self, now: Stamp, cause: Cause, text: &str) {
        for alert in [
            Alert::TrackDataLate,
            Alert::TrackDataRefused,
            Alert::NoDifferential,
            Alert::OffTrack,
        ] {
            self.alerts.machine.rectify(now, alert);
        }
        self.lay_the_lost_turn(now);
        self.alerts.machine.raise(now, Alert::TrackFail, text);
        self.remote.proofs.clear();
        self.apply(now, &Event::TrackFail(cause), text);
    }

    /// What an alert says. TRACK FAIL tells what steers now, so it changes with the mode.
    #[must_use]
    pub fn text_of(&self, standing: &Standing) -> String {
        let steering = match &self.mode {
            Mode::Auto(auto) if auto.finish.is_some() => "AUTO finishes the turn, SWITCH TO AUTO",
            Mode::Auto(_) => "AUTO steers, SWITCH TO AUTO",
            Mode::RudderHold(_) => "rudder held, steer by hand",
            Mode::Standby(_) => "STANDBY, steer by hand",
            Mode::AutonavTi(_) | Mode::AutonavTn(_) => "",
        };
        let text = standing.text();
        let over = standing.state == State::RectifiedUnacknowledged;
        if standing.alert != Alert::TrackFail || over || steering.is_empty() {
            return text.to_string();
        }
        format!("{text}: {steering}")
    }

    /// Farther off the track is an alarm, metres: by the corridor that HTC gives, else by the setting.
    #[must_use]
    pub fn off_track_limit(&self, now: Stamp) -> f64 {
        match self.remote.command(now, self.settings.track_fail_ms()) {
            Some(crate::command::Remote::Track {
                off_track_limit: Some(limit),
                ..
            }) => limit.m(),
            _ => self.settings.off_track_limit,
        }
    }

    /// MSC.74(69) A2 5.3.6: off the track by more than the corridor that HTC gives, or the setting.
    fn watch_track(&mut self, now: Stamp) {
        let limit = self.off_track_limit(now);
        let off = (self.gear.steered())
            .and_then(|steered| steered.cross_track)
            .map(|off| libm::fabs(off.m()));
        let Mode::AutonavTi(ti) = &mut self.mode else {
            self.alerts.machine.rectify(now, Alert::OffTrack);
            return;
        };
        let outside = off.is_some_and(|off| off > limit);
        ti.captured |= off.is_some_and(|off| off < 0.5 * limit);
        if !outside || !ti.captured {
            ti.off_track_since = None;
            self.alerts.machine.rectify(now, Alert::OffTrack);
            return;
        }
        let since = *ti.off_track_since.get_or_insert(now);
        if now.since(since) >= OFF_TRACK_MS {
            let text = format!(
                "{:.0} m off the track, the limit is {limit:.0} m: check track and speed",
                off.unwrap_or_default()
            );
            self.alerts.machine.raise(now, Alert::OffTrack, &text);
        }
    }
}

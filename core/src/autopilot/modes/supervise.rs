//! The ages of what the chart system says, TRACK FAIL, and what it calls itself (TCS-8 to TCS-10); what lost sensors end
//! (FA7, FA9).

use super::auto::Auto;
use super::event::{Cause, Event};
use super::mode::Mode;
use super::need::{Lost, Need};
use super::part::Modes;
use super::state::Told;
use super::table::OnLoss;
use crate::alerts::{Alert, Standing, State};
use crate::autopilot::facts::Outlook;
use crate::autopilot::notices::Notices;
use crate::autopilot::remote::Charted;
use crate::command::Remote;
use crate::settings::SpeedSource;
use crate::time::Stamp;
use alloc::format;
use alloc::string::{String, ToString};
use alloc::vec::Vec;

/// Sentences that fail within so long of each other failed together, seconds.
const TOGETHER_S: f64 = 1.2;

/// What is followed, and how old it is.
struct Followed {
    name: &'static str,
    age: f64,
}

impl Modes {
    /// There is no heading: one is heard that is not believed, or nothing is (FA7).
    pub(in super::super) fn heading_lost(
        &mut self,
        outlook: &Outlook<'_>,
        heard: bool,
        notices: &mut Notices,
    ) {
        // AP-21: by the rate of turn alone, as long as that is measured.
        let no_rate = self.steers_by_rate() && !outlook.sight.has_rate();
        if self.steers_by_heading() || no_rate {
            let why = if no_rate {
                "neither a heading nor a rate of turn: rudder held"
            } else if heard {
                "the heading jumped: rudder held"
            } else {
                "no heading for 2 s: rudder held"
            };
            notices.raise(Alert::HeadingLost, "");
            self.apply(&outlook.facts, &Event::HeadingLost, why);
        }
    }

    /// FA11: what turns the rudder fails.
    pub(in super::super) fn rudder_lost(&mut self, outlook: &Outlook<'_>, why: &str) {
        self.apply(&outlook.facts, &Event::RudderLost, why);
    }

    /// FA9: the position in use jumped.
    pub(in super::super) fn position_jumped(
        &mut self,
        outlook: &Outlook<'_>,
        notices: &mut Notices,
    ) {
        if self.mode.row().needs(Need::Position) {
            let text = "the position jumped";
            self.track_fail(outlook, Cause::PositionJump, text, notices);
        }
    }

    /// Once a step: the pending selection, the ages of what is followed, the path.
    pub(in super::super) fn supervise(&mut self, outlook: &Outlook<'_>, notices: &mut Notices) {
        self.watch_the_stand(outlook, notices);
        self.end_the_jog(outlook);
        self.watch_mode(outlook, notices);
        self.try_engage(outlook, notices);
        self.name_stop(outlook, notices);
        let (now, settings) = (outlook.facts.now, outlook.facts.settings);
        if !self.remote.htc.in_conflict(now, settings.track_fail_ms()) {
            notices.rectify(Alert::HtcConflict);
        }
        if !self.remote.hsc.in_conflict(now, settings.track_fail_ms()) {
            notices.rectify(Alert::HscConflict);
        }
        self.watch_waypoints(outlook, notices);
        let engaged = self.mode.state().path().is_some();
        self.positions.compare(outlook, engaged);
        if self.mode.row().on_loss != OnLoss::TrackFail {
            for over in [
                Alert::TrackDataLate,
                Alert::TrackDataRefused,
                Alert::OffTrack,
            ] {
                notices.rectify(over);
            }
            return;
        }
        let disagreement = self.agree(outlook).err();
        if self.fail_if_old(outlook, notices) {
            return;
        }
        let refused = disagreement
            .or_else(|| self.refused().map(String::from))
            .or_else(|| self.mode.state().makeshift().map(String::from));
        notices.tell(Alert::TrackDataRefused, refused);
        let caution = settings.track_caution;
        let late = self.oldest(outlook).age >= caution;
        let late = late.then(|| {
            let names = self.names(outlook, caution);
            self.remote.spoilt(now, &names, "late")
        });
        notices.tell(Alert::TrackDataLate, late);
        self.watch_track(outlook, notices);
    }

    /// What the mode needs besides a heading and the chart system is lost, or what it does is done: AUTO goes on.
    fn watch_mode(&mut self, outlook: &Outlook<'_>, notices: &mut Notices) {
        let speed = outlook.sight.measured_speed();
        self.speed.look(outlook.facts.now, speed);
        let by_rate = self.steers_by_rate() && outlook.sight.heading().is_none();
        notices.tell(Alert::NoHeading, by_rate.then(String::new));
        let measured = outlook.facts.settings.speed_source != SpeedSource::Manual;
        if self.speed_by_hand && measured && self.mode == Mode::STANDBY {
            self.speed_by_hand = false;
            notices.rectify(Alert::ChangeSpeedSource);
        }
        if let Some(ended) = self.mode.state_mut().watch(outlook) {
            if let Some(alert) = ended.alert {
                notices.raise(alert, ended.why.clone());
            }
            self.apply(&outlook.facts, &Event::AutoOn(ended.set), &ended.why);
        } else if self.has(outlook, Need::Wind, self.mode.name()) {
            notices.rectify(Alert::WindLost);
        }
    }

    /// The mode goes by what is commanded, or says what does not agree.
    fn agree(&mut self, outlook: &Outlook<'_>) -> Result<(), String> {
        let told = Told {
            command: self.command(outlook),
            charted: Charted::of(outlook, &self.positions),
            plotted: self.plotter.in_force(outlook),
        };
        self.mode.state_mut().agree(outlook, told)
    }

    /// Why the last command of whom the mode follows is not followed.
    fn refused(&self) -> Option<&str> {
        match self.mode {
            Mode::Track(_) => self.plotter.apb.refused(),
            _ if self.remote.by_hsc => self.remote.hsc.refused(),
            _ => self.remote.htc.refused(),
        }
    }

    /// TRACK FAIL where the chart system controls and something that is followed is too old; whether it did.
    pub(in super::super) fn fail_if_old(
        &mut self,
        outlook: &Outlook<'_>,
        notices: &mut Notices,
    ) -> bool {
        let fails = self.mode.row().on_loss == OnLoss::TrackFail;
        let track_fail = outlook.facts.settings.track_fail;
        if !fails || self.oldest(outlook).age < track_fail {
            return false;
        }
        let silent = self.names(outlook, track_fail - TOGETHER_S);
        let command = ["HTC", "HSC", "APB", "agreement"];
        let text = match self.refused().map(String::from) {
            Some(refused) if command.iter().any(|name| silent.starts_with(name)) => refused,
            _ if silent == "agreement" => {
                let disagreement = self.agree(outlook).err();
                disagreement.unwrap_or_else(|| "the chart system's sentences do not agree".into())
            }
            _ => (self.remote).spoilt(outlook.facts.now, &silent, "missing"),
        };
        self.track_fail(outlook, Cause::Missing, &text, notices);
        true
    }

    /// The names of everything older than `seconds`, in an officer's words.
    fn names(&self, outlook: &Outlook<'_>, seconds: f64) -> String {
        let followed = self.followed(outlook);
        let mut old: Vec<&str> = followed
            .filter(|item| item.age >= seconds && item.name != "agreement")
            .map(|item| match item.name {
                "HTC" if self.remote.by_hsc => "HSC",
                name => name,
            })
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

    fn oldest(&self, outlook: &Outlook<'_>) -> Followed {
        let none = Followed {
            name: "HTC",
            age: 0.0,
        };
        self.followed(outlook).fold(
            none,
            |oldest, item| if item.age > oldest.age { item } else { oldest },
        )
    }

    /// What the mode needs and is watched, with its age. In Tn only HTC is supervised.
    fn followed<'a>(&'a self, outlook: &'a Outlook<'a>) -> impl Iterator<Item = Followed> + 'a {
        let now = outlook.facts.now;
        let needs = self.mode.row().needs.iter();
        needs.filter_map(move |need| match need.lost() {
            Lost::Watched(name) => Some(Followed {
                name,
                age: (self.last(outlook, *need))
                    .map_or(f64::MAX, |at| now.since(at) as f64 / 1000.0),
            }),
            Lost::AtEntry | Lost::RudderHold | Lost::Auto | Lost::NotFollowed => None,
        })
    }

    /// When a watched need was last met.
    fn last(&self, outlook: &Outlook<'_>, need: Need) -> Option<Stamp> {
        let (now, picture) = (outlook.facts.now, outlook.seen.picture);
        match need {
            Need::Command => Some(self.commands(outlook).heard_at().min(now)),
            Need::Plotted => Some(self.plotter.apb.heard_at().min(now)),
            Need::Agreement => self.mode.state().agreed().or(Some(now)),
            Need::CrossTrack => picture.xte.as_ref().map(|heard| heard.at),
            Need::ControlDistance => picture.pney1.as_ref().map(|heard| heard.at),
            Need::Centre => picture.pney2.as_ref().map(|heard| heard.at),
            Need::Differential if !self.has(outlook, need, self.mode.name()) => {
                outlook.sight.last_corrected()
            }
            Need::Position => picture.fixes.iter().map(|fix| fix.at).max(),
            _ => Some(now),
        }
    }

    /// TCS-10: without distances the stop was the end of the route.
    pub(super) fn name_stop(&mut self, outlook: &Outlook<'_>, notices: &mut Notices) {
        let Mode::Auto(Auto {
            stop_cause_until: Some(until),
            ..
        }) = self.mode
        else {
            return;
        };
        let ended = self.charted(outlook).distances() == [Some(None); 2];
        if ended {
            self.why = "end of route".into();
            notices.retell(Alert::TrackFail, "end of route");
        }
        if let (Mode::Auto(auto), true) = (&mut self.mode, ended || outlook.facts.now >= until) {
            auto.stop_cause_until = None;
        }
    }

    /// TCS-8: TRACK FAIL, the prompt, and heading control at once.
    pub(super) fn track_fail(
        &mut self,
        outlook: &Outlook<'_>,
        cause: Cause,
        text: &str,
        notices: &mut Notices,
    ) {
        for over in [
            Alert::TrackDataLate,
            Alert::TrackDataRefused,
            Alert::NoDifferential,
            Alert::OffTrack,
        ] {
            notices.rectify(over);
        }
        let ms = outlook.facts.settings.track_fail_ms() + 1_000;
        let command = self.remote.command(outlook.facts.now, ms);
        self.mode.state_mut().losing(outlook, command);
        notices.raise(Alert::TrackFail, text);
        self.remote.htc.disprove();
        self.remote.hsc.disprove();
        self.plotter.apb.disprove();
        self.apply(&outlook.facts, &Event::TrackFail(cause), text);
    }

    /// What an alert says. TRACK FAIL tells what steers now, so it changes with the mode.
    pub(in super::super) fn text_of(&self, standing: &Standing) -> String {
        let steering = self.mode.state().steers(self.mode.row());
        let text = standing.text();
        let over = standing.state == State::RectifiedUnacknowledged;
        if standing.alert != Alert::TrackFail || over || steering.is_empty() {
            return text.to_string();
        }
        format!("{text}: {steering}")
    }

    /// Farther off the track is an alarm, metres: by the corridor that HTC gives, else by the setting.
    pub(in super::super) fn off_track_limit(&self, outlook: &Outlook<'_>) -> f64 {
        match self.command(outlook).filter(|_| self.mode.is_autonav()) {
            Some(Remote::Track {
                off_track_limit: Some(limit),
                ..
            }) => limit.m(),
            _ => outlook.facts.settings.off_track_limit,
        }
    }

    /// MSC.74(69) A2 5.3.6: off the track by more than the corridor that HTC gives, or the setting.
    fn watch_track(&mut self, outlook: &Outlook<'_>, notices: &mut Notices) {
        let limit = self.off_track_limit(outlook);
        let off = (self.mode.state())
            .cross_track(&outlook.facts)
            .map(|off| libm::fabs(off.m()));
        let left = (self.mode)
            .state_mut()
            .has_left_the_track(outlook.facts.now, off, limit);
        let text = || {
            format!(
                "{:.0} m off the track, the limit is {limit:.0} m: check track and speed",
                off.unwrap_or_default()
            )
        };
        notices.tell(Alert::OffTrack, left.then(text));
    }
}

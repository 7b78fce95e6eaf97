//! The chart system's commands: whose are obeyed, what is accepted, and for how long (HTC-1 to HTC-4, TCS-6 to TCS-10).
//!
//! An HTC is obeyed in three steps. `command::htc` makes it a command or refuses it; `accept` holds it against the
//! ship's constants and the authority of its source; `agree` holds it against everything else that is heard. What is
//! refused moves nothing, is said, and is TRACK FAIL when it lasts (TCS-8).

mod agree;
mod place;
mod supervise;

use super::modes::{AutonavTn, Cause, Event};
use super::selection::{mode_of, why_of};
use super::{Autopilot, Mode};
use crate::alerts::Alert;
use crate::command::{self, Refusal};
use crate::geo::Point;
use crate::nmea::{Sentence, SteeringMode};
use crate::picture::Source;
use crate::station::PortIndex;
use crate::time::Stamp;
use crate::units::{Course, Heading, Radius, RateOfTurn};
use alloc::collections::{BTreeMap, VecDeque};
use alloc::format;
use alloc::string::{String, ToString};
use serde::{Deserialize, Serialize};

/// Largest radius that is believed, nautical miles.
const LARGEST_RADIUS_NM: f64 = 10.0;
/// Heading and track of a command differ by the crab angle and the approach, degrees.
const HEADING_OFF_TRACK_DEG: f64 = 60.0;
/// In a turn of Tn the heading to steer is the track, degrees.
const SAME_DEG: f64 = 2.0;
/// A heading to steer that changes by more at once, without a turn, counts when it is said twice, degrees.
const HEADING_STEP_DEG: f64 = 15.0;

/// What is known of the chart system that commands.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub(super) struct Remote {
    /// Whose commands are obeyed, and when it last commanded (FB13).
    authority: Option<(Source, Stamp)>,
    /// When another source last commanded.
    other: Option<Stamp>,
    /// The last command that was accepted.
    command: Option<(command::Remote, Stamp)>,
    /// The last refusal.
    refusal: Option<(String, Stamp)>,
    /// What spoils a sentence that is followed, by its formatter, and when it last came so (FA4).
    spoilt: BTreeMap<String, (String, Stamp)>,
    /// Times of the accepted commands in a row (FA14).
    pub(super) proofs: VecDeque<Stamp>,
    /// When all that is heard last agreed with what is steered.
    pub(super) agreed: Stamp,
    /// Accepted commands without a radius in a row.
    straight: u8,
    /// Where the ship was when the radius of the turn to come was first commanded, and when.
    wheel_over: Option<(Point, Stamp)>,
    /// Course and place of the leg as it was accepted.
    leg: Option<(Course, Point)>,
    /// The turn as it was commanded first (HTC-3).
    turn: TurnPlan,
    /// A heading to steer that waits to be said again.
    stepped: Option<Heading>,
    /// Own position less the chart system's, slowly averaged, metres (TCS-4).
    pub(super) offset: Option<Point>,
    /// How far apart the two positions were last, metres.
    apart: f64,
    /// How far their difference was off the averaged one last, metres.
    jumped: f64,
    /// What is laid though something of it was not said; absent where all was (SEN-4).
    makeshift: Option<String>,
    /// The chart system's position that was last compared.
    compared: Option<Stamp>,
}

/// What is known of a turn whose track is altered while it is made (HTC-3).
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
struct TurnPlan {
    /// The track has been altered since the turn was commanded.
    altered: bool,
    /// The first track was the leg's own: how far the turn goes is not known.
    open: bool,
}

impl Remote {
    /// Control ended or begins: nothing of a turn or a leg is remembered.
    pub(super) fn begin(&mut self, now: Stamp, leg: Option<(Course, Point)>) {
        self.agreed = now;
        self.straight = 0;
        self.wheel_over = None;
        self.turn = TurnPlan::default();
        self.stepped = None;
        self.makeshift = None;
        self.leg = leg;
    }

    /// The command in force, unless it is older than `ms`.
    pub(super) fn command(&self, now: Stamp, ms: u64) -> Option<command::Remote> {
        let (command, at) = self.command?;
        (now.since(at) <= ms).then_some(command)
    }
}

impl Autopilot {
    /// XTE, PNEY,001 or PNEY,002 was heard: what spoils it, if anything does, is kept for the officer (FA4, FA5).
    pub(super) fn on_distance(&mut self, now: Stamp, sentence: &Sentence<'_>, checked: bool) {
        let name = sentence.formatter;
        let picture = &self.post.picture;
        let taken = match name {
            "XTE" => picture.xte.as_ref().map(|xte| xte.at),
            "PNEY,001" => picture.pney1.as_ref().map(|pney1| pney1.at),
            "PNEY,002" => picture.pney2.as_ref().map(|pney2| pney2.at),
            _ => return,
        };
        let why = if !checked {
            "checksum missing or wrong".into()
        } else if let Some(fault) = sentence.faults().first() {
            let field = fault.field.map(|field| format!("field {field}: "));
            format!("{}{}", field.unwrap_or_default(), fault.text())
        } else if taken != Some(now) {
            "its status or mode says not valid".into()
        } else {
            self.remote.spoilt.remove(name);
            return;
        };
        self.remote.spoilt.insert(name.into(), (why, now));
    }

    /// An HTC that the port's policy does not accept breaks the row (FA14, SEN-2).
    pub(super) fn on_broken_htc(&mut self, now: Stamp) {
        self.remote.proofs.clear();
        self.remote.refusal = Some(("HTC refused: checksum missing or wrong".into(), now));
    }

    /// An HTC was heard on a port that may command.
    pub(super) fn on_htc(&mut self, now: Stamp, port: PortIndex, sentence: &Sentence<'_>) {
        let source = Source {
            port,
            talker: sentence.talker().into(),
            formatter: "HTC".into(),
        };
        if self.has_another_authority(now, &source) {
            return;
        }
        let command = command::htc(sentence, self.settings.accept_null_status)
            .and_then(|command| self.accept(command));
        let command = match command {
            Ok(command) => command,
            Err(refusal) => {
                self.remote.proofs.clear();
                let text = format!("HTC refused: {refusal}");
                if self.mode.selected_until().is_some() || self.mode.is_autonav() {
                    self.why.clone_from(&text);
                }
                self.remote.refusal = Some((text, now));
                return;
            }
        };
        self.remote.authority = Some((source, now));
        self.remote.command = Some((command, now));
        match command {
            command::Remote::Override => self.override_reported(now),
            command::Remote::Stop(mode) => {
                self.remote.proofs.clear();
                self.alerts.machine.rectify(now, Alert::Override);
                if self.mode.is_autonav() {
                    self.stopped(now, mode);
                }
            }
            command::Remote::Heading { .. } | command::Remote::Track { .. } => {
                self.alerts.machine.rectify(now, Alert::Override);
                self.prove(now);
                self.follow(now, command);
            }
        }
    }

    /// FB13: the first that commands keeps the authority while it is fresh; the other is shown and never obeyed.
    fn has_another_authority(&mut self, now: Stamp, source: &Source) -> bool {
        let fresh = self.settings.track_fail_ms();
        let Some((authority, _)) = (self.remote.authority.as_ref())
            .filter(|(authority, at)| authority != source && now.since(*at) <= fresh)
        else {
            return false;
        };
        let picture = &self.post.picture;
        let text = format!(
            "HTC SOURCE CONFLICT: {} is obeyed, {} commands too and is not",
            picture.source_name(authority),
            picture.source_name(source)
        );
        self.alerts.machine.raise(now, Alert::HtcConflict, &text);
        self.remote.other = Some(now);
        true
    }

    /// What a ship like this can do, and what does not contradict itself.
    fn accept(&mut self, command: command::Remote) -> Result<command::Remote, Refusal> {
        let refuse = |field: u8, text: String| {
            Err(Refusal {
                field: Some(field),
                text,
            })
        };
        let speed = self.sight.speed(&self.settings);
        match command {
            command::Remote::Track {
                radius: Some(radius),
                ..
            } => {
                let least = self.steering.settings().smallest_radius();
                if radius < least || radius.nm() > LARGEST_RADIUS_NM {
                    return refuse(
                        8,
                        format!(
                            "radius {:.3} nm, this ship can hold {:.2} to {LARGEST_RADIUS_NM:.0} nm",
                            radius.nm(),
                            least.nm()
                        ),
                    );
                }
            }
            command::Remote::Heading { hts, track, rate } => {
                let most = self.steering.settings().fastest_rate(speed).deg_per_min();
                let asked = rate.map_or(0.0, |rate| libm::fabs(rate.deg_per_min()));
                if asked > most || rate.is_some() && asked == 0.0 {
                    return refuse(
                        9,
                        format!("rate of turn {asked:.0}°/min, this ship can hold up to {most:.0}"),
                    );
                }
                let off = (hts.as_course() - track).abs().deg();
                let limit = if rate.is_some() {
                    SAME_DEG
                } else {
                    HEADING_OFF_TRACK_DEG
                };
                if off > limit {
                    return refuse(
                        10,
                        format!(
                            "heading to steer {:.1} contradicts track {:.1}",
                            hts.deg(),
                            track.deg()
                        ),
                    );
                }
                return self.accept_step(hts, rate).map(|()| command);
            }
            _ => {}
        }
        Ok(command)
    }

    /// A single heading to steer that jumps is a glitch; said twice it is meant.
    fn accept_step(&mut self, hts: Heading, rate: Option<RateOfTurn>) -> Result<(), Refusal> {
        let Mode::AutonavTn(tn) = &self.mode else {
            return Ok(());
        };
        let step = (hts - tn.hts).abs().deg();
        let said_before = self
            .remote
            .stepped
            .is_some_and(|stepped| (hts - stepped).abs().deg() <= SAME_DEG);
        if rate.is_none() && step > HEADING_STEP_DEG && !said_before {
            self.remote.stepped = Some(hts);
            return Err(Refusal {
                field: Some(10),
                text: format!("heading to steer jumps by {step:.0}° without a turn"),
            });
        }
        self.remote.stepped = None;
        Ok(())
    }

    /// HTC-1: STANDBY within one tick, and no way back but the operator's.
    fn override_reported(&mut self, now: Stamp) {
        self.remote.proofs.clear();
        if self.mode == Mode::STANDBY {
            return;
        }
        self.alerts.machine.raise(now, Alert::Override, "");
        self.apply(
            now,
            &Event::Override,
            "override reported by the chart system",
        );
    }

    /// TCS-6: Tn and Ti may be switched without leaving AutoNAV.
    fn follow(&mut self, now: Stamp, command: command::Remote) {
        let Some(wanted) = mode_of(command) else {
            return;
        };
        if !self.mode.is_autonav() {
            let selected = self.mode.selected_until().is_some();
            if !selected && self.missing(now, wanted).is_none() {
                self.why = "the chart system offers control: select AutoNAV".into();
            }
            return;
        }
        if let Some(missing) = self.missing(now, wanted) {
            self.remote.refusal = Some((format!("HTC not followed: {missing}"), now));
            self.why = format!("HTC not followed: {missing}");
            return;
        }
        if self.mode.name() != wanted {
            if let Some(event) = self.engagement(now, wanted) {
                self.engage(now, &event, "switched by the chart system");
            }
            return;
        }
        if self.why.starts_with("HTC ") {
            self.why = why_of(wanted).into(); // what was refused is obeyed again
        }
        match (&mut self.mode, command) {
            (Mode::AutonavTn(tn), command::Remote::Heading { hts, track, rate }) => {
                *tn = AutonavTn { hts, track, rate };
                self.remote.agreed = now;
            }
            (Mode::AutonavTi(_), command::Remote::Track { radius, .. }) => {
                self.remote.straight = match radius {
                    Some(_) => 0,
                    None => self.remote.straight.saturating_add(1),
                };
            }
            _ => {}
        }
    }

    /// Enters Tn or Ti; what is heard agrees as of now.
    pub(super) fn engage(&mut self, now: Stamp, event: &Event, why: &str) {
        let leg = match event {
            Event::EngageTi { path, .. } => Some((path.course_in, path.point)),
            _ => None,
        };
        self.remote.begin(now, leg);
        self.apply(now, event, why);
    }

    /// TCS-9, TCS-10: the chart system commands another mode.
    fn stopped(&mut self, now: Stamp, mode: SteeringMode) {
        if mode == SteeringMode::StandAlone {
            self.track_fail(now, Cause::StandAlone, "stopped by chart system");
            self.name_stop(now);
        } else {
            let text = format!("HTC commands {}", mode.meaning());
            self.track_fail(now, Cause::ModeRefused, &text);
        }
    }

    /// The radius of a turn that is commanded.
    pub(super) fn commanded_radius(&self, now: Stamp) -> Option<Radius> {
        match self.remote.command(now, self.settings.track_fail_ms())? {
            command::Remote::Track { radius, .. } => radius,
            _ => None,
        }
    }

    /// What refused or missing means for an officer: the last refusal, where it is younger than what was followed.
    pub(super) fn refused_since(&self, followed: Stamp) -> Option<String> {
        let (text, at) = self.remote.refusal.as_ref()?;
        (*at > followed).then(|| text.to_string())
    }
}

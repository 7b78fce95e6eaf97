//! The chart system's commands: whose are obeyed, what was said of them last, and what a ship can do (HTC-1 to HTC-4, SEN-5).

use super::super::steering::SteeringSettings;
use crate::command::{self, Refusal};
use crate::nmea::Sentence;
use crate::picture::Source;
use crate::post::Seen;
use crate::time::Stamp;
use crate::units::Speed;
use alloc::collections::{BTreeMap, VecDeque};
use alloc::format;
use alloc::string::String;
use serde::{Deserialize, Serialize};

/// So many valid HTC in a row, within so long, before the first is obeyed (FA14).
const PROOFS: usize = 3;
const PROOF_WINDOW_MS: u64 = 5_000;
/// A sentence that came spoilt within this time comes still, milliseconds.
const SPOILT_MS: u64 = 2_500;
/// Largest radius that is believed, nautical miles.
const LARGEST_RADIUS_NM: f64 = 10.0;
/// Heading and track of a command differ by the crab angle and the approach, degrees.
const HEADING_OFF_TRACK_DEG: f64 = 60.0;
/// In a turn of Tn the heading to steer is the track, degrees.
const SAME_DEG: f64 = 2.0;

/// What is known of the chart system that commands.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub(in super::super) struct Remote {
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
    proofs: VecDeque<Stamp>,
}

impl Remote {
    /// The command in force, unless it is older than `ms`.
    pub(in super::super) fn command(&self, now: Stamp, ms: u64) -> Option<command::Remote> {
        let (command, at) = self.command?;
        (now.since(at) <= ms).then_some(command)
    }

    /// When the last command was accepted.
    pub(in super::super) fn heard_at(&self) -> Stamp {
        self.command.map_or(Stamp(0), |(_, at)| at)
    }

    /// Takes an accepted command.
    pub(in super::super) fn take(&mut self, now: Stamp, source: Source, command: command::Remote) {
        self.authority = Some((source, now));
        self.command = Some((command, now));
    }

    /// FB13: the first that commands keeps the authority while it is fresh, for `ms`; that one, where it is another.
    pub(in super::super) fn other_authority(
        &mut self,
        now: Stamp,
        source: &Source,
        ms: u64,
    ) -> Option<&Source> {
        let (authority, at) = self.authority.as_ref()?;
        if authority == source || now.since(*at) > ms {
            return None;
        }
        self.other = Some(now);
        Some(authority)
    }

    /// Whether another source has commanded within `ms`.
    pub(in super::super) fn in_conflict(&self, now: Stamp, ms: u64) -> bool {
        self.other.is_some_and(|at| now.since(at) <= ms)
    }

    /// Notes a valid command for the proof of life.
    pub(in super::super) fn prove(&mut self, now: Stamp) {
        self.proofs.push_back(now);
        while self.proofs.len() > PROOFS {
            self.proofs.pop_front();
        }
    }

    /// The row of valid commands is broken.
    pub(in super::super) fn disprove(&mut self) {
        self.proofs.clear();
    }

    /// FA14: there were enough valid commands in a row.
    pub(in super::super) fn is_proven(&self, now: Stamp) -> bool {
        let first = self.proofs.front();
        self.proofs.len() >= PROOFS && first.is_some_and(|at| now.since(*at) <= PROOF_WINDOW_MS)
    }

    /// Notes why a command is not followed.
    pub(in super::super) fn refuse(&mut self, now: Stamp, text: String) {
        self.refusal = Some((text, now));
    }

    /// The last refusal, where it is younger than the last command that was accepted.
    pub(in super::super) fn refused(&self) -> Option<&str> {
        let (text, at) = self.refusal.as_ref()?;
        (*at > self.heard_at()).then_some(text.as_str())
    }

    /// XTE, PNEY,001 or PNEY,002 was heard: what spoils it, if anything does, is kept for the officer (FA4, FA5).
    pub(in super::super) fn on_distance(
        &mut self,
        seen: Seen<'_>,
        sentence: &Sentence<'_>,
        checked: bool,
    ) {
        let name = sentence.formatter;
        let picture = seen.picture;
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
        } else if taken != Some(seen.now) {
            "its status or mode says not valid".into()
        } else {
            self.spoilt.remove(name);
            return;
        };
        self.spoilt.insert(name.into(), (why, seen.now));
    }

    /// What is wrong with a sentence that is not followed: what spoils it where it comes, else that it does not come.
    pub(in super::super) fn spoilt(&self, now: Stamp, name: &str, state: &str) -> String {
        let spoilt = self.spoilt.get(name);
        match spoilt.filter(|(_, at)| now.since(*at) <= SPOILT_MS) {
            Some((why, _)) => format!("{name} refused: {why}"),
            None => format!("{name} {state}"),
        }
    }
}

/// What a ship like this can do, and what does not contradict itself.
pub(in super::super) fn can_do(
    command: command::Remote,
    ship: &SteeringSettings,
    speed: Speed,
) -> Result<(), Refusal> {
    let refuse = |field: u8, text: String| {
        Err(Refusal {
            field: Some(field),
            text,
        })
    };
    match command {
        command::Remote::Track {
            radius: Some(radius),
            ..
        } => {
            let least = ship.smallest_radius();
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
            let most = ship.fastest_rate(speed).deg_per_min();
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
        }
        _ => {}
    }
    Ok(())
}

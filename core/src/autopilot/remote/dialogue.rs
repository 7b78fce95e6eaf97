//! The chart system's commands: what was said of them last, and what a ship can do (HTC-1 to HTC-4, SEN-5).

use super::super::steering::SteeringSettings;
use super::authority::Authority;
use crate::command::{self, Refusal};
use crate::nmea::Sentence;
use crate::post::Seen;
use crate::time::Stamp;
use crate::units::Speed;
use alloc::collections::BTreeMap;
use alloc::format;
use alloc::string::String;
use serde::{Deserialize, Serialize};

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
    /// Whose HTC are obeyed, and the last of them.
    pub(in super::super) htc: Authority<command::Remote>,
    /// Whose HSC are obeyed, and the last of them (AP-13).
    pub(in super::super) hsc: Authority<command::Remote>,
    /// Tn was engaged by HSC: no HTC has come since.
    pub(in super::super) by_hsc: bool,
    /// What spoils a sentence that is followed, by its formatter, and when it last came so (FA4).
    spoilt: BTreeMap<String, (String, Stamp)>,
}

impl Remote {
    /// The command in force, unless it is older than `ms`.
    pub(in super::super) fn command(&self, now: Stamp, ms: u64) -> Option<command::Remote> {
        self.htc.command(now, ms).copied()
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

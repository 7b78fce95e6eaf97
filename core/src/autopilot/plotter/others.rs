//! What else a plotter says of the leg, held against its APB: XTE, RMB, BWC, BWR and BOD (AP-14).

use super::super::facts::Outlook;
use super::leg::{Leg, north};
use crate::command::Said;
use crate::nmea::{self, DataStatus, ModeIndicator, Sentence};
use crate::station::PortIndex;
use crate::time::Stamp;
use crate::units::{Course, Distance, wrap_180};
use alloc::format;
use alloc::string::String;
use alloc::vec::Vec;
use serde::{Deserialize, Serialize};

/// What is older is held against nothing, milliseconds.
const FRESH_MS: u64 = 3_000;
/// Courses of a leg within so many degrees are the same.
const COURSE_DEG: f64 = 5.0;
/// A great circle and a rhumb line, and the way made between two sentences, make bearings differ by so much, degrees.
const BEARING_DEG: f64 = 12.0;
/// Nearer to the waypoint than this its bearing swings too fast, nautical miles.
const NEAR_NM: f64 = 0.25;

/// The last of each sentence of each port.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub(super) struct Others(Vec<Other>);

/// What another sentence says of the leg.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
struct Other {
    port: PortIndex,
    formatter: String,
    at: Stamp,
    /// By its status or mode indicator it is valid.
    valid: bool,
    cross_track: Option<Distance>,
    waypoint: Option<String>,
    /// Course of the leg, true and magnetic.
    course: [Option<f64>; 2],
    /// Bearing of the waypoint, true and magnetic.
    bearing: [Option<f64>; 2],
    distance: Option<Distance>,
}

impl Others {
    /// Takes a sentence; one with a fault says nothing.
    pub(super) fn take(&mut self, now: Stamp, port: PortIndex, sentence: &Sentence<'_>) {
        if !sentence.is_clean() {
            return;
        }
        if let Some(other) = read(now, port, sentence) {
            (self.0).retain(|old| old.port != port || old.formatter != other.formatter);
            self.0.push(other);
        }
    }

    /// What of that port does not agree with the leg, in an officer's words.
    pub(super) fn contradiction(
        &self,
        outlook: &Outlook<'_>,
        port: PortIndex,
        leg: &Leg,
    ) -> Option<String> {
        let now = outlook.facts.now;
        let of_port = self.0.iter().filter(|other| other.port == port);
        let mut fresh = of_port.filter(|other| now.since(other.at) <= FRESH_MS);
        fresh.find_map(|other| {
            // What was said before the leg began belongs to the leg before it.
            let same = other.waypoint.as_ref() == Some(&leg.waypoint);
            if other.at < leg.begun && !same {
                return None;
            }
            let contradicts = other.contradicts(outlook, leg)?;
            Some(format!("{} {contradicts}", other.formatter))
        })
    }
}

impl Other {
    fn contradicts(&self, outlook: &Outlook<'_>, leg: &Leg) -> Option<String> {
        if !self.valid {
            return Some("says not valid, APB valid".into());
        }
        if let Some(waypoint) = &self.waypoint
            && !leg.waypoint.is_empty()
            && *waypoint != leg.waypoint
        {
            return Some(format!("goes to {waypoint}, APB to {}", leg.waypoint));
        }
        if let Some(cross_track) = self.cross_track {
            let apart = libm::fabs(cross_track.m() - leg.cross_track.m());
            if apart > outlook.facts.settings.leg_tolerance + leg.resolution.m() {
                let side = |distance: Distance| match distance.m() < 0.0 {
                    true => "left",
                    false => "right",
                };
                return Some(format!(
                    "has the ship {:.0} m {} of the track, APB {:.0} m {}",
                    libm::fabs(cross_track.m()),
                    side(cross_track),
                    libm::fabs(leg.cross_track.m()),
                    side(leg.cross_track)
                ));
            }
        }
        if let Some(course) = of_north(self.course, outlook) {
            let off = libm::fabs(wrap_180(course - leg.course.deg()));
            if off > COURSE_DEG {
                return Some(format!(
                    "has the leg on {course:05.1}, APB on {:05.1}",
                    leg.course.deg()
                ));
            }
        }
        self.bears_elsewhere(outlook, leg)
    }

    /// The waypoint bears as APB says, and as course and cross-track distance make it.
    fn bears_elsewhere(&self, outlook: &Outlook<'_>, leg: &Leg) -> Option<String> {
        let bearing = of_north(self.bearing, outlook)?;
        let distance = self.distance.filter(|distance| distance.nm() >= NEAR_NM)?;
        if leg.arrived {
            return None;
        }
        let across = (leg.cross_track.m() / distance.m()).clamp(-1.0, 1.0);
        let by_leg = leg.course.deg() - libm::asin(across).to_degrees();
        let off = |from: f64| libm::fabs(wrap_180(bearing - from)) > BEARING_DEG;
        if let Some(said) = leg.bearing.map(Course::deg).filter(|said| off(*said)) {
            return Some(format!(
                "bears {bearing:05.1} to the waypoint, APB {said:05.1}"
            ));
        }
        off(by_leg).then(|| {
            format!(
                "bears {bearing:05.1} to the waypoint, leg and cross-track distance make it {:05.1}",
                crate::units::wrap_360(by_leg)
            )
        })
    }
}

/// A direction of the north of the compass in use, of what is said true and magnetic.
fn of_north([of_true, of_magnetic]: [Option<f64>; 2], outlook: &Outlook<'_>) -> Option<f64> {
    let said = |magnetic: bool, degrees: Option<f64>| {
        let degrees = degrees?;
        north(Said { degrees, magnetic }, outlook)
    };
    said(false, of_true).or_else(|| said(true, of_magnetic))
}

fn read(at: Stamp, port: PortIndex, sentence: &Sentence<'_>) -> Option<Other> {
    let nothing = Other {
        port,
        formatter: sentence.formatter.into(),
        at,
        valid: true,
        cross_track: None,
        waypoint: None,
        course: [None; 2],
        bearing: [None; 2],
        distance: None,
    };
    let allows = |mode: Option<ModeIndicator>| mode.is_none_or(ModeIndicator::valid);
    let valid = |status: Option<DataStatus>| status == Some(DataStatus::Valid);
    if let Some(xte) = nmea::Xte::from_sentence(sentence) {
        return Some(Other {
            valid: valid(xte.status)
                && xte.cycle_lock != Some(DataStatus::Invalid)
                && allows(xte.mode),
            cross_track: xte.cross_track.map(Distance::from_nm),
            ..nothing
        });
    }
    if let Some(rmb) = nmea::Rmb::from_sentence(sentence) {
        return Some(Other {
            valid: valid(rmb.status) && allows(rmb.mode),
            cross_track: rmb.cross_track.map(Distance::from_nm),
            waypoint: rmb.destination,
            bearing: [rmb.bearing, None],
            distance: rmb.range.map(Distance::from_nm),
            ..nothing
        });
    }
    if let Some(bod) = nmea::Bod::from_sentence(sentence) {
        return Some(Other {
            waypoint: bod.destination,
            course: [bod.bearing_true, bod.bearing_magnetic],
            ..nothing
        });
    }
    let bears = |bearing, distance: Option<f64>, waypoint, mode| Other {
        valid: allows(mode),
        waypoint,
        bearing,
        distance: distance.map(Distance::from_nm),
        ..nothing
    };
    if let Some(bwc) = nmea::Bwc::from_sentence(sentence) {
        let bearing = [bwc.bearing_true, bwc.bearing_magnetic];
        return Some(bears(bearing, bwc.distance, bwc.waypoint, bwc.mode));
    }
    let bwr = nmea::Bwr::from_sentence(sentence)?;
    let bearing = [bwr.bearing_true, bwr.bearing_magnetic];
    Some(bears(bearing, bwr.distance, bwr.waypoint, bwr.mode))
}

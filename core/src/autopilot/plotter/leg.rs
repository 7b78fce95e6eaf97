//! A leg that a plotter says, of the north of the compass in use, and whether it contradicts itself (AP-14).

use super::super::facts::Outlook;
use crate::command::{self, Refusal, Said};
use crate::time::Stamp;
use crate::units::{Course, Distance, Heading, SignedAngle};
use alloc::format;
use alloc::string::String;
use serde::{Deserialize, Serialize};

/// The heading to steer differs from the leg's course by the crab angle and the approach, degrees.
const HEADING_OFF_LEG_DEG: f64 = 60.0;
/// A heading to steer leads away from the leg by a crab angle at most, degrees.
const CRAB_DEG: f64 = 30.0;
/// A waypoint that is not reached lies ahead of the leg, degrees.
const AHEAD_DEG: f64 = 100.0;

/// A leg, and where the ship is on it.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub(in super::super) struct Leg {
    /// It is of magnetic north, as the headings are.
    pub(in super::super) magnetic: bool,
    /// Destination; empty where none is said.
    pub(in super::super) waypoint: String,
    /// When it was first said to be the destination.
    pub(in super::super) begun: Stamp,
    /// Course of the leg.
    pub(in super::super) course: Course,
    /// Cross-track distance, ship right of the track positive.
    pub(in super::super) cross_track: Distance,
    /// How far apart two distances are that it can tell from each other.
    pub(super) resolution: Distance,
    /// Bearing of the destination.
    pub(super) bearing: Option<Course>,
    /// Heading to steer; absent where it follows from course and cross-track distance.
    pub(in super::super) heading_to_steer: Option<Heading>,
    /// The waypoint is reached.
    pub(in super::super) arrived: bool,
}

impl Leg {
    /// What an APB says, of the north of the compass in use.
    pub(super) fn of(said: command::Leg, outlook: &Outlook<'_>) -> Result<Self, Refusal> {
        let of = |field: u8, said: Said| {
            north(said, outlook).ok_or_else(|| Refusal {
                field: Some(field),
                text: match said.magnetic {
                    true => "magnetic, and no variation is known".into(),
                    false => "true, the compass is magnetic, and no variation is known".into(),
                },
            })
        };
        let maybe = |field: u8, said: Option<Said>| said.map(|said| of(field, said)).transpose();
        Ok(Self {
            magnetic: outlook.sight.is_magnetic(),
            course: Course::from_deg(of(9, said.course)?),
            bearing: maybe(12, said.bearing)?.map(Course::from_deg),
            heading_to_steer: maybe(14, said.heading_to_steer)?.map(Heading::from_deg),
            waypoint: said.waypoint,
            begun: outlook.facts.now,
            cross_track: said.cross_track,
            resolution: said.resolution,
            arrived: said.arrived,
        })
    }

    /// Whether it goes to another waypoint; one that is not named is the same.
    pub(super) fn is_of_another_waypoint(&self, before: &Self) -> bool {
        !self.waypoint.is_empty() && self.waypoint != before.waypoint
    }

    /// Heading to steer and bearing are those of this leg.
    pub(super) fn agrees_in_itself(&self, outlook: &Outlook<'_>) -> Result<(), Refusal> {
        let refuse = |field: u8, text: String| {
            Err(Refusal {
                field: Some(field),
                text,
            })
        };
        if let Some(bearing) = self.bearing.filter(|_| !self.arrived)
            && (bearing - self.course).abs().deg() > AHEAD_DEG
        {
            return refuse(
                11,
                format!(
                    "the waypoint bears {:05.1}, astern of the leg {:05.1}, and is not reached",
                    bearing.deg(),
                    self.course.deg()
                ),
            );
        }
        let Some(hts) = self.heading_to_steer else {
            return Ok(());
        };
        let off = hts.as_course() - self.course;
        let away = off.deg() * libm::copysign(1.0, self.cross_track.m());
        let beside = libm::fabs(self.cross_track.m()) > outlook.facts.settings.leg_tolerance;
        if off.abs().deg() > HEADING_OFF_LEG_DEG || beside && away > CRAB_DEG {
            return refuse(
                13,
                format!(
                    "heading to steer {:05.1} contradicts the leg {:05.1}, {:.0} m to {}",
                    hts.deg(),
                    self.course.deg(),
                    libm::fabs(self.cross_track.m()),
                    if self.cross_track.m() > 0.0 {
                        "port"
                    } else {
                        "starboard"
                    },
                ),
            );
        }
        Ok(())
    }
}

/// A direction of the north of the compass in use, degrees; absent where it takes a variation that is not known.
pub(in super::super) fn north(said: Said, outlook: &Outlook<'_>) -> Option<f64> {
    let variation = || {
        let settings = outlook.facts.settings;
        outlook.sight.variation(outlook.seen, settings)
    };
    let by = match (said.magnetic, outlook.sight.is_magnetic()) {
        (true, false) => variation()?,
        (false, true) => -variation()?,
        (true, true) | (false, false) => 0.0,
    };
    Some((Heading::from_deg(said.degrees) + SignedAngle::from_deg(by)).deg())
}

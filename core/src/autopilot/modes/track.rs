//! TRACK: a plotter's route is followed by its APB (AP-14, EMC-3).

use super::auto::turns_by;
use super::former::Former;
use super::need::Need;
use super::off_track::OffTrack;
use super::state::{Listed, State, Told};
use super::table::{Limit, ModeName, OnLoss, Row};
use crate::autopilot::facts::{Facts, Outlook};
use crate::autopilot::plotter::Leg;
use crate::autopilot::steering::{Demand, Intercept};
use crate::nmea::{Htd, SteeringMode};
use crate::settings::Role;
use crate::time::Stamp;
use crate::units::{Course, Distance, Heading};
use alloc::string::String;
use alloc::vec::Vec;
use serde::{Deserialize, Serialize};

/// What is followed.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Track {
    /// Heading to steer: the plotter's, else by the leg's course and the cross-track distance.
    pub hts: Heading,
    /// Course of the leg.
    pub course: Course,
    /// Cross-track distance as it was said last, ship right of the track positive.
    pub cross_track: Distance,
    /// When the leg began.
    begun: Stamp,
    intercept: Intercept,
    off_track: OffTrack,
}

impl Track {
    /// Begins on a leg, with this heading to steer.
    pub(super) fn on(leg: &Leg, hts: Heading) -> Self {
        Self {
            hts: leg.heading_to_steer.unwrap_or(hts),
            course: leg.course,
            cross_track: leg.cross_track,
            begun: leg.begun,
            intercept: Intercept::default(),
            off_track: OffTrack::new(),
        }
    }
}

impl Listed for Track {
    const ROW: Row = Row {
        name: ModeName::Track,
        title: "TRACK",
        what: "A plotter's route is followed: the heading to steer of APB, else the leg's course corrected by the cross-track distance.",
        role: Role::Operator,
        entry: &[
            Need::AutoFirst,
            Need::Heading,
            Need::NoOverride,
            Need::Plotted,
        ],
        needs: &[Need::Heading, Need::Plotted],
        on_loss: OnLoss::TrackFail,
        limit: Limit::Set,
        htd: Some(SteeringMode::TrackControl),
        commanded: None,
        steers: "",
    };

    fn examples() -> Vec<(&'static str, Self)> {
        let north = Course::from_deg(0.0);
        let track = Self {
            hts: north.as_heading(),
            course: north,
            cross_track: Distance::from_m(0.0),
            begun: Stamp(0),
            intercept: Intercept::default(),
            off_track: OffTrack::new(),
        };
        alloc::vec![("TRACK", track)]
    }
}

impl State for Track {
    fn demand(&mut self, facts: &Facts<'_>) -> Option<Demand> {
        Some(Demand::Heading {
            set: self.hts,
            by: turns_by(facts.settings),
        })
    }

    fn hts(&self, _: &Facts<'_>) -> Option<Heading> {
        Some(self.hts)
    }

    fn former(&self) -> Option<Former> {
        Some(Former::Track)
    }

    fn htd(&self, _: &Facts<'_>, htd: &mut Htd) {
        htd.heading_to_steer = Some(self.hts.deg());
        htd.track = Some(self.course.deg());
    }

    fn agree(&mut self, outlook: &Outlook<'_>, told: Told<'_>) -> Result<(), String> {
        let Some(leg) = told.plotted else {
            return Ok(()); // its age is watched
        };
        if leg.begun != self.begun {
            // Another leg: neither its drift nor its track are those of the one before.
            *self = Self::on(leg, self.hts);
        }
        (self.course, self.cross_track) = (leg.course, leg.cross_track);
        let by_distance = self.intercept.step(
            leg.course,
            leg.cross_track,
            (outlook.ship, outlook.speed()),
            outlook.facts.settings.step_ms() as f64 / 1000.0,
        );
        self.hts = leg.heading_to_steer.unwrap_or(by_distance);
        Ok(())
    }

    fn cross_track(&self, _: &Facts<'_>) -> Option<Distance> {
        Some(self.cross_track)
    }

    fn has_left_the_track(&mut self, now: Stamp, off: Option<f64>, limit: f64) -> bool {
        self.off_track.watch(now, off, limit)
    }
}

//! AutoNAV Ti: the track comes from the chart system, and is steered here (AP-2, AP-7, TCS-4, TCS-8).

use super::auto::{Auto, Finish};
use super::need::{ENTRY, Need};
use super::state::{Facts, State};
use super::table::{Limit, ModeName, OnLoss, Row};
use crate::autopilot::steering::{Demand, TurnBy};
use crate::nmea::{Htd, SteeringMode, TurnMode};
use crate::path::{Part, Path};
use crate::time::Stamp;
use crate::units::{Course, Heading, Radius};
use serde::{Deserialize, Serialize};

/// What is followed.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct AutonavTi {
    /// The leg, or the turn with both its legs.
    pub path: Path,
    /// The radius that HTD acknowledges: the last accepted one (AP-2).
    pub radius: Option<Radius>,
    /// The commanded track, as accepted.
    pub track: Course,
    /// The ship has been within half the off-track limit since track control began.
    pub captured: bool,
    /// Since when she is off the track.
    pub off_track_since: Option<Stamp>,
}

impl AutonavTi {
    /// Begins on a leg.
    #[must_use]
    pub const fn on(path: Path, radius: Option<Radius>) -> Self {
        Self {
            path,
            radius,
            track: path.course_in,
            captured: false,
            off_track_since: None,
        }
    }

    /// TCS-8: a turn is finished on its radius, from where it begins; else `held` is held.
    pub(super) fn lost(&self, held: Heading, facts: &Facts) -> Auto {
        let Some(turn) = self.path.turn else {
            return Auto::on(held);
        };
        let before_arc = facts.is_on(&self.path, Part::LegIn);
        Auto::finishing(
            self.track.as_heading(),
            Finish {
                by: TurnBy::Radius(turn.radius),
                wait: before_arc.then_some(self.path),
            },
        )
    }
}

impl State for AutonavTi {
    const ROW: Row = Row {
        name: ModeName::AutonavTi,
        title: "AutoNAV Ti",
        what: "Track control: leg and arc of HTC mode T, XTE and PNEY are sailed along, corrected for current and offset.",
        entry: ENTRY,
        needs: &[
            Need::Heading,
            Need::MeasuredSpeed,
            Need::Command,
            Need::ShipConstants,
            Need::Position,
            Need::CrossTrack,
            Need::ControlDistance,
            Need::Leg,
            Need::Centre,
            Need::OnePosition,
            Need::Agreement,
        ],
        on_loss: OnLoss::TrackFail,
        limit: Limit::Max,
        htd: SteeringMode::TrackControl,
    };

    fn demand(&mut self, _: &Facts) -> Option<Demand> {
        Some(Demand::Track(self.path))
    }

    fn hts(&self, facts: &Facts) -> Option<Heading> {
        Some(match &facts.steered {
            Some(steered) => steered.hts,
            None => self.path.course_in.as_heading(),
        })
    }

    fn htd(&self, facts: &Facts, htd: &mut Htd) {
        if self.path.turn.is_some() {
            htd.turn_mode = Some(TurnMode::Radius);
            let steered = facts.steered.as_ref();
            htd.rate_of_turn = steered.map(|steered| steered.rate_reference.abs().deg_per_min());
        }
        htd.radius = self.radius.map(Radius::nm);
        htd.heading_to_steer = self.hts(facts).map(Heading::deg);
        htd.track = Some(self.track.deg());
    }
}

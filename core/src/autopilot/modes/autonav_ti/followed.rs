//! What AutoNAV Ti follows, and what is left of it where it is lost (TCS-8).

use super::super::auto::{Auto, Finish};
use super::super::off_track::OffTrack;
use crate::autopilot::facts::Facts;
use crate::autopilot::steering::TurnBy;
use crate::geo::Point;
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
    /// Whether the ship has left the track.
    pub(super) off_track: OffTrack,
    /// When all that is heard last agreed with what is steered.
    pub(super) agreed: Stamp,
    /// Accepted commands without a radius in a row.
    pub(super) straight: u8,
    /// Where the ship was when the radius of the turn to come was first commanded, and when.
    pub(super) wheel_over: Option<(Point, Stamp)>,
    /// Course and place of the leg as it was accepted.
    pub(super) leg: (Course, Point),
    /// The turn as it was commanded first (HTC-3).
    pub(super) turn: TurnPlan,
    /// The turn is laid though its centre was not said (SEN-4).
    pub(super) without_centre: bool,
}

/// What is known of a turn whose track is altered while it is made (HTC-3).
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
pub(super) struct TurnPlan {
    /// The track has been altered since the turn was commanded.
    pub(super) altered: bool,
    /// The first track was the leg's own: how far the turn goes is not known.
    pub(super) open: bool,
}

impl AutonavTi {
    /// Begins on a leg.
    #[must_use]
    pub const fn on(now: Stamp, path: Path, radius: Option<Radius>) -> Self {
        Self {
            path,
            radius,
            track: path.course_in,
            off_track: OffTrack::new(),
            agreed: now,
            straight: 0,
            wheel_over: None,
            leg: (path.course_in, path.point),
            turn: TurnPlan {
                altered: false,
                open: false,
            },
            without_centre: false,
        }
    }

    /// TCS-8: a turn is finished on its radius, from where it begins; else `held` is held.
    pub(in super::super) fn lost(&self, held: Heading, facts: &Facts<'_>) -> Auto {
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

//! What happened as the sensors were looked at, for the autopilot to take in its order.

use crate::autopilot::notices::Notice;
use crate::geo::Point;
use crate::units::SignedAngle;

/// What happened as the sensors were looked at.
#[derive(Clone, Debug, PartialEq)]
pub(in super::super) enum Sighted {
    /// What is said of an alert.
    Notice(Notice),
    /// Another compass is in use; its heading differs by so much, and the ship has not turned (AP-9).
    OtherCompass(SignedAngle),
    /// There is a heading again; it differs by so much from the one that the rate of turn carried on (AP-21).
    HeadingBack(SignedAngle),
    /// There is a heading.
    Heading,
    /// There is none (FA7); one was heard that is not believed, or nothing.
    NoHeading { heard: bool },
    /// Another receiver is in use, and the plane has moved with it, metres (AP-9).
    PlaneMoved(Point),
    /// Whether the position is without differential correction (AP-7).
    Uncorrected(bool),
    /// The position in use jumped (FA9).
    PositionJumped,
}

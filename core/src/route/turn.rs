//! A turn at a waypoint: arc from A to B about C, tangent to both legs; wheel-over line F before A. Its geometry is [`Path`]'s.

use super::Leg;
use crate::geo::{Plane, Point, Position, rhumb};
use crate::path::{Path, tangent};
use crate::units::{Course, Distance, Radius, SignedAngle};

/// An arc that is tangent to two legs.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Turn {
    /// Legs and arc in the plane at the centre.
    path: Path,
    plane: Plane,
    radius: Radius,
    tangent: Distance,
    forwarding: Distance,
    start: Position,
    end: Position,
}

impl Turn {
    /// The arc of `radius` between two legs that meet, in the plane at their waypoint (good to 0.5 m for a
    /// radius of a mile at 60 degrees of latitude).
    #[must_use]
    pub(super) fn between(
        leg_in: &Leg,
        leg_out: &Leg,
        radius: Radius,
        forwarding: Distance,
    ) -> Self {
        let (course_in, course_out) = (leg_in.course(), leg_out.course());
        let corner = Point::default();
        let laid = Path::corner(corner, course_in, radius, course_out);
        let centre = laid.turn.map_or(corner, |arc| arc.centre);
        let waypoint = Plane::at(leg_in.to());
        Self {
            path: Path::turn(course_in, Point::default(), radius, course_out),
            plane: Plane::at(waypoint.position(centre)),
            radius,
            tangent: tangent(laid.angle(), radius),
            forwarding,
            start: waypoint.position(laid.point),
            end: waypoint.position(laid.leg_out().point),
        }
    }

    /// Change of course, starboard positive.
    #[must_use]
    pub fn angle(&self) -> SignedAngle {
        self.path.angle()
    }
    /// Its radius.
    #[must_use]
    pub const fn radius(&self) -> Radius {
        self.radius
    }
    /// Distance from the waypoint to the beginning and to the end of the arc.
    #[must_use]
    pub const fn tangent(&self) -> Distance {
        self.tangent
    }
    /// The planned forwarding distance F, from the wheel-over line to the beginning of the arc.
    #[must_use]
    pub const fn forwarding(&self) -> Distance {
        self.forwarding
    }
    /// Distance from the waypoint back to the line that lies so far before the beginning of the arc.
    #[must_use]
    pub fn before(&self, forwarding: Distance) -> Distance {
        Distance::from_m(self.tangent.m() + forwarding.m())
    }
    /// Where the arc begins (A).
    #[must_use]
    pub const fn start(&self) -> Position {
        self.start
    }
    /// Where the arc ends (B).
    #[must_use]
    pub const fn end(&self) -> Position {
        self.end
    }
    /// Its centre (C).
    #[must_use]
    pub const fn centre(&self) -> Position {
        self.plane.origin
    }
    /// Course of the next leg.
    #[must_use]
    pub fn course_out(&self) -> Course {
        self.path.leg_out().course_in
    }
    /// Where the wheel-over line crosses the leg, for a forwarding distance.
    #[must_use]
    pub fn wheel_over(&self, forwarding: Distance) -> Position {
        let back = Course::from_deg(self.path.course_in.deg() + 180.0);
        rhumb::destination(self.start, back, forwarding)
    }
    /// Cross-track distance of a position to the arc, right of the track positive.
    #[must_use]
    pub fn cross_track(&self, position: Position) -> Distance {
        Distance::from_m(self.path.beside_arc(self.plane.point(position)))
    }
    /// Distance run on the arc abeam of a position, from its beginning; negative before it.
    #[must_use]
    pub fn along(&self, position: Position) -> Distance {
        Distance::from_m(self.path.progress(self.plane.point(position)).along)
    }
    /// Length of the arc.
    #[must_use]
    pub fn length(&self) -> Distance {
        Distance::from_m(self.path.arc_length())
    }
    /// The position on the arc so far from its beginning.
    #[must_use]
    pub fn at(&self, along: Distance) -> Position {
        self.plane.position(self.path.at(along.m(), 0.0))
    }
}

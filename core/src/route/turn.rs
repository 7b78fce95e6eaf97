//! A turn at a waypoint: `T = R tan(|D|/2)`, arc from A to B about C, wheel-over line F before A.

use super::Leg;
use crate::geo::{Plane, Point, Position, rhumb};
use crate::units::{Course, Distance, Radius, SignedAngle};

/// An arc that is tangent to two legs.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Turn {
    angle: SignedAngle,
    radius: Radius,
    tangent: Distance,
    forwarding: Distance,
    start: Position,
    end: Position,
    centre: Position,
    course_in: Course,
    course_out: Course,
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
        let angle = leg_out.course() - leg_in.course();
        let tangent = tangent(angle, radius);
        let plane = Plane::at(leg_in.to());
        let corner = Point::default();
        let start = corner.towards(leg_in.course().deg() + 180.0, tangent.m());
        let end = corner.towards(leg_out.course().deg(), tangent.m());
        let centre = start.towards(leg_in.course().deg() + side(angle) * 90.0, radius.m());
        Self {
            angle,
            radius,
            tangent,
            forwarding,
            start: plane.position(start),
            end: plane.position(end),
            centre: plane.position(centre),
            course_in: leg_in.course(),
            course_out: leg_out.course(),
        }
    }

    /// Change of course, starboard positive.
    #[must_use]
    pub const fn angle(&self) -> SignedAngle {
        self.angle
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
        self.centre
    }
    /// Course of the next leg.
    #[must_use]
    pub const fn course_out(&self) -> Course {
        self.course_out
    }
    /// Where the wheel-over line crosses the leg, for a forwarding distance.
    #[must_use]
    pub fn wheel_over(&self, forwarding: Distance) -> Position {
        let back = Course::from_deg(self.course_in.deg() + 180.0);
        rhumb::destination(self.start, back, forwarding)
    }
    /// Cross-track distance of a position to the arc, right of the track positive: `s (R - rho)`.
    #[must_use]
    pub fn cross_track(&self, position: Position) -> Distance {
        let rho = Plane::at(self.centre)
            .point(position)
            .distance(Point::default());
        Distance::from_m(side(self.angle) * (self.radius.m() - rho))
    }
    /// Distance run on the arc abeam of a position, from its beginning; negative before it.
    #[must_use]
    pub fn along(&self, position: Position) -> Distance {
        let centre = Plane::at(self.centre);
        let bearing = Point::default().bearing(centre.point(position));
        let first = self.course_in.deg() - side(self.angle) * 90.0;
        let swept = SignedAngle::from_deg(side(self.angle) * (bearing - first));
        Distance::from_m(swept.rad() * self.radius.m())
    }
    /// Length of the arc.
    #[must_use]
    pub fn length(&self) -> Distance {
        Distance::from_m(self.angle.abs().rad() * self.radius.m())
    }
    /// The position on the arc so far from its beginning.
    #[must_use]
    pub fn at(&self, along: Distance) -> Position {
        let swept = along.m() / self.radius.m() * 180.0 / core::f64::consts::PI;
        let bearing = self.course_in.deg() + side(self.angle) * (swept - 90.0);
        Plane::at(self.centre).position(Point::default().towards(bearing, self.radius.m()))
    }
}

/// `T = R tan(|D|/2)`.
pub(super) fn tangent(angle: SignedAngle, radius: Radius) -> Distance {
    Distance::from_m(radius.m() * libm::tan(angle.abs().rad() / 2.0))
}

/// +1 for a turn to starboard, -1 to port.
fn side(angle: SignedAngle) -> f64 {
    if angle.deg() < 0.0 { -1.0 } else { 1.0 }
}

//! A leg: the rhumb line between two waypoints, with its corridor.

use super::Waypoint;
use crate::geo::{Position, rhumb};
use crate::units::{Course, Distance};

/// A rhumb line between two waypoints.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Leg {
    from: Position,
    to: Position,
    course: Course,
    length: Distance,
    limit_port: Distance,
    limit_starboard: Distance,
}

impl Leg {
    pub(super) fn new(from: &Waypoint, to: &Waypoint) -> Self {
        let (course, length) = rhumb::between(from.position, to.position);
        Self {
            from: from.position,
            to: to.position,
            course,
            length,
            limit_port: to.limit_port,
            limit_starboard: to.limit_starboard,
        }
    }

    /// Half its corridor, the smaller side.
    #[must_use]
    pub fn corridor(&self) -> Distance {
        if self.limit_port < self.limit_starboard {
            self.limit_port
        } else {
            self.limit_starboard
        }
    }

    /// Where it begins.
    #[must_use]
    pub const fn from(&self) -> Position {
        self.from
    }
    /// Where it ends.
    #[must_use]
    pub const fn to(&self) -> Position {
        self.to
    }
    /// Its course, the same everywhere on it.
    #[must_use]
    pub const fn course(&self) -> Course {
        self.course
    }
    /// Its length between the waypoints.
    #[must_use]
    pub const fn length(&self) -> Distance {
        self.length
    }
    /// Cross-track distance of a position, right of the track positive.
    #[must_use]
    pub fn cross_track(&self, position: Position) -> Distance {
        rhumb::offset(self.from, self.course, position).1
    }
    /// Distance run along it to a position, from its beginning; negative before it.
    #[must_use]
    pub fn along(&self, position: Position) -> Distance {
        rhumb::offset(self.from, self.course, position).0
    }
    /// Distance along it from a position to its end; negative past the end.
    #[must_use]
    pub fn remaining(&self, position: Position) -> Distance {
        Distance::from_m(self.length.m() - self.along(position).m())
    }
    /// The position on it so far from its beginning.
    #[must_use]
    pub fn at(&self, along: Distance) -> Position {
        rhumb::destination(self.from, self.course, along)
    }
    /// Whether a cross-track distance is outside the corridor.
    #[must_use]
    pub fn outside(&self, cross_track: Distance) -> bool {
        cross_track > self.limit_starboard || -cross_track > self.limit_port
    }
}

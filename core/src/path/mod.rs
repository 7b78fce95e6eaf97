//! The one geometry of a way that is sailed: a leg, or two legs joined by an arc, in a local plane.
//!
//! Routes, autopilot, checker, page and bench lay and measure their paths here. In: courses, a centre, a radius. Out: where a point lies along
//! the path and beside it, the point that lies there, and in `smooth` the way that a ship can sail.

mod smooth;

use crate::geo::Point;
use crate::units::{Course, Distance, Radius, SignedAngle, wrap_180};
use alloc::vec::Vec;
use core::f64::consts::PI;
use serde::{Deserialize, Serialize};

/// A leg, with the turn that ends it where there is one.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Path {
    /// Course of the incoming leg.
    pub course_in: Course,
    /// Any point on the incoming leg.
    pub point: Point,
    /// The turn that follows.
    pub turn: Option<Arc>,
}

/// An arc to which both legs are tangent.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Arc {
    /// Centre of the arc.
    pub centre: Point,
    /// Its radius.
    pub radius: Radius,
    /// Course of the leg that follows.
    pub course_out: Course,
}

/// Part of a path.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Part {
    /// The incoming leg.
    LegIn,
    /// The arc.
    Arc,
    /// The outgoing leg.
    LegOut,
}

/// Where a ship is along a path.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Progress {
    /// On which part.
    pub part: Part,
    /// Metres from the start of the arc (on a leg alone: from its point), negative before it.
    pub along: f64,
    /// Metres from the path, ship right of it positive.
    pub cross_track: f64,
}

impl Arc {
    /// How far `p` lies inside the circle of the arc, metres; negative outside.
    #[must_use]
    pub fn inside(&self, p: Point) -> f64 {
        self.radius.m() - self.centre.distance(p)
    }
}

impl Path {
    /// A leg through `point`.
    #[must_use]
    pub fn leg(point: Point, course: Course) -> Self {
        Self {
            course_in: course,
            point,
            turn: None,
        }
    }

    /// A leg on `course_in`, an arc about `centre`, a leg on `course_out`. The turn takes the short way.
    #[must_use]
    pub fn turn(course_in: Course, centre: Point, radius: Radius, course_out: Course) -> Self {
        let arc = Arc {
            centre,
            radius,
            course_out,
        };
        let side = side(course_out - course_in);
        Self {
            course_in,
            point: centre.towards(course_in.deg() - 90.0 * side, radius.m()),
            turn: Some(arc),
        }
    }

    /// Two legs that meet at `corner`, and the arc of `radius` that is tangent to both; `point` is where the arc begins.
    #[must_use]
    pub fn corner(corner: Point, course_in: Course, radius: Radius, course_out: Course) -> Self {
        let angle = course_out - course_in;
        let start = corner.towards(course_in.deg() + 180.0, tangent(angle, radius).m());
        let arc = Arc {
            centre: start.towards(course_in.deg() + side(angle) * 90.0, radius.m()),
            radius,
            course_out,
        };
        Self {
            course_in,
            point: start,
            turn: Some(arc),
        }
    }

    /// The leg that follows the turn, through the end of the arc; the leg itself where there is no turn.
    #[must_use]
    pub fn leg_out(&self) -> Self {
        let Some(turn) = self.turn else { return *self };
        let end = turn
            .centre
            .towards(turn.course_out.deg() - 90.0 * self.side(), turn.radius.m());
        Self::leg(end, turn.course_out)
    }

    /// Metres along the path from `p` to the end of the arc; none where that lies behind, or without one.
    #[must_use]
    pub fn left(&self, p: Point) -> Option<f64> {
        let progress = self.progress(p);
        let left = self.arc_length() - progress.along;
        (self.turn.is_some() && progress.part != Part::LegOut && left > 0.0).then_some(left)
    }

    /// Where the arc begins; for a leg alone the point that it was laid through.
    #[must_use]
    pub fn start(&self) -> Point {
        self.at(0.0, 0.0)
    }

    /// The point so many metres along the path as [`Progress`] counts them, and so many to starboard of it.
    #[must_use]
    pub fn at(&self, along: f64, starboard: f64) -> Point {
        let beside = |point: Point, course: Course, along: f64| {
            point
                .towards(course.deg(), along)
                .towards(course.deg() + 90.0, starboard)
        };
        let Some(turn) = self.turn.filter(|_| along >= 0.0) else {
            return beside(self.point, self.course_in, along);
        };
        let length = self.arc_length();
        if along > length {
            let out = self.leg_out();
            return beside(out.point, out.course_in, along - length);
        }
        let (side, radius) = (self.side(), turn.radius.m().max(1.0));
        let bearing = self.course_in.deg() + side * ((along / radius).to_degrees() - 90.0);
        let distance = (radius - side * starboard).max(0.0);
        turn.centre.towards(bearing, distance)
    }

    /// The arc as a line of points, `from` metres to starboard of it at its begin, `to` metres at its end.
    #[must_use]
    pub fn drawn(&self, from: f64, to: f64) -> Vec<Point> {
        let length = self.arc_length();
        let turned = self
            .turn
            .map_or(0.0, |turn| length / turn.radius.m().max(1.0));
        let steps = (turned.to_degrees() / 3.0) as u32 + 2;
        (0..=steps)
            .map(|step| {
                let part = f64::from(step) / f64::from(steps);
                self.at(length * part, from + (to - from) * part)
            })
            .collect()
    }

    /// Cross-track distance from the part of the path where `p` is.
    #[must_use]
    pub fn cross_track(&self, p: Point) -> Distance {
        Distance::from_m(self.progress(p).cross_track)
    }

    /// 1 where the turn goes to starboard, -1 to port, 0 for a leg alone.
    #[must_use]
    pub fn side(&self) -> f64 {
        self.turn
            .map_or(0.0, |turn| side(turn.course_out - self.course_in))
    }

    /// Change of course, starboard positive; none for a leg alone.
    #[must_use]
    pub fn angle(&self) -> SignedAngle {
        self.leg_out().course_in - self.course_in
    }

    /// Cross-track distance of `p` to the circle of the arc, metres, right of the track positive: `s (R - rho)`; to the leg
    /// where there is no turn.
    #[must_use]
    pub fn beside_arc(&self, p: Point) -> f64 {
        match self.turn {
            Some(turn) => self.side() * turn.inside(p),
            None => self.progress(p).cross_track,
        }
    }

    /// Length of the arc, metres; 0 for a leg alone.
    #[must_use]
    pub fn arc_length(&self) -> f64 {
        self.turn.map_or(0.0, |t| {
            libm::fabs((t.course_out - self.course_in).rad()) * t.radius.m()
        })
    }

    /// Where `p` is along the path: on the part that is nearest.
    #[must_use]
    pub fn progress(&self, p: Point) -> Progress {
        let (along_in, across_in) = p.off_line(self.point, self.course_in);
        let leg_in = Progress {
            part: Part::LegIn,
            along: along_in,
            cross_track: across_in,
        };
        let Some(turn) = self.turn else { return leg_in };
        let side = self.side();
        let radius = turn.radius.m().max(1.0);
        let start = turn
            .centre
            .towards(self.course_in.deg() - 90.0 * side, radius);
        let end = turn
            .centre
            .towards(turn.course_out.deg() - 90.0 * side, radius);
        let length = self.arc_length();
        let (before, across_in) = p.off_line(start, self.course_in);
        let (after, across_out) = p.off_line(end, turn.course_out);
        let bearing = turn.centre.bearing(p);
        let turned = side * wrap_180(bearing - turn.centre.bearing(start)) * PI / 180.0;
        let turned = if turned < -PI / 2.0 {
            turned + 2.0 * PI
        } else {
            turned
        };
        let arc = Progress {
            part: Part::Arc,
            along: within(turned * radius, length),
            cross_track: side * turn.inside(p),
        };
        let mut best = arc;
        let on_arc = turned >= 0.0 && turned * radius <= length;
        let mut nearest = if on_arc {
            libm::fabs(arc.cross_track)
        } else {
            f64::MAX
        };
        if before < 0.0 && libm::fabs(across_in) < nearest {
            best = Progress {
                part: Part::LegIn,
                along: before,
                cross_track: across_in,
            };
            nearest = libm::fabs(across_in);
        }
        if after > 0.0 && libm::fabs(across_out) < nearest {
            best = Progress {
                part: Part::LegOut,
                along: length + after,
                cross_track: across_out,
            };
        }
        best
    }
}

/// At least 0 and at most `most`. The language's own `clamp` carries the printing of numbers into a page, 6 kB of it.
fn within(value: f64, most: f64) -> f64 {
    if value < 0.0 {
        0.0
    } else if value > most {
        most
    } else {
        value
    }
}

/// Distance from the corner of two legs to the beginning and to the end of the arc: `T = R tan(|D|/2)`.
#[must_use]
pub fn tangent(angle: SignedAngle, radius: Radius) -> Distance {
    Distance::from_m(radius.m() * libm::tan(angle.abs().rad() / 2.0))
}

/// 1 for a turn to starboard, -1 to port.
fn side(angle: SignedAngle) -> f64 {
    if angle.deg() < 0.0 { -1.0 } else { 1.0 }
}

#[cfg(test)]
pub(crate) mod tests;

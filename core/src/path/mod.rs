//! The one geometry of a way that is sailed: a leg, or two legs joined by an arc, in a local plane.
//!
//! Autopilot, page and bench lay and measure their paths here. In: courses, a centre, a radius. Out: where a point lies along
//! the path and beside it, the point that lies there, and in `smooth` the way that a ship can sail.

mod smooth;

use crate::geo::Point;
use crate::units::{Course, Distance, Radius, wrap_180};
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
        let side = if (course_out - course_in).deg() < 0.0 {
            -1.0
        } else {
            1.0
        };
        let point = centre.towards(course_in.deg() - 90.0 * side, radius.m());
        Self {
            course_in,
            point,
            turn: Some(Arc {
                centre,
                radius,
                course_out,
            }),
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
        match self.turn {
            Some(turn) if (turn.course_out - self.course_in).deg() < 0.0 => -1.0,
            Some(_) => 1.0,
            None => 0.0,
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
        let (along_in, across_in) = from_line(self.point, self.course_in, p);
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
        let (before, across_in) = from_line(start, self.course_in, p);
        let (after, across_out) = from_line(end, turn.course_out, p);
        let bearing = turn.centre.bearing(p);
        let turned = side * wrap_180(bearing - turn.centre.bearing(start)) * PI / 180.0;
        let turned = if turned < -PI / 2.0 {
            turned + 2.0 * PI
        } else {
            turned
        };
        let rho = turn.centre.distance(p);
        let arc = Progress {
            part: Part::Arc,
            along: within(turned * radius, length),
            cross_track: side * (radius - rho),
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

/// Distance along a line from `origin` and across it, right positive.
fn from_line(origin: Point, course: Course, p: Point) -> (f64, f64) {
    let (sine, cosine) = (libm::sin(course.rad()), libm::cos(course.rad()));
    let (north, east) = (p.north - origin.north, p.east - origin.east);
    (north * cosine + east * sine, east * cosine - north * sine)
}

#[cfg(test)]
pub(crate) mod tests {
    use super::*;

    pub(super) fn right_turn() -> Path {
        let centre = Point {
            north: 1000.0,
            east: 500.0,
        };
        Path::turn(
            Course::from_deg(0.0),
            centre,
            Radius::from_m(500.0),
            Course::from_deg(90.0),
        )
    }

    fn check(path: &Path, north: f64, east: f64, part: Part, along: f64, across: f64) {
        let at = path.progress(Point { north, east });
        assert_eq!(at.part, part, "{at:?}");
        assert!(
            (at.along - along).abs() < 0.01 && (at.cross_track - across).abs() < 0.01,
            "{at:?}"
        );
    }

    #[test]
    fn progress_runs_over_leg_arc_and_leg() {
        let path = right_turn();
        check(&path, 400.0, 10.0, Part::LegIn, -600.0, 10.0);
        let quarter = 500.0 * PI / 4.0;
        let diagonal = 500.0 / 2.0_f64.sqrt();
        check(
            &path,
            1000.0 + diagonal,
            500.0 - diagonal,
            Part::Arc,
            quarter,
            0.0,
        );
        check(
            &path,
            1480.0,
            800.0,
            Part::LegOut,
            2.0 * quarter + 300.0,
            20.0,
        );
    }

    #[test]
    fn a_port_turn_counts_right_of_the_track_as_positive_too() {
        let centre = Point {
            north: 1000.0,
            east: -500.0,
        };
        let path = Path::turn(
            Course::from_deg(0.0),
            centre,
            Radius::from_m(500.0),
            Course::from_deg(270.0),
        );
        check(&path, 400.0, 10.0, Part::LegIn, -600.0, 10.0);
        let out = 510.0 / 2.0_f64.sqrt();
        check(
            &path,
            1000.0 + out,
            -500.0 + out,
            Part::Arc,
            500.0 * PI / 4.0,
            10.0,
        );
        check(
            &path,
            1480.0,
            -800.0,
            Part::LegOut,
            500.0 * PI / 2.0 + 300.0,
            -20.0,
        );
    }

    #[test]
    fn what_is_left_counts_down_to_the_end_of_the_arc() {
        let path = right_turn();
        let length = path.arc_length();
        let check =
            |north, east, expect: Option<f64>| match (path.left(Point { north, east }), expect) {
                (Some(left), Some(expect)) => {
                    assert!((left - expect).abs() < 1.0, "{left} {expect}")
                }
                (left, expect) => assert_eq!(left, expect),
            };
        check(900.0, 0.0, Some(length + 100.0));
        check(1353.553, 146.447, Some(length / 2.0));
        check(1510.0, 700.0, None);
        assert_eq!(path.leg_out().left(Point::default()), None);
    }

    #[test]
    fn a_point_along_the_path_lies_there() {
        for path in [right_turn(), right_turn().leg_out()] {
            for (along, starboard) in [(-300.0, 25.0), (0.0, -10.0), (200.0, 40.0), (900.0, -30.0)]
            {
                let progress = path.progress(path.at(along, starboard));
                assert!((progress.along - along).abs() < 1e-6, "{progress:?}");
                assert!((progress.cross_track - starboard).abs() < 1e-6);
            }
        }
        let line = right_turn().drawn(0.0, 0.0);
        assert!(line[0].distance(right_turn().start()) < 1e-6 && line.len() > 20);
        assert!(line[line.len() - 1].distance(right_turn().leg_out().point) < 1e-6);
    }
}

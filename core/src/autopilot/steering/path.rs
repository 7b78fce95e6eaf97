//! The path that is steered along: a leg, or two legs joined by an arc, with its curvature smoothed.
//!
//! A ship cannot change her curvature at once. With the planned curvature `k(s)` averaged over a window
//! of half length `h`, the path that can be sailed leaves the planned one by `o(s)`, `o'' = k_mean - k`:
//! `o` grows to `h^2/(6R)` inside the arc and is nothing on the legs. Everything is in closed form, as
//! the sum of two steps of curvature, `e(s)` at the start of the arc and `-e(s - length)` at its end.

use crate::geo::Point;
use crate::units::{Course, Distance, Radius, wrap_180};
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
    pub turn: Option<PathTurn>,
}

/// An arc to which both legs are tangent.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct PathTurn {
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

/// The smoothed path at one place.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Smooth {
    /// Cross-track distance of the smoothed path from the planned one, m.
    pub(super) offset: f64,
    /// Its direction, rad.
    pub(super) tangent: f64,
    /// Its curvature, 1/m.
    pub(super) curvature: f64,
    /// Change of the curvature along the path, 1/m^2.
    pub(super) bend: f64,
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
            turn: Some(PathTurn {
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
            along: (turned * radius).clamp(0.0, length),
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

    /// The smoothed path `along` metres from the start of the arc, averaged over `half` to both sides.
    pub(super) fn smooth(&self, along: f64, half: f64) -> Smooth {
        let Some(turn) = self.turn else {
            let tangent = self.course_in.rad();
            return Smooth {
                offset: 0.0,
                tangent,
                curvature: 0.0,
                bend: 0.0,
            };
        };
        let kappa = self.side() / turn.radius.m().max(1.0);
        let length = self.arc_length();
        let [o0, t0, k0, b0] = step_of_curvature(along, half.max(1.0));
        let [o1, t1, k1, b1] = step_of_curvature(along - length, half.max(1.0));
        let planned = along.clamp(0.0, length);
        Smooth {
            offset: kappa * (o0 - o1),
            tangent: self.course_in.rad() + kappa * (planned + t0 - t1),
            curvature: kappa * (k0 - k1),
            bend: kappa * (b0 - b1),
        }
    }
}

/// Offset, change of direction beyond the planned one, curvature and its slope, for a unit step at 0.
fn step_of_curvature(s: f64, h: f64) -> [f64; 4] {
    if s <= -h {
        return [0.0; 4];
    }
    if s >= h {
        return [h * h / 6.0, 0.0, 1.0, 0.0];
    }
    let mean = (s + h) / (2.0 * h);
    let slope = 1.0 / (2.0 * h);
    if s < 0.0 {
        let u = s + h;
        [u * u * u / (12.0 * h), u * u / (4.0 * h), mean, slope]
    } else {
        let u = s - h;
        [
            h * h / 6.0 + u * u * u / (12.0 * h),
            u * u / (4.0 * h),
            mean,
            slope,
        ]
    }
}

/// Distance along a line from `origin` and across it, right positive.
fn from_line(origin: Point, course: Course, p: Point) -> (f64, f64) {
    let (sine, cosine) = (libm::sin(course.rad()), libm::cos(course.rad()));
    let (north, east) = (p.north - origin.north, p.east - origin.east);
    (north * cosine + east * sine, east * cosine - north * sine)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn right_turn() -> Path {
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
    fn the_smoothed_path_is_the_integral_of_its_curvature() {
        let path = right_turn();
        let (mut before, step) = (path.smooth(-250.0, 200.0), 0.5);
        let mut s = -250.0;
        while s < 1100.0 {
            let next = path.smooth(s + step, 200.0);
            let mean = 0.5 * (before.curvature + next.curvature);
            assert!(
                (next.tangent - before.tangent - mean * step).abs() < 1e-6,
                "at {s}"
            );
            before = next;
            s += step;
        }
        assert!((before.tangent - PI / 2.0).abs() < 1e-9 && before.offset.abs() < 1e-9);
        assert!((path.smooth(400.0, 200.0).offset - 200.0 * 200.0 / 3000.0).abs() < 1e-9);
    }
}

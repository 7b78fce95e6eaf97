//! From places on the earth to points on the screen, and back to nothing else: the plan's one projection.

use crate::format::fixed;
use wheelover_core::geo::{Plane, Point, Position};
use wheelover_core::units::{Course, METRES_PER_NAUTICAL_MILE};

/// What is up on the screen.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Orientation {
    /// North.
    #[default]
    North,
    /// The ship's head.
    Head,
    /// The course of the leg.
    Course,
}

impl Orientation {
    /// Its name on the screen.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::North => "N UP",
            Self::Head => "H UP",
            Self::Course => "C UP",
        }
    }
}

/// Ranges that can be chosen: nautical miles from the ship to the nearer edge.
pub const RANGES: [f64; 8] = [0.25, 0.5, 0.75, 1.0, 1.5, 3.0, 6.0, 12.0];

/// A projection: a plane around the ship, turned and scaled to the screen.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Frame {
    /// The plane in which everything is placed.
    pub plane: Plane,
    /// Width and height, screen units.
    pub size: (f64, f64),
    /// Screen units in a metre.
    pub scale: f64,
    /// The direction that is up, degrees.
    pub up: f64,
    /// Where the plane's origin stands.
    centre: (f64, f64),
}

impl Frame {
    /// A frame with the ship at `ship`, moved against `ahead` so that more is seen in that direction.
    #[must_use]
    pub fn around(ship: Position, size: (f64, f64), range_nm: f64, up: f64, ahead: f64) -> Self {
        let half = libm::fmin(size.0, size.1) / 2.0;
        let scale = half / (range_nm * METRES_PER_NAUTICAL_MILE);
        let angle = (ahead - up).to_radians();
        let (dx, dy) = (
            libm::sin(angle) * size.0 * 0.18,
            -libm::cos(angle) * size.1 * 0.18,
        );
        Self {
            plane: Plane::at(ship),
            size,
            scale,
            up,
            centre: (size.0 / 2.0 - dx, size.1 / 2.0 - dy),
        }
    }

    /// Where a point of the plane stands.
    #[must_use]
    pub fn point(&self, point: Point) -> (f64, f64) {
        let (up, right) = point.off_line(Point::default(), Course::from_deg(self.up));
        (
            self.centre.0 + self.scale * right,
            self.centre.1 - self.scale * up,
        )
    }

    /// Where a position stands.
    #[must_use]
    pub fn place(&self, position: Position) -> (f64, f64) {
        self.point(self.plane.point(position))
    }

    /// The plane's point that stands at a corner or elsewhere on the screen.
    #[must_use]
    pub fn unproject(&self, (x, y): (f64, f64)) -> Point {
        let (sine, cosine) = (
            libm::sin(self.up.to_radians()),
            libm::cos(self.up.to_radians()),
        );
        let right = (x - self.centre.0) / self.scale;
        let upward = (self.centre.1 - y) / self.scale;
        Point {
            north: upward * cosine - right * sine,
            east: right * cosine + upward * sine,
        }
    }

    /// An SVG path through points of the plane.
    #[must_use]
    pub fn path(&self, points: &[Point]) -> String {
        let mut text = String::with_capacity(points.len() * 14);
        for (index, point) in points.iter().enumerate() {
            self.go(&mut text, index == 0, *point);
        }
        text
    }

    /// One more point of a path; `begins`: no line leads to it.
    pub fn go(&self, path: &mut String, begins: bool, point: Point) {
        let (x, y) = self.point(point);
        path.push(if begins { 'M' } else { 'L' });
        path.push_str(&format!("{} {}", fixed(x, 1), fixed(y, 1)));
    }

    /// A line of the plane from `point` in the direction `degrees`, `metres` long.
    #[must_use]
    pub fn ray(&self, point: Point, degrees: f64, metres: f64) -> String {
        self.path(&[point, point.towards(degrees, metres)])
    }

    /// A line across `point`, square to the direction `degrees`, `metres` to each side.
    #[must_use]
    pub fn across(&self, point: Point, degrees: f64, metres: f64) -> String {
        self.path(&[
            point.towards(degrees - 90.0, metres),
            point.towards(degrees + 90.0, metres),
        ])
    }

    /// Lines of latitude and longitude as one path, with the minutes between two of them.
    #[must_use]
    pub fn graticule(&self) -> (String, f64) {
        let (width, height) = self.size;
        let corners = [(0.0, 0.0), (width, 0.0), (0.0, height), (width, height)]
            .map(|corner| self.plane.position(self.unproject(corner)));
        let low =
            |pick: fn(&Position) -> f64| corners.iter().map(pick).fold(f64::INFINITY, libm::fmin);
        let high = |pick: fn(&Position) -> f64| {
            corners.iter().map(pick).fold(f64::NEG_INFINITY, libm::fmax)
        };
        let (south, north) = (low(|p| p.lat), high(|p| p.lat));
        let (west, east) = (low(|p| p.lon), high(|p| p.lon));
        let step = [0.1, 0.2, 0.5, 1.0, 2.0, 5.0, 10.0, 20.0]
            .into_iter()
            .find(|minutes| (north - south) * 60.0 / minutes < 7.0)
            .unwrap_or(30.0);
        let mut path = String::new();
        let mut line = |from: Position, to: Position| {
            path.push_str(&self.path(&[self.plane.point(from), self.plane.point(to)]));
        };
        for lat in multiples(south, north, step / 60.0) {
            line(Position { lat, lon: west }, Position { lat, lon: east });
        }
        for lon in multiples(west, east, step / 60.0) {
            line(Position { lat: south, lon }, Position { lat: north, lon });
        }
        (path, step)
    }
}

fn multiples(low: f64, high: f64, step: f64) -> impl Iterator<Item = f64> {
    let first = libm::ceil(low / step);
    (0..40)
        .map(move |index| (first + f64::from(index)) * step)
        .take_while(move |value| *value <= high)
}

#[cfg(test)]
mod tests {
    use super::*;

    const SHIP: Position = Position {
        lat: 54.0,
        lon: 12.0,
    };

    fn frame(up: f64) -> Frame {
        Frame::around(SHIP, (800.0, 600.0), 1.0, up, up)
    }

    // DSP-4
    #[test]
    fn what_is_ahead_is_above_when_the_head_is_up() {
        let frame = frame(245.0);
        let ship = frame.point(Point::default());
        let ahead = frame.point(Point::default().towards(245.0, 1852.0));
        assert!((ahead.0 - ship.0).abs() < 1e-6);
        assert!(
            (ship.1 - ahead.1 - 300.0).abs() < 1e-6,
            "a mile is half the height"
        );
        assert!(ship.1 > 400.0, "the ship stands below the middle");
    }

    #[test]
    fn screen_and_plane_agree_both_ways() {
        let frame = frame(33.0);
        let point = Point {
            north: 812.0,
            east: -407.0,
        };
        let back = frame.unproject(frame.point(point));
        assert!(back.distance(point) < 1e-6);
    }

    #[test]
    fn graticule_has_few_lines() {
        let (path, step) = frame(0.0).graticule();
        let lines = path.matches('M').count();
        assert!((4..30).contains(&lines), "{lines} lines of {step} minutes");
    }
}

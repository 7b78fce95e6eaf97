//! Positions on the WGS 84 ellipsoid and the local plane in which a ship is steered.

pub mod rhumb;

use crate::units::Course;
use core::f64::consts::PI;
use serde::{Deserialize, Serialize};

/// A place: latitude and longitude in degrees, north and east positive.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Position {
    /// Latitude, degrees, -90 to 90.
    pub lat: f64,
    /// Longitude, degrees, -180 to 180.
    pub lon: f64,
}

/// A point of a local plane: metres north and east of its origin.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Point {
    /// Metres north.
    pub north: f64,
    /// Metres east.
    pub east: f64,
}

/// A plane that touches the ellipsoid at `origin`; good to a metre within ten miles.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Plane {
    /// Where the plane touches.
    pub origin: Position,
    meridian_radius: f64,
    parallel_radius: f64,
}

const SEMI_MAJOR: f64 = 6_378_137.0;
const ECCENTRICITY_SQUARED: f64 = 0.006_694_379_990_141_316;

/// Degrees of latitude or longitude to a millimetre on the earth, for whoever writes them: what is computed has fifteen
/// decimals, which say no more.
#[must_use]
pub fn to_millimetre(degrees: f64) -> f64 {
    libm::round(degrees * 1e8) / 1e8
}

impl Position {
    /// Distance to a place near by, in the plane here, metres.
    #[must_use]
    pub fn distance(self, other: Self) -> f64 {
        Plane::at(self).point(other).distance(Point::default())
    }

    /// The place so far north and east of this one, in the plane here.
    #[must_use]
    pub fn moved(self, by: Point) -> Self {
        Plane::at(self).position(by)
    }
}

impl Plane {
    /// The plane that touches at `origin`.
    #[must_use]
    pub fn at(origin: Position) -> Self {
        let phi = origin.lat * PI / 180.0;
        let sine = libm::sin(phi);
        let w2 = 1.0 - ECCENTRICITY_SQUARED * sine * sine;
        let w = libm::sqrt(w2);
        Self {
            origin,
            meridian_radius: SEMI_MAJOR * (1.0 - ECCENTRICITY_SQUARED) / (w2 * w),
            parallel_radius: SEMI_MAJOR / w * libm::cos(phi),
        }
    }

    /// The point of the plane that stands for `position`.
    #[must_use]
    pub fn point(&self, position: Position) -> Point {
        let dlon = crate::units::wrap_180(position.lon - self.origin.lon);
        Point {
            north: (position.lat - self.origin.lat) * PI / 180.0 * self.meridian_radius,
            east: dlon * PI / 180.0 * self.parallel_radius,
        }
    }

    /// The position that `point` stands for.
    #[must_use]
    pub fn position(&self, point: Point) -> Position {
        let lon = self.origin.lon + point.east / self.parallel_radius * 180.0 / PI;
        Position {
            lat: self.origin.lat + point.north / self.meridian_radius * 180.0 / PI,
            lon: crate::units::wrap_180(lon),
        }
    }
}

impl Point {
    /// Distance to another point, metres.
    #[must_use]
    pub fn distance(self, other: Self) -> f64 {
        libm::hypot(other.north - self.north, other.east - self.east)
    }

    /// Direction to another point, degrees from north, 0 to 360.
    #[must_use]
    pub fn bearing(self, other: Self) -> f64 {
        crate::units::wrap_360(
            libm::atan2(other.east - self.east, other.north - self.north) * 180.0 / PI,
        )
    }

    /// How far it lies along the line that leaves `origin` on `course`, and how far off it, right of it positive, metres.
    #[must_use]
    pub fn off_line(self, origin: Self, course: Course) -> (f64, f64) {
        let (sine, cosine) = (libm::sin(course.rad()), libm::cos(course.rad()));
        let (north, east) = (self.north - origin.north, self.east - origin.east);
        (north * cosine + east * sine, east * cosine - north * sine)
    }

    /// The point `metres` away in the direction `degrees` from north.
    #[must_use]
    pub fn towards(self, degrees: f64, metres: f64) -> Self {
        let angle = degrees * PI / 180.0;
        Self {
            north: self.north + metres * libm::cos(angle),
            east: self.east + metres * libm::sin(angle),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn plane_and_back_gives_the_same_position() {
        let plane = Plane::at(Position {
            lat: 53.75,
            lon: -12.9,
        });
        let there = plane.position(Point {
            north: 3000.0,
            east: -4000.0,
        });
        let back = plane.point(there);
        assert!((back.north - 3000.0).abs() < 1e-6 && (back.east + 4000.0).abs() < 1e-6);
    }
}

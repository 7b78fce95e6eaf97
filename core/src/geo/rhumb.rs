//! Rhumb lines on the WGS 84 ellipsoid: course, distance, destination, cross-track distance.
//!
//! A rhumb line is a straight line over longitude and isometric latitude
//! `q = asinh(tan phi) - e atanh(e sin phi)`; its length is `(m2 - m1) / cos c` with `m` the length of the
//! meridian arc, and along a parallel `N cos phi dlon`.

use super::{ECCENTRICITY_SQUARED, Position, SEMI_MAJOR};
use crate::units::{Course, Distance, wrap_180};
use core::f64::consts::PI;

const RADIANS: f64 = PI / 180.0;

/// Course and length of the rhumb line between two positions, the short way round.
#[must_use]
pub fn between(from: Position, to: Position) -> (Course, Distance) {
    let dlon = wrap_180(to.lon - from.lon) * RADIANS;
    let (lat1, lat2) = (from.lat * RADIANS, to.lat * RADIANS);
    let dq = isometric(lat2) - isometric(lat1);
    let scale = mean_scale(lat1, lat2);
    (
        Course::from_rad(libm::atan2(dlon, dq)),
        Distance::from_m(libm::hypot(dlon, dq) * scale),
    )
}

/// The position `distance` away on the rhumb line that leaves on `course`.
#[must_use]
pub fn destination(from: Position, course: Course, distance: Distance) -> Position {
    let lat1 = from.lat * RADIANS;
    let lat2 = latitude_of(meridian_arc(lat1) + distance.m() * libm::cos(course.rad()));
    let dlon = distance.m() * libm::sin(course.rad()) / mean_scale(lat1, lat2);
    Position {
        lat: lat2 / RADIANS,
        lon: wrap_180(from.lon + dlon / RADIANS),
    }
}

/// Where a position lies relative to the rhumb line that leaves `from` on `course`: metres along it to the foot
/// of the perpendicular, and metres off it, right of the line positive.
#[must_use]
pub fn offset(from: Position, course: Course, position: Position) -> (Distance, Distance) {
    let (sine, cosine) = (libm::sin(course.rad()), libm::cos(course.rad()));
    let (lat0, lat) = (from.lat * RADIANS, position.lat * RADIANS);
    let x = wrap_180(position.lon - from.lon) * RADIANS;
    let y = isometric(lat) - isometric(lat0);
    let across = x * cosine - y * sine;
    let along = x * sine + y * cosine;
    // The foot of the perpendicular lies north of the ship by `across sin c`.
    let foot = lat + across * parallel_radius(lat) * sine / meridian_radius(lat);
    (
        Distance::from_m(along * mean_scale(lat0, foot)),
        Distance::from_m(across * mean_scale(lat, foot)),
    )
}

/// Isometric latitude, radians.
fn isometric(lat: f64) -> f64 {
    let e = libm::sqrt(ECCENTRICITY_SQUARED);
    libm::asinh(libm::tan(lat)) - e * libm::atanh(e * libm::sin(lat))
}

fn parallel_radius(lat: f64) -> f64 {
    let sine = libm::sin(lat);
    SEMI_MAJOR * libm::cos(lat) / libm::sqrt(1.0 - ECCENTRICITY_SQUARED * sine * sine)
}

fn meridian_radius(lat: f64) -> f64 {
    let sine = libm::sin(lat);
    let w2 = 1.0 - ECCENTRICITY_SQUARED * sine * sine;
    SEMI_MAJOR * (1.0 - ECCENTRICITY_SQUARED) / (w2 * libm::sqrt(w2))
}

/// Metres for each unit of longitude or isometric latitude on a rhumb line between two latitudes.
fn mean_scale(lat1: f64, lat2: f64) -> f64 {
    if libm::fabs(lat2 - lat1) < 1e-5 {
        return parallel_radius(0.5 * (lat1 + lat2));
    }
    (meridian_arc(lat2) - meridian_arc(lat1)) / (isometric(lat2) - isometric(lat1))
}

/// Length of the meridian from the equator, metres (Bessel's series in the third flattening).
fn meridian_arc(lat: f64) -> f64 {
    let root = libm::sqrt(1.0 - ECCENTRICITY_SQUARED);
    let n = (1.0 - root) / (1.0 + root);
    let (n2, n3, n4) = (n * n, n * n * n, n * n * n * n);
    let radius = SEMI_MAJOR / (1.0 + n) * (1.0 + n2 / 4.0 + n4 / 64.0);
    radius
        * (lat - (1.5 * n - 9.0 / 16.0 * n3) * libm::sin(2.0 * lat)
            + (15.0 / 16.0 * n2 - 15.0 / 32.0 * n4) * libm::sin(4.0 * lat)
            - 35.0 / 48.0 * n3 * libm::sin(6.0 * lat)
            + 315.0 / 512.0 * n4 * libm::sin(8.0 * lat))
}

/// The latitude at which the meridian arc has that length; the inverse of [`meridian_arc`] by Newton's method.
fn latitude_of(arc: f64) -> f64 {
    let mut lat = arc / 6_367_449.0;
    for _ in 0..5 {
        lat -= (meridian_arc(lat) - arc) / meridian_radius(lat);
    }
    lat.clamp(-0.4999 * PI, 0.4999 * PI)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn near(a: f64, b: f64, within: f64) {
        assert!((a - b).abs() < within, "{a} is not {b}");
    }

    #[test]
    fn a_minute_of_the_meridian_has_its_known_length() {
        // WGS 84: the quarter meridian is 10 001 965.729 m; one minute at 45 degrees 1852.2 m.
        near(meridian_arc(PI / 2.0), 10_001_965.729, 0.001);
        let (course, length) = between(
            Position {
                lat: 44.991_666_667,
                lon: 5.0,
            },
            Position {
                lat: 45.008_333_333,
                lon: 5.0,
            },
        );
        assert_eq!(course.deg(), 0.0);
        near(length.m(), 1852.2, 0.1);
    }

    #[test]
    fn along_a_parallel_the_length_is_that_of_the_parallel() {
        // One degree of longitude at 60 degrees north is 55 800 m on WGS 84.
        let (course, length) = between(
            Position {
                lat: 60.0,
                lon: 179.5,
            },
            Position {
                lat: 60.0,
                lon: -179.5,
            },
        );
        assert_eq!(course.deg(), 90.0);
        near(length.m(), 55_800.1, 0.5);
    }

    #[test]
    fn destination_and_between_are_inverse() {
        for (lat, course, miles) in [
            (53.9, 37.0, 3.0),
            (-33.0, 200.0, 400.0),
            (60.0, 90.0, 60.0),
            (0.0, 271.0, 5.0),
        ] {
            let from = Position { lat, lon: -179.9 };
            let to = destination(from, Course::from_deg(course), Distance::from_nm(miles));
            let (back, length) = between(from, to);
            near((back - Course::from_deg(course)).deg(), 0.0, 1e-6);
            near(length.nm(), miles, 1e-6);
        }
    }

    #[test]
    fn right_of_the_line_is_positive_and_offsets_are_metres() {
        let from = Position {
            lat: 59.8,
            lon: 24.8,
        };
        for course in [0.0, 45.0, 90.0, 135.0, 222.0, 270.0, 359.0] {
            let course = Course::from_deg(course);
            let foot = destination(from, course, Distance::from_nm(2.5));
            let right = Course::from_deg(course.deg() + 90.0);
            let ship = destination(foot, right, Distance::from_m(300.0));
            let (along, across) = offset(from, course, ship);
            near(across.m(), 300.0, 0.05);
            near(along.m(), 2.5 * 1852.0, 0.5);
        }
    }
}

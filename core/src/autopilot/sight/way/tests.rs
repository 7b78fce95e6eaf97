//! What fixes of so many decimals make of course and speed, and what they never make.

use super::*;
use crate::geo::{Plane, Position};
use crate::units::{Course, METRES_PER_SECOND_PER_KNOT, wrap_180};

/// A position as GGA says it, with so many decimals of a minute, in the plane.
fn said(plane: &Plane, point: Point, decimals: i32) -> Point {
    let place = plane.position(point);
    let unit = libm::pow(10.0, f64::from(decimals)) * 60.0;
    let round = |degrees: f64| libm::round(degrees * unit) / unit;
    plane.point(Position {
        lat: round(place.lat),
        lon: round(place.lon),
    })
}

/// A ship at `knots` that turns at `rate`, degrees a minute, and her receiver: one fix a second, `spoil` moves it.
/// The largest errors of course and speed from the tenth second on, degrees and knots; and how many seconds had none.
fn sail(
    (knots, rate, decimals): (f64, f64, i32),
    spoil: impl Fn(u64, &mut Point),
) -> (f64, f64, u32) {
    let plane = Plane::at(Position {
        lat: 59.8,
        lon: 25.0,
    });
    let turn = RateOfTurn::from_deg_per_min(rate);
    let (mut way, mut point, mut course) = (Way::default(), Point::default(), 30.0);
    let (mut worst, mut none) = ((0.0_f64, 0.0_f64), 0);
    for tenth in 0..3_000_u64 {
        course += rate / 600.0;
        point = point.towards(course, knots * METRES_PER_SECOND_PER_KNOT / 10.0);
        if !tenth.is_multiple_of(10) {
            continue;
        }
        let mut fix = said(&plane, point, decimals);
        spoil(tenth / 10, &mut fix);
        let now = Stamp(tenth * 100);
        way.take(fix, now, turn);
        if tenth < 100 {
            continue;
        }
        let Some((v, _)) = way.velocity(now) else {
            none += 1;
            continue;
        };
        let speed = libm::hypot(v.north, v.east) / METRES_PER_SECOND_PER_KNOT;
        let made = Course::from_rad(libm::atan2(v.east, v.north)).deg();
        worst.0 = worst.0.max(libm::fabs(wrap_180(made - course)));
        worst.1 = worst.1.max(libm::fabs(speed - knots));
    }
    (worst.0, worst.1, none)
}

// AP-9: C, on a straight course and in turns of a ship and of a craft
#[test]
fn fixes_once_a_second_make_course_and_speed() {
    for (ship, course, speed) in [
        ((15.0, 0.0, 4), 0.3, 0.05),
        ((15.0, 0.0, 3), 1.5, 0.35),
        ((15.0, 28.0, 4), 0.5, 0.15),
        ((15.0, -28.0, 3), 2.0, 0.5),
        ((20.0, 200.0, 4), 4.0, 0.5),
        ((20.0, -200.0, 3), 7.0, 1.5),
        ((5.0, 20.0, 4), 1.0, 0.15),
    ] {
        let (off, fast, none) = sail(ship, |_, _| {});
        assert!(off < course && fast < speed, "{ship:?}: {off} {fast}");
        assert_eq!(none, 0, "{ship:?}");
    }
}

// AP-9, FA9: whatever a position does, no speed comes of it.
#[test]
fn a_position_that_jumps_gives_no_speed() {
    for metres in [3.0, 6.0, 9.0, 15.0, 29.0, 300.0] {
        for back in [u64::MAX, 61, 63, 64] {
            let jump = |second: u64, fix: &mut Point| {
                if (60..back).contains(&second) {
                    fix.east += metres;
                }
            };
            let (_, fast, _) = sail((15.0, 0.0, 4), jump);
            assert!(fast < 1.5, "{metres} m, back at {back}: {fast} kn");
            let (_, fast, _) = sail((0.0, 0.0, 4), jump);
            assert!(fast < 1.5, "{metres} m, back at {back}, at rest: {fast} kn");
        }
    }
    // From the first fixes on.
    for metres in [15.0, 29.0] {
        let jump = |second: u64, fix: &mut Point| {
            if second > 1 {
                fix.north += metres;
            }
        };
        let (_, fast, _) = sail((0.0, 0.0, 4), jump);
        assert!(fast < 1.5, "{metres} m: {fast} kn");
    }
}

// AP-9: two decimals are steps of 18 m; no speed is made of them, rather than a wrong one.
#[test]
fn a_position_of_two_decimals_gives_none_while_she_moves() {
    let (_, fast, none) = sail((15.0, 0.0, 2), |_, _| {});
    assert!(none > 200 || fast < 2.0, "{none} {fast}");
}

// AP-9
#[test]
fn a_velocity_is_used_no_longer_than_five_seconds_after_its_last_fix() {
    let mut way = Way::default();
    for second in 0..20 {
        let point = Point::default().towards(90.0, 7.0 * second as f64);
        way.take(point, Stamp(second * 1000), RateOfTurn::default());
    }
    assert!(way.velocity(Stamp(24_000)).is_some());
    assert!(way.velocity(Stamp(24_001)).is_none());
    // One fix after a silence is no way made.
    way.take(Point::default(), Stamp(30_000), RateOfTurn::default());
    assert!(way.velocity(Stamp(30_000)).is_none());
}

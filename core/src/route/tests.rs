//! Route geometry and the checks of TCS-11.

use super::*;
use crate::geo::{Position, rhumb};
use crate::units::{Course, Distance, Radius, Speed};
use alloc::string::ToString;
use alloc::vec;
use alloc::vec::Vec;

fn near(a: f64, b: f64, within: f64) {
    assert!((a - b).abs() < within, "{a} is not {b}");
}

/// Course, miles, and radius at the end of a leg.
type Plain = (f64, f64, Option<f64>);

/// Waypoints from a start and legs.
fn waypoints(legs: &[Plain]) -> Vec<Waypoint> {
    let mut place = Position {
        lat: 59.8,
        lon: 24.8,
    };
    let mut all = vec![Waypoint::new("000", place, None)];
    for (index, (course, miles, radius)) in legs.iter().enumerate() {
        place = rhumb::destination(place, Course::from_deg(*course), Distance::from_nm(*miles));
        let id = alloc::format!("{:03}", index + 1);
        all.push(Waypoint::new(&id, place, radius.map(Radius::from_nm)));
    }
    all
}

fn route(legs: &[Plain]) -> Result<Route, RouteFault> {
    Route::new("test", waypoints(legs), RouteLimits::default())
}

#[test]
fn the_arc_is_tangent_to_both_legs() {
    for turn_deg in [-120.0, -60.0, -5.0, 5.0, 35.0, 90.0, 140.0] {
        let route = route(&[(245.0, 4.0, Some(0.5)), (245.0 + turn_deg, 4.0, None)]).unwrap();
        let turn = &route.turns()[0];
        near(turn.angle().deg(), turn_deg, 1e-3);
        for (leg, point) in [(0, turn.start()), (1, turn.end())] {
            near(route.leg(leg).cross_track(point).m(), 0.0, 0.5);
            near(turn.cross_track(point).m(), 0.0, 0.5);
        }
        near(turn.along(turn.start()).m(), 0.0, 1.0);
        near(turn.along(turn.end()).m(), turn.length().m(), 1.0);
        let middle = turn.at(Distance::from_m(turn.length().m() / 2.0));
        near(turn.cross_track(middle).m(), 0.0, 0.1);
        // XTD of an arc point to the next leg: R (1 - cos(remaining angle)), outside of the bend.
        let off = route.leg(1).cross_track(middle).m();
        let expected = 926.0 * (1.0 - libm::cos(turn.angle().abs().rad() / 2.0));
        near(off.abs(), expected, 1.0);
    }
}

#[test]
fn right_of_the_arc_is_positive_to_both_sides() {
    for turn_deg in [60.0, -60.0] {
        let route = route(&[(10.0, 4.0, Some(0.5)), (10.0 + turn_deg, 4.0, None)]).unwrap();
        let turn = &route.turns()[0];
        let middle = turn.at(Distance::from_m(turn.length().m() / 2.0));
        let right = Course::from_deg(10.0 + turn_deg / 2.0 + 90.0);
        let ship = rhumb::destination(middle, right, Distance::from_m(50.0));
        near(turn.cross_track(ship).m(), 50.0, 0.5);
    }
}

#[test]
fn a_radius_that_does_not_fit_is_refused_with_leg_and_largest_radius() {
    // TCS-11
    let legs = |radius| {
        [
            (0.0, 3.0, Some(0.5)),
            (60.0, 2.0, Some(radius)),
            (120.0, 3.0, None),
        ]
    };
    let fault = route(&legs(2.5)).unwrap_err();
    let RouteFault::RadiusDoesNotFit {
        waypoint,
        leg,
        radius_nm,
        largest_nm,
    } = fault.clone()
    else {
        panic!("{fault:?}")
    };
    assert_eq!((waypoint.as_str(), leg), ("002", 2));
    near(radius_nm, 2.5, 1e-9);
    assert!(
        fault
            .to_string()
            .contains("does not fit leg 2; the largest that fits is"),
        "{fault}"
    );
    assert!(route(&legs(largest_nm)).is_ok());
    assert!(route(&legs(largest_nm + 0.002)).is_err());
}

#[test]
fn one_radius_too_large_for_the_last_leg_names_that_leg() {
    let fault = route(&[(0.0, 6.0, Some(2.0)), (90.0, 1.5, None)]).unwrap_err();
    let RouteFault::RadiusDoesNotFit {
        leg, largest_nm, ..
    } = fault.clone()
    else {
        panic!("{fault:?}")
    };
    assert_eq!(leg, 2);
    assert!(route(&[(0.0, 6.0, Some(largest_nm)), (90.0, 1.5, None)]).is_ok());
}

#[test]
fn what_is_not_a_route_is_refused_with_its_reason() {
    let cases: [(&[Plain], &str); 6] = [
        (&[], "at least two waypoints"),
        (&[(0.0, 0.0, None)], "leg 1 has no length"),
        (
            &[(0.0, 3.0, None), (40.0, 3.0, None)],
            "waypoint 001 has no radius",
        ),
        (
            &[(0.0, 3.0, Some(0.5)), (170.0, 3.0, None)],
            "is more than 150 deg",
        ),
        (
            &[(0.0, 3.0, Some(0.01)), (40.0, 3.0, None)],
            "is not between 0.100 and 10.000 nm",
        ),
        (
            &[(0.0, 0.2, Some(0.5)), (40.0, 3.0, None)],
            "leg 1 of 0.200 nm is too short",
        ),
    ];
    for (legs, words) in cases {
        let text = route(legs).unwrap_err().to_string();
        assert!(text.contains(words), "{text}");
    }
    let nan = Position {
        lat: f64::NAN,
        lon: 0.0,
    };
    let far = Position {
        lat: 0.0,
        lon: 200.0,
    };
    for place in [nan, far] {
        let both = vec![
            Waypoint::new("A", place, None),
            Waypoint::new("B", nan, None),
        ];
        assert!(matches!(
            Route::new("x", both, RouteLimits::default()),
            Err(RouteFault::Place { .. })
        ));
    }
    let mut named = waypoints(&[(0.0, 3.0, None)]);
    named[1].id = "A,B".into();
    assert!(matches!(
        Route::new("x", named, RouteLimits::default()),
        Err(RouteFault::Identifier { number: 2 })
    ));
}

#[test]
fn a_stored_route_that_does_not_fit_does_not_come_back() {
    let good = embedded();
    let json = serde_json::to_string(&good).unwrap();
    assert_eq!(serde_json::from_str::<Route>(&json).unwrap(), good);
    let bad = json.replace("\"radius\":926.0", "\"radius\":9260.0");
    assert!(bad != json && serde_json::from_str::<Route>(&bad).is_err());
}

#[test]
fn the_embedded_route_turns_both_ways_and_wheels_over_early() {
    let route = embedded();
    assert!(route.legs().len() >= 5);
    assert!(route.turns().iter().any(|turn| turn.angle().deg() > 0.0));
    assert!(route.turns().iter().any(|turn| turn.angle().deg() < 0.0));
    assert!(route.turns().iter().all(|turn| turn.radius().nm() >= 0.5));
    let (start, heading) = embedded_start();
    let progress = Progress::locate(&route, start, route.turns()[0].forwarding());
    assert_eq!(progress.phase(), Phase::Leg(0));
    near(heading.deg(), 245.0, 0.1);
    let to_go = progress
        .to_wheel_over(&route, start, route.turns()[0].forwarding())
        .unwrap();
    near(to_go.m() / Speed::from_knots(15.0).mps(), 80.0, 0.1);
}

#[test]
fn a_ship_along_the_track_passes_each_line_in_order() {
    let route = embedded();
    let forwarding = route.turns()[0].forwarding();
    let (start, _) = embedded_start();
    let mut progress = Progress::locate(&route, start, forwarding);
    let mut seen = vec![progress.phase()];
    for (index, leg) in route.legs().iter().enumerate() {
        let from = index
            .checked_sub(1)
            .map_or(0.0, |k| route.turns()[k].tangent().m());
        let to = leg.length().m()
            - route
                .turn_after(index)
                .map_or(-15.0, |turn| turn.tangent().m());
        let points = (0..)
            .map(|i| from + f64::from(i) * 7.7)
            .take_while(|d| *d < to);
        let arc = route
            .turn_after(index)
            .map_or(0.0, |turn| turn.length().m());
        let arcs = (0..).map(|i| f64::from(i) * 7.7).take_while(|d| *d < arc);
        let places = points
            .map(|d| leg.at(Distance::from_m(d)))
            .chain(arcs.filter_map(|d| Some(route.turn_after(index)?.at(Distance::from_m(d)))));
        for place in places {
            progress.advance(&route, place, forwarding);
            if seen.last() != Some(&progress.phase()) {
                seen.push(progress.phase());
            }
            // A monitor that is switched on here finds the same part of the route (but for F, seen as leg).
            let found = Progress::locate(&route, place, forwarding).phase();
            // Past the end of a circuit the first leg comes next.
            let same = found == progress.phase() || progress.phase() == Phase::Past;
            assert!(
                same || progress.phase().turning(),
                "{found:?} {:?}",
                progress.phase()
            );
        }
    }
    let mut expected = vec![];
    for leg in 0..6 {
        expected.extend([Phase::Leg(leg), Phase::Forwarding(leg), Phase::Arc(leg)]);
    }
    expected.extend([Phase::Leg(6), Phase::Past]);
    assert_eq!(seen, expected);
}

//! The route of the embedded voyage: a circuit of seven legs in the Gulf of Finland, turns to both sides.

use super::{Route, RouteLimits, Waypoint};
use crate::geo::{Position, rhumb};
use crate::units::{Course, Distance, Heading, Radius};
use alloc::vec::Vec;

/// Place of the first waypoint.
const FIRST: Position = Position {
    lat: 59.8,
    lon: 25.0,
};

/// Course and length (nautical miles) of each leg, then identifier and radius of the waypoint at its end.
/// The last leg ends a quarter of a mile before the first begins, on the same course: round after round.
const LEGS: [(f64, f64, &str, Option<f64>); 7] = [
    (245.0, 1.2, "001", Some(0.5)),
    (330.0, 2.2, "002", Some(0.8)),
    (300.0, 2.0, "HAMBURG", Some(0.6)),
    (40.0, 3.800, "004", Some(0.5)),
    (155.0, 3.623, "005", Some(0.8)),
    (130.0, 2.0, "006", Some(0.5)),
    (245.0, 1.5, "007", None),
];

/// Time from the start to the first wheel-over line at the planned speed, seconds.
const FIRST_WHEEL_OVER_S: f64 = 80.0;

/// The route of the embedded voyage; an hour at 15 knots.
#[must_use]
#[allow(clippy::missing_panics_doc)] // the route is a constant, and a test builds it
pub fn embedded() -> Route {
    let mut waypoints = Vec::with_capacity(LEGS.len() + 1);
    waypoints.push(Waypoint::new("000", FIRST, None));
    let mut place = FIRST;
    for (course, miles, id, radius) in LEGS {
        place = rhumb::destination(place, Course::from_deg(course), Distance::from_nm(miles));
        waypoints.push(Waypoint::new(id, place, radius.map(Radius::from_nm)));
    }
    Route::new("Gulf of Finland", waypoints, RouteLimits::default())
        .expect("the route of the embedded voyage is constant and fits")
}

/// Where and on which heading the embedded voyage begins: on the first leg, 80 s before its wheel-over line.
#[must_use]
pub fn embedded_start() -> (Position, Heading) {
    let route = embedded();
    let leg = route.leg(0);
    let before = route
        .turn_after(0)
        .map_or(0.0, |turn| turn.before(turn.forwarding()).m())
        + FIRST_WHEEL_OVER_S * route.limits().speed.mps();
    let along = Distance::from_m(leg.length().m() - before);
    (leg.at(along), leg.course().as_heading())
}

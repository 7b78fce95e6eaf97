//! Routes of these tests, and how far off them a ship is.

use wheelover_core::chart_system::ChartSystem;
use wheelover_core::geo::{Position, rhumb};
use wheelover_core::route::{Route, RouteLimits, Waypoint};
use wheelover_core::units::{Course, Distance, Radius};

/// Legs of `(course, miles)`; a radius at each waypoint between them.
pub(crate) fn route(legs: &[(f64, f64)], radius: f64) -> Route {
    let mut place = Position {
        lat: 59.8,
        lon: 25.0,
    };
    let mut waypoints = vec![Waypoint::new("WP0", place, None)];
    for (index, (course, miles)) in legs.iter().enumerate() {
        place = rhumb::destination(place, Course::from_deg(*course), Distance::from_nm(*miles));
        let last = index + 1 == legs.len();
        let id = format!("WP{}", index + 1);
        waypoints.push(Waypoint::new(
            &id,
            place,
            (!last).then(|| Radius::from_nm(radius)),
        ));
    }
    Route::new("test", waypoints, RouteLimits::default()).unwrap()
}

/// Distance of the leg or arc that belongs to the chart system's situation, metres, without sign.
pub(crate) fn off_path(route: &Route, chart: &ChartSystem, position: Position) -> f64 {
    let index = chart.leg().unwrap_or(0);
    let on_arc = chart.situation() == 4;
    let leg = route.leg(index);
    match route.turn_after(index) {
        Some(turn) if on_arc => turn.cross_track(position).m().abs(),
        _ => leg.cross_track(position).m().abs(),
    }
}

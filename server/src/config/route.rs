//! The route of a configuration: waypoints as written, made into a route that fits its legs.

use serde::Deserialize;
use wheelover_core::geo::Position;
use wheelover_core::route::{Route, RouteLimits, Waypoint};
use wheelover_core::units::{Distance, Radius, Speed};

/// `[route]` as written.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct Form {
    /// Its name.
    #[serde(default)]
    pub(super) name: Option<String>,
    /// A file with the waypoints.
    pub(super) file: Option<String>,
    /// The waypoints themselves.
    #[serde(default)]
    pub(super) waypoint: Vec<Point>,
}

/// One waypoint as written.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct Point {
    id: String,
    lat: f64,
    lon: f64,
    radius_nm: Option<f64>,
    #[serde(default = "corridor")]
    xtd_port_m: f64,
    #[serde(default = "corridor")]
    xtd_starboard_m: f64,
}

const fn corridor() -> f64 {
    185.2
}

/// Makes the route, or says in one line why it cannot be.
pub(super) fn route(name: &str, points: &[Point], speed_kn: f64) -> Result<Route, String> {
    let mut waypoints = Vec::with_capacity(points.len());
    for point in points {
        let numbers = [
            point.lat,
            point.lon,
            point.radius_nm.unwrap_or_default(),
            point.xtd_port_m,
            point.xtd_starboard_m,
        ];
        if numbers.iter().any(|number| !number.is_finite()) {
            return Err(format!(
                "waypoint {} has a value that is not a number",
                point.id
            ));
        }
        let position = Position {
            lat: point.lat,
            lon: point.lon,
        };
        let mut waypoint = Waypoint::new(&point.id, position, point.radius_nm.map(Radius::from_nm));
        waypoint.limit_port = Distance::from_m(point.xtd_port_m);
        waypoint.limit_starboard = Distance::from_m(point.xtd_starboard_m);
        waypoints.push(waypoint);
    }
    let limits = RouteLimits {
        speed: Speed::from_knots(speed_kn),
        ..RouteLimits::default()
    };
    Route::new(name, waypoints, limits).map_err(|fault| fault.to_string())
}

//! The route as the page draws it.

use super::message::{RouteDocument, TurnView, WaypointView};
use crate::route::{Route, Turn, Waypoint};
use alloc::string::ToString;

/// The route with its geometry, for drawing.
#[must_use]
pub fn drawn_route(route: &Route, revision: u64) -> RouteDocument {
    let waypoint = |(index, waypoint): (usize, &Waypoint)| WaypointView {
        id: waypoint.id.clone(),
        position: waypoint.position,
        radius_nm: waypoint.radius.map(|radius| radius.nm()),
        xtd_m: [waypoint.limit_port.m(), waypoint.limit_starboard.m()],
        course: index
            .checked_sub(1)
            .map(|leg| route.leg(leg).course().deg()),
    };
    let turn = |(index, turn): (usize, &Turn)| TurnView {
        waypoint: index + 1,
        wheel_over: turn.wheel_over(turn.forwarding()),
        start: turn.start(),
        end: turn.end(),
        centre: turn.centre(),
        turn: turn.angle().deg(),
        forwarding_m: turn.forwarding().m(),
    };
    RouteDocument {
        revision,
        name: route.name().to_string(),
        waypoints: route.waypoints().iter().enumerate().map(waypoint).collect(),
        turns: route.turns().iter().enumerate().map(turn).collect(),
    }
}

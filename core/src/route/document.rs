//! The route as the page draws it.

use super::Route;
use crate::stream::{RouteDocument, TurnView, WaypointView};

impl Route {
    /// The route with its geometry, for drawing.
    #[must_use]
    pub fn document(&self, revision: u64) -> RouteDocument {
        let waypoint = |(index, waypoint): (usize, &super::Waypoint)| WaypointView {
            id: waypoint.id.clone(),
            position: waypoint.position,
            radius_nm: waypoint.radius.map(|radius| radius.nm()),
            xtd_m: [waypoint.limit_port.m(), waypoint.limit_starboard.m()],
            course: index.checked_sub(1).map(|leg| self.leg(leg).course().deg()),
        };
        let turn = |(index, turn): (usize, &super::Turn)| TurnView {
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
            name: self.name.clone(),
            waypoints: self.waypoints.iter().enumerate().map(waypoint).collect(),
            turns: self.turns.iter().enumerate().map(turn).collect(),
        }
    }
}

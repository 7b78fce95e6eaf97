//! The route and the turn as lines of the plane: legs, arcs, corridor, wheel-over line, forwarding distance.

use wheelover_core::geo::{Plane, Point};
use wheelover_core::path::Path;
use wheelover_core::units::{Course, Radius, SignedAngle};
use wheelover_core::view::{RouteDocument, TurnView};

/// A turn in the plane.
#[derive(Clone, Debug, PartialEq)]
pub struct DrawnTurn {
    /// Index of its waypoint.
    pub waypoint: usize,
    /// Both legs and the arc.
    pub path: Path,
    /// Where the wheel-over line crosses the leg.
    pub wheel_over: Point,
}

impl DrawnTurn {
    fn of(view: &TurnView, plane: &Plane, course_in: Course, radius: Radius) -> Self {
        let course_out = course_in + SignedAngle::from_deg(view.turn);
        Self {
            waypoint: view.waypoint,
            path: Path::turn(course_in, plane.point(view.centre), radius, course_out),
            wheel_over: plane.point(view.wheel_over),
        }
    }
}

/// The route in a plane.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Shape {
    /// Waypoints: identifier and place.
    pub waypoints: Vec<(String, Point)>,
    /// Legs without their arcs: from, to; the leg that leads to waypoint `index + 1`.
    pub legs: Vec<(Point, Point)>,
    /// Turns.
    pub turns: Vec<DrawnTurn>,
    /// Limits to port and to starboard, each one line along the whole route.
    pub corridor: [Vec<Point>; 2],
}

impl Shape {
    /// Places a route in a plane.
    #[must_use]
    pub fn of(route: &RouteDocument, plane: &Plane) -> Self {
        let waypoints: Vec<(String, Point)> = route
            .waypoints
            .iter()
            .map(|w| (w.id.clone(), plane.point(w.position)))
            .collect();
        let course = |leg: usize| -> f64 {
            let given = route.waypoints.get(leg + 1).and_then(|w| w.course);
            given.unwrap_or_else(|| match (waypoints.get(leg), waypoints.get(leg + 1)) {
                (Some((_, from)), Some((_, to))) => from.bearing(*to),
                _ => 0.0,
            })
        };
        let turns: Vec<DrawnTurn> = route
            .turns
            .iter()
            .filter_map(|view| {
                let radius = Radius::from_nm(route.waypoints.get(view.waypoint)?.radius_nm?);
                let course_in = Course::from_deg(course(view.waypoint.saturating_sub(1)));
                Some(DrawnTurn::of(view, plane, course_in, radius))
            })
            .collect();
        let turn_at = |waypoint: usize| turns.iter().find(|turn| turn.waypoint == waypoint);
        let mut legs = Vec::new();
        let mut corridor = [Vec::new(), Vec::new()];
        for leg in 0..waypoints.len().saturating_sub(1) {
            let from = turn_at(leg).map_or(waypoints[leg].1, |turn| turn.path.leg_out().point);
            let to = turn_at(leg + 1).map_or(waypoints[leg + 1].1, |turn| turn.path.start());
            legs.push((from, to));
            let limits = limits(route, leg);
            let next = limits_after(route, leg);
            for side in 0..2 {
                let sign = if side == 0 { -1.0 } else { 1.0 };
                let square = course(leg) + 90.0;
                corridor[side].push(from.towards(square, sign * limits[side]));
                corridor[side].push(to.towards(square, sign * limits[side]));
                if let Some(turn) = turn_at(leg + 1) {
                    corridor[side].extend(turn.path.drawn(sign * limits[side], sign * next[side]));
                }
            }
        }
        Self {
            waypoints,
            legs,
            turns,
            corridor,
        }
    }
}

fn limits(route: &RouteDocument, leg: usize) -> [f64; 2] {
    route
        .waypoints
        .get(leg + 1)
        .map_or([0.0; 2], |waypoint| waypoint.xtd_m)
}

fn limits_after(route: &RouteDocument, leg: usize) -> [f64; 2] {
    if leg + 2 < route.waypoints.len() {
        limits(route, leg + 1)
    } else {
        limits(route, leg)
    }
}

/// Where the ship will be in `seconds` at a steady rate of turn (degrees a minute) and speed (metres a second).
#[must_use]
pub fn predicted(course: f64, rate: f64, speed: f64, seconds: f64) -> Vec<Point> {
    let steps = 24;
    let dt = seconds / f64::from(steps);
    let mut points = vec![Point::default()];
    let mut point = Point::default();
    for step in 0..steps {
        let middle = course + rate / 60.0 * dt * (f64::from(step) + 0.5);
        point = point.towards(middle, speed * dt);
        points.push(point);
    }
    points
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn prediction_without_turning_is_straight() {
        let points = predicted(90.0, 0.0, 5.0, 60.0);
        let last = points[points.len() - 1];
        assert!((last.east - 300.0).abs() < 1e-9 && last.north.abs() < 1e-9);
    }
}

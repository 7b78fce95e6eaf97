//! The route and the turn as lines of the plane: legs, arcs, corridor, wheel-over line, forwarding distance.

use wheelover_core::geo::{Plane, Point};
use wheelover_core::units::wrap_360;
use wheelover_core::view::{RouteDocument, TurnView};

/// A turn in the plane.
#[derive(Clone, Debug, PartialEq)]
pub struct Turn {
    /// Index of its waypoint.
    pub waypoint: usize,
    /// Where the wheel-over line crosses the leg.
    pub wheel_over: Point,
    /// Where the arc begins.
    pub start: Point,
    /// Where it ends.
    pub end: Point,
    /// Its centre.
    pub centre: Point,
    /// Signed change of course, degrees.
    pub sweep: f64,
    /// Its radius, metres.
    pub radius: f64,
    /// Course of the leg before it, degrees.
    pub course_in: f64,
}

impl Turn {
    fn of(view: &TurnView, plane: &Plane, course_in: f64) -> Self {
        let (centre, start) = (plane.point(view.centre), plane.point(view.start));
        Self {
            waypoint: view.waypoint,
            wheel_over: plane.point(view.wheel_over),
            start,
            end: plane.point(view.end),
            centre,
            sweep: view.turn,
            radius: centre.distance(start),
            course_in,
        }
    }

    /// Course after the turn, degrees.
    #[must_use]
    pub fn course_out(&self) -> f64 {
        wrap_360(self.course_in + self.sweep)
    }

    /// The arc, `offset` metres to starboard of the planned one at its begin, `offset_end` at its end.
    #[must_use]
    pub fn arc(&self, offset: f64, offset_end: f64) -> Vec<Point> {
        let first = self.centre.bearing(self.start);
        let steps = (libm::fabs(self.sweep) / 3.0) as u32 + 2;
        let side = if self.sweep > 0.0 { 1.0 } else { -1.0 };
        (0..=steps)
            .map(|step| {
                let part = f64::from(step) / f64::from(steps);
                let lateral = offset + (offset_end - offset) * part;
                let distance = libm::fmax(self.radius - side * lateral, 0.0);
                self.centre.towards(first + self.sweep * part, distance)
            })
            .collect()
    }

    /// Metres along the path from `ship` to the end of the arc; absent where that lies behind.
    #[must_use]
    pub fn remaining(&self, ship: Point) -> Option<f64> {
        let along = along(self.start, self.course_in, ship);
        let arc = self.radius * libm::fabs(self.sweep).to_radians();
        if along < 0.0 {
            return Some(arc - along);
        }
        let turned = wrap_360(
            (self.centre.bearing(ship) - self.centre.bearing(self.start))
                * if self.sweep > 0.0 { 1.0 } else { -1.0 },
        );
        (turned < libm::fabs(self.sweep)).then(|| arc - self.radius * turned.to_radians())
    }
}

/// Metres of `ship` beyond `point` in the direction `course`.
#[must_use]
pub fn along(point: Point, course: f64, ship: Point) -> f64 {
    let angle = course.to_radians();
    (ship.north - point.north) * libm::cos(angle) + (ship.east - point.east) * libm::sin(angle)
}

/// The route in a plane.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Shape {
    /// Waypoints: identifier and place.
    pub waypoints: Vec<(String, Point)>,
    /// Legs without their arcs: from, to; the leg that leads to waypoint `index + 1`.
    pub legs: Vec<(Point, Point)>,
    /// Turns.
    pub turns: Vec<Turn>,
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
        let turns: Vec<Turn> = route
            .turns
            .iter()
            .map(|view| Turn::of(view, plane, course(view.waypoint.saturating_sub(1))))
            .collect();
        let turn_at = |waypoint: usize| turns.iter().find(|turn| turn.waypoint == waypoint);
        let mut legs = Vec::new();
        let mut corridor = [Vec::new(), Vec::new()];
        for leg in 0..waypoints.len().saturating_sub(1) {
            let from = turn_at(leg).map_or(waypoints[leg].1, |turn| turn.end);
            let to = turn_at(leg + 1).map_or(waypoints[leg + 1].1, |turn| turn.start);
            legs.push((from, to));
            let limits = limits(route, leg);
            let next = limits_after(route, leg);
            for side in 0..2 {
                let sign = if side == 0 { -1.0 } else { 1.0 };
                let square = course(leg) + 90.0;
                corridor[side].push(from.towards(square, sign * limits[side]));
                corridor[side].push(to.towards(square, sign * limits[side]));
                if let Some(turn) = turn_at(leg + 1) {
                    corridor[side].extend(turn.arc(sign * limits[side], sign * next[side]));
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

    fn turn() -> Turn {
        // Northbound, then east: a turn to starboard of 1000 m radius.
        Turn {
            waypoint: 1,
            wheel_over: Point {
                north: -100.0,
                east: 0.0,
            },
            start: Point {
                north: 0.0,
                east: 0.0,
            },
            end: Point {
                north: 1000.0,
                east: 1000.0,
            },
            centre: Point {
                north: 0.0,
                east: 1000.0,
            },
            sweep: 90.0,
            radius: 1000.0,
            course_in: 0.0,
        }
    }

    #[test]
    fn arc_runs_from_start_to_end_and_starboard_is_inside() {
        let turn = turn();
        let arc = turn.arc(0.0, 0.0);
        assert!(arc[0].distance(turn.start) < 1e-6);
        assert!(arc[arc.len() - 1].distance(turn.end) < 1e-6);
        assert!((turn.arc(50.0, 50.0)[3].distance(turn.centre) - 950.0).abs() < 1e-6);
    }

    #[test]
    fn remaining_distance_counts_down_to_the_end_of_the_arc() {
        let turn = turn();
        let quarter = 1000.0 * core::f64::consts::FRAC_PI_2;
        let check = |north, east, expect: Option<f64>| {
            let got = turn.remaining(Point { north, east });
            match (got, expect) {
                (Some(got), Some(expect)) => assert!((got - expect).abs() < 1.0, "{got} {expect}"),
                (got, expect) => assert_eq!(got, expect),
            }
        };
        check(-100.0, 0.0, Some(quarter + 100.0));
        check(1.0, 0.0, Some(quarter));
        check(707.107, 292.893, Some(quarter / 2.0));
        check(1010.0, 1400.0, None);
    }

    #[test]
    fn prediction_without_turning_is_straight() {
        let points = predicted(90.0, 0.0, 5.0, 60.0);
        let last = points[points.len() - 1];
        assert!((last.east - 300.0).abs() < 1e-9 && last.north.abs() < 1e-9);
    }
}

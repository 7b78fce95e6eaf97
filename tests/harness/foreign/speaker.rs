//! Hull, sensors and chart system of a foreign ship: where she is, and what each says of it.

use super::Foreign;
use crate::serial::Line;
use std::collections::BTreeMap;
use wheelover_core::geo::{Plane, Point, Position};

/// The hull in the plane of the chart.
#[derive(Clone, Copy, Debug)]
struct Hull {
    place: Point,
    heading: f64,
    rate: f64,
    rudder: f64,
}

/// The track as the chart system has it; the waypoint is the plane's origin.
#[derive(Clone, Copy, Debug)]
struct Track {
    course: f64,
    next: f64,
    radius: f64,
    /// From tangent point to waypoint, metres.
    tangent: f64,
    side: f64,
    forwarding: f64,
}

fn unit(course: f64) -> Point {
    Point {
        north: course.to_radians().cos(),
        east: course.to_radians().sin(),
    }
}

impl Track {
    fn of(ship: &Foreign) -> Self {
        let radius = ship.radius * 1852.0;
        Self {
            course: ship.course,
            next: (ship.course + ship.turn).rem_euclid(360.0),
            radius,
            tangent: radius * (ship.turn.abs() / 2.0).to_radians().tan(),
            side: ship.turn.signum(),
            forwarding: ship.forwarding * ship.knots * 1852.0 / 3600.0,
        }
    }

    fn along(course: f64, place: Point) -> f64 {
        let unit = unit(course);
        place.north * unit.north + place.east * unit.east
    }

    /// Positive to starboard of a leg through the waypoint.
    fn across(course: f64, place: Point) -> f64 {
        Self::along(course + 90.0, place)
    }

    fn centre(&self) -> Point {
        let (leg, to_centre) = (unit(self.course), unit(self.course + 90.0 * self.side));
        Point {
            north: -self.tangent * leg.north + self.radius * to_centre.north,
            east: -self.tangent * leg.east + self.radius * to_centre.east,
        }
    }

    fn situation(&self, place: Point) -> u8 {
        if Self::along(self.next, place) >= self.tangent {
            return 5;
        }
        match Self::along(self.course, place) + self.tangent {
            ahead if ahead >= 0.0 => 4,
            ahead if ahead >= -self.forwarding => 3,
            _ => 2,
        }
    }

    /// Distances for display and for control (XTE and PNEY,001), positive to starboard.
    fn distances(&self, situation: u8, place: Point) -> (f64, f64) {
        let next = Self::across(self.next, place);
        match situation {
            4 => {
                let off = self.radius - place.distance(self.centre());
                (off * self.side, next)
            }
            5 => (next, next),
            _ => {
                let leg = Self::across(self.course, place);
                (leg, leg)
            }
        }
    }
}

/// `1234.56789,N` of degrees; `width` is 2 for a latitude, 3 for a longitude.
fn angle(degrees: f64, width: usize, sides: [char; 2]) -> String {
    let minutes = degrees.abs() * 60.0;
    let whole = (minutes / 60.0).floor();
    let side = sides[usize::from(degrees < 0.0)];
    format!("{whole:0width$}{:08.5},{side}", minutes - whole * 60.0)
}

fn place(position: Position) -> String {
    format!(
        "{},{}",
        angle(position.lat, 2, ['N', 'S']),
        angle(position.lon, 3, ['E', 'W'])
    )
}

/// The ship, and the far ends of the autopilot's lines.
pub(super) struct Speaker {
    ship: Foreign,
    track: Track,
    plane: Plane,
    hull: Hull,
    pub(super) lines: BTreeMap<&'static str, Line>,
}

impl Speaker {
    pub(super) fn new(ship: &Foreign, lines: BTreeMap<&'static str, Line>) -> Self {
        let track = Track::of(ship);
        let speed = ship.knots * 1852.0 / 3600.0;
        let (leg, starboard) = (unit(ship.course), unit(ship.course + 90.0));
        let back = track.tangent + track.forwarding + ship.lead * speed;
        Self {
            hull: Hull {
                place: Point {
                    north: ship.beside * starboard.north - back * leg.north,
                    east: ship.beside * starboard.east - back * leg.east,
                },
                heading: ship.course,
                rate: 0.0,
                rudder: 0.0,
            },
            track,
            plane: Plane::at(Position {
                lat: 59.8,
                lon: 24.9,
            }),
            ship: ship.clone(),
            lines,
        }
    }

    pub(super) fn sail(&mut self, order: f64, dt: f64) {
        let hull = &mut self.hull;
        hull.rudder += (order - hull.rudder).clamp(-5.0 * dt, 5.0 * dt);
        let turn = self.ship.gain * hull.rudder - hull.rate;
        hull.rate += turn / self.ship.time_constant * dt;
        hull.heading = (hull.heading + hull.rate * dt).rem_euclid(360.0);
        let speed = self.ship.knots * 1852.0 / 3600.0;
        let ahead = unit(hull.heading);
        hull.place.north += speed * ahead.north * dt;
        hull.place.east += speed * ahead.east * dt;
    }

    /// What sensors and, where it controls, the chart system say now.
    pub(super) fn bodies(&self, tick: u64, controls: bool) -> Vec<(&'static str, String)> {
        let (hull, knots) = (&self.hull, self.ship.knots);
        let mut said = vec![
            ("gyro1", format!("HEHDT,{:.2},T", hull.heading)),
            ("gyro1", format!("HEROT,{:05.1},A", hull.rate * 60.0)),
            ("gyro2", format!("HEHDT,{:.2},T", hull.heading)),
            ("gear", format!("IIRSA,{:.1},A,,V", hull.rudder)),
        ];
        if tick.is_multiple_of(10) {
            let clock = format!("{:06}.00", tick / 10 % 60);
            let here = |place| self.plane.position(place);
            let beside = hull.place.towards(hull.heading + 90.0, self.ship.receiver);
            let ground = format!(
                "VTG,{:.1},T,,M,{knots:.1},N,{:.1},K,D",
                hull.heading,
                knots * 1.852
            );
            said.push(("gps", format!("GPGLL,{},{clock},A,D", place(here(beside)))));
            said.push(("gps", format!("GP{ground}")));
            said.push((
                "log",
                format!("VDVHW,,T,,M,{knots:.1},N,{:.1},K", knots * 1.852),
            ));
            for body in self.chart(controls) {
                said.push(("ecdis", body));
            }
            said.push((
                "ecdis",
                format!("EIGLL,{},{clock},A,D", place(here(hull.place))),
            ));
            said.push(("ecdis", format!("EI{ground}")));
        }
        said
    }

    fn chart(&self, controls: bool) -> [String; 4] {
        let track = &self.track;
        let situation = track.situation(self.hull.place);
        let (display, control) = track.distances(situation, self.hull.place);
        let miles = |metres: f64| {
            // The side to which to steer.
            let side = if metres > 0.0 { 'L' } else { 'R' };
            format!("{:.4},{side}", metres.abs() / 1852.0)
        };
        let turning = matches!(situation, 3 | 4);
        let htc = if controls {
            let radius = if turning {
                format!("{:.3}", self.ship.radius)
            } else {
                String::new()
            };
            let course = if situation == 2 {
                track.course
            } else {
                track.next
            };
            format!("EIHTC,V,,,T,R,,,{radius},,,,{course:.1},T,C")
        } else {
            "EIHTC,V,,,S,N,,,,,,,,T,C".to_string()
        };
        let centre = if turning && controls {
            place(self.plane.position(track.centre()))
        } else {
            ",,,".to_string()
        };
        let waypoint = if situation == 5 { "002" } else { "001" };
        [
            htc,
            format!("EIXTE,A,A,{},N,D", miles(display)),
            format!("PNEY,001,A,A,{},N,D", miles(control)),
            format!("PNEY,002,{centre},{waypoint}"),
        ]
    }

    /// Situation, heading in degrees, and metres off leg or arc.
    pub(super) fn seen(&self) -> (u8, f64, f64) {
        let situation = self.track.situation(self.hull.place);
        let (off, _) = self.track.distances(situation, self.hull.place);
        (situation, self.hull.heading, off)
    }

    pub(super) fn say(&mut self, port: &str, said: &str) {
        if let Some(line) = self.lines.get_mut(port) {
            if said.starts_with('$') {
                line.send(format!("{said}\r\n").as_bytes());
            } else {
                line.say(said);
            }
        }
    }
}

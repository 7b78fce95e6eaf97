//! The ship of a mended dialogue: she sails the printed leg of 245 degrees, the arc about the printed centre and the leg
//! of 280 degrees, at a distance beside them, whatever is ordered.

use std::time::{Duration, Instant};
use wheelover_core::geo::{Plane, Point, Position};

const MILE: f64 = 1852.0;
/// Of document N, 2.1.3.
const LEG: f64 = 245.0;
const NEXT: f64 = 280.0;
const RADIUS: f64 = 0.35 * MILE;
const CENTRE: Position = Position {
    lat: 62.0 + 35.234 / 60.0,
    lon: -(123.0 + 43.231 / 60.0),
};
/// From wheel-over to the arc, seconds.
pub(super) const FORWARDING: f64 = 5.0;
/// In so many seconds she comes from her distance to the one of 2.1.4 and 2.1.5.
const NEARER: f64 = 10.0;
const LAST: f64 = 0.001 * MILE;

/// A ship under way.
#[derive(Clone, Debug)]
pub(super) struct Ship {
    begun: Instant,
    /// None where it is the path's.
    heading: Option<f64>,
    course: Option<f64>,
    knots: f64,
    /// Metres to port of leg and arc.
    beside: f64,
    /// Seconds from the start to the arc.
    lead: f64,
}

/// Part of the path.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(super) enum Part {
    Leg,
    WheelOver,
    Arc,
    Next,
}

impl Ship {
    /// As the cells of a dialogue say, from now on.
    pub(super) fn new(cells: &[&str]) -> Self {
        let number = |cell: &str| cell.parse::<f64>().unwrap();
        Self {
            begun: Instant::now(),
            heading: cells[0].parse().ok(),
            course: cells[1].parse().ok(),
            knots: number(cells[2]),
            beside: number(cells[3]) * MILE,
            lead: number(cells[4]),
        }
    }

    pub(super) fn sailed(&self) -> f64 {
        self.begun.elapsed().as_secs_f64()
    }

    fn speed(&self) -> f64 {
        self.knots * MILE / 3600.0
    }

    /// Degrees of the arc that lie behind her; negative before it.
    fn turned(&self, at: f64) -> f64 {
        ((at - self.lead) * self.speed() / RADIUS).to_degrees()
    }

    pub(super) fn part(&self, at: f64) -> Part {
        match self.turned(at) {
            turned if turned >= NEXT - LEG => Part::Next,
            turned if turned >= 0.0 => Part::Arc,
            _ if at >= self.lead - FORWARDING => Part::WheelOver,
            _ => Part::Leg,
        }
    }

    /// Course of the path where she is.
    fn tangent(&self, at: f64) -> f64 {
        LEG + self.turned(at).clamp(0.0, NEXT - LEG)
    }

    pub(super) fn heading(&self, at: f64) -> f64 {
        self.heading.unwrap_or_else(|| self.tangent(at))
    }

    /// Degrees a minute.
    pub(super) fn rate(&self, at: f64) -> f64 {
        (self.heading(at + 0.1) - self.heading(at)) * 600.0
    }

    fn place(&self, at: f64) -> Point {
        let centre = Point::default();
        if let Some(course) = self.course.filter(|course| *course != LEG) {
            // Not along the leg: she passes its begin.
            return centre.towards(course, at * self.speed());
        }
        let after = ((at - self.lead) / NEARER).clamp(0.0, 1.0);
        let beside = if self.beside > 0.0 {
            self.beside + (LAST - self.beside) * after
        } else {
            0.0
        };
        let tangent = self.tangent(at);
        let beside = centre.towards(tangent - 90.0, RADIUS + beside);
        let behind = self.turned(at).min(0.0) + (self.turned(at) - (NEXT - LEG)).max(0.0);
        beside.towards(tangent, behind.to_radians() * RADIUS)
    }

    fn course(&self, at: f64) -> f64 {
        let (a, b) = (self.place(at - 0.5), self.place(at + 0.5));
        let course = (b.east - a.east).atan2(b.north - a.north);
        course.to_degrees().rem_euclid(360.0)
    }

    /// Metres to starboard of a leg of that course, which touches the arc.
    fn across(&self, at: f64, course: f64) -> f64 {
        let start = Point::default().towards(course - 90.0, RADIUS);
        let (place, beam) = (self.place(at), (course + 90.0).to_radians());
        (place.north - start.north) * beam.cos() + (place.east - start.east) * beam.sin()
    }

    /// A line with its places filled.
    pub(super) fn fill(&self, line: &str, at: f64) -> String {
        let place = Plane::at(CENTRE).position(self.place(at));
        let off_arc = RADIUS - self.place(at).distance(Point::default());
        let fill = [
            ("{position}", written(place)),
            ("{time}", format!("1234{:02}.00", at as u64 % 60)),
            ("{course}", format!("{:.1}", self.course(at))),
            ("{knots}", format!("{:.1}", self.knots)),
            ("{kmh}", format!("{:.1}", self.knots * MILE / 1000.0)),
            ("{arc}", distance(off_arc)),
            ("{next}", distance(self.across(at, NEXT))),
        ];
        fill.iter().fold(line.to_owned(), |line, (name, text)| {
            line.replace(name, text)
        })
    }
}

/// Miles and the side to which to steer.
fn distance(metres: f64) -> String {
    let side = if metres > 0.0 { 'L' } else { 'R' };
    format!("{:.4},{side}", metres.abs() / MILE)
}

fn written(place: Position) -> String {
    let minutes = |degrees: f64| degrees.abs().fract() * 60.0;
    format!(
        "{:02.0}{:08.5},N,{:03.0}{:08.5},W",
        place.lat.abs().floor(),
        minutes(place.lat),
        place.lon.abs().floor(),
        minutes(place.lon)
    )
}

/// Waits until she has sailed so long.
pub(super) fn wait(ship: &Ship, until: f64) {
    std::thread::sleep(Duration::from_secs_f64((until - ship.sailed()).max(0.0)));
}

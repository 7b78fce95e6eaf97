//! The route on the plan: legs, corridor, waypoints; of the turn the wheel-over line, F, arc and radius centre.

use super::frame::Frame;
use super::scene::Scene;
use super::shapes::{DrawnTurn, Shape};
use crate::drawing::Drawing;
use crate::format::{self, fixed};
use wheelover_core::geo::Point;
use wheelover_core::path::Path;

/// The route and the turn that comes or is sailed.
pub(super) fn draw(scene: &Scene<'_>, drawing: &mut Drawing) {
    let frame = &scene.frame;
    let shape = Shape::of(scene.route, &frame.plane);
    let leg = scene.chart.map_or(0, |chart| chart.leg);
    for side in &shape.corridor {
        drawing.path("corridor", "corridor", &frame.path(side));
    }
    for (index, (from, to)) in shape.legs.iter().enumerate() {
        let (class, plan) = match index {
            _ if scene.chart.is_none() => ("route", ""),
            index if index == leg => ("route active", "leg"),
            index if index == leg + 1 => ("route", "next-leg"),
            _ => ("route far", ""),
        };
        drawing.path(class, plan, &frame.path(&[*from, *to]));
    }
    let next = |turn: &&DrawnTurn| turn.waypoint == leg + 1;
    for other in shape.turns.iter().filter(|turn| !next(turn)) {
        drawing.path("route far", "", &frame.path(&other.path.drawn(0.0, 0.0)));
    }
    for (index, (name, place)) in shape.waypoints.iter().enumerate() {
        waypoint(frame, drawing, name, *place, index == leg + 1);
    }
    let coming = shape.turns.iter().find(next);
    if let Some(coming) = coming {
        let name = shape.waypoints.get(leg + 1).map(|(name, _)| name.as_str());
        turn(frame, drawing, &coming.path, Some(coming.wheel_over), name);
    }
    centre(scene, drawing, coming.map(|turn| &turn.path));
}

fn waypoint(frame: &Frame, drawing: &mut Drawing, name: &str, place: Point, active: bool) {
    let (x, y) = frame.point(place);
    drawing.circle("wp", (x, y), 7.0);
    if active {
        drawing.circle("wp next", (x, y), 12.0);
    }
    drawing.word(
        "wp-name",
        "middle",
        (x, y + 28.0),
        format::waypoint(Some(name)),
    );
}

/// The turn that comes or is sailed: arc and its ends, and where the wheel-over line is known, that and the forwarding distance.
pub(super) fn turn(
    frame: &Frame,
    drawing: &mut Drawing,
    path: &Path,
    wheel_over: Option<Point>,
    name: Option<&str>,
) {
    let unit = |pixels: f64| pixels / frame.scale;
    let (start, out) = (path.start(), path.leg_out());
    let (course, side) = (path.course_in.deg(), -90.0 * path.side());
    drawing.path("arc", "arc", &frame.path(&path.drawn(0.0, 0.0)));
    let reach = |leg: Path| frame.across(leg.point, leg.course_in.deg(), unit(22.0));
    drawing.path("reach", "", &reach(out));
    let Some(wheel_over) = wheel_over else {
        return;
    };
    drawing.path("reach", "", &reach(Path::leg(start, path.course_in)));
    // The bracket of F stands outside the turn, beside the leg.
    let beside = |point: Point, pixels: f64| point.towards(course + side, unit(pixels));
    let bracket = frame.path(&[
        beside(wheel_over, 14.0),
        beside(wheel_over, 22.0),
        beside(start, 22.0),
        beside(start, 14.0),
    ]);
    let middle = Point {
        north: (wheel_over.north + start.north) / 2.0,
        east: (wheel_over.east + start.east) / 2.0,
    };
    let (fx, fy) = frame.point(beside(middle, 36.0));
    let (wx, wy) = frame.point(wheel_over.towards(course - side, unit(56.0)));
    let over = frame.across(wheel_over, course, unit(36.0));
    drawing.path("wol", "wheel-over", &over);
    drawing.path("forward", "forwarding-distance", &bracket);
    drawing.word("plan-ink", "middle", (fx, fy + 5.0), "F");
    let name = format!("WOL {}", format::waypoint(name));
    drawing.word("plan-ink", "middle", (wx, wy + 5.0), name);
}

/// The radius centre as the chart system says it, with the radius it commands; only while it says so (PNEY,002).
pub(super) fn centre(scene: &Scene<'_>, drawing: &mut Drawing, turn: Option<&Path>) {
    let (frame, readings) = (&scene.frame, scene.readings);
    let Some(position) = readings.centre.value else {
        return;
    };
    let place = frame.plane.point(position);
    let (x, y) = frame.point(place);
    if let Some(turn) = turn {
        let radii = frame.path(&[turn.start(), place, turn.leg_out().point]);
        drawing.path("radius", "", &radii);
    }
    drawing
        .open("path")
        .attribute("class", "cross")
        .attribute("data-plan", "radius-centre");
    drawing.attribute("data-lat", fixed(position.lat, 6));
    drawing.attribute("data-lon", fixed(position.lon, 6));
    let [left, middle, across, top] = [x - 8.0, y, x, y - 8.0].map(|value| fixed(value, 1));
    let cross = format_args!("M{left} {middle}h16M{across} {top}v16");
    drawing.attribute("d", cross).plain("/>");
    let text = format!("CENTRE R {}", format::radius(readings.radius.value));
    drawing.word("plan-ink", "start", (x + 12.0, y - 8.0), text);
}

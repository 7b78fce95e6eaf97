//! The path on the plan where a foreign chart system has the route: as much of it as its sentences tell (AP-23).

use super::scene::Scene;
use super::track;
use crate::drawing::Drawing;
use wheelover_core::route::foreign::Told;

/// A line whose end nobody told goes beyond every range, metres.
const BEYOND: f64 = 60_000.0;

/// Leg, corridor, arc, next leg, centre and, once it was passed, the wheel-over line.
pub(super) fn draw(scene: &Scene<'_>, told: &Told, drawing: &mut Drawing) {
    let frame = &scene.frame;
    // Each line begins abeam of the ship: what lies behind her was not told.
    let path = |starboard: f64| {
        let mut points = Vec::new();
        points.extend(told.leg.map(|leg| leg.at(0.0, starboard)));
        if let Some(turn) = &told.turn {
            points.extend(turn.drawn(starboard, starboard));
        }
        let last = told.turn.map(|turn| turn.leg_out()).or(told.leg);
        points.extend(last.map(|leg| leg.at(BEYOND, starboard)));
        frame.path(&points)
    };
    if let Some(limit) = told.limit {
        for side in [-limit.m(), limit.m()] {
            drawing.path("corridor", "corridor", &path(side));
        }
    }
    if let Some(leg) = told.leg {
        let end = told.turn.map_or(leg.at(BEYOND, 0.0), |turn| turn.start());
        drawing.path("route active", "leg", &frame.path(&[leg.point, end]));
    }
    if let Some(turn) = &told.turn {
        let out = turn.leg_out();
        let next = [out.point, out.at(BEYOND, 0.0)];
        drawing.path("route", "next-leg", &frame.path(&next));
        let wheel_over = told.wheel_over.map(|(_, point)| point);
        let name = scene.readings.waypoint.value.as_deref();
        track::turn(frame, drawing, turn, wheel_over, name);
    }
    track::centre(scene, drawing, told.turn.as_ref());
    if told.leg.is_some() || told.turn.is_some() {
        drawing.word(
            "plan-ink",
            "middle",
            (frame.size.0 / 2.0, frame.size.1 - 34.0),
            "PATH FROM HTC, XTE, PNEY",
        );
    }
}

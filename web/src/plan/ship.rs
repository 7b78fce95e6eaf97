//! Own ship: outline to scale, heading line, vector over ground, predicted path, track made good.

use super::frame::Frame;
use super::scene::{Scene, vector_minutes};
use super::shapes::predicted;
use crate::drawing::Drawing;
use crate::format::fixed;
use crate::reading::state_name;
use wheelover_core::geo::Point;
use wheelover_core::view::Outline;

/// Below this length on the screen the ship is a symbol.
const SMALL: f64 = 24.0;

/// Own ship and her lines. Without a position there is no ship; without a heading no outline.
pub(super) fn draw(scene: &Scene<'_>, drawing: &mut Drawing) {
    let (frame, readings) = (&scene.frame, scene.readings);
    let mut made_good = String::new();
    for dot in scene.trail.dots() {
        frame.go(&mut made_good, dot.begins, frame.plane.point(dot.place));
    }
    drawing.path("trail", "track-made-good", &made_good);
    let Some(position) = readings.position.value else {
        return;
    };
    let ship = frame.plane.point(position);
    let seconds = vector_minutes(scene.range_nm) * 60.0;
    if let Some((course, speed)) = readings.cog.value.zip(readings.speed()) {
        if let Some(rate) = readings.rot.value {
            let points: Vec<Point> = predicted(course, rate, speed, seconds)
                .into_iter()
                .map(|p| Point {
                    north: ship.north + p.north,
                    east: ship.east + p.east,
                })
                .collect();
            drawing.path("predictor", "predictor", &frame.path(&points));
        }
        let tip = ship.towards(course, speed * seconds);
        drawing.path("vector", "vector", &frame.path(&[ship, tip]));
        // Two arrow-heads: stabilised over ground.
        let heads = arrow(frame, tip, course, 0.0) + &arrow(frame, tip, course, 6.0);
        drawing.path("arrow", "", &heads);
    }
    let small = scene.ship.length_m * frame.scale < SMALL;
    if let Some(heading) = readings.heading.value {
        let line = frame.ray(ship, heading, 60_000.0);
        drawing.path("headline", "heading-line", &line);
        let beam = frame.across(ship, heading, 9.0 / frame.scale);
        drawing.path("headline", "", &beam);
        drawing
            .open("path")
            .attribute("class", "hull")
            .attribute("data-plan", "own-ship")
            .attribute("data-state", state_name(readings.heading.state))
            .number("data-heading", heading)
            .attribute("data-lat", fixed(position.lat, 6))
            .attribute("data-lon", fixed(position.lon, 6));
        let outline = if small {
            String::new()
        } else {
            hull(frame, scene.ship, ship, heading)
        };
        drawing.attribute("d", outline).plain("/>");
    }
    if readings.heading.value.is_none() || small {
        let place = frame.point(ship);
        drawing.circle("hull", place, 5.0);
        drawing.circle("hull", place, 10.0);
    }
}

/// An arrow-head that points in the direction `course`, so many screen units behind `tip`.
fn arrow(frame: &Frame, tip: Point, course: f64, back: f64) -> String {
    let wing = 7.0 / frame.scale;
    let at = tip.towards(course + 180.0, back / frame.scale);
    frame.path(&[
        at.towards(course + 145.0, wing),
        at,
        at.towards(course - 145.0, wing),
    ])
}

/// The outline, true to scale.
fn hull(frame: &Frame, outline: Outline, ship: Point, heading: f64) -> String {
    let corner = |ahead: f64, side: f64| {
        ship.towards(heading, ahead * outline.length_m)
            .towards(heading + 90.0, side * outline.beam_m)
    };
    frame.path(&[
        corner(0.5, 0.0),
        corner(0.34, 0.5),
        corner(-0.46, 0.5),
        corner(-0.5, 0.38),
        corner(-0.5, -0.38),
        corner(-0.46, -0.5),
        corner(0.34, -0.5),
        corner(0.5, 0.0),
    ]) + "Z"
}

//! Own ship: outline to scale, heading line, vector over ground, predicted path, track made good.

use super::frame::Frame;
use super::shapes::predicted;
use super::view::vector_minutes;
use crate::deck::Deck;
use crate::reading::Readings;
use leptos::prelude::*;
use wheelover_core::geo::Point;

/// Length and breadth drawn, metres: the built-in ship's.
const LENGTH: f64 = 161.0;
const BREADTH: f64 = 23.0;
/// Below this length on the screen the ship is a symbol.
const SMALL: f64 = 24.0;

/// Own ship and her lines. Without a position there is no ship; without a heading no outline.
#[component]
pub(super) fn OwnShip(frame: Frame, range_nm: f64) -> impl IntoView {
    let deck = Deck::here();
    let trail = deck.with_fold(|fold| {
        let points: Vec<Point> = fold.trail.iter().map(|p| frame.plane.point(*p)).collect();
        frame.path(&points)
    });
    let drawn = deck
        .readings
        .with_untracked(|readings| draw(readings, &frame, range_nm));
    view! {
        <path class="trail" data-plan="track-made-good" d=trail/>
        {drawn}
    }
}

fn draw(readings: &Readings, frame: &Frame, range_nm: f64) -> Option<impl IntoView + use<>> {
    let position = readings.position.value?;
    let ship = frame.plane.point(position);
    let (x, y) = frame.point(ship);
    let seconds = vector_minutes(range_nm) * 60.0;
    let speed = readings.sog.value.map(|knots| knots * 1852.0 / 3600.0);
    let vector = readings.cog.value.zip(speed).map(|(course, speed)| {
        let tip = ship.towards(course, speed * seconds);
        let wing = 7.0 / frame.scale;
        let head = |back: f64| {
            let at = tip.towards(course + 180.0, back / frame.scale);
            frame.path(&[
                at.towards(course + 145.0, wing),
                at,
                at.towards(course - 145.0, wing),
            ])
        };
        // Two arrow-heads: stabilised over ground.
        view! {
            <path class="vector" data-plan="vector" d=frame.path(&[ship, tip])/>
            <path class="arrow" d=head(0.0) + &head(6.0)/>
        }
    });
    let curve =
        readings
            .cog
            .value
            .zip(speed)
            .zip(readings.rot.value)
            .map(|((course, speed), rate)| {
                let points: Vec<Point> = predicted(course, rate, speed, seconds)
                    .into_iter()
                    .map(|p| Point {
                        north: ship.north + p.north,
                        east: ship.east + p.east,
                    })
                    .collect();
                view! { <path class="predictor" data-plan="predictor" d=frame.path(&points)/> }
            });
    let headed = readings.heading.value.map(|heading| {
        let beam = 9.0 / frame.scale;
        view! {
            <path class="headline" data-plan="heading-line" d=frame.ray(ship, heading, 60_000.0)/>
            <path class="headline" d=frame.across(ship, heading, beam)/>
            <path class="hull" data-plan="own-ship" data-heading=format!("{heading:.1}") d=hull(frame, ship, heading)/>
        }
    });
    let simple = readings.heading.value.is_none() || LENGTH * frame.scale < SMALL;
    let rings = simple.then(|| {
        view! {
            <circle class="hull" cx=format!("{x:.1}") cy=format!("{y:.1}") r="5"/>
            <circle class="hull" cx=format!("{x:.1}") cy=format!("{y:.1}") r="10"/>
        }
    });
    Some(view! {
        {curve}
        {vector}
        {headed}
        {rings}
    })
}

/// The outline, true to scale; an empty path where it would be too small to see.
fn hull(frame: &Frame, ship: Point, heading: f64) -> String {
    if LENGTH * frame.scale < SMALL {
        return String::new();
    }
    let corner = |ahead: f64, side: f64| {
        ship.towards(heading, ahead * LENGTH)
            .towards(heading + 90.0, side * BREADTH)
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

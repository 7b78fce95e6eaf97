//! The route on the plan: legs, corridor, waypoints; of the turn the wheel-over line, F, arc and radius centre.

use super::frame::Frame;
use super::shapes::{Shape, Turn};
use crate::deck::Deck;
use crate::format;
use leptos::prelude::*;
use wheelover_core::geo::Point;

/// The route and the turn that comes or is sailed.
#[component]
pub(super) fn Track(frame: Frame) -> impl IntoView {
    let deck = Deck::here();
    let shape = deck
        .route
        .with_untracked(|route| Shape::of(route, &frame.plane));
    let chart = deck
        .own
        .with_untracked(|own| own.as_ref().and_then(|s| s.chart.clone()));
    let leg = chart.as_ref().map_or(0, |chart| chart.leg);
    let legs: Vec<_> = shape
        .legs
        .iter()
        .enumerate()
        .map(|(index, (from, to))| {
            let (class, plan) = match index {
                _ if chart.is_none() => ("route", None),
                index if index == leg => ("route active", Some("leg")),
                index if index == leg + 1 => ("route", Some("next-leg")),
                _ => ("route far", None),
            };
            view! { <path class=class data-plan=plan d=frame.path(&[*from, *to])/> }
        })
        .collect();
    let arcs: Vec<_> = shape
        .turns
        .iter()
        .filter(|turn| turn.waypoint != leg + 1)
        .map(|turn| view! { <path class="route far" d=frame.path(&turn.arc(0.0, 0.0))/> })
        .collect();
    let corridor = shape
        .corridor
        .clone()
        .map(|side| view! { <path class="corridor" data-plan="corridor" d=frame.path(&side)/> });
    let waypoints: Vec<_> = shape
        .waypoints
        .iter()
        .enumerate()
        .map(|(index, (name, place))| waypoint(&frame, name, *place, index == leg + 1))
        .collect();
    let turn = shape.turns.iter().find(|turn| turn.waypoint == leg + 1);
    let name = shape
        .waypoints
        .get(leg + 1)
        .map(|(name, _)| name.clone())
        .unwrap_or_default();
    let drawn = turn.map(|turn| view! { <TurnShape frame turn=turn.clone() name/> });
    view! {
        {corridor}
        {legs}
        {arcs}
        {waypoints}
        {drawn}
        <Centre frame turn=turn.cloned()/>
    }
}

fn waypoint(frame: &Frame, name: &str, place: Point, active: bool) -> impl IntoView + use<> {
    let (x, y) = frame.point(place);
    let (cx, cy) = (format!("{x:.1}"), format!("{y:.1}"));
    let second =
        active.then(|| view! { <circle class="wp next" cx=cx.clone() cy=cy.clone() r="12"/> });
    view! {
        <circle class="wp" cx=cx.clone() cy=cy.clone() r="7"/>
        {second}
        <text x=format!("{x:.1}") y=format!("{:.1}", y + 28.0) text-anchor="middle">
            {format::waypoint(Some(name))}
        </text>
    }
}

/// The turn that comes or is sailed: arc, wheel-over line, forwarding distance, its ends.
#[component]
fn TurnShape(frame: Frame, turn: Turn, name: String) -> impl IntoView {
    let unit = |pixels: f64| pixels / frame.scale;
    let side = if turn.sweep > 0.0 { -90.0 } else { 90.0 };
    // The bracket of F stands outside the turn, beside the leg.
    let beside = |point: Point, pixels: f64| point.towards(turn.course_in + side, unit(pixels));
    let bracket = frame.path(&[
        beside(turn.wheel_over, 14.0),
        beside(turn.wheel_over, 22.0),
        beside(turn.start, 22.0),
        beside(turn.start, 14.0),
    ]);
    let middle = Point {
        north: (turn.wheel_over.north + turn.start.north) / 2.0,
        east: (turn.wheel_over.east + turn.start.east) / 2.0,
    };
    let (fx, fy) = frame.point(beside(middle, 36.0));
    let (wx, wy) = frame.point(turn.wheel_over.towards(turn.course_in - side, unit(56.0)));
    view! {
        <path class="arc" data-plan="arc" d=frame.path(&turn.arc(0.0, 0.0))/>
        <path class="wol" data-plan="wheel-over" d=frame.across(turn.wheel_over, turn.course_in, unit(36.0))/>
        <path class="forward" data-plan="forwarding-distance" d=bracket/>
        <path class="reach" d=frame.across(turn.start, turn.course_in, unit(22.0))/>
        <path class="reach" d=frame.across(turn.end, turn.course_out(), unit(22.0))/>
        <text class="plan-ink" x=format!("{fx:.1}") y=format!("{:.1}", fy + 5.0) text-anchor="middle">"F"</text>
        <text class="plan-ink" x=format!("{wx:.1}") y=format!("{:.1}", wy + 5.0) text-anchor="middle">
            {format!("WOL {}", format::waypoint(Some(&name)))}
        </text>
    }
}

/// The radius centre as the chart system says it, with the radius it commands; only while it says so (PNEY,002).
#[component]
fn Centre(frame: Frame, turn: Option<Turn>) -> impl IntoView {
    let deck = Deck::here();
    let (centre, radius) = deck
        .readings
        .with_untracked(|readings| (readings.centre.value, readings.radius.value));
    centre.map(|position| {
        let place = frame.plane.point(position);
        let (x, y) = frame.point(place);
        let radii = turn.map(|turn| {
            let path = frame.path(&[turn.start, place, turn.end]);
            view! { <path class="radius" d=path/> }
        });
        view! {
            {radii}
            <path
                class="cross"
                data-plan="radius-centre"
                data-lat=format!("{:.6}", position.lat)
                data-lon=format!("{:.6}", position.lon)
                d=format!("M{:.1} {y:.1}h16M{x:.1} {:.1}v16", x - 8.0, y - 8.0)
            />
            <text class="plan-ink" x=format!("{:.1}", x + 12.0) y=format!("{:.1}", y - 8.0)>
                {format!("CENTRE R {}", format::radius(radius))}
            </text>
        }
    })
}

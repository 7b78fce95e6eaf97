//! The bottom strip: where from, where to, when over, how round.

use crate::deck::Deck;
use crate::plan::shapes::Shape;
use crate::value::{Value, shown};
use crate::{format, situation};
use leptos::prelude::*;
use wheelover_core::geo::{Plane, Point};

/// What the route says about the ship's place on it.
#[derive(Clone, Debug, Default, PartialEq)]
struct Progress {
    from: String,
    next: String,
    wheel_over: Option<f64>,
    turn_end: Option<f64>,
    next_track: Option<f64>,
    to_go: Option<f64>,
    eta: Option<f64>,
}

fn progress(deck: Deck) -> Progress {
    let chart = deck
        .own
        .with(|own| own.as_ref().and_then(|s| s.chart.clone()));
    let Some(chart) = chart else {
        return told(deck);
    };
    // TCS-2: at the end of the route there is no way to go.
    if chart.situation == situation::END {
        return Progress::default();
    }
    let name = |index: usize| {
        deck.route
            .with(|route| format::waypoint(route.waypoints.get(index).map(|w| w.id.as_str())))
    };
    let mut progress = Progress {
        from: name(chart.leg),
        next: name(chart.leg + 2),
        wheel_over: chart.wheel_over_s,
        ..Progress::default()
    };
    deck.readings.with(|readings| {
        let Some(position) = readings.position.value else {
            return;
        };
        let plane = Plane::at(position);
        let ship = plane.point(position);
        let speed = readings.speed().filter(|speed| *speed > 0.2);
        deck.route.with(|route| {
            let shape = Shape::of(route, &plane);
            if let Some((_, place)) = shape.waypoints.get(chart.leg + 1) {
                let metres = ship.distance(*place);
                progress.to_go = Some(metres);
                progress.eta = deck
                    .utc
                    .get()
                    .zip(speed)
                    .map(|(utc, speed)| utc + metres / speed);
            }
            if let Some(turn) = shape
                .turns
                .iter()
                .find(|turn| turn.waypoint == chart.leg + 1)
            {
                progress.next_track = Some(turn.path.leg_out().course_in.deg());
                if matches!(chart.situation, 3 | 4) {
                    progress.turn_end = turn
                        .path
                        .left(ship)
                        .zip(speed)
                        .map(|(metres, speed)| metres / speed);
                }
            }
        });
    });
    progress
}

/// What the sentences of a foreign chart system tell: neither names nor places of other waypoints (AP-23).
fn told(deck: Deck) -> Progress {
    if deck.link.get().lost() {
        return Progress::default();
    }
    let told = situation::told(deck);
    deck.readings.with(|readings| {
        let ship = Point::default(); // of a plane at her position
        let speed = readings
            .speed()
            .filter(|speed| *speed > 0.2 && readings.position.value.is_some());
        let left = told.turn.and_then(|turn| turn.left(ship)).zip(speed);
        Progress {
            wheel_over: told
                .wheel_over
                .map(|(at, _)| -(readings.now.since(at) as f64) / 1000.0),
            turn_end: left.map(|(metres, speed)| metres / speed),
            next_track: told.next_track.map(|track| track.deg()),
            ..Progress::default()
        }
    })
}

/// The bottom strip.
#[component]
pub(super) fn Strip() -> impl IntoView {
    let deck = Deck::here();
    let progress = Memo::new(move |_| progress(deck));
    let to = shown(|r| &r.waypoint, |id| format::waypoint(id.as_deref()));
    let radius = shown(|r| &r.radius, format::radius);
    let centre = shown(
        |r| &r.centre,
        |place| match place {
            Some(_) => {
                let (lat, lon) = format::position(place);
                format!("{lat}\n{lon}")
            }
            None => "- -".to_owned(),
        },
    );
    let passed = Memo::new(move |_| progress.with(|p| p.wheel_over.is_some_and(|s| s < 0.0)));
    let now = Memo::new(move |_| situation::current(deck));
    view! {
        <footer class="strip">
            <div>
                <p class="label">"SITUATION"</p>
                <p
                    class="number"
                    data-value="situation"
                    data-state=move || if now.get().is_some() { "valid" } else { "never" }
                    title=move || now.get().map_or("", situation::words)
                >
                    {move || now.get().map_or_else(|| "-".to_owned(), |n| n.to_string())}
                </p>
            </div>
            <Field label="FROM" text=Signal::derive(move || progress.with(|p| known(&p.from)))/>
            <div>
                <p class="label">"TO"</p>
                <p class="number"><Value name="waypoint" shown=to/></p>
            </div>
            <Field label="NEXT" text=Signal::derive(move || progress.with(|p| known(&p.next)))/>
            <div>
                <p class="label">{move || if passed.get() { "WOL passed" } else { "WOL in" }}</p>
                <p class="number">{move || progress.with(|p| format::span(p.wheel_over))}</p>
            </div>
            <Field label="TURN END in" text=Signal::derive(move || progress.with(|p| format::span(p.turn_end)))/>
            <div>
                <p class="label">"SET RAD"</p>
                <p class="number"><Value name="radius" shown=radius/><span class="unit">"NM"</span></p>
            </div>
            <div>
                <p class="label">"RADIUS CENTRE"</p>
                <p class="number two pre"><Value name="radius-centre" shown=centre/></p>
            </div>
            <div>
                <p class="label">"NEXT TRACK"</p>
                <p class="number">
                    {move || progress.with(|p| format::direction(p.next_track))}<span class="unit">"°T"</span>
                </p>
            </div>
            <div>
                <p class="label">"DTW "{move || to.with(|to| to.text.clone())}</p>
                <p class="number">
                    <span data-value="dtw">{move || progress.with(|p| format::miles(p.to_go))}</span>
                    <span class="unit">"NM"</span>
                </p>
            </div>
            <div>
                <p class="label">"ETA "{move || to.with(|to| to.text.clone())}</p>
                <p class="number" data-value="eta">{move || progress.with(|p| format::clock_minutes(p.eta))}</p>
            </div>
        </footer>
    }
}

fn known(text: &str) -> String {
    if text.is_empty() {
        format::NO_TEXT.to_owned()
    } else {
        text.to_owned()
    }
}

#[component]
fn Field(label: &'static str, text: Signal<String>) -> impl IntoView {
    view! {
        <div>
            <p class="label">{label}</p>
            <p class="number">{move || text.get()}</p>
        </div>
    }
}

//! The plan's frame on the screen: size, range, orientation, drawing.

use super::frame::{Frame, Orientation, RANGES};
use super::scene::{Scene, vector_minutes};
use crate::deck::{Deck, Greeting};
use crate::format;
use leptos::html::Div;
use leptos::prelude::*;
use wheelover_core::geo::Position;

/// The plan view.
#[component]
pub(crate) fn Plan() -> impl IntoView {
    let deck = Deck::here();
    let element = NodeRef::<Div>::new();
    let orientation = RwSignal::new(Orientation::North);
    let range = RwSignal::new(2_usize);
    let last_known = StoredValue::new(None::<Position>);
    let frame = move || {
        let size = element.get().map_or((860.0, 520.0), |element| {
            (
                f64::from(element.client_width()),
                f64::from(element.client_height()),
            )
        });
        if size.0 < 1.0 || size.1 < 1.0 {
            // Not laid out yet, or on its way out: the next readings try again.
            deck.readings.track();
            return None;
        }
        deck.readings.with(|readings| {
            if let Some(position) = readings.position.value {
                last_known.set_value(Some(position));
            }
            let ship = last_known
                .get_value()
                .or_else(|| deck.route.with(|r| r.waypoints.first().map(|w| w.position)))?;
            let heading = readings.heading.value.unwrap_or(0.0);
            let up = match orientation.get() {
                Orientation::North => 0.0,
                Orientation::Head => heading,
                Orientation::Course => readings.track.value.unwrap_or(heading),
            };
            Some(Frame::around(ship, size, RANGES[range.get()], up, heading))
        })
    };
    let drawing = move || {
        let Some(frame) = frame() else {
            return String::new();
        };
        let range_nm = RANGES[range.get()];
        let greeted = |greeting: &Option<Greeting>| greeting.as_ref().map(|greeting| greeting.ship);
        let ship = deck.greeting.with_untracked(greeted).unwrap_or_default();
        deck.readings.with_untracked(|readings| {
            deck.route.with_untracked(|route| {
                deck.own.with_untracked(|own| {
                    deck.with_fold(|fold| {
                        let chart = own.as_ref().and_then(|own| own.chart.as_ref());
                        let foreign = own.is_some() && chart.is_none();
                        let told = foreign.then(|| fold.told(readings.now, &frame.plane));
                        let trail = &fold.trail;
                        Scene {
                            frame,
                            range_nm,
                            ship,
                            readings,
                            route,
                            chart,
                            told,
                            trail,
                        }
                        .markup()
                    })
                })
            })
        })
    };
    let corner = move || {
        format!(
            "{} · RM · {} NM",
            orientation.get().name(),
            format::short(RANGES[range.get()])
        )
    };
    let vector = move || {
        format!(
            "Vector {} min · ground stab.",
            format::short(vector_minutes(RANGES[range.get()]))
        )
    };
    let turn_to = move |target: Orientation, name: &'static str| {
        view! {
            <button
                type="button"
                data-command=name
                aria-pressed=move || if orientation.get() == target { "true" } else { "false" }
                on:click=move |_| orientation.set(target)
            >
                {target.name()}
            </button>
        }
    };
    view! {
        <div class="plan" node_ref=element>
            <svg role="img" aria-label="plan view" inner_html=drawing></svg>
            <span class="corner tl">{corner}</span>
            <span class="corner bl">{vector}</span>
            <div class="tools">
                {turn_to(Orientation::North, "north-up")}
                {turn_to(Orientation::Head, "head-up")}
                {turn_to(Orientation::Course, "course-up")}
                <button
                    type="button"
                    data-command="range-in"
                    aria-label="smaller range"
                    on:click=move |_| range.update(|index| *index = index.saturating_sub(1))
                >
                    "+"
                </button>
                <button
                    type="button"
                    data-command="range-out"
                    aria-label="larger range"
                    on:click=move |_| range.update(|index| *index = (*index + 1).min(RANGES.len() - 1))
                >
                    "−"
                </button>
            </div>
        </div>
    }
}

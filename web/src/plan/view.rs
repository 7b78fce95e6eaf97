//! The plan's frame on the screen: size, range, orientation, backdrop.

use super::frame::{Frame, Orientation, RANGES};
use super::ship::OwnShip;
use super::track::Track;
use crate::deck::Deck;
use crate::format;
use leptos::html::Div;
use leptos::prelude::*;
use wheelover_core::geo::{Point, Position};

/// Minutes that the vectors reach ahead, by range.
#[must_use]
pub(super) fn vector_minutes(range_nm: f64) -> f64 {
    match range_nm {
        range if range <= 0.75 => 1.5,
        range if range <= 1.5 => 3.0,
        range if range <= 3.0 => 6.0,
        _ => 12.0,
    }
}

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
    let corner = move || {
        format!(
            "{} · RM · {} NM",
            orientation.get().name(),
            RANGES[range.get()]
        )
    };
    let vector = move || {
        format!(
            "Vector {} min · ground stab.",
            vector_minutes(RANGES[range.get()])
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
            <svg role="img" aria-label="plan view">
                {move || {
                    frame()
                        .map(|frame| {
                            let range_nm = RANGES[range.get()];
                            view! {
                                <Backdrop frame range_nm/>
                                <Track frame/>
                                <OwnShip frame range_nm/>
                            }
                        })
                }}
            </svg>
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

/// Lines of latitude and longitude, and range rings around the ship.
#[component]
fn Backdrop(frame: Frame, range_nm: f64) -> impl IntoView {
    let (graticule, _) = frame.graticule();
    let (x, y) = frame.point(Point::default());
    let rings = [0.5, 1.0].map(|part| {
        let radius = range_nm * part * 1852.0 * frame.scale;
        let label = format::miles(Some(range_nm * part * 1852.0));
        view! {
            <circle class="ring" cx=format!("{x:.1}") cy=format!("{y:.1}") r=format!("{radius:.1}")/>
            <text class="ring-name" x=format!("{:.1}", x + radius * 0.707 + 4.0) y=format!("{:.1}", y + radius * 0.707 + 12.0)>
                {label}
            </text>
        }
    });
    view! {
        <path class="grid" d=graticule/>
        {rings}
    }
}

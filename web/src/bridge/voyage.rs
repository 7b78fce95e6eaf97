//! The embedded voyage's bar: pace, officer, the chart side, faults. Absent with a real ship.

use crate::deck::Deck;
use leptos::prelude::*;
use wheelover_core::view::{ChartRequest, FaultKind, Order, VoyageOwn};

const PACES: [u8; 5] = [1, 5, 10, 30, 60];

/// Faults that can be put in: name of the button, its text, cable, kind.
const FAULTS: [(&str, &str, &str, FaultKind); 3] = [
    (
        "fault-chart-silent",
        "CHART SILENT",
        "ecdis",
        FaultKind::Silent,
    ),
    ("fault-gyro-jump", "GYRO JUMP", "gyro1", FaultKind::Jump),
    ("fault-position-jump", "POS JUMP", "gps", FaultKind::Jump),
];

/// The current that the button sets: direction and knots.
const CURRENT: (f64, f64) = (90.0, 1.0);

/// The bar.
#[component]
pub(super) fn VoyageBar() -> impl IntoView {
    let deck = Deck::here();
    let simulated = Memo::new(move |_| {
        deck.greeting
            .with(|g| g.as_ref().is_some_and(|g| g.simulated))
    });
    view! {
        <Show when=move || simulated.get()>
            <Bar/>
        </Show>
    }
}

#[component]
fn Bar() -> impl IntoView {
    let deck = Deck::here();
    let voyage = Memo::new(move |_| {
        deck.own
            .with(|own| own.as_ref().and_then(|s| s.voyage.clone()))
    });
    let control = Memo::new(move |_| {
        deck.own.with(|own| {
            own.as_ref()
                .and_then(|s| s.chart.as_ref())
                .map(|c| c.control.clone())
        })
    });
    let officer = Memo::new(move |_| voyage.with(|v| v.as_ref().is_some_and(|v| v.officer)));
    let round = Memo::new(move |_| voyage.with(|v| v.as_ref().map_or(0, |v| v.round)));
    let current =
        Memo::new(move |_| voyage.with(|v| v.as_ref().is_some_and(|v| v.current[1] > 0.05)));
    let pace = |pace: u8| {
        let name = format!("speed-{pace}");
        let asked = name.clone();
        let on = move || {
            let on = voyage.with(|v| {
                v.as_ref()
                    .is_some_and(|v| (v.speed - f64::from(pace)).abs() < 0.01)
            });
            if on { "true" } else { "false" }
        };
        view! {
            <button
                type="button"
                data-command=name
                aria-pressed=on
                on:click=move |_| deck.command(&asked, Order::Speed(f64::from(pace)))
            >
                {format!("{pace}x")}
            </button>
        }
    };
    let chart =
        |name: &'static str, text: &'static str, key: &'static str, request: ChartRequest| {
            view! {
                <button
                    type="button"
                    data-command=name
                    aria-pressed=move || {
                        if control.with(|c| c.as_deref() == Some(key)) { "true" } else { "false" }
                    }
                    on:click=move |_| deck.command(name, Order::Chart(request))
                >
                    {text}
                </button>
            }
        };
    let fault =
        |(name, text, cable, kind): (&'static str, &'static str, &'static str, FaultKind)| {
            let on = Memo::new(move |_| voyage.with(|v| has(v.as_ref(), cable, kind)));
            view! {
                <button
                    type="button"
                    class="fault"
                    data-command=name
                    aria-pressed=move || if on.get() { "true" } else { "false" }
                    on:click=move |_| {
                        let on = !on.get_untracked();
                        deck.command(name, Order::Fault { cable: cable.to_owned(), kind, on });
                    }
                >
                    {text}
                </button>
            }
        };
    view! {
        <div class="bar voyage">
            <span class="caption">"ROUND "{move || round.get()}</span>
            {PACES.into_iter().map(pace).collect_view()}
            <button
                type="button"
                data-command="officer"
                aria-pressed=move || if officer.get() { "true" } else { "false" }
                on:click=move |_| deck.command("officer", Order::Officer(!officer.get_untracked()))
            >
                "OFFICER"
            </button>
            <span class="caption">"CHART"</span>
            {chart("chart-track", "Ti", "track", ChartRequest::Track)}
            {chart("chart-heading", "Tn", "heading", ChartRequest::Heading)}
            {chart("chart-stop", "OFF", "off", ChartRequest::Stop)}
            <span class="faults">
                {FAULTS.into_iter().map(fault).collect_view()}
                <button
                    type="button"
                    class="fault"
                    data-command="current"
                    aria-pressed=move || if current.get() { "true" } else { "false" }
                    on:click=move |_| {
                        let drift = if current.get_untracked() { 0.0 } else { CURRENT.1 };
                        deck.command("current", Order::Current { set: CURRENT.0, drift });
                    }
                >
                    "CURRENT"
                </button>
            </span>
        </div>
    }
}

fn has(voyage: Option<&VoyageOwn>, cable: &str, kind: FaultKind) -> bool {
    voyage.is_some_and(|v| {
        v.faults
            .iter()
            .any(|(name, what)| name == cable && *what == kind)
    })
}

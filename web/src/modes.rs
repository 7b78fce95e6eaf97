//! The modes besides AUTO and AutoNAV: selecting them, and setting what is set in the one that is on (AP-18, AP-19, AP-21).
//!
//! The control bar stands below as on the bridge: it confirms what is pressed here, and STANDBY has its place (AP-25).

use crate::bridge::control::{Armed, Control, pressed};
use crate::deck::Deck;
use crate::format;
use leptos::prelude::*;
use wheelover_core::view::{ModeName, ModeRequest, Order, Own, Side};

/// A mode: its name in `data-command`, its title, what it does for the officer.
type Row = (
    ModeRequest,
    ModeName,
    &'static str,
    &'static str,
    &'static str,
);

const MODES: [Row; 7] = [
    (
        ModeRequest::Track,
        ModeName::Track,
        "track",
        "TRACK",
        "follows the plotter's route",
    ),
    (
        ModeRequest::WindVane,
        ModeName::WindVane,
        "wind_vane",
        "WIND VANE",
        "holds the angle to the wind",
    ),
    (
        ModeRequest::RiverPilot,
        ModeName::RiverPilot,
        "river_pilot",
        "RIVER PILOT",
        "holds the rate of turn",
    ),
    (
        ModeRequest::Dodge,
        ModeName::Dodge,
        "dodge",
        "DODGE",
        "goes round something; again: back to the mode before",
    ),
    (
        ModeRequest::FfuOverride,
        ModeName::FfuOverride,
        "ffu_override",
        "FFU OVERRIDE",
        "gives the ordered rudder",
    ),
    (
        ModeRequest::Installation,
        ModeName::Installation,
        "installation",
        "INSTALLATION",
        "no orders; only STANDBY ends it",
    ),
    (
        ModeRequest::Autotuning,
        ModeName::Autotuning,
        "autotuning",
        "AUTOTUNING",
        "sails a zigzag; its limits are shown first, the second selection begins it",
    ),
];

/// What is set in a mode: its name, its unit, the small and the large step, the most, and the order.
type Setter = (
    ModeName,
    &'static str,
    &'static str,
    [f64; 2],
    f64,
    fn(f64) -> Order,
);

const SETS: [Setter; 4] = [
    (
        ModeName::WindVane,
        "WIND",
        "°",
        [1.0, 10.0],
        180.0,
        Order::SetWindAngle,
    ),
    (
        ModeName::RiverPilot,
        "ROT",
        "°/min",
        [1.0, 10.0],
        300.0,
        Order::SetRate,
    ),
    (
        ModeName::Dodge,
        "DODGE",
        "°",
        [1.0, 10.0],
        90.0,
        Order::SetDodge,
    ),
    (
        ModeName::FfuOverride,
        "RUDDER",
        "°",
        [1.0, 5.0],
        45.0,
        Order::SetRudder,
    ),
];

/// What is set in the mode that is on.
fn set_in(own: &Own) -> Option<(Setter, f64)> {
    let set = SETS.into_iter().find(|set| set.0 == own.mode)?;
    Some((set, own.set_value?))
}

fn words(set: &Setter, value: f64) -> String {
    format!("{} {}{}", set.1, format::sided(Some(value), 0), set.2)
}

/// The view of the modes.
#[component]
pub(crate) fn Modes() -> impl IntoView {
    let deck = Deck::here();
    let armed = RwSignal::new(None::<Armed>);
    let own = Memo::new(move |_| {
        deck.own
            .with(|own| own.as_ref().and_then(|snapshot| snapshot.own.clone()))
    });
    let may = Memo::new(move |_| {
        deck.greeting.with(|greeting| {
            greeting
                .as_ref()
                .is_some_and(|greeting| greeting.may_command)
        })
    });
    let arm = move |order: Order, words: String| armed.set(Some(Armed::new(deck, order, words)));
    let rows = MODES.map(|(request, name, key, title, what)| {
        let why = move || {
            own.with(|own| {
                let closed = &own.as_ref()?.closed;
                let found = closed.iter().find(|(closed, _)| *closed == request);
                found.map(|(_, why)| why.clone())
            })
        };
        let on = move || own.with(|own| own.as_ref().is_some_and(|own| own.mode == name));
        view! {
            <button
                type="button"
                data-command=key
                aria-pressed=move || pressed(on())
                aria-disabled=move || pressed(why().is_some())
                aria-describedby=key
                disabled=move || !may.get()
                on:click=move |_| if why().is_none() { arm(Order::Mode(request), title.to_owned()) }
            >
                {title}
            </button>
            <p id=key>
                {what}
                <span class="closed" data-closed=key>{why}</span>
            </p>
        }
    });
    // A press more changes what is armed already.
    let nudge = move |large: usize, sign: f64| {
        let Some((set, value)) = own.with_untracked(|own| own.as_ref().and_then(set_in)) else {
            return;
        };
        let before = match armed.get_untracked().map(|armed| armed.order) {
            Some(
                Order::SetWindAngle(value)
                | Order::SetRate(value)
                | Order::SetDodge(value)
                | Order::SetRudder(value),
            ) => value,
            _ => value,
        };
        let value = (before + sign * set.3[large]).clamp(-set.4, set.4);
        arm(set.5(value), words(&set, value));
    };
    let step = move |key: &'static str, large: usize, sign: f64| {
        let text = move || {
            let set = own.with(|own| own.as_ref().and_then(set_in));
            let size = set.map_or(0.0, |(set, _)| set.3[large]);
            format::sided(Some(sign * size), 0)
        };
        view! {
            <button type="button" data-command=key disabled=move || !may.get() on:click=move |_| nudge(large, sign)>
                {text}
            </button>
        }
    };
    let shown = move || own.with(|own| own.as_ref().and_then(set_in));
    let tack = move |key: &'static str, text: &'static str, side: Side| {
        let here = move || {
            own.with(|own| {
                own.as_ref()
                    .is_some_and(|own| own.mode == ModeName::WindVane)
            })
        };
        view! {
            <button
                type="button"
                data-command=key
                disabled=move || !may.get() || !here()
                on:click=move |_| arm(Order::Tack(side), text.to_owned())
            >
                {text}
            </button>
        }
    };
    view! {
        <main class="bridge modes">
            <div class="modes-list">
                {rows.into_iter().collect_view()}
                <p class="set-value" data-value="set-value">
                    {move || shown().map_or_else(|| "nothing is set by a number in this mode".to_owned(), |(set, value)| words(&set, value))}
                </p>
                <div class="set-keys" class:hidden=move || shown().is_none()>
                    {step("set-10", 1, -1.0)}
                    {step("set-1", 0, -1.0)}
                    {step("set+1", 0, 1.0)}
                    {step("set+10", 1, 1.0)}
                    {tack("tack-port", "TACK PORT", Side::Port)}
                    {tack("tack-starboard", "TACK STBD", Side::Starboard)}
                </div>
            </div>
            <Control armed/>
        </main>
    }
}

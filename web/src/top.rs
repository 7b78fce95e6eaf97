//! The top bar: mode, state of the turn, sources, link, time; and the banner when the link is gone.

use crate::deck::Deck;
use crate::format;
use crate::heard::Agreement;
use crate::palette::Palettes;
use crate::situation;
use crate::views::View;
use leptos::prelude::*;
use wheelover_core::view::ModeName;

/// The mode as the badge says it.
#[must_use]
pub(crate) const fn mode_title(mode: ModeName) -> &'static str {
    match mode {
        ModeName::Standby => "STANDBY",
        ModeName::NfuOverride => "NFU OVERRIDE",
        ModeName::Auto => "AUTO",
        ModeName::AutonavTn => "REMOTE Tn",
        ModeName::AutonavTi => "TRACK Ti",
        ModeName::Track => "TRACK APB",
        ModeName::RudderHold => "RUDDER HOLD",
        ModeName::WindVane => "WIND VANE",
        ModeName::RiverPilot => "RIVER PILOT",
        ModeName::Dodge => "DODGE",
        ModeName::FfuOverride => "FFU OVERRIDE",
        ModeName::Installation => "INSTALLATION",
        ModeName::Autotuning => "AUTOTUNING",
    }
}

/// The mode's name in `data-mode`.
#[must_use]
pub(crate) const fn mode_key(mode: ModeName) -> &'static str {
    match mode {
        ModeName::Standby => "standby",
        ModeName::NfuOverride => "nfu_override",
        ModeName::Auto => "auto",
        ModeName::AutonavTn => "autonav_tn",
        ModeName::AutonavTi => "autonav_ti",
        ModeName::Track => "track",
        ModeName::RudderHold => "rudder_hold",
        ModeName::WindVane => "wind_vane",
        ModeName::RiverPilot => "river_pilot",
        ModeName::Dodge => "dodge",
        ModeName::FfuOverride => "ffu_override",
        ModeName::Installation => "installation",
        ModeName::Autotuning => "autotuning",
    }
}

/// The top bar.
#[component]
pub(crate) fn TopBar(view: RwSignal<View>) -> impl IntoView {
    let deck = Deck::here();
    let mode = Memo::new(move |_| {
        deck.own.with(|own| {
            own.as_ref()
                .and_then(|s| s.own.as_ref())
                .map(|own| own.mode)
        })
    });
    let linked = Memo::new(move |_| !deck.link.get().lost());
    let title = move || match (linked.get(), mode.get()) {
        (true, Some(mode)) => mode_title(mode),
        _ => "- - -",
    };
    let state = move || {
        if linked.get() && mode.get().is_some() {
            "valid"
        } else {
            "lost"
        }
    };
    let tab = move |target: View, address: &'static str, name: &'static str| {
        view! {
            <a href=address aria-current=move || (view.get() == target).then_some("page")>{name}</a>
        }
    };
    let turn = Memo::new(move |_| situation::headline(deck));
    view! {
        <header class="top">
            <span
                class="badge"
                data-value="mode"
                data-state=state
                data-mode=move || mode.get().map_or("", mode_key)
            >
                {title}
            </span>
            <div class="headline">
                <span class="turn">{move || turn.with(|(headline, _)| headline.clone())}</span>
                <span class="detail">{move || turn.with(|(_, detail)| detail.clone())}</span>
            </div>
            <Sources/>
            <span class="disagree" class:hidden=move || deck.agreement.get() != Agreement::Disagree>
                "PICTURE DIFFERS FROM SERVER"
            </span>
            <span class="disagree" class:hidden=move || deck.misread.get() == 0>"OTHER VERSION: RELOAD"</span>
            <div class="alive">
                <LinkMark/>
                <time class="utc">{move || format::clock(deck.utc.get())}" UTC"</time>
            </div>
            <nav class="tabs">
                {tab(View::Bridge, "#/bridge", "BRIDGE")}
                {tab(View::Modes, "#/modes", "MODE")}
                {tab(View::Dialogue, "#/dialogue", "DIALOGUE")}
                {tab(View::Decoder, "#/decoder", "DECODER")}
                {tab(View::About, "#/about", "?")}
            </nav>
            <Palettes/>
        </header>
    }
}

/// Which source each quantity is taken from.
#[component]
fn Sources() -> impl IntoView {
    let deck = Deck::here();
    let text = Memo::new(move |_| {
        deck.readings.with(|readings| {
            let part = |name: &str, port: String, why: &str| match (why, port.as_str()) {
                ("", "") => format!("{name} –"),
                ("", port) => format!("{name} {port}"),
                (why, _) => format!("{name} {why}"),
            };
            [
                part("HDG", readings.heading.port(), &readings.heading.why),
                part("POS", readings.position.port(), &readings.position.why),
                part("STW", readings.stw.port(), ""),
            ]
            .join(" | ")
        })
    });
    view! { <span class="sources">{move || text.get()}</span> }
}

/// Age of the link; the mark moves with the frames that come, not by itself.
#[component]
fn LinkMark() -> impl IntoView {
    let deck = Deck::here();
    let age = Memo::new(move |_| {
        let link = deck.link.get();
        (link.age.map(|age| age / 100 * 100), link.lost())
    });
    let state = move || match age.get() {
        (None, _) => "never",
        (_, true) => "lost",
        (Some(0..=1_000), _) => "valid",
        _ => "late",
    };
    let place = move || {
        if (deck.link.get().frames / 10).is_multiple_of(2) {
            "4"
        } else {
            "10"
        }
    };
    view! {
        <span class="link" data-state=state>
            <svg viewBox="0 0 14 14" aria-hidden="true"><circle cx=place cy="7" r="4"/></svg>
            <span data-value="link-age" data-state=state>
                {move || match age.get() {
                    (None, _) => "NO LINK".to_owned(),
                    (Some(age), false) => format!("LIVE {}", format::age(age)),
                    (Some(age), true) => format!("LOST {}", format::age(age)),
                }}
            </span>
        </span>
    }
}

/// The veil over the page while nothing comes, also before anything came; what was pressed and not sent stands there.
#[component]
pub(crate) fn NoLink() -> impl IntoView {
    let deck = Deck::here();
    let lost = Memo::new(move |_| {
        let link = deck.link.get();
        link.lost().then(|| {
            link.age.map_or_else(
                || "NO LINK".to_owned(),
                |age| format!("NO LINK {} s", age / 1_000),
            )
        })
    });
    let unsent = Memo::new(move |_| {
        deck.answer
            .with(|answer| answer.as_ref().filter(|a| !a.ok).map(|a| a.text.clone()))
    });
    view! {
        <div class="veil" class:hidden=move || lost.with(Option::is_none) data-value="no-link">
            <b role="status">{move || lost.get()}</b>
            <b role="alert" class:hidden=move || unsent.with(Option::is_none)>{move || unsent.get()}</b>
        </div>
    }
}

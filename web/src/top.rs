//! The top bar: mode, state of the turn, sources, link, time; and the banner when the link is gone.

use crate::app::View;
use crate::deck::Deck;
use crate::format;
use crate::heard::Agreement;
use crate::palette::Palettes;
use crate::situation;
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
    let linked = Memo::new(move |_| deck.link.get().age.is_some_and(|age| age <= 5_000));
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
            <span class="turn">{move || turn.with(|(headline, _)| headline.clone())}</span>
            <span class="detail">{move || turn.with(|(_, detail)| detail.clone())}</span>
            <Sources/>
            <span class="disagree" class:hidden=move || deck.agreement.get() != Agreement::Disagree>
                "PICTURE DIFFERS FROM SERVER"
            </span>
            <span class="disagree" class:hidden=move || deck.misread.get() == 0>"OTHER VERSION: RELOAD"</span>
            <LinkMark/>
            <time class="utc">{move || format::clock(deck.utc.get())}" UTC"</time>
            <nav class="tabs">
                {tab(View::Bridge, "#/bridge", "BRIDGE")}
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
            let part = |name: &str, port: String| {
                if port.is_empty() {
                    format!("{name} –")
                } else {
                    format!("{name} {port}")
                }
            };
            [
                part("HDG", readings.heading.port()),
                part("POS", readings.position.port()),
                part("STW", readings.stw.port()),
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
    let age = Memo::new(move |_| deck.link.get().age.map(|age| age / 100 * 100));
    let state = move || match age.get() {
        None => "never",
        Some(0..=1_000) => "valid",
        Some(1_001..=2_000) => "late",
        Some(_) => "lost",
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
                    None => "NO LINK".to_owned(),
                    Some(age @ 0..=2_000) => format!("LIVE {}", format::age(age)),
                    Some(age) => format!("LOST {}", format::age(age)),
                }}
            </span>
        </span>
    }
}

/// The veil over the page when nothing comes.
#[component]
pub(crate) fn NoLink() -> impl IntoView {
    let deck = Deck::here();
    let age = Memo::new(move |_| match deck.link.get().age {
        Some(age) if age > 2_000 => Some(age / 1_000),
        _ => None,
    });
    view! {
        <div class="veil" class:hidden=move || age.get().is_none() role="status">
            <b>{move || age.get().map(|age| format!("NO LINK {age} s"))}</b>
        </div>
    }
}

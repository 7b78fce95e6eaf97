//! The page's frame: top bar, alert bar, and the view that the address names (`#/bridge`, `#/dialogue`, `#/decoder`, `#/about`).

use crate::about::About;
use crate::alerts::AlertBar;
use crate::bridge::Bridge;
use crate::deck::Deck;
use crate::decoder::Decoder;
use crate::dialogue::Dialogue;
use crate::lookup::Dictionary;
use crate::top::{NoLink, TopBar};
use crate::{link, palette};
use leptos::prelude::*;
use std::time::Duration;

/// Which view is shown.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum View {
    /// The bridge view.
    Bridge,
    /// Both directions of the dialogue.
    Dialogue,
    /// Lines explained.
    Decoder,
    /// What this is.
    About,
}

impl View {
    fn of(hash: &str) -> Self {
        match hash {
            "#/dialogue" => Self::Dialogue,
            "#/decoder" => Self::Decoder,
            "#/about" => Self::About,
            _ => Self::Bridge,
        }
    }
}

/// Mounts the page: the whole of it, or the decoder alone in the file that works from a disk.
pub fn start() {
    let alone = document()
        .document_element()
        .and_then(|root| root.get_attribute("data-page"))
        .is_some_and(|page| page == "decoder");
    if alone {
        mount_to_body(DecoderAlone);
        return;
    }
    let (deck, dictionary) = (Deck::new(), Dictionary::new());
    // What has come already is in what is drawn first.
    link::open(deck);
    mount_to_body(move || view! { <Page deck dictionary/> });
    let mut beat = 0_u32;
    let tick = move || {
        beat = beat.wrapping_add(1);
        deck.show();
        link::watch(deck);
        if deck.own.with_untracked(Option::is_some) {
            // What is shown first has come; from now on the decoder needs no server either.
            dictionary.fetch();
        }
        if beat.is_multiple_of(2) {
            deck.flash.update(|on| *on = !*on);
        }
    };
    let tick = std::cell::RefCell::new(tick);
    set_interval(move || (tick.borrow_mut())(), Duration::from_millis(250));
    reload_when_built_anew();
}

#[component]
fn Page(deck: Deck, dictionary: Dictionary) -> impl IntoView {
    provide_context(deck);
    provide_context(dictionary);
    let shown = || View::of(&window().location().hash().unwrap_or_default());
    let view = RwSignal::new(shown());
    let handle = window_event_listener(leptos::ev::hashchange, move |_| view.set(shown()));
    on_cleanup(move || handle.remove());
    view! {
        <div class="page" class:flash-off=move || !deck.flash.get()>
            <TopBar view/>
            <AlertBar/>
            {move || match view.get() {
                View::Bridge => view! { <Bridge/> }.into_any(),
                View::Dialogue => view! { <Dialogue/> }.into_any(),
                View::Decoder => view! { <Decoder/> }.into_any(),
                View::About => view! { <About/> }.into_any(),
            }}
            <NoLink/>
        </div>
    }
}

/// The decoder without a server.
#[component]
fn DecoderAlone() -> impl IntoView {
    provide_context(Dictionary::new());
    view! {
        <div class="page alone">
            <header class="top">
                <b class="turn">"Wheelover decoder"</b>
                <span class="detail">"works without a server and without a network"</span>
                <span class="sources"></span>
                <palette::Palettes/>
            </header>
            <Decoder/>
        </div>
    }
}

/// A page of a development build asks for the name of the newest build and reloads itself when that changes.
fn reload_when_built_anew() {
    #[cfg(debug_assertions)]
    {
        use wasm_bindgen::JsCast;
        use wasm_bindgen_futures::JsFuture;
        async fn newest() -> Option<String> {
            let answer = JsFuture::from(window().fetch_with_str("/build.txt"))
                .await
                .ok()?;
            let answer: web_sys::Response = answer.dyn_into().ok()?;
            if !answer.ok() {
                return None;
            }
            JsFuture::from(answer.text().ok()?).await.ok()?.as_string()
        }
        let first = StoredValue::new(None::<String>);
        set_interval(
            move || {
                wasm_bindgen_futures::spawn_local(async move {
                    let Some(newest) = newest().await else { return };
                    let known = first.get_value();
                    if known.is_some_and(|known| known != newest) {
                        // A page that cannot reload itself is reloaded by hand.
                        let _reloaded = window().location().reload();
                    }
                    first.set_value(Some(newest));
                });
            },
            Duration::from_secs(1),
        );
    }
}

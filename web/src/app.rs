//! The page's frame: top bar, alert bar, and the view that the address names (`#/bridge`, `#/modes`, `#/dialogue`, `#/decoder`, `#/about`).

use crate::alerts::AlertBar;
use crate::asking;
use crate::bridge::Bridge;
use crate::deck::Deck;
use crate::later::{Later, Parts};
use crate::link::{self, InPage, Socket};
use crate::lookup::Dictionary;
use crate::palette;
use crate::steady::each_frame;
use crate::top::{NoLink, TopBar};
use crate::views::View;
use leptos::prelude::*;
use std::time::Duration;
use wasm_bindgen::JsCast;
use wasm_bindgen::closure::Closure;
use web_sys::EventTarget;
use wheelover_core::voyage::Voyage;

/// Mounts the page: the whole of it, or the decoder alone in the file that works from a disk.
pub fn start(parts: Parts) {
    let alone = document()
        .document_element()
        .and_then(|root| root.get_attribute("data-page"))
        .is_some_and(|page| page == "decoder");
    if alone {
        mount_to_body(move || view! { <DecoderAlone parts/> });
        return;
    }
    let deck = Deck::new();
    let socket = Socket::new(deck);
    link::open(Box::new(socket.clone()));
    // What has come already is in what is drawn first.
    socket.connect();
    live(deck, parts);
    reload_when_built_anew();
}

/// Mounts the page on a voyage that runs in it: the same page, without a server.
pub fn sail(voyage: Voyage) {
    let deck = Deck::new();
    let voyage = InPage::new(deck, voyage);
    link::open(Box::new(voyage.clone()));
    voyage.sail();
    live(deck, Parts::here());
}

/// Mounts the page, and keeps it awake: before each picture, four times a second, and when it is looked at again.
fn live(deck: Deck, parts: Parts) {
    let dictionary = Dictionary::new();
    mount_to_body(move || view! { <Page deck dictionary parts/> });
    each_frame(move || asking::look(deck));
    // The first picture after a sleep is judged before it is shown, and the last one before it is dead (FC6).
    on(&window(), "pagehide", move || asking::leave(deck, true));
    on(&window(), "pageshow", move || asking::leave(deck, false));
    on(&document(), "freeze", move || asking::leave(deck, true));
    on(&document(), "resume", move || asking::leave(deck, false));
    on(&document(), "visibilitychange", move || {
        asking::leave(deck, document().hidden());
    });
    let (mut beat, mut fetched) = (0_u32, false);
    let tick = move || {
        beat = beat.wrapping_add(1);
        asking::look(deck);
        link::watch(deck.silent());
        if deck.own.with_untracked(Option::is_some) {
            // What is shown first has come; from now on the other views need no server either.
            dictionary.fetch();
            if !std::mem::replace(&mut fetched, true) {
                // What fails is fetched when it is opened.
                leptos::task::spawn_local(async move { drop((parts.fetch)().await) });
            }
        }
        if beat.is_multiple_of(2) {
            deck.flash.update(|on| *on = !*on);
        }
    };
    let tick = std::cell::RefCell::new(tick);
    set_interval(move || (tick.borrow_mut())(), Duration::from_millis(250));
}

/// Listens as long as the page lives.
fn on(target: &EventTarget, event: &str, act: impl FnMut() + 'static) {
    let listener = Closure::<dyn FnMut()>::new(act);
    // Any target takes a listener.
    let _listens =
        target.add_event_listener_with_callback(event, listener.as_ref().unchecked_ref());
    listener.forget();
}

#[component]
fn Page(deck: Deck, dictionary: Dictionary, parts: Parts) -> impl IntoView {
    provide_context(parts);
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
                view => view! { <Later view/> }.into_any(),
            }}
            <NoLink/>
        </div>
    }
}

/// The decoder without a server.
#[component]
fn DecoderAlone(parts: Parts) -> impl IntoView {
    provide_context(parts);
    provide_context(Dictionary::new());
    view! {
        <div class="page alone">
            <header class="top">
                <b class="turn">"Wheelover decoder"</b>
                <span class="detail">"works without a server and without a network"</span>
                <span class="sources"></span>
                <palette::Palettes/>
            </header>
            <Later view=View::Decoder/>
        </div>
    }
}

/// A page of a development build asks for the name of the newest build and reloads itself when that changes.
fn reload_when_built_anew() {
    #[cfg(debug_assertions)]
    {
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

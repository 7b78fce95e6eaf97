//! The route that a plotter offers to our chart-system side, and the button that loads it (TCS-13). Its order names the offer
//! that stands here: another one meanwhile is refused.

use crate::deck::Deck;
use crate::format;
use js_sys::{Array, Reflect};
use leptos::prelude::*;
use std::time::Duration;
use wasm_bindgen::{JsCast, JsValue};
use wasm_bindgen_futures::{JsFuture, spawn_local};
use wheelover_core::view::Order;

/// Between two looks.
const LOOK: Duration = Duration::from_secs(1);

/// The offer as it is shown.
#[derive(Clone, Debug, PartialEq)]
struct Offer {
    number: f64,
    words: String,
    refusal: String,
}

fn read(text: &str) -> Option<Offer> {
    let all = js_sys::JSON::parse(text).ok()?;
    let field = |name: &str| Reflect::get(&all, &JsValue::from_str(name)).ok();
    let waypoints: Array = field("waypoints")?.dyn_into().ok()?;
    let kind = if field("complete")?.is_truthy() {
        "complete"
    } else {
        "what is still to be sailed"
    };
    let length = match field("length_nm")?.as_f64() {
        Some(miles) => format!(", {} NM", format::fixed(miles, 1)),
        None => String::new(),
    };
    Some(Offer {
        number: field("number")?.as_f64()?,
        words: format!(
            "{}, {kind}{length}: {}",
            field("name")?.as_string()?,
            String::from(waypoints.join(" · "))
        ),
        refusal: field("refusal")?.as_string()?,
    })
}

async fn look() -> Option<Offer> {
    let answer = JsFuture::from(window().fetch_with_str("/api/offered")).await;
    let answer: web_sys::Response = answer.ok()?.dyn_into().ok()?;
    if !answer.ok() {
        return None;
    }
    let text = JsFuture::from(answer.text().ok()?).await.ok()?;
    read(&text.as_string()?)
}

/// The offer; nothing where there is none.
#[component]
pub(crate) fn Offered() -> impl IntoView {
    let deck = Deck::here();
    let offer = RwSignal::new(None::<Offer>);
    let may_command = move || {
        let greeting = deck.greeting;
        greeting.with(|g| g.as_ref().is_some_and(|g| g.may_command))
    };
    let ask = move || {
        spawn_local(async move {
            let found = look().await;
            offer.try_set(found);
        });
    };
    ask();
    if let Ok(timer) = set_interval_with_handle(ask, LOOK) {
        on_cleanup(move || timer.clear());
    }
    move || {
        offer.get().map(|offer| {
            let (closed, number) = (!offer.refusal.is_empty(), offer.number as u64);
            view! {
                <section class="lane" data-value="offered-route">
                    <h2>"offered route"</h2>
                    <p>{offer.words}</p>
                    <p class="quiet">{offer.refusal}</p>
                    <button
                        type="button"
                        data-command="load-route"
                        disabled=move || closed || !may_command()
                        on:click=move |_| deck.command("load-route", Order::LoadRoute(number))
                    >
                        "LOAD"
                    </button>
                </section>
            }
        })
    }
}

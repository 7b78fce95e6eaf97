//! The page on a voyage that runs in it: the same views, the same digests, the same buttons, and no server.
#![cfg(target_arch = "wasm32")]
#![allow(clippy::unwrap_used)]

use js_sys::Promise;
use wasm_bindgen::JsCast;
use wasm_bindgen_futures::JsFuture;
use wasm_bindgen_test::{wasm_bindgen_test, wasm_bindgen_test_configure};
use web_sys::{HtmlElement, Window};
use wheelover_core::voyage::Voyage;

wasm_bindgen_test_configure!(run_in_browser);

/// Between two looks, milliseconds, and how many there are.
const LOOK: i32 = 50;
const LOOKS: u32 = 400;

fn window() -> Window {
    web_sys::window().unwrap()
}

fn element(selector: &str) -> Option<HtmlElement> {
    let found = window().document()?.query_selector(selector).ok()??;
    found.dyn_into().ok()
}

fn attribute(selector: &str, name: &str) -> String {
    element(selector)
        .and_then(|element| element.get_attribute(name))
        .unwrap_or_default()
}

async fn until(what: &str, holds: impl Fn() -> bool) {
    for _ in 0..LOOKS {
        if holds() {
            return;
        }
        let wait = Promise::new(&mut |done, _| {
            window()
                .set_timeout_with_callback_and_timeout_and_arguments_0(&done, LOOK)
                .unwrap();
        });
        JsFuture::from(wait).await.unwrap();
    }
    panic!("{what} not in time");
}

#[wasm_bindgen_test]
async fn a_voyage_sails_in_the_page_and_obeys_it() {
    wheelover_web::app::sail(Voyage::embedded(7));
    let heading = || attribute("[data-value=heading]", "data-state");
    until("a live heading", || heading() == "valid").await;
    let mode = || attribute("[data-value=mode]", "data-mode");
    until("a mode", || !mode().is_empty() && mode() != "standby").await;
    // AP-25: the button reaches the autopilot, wherever it runs.
    element("[data-command=standby]").unwrap().click();
    until("STANDBY", || mode() == "standby").await;
    // The page's own fold agrees with the stations, digest by digest.
    window().location().set_hash("#/about").unwrap();
    let agreement = || element("[data-value=agreement]").map(|e| e.inner_text());
    until("agreement", || {
        agreement().is_some_and(|text| text.starts_with("agrees"))
    })
    .await;
    assert_eq!(heading(), "", "another view is open");
}

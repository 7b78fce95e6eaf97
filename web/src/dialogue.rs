//! Both directions of the dialogue, live.
use leptos::prelude::*;

/// The dialogue page.
#[component]
pub(crate) fn Dialogue() -> impl IntoView {
    view! { <main class="talk"></main> }
}

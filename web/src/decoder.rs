//! Lines explained.
use leptos::prelude::*;

/// The decoder page.
#[component]
pub(crate) fn Decoder() -> impl IntoView {
    view! { <main class="decoder"></main> }
}

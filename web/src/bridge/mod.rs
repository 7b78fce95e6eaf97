//! The bridge view: plan and controls at the left, instruments at the right, the route along the bottom.

mod control;
mod instruments;
mod strip;
mod voyage;

use crate::plan::Plan;
use leptos::prelude::*;

/// The bridge view.
#[component]
pub(crate) fn Bridge() -> impl IntoView {
    view! {
        <main class="bridge">
            <div class="left">
                <Plan/>
                <control::Control/>
                <voyage::VoyageBar/>
            </div>
            <instruments::Instruments/>
            <strip::Strip/>
        </main>
    }
}

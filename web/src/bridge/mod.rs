//! The bridge view: plan, instruments, route and the voyage's bar; the controls stand outside of what may scroll (AP-25).

pub(crate) mod control;
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
            <div class="view">
                <Plan/>
                <instruments::Instruments/>
                <strip::Strip/>
                <voyage::VoyageBar/>
            </div>
            <control::Control armed=RwSignal::new(None)/>
        </main>
    }
}

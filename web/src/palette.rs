//! The four palettes; the choice is this tablet's own and kept in its storage.

use leptos::prelude::*;

const PALETTES: [(&str, &str); 4] = [
    ("bright", "BRIGHT"),
    ("day", "DAY"),
    ("dusk", "DUSK"),
    ("night", "NIGHT"),
];

/// A button that goes to the next palette.
#[component]
pub(crate) fn Palettes() -> impl IntoView {
    let root = document().document_element();
    let kept = root
        .and_then(|root| root.get_attribute("data-palette"))
        .unwrap_or_default();
    let start = PALETTES
        .iter()
        .position(|(name, _)| *name == kept)
        .unwrap_or(1);
    let chosen = RwSignal::new(start);
    let next = move |_| {
        let index = (chosen.get_untracked() + 1) % PALETTES.len();
        chosen.set(index);
        put(PALETTES[index].0);
    };
    view! {
        <button type="button" data-command="palette" title="Palette" on:click=next>
            {move || PALETTES[chosen.get()].1}
        </button>
    }
}

fn put(name: &str) {
    if let Some(root) = document().document_element() {
        // An element takes any attribute of this form.
        let _set = root.set_attribute("data-palette", name);
    }
    if let Ok(Some(storage)) = window().local_storage() {
        // A full or forbidden storage only means that the choice is not kept.
        let _kept = storage.set_item("wheelover.palette", name);
    }
}

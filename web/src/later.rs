//! Views that are fetched later, as parts of the same module: the first load holds the bridge view alone.
//!
//! Where the parts begin is said by who starts the page ([`Parts`]): the program itself cuts them out.

use crate::about::About;
use crate::decoder::Decoder;
use crate::dialogue::Dialogue;
use crate::modes::Modes;
use crate::views::View;
use leptos::prelude::*;
use leptos::reactive::computed::ScopedFuture;
use leptos::task::spawn_local;
use leptos::wasm_split::SplitLoaderError;
use std::pin::Pin;

/// A view that was fetched, or none because it cannot be.
pub type Fetched = Result<AnyView, SplitLoaderError>;

type Opens = fn() -> Pin<Box<dyn Future<Output = Fetched>>>;
type Fetches = fn() -> Pin<Box<dyn Future<Output = Result<(), SplitLoaderError>>>>;

/// How the later views are opened.
#[derive(Clone, Copy)]
pub struct Parts {
    /// Opens the modes.
    pub modes: Opens,
    /// Opens the dialogue.
    pub dialogue: Opens,
    /// Opens the decoder.
    pub decoder: Opens,
    /// Opens what is said about the program.
    pub about: Opens,
    /// Fetches all of them, so that they open although the server is gone.
    pub fetch: Fetches,
}

impl Parts {
    /// All of them are here from the beginning.
    #[must_use]
    pub fn here() -> Self {
        Self {
            modes: || Box::pin(async { Ok(modes()) }),
            dialogue: || Box::pin(async { Ok(dialogue()) }),
            decoder: || Box::pin(async { Ok(decoder()) }),
            about: || Box::pin(async { Ok(about()) }),
            fetch: || Box::pin(async { Ok(()) }),
        }
    }
}

/// The modes.
#[must_use]
pub fn modes() -> AnyView {
    view! { <Modes/> }.into_any()
}

/// The dialogue view.
#[must_use]
pub fn dialogue() -> AnyView {
    view! { <Dialogue/> }.into_any()
}

/// The decoder view.
#[must_use]
pub fn decoder() -> AnyView {
    view! { <Decoder/> }.into_any()
}

/// What is said about the program.
#[must_use]
pub fn about() -> AnyView {
    view! { <About/> }.into_any()
}

/// How far a view is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Way {
    Asked,
    There,
    Failed,
}

/// A view other than the bridge.
#[component]
pub(crate) fn Later(view: View) -> impl IntoView {
    let parts: Parts = expect_context();
    let way = RwSignal::new(Way::Asked);
    let slot = StoredValue::new_local(None::<AnyView>);
    let ask = move || {
        way.set(Way::Asked);
        spawn_local(ScopedFuture::new(async move {
            let open = match view {
                View::Modes => parts.modes,
                View::Dialogue => parts.dialogue,
                View::Decoder => parts.decoder,
                View::About | View::Bridge => parts.about,
            };
            let fetched = open().await;
            // Another view may have been opened meanwhile; then this one is not wanted.
            let next = if fetched.is_ok() {
                Way::There
            } else {
                Way::Failed
            };
            slot.try_update_value(|slot| *slot = fetched.ok());
            way.try_set(next);
        }));
    };
    ask();
    move || {
        match way.get() {
        Way::Asked => view! { <main class="about"></main> }.into_any(),
        Way::There => slot.try_update_value(Option::take).flatten().into_any(),
        Way::Failed => view! {
            <main class="about">
                <p class="notice">"NO LINK: this view could not be fetched."</p>
                <button type="button" data-command="fetch" on:click=move |_| ask()>"TRY AGAIN"</button>
            </main>
        }
        .into_any(),
    }
    }
}

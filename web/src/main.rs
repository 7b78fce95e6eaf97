//! Starts the page, and says where its later views are cut out of it (`split`, by the build task).
#![cfg_attr(
    feature = "split",
    allow(
        unsafe_code,
        improper_ctypes_definitions,
        reason = "a part is entered through a name that the build task finds; both ends are this program"
    )
)]

#[cfg(target_arch = "wasm32")]
fn main() {
    console_error_panic_hook::set_once();
    wheelover_web::app::start(parts());
}

#[cfg(all(target_arch = "wasm32", not(feature = "split")))]
fn parts() -> wheelover_web::later::Parts {
    wheelover_web::later::Parts::here()
}

#[cfg(all(target_arch = "wasm32", feature = "split"))]
use cut::parts;

/// Each function is a part of its own, with all that only it needs.
#[cfg(all(target_arch = "wasm32", feature = "split"))]
mod cut {
    use leptos::wasm_split::wasm_split;
    use wheelover_web::later::{self, Fetched, Parts};

    #[wasm_split(modes, wasm_split_path = leptos::wasm_split, preload(fetch_modes), fallible)]
    fn modes() -> Fetched {
        Ok(later::modes())
    }

    #[wasm_split(dialogue, wasm_split_path = leptos::wasm_split, preload(fetch_dialogue), fallible)]
    fn dialogue() -> Fetched {
        Ok(later::dialogue())
    }

    #[wasm_split(decoder, wasm_split_path = leptos::wasm_split, preload(fetch_decoder), fallible)]
    fn decoder() -> Fetched {
        Ok(later::decoder())
    }

    #[wasm_split(about, wasm_split_path = leptos::wasm_split, preload(fetch_about), fallible)]
    fn about() -> Fetched {
        Ok(later::about())
    }

    pub(crate) fn parts() -> Parts {
        Parts {
            modes: || Box::pin(modes()),
            dialogue: || Box::pin(dialogue()),
            decoder: || Box::pin(decoder()),
            about: || Box::pin(about()),
            fetch: || {
                Box::pin(async {
                    // In the order in which they are likely to be wanted.
                    fetch_modes().await?;
                    fetch_decoder().await?;
                    fetch_dialogue().await?;
                    fetch_about().await
                })
            },
        }
    }
}

#[cfg(not(target_arch = "wasm32"))]
fn main() {
    eprintln!("this is the page: build it with `cargo xtask build`");
}

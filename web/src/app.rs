//! The page's frame.
use leptos::prelude::*;

/// Mounts the page.
pub fn start() {
    mount_to_body(|| view! { <p>"Wheelover"</p> });
}

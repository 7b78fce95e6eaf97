//! The whole dictionary as a module of its own, loaded beside the page: the first load stays small.

#[cfg(target_arch = "wasm32")]
mod export {
    use wasm_bindgen::prelude::wasm_bindgen;
    use wheelover_web::explained;

    /// A line as chips; `chosen` is the field that was tapped, less than 0 for none.
    #[wasm_bindgen]
    #[must_use]
    pub fn chips(text: &str, chosen: i32) -> String {
        explained::chips(text, usize::try_from(chosen).ok())
    }

    /// A line as a table.
    #[wasm_bindgen]
    #[must_use]
    pub fn table(text: &str, chosen: i32) -> String {
        explained::table(text, usize::try_from(chosen).ok())
    }

    /// A text of many lines: words, a line end, tables.
    #[wasm_bindgen]
    #[must_use]
    pub fn whole(text: &str) -> String {
        explained::document(text)
    }
}

#[cfg(target_arch = "wasm32")]
pub use export::{chips, table, whole};

fn main() {}

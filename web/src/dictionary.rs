//! The whole dictionary as a module of its own, loaded beside the page: the first load stays small.

#[cfg(target_arch = "wasm32")]
mod export {
    use std::cell::RefCell;
    use wasm_bindgen::prelude::wasm_bindgen;
    use wheelover_core::conformance::Live;
    use wheelover_web::text::Text;
    use wheelover_web::{checked, explained};

    thread_local! {
        static TEXT: RefCell<Text> = RefCell::default();
        static LIVE: RefCell<Live> = RefCell::default();
    }

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

    /// Checks the next lines of a running dialogue (CON-2), each `number`, tab, milliseconds, tab, text; `anew`: the first
    /// ones of another.
    #[wasm_bindgen]
    #[must_use]
    pub fn follow(lines: &str, anew: bool) -> String {
        if anew {
            LIVE.take();
        }
        LIVE.with_borrow_mut(|live| checked::follow(live, lines))
    }

    /// Begins to read a text of many lines.
    #[wasm_bindgen]
    pub fn begin() {
        TEXT.take();
    }

    /// Reads its next part.
    #[wasm_bindgen]
    pub fn take(bytes: &[u8]) {
        TEXT.with_borrow_mut(|text| text.take(bytes));
    }

    /// Ends it.
    #[wasm_bindgen]
    pub fn end() {
        TEXT.with_borrow_mut(Text::end);
    }

    /// What it holds so far, in words.
    #[wasm_bindgen]
    #[must_use]
    pub fn words() -> String {
        TEXT.with_borrow(Text::words)
    }

    /// Its lines as tables.
    #[wasm_bindgen]
    #[must_use]
    pub fn tables() -> String {
        TEXT.with_borrow(Text::tables)
    }
}

#[cfg(target_arch = "wasm32")]
pub use export::{begin, chips, end, follow, table, tables, take, words};

fn main() {}

//! The whole dictionary as a module of its own, loaded when something is to be explained: the first load stays small.

#[cfg(target_arch = "wasm32")]
mod export {
    use wasm_bindgen::prelude::wasm_bindgen;
    use wheelover_core::nmea::{decode, json_line};

    /// Explains a line (its characters are its bytes) as the JSON object of `wheelover decode --json`.
    #[wasm_bindgen]
    #[must_use]
    pub fn explain(number: f64, text: &str) -> String {
        let bytes: Vec<u8> = text
            .chars()
            .map(|letter| u8::try_from(u32::from(letter)).unwrap_or(b'?'))
            .collect();
        json_line(number as u64, None, &decode(&bytes)).text()
    }
}

#[cfg(target_arch = "wasm32")]
pub use export::explain;

fn main() {}

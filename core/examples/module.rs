//! The core as a module of wasm with nothing around it: the embedded voyage, as far as it is asked to sail.
//!
//! A test reads that it imports nothing: what the core does depends on its arguments only.

use wheelover_core::time::Stamp;
use wheelover_core::voyage::{Event, Voyage};

/// Sails for so many seconds; gives the number of outputs.
#[allow(unsafe_code, reason = "the name by which a host calls it")]
#[unsafe(no_mangle)]
pub extern "C" fn sail(seconds: u32) -> u32 {
    let mut out = Vec::new();
    let mut voyage = Voyage::embedded(1);
    voyage.handle(Stamp(u64::from(seconds) * 1_000), Event::Tick, &mut out);
    u32::try_from(out.len()).unwrap_or(u32::MAX)
}

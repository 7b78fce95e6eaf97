//! Tests over the whole dictionary.

mod bounded;
mod codes;
mod framing;
mod generate;
pub(super) mod given;
mod hostile;
#[path = "../../../../tests/random.rs"]
pub(super) mod random;
mod round_trip;
mod sweep;
mod views;
mod wrong_field;

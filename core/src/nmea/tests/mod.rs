//! Tests over the whole dictionary.

mod bounded;
mod codes;
mod framing;
mod generate;
mod hostile;
mod random;
mod sweep;
mod views;
mod wrong_field;

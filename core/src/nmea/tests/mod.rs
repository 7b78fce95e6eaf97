//! Tests over the whole dictionary.

mod framing;
mod random;
mod views;

//! Tests over the whole dictionary.

mod framing;
mod views;

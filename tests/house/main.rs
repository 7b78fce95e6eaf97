//! How the house is built, read from its files: layers, circles, lengths, citations.
#![allow(clippy::unwrap_used)]

mod coverage;
mod documents;
mod files;
mod layers;
mod needs;
mod rules;
mod source;
mod wasm;

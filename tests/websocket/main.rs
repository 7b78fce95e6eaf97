//! The stream and the doors: what a WebSocket client sees of the embedded voyage, and who is let in.
#![allow(clippy::unwrap_used)]

mod alerts;
mod dialogue;
mod doors;
mod ends;
mod flood;
mod recording;
mod settings;
mod stream;

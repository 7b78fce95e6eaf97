//! A voyage: the stations that run here, the cables between them, and the ports to real equipment.
//!
//! In: bytes from real ports, commands, time. Out: bytes to real ports, numbered lines, answers.
//! The embedded voyage, two processes over serial lines, the fault tests and a recording are all this.
//!
//! **Invariant:** stations exchange bytes only; the same events at the same times give the same outputs.

mod cable;
mod conduct;
mod event;
mod line;
mod officer;
mod run;
mod see;
mod setup;
mod tap;
mod wiring;

pub use crate::station::Role;
pub use event::{Event, VoyageOutput};
pub use line::Line;
pub use setup::VoyageConfig;
pub use tap::{Parcel, Tap};
pub use wiring::Voyage;

#[cfg(test)]
mod tests;

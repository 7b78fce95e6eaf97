//! Wheelover's core: a function of bytes, commands and time.
//!
//! No clock, socket, thread, log or random source is inside; `now` and seeds are arguments.
#![no_std]
extern crate alloc;
#[cfg(test)]
extern crate std;

pub mod alerts;
pub mod autopilot;
pub mod chart_system;
pub mod command;
pub mod conformance;
pub mod doctor;
pub mod facts;
pub mod geo;
pub mod motor;
pub mod nmea;
pub mod path;
pub mod picture;
mod post;
pub mod recording;
pub mod route;
pub mod scenario;
pub mod settings;
pub mod station;
pub mod talk;
pub mod time;
mod timers;
pub mod units;
pub mod view;
pub mod voyage;
pub mod world;

pub use facts::limits;

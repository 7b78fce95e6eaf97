//! Wheelover's server: ports, the control thread with the one clock, HTTP and WebSocket.
//!
//! Bytes from ports and commands from pages go in; sentences, lines and snapshots come out. What to
//! do with them is the core's affair: nothing here decides anything about steering.

mod args;
mod bus;
mod check;
mod clock;
mod config;
mod control;
mod decode;
mod dialogue;
mod error;
mod feed;
mod guard;
mod http;
mod lines;
mod log;
mod outbox;
pub mod page;
mod persist;
mod ports;
pub mod program;
mod realtime;
mod recorder;
mod serve;
mod simulate;
mod window;
mod ws;

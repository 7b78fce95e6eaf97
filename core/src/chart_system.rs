//! The chart system: monitors a route from heard positions and says once a second what the autopilot needs
//! (TCS-1, situations 1 to 6, "Ti" and "Tn").
//!
//! In: bytes of the position receiver, gyro, log and autopilot; requests of an officer. Out: HTC, XTE,
//! PNEY,001, PNEY,002, GLL, VTG and VHW on the autopilot's port.
//!
//! **Invariant:** situations change by geometry, never by time; no position older than 5 s is sent as valid.

mod adrift;
mod alerting;
mod commanding;
mod config;
mod control;
mod current;
mod followed;
mod indications;
mod loading;
mod offered;
mod place;
mod position;
mod reckoning;
mod run;
mod sentences;
mod sight;
mod state;
mod watch;

pub use config::ChartConfig;
pub use offered::Offer;
pub use state::ChartSystem;

#[cfg(test)]
pub(crate) mod tests;

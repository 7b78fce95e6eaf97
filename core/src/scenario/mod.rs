//! Scenarios: a track-keeping bench in closed loop, and open-loop manoeuvres; both give figures.
//!
//! In: the text of a scenario and its noise series. Out: one report a scenario, and samples for a table.
//! The bench steers with the autopilot's own laws, told of each turn at the wheel-over line and of the next
//! leg at the end of the arc, as a chart system would.

mod bench;
mod document;
mod manoeuvre;
mod metrics;
mod sample;

pub use bench::BenchRun;
pub use document::{Bench, Conditions, Disturbance, Document};
pub use manoeuvre::{Manoeuvre, ManoeuvreRow, Plan, SpiralRow};
pub use metrics::Report;
pub use sample::Sample;

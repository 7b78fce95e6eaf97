//! The dialogue checker (CON-1): takes the lines of both directions, recorded or live, and reports each breach.
//!
//! In: lines with their time and number. Out: [`Breach`]es, and which situation lasted from when to when.
//! It is outside the control path: nothing steers by it (CON-2).
//!
//! Lines of the chart system belong together in bursts, one a second; a burst is judged when it is complete.
//! Without times a burst counts as a second, and cadence is not judged.

mod autopilot;
mod cadence;
mod chart;
mod checker;
mod fields;
mod live;
mod report;
mod timed;

pub use checker::Checker;
pub use live::{Found, Live};
pub use report::{Breach, Span};
pub use timed::{Timed, timed};

#[cfg(test)]
mod tests;

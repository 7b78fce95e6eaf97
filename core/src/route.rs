//! Routes: waypoints, legs, turns with their wheel-over lines, and where a ship is along them.
//!
//! In go waypoints and limits; out comes a [`Route`] that fits, or a [`RouteFault`] that names leg and reason.
//!
//! **Invariant:** a [`Route`] cannot be wrong: every turn fits both its legs with its forwarding distance and
//! the time for the early course change indication (TCS-11).

mod embedded;
mod fault;
mod fit;
pub mod foreign;
mod leg;
mod limits;
mod plan;
mod progress;
mod turn;
mod waypoint;

pub use embedded::{embedded, embedded_start};
pub use fault::RouteFault;
pub use leg::Leg;
pub use limits::RouteLimits;
pub use plan::Route;
pub use progress::{Phase, Progress};
pub use turn::Turn;
pub use waypoint::Waypoint;

#[cfg(test)]
mod tests;

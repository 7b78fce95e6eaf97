//! What a route is checked against when it is loaded (TCS-11).

use crate::units::{Distance, Radius, RateOfTurn, Speed};
use serde::{Deserialize, Serialize};

/// What a route is checked against when it is loaded.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct RouteLimits {
    /// Planned speed.
    pub speed: Speed,
    /// Time on the forwarding distance: half the 50 s over which the autopilot averages the planned
    /// curvature, 2 s of its lead, and 1 s for the period of HTC.
    pub forwarding_s: f64,
    /// Time before wheel-over at which the course change must be indicated at the latest (TCS-11).
    pub early_s: f64,
    /// Distance in which the ship settles on a leg after a turn.
    pub settling: Distance,
    /// Smallest radius.
    pub smallest_radius: Radius,
    /// Largest radius.
    pub largest_radius: Radius,
    /// Highest rate of turn at the planned speed.
    pub highest_rate: RateOfTurn,
    /// Largest change of course at one waypoint, degrees.
    pub largest_turn_deg: f64,
}

impl Default for RouteLimits {
    fn default() -> Self {
        Self {
            speed: Speed::from_knots(15.0),
            forwarding_s: 28.0,
            early_s: 60.0,
            settling: Distance::from_m(320.0),
            smallest_radius: Radius::from_nm(0.1),
            largest_radius: Radius::from_nm(10.0),
            highest_rate: RateOfTurn::from_deg_per_min(120.0),
            largest_turn_deg: 150.0,
        }
    }
}

impl RouteLimits {
    /// The forwarding distance at a speed.
    #[must_use]
    pub fn forwarding(&self, speed: Speed) -> Distance {
        Distance::from_m(speed.mps() * self.forwarding_s)
    }
}

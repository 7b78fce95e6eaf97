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
mod progress;
mod turn;

pub use embedded::{embedded, embedded_start};
pub use fault::RouteFault;
pub use leg::Leg;
pub use progress::{Phase, Progress};
pub use turn::Turn;

use crate::geo::Position;
use crate::units::{Distance, Radius, RateOfTurn, Speed};
use alloc::string::String;
use alloc::vec::Vec;
use serde::{Deserialize, Serialize};

/// A waypoint as it is planned.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Waypoint {
    /// Identifier; displays show its first three characters (TCS-5).
    pub id: String,
    /// Place.
    pub position: Position,
    /// Radius of the turn there; the first and the last waypoint have none.
    pub radius: Option<Radius>,
    /// Corridor of the leg that leads here, to port.
    pub limit_port: Distance,
    /// Corridor of the leg that leads here, to starboard.
    pub limit_starboard: Distance,
}

impl Waypoint {
    /// A waypoint with the usual corridor of a tenth of a mile on each side.
    #[must_use]
    pub fn new(id: &str, position: Position, radius: Option<Radius>) -> Self {
        let corridor = Distance::from_nm(0.1);
        Self {
            id: id.into(),
            position,
            radius,
            limit_port: corridor,
            limit_starboard: corridor,
        }
    }
}

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

/// A route whose turns fit its legs.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(try_from = "Plan", into = "Plan")]
pub struct Route {
    name: String,
    limits: RouteLimits,
    waypoints: Vec<Waypoint>,
    legs: Vec<Leg>,
    turns: Vec<Turn>,
}

/// What a route is made from; the form in which it is kept.
#[derive(Clone, Debug, Serialize, Deserialize)]
struct Plan {
    name: String,
    waypoints: Vec<Waypoint>,
    limits: RouteLimits,
}

impl TryFrom<Plan> for Route {
    type Error = RouteFault;
    fn try_from(plan: Plan) -> Result<Self, RouteFault> {
        Self::new(&plan.name, plan.waypoints, plan.limits)
    }
}

impl From<Route> for Plan {
    fn from(route: Route) -> Self {
        Self {
            name: route.name,
            waypoints: route.waypoints,
            limits: route.limits,
        }
    }
}

impl Route {
    /// Builds the legs and turns and checks that they fit.
    ///
    /// # Errors
    /// Fewer than two waypoints; a place that is not on the globe; two waypoints on one place; an identifier
    /// that cannot be sent; a turn without a radius, too sharp, too tight, too wide, or too fast at the planned
    /// speed; a radius that does not fit its legs, with the largest that does (TCS-11).
    pub fn new(
        name: &str,
        waypoints: Vec<Waypoint>,
        limits: RouteLimits,
    ) -> Result<Self, RouteFault> {
        fit::waypoints(&waypoints)?;
        let legs: Vec<Leg> = waypoints
            .windows(2)
            .map(|pair| Leg::new(&pair[0], &pair[1]))
            .collect();
        let mut turns = Vec::with_capacity(legs.len().saturating_sub(1));
        for (index, pair) in legs.windows(2).enumerate() {
            turns.push(fit::turn(
                &waypoints[index + 1],
                &pair[0],
                &pair[1],
                &limits,
            )?);
        }
        fit::legs(&waypoints, &legs, &turns, &limits)?;
        Ok(Self {
            name: name.into(),
            limits,
            waypoints,
            legs,
            turns,
        })
    }

    /// Its name.
    #[must_use]
    pub fn name(&self) -> &str {
        &self.name
    }
    /// What it was checked against.
    #[must_use]
    pub const fn limits(&self) -> &RouteLimits {
        &self.limits
    }
    /// Its waypoints, at least two.
    #[must_use]
    pub fn waypoints(&self) -> &[Waypoint] {
        &self.waypoints
    }
    /// Its legs; leg `k` leads from waypoint `k` to waypoint `k + 1`.
    #[must_use]
    pub fn legs(&self) -> &[Leg] {
        &self.legs
    }
    /// Its turns; turn `k` leads from leg `k` to leg `k + 1`.
    #[must_use]
    pub fn turns(&self) -> &[Turn] {
        &self.turns
    }
    /// The leg with that index, the last one where there are fewer.
    #[must_use]
    pub fn leg(&self, index: usize) -> &Leg {
        &self.legs[index.min(self.legs.len() - 1)]
    }
    /// The turn at the end of a leg; none at the end of the last.
    #[must_use]
    pub fn turn_after(&self, leg: usize) -> Option<&Turn> {
        self.turns.get(leg)
    }
    /// The longest forwarding distance that leg `leg` has room for before its turn.
    #[must_use]
    pub fn room_for_forwarding(&self, leg: usize) -> Distance {
        let before = leg.checked_sub(1).and_then(|k| self.turns.get(k));
        let taken = before.map_or(0.0, |turn| turn.tangent().m())
            + self.turn_after(leg).map_or(0.0, |turn| turn.tangent().m());
        Distance::from_m((self.leg(leg).length().m() - taken).max(0.0))
    }
}

#[cfg(test)]
mod tests;

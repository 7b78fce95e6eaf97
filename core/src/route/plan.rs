//! A route: legs and turns that fit each other, or it does not exist.

use super::fault::RouteFault;
use super::fit;
use super::leg::Leg;
use super::limits::RouteLimits;
use super::turn::Turn;
use super::waypoint::Waypoint;
use crate::units::Distance;
use alloc::string::String;
use alloc::vec::Vec;
use serde::{Deserialize, Serialize};

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

//! Where a ship is along a route: on a leg, on the forwarding distance, on an arc, or past the end.
//!
//! Switching is geometry, never time: the wheel-over line, the beginning of the arc and the end of the arc are
//! lines across the leg.

use super::{Leg, Route, Turn};
use crate::geo::Position;
use crate::units::Distance;
use serde::{Deserialize, Serialize};

/// The part of the route that is sailed; each but the last with the index of its leg, from 0.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Phase {
    /// On a leg before the wheel-over line.
    Leg(usize),
    /// Between the wheel-over line and the beginning of the arc at the end of this leg.
    Forwarding(usize),
    /// On the arc at the end of this leg.
    Arc(usize),
    /// Past the last waypoint.
    Past,
}

impl Phase {
    /// Whether the ship is between a wheel-over line and the end of its arc.
    #[must_use]
    pub const fn turning(self) -> bool {
        matches!(self, Self::Forwarding(_) | Self::Arc(_))
    }
}

/// The monitor of a ship's way along a route.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Progress {
    phase: Phase,
}

impl Progress {
    /// A ship at `position` that has just loaded the route: on the nearest leg, or on the turn that she is in.
    /// Past the last waypoint with the first one close by, she is on her way to the first leg (a circuit).
    #[must_use]
    pub fn locate(route: &Route, position: Position, forwarding: Distance) -> Self {
        let beyond = |leg: &Leg| {
            let along = leg.along(position).m();
            let excess = (along - leg.length().m()).max(-along).max(0.0);
            libm::hypot(excess, leg.cross_track(position).m())
        };
        let mut nearest = 0;
        for (index, leg) in route.legs().iter().enumerate() {
            if beyond(leg) + 1.0 < beyond(route.leg(nearest)) {
                nearest = index;
            }
        }
        let last = route.legs().len() - 1;
        let passed = nearest == last && route.leg(last).remaining(position).m() < 0.0;
        if passed && beyond(route.leg(0)) < Distance::from_nm(1.0).m() {
            nearest = 0;
        }
        // Near the corner the ship may still be on the arc that leads to this leg.
        let on_arc = nearest.checked_sub(1).filter(|previous| {
            route.turn_after(*previous).is_some_and(|turn| {
                route.leg(nearest).along(position) < turn.tangent()
                    && libm::fabs(turn.cross_track(position).m()) < turn.radius().m()
            })
        });
        let mut progress = Self {
            phase: on_arc.map_or(Phase::Leg(nearest), Phase::Arc),
        };
        progress.advance(route, position, forwarding);
        progress
    }

    /// The part that is sailed.
    #[must_use]
    pub const fn phase(&self) -> Phase {
        self.phase
    }

    /// Moves on past every line that the position lies beyond.
    pub fn advance(&mut self, route: &Route, position: Position, forwarding: Distance) {
        while let Some(next) = self.next(route, position, forwarding) {
            self.phase = next;
        }
    }

    fn next(&self, route: &Route, position: Position, forwarding: Distance) -> Option<Phase> {
        match self.phase {
            Phase::Leg(leg) => {
                let line = self.to_wheel_over(route, position, forwarding)?;
                let next = route.turn_after(leg);
                (line.m() <= 0.0).then_some(next.map_or(Phase::Past, |_| Phase::Forwarding(leg)))
            }
            Phase::Forwarding(leg) => {
                let turn = route.turn_after(leg)?;
                (route.leg(leg).remaining(position) <= turn.tangent()).then_some(Phase::Arc(leg))
            }
            Phase::Arc(leg) => {
                let turn = route.turn_after(leg)?;
                (route.leg(leg + 1).along(position) >= turn.tangent())
                    .then_some(Phase::Leg(leg + 1))
            }
            Phase::Past => None,
        }
    }

    /// The leg whose course is followed or, in a turn, left; none past the end.
    #[must_use]
    pub const fn leg(&self) -> Option<usize> {
        match self.phase {
            Phase::Leg(leg) | Phase::Forwarding(leg) | Phase::Arc(leg) => Some(leg),
            Phase::Past => None,
        }
    }

    /// The turn that is sailed or comes next.
    #[must_use]
    pub fn turn<'a>(&self, route: &'a Route) -> Option<&'a Turn> {
        route.turn_after(self.leg()?)
    }

    /// Distance along the track to the wheel-over line of this leg, or to the last waypoint; negative past it.
    #[must_use]
    pub fn to_wheel_over(
        &self,
        route: &Route,
        position: Position,
        forwarding: Distance,
    ) -> Option<Distance> {
        let leg = self.leg()?;
        let before = route
            .turn_after(leg)
            .map_or(0.0, |turn| turn.before(forwarding).m());
        Some(Distance::from_m(
            route.leg(leg).remaining(position).m() - before,
        ))
    }
}

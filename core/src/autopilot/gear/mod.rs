//! The steering gear: the order with its limit and slew, what the rudder makes of it, and what is said of both (AP-4, FA6, FA11).
//!
//! In: the rudder that is wanted, or an order that somebody else gave; the responses. Out: the orders, whether they are followed,
//! RSA and ROR. A single rudder, or linked ones, stand on the starboard side of the sentences. An independent pair acts as
//! the mean of its two angles, so where one side has failed the other makes up for it, within its own limit:
//!
//! ```text
//! both follow       order_s = order_p = wanted
//! one has failed    order_healthy = 2 wanted - where the failed one is taken to stand;   order_failed = wanted
//! ```
//! The laws are told what the pair gives, so nothing winds up while the healthy side is at its limit.
//!
//! **Invariant:** of each side `|order| <= limit` and `|order - last order| <= slew dt`, whatever is wanted (FA6).

mod mount;
mod pair;
mod response;
mod rudder;
mod side;
mod told;

use super::notices::Notice;
use super::steering::{Given, SteeringSettings, Terms, Wanted};
use crate::nmea::{CommandSource, DataStatus, Ror, Rsa};
use crate::settings::Rudders;
use crate::time::Stamp;
use crate::units::{Distance, Heading, RateOfTurn, RudderAngle};
pub(super) use mount::Mount;
use serde::{Deserialize, Serialize};
use side::Side;

/// Angles of the single rudder or the starboard one of a pair, and of the port one.
pub(super) type Angles = [Option<RudderAngle>; 2];

/// A rudder order and why.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Steered {
    /// The order.
    pub order: RudderAngle,
    /// The heading that is steered now.
    pub hts: Heading,
    /// The rate of turn that is steered now.
    pub rate_reference: RateOfTurn,
    /// Cross-track distance from the path, ship right of it positive.
    pub cross_track: Option<Distance>,
    /// What the order is made of.
    pub terms: Terms,
    /// The order is at its limit.
    pub limited: bool,
}

/// The gear, as the autopilot has it.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Gear {
    /// The single rudder, the linked ones, or the starboard one of a pair.
    starboard: Side,
    /// The port one of an independent pair.
    port: Option<Side>,
    steered: Option<Steered>,
}

impl Gear {
    /// A gear with these rudders.
    #[must_use]
    pub fn of(rudders: Rudders) -> Self {
        let mut gear = Self::default();
        gear.fit(rudders);
        gear
    }

    /// Has other rudders from now on; a second one begins at the order of the first.
    pub fn fit(&mut self, rudders: Rudders) {
        self.port = match (rudders, self.port.take()) {
            (Rudders::Independent, None) => Some(Side::beside(&self.starboard)),
            (Rudders::Independent, pair) => pair,
            (Rudders::Single | Rudders::Linked, _) => None,
        };
    }

    /// The order in force; where none is given, the last one. Of a pair: the single rudder that it is as good as.
    #[must_use]
    pub fn order(&self) -> RudderAngle {
        RudderAngle::from_deg(match &self.port {
            None => self.starboard.order(),
            Some(port) => pair::order(&self.starboard, port),
        })
    }

    /// The order of each side, starboard or single first.
    pub(super) fn orders(&self) -> Angles {
        let order = |side: &Side| RudderAngle::from_deg(side.order());
        [Some(order(&self.starboard)), self.port.as_ref().map(order)]
    }

    /// What became of the rudder that was wanted last, for the laws.
    #[must_use]
    pub fn given(&self) -> Given {
        Given {
            order: self.order(),
            cut: match &self.port {
                None => self.starboard.rudder.cut(),
                Some(port) => pair::cut(&self.starboard, port),
            },
        }
    }

    /// What was steered in the last step; absent where the order is frozen or none is given.
    #[must_use]
    pub const fn steered(&self) -> Option<&Steered> {
        self.steered.as_ref()
    }

    /// Takes over at an order that somebody else gave, without a bump (FA6).
    pub fn engage(&mut self, order: RudderAngle) {
        self.engage_at([Some(order); 2]);
    }

    /// Takes over where each rudder was left; at its own order where that is not known.
    pub(super) fn engage_at(&mut self, left: Angles) {
        for (side, left) in self.sides_mut().zip(left) {
            let order = left.map_or(side.order(), RudderAngle::deg);
            side.rudder.engage(order);
        }
    }

    /// What is wanted next follows from something else: it is joined without a bump (FA6).
    pub fn join(&mut self) {
        for side in self.sides_mut() {
            side.rudder.join();
        }
    }

    fn sides_mut(&mut self) -> impl Iterator<Item = &mut Side> {
        core::iter::once(&mut self.starboard).chain(&mut self.port)
    }

    /// Goes towards the wanted rudder for `dt` seconds, within the limit and the gear's own slew and maximum.
    pub fn steer(
        &mut self,
        wanted: &Wanted,
        limit: RudderAngle,
        ship: &SteeringSettings,
        dt: f64,
    ) -> Steered {
        if wanted.joins {
            self.join();
        }
        if wanted.ordered {
            self.sides_mut().for_each(|side| side.rudder.obey());
        }
        let limit = limit.deg().min(ship.rudder_max.deg());
        let rudder = wanted.rudder.deg();
        let step = |side: &mut Side, wanted| side.rudder.step(wanted, limit, ship.slew, dt);
        let limited = match &mut self.port {
            None => step(&mut self.starboard, rudder),
            Some(port) => pair::step(&mut self.starboard, port, rudder, step),
        };
        let steered = Steered {
            order: self.order(),
            hts: wanted.hts,
            rate_reference: wanted.rate_reference,
            cross_track: wanted.cross_track,
            terms: wanted.terms,
            limited,
        };
        self.steered = Some(steered);
        steered
    }

    /// FA7: the order stays as it is.
    pub(super) const fn freeze(&mut self) {
        self.steered = None;
    }

    /// FA11, AP-4: holds the responses against the orders in force, where any are given, and says which rudder fails.
    pub(super) fn watch(
        &mut self,
        now: Stamp,
        ordered: bool,
        [first, second]: Angles,
        slew: f64,
    ) -> impl Iterator<Item = Notice> {
        let starboard = &mut self.starboard;
        let said = match &mut self.port {
            None => told::of_single(starboard.watch(now, ordered, first, slew)),
            Some(port) => {
                let first = starboard.watch_in_pair(now, ordered, first, slew);
                let second = port.watch_in_pair(now, ordered, second, slew);
                told::of_pair([first, second], starboard.has_failed() && port.has_failed())
            }
        };
        said.into_iter().flatten()
    }

    /// The rudder that acts, for the laws: of a pair the mean of the sides that are believed; absent where none is.
    pub(super) fn acting(&self, [first, second]: Angles) -> Option<RudderAngle> {
        let starboard = self.starboard.acting(first);
        let port = self.port.as_ref().and_then(|port| port.acting(second));
        mean(starboard, port)
    }

    /// The rudder as a hand left it: of a pair the mean of the sides that say so.
    pub(super) fn left(&self, [first, second]: Angles) -> Option<RudderAngle> {
        let port = second.filter(|_| self.port.is_some());
        mean(first.map(RudderAngle::deg), port.map(RudderAngle::deg))
    }

    /// AP-4: of a single rudder the port side is null with V. `followed`: no rudder fails.
    pub(super) fn rsa(&self, [first, second]: Angles, followed: bool) -> Rsa {
        let valid = match self.port {
            None => followed,
            Some(_) => !self.starboard.has_failed(),
        };
        let port = self.port.as_ref();
        let second = second.filter(|_| port.is_some());
        let port_valid = port.is_some_and(|port| !port.has_failed());
        Rsa {
            starboard: first.map(RudderAngle::deg),
            starboard_status: Some(status(first.is_some() && valid)),
            port: second.map(RudderAngle::deg),
            port_status: Some(status(second.is_some() && port_valid)),
        }
    }

    /// AP-1: where no order is given both sides are null with V. The order to a rudder that has failed goes on, with A.
    pub(super) fn ror(&self, given: bool) -> Ror {
        let said = |order: Option<RudderAngle>| order.filter(|_| given).map(RudderAngle::deg);
        let [starboard, port] = self.orders().map(said);
        Ror {
            starboard,
            starboard_status: Some(status(starboard.is_some())),
            port,
            port_status: Some(status(port.is_some())),
            source: Some(CommandSource::Bridge),
        }
    }
}

/// The mean of what is there, degrees.
fn mean(one: Option<f64>, other: Option<f64>) -> Option<RudderAngle> {
    Some(RudderAngle::from_deg(match (one, other) {
        (Some(one), Some(other)) => 0.5 * (one + other),
        (one, other) => one.or(other)?,
    }))
}

const fn status(valid: bool) -> DataStatus {
    if valid {
        DataStatus::Valid
    } else {
        DataStatus::Invalid
    }
}

#[cfg(test)]
mod tests;

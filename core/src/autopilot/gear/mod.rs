//! The steering gear: the order with its limit and slew, what the rudder makes of it, and what is said of both (AP-4, FA6, FA11).
//!
//! In: the rudder that is wanted, or an order that somebody else gave; the response. Out: the order, whether it is followed,
//! RSA and ROR. One rudder stands here, on the starboard side of the sentences (AP-4). All that belongs to one rudder is in
//! `rudder` (its order) and `response` (whether it follows), so a pair is two of each.
//!
//! **Invariant:** `|order| <= limit` and `|order - last order| <= slew dt`, whatever is wanted (FA6).

mod response;
mod rudder;

use super::steering::{Given, SteeringSettings, Terms, Wanted};
use crate::nmea::{CommandSource, DataStatus, Ror, Rsa};
use crate::time::Stamp;
use crate::units::{Distance, Heading, RateOfTurn, RudderAngle};
pub(super) use response::Follows;
use response::Response;
use rudder::Rudder;
use serde::{Deserialize, Serialize};

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
    rudder: Rudder,
    response: Response,
    steered: Option<Steered>,
}

impl Gear {
    /// The order in force; where none is given, the last one.
    #[must_use]
    pub const fn order(&self) -> RudderAngle {
        RudderAngle::from_deg(self.rudder.order())
    }

    /// What became of the rudder that was wanted last, for the laws.
    #[must_use]
    pub const fn given(&self) -> Given {
        Given {
            order: self.order(),
            cut: self.rudder.cut(),
        }
    }

    /// What was steered in the last step; absent where the order is frozen or none is given.
    #[must_use]
    pub const fn steered(&self) -> Option<&Steered> {
        self.steered.as_ref()
    }

    /// Takes over at an order that somebody else gave, without a bump (FA6).
    pub fn engage(&mut self, order: RudderAngle) {
        self.rudder.engage(order.deg());
    }

    /// What is wanted next follows from something else: it is joined without a bump (FA6).
    pub fn join(&mut self) {
        self.rudder.join();
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
            self.rudder.join();
        }
        if wanted.ordered {
            self.rudder.obey();
        }
        let limit = limit.deg().min(ship.rudder_max.deg());
        let limited = self.rudder.step(wanted.rudder.deg(), limit, ship.slew, dt);
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

    /// FA11, AP-4: holds the response against the order in force, absent where the gear is given none.
    pub(super) fn watch(
        &mut self,
        now: Stamp,
        order: Option<RudderAngle>,
        response: Option<RudderAngle>,
        slew: f64,
    ) -> Follows {
        self.response.watch(now, order, response, slew)
    }
}

/// AP-4: one rudder; the port side is null with V. `valid`: the response may be used.
pub(super) fn rsa(response: Option<RudderAngle>, valid: bool) -> Rsa {
    Rsa {
        starboard: response.map(RudderAngle::deg),
        starboard_status: Some(status(response.is_some() && valid)),
        port: None,
        port_status: Some(DataStatus::Invalid),
    }
}

/// AP-1: in STANDBY there is no order.
pub(super) fn ror(order: Option<RudderAngle>) -> Ror {
    Ror {
        starboard: order.map(RudderAngle::deg),
        starboard_status: Some(status(order.is_some())),
        port: None,
        port_status: Some(DataStatus::Invalid),
        source: Some(CommandSource::Bridge),
    }
}

const fn status(valid: bool) -> DataStatus {
    if valid {
        DataStatus::Valid
    } else {
        DataStatus::Invalid
    }
}

//! The world's steering gear: the orders it obeys, what it feeds back, and what is done to each rudder.
//!
//! A single rudder goes by the starboard side of ROR and RSA, a pair by both. An order that is older than 2 s, or has status
//! V, leaves its rudder where it is. A rudder that sticks tells where it stands.

use super::hull::{Drive, Hull};
use crate::command::FaultKind;
use crate::nmea::{DataStatus, Ror, Rsa};
use crate::time::Stamp;
use crate::units::RudderAngle;
use serde::{Deserialize, Serialize};

/// Age at which a rudder order is no longer obeyed, milliseconds.
const ORDER_AGE: u64 = 2000;

/// The orders in force and the injuries, the starboard rudder first.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub(super) struct Steering {
    /// Last valid order, rad, and when it came.
    orders: [Option<(f64, Stamp)>; 2],
    stuck: [bool; 2],
}

impl Steering {
    /// The same gear without an order.
    pub(super) fn forgotten(self) -> Self {
        Self {
            orders: [None; 2],
            ..self
        }
    }

    /// Has a rudder stick or frees it; false of what no rudder suffers, or of one that she has not.
    pub(super) fn injure(&mut self, kind: FaultKind, pair: bool, on: bool) -> bool {
        let side = match kind {
            FaultKind::Stuck => 0,
            FaultKind::StuckPort if pair => 1,
            _ => return false,
        };
        self.stuck[side] = on;
        true
    }

    /// Takes the orders of a ROR.
    pub(super) fn hear(&mut self, now: Stamp, ror: &Ror) {
        let sides = [
            (ror.starboard, ror.starboard_status),
            (ror.port, ror.port_status),
        ];
        self.orders = sides.map(|(angle, status)| {
            let angle = angle.filter(|_| status == Some(DataStatus::Valid));
            angle.map(|degrees| (RudderAngle::from_deg(degrees).rad(), now))
        });
    }

    /// What acts on the hull now.
    pub(super) fn drive(&self, now: Stamp, hull: &Hull, pair: bool, drive: &mut Drive) {
        let order = |order: Option<(f64, Stamp)>, rudder: f64| match order {
            Some((order, at)) if now.since(at) <= ORDER_AGE => order,
            _ => rudder,
        };
        drive.order = order(self.orders[0], hull.rudder);
        drive.port_order = pair.then(|| order(self.orders[1], hull.port_rudder));
        drive.stuck = self.stuck;
    }

    /// What the gear feeds back.
    pub(super) fn rsa(hull: &Hull, pair: bool) -> Rsa {
        let port_status = if pair {
            DataStatus::Valid
        } else {
            DataStatus::Invalid
        };
        Rsa {
            starboard: Some(hull.rudder.to_degrees()),
            starboard_status: Some(DataStatus::Valid),
            port: pair.then(|| hull.port_rudder.to_degrees()),
            port_status: Some(port_status),
        }
    }
}

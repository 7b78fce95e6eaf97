//! How the motor of a tiller is mounted: from the rudder's angle to the position of the gear, and back (EMC-7).
//!
//! `position = s rudder + centre`, with `s = 1` of a motor on the starboard side and `-1` of one on the port side; degrees,
//! starboard positive. It acts on the gear's port alone: everybody else is told the rudder's angle.

use crate::nmea::Ror;
use crate::settings::{Settings, TillerSide};
use crate::units::RudderAngle;

/// Side and centre of the gear.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(in super::super) struct Mount {
    sign: f64,
    centre: f64,
}

impl Mount {
    /// As it is set.
    pub(in super::super) const fn of(settings: &Settings) -> Self {
        Self {
            sign: match settings.tiller_side {
                TillerSide::Starboard => 1.0,
                TillerSide::Port => -1.0,
            },
            centre: settings.tiller_centre,
        }
    }

    /// The angles of rudders whose gear says these positions.
    pub(in super::super) fn rudders(
        self,
        positions: [Option<RudderAngle>; 2],
    ) -> [Option<RudderAngle>; 2] {
        let rudder = |at: RudderAngle| RudderAngle::from_deg(self.sign * (at.deg() - self.centre));
        positions.map(|position| position.map(rudder))
    }

    /// The positions that the gear is ordered to for the orders to the rudders.
    pub(in super::super) fn positions(self, orders: Ror) -> Ror {
        let position = |order: f64| self.sign * order + self.centre;
        Ror {
            starboard: orders.starboard.map(position),
            port: orders.port.map(position),
            ..orders
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    // EMC-7: what is ordered and what is fed back are mounted alike.
    #[test]
    fn a_position_and_its_rudder_belong_together() {
        let check = |side, centre, order: f64, expect: f64| {
            let settings = Settings {
                tiller_side: side,
                tiller_centre: centre,
                ..Settings::default()
            };
            let mount = Mount::of(&settings);
            let orders = Ror {
                starboard: Some(order),
                ..Ror::default()
            };
            let position = mount.positions(orders).starboard.unwrap();
            assert_eq!(position, expect, "{side:?} {centre}");
            let heard = [Some(RudderAngle::from_deg(position)), None];
            let back = mount.rudders(heard)[0].unwrap().deg();
            assert!((back - order).abs() < 1e-9, "{back}");
        };
        check(TillerSide::Starboard, 0.0, 10.0, 10.0);
        check(TillerSide::Starboard, 2.0, 10.0, 12.0);
        check(TillerSide::Port, 0.0, 10.0, -10.0);
        check(TillerSide::Port, 2.0, 10.0, -8.0);
    }
}

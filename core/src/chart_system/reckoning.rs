//! Dead reckoning while the chart system has no position and controls (TCS-14); off unless it is set.
//!
//! `p += (U_water heading + current) dt` from the last place that was known; without a log the speed over ground of that
//! moment stands for `U_water`. What it may be off, two sigma, metres, after `t` seconds and a way `s = sum U_water dt`:
//! `sqrt(20^2 + (0.06 s)^2 + (0.3 t)^2)`: a fix, 3 % of the way across and along, 0.15 m/s of a current that has changed
//! (own numbers).
//!
//! **Invariant:** it ends by itself when two sigma exceed the corridor, and after ten minutes. What is sent of it is
//! marked E (estimated); an autopilot that takes an estimated position for none, as ours does (AP-9), falls back by TCS-8.

use super::place::{Here, OverGround};
use crate::geo::{Point, Position};
use crate::nmea::ModeIndicator;
use crate::time::Stamp;
use crate::units::{Course, Distance, Speed};
use serde::{Deserialize, Serialize};

/// Two sigma: of the last fix, metres; for each metre of way; for each second.
const FIX_M: f64 = 20.0;
const OF_WAY: f64 = 0.06;
const OF_TIME_MPS: f64 = 0.3;

/// The last place that was known, and how fast the ship went through the water there, as far as that is known.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub(super) struct Known {
    pub(super) place: Position,
    pub(super) at: Stamp,
    pub(super) speed: Speed,
}

/// A reckoning that goes on.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub(super) struct Reckoning {
    pub(super) place: Position,
    pub(super) at: Stamp,
    /// Metres a second made good, north and east.
    pub(super) drift: Point,
    /// Speed that stands for a log's.
    pub(super) speed: Speed,
    pub(super) since: Stamp,
    pub(super) way_m: f64,
    pub(super) called: Stamp,
}

impl Reckoning {
    /// What it may be off, two sigma.
    pub(super) fn two_sigma(&self) -> Distance {
        let seconds = self.at.since(self.since) as f64 / 1_000.0;
        let (way, time) = (OF_WAY * self.way_m, OF_TIME_MPS * seconds);
        Distance::from_m(libm::sqrt(FIX_M * FIX_M + way * way + time * time))
    }

    /// The place at a time.
    pub(super) fn here(&self, now: Stamp) -> Here {
        let seconds = now.since(self.at) as f64 / 1_000.0;
        let by = Point {
            north: self.drift.north * seconds,
            east: self.drift.east * seconds,
        };
        Here {
            position: self.place.moved(by),
            utc: None,
            mode: ModeIndicator::Estimated,
        }
    }

    /// Course and speed made good.
    pub(super) fn over_ground(&self) -> OverGround {
        let (north, east) = (self.drift.north, self.drift.east);
        OverGround {
            course: Course::from_deg(libm::atan2(east, north).to_degrees()),
            speed: Speed::from_mps(libm::hypot(north, east)),
            mode: ModeIndicator::Estimated,
        }
    }
}

impl From<Known> for Reckoning {
    fn from(known: Known) -> Self {
        Self {
            place: known.place,
            at: known.at,
            drift: Point::default(),
            speed: known.speed,
            since: known.at,
            way_m: 0.0,
            called: known.at,
        }
    }
}

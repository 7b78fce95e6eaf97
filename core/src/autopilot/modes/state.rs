//! What every mode is to the autopilot: a row of the table, a demand, a report; and what it knows of the ship.

use super::table::Row;
use crate::autopilot::gear::Steered;
use crate::autopilot::steering::Demand;
use crate::geo::Point;
use crate::nmea::Htd;
use crate::path::{Part, Path};
use crate::settings::Settings;
use crate::time::Stamp;
use crate::units::{Heading, RudderAngle};

/// What each mode is.
pub(super) trait State {
    /// Its row in the table.
    const ROW: Row;

    /// What it asks of the steering; absent where no orders are computed.
    fn demand(&mut self, _: &Facts) -> Option<Demand> {
        None
    }

    /// Heading to steer in force.
    fn hts(&self, _: &Facts) -> Option<Heading> {
        None
    }

    /// Adds what HTD says of this mode alone.
    fn htd(&self, _: &Facts, _: &mut Htd) {}
}

/// What modes and their transitions know of the ship and what is set.
#[derive(Clone, Debug, PartialEq)]
pub(in super::super) struct Facts {
    /// The time.
    pub(in super::super) now: Stamp,
    /// Actual heading; the last usable one where it is lost.
    pub(in super::super) heading: Heading,
    /// Rudder order in force.
    pub(in super::super) order: RudderAngle,
    /// Where the ship is, by dead reckoning as long as that is worth something.
    pub(in super::super) place: Option<Point>,
    /// What the steering gave last.
    pub(in super::super) steered: Option<Steered>,
    /// What is set.
    pub(in super::super) settings: Settings,
}

impl Facts {
    /// Whether the ship is on that part of a path.
    pub(super) fn is_on(&self, path: &Path, part: Part) -> bool {
        self.place
            .is_some_and(|place| path.progress(place).part == part)
    }
}

//! What every mode is to the autopilot: a row of the table, a demand, a report, and what it does with commands and places.

use super::former::Former;
use super::set_value::SetValue;
use super::table::Row;
use crate::alerts::Alert;
use crate::autopilot::facts::{Facts, Outlook};
use crate::autopilot::plotter::Leg;
use crate::autopilot::remote::Charted;
use crate::autopilot::steering::Demand;
use crate::command::{Refusal, Remote};
use crate::geo::Point;
use crate::nmea::Htd;
use crate::path::Path;
use crate::time::Stamp;
use crate::units::{Distance, Heading};
use alloc::string::String;
use alloc::vec::Vec;

/// What others ask the ship to follow.
#[derive(Clone, Copy, Debug)]
pub(in super::super) struct Told<'a> {
    /// The chart system's command in force.
    pub(super) command: Option<Remote>,
    /// What it says beside, in the own plane.
    pub(super) charted: Charted<'a>,
    /// The plotter's leg in force.
    pub(super) plotted: Option<&'a Leg>,
}

/// The plane is laid anew so far from where it touches, metres.
pub(super) const PLANE_M: f64 = 10_000.0;

/// A mode is over: AUTO goes on.
pub(in super::super) struct Ended {
    /// On this heading.
    pub(super) set: Heading,
    /// Why, in an officer's words.
    pub(super) why: String,
    /// What is raised.
    pub(super) alert: Option<Alert>,
}

/// What is fixed of each mode.
pub(super) trait Listed: Sized {
    /// Its row in the table.
    const ROW: Row;

    /// One state for each way in which it can go on, by the name that `docs/modes.md` gives it. The ship stands at the
    /// origin of the plane then, on course 000.
    fn examples() -> Vec<(&'static str, Self)>;
}

/// What each mode does. A mode says only what is its own; the rest is as it stands here.
pub(in super::super) trait State {
    /// What it asks of the steering; absent where no orders are computed.
    fn demand(&mut self, _: &Facts<'_>) -> Option<Demand> {
        None
    }

    /// Heading to steer in force.
    fn hts(&self, _: &Facts<'_>) -> Option<Heading> {
        None
    }

    /// Adds what HTD says of this mode alone.
    fn htd(&self, _: &Facts<'_>, _: &mut Htd) {}

    /// Sets what the operator sets in this mode, or says where that is set.
    fn set(&mut self, _: &Facts<'_>, set: SetValue) -> Result<String, Refusal> {
        Err(set.refused())
    }

    /// What is set in it by a number, in the unit of its order; absent in a mode where a heading or nothing is set.
    fn set_value(&self) -> Option<f64> {
        None
    }

    /// What DODGE returns to from here; absent where it is not selected.
    fn former(&self) -> Option<Former> {
        None
    }

    /// Takes what is heard, once a step; what ends the mode.
    fn watch(&mut self, _: &Outlook<'_>) -> Option<Ended> {
        None
    }

    /// What TRACK FAIL tells the officer of who steers now.
    fn steers(&self, row: &Row) -> &'static str {
        row.steers
    }

    /// The path that is sailed.
    fn path(&self) -> Option<&Path> {
        None
    }

    /// How far from where the plane touches it is laid anew, metres; absent while it has to lie.
    fn plane_m(&self) -> Option<f64> {
        Some(PLANE_M)
    }

    /// Carries its places into another plane.
    fn carry(&mut self, _: &dyn Fn(Point) -> Point) {}

    /// Whether a command of the chart system may be followed as it is (SEN-5).
    fn accepts(&mut self, _: Remote) -> Result<(), Refusal> {
        Ok(())
    }

    /// Follows an accepted command for this mode.
    fn follow(&mut self, _: Stamp, _: Remote) {}

    /// Holds the command in force against everything else that is heard, once a step, and goes by it; or says what does
    /// not agree.
    fn agree(&mut self, _: &Outlook<'_>, _: Told<'_>) -> Result<(), String> {
        Ok(())
    }

    /// When all that is heard last agreed with what is steered; absent where nothing has to.
    fn agreed(&self) -> Option<Stamp> {
        None
    }

    /// What is done without though it should be said (SEN-4).
    fn makeshift(&self) -> Option<&'static str> {
        None
    }

    /// Control by the chart system is about to be lost; `command` is the last one.
    fn losing(&mut self, _: &Outlook<'_>, _: Option<Remote>) {}

    /// Cross-track distance from what is sailed, ship right of it positive.
    fn cross_track(&self, facts: &Facts<'_>) -> Option<Distance> {
        facts.steered?.cross_track
    }

    /// Whether the ship has left the track for long enough, `off` metres from it, with a limit of `limit` metres.
    fn has_left_the_track(&mut self, _: Stamp, _off: Option<f64>, _limit: f64) -> bool {
        false
    }
}

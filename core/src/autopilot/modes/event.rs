//! What changes a mode.

use super::former::Former;
use super::track::Track;
use crate::path::Path;
use crate::time::Stamp;
use crate::units::{Course, Heading, Radius, RateOfTurn, RudderAngle, SignedAngle};
use serde::{Deserialize, Serialize};

/// Why control by the chart system ended.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub(in super::super) enum Cause {
    /// A sentence is missing, late, malformed or has a wrong checksum (TCS-8).
    Missing,
    /// HTC says manual or rudder control (TCS-9).
    ModeRefused,
    /// HTC says stand-alone (TCS-10).
    StandAlone,
    /// The position jumped (FA9).
    PositionJump,
}

/// What changes a mode.
#[derive(Clone, Debug, PartialEq)]
pub(in super::super) enum Event {
    /// The operator takes the ship.
    Standby,
    /// The operator selects heading control.
    Auto,
    /// The operator sets a heading.
    SetHeading(Heading),
    /// Both sides agree on Tn.
    EngageTn {
        /// Commanded heading.
        hts: Heading,
        /// Commanded track.
        track: Course,
        /// Commanded rate in a turn.
        rate: Option<RateOfTurn>,
    },
    /// Both sides agree on Ti.
    EngageTi {
        /// The leg.
        path: Path,
        /// AUTO's radius, reported before the first turn.
        radius: Radius,
    },
    /// The operator selects TRACK.
    EngageTrack(Track),
    /// Control by the chart system or the plotter is lost.
    TrackFail(Cause),
    /// The line of the hardware override is in use, or released.
    NfuLine(bool),
    /// Override is reported.
    Override,
    /// No heading is usable.
    HeadingLost,
    /// Nothing turns the rudder any more.
    RudderLost,
    /// The mode is over, or released, and AUTO holds this heading.
    AutoOn(Heading),
    /// The operator selects RIVER PILOT.
    RiverPilot,
    /// The operator selects FFU OVERRIDE, where the rudder stands so.
    FfuOverride(RudderAngle),
    /// A hand unit moves the tiller from STANDBY (EMC-7).
    Jog {
        /// To this rudder.
        rudder: RudderAngle,
        /// For so long.
        until: Stamp,
    },
    /// WIND VANE is selected, or DODGE goes back to it.
    WindVane {
        /// Angle to hold.
        angle: SignedAngle,
        /// To the apparent wind.
        apparent: bool,
        /// Where the wind comes from.
        direction: Heading,
    },
    /// The operator selects DODGE.
    Dodge {
        /// Off this heading.
        base: Heading,
        /// What it returns to.
        former: Former,
    },
    /// The engineer selects INSTALLATION.
    Installation,
    /// The engineer selects AUTOTUNING.
    Autotuning,
}

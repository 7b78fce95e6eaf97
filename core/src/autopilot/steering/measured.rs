//! What the laws are told of the ship in one step.

use crate::geo::Point;
use crate::units::{Course, Heading, RateOfTurn, RudderAngle, Speed};
use serde::{Deserialize, Serialize};

/// What is measured now; a value that is not known, or too old, is absent.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Measured {
    /// True heading.
    pub heading: Heading,
    /// Rate of turn.
    pub rate: RateOfTurn,
    /// Rudder angle as fed back.
    pub rudder: Option<RudderAngle>,
    /// Speed through the water, ahead.
    pub water_speed: Option<Speed>,
    /// Course and speed over ground.
    pub ground: Option<(Course, Speed)>,
    /// The last fix, in the local plane. The same value again is the same fix: it is carried on here.
    pub position: Option<Point>,
}

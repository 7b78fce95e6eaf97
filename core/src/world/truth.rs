//! The ship as she is, beside what her sensors say of her.

use crate::geo::Position;
use crate::units::{Heading, RateOfTurn, RudderAngle, SignedAngle, Speed};
use serde::{Deserialize, Serialize};

/// The truth that no sensor says, for tests and the trainer.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Truth {
    /// Where the ship is (midship).
    pub position: Position,
    /// Where the bow points.
    pub heading: Heading,
    /// How fast it turns.
    pub rate: RateOfTurn,
    /// Speed ahead through the water.
    pub water_speed: Speed,
    /// Speed over ground.
    pub ground_speed: Speed,
    /// Rudder; of a pair, the starboard one.
    pub rudder: RudderAngle,
    /// How far she heels, to starboard positive.
    pub heel: SignedAngle,
    /// The port rudder of a pair.
    pub port_rudder: Option<RudderAngle>,
}

//! Facts of more than one number: a position and a motion over ground, each with how it was found.

use crate::geo::Position;
use crate::nmea::ModeIndicator;
use crate::units::{Course, Speed};
use serde::{Deserialize, Serialize};

/// A position with its quality.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Fix {
    /// Place.
    pub position: Position,
    /// How it was found; always a valid mode.
    pub mode: ModeIndicator,
    /// Its time, seconds after midnight UTC.
    pub utc: Option<f64>,
}

impl Fix {
    /// Differential, precise or real-time kinematic (AP-7).
    #[must_use]
    pub fn corrected(&self) -> bool {
        self.mode.valid() && self.mode != ModeIndicator::Autonomous
    }
}

/// Course and speed over ground.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Ground {
    /// Course, absent where the ship lies still.
    pub course: Option<Course>,
    /// Speed.
    pub speed: Speed,
    /// How it was found; always a valid mode.
    pub mode: ModeIndicator,
}

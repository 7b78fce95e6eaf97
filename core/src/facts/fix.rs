//! Facts of more than one number: a heading, a position and a motion over ground, each with how it was found.

use crate::geo::Position;
use crate::nmea::ModeIndicator;
use crate::units::{Course, Heading, SignedAngle, Speed};
use serde::{Deserialize, Serialize};

/// What a compass says.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Bearing {
    /// A heading of true north.
    True(Heading),
    /// A reading of magnetic north (N table A.12).
    Magnetic {
        /// As it is read, not corrected.
        reading: Heading,
        /// Deviation that the compass says, degrees, east positive.
        deviation: Option<f64>,
        /// Variation that it says, degrees, east positive.
        variation: Option<f64>,
    },
}

impl Bearing {
    /// A heading of true north, degrees.
    #[must_use]
    pub fn of_true(degrees: f64) -> Self {
        Self::True(Heading::from_deg(degrees))
    }

    /// A reading of magnetic north with its deviation and variation, degrees, east positive.
    #[must_use]
    pub fn of_magnetic(degrees: f64, deviation: Option<f64>, variation: Option<f64>) -> Self {
        Self::Magnetic {
            reading: Heading::from_deg(degrees),
            deviation,
            variation,
        }
    }

    /// The true heading, by the ship's variation where the compass says none of its own; absent where none is known (AP-10).
    #[must_use]
    pub fn true_heading(&self, ships: Option<f64>) -> Option<Heading> {
        match *self {
            Self::True(heading) => Some(heading),
            Self::Magnetic { variation, .. } => {
                let by = SignedAngle::from_deg(variation.or(ships)?);
                Some(self.magnetic_heading()? + by)
            }
        }
    }

    /// The magnetic heading, corrected for the deviation; absent of a compass that knows true north only.
    #[must_use]
    pub fn magnetic_heading(&self) -> Option<Heading> {
        match *self {
            Self::True(_) => None,
            Self::Magnetic {
                reading, deviation, ..
            } => Some(reading + SignedAngle::from_deg(deviation.unwrap_or(0.0))),
        }
    }
}

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

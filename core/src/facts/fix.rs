//! Facts of more than one number: a heading, a position and a motion over ground, each with how it was found.

use crate::geo::Position;
use crate::nmea::ModeIndicator;
use crate::units::{Course, Heading, SignedAngle, Speed};
use serde::{Deserialize, Serialize};

/// What a compass says (N table A.12). One shape for all, which a page reads with little code.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Bearing {
    /// As it is read, not corrected.
    reading: Heading,
    /// It is of magnetic north.
    magnetic: bool,
    /// Deviation that a magnetic compass says, degrees, east positive.
    deviation: Option<f64>,
    /// Variation that it says, degrees, east positive.
    variation: Option<f64>,
}

impl Bearing {
    /// A heading of true north, degrees.
    #[must_use]
    pub fn of_true(degrees: f64) -> Self {
        Self {
            reading: Heading::from_deg(degrees),
            magnetic: false,
            deviation: None,
            variation: None,
        }
    }

    /// A reading of magnetic north with its deviation and variation, degrees, east positive.
    #[must_use]
    pub fn of_magnetic(degrees: f64, deviation: Option<f64>, variation: Option<f64>) -> Self {
        Self {
            reading: Heading::from_deg(degrees),
            magnetic: true,
            deviation,
            variation,
        }
    }

    /// The same of a magnetic compass that is mounted so many degrees to port of the bow (EMC-7).
    pub(crate) fn aligned(self, by: f64) -> Self {
        if !self.magnetic || by == 0.0 {
            return self;
        }
        Self {
            reading: self.reading + SignedAngle::from_deg(by),
            ..self
        }
    }

    /// As it is read, not corrected.
    #[must_use]
    pub const fn reading(&self) -> Heading {
        self.reading
    }

    /// Whether it is of magnetic north.
    #[must_use]
    pub const fn is_magnetic(&self) -> bool {
        self.magnetic
    }

    /// Deviation that the compass says, degrees, east positive.
    #[must_use]
    pub const fn deviation(&self) -> Option<f64> {
        self.deviation
    }

    /// The true heading, by the ship's variation where the compass says none of its own; absent where none is known (AP-10).
    #[must_use]
    pub fn true_heading(&self, ships: Option<f64>) -> Option<Heading> {
        if !self.magnetic {
            return Some(self.reading);
        }
        let by = SignedAngle::from_deg(self.variation.or(ships)?);
        Some(self.magnetic_heading()? + by)
    }

    /// The magnetic heading, corrected for the deviation; absent of a compass that knows true north only.
    #[must_use]
    pub fn magnetic_heading(&self) -> Option<Heading> {
        let by = SignedAngle::from_deg(self.deviation.unwrap_or(0.0));
        self.magnetic.then(|| self.reading + by)
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

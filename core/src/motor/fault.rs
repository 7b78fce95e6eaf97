//! Why a motor stands.

use serde::{Deserialize, Serialize};

/// Why a motor stands.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum MotorFault {
    /// Its controller says nothing.
    Absent,
    /// Where the rudder is, is not told.
    NoFeedback,
    /// It runs, and the rudder stands.
    Stalled,
    /// The rudder goes against it.
    Reversed,
    /// It takes too much current.
    OverCurrent,
    /// Motor or controller are too hot.
    TooHot,
    /// The supply is missing, or outside what the controller can use.
    Supply,
    /// The controller's driver.
    Driver,
}

impl MotorFault {
    /// All.
    pub const ALL: [Self; 8] = [
        Self::Absent,
        Self::NoFeedback,
        Self::Stalled,
        Self::Reversed,
        Self::OverCurrent,
        Self::TooHot,
        Self::Supply,
        Self::Driver,
    ];

    /// What happened and what to look at.
    #[must_use]
    pub const fn text(self) -> &'static str {
        match self {
            Self::Absent => "no answer from the motor: look at its supply, line and baud rate",
            Self::NoFeedback => "no rudder feedback from the motor: look at the sensor's wires",
            Self::Stalled => {
                "the motor runs and the rudder stands: look for what blocks it, and at the clutch"
            }
            Self::Reversed => {
                "the rudder goes against the motor: turn motor_reversed, or change the motor's two wires"
            }
            Self::OverCurrent => {
                "the motor takes too much current: look for what blocks the rudder"
            }
            Self::TooHot => "the motor or its controller is too hot",
            Self::Supply => "the motor's supply is missing or out of range",
            Self::Driver => "the motor's driver fails",
        }
    }

    /// Whether it ends when the motor is engaged anew; what lasts must go by itself or be repaired.
    #[must_use]
    pub const fn may_be_tried_again(self) -> bool {
        matches!(self, Self::Stalled | Self::OverCurrent | Self::TooHot)
    }
}

//! Where the ship is, how she moves, and what of her fixes is believed (FA9).

use crate::geo::Position;
use crate::nmea::{ModeIndicator, UtcTime};
use crate::picture::Fix;
use crate::time::Stamp;
use crate::units::{Course, Speed};
use serde::{Deserialize, Serialize};

/// A position for the moment of sending.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Here {
    pub(super) position: Position,
    pub(super) utc: Option<UtcTime>,
    pub(super) mode: ModeIndicator,
}

/// Course and speed over ground.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct OverGround {
    pub(super) course: Course,
    pub(super) speed: Speed,
    pub(super) mode: ModeIndicator,
}

/// Guards the position against jumps.
#[derive(Clone, Debug, Default, Serialize, Deserialize)]
pub(super) struct PositionGuard {
    /// When the last fix that was judged was heard.
    pub(super) judged: Option<Stamp>,
    /// The last fix that is believed, and when it was heard.
    pub(super) fix: Option<(Fix, Stamp)>,
    pub(super) off: u8,
    pub(super) jumped: bool,
}

impl PositionGuard {
    /// Whether the position has jumped since the last call (FA9).
    pub(super) fn take_jump(&mut self) -> bool {
        core::mem::take(&mut self.jumped)
    }

    /// The ship may be anywhere: waits for a new position.
    pub(super) fn forget(&mut self) {
        self.fix = None;
        self.off = 0;
        self.jumped = false;
    }
}

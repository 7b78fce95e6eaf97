//! What DODGE returns to when it is released (AP-21).

use crate::units::{Heading, SignedAngle};
use serde::{Deserialize, Serialize};

/// The mode before, and what was set in it.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub enum Former {
    /// AUTO on this heading.
    Auto(Heading),
    /// AutoNAV, as the chart system commands by then.
    Autonav,
    /// TRACK, on the leg that the plotter is on by then.
    Track,
    /// WIND VANE at this angle.
    WindVane {
        /// Starboard positive.
        angle: SignedAngle,
        /// To the apparent wind, else to the true one.
        apparent: bool,
    },
}

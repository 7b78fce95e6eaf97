//! What is commanded, what follows, and how far the ship is off the track.

use crate::time::Stamp;
use crate::units::{Course, Distance};
use serde::{Deserialize, Serialize};

/// What the chart system commands.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub(super) enum Commanding {
    /// Nothing: HTC mode S.
    Off,
    /// Track control, HTC mode T.
    Track {
        /// A turn was completed since control began (situation 5 instead of 2).
        turned: bool,
    },
    /// Remote heading control, HTC mode H.
    Heading {
        /// Course of the virtual leg, where no route is sailed.
        leg: Option<Course>,
    },
}

impl Commanding {
    pub(super) const fn name(self) -> &'static str {
        match self {
            Self::Off => "off",
            Self::Track { .. } => "track",
            Self::Heading { .. } => "heading",
        }
    }
}

/// What HTD said since control began. Either side may come first (AP-6), so nothing is asked of it before it followed.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub(super) struct Followed {
    /// When control began.
    pub(super) begun: Stamp,
    /// When HTD last said T or H under this control.
    pub(super) at: Option<Stamp>,
}

impl Followed {
    /// Control begins at `now`; what was heard before does not count.
    pub(super) const fn begin(now: Stamp) -> Self {
        Self {
            begun: now,
            at: None,
        }
    }

    /// FA16: the station stood still and must hear again; its own gap is not the autopilot's.
    pub(super) fn stalled(&mut self, now: Stamp) {
        self.at = self.at.map(|_| now);
    }
}

/// Cross-track distances as they are sent, right of the track positive.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub(super) struct CrossTracks {
    /// For display (XTE): to the leg, on an arc to the arc.
    pub(super) display: Option<Distance>,
    /// For control (PNEY,001): to the leg, on an arc to the next leg.
    pub(super) control: Option<Distance>,
}

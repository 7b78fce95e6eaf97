//! The hand unit of a small craft: what it asks for by `$PEMC`, what it is told, and what is calibrated by it (EMC-2, EMC-4, EMC-7).
//!
//! In: its sentences, with what is heard and set. Out: what is asked, the answers that are due, and what a calibration found. The
//! autopilot carries out what is asked, as it does an operator's orders (HTC-4).

pub(super) mod answer;
pub(super) mod asked;
pub(super) mod calibration;
pub(super) mod kept;
pub(super) mod told;

use super::sight::Sight;
use crate::post::Seen;
use crate::settings::Settings;
use crate::station::PortIndex;
use crate::units::RudderAngle;
use alloc::format;
use alloc::string::String;
use alloc::vec::Vec;
use answer::Answer;
use calibration::Calibration;
use kept::Kept;
use serde::{Deserialize, Serialize};

/// What is to be said or kept as soon as the sentence is done.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub(super) enum Due {
    /// Says that sentence on that port.
    Say(PortIndex, Answer),
    /// Settings were changed, and are not kept.
    Changed,
    /// Keeps those settings over a restart.
    Keep(Kept),
}

/// What is kept of hand units.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub(super) struct HandUnit {
    /// What is calibrated now.
    pub(super) calibration: Option<Calibration>,
    due: Vec<Due>,
    /// Sentences that were refused since the start.
    refused: u64,
}

impl HandUnit {
    /// Something is to be said or kept.
    pub(super) fn owe(&mut self, due: Due) {
        self.due.push(due);
    }

    /// What is to be said and kept.
    pub(super) fn take_due(&mut self) -> Vec<Due> {
        core::mem::take(&mut self.due)
    }

    /// Once a step: the sensors as they are heard, without what is set for them. Orders end a calibration: `free` is without.
    pub(super) fn look(&mut self, seen: Seen<'_>, sight: &Sight, settings: &Settings, free: bool) {
        if !free {
            self.calibration = None;
        }
        if let Some(calibration) = &mut self.calibration {
            let position = seen.rudders()[0].map(RudderAngle::deg);
            let (heel, rate) = sight.as_heard(seen, settings);
            calibration.look(position, heel, rate);
        }
    }

    /// A sentence is refused, and counted; what an officer is told of it.
    pub(super) fn refuse(&mut self, sentence: &str, why: &str) -> String {
        self.refused += 1;
        format!(
            "hand unit, {sentence} refused ({} so far): {why}",
            self.refused
        )
    }
}

//! Where the wind comes from, by the angle that is heard and the heading that is believed, low-passed (AP-21).
//!
//! `d' = (psi + angle - d) / tau`, all angles wrapped; `tau` is the setting `wind_time`. The direction and not the angle is
//! smoothed, so that a turn of the ship alone changes nothing. Absent as soon as the wind is lost by its age limit.

use crate::limits::Quantity;
use crate::picture::Heard;
use crate::post::Seen;
use crate::settings::Settings;
use crate::time::Stamp;
use crate::units::{Heading, SignedAngle};
use serde::{Deserialize, Serialize};

/// One wind.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
struct Felt {
    /// When it was said last.
    at: Stamp,
    /// What was said then.
    said: Heading,
    /// The same, low-passed.
    direction: Heading,
}

/// The apparent and the true wind.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub(super) struct Winds {
    apparent: Option<Felt>,
    theoretical: Option<Felt>,
}

impl Winds {
    /// Takes what is fresh, once a step; without a heading nothing moves.
    pub(super) fn look(&mut self, seen: Seen<'_>, heading: Option<Heading>, settings: &Settings) {
        let share = settings.step_ms() as f64 / 1000.0 / settings.wind_time;
        for (felt, apparent) in [(&mut self.apparent, true), (&mut self.theoretical, false)] {
            let heard = seen.picture.wind(apparent, seen.now);
            let fresh = seen.fresh(heard, Quantity::Wind);
            *felt = match (heard, fresh) {
                (Some(heard), Some(angle)) => feel(*felt, heard, angle, heading, share),
                _ => None,
            };
        }
    }

    /// Where it comes from.
    pub(super) const fn direction(&self, apparent: bool) -> Option<Heading> {
        let felt = if apparent {
            &self.apparent
        } else {
            &self.theoretical
        };
        match felt {
            Some(felt) => Some(felt.direction),
            None => None,
        }
    }
}

fn feel(
    felt: Option<Felt>,
    heard: &Heard<SignedAngle>,
    angle: SignedAngle,
    heading: Option<Heading>,
    share: f64,
) -> Option<Felt> {
    let said = match (felt, heading) {
        // Said of the heading of then.
        (Some(felt), _) if felt.at == heard.at => felt.said,
        (_, Some(heading)) => heading + angle,
        (felt, None) => return felt,
    };
    let before = felt.map_or(said, |felt| felt.direction);
    let by = (said - before).deg() * share.min(1.0);
    Some(Felt {
        at: heard.at,
        said,
        direction: before + SignedAngle::from_deg(by),
    })
}

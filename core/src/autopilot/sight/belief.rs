//! What the autopilot believes of the ship, and which sources it does not believe, for whoever shows it (DSP-5).

use super::super::{Autopilot, Timer};
use super::compass::Doubt;
use super::speed::Measure;
use crate::alerts::Alert;
use crate::facts::Quantity;
use crate::geo::Position;
use crate::picture::Source;
use crate::time::Stamp;
use crate::units::Heading;
use alloc::string::String;
use alloc::vec::Vec;

/// A source that is heard and not believed.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Refused<'a> {
    /// What it says.
    pub quantity: Quantity,
    /// Who says it.
    pub source: &'a Source,
    /// Why it is not believed, in an officer's words.
    pub why: &'static str,
}

impl Autopilot {
    /// The heading that is believed: of the compass in use, or its prediction while that stands in; absent where none is.
    #[must_use]
    pub const fn believed_heading(&self) -> Option<Heading> {
        self.heading
    }

    /// When the sources were judged last, at the control step before this: what was heard then or later waits for the next.
    #[must_use]
    pub fn judged_at(&self) -> Stamp {
        let next = self.timers.at(Timer::Step).unwrap_or(self.now);
        Stamp(next.0.saturating_sub(self.step_ms()))
    }

    /// The position that is believed: of the receiver in use, carried on; absent 5 s after its last good fix.
    #[must_use]
    pub fn believed_position(&self, now: Stamp) -> Option<Position> {
        self.position_guard.position(now)
    }

    /// The compass in use.
    #[must_use]
    pub const fn compass_in_use(&self) -> Option<&Source> {
        self.compasses.in_use()
    }

    /// The receiver in use.
    #[must_use]
    pub const fn receiver_in_use(&self) -> Option<&Source> {
        self.position_guard.in_use()
    }

    /// Every source that is heard and not believed (AP-9, FA8, FA9, TCS-8).
    #[must_use]
    pub fn refused(&self) -> Vec<Refused<'_>> {
        let compasses = self.compasses.doubted().map(|(source, doubt)| Refused {
            quantity: Quantity::Heading,
            source,
            why: match doubt {
                Doubt::Jumped => "jumped",
                Doubt::Stuck => "stuck",
                Doubt::Drifts => "drifts",
            },
        });
        let receivers = self.position_guard.doubted().map(|source| Refused {
            quantity: Quantity::Position,
            source,
            why: "jumped",
        });
        let commands = (self.post.picture.pney1.as_ref())
            .filter(|_| self.alerts.raised(Alert::TrackDataRefused))
            .map(|heard| Refused {
                quantity: Quantity::Control,
                source: &heard.source,
                why: "does not fit",
            });
        let others = self.refused_rate().into_iter().chain(self.refused_speed());
        compasses
            .chain(receivers)
            .chain(commands)
            .chain(others)
            .collect()
    }

    fn refused_rate(&self) -> Option<Refused<'_>> {
        let heard = self.post.picture.rate(self.now)?;
        self.rate_guard.doubted().then_some(Refused {
            quantity: Quantity::RateOfTurn,
            source: &heard.source,
            why: "disagrees",
        })
    }

    fn refused_speed(&self) -> Option<Refused<'_>> {
        let picture = &self.post.picture;
        let (quantity, source) = match self.speed_guard.doubted()? {
            Measure::Water => (Quantity::WaterSpeed, &picture.water_speed(self.now)?.source),
            Measure::Ground => (Quantity::Ground, &picture.ground(self.now)?.source),
        };
        Some(Refused {
            quantity,
            source,
            why: "disagrees",
        })
    }

    /// Name of a source as `port/talker/formatter`.
    #[must_use]
    pub fn source_name(&self, source: &Source) -> String {
        self.post.picture.source_name(source)
    }
}

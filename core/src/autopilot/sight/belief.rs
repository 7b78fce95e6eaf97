//! What is believed of the ship, and which sources are not, for whoever shows it (DSP-5).

use super::Sight;
use super::compass::Doubt;
use super::monitor::HeadingMonitor;
use super::mounted;
use super::source::Refused;
use super::speed::Measure;
use crate::facts::Quantity;
use crate::geo::Position;
use crate::nmea::Sentence;
use crate::picture::{Bearing, Source};
use crate::post::Seen;
use crate::settings::Settings;
use crate::station::PortIndex;
use crate::time::Stamp;
use alloc::vec::Vec;

impl Sight {
    /// The position that is believed: of the receiver in use, carried on; absent 5 s after its last good fix.
    pub(in super::super) fn believed_position(&self, now: Stamp) -> Option<Position> {
        self.positions.position(now)
    }

    /// The compass in use.
    pub(in super::super) const fn compass(&self) -> Option<&Source> {
        self.headings.compasses.in_use()
    }

    /// What the compass in use says, where it is a magnetic one and still believed.
    pub(in super::super) fn magnetic_compass<'a>(
        &'a self,
        seen: Seen<'_>,
        settings: &Settings,
    ) -> Option<(&'a Source, Bearing)> {
        let source = self.compass().filter(|_| self.heading().is_some())?;
        let heard = (seen.picture.headings.iter()).find(|heard| heard.source == *source);
        let said = seen.fresh(heard, Quantity::Heading)?;
        let said = mounted::bearing(seen.picture, settings, source, said)?;
        said.is_magnetic().then_some((source, said))
    }

    /// The heel, degrees, starboard positive; absent where none is heard that is used.
    pub(in super::super) fn heel(&self, seen: Seen<'_>, settings: &Settings) -> Option<f64> {
        Some(self.heels.as_heard(seen, settings)? + settings.heel_offset)
    }

    /// Hears a sentence that may say a heel.
    pub(in super::super) fn hear_heel(
        &mut self,
        now: Stamp,
        port: PortIndex,
        sentence: &Sentence<'_>,
    ) {
        self.heels.hear(now, port, sentence);
    }

    /// Heel, degrees, and rate of turn of an IMU, degrees a minute, as they are heard: without what is set for them.
    pub(in super::super) fn as_heard(
        &self,
        seen: Seen<'_>,
        settings: &Settings,
    ) -> (Option<f64>, Option<f64>) {
        let heel = self.heels.as_heard(seen, settings);
        (heel, mounted::rate_as_heard(seen))
    }

    /// What the heading monitor has to say (AP-10).
    pub(in super::super) const fn monitor(&self) -> &HeadingMonitor {
        &self.headings.monitor
    }

    /// Whether HMS is to be said (AP-10).
    pub(in super::super) fn hms_is_due(&mut self, now: Stamp, period: u64) -> bool {
        self.headings.monitor.hms_is_due(now, period)
    }

    /// The receiver in use.
    pub(in super::super) const fn receiver(&self) -> Option<&Source> {
        self.positions.in_use()
    }

    /// Whether the position in use is corrected; as long as there is none, nothing says that it is not (AP-7).
    pub(in super::super) const fn is_corrected(&self) -> bool {
        self.correction.is_there()
    }

    /// When the position in use was corrected last; absent where it never was.
    pub(in super::super) const fn last_corrected(&self) -> Option<Stamp> {
        self.correction.last()
    }

    /// Compasses and receivers that are heard and not believed (AP-9, FA8, FA9).
    pub(in super::super) fn refused_places(&self) -> Vec<Refused<'_>> {
        let compasses = self
            .headings
            .compasses
            .doubted()
            .map(|(source, doubt)| Refused {
                quantity: Quantity::Heading,
                source,
                why: match doubt {
                    Doubt::Jumped => "jumped",
                    Doubt::Stuck => "stuck",
                    Doubt::Drifts => "drifts",
                },
            });
        let receivers = self.positions.doubted().map(|source| Refused {
            quantity: Quantity::Position,
            source,
            why: "jumped",
        });
        compasses.chain(receivers).collect()
    }

    /// Rate of turn and speeds that are heard and not believed (AP-9).
    pub(in super::super) fn refused_motions<'a>(
        &self,
        seen: Seen<'a>,
    ) -> impl Iterator<Item = Refused<'a>> {
        let (now, picture) = (seen.now, seen.picture);
        let rate = picture.rate(now).filter(|_| self.headings.rates.doubted());
        let rate = rate.map(|heard| (Quantity::RateOfTurn, &heard.source));
        let speed = match self.speeds.doubted() {
            Some(Measure::Water) => {
                let heard = picture.water_speed(now);
                heard.map(|heard| (Quantity::WaterSpeed, &heard.source))
            }
            Some(Measure::Ground) => {
                let heard = picture.ground(now);
                let heard = heard.filter(|heard| heard.usable(Quantity::Ground, now).is_some());
                heard.map(|heard| (Quantity::Ground, &heard.source))
            }
            None => None,
        };
        let both = rate.into_iter().chain(speed);
        both.map(|(quantity, source)| Refused {
            quantity,
            source,
            why: "disagrees",
        })
    }
}

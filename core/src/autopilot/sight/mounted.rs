//! Small craft's sensors as they are mounted: alignment, offsets, and whether the plotter's compass is used (EMC-2, EMC-5, EMC-7).

use crate::limits::Quantity;
use crate::nmea::{DataStatus, Hrm, Sentence, TransducerType, Xdr, XdrReading};
use crate::picture::{Bearing, Heard, Picture, Source};
use crate::post::Seen;
use crate::settings::Settings;
use crate::station::{PortIndex, Profile};
use crate::time::Stamp;
use crate::units::RateOfTurn;
use alloc::vec::Vec;
use serde::{Deserialize, Serialize};

/// At most so many sources of heel; a further one is not taken.
const MAX_SOURCES: usize = 16;

fn profile(picture: &Picture, source: &Source) -> Option<Profile> {
    picture.ports.get(source.port).map(|port| port.profile)
}

/// Whether a compass or an inclinometer may be used: a plotter's only where it is set to be (EMC-5).
fn is_used(picture: &Picture, source: &Source, settings: &Settings) -> bool {
    settings.external_compass || profile(picture, source) != Some(Profile::Plotter)
}

/// What a compass says, of a magnetic one on a small craft with the alignment that is set; absent where it is not used.
pub(super) fn bearing(
    picture: &Picture,
    settings: &Settings,
    source: &Source,
    said: Bearing,
) -> Option<Bearing> {
    if !is_used(picture, source, settings) {
        return None;
    }
    let aligned = [Profile::Imu, Profile::Magn, Profile::Plotter];
    let ours = profile(picture, source).is_some_and(|profile| aligned.contains(&profile));
    Some(if ours {
        said.aligned(settings.heading_alignment)
    } else {
        said
    })
}

/// The rate of turn in use, of an IMU with its offset.
pub(super) fn rate(seen: Seen<'_>, settings: &Settings) -> Option<RateOfTurn> {
    let heard = seen.picture.rate(seen.now)?;
    let rate = seen.fresh(Some(heard), Quantity::RateOfTurn)?;
    let of_imu = profile(seen.picture, &heard.source) == Some(Profile::Imu);
    if of_imu && settings.rate_offset != 0.0 {
        return Some(RateOfTurn::from_deg_per_min(
            rate.deg_per_min() + settings.rate_offset,
        ));
    }
    Some(rate)
}

/// The rate of turn of an IMU as it says it, degrees a minute; absent where another sensor is in use.
pub(super) fn rate_as_heard(seen: Seen<'_>) -> Option<f64> {
    let heard = seen.picture.rate(seen.now)?;
    let of_imu = profile(seen.picture, &heard.source) == Some(Profile::Imu);
    let rate = seen.fresh(Some(heard).filter(|_| of_imu), Quantity::RateOfTurn)?;
    Some(rate.deg_per_min())
}

/// Heels that are heard, one a source. They are no part of the picture: a page that folded them would carry their tables.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub(super) struct Heels(Vec<Heard<f64>>);

impl Heels {
    /// Hears a sentence that may say a heel: an XDR's angle named HEEL or ROLL, or an HRM that is valid (EMC-5).
    pub(super) fn hear(&mut self, now: Stamp, port: PortIndex, sentence: &Sentence<'_>) {
        let Some(heel) = said(sentence) else {
            return;
        };
        let source = Source {
            port,
            talker: sentence.talker().into(),
            formatter: sentence.formatter.into(),
        };
        let heard = Heard::new(heel, now, source);
        let known = self.0.iter().position(|one| one.source == heard.source);
        match known {
            Some(known) => self.0[known] = heard,
            None if self.0.len() < MAX_SOURCES => self.0.push(heard),
            None => {}
        }
    }

    /// As its best sensor says it, degrees, starboard positive; absent where none is heard that is used.
    pub(super) fn as_heard(&self, seen: Seen<'_>, settings: &Settings) -> Option<f64> {
        let picture = seen.picture;
        let used = |heard: &&Heard<f64>| {
            let fresh = seen.fresh(Some(*heard), Quantity::Heel).is_some();
            fresh && is_used(picture, &heard.source, settings)
        };
        let used = self.0.iter().filter(used);
        let best = used.min_by_key(|heard| picture.rank(&heard.source))?;
        Some(best.value)
    }
}

/// The heel that a sentence says, degrees, starboard positive.
fn said(sentence: &Sentence<'_>) -> Option<f64> {
    if !sentence.faults().is_empty() {
        return None;
    }
    if let Some(hrm) = Hrm::from_sentence(sentence) {
        return hrm.heel.filter(|_| hrm.status == Some(DataStatus::Valid));
    }
    let named = |name: &str| {
        ["HEEL", "ROLL"]
            .iter()
            .any(|one| name.eq_ignore_ascii_case(one))
    };
    let heels = |of: &&XdrReading| {
        of.kind == Some(TransducerType::Angle) && of.name.as_deref().is_some_and(named)
    };
    Xdr::from_sentence(sentence)?
        .readings
        .iter()
        .find(heels)?
        .reading
}

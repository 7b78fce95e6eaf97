//! HTC with commas missing before the track: both readings (SEN-5).

use crate::nmea::codes::{SteeringMode, TurnMode};
use crate::nmea::tables::Htc;
use crate::nmea::value::latin1;
use crate::nmea::{Decimal, Sentence, decode, with_checksum};
use alloc::format;
use alloc::string::String;
use alloc::vec::Vec;

/// Says what a short HTC means by position, and what with the fields that are missing.
pub(super) fn short_htc(sentence: &Sentence<'_>, out: &mut Vec<String>) {
    let count = sentence.fields.len();
    if sentence.formatter != "HTC" || !(11..=13).contains(&count) {
        return;
    }
    let plain_thirteen = count == 13
        && (sentence.fields.get(12).is_empty()
            || Decimal::parse(sentence.fields.get(12)).is_some());
    if plain_thirteen {
        out.push("13 fields: the status is missing; it counts as null".into());
        return;
    }
    let missing = 14 - count;
    let mut best: Option<(u32, usize, Htc)> = None;
    for before in (6..=count.saturating_sub(1)).rev() {
        let mut fields: Vec<&[u8]> = sentence.fields.iter().collect();
        for _ in 0..missing {
            fields.insert(before - 1, b"");
        }
        let text: Vec<String> = fields.iter().map(|f| latin1(f)).collect();
        let line = with_checksum(&format!("{},{}", sentence.address(), text.join(",")));
        let other = decode(line.as_bytes());
        let Some(htc) = Htc::from_sentence(&other) else {
            continue;
        };
        if other.faults().is_empty() {
            let score = plausibility(&htc);
            if best.as_ref().is_none_or(|(most, ..)| score > *most) {
                best = Some((score, before, htc));
            }
        }
    }
    let Some((_, before, htc)) = best else { return };
    let position: Vec<String> = (8..=12)
        .filter(|&n| !sentence.fields.get(n).is_empty())
        .map(|n| format!("{} {}", NAMES[n - 8], latin1(sentence.fields.get(n))))
        .collect();
    let position = if position.is_empty() {
        "nothing".into()
    } else {
        position.join(", ")
    };
    let values = [
        htc.radius,
        htc.rate_of_turn,
        htc.heading_to_steer,
        htc.off_track_limit,
        htc.track,
    ];
    let meant: Vec<String> = values
        .iter()
        .zip(NAMES)
        .filter_map(|(v, name)| v.map(|v| format!("{name} {v}")))
        .collect();
    let meant = if meant.is_empty() {
        "no values".into()
    } else {
        meant.join(", ")
    };
    let last = before + missing - 1;
    let null = if missing == 1 {
        format!("null field {before}")
    } else {
        format!("null fields {before} to {last}")
    };
    out.push(format!(
        "{count} of 14 fields: by position it says {position}; with the missing {null} it says {meant}; never used for steering"
    ));
}

const NAMES: [&str; 5] = [
    "radius",
    "rate of turn",
    "heading to steer",
    "off-track limit",
    "track",
];

/// How well an HTC fits the dialogue (interface, sections 2 and 4).
fn plausibility(htc: &Htc) -> u32 {
    let tn = htc.steering_mode == Some(SteeringMode::HeadingControl);
    let ti = htc.steering_mode == Some(SteeringMode::TrackControl);
    u32::from(htc.reference.is_some()) * 4
        + u32::from(htc.status.is_some()) * 4
        + u32::from(htc.off_track_limit.is_none()) * 2
        + u32::from(htc.rudder_limit.is_none() && htc.off_heading_limit.is_none()) * 2
        + u32::from(htc.track.is_some() == (tn || ti)) * 4
        + u32::from(htc.heading_to_steer.is_some() == tn) * 2
        + u32::from(ti || htc.radius.is_none()) * 2
        + u32::from(htc.rate_of_turn.is_none() || (tn && htc.turn_mode != Some(TurnMode::Radius)))
            * 2
}

//! Hints: what is not wrong by the standard, or why something is wrong, in words for people.

use super::fault::FaultKind;
use super::tables::{Gll, Htc, Pney1, Xte};
use super::{Checksum, DataStatus, Decimal, ModeIndicator, Sentence, with_checksum};
use alloc::format;
use alloc::string::String;
use alloc::vec::Vec;

/// Hints about a sentence.
#[must_use]
pub fn hints(sentence: &Sentence<'_>) -> Vec<String> {
    let mut out = Vec::new();
    checksum(sentence, &mut out);
    if let Some(tag) = &sentence.tag
        && !tag.right
    {
        out.push(
            "the checksum of the TAG block is wrong or missing; the sentence stands for itself"
                .into(),
        );
    }
    if sentence.known.is_none() && !sentence.address.is_empty() {
        out.push(format!(
            "{} is not in the dictionary; it is kept as it is",
            sentence.formatter
        ));
    }
    short_htc(sentence, &mut out);
    frame(sentence, &mut out);
    speeds(sentence, &mut out);
    status_and_mode(sentence, &mut out);
    talker(sentence, &mut out);
    device_ranges(sentence, &mut out);
    out
}

/// What the checksum should be is a fault; here is what may have happened to the line.
fn checksum(sentence: &Sentence<'_>, out: &mut Vec<String>) {
    let Checksum::Wrong {
        given: Some(given),
        computed,
    } = sentence.checksum
    else {
        return;
    };
    let difference = given ^ computed;
    let short = sentence
        .faults()
        .iter()
        .any(|f| matches!(f.kind, FaultKind::FieldCount { .. }));
    if difference == b',' && short {
        out.push("one lost comma explains the checksum and the number of fields".into());
        return;
    }
    if !sentence.fields.is_empty()
        && (difference == b'.' || difference == b'-' || difference.is_ascii_digit())
    {
        out.push(format!(
            "one lost '{}' would explain the checksum",
            char::from(difference)
        ));
    }
    let Some(body) = sentence
        .text
        .get(1..)
        .and_then(|t| t.split(|&b| b == b'*').next())
    else {
        return;
    };
    let mut field = 0;
    let mut places: Vec<String> = Vec::new();
    for &byte in body {
        if byte == b',' {
            field += 1;
            continue;
        }
        let before = byte ^ difference;
        let alike = (byte.is_ascii_digit() && before.is_ascii_digit())
            || (byte.is_ascii_uppercase() && before.is_ascii_uppercase())
            || (!byte.is_ascii() && before.is_ascii_graphic());
        if alike {
            places.push(format!(
                "'{}' for '{}' in field {field}",
                char::from(before),
                char::from(byte)
            ));
        }
    }
    match places.len() {
        0 => {}
        1..=3 => out.push(format!(
            "one changed character would explain the checksum: {}",
            places.join(", or ")
        )),
        n => out.push(format!(
            "one changed character would explain the checksum, at {n} places"
        )),
    }
}

/// SEN-5: HTC with missing commas before the track; both readings.
fn short_htc(sentence: &Sentence<'_>, out: &mut Vec<String>) {
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
        let text: Vec<String> = fields.iter().map(|f| super::explain::latin1(f)).collect();
        let line = with_checksum(&format!("{},{}", sentence.address, text.join(",")));
        let other = super::decode(line.as_bytes());
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
        .map(|n| {
            format!(
                "{} {}",
                NAMES[n - 8],
                super::explain::latin1(sentence.fields.get(n))
            )
        })
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
    use super::{SteeringMode, TurnMode};
    let tn = htc.steering_mode == Some(SteeringMode::HeadingControl);
    let ti = htc.steering_mode == Some(SteeringMode::TrackControl);
    u32::from(htc.reference.is_some()) * 4
        + u32::from(htc.status.is_some()) * 4
        + u32::from(htc.off_track_limit.is_none()) * 2
        + u32::from(htc.track.is_some() == (tn || ti)) * 4
        + u32::from(htc.heading_to_steer.is_some() == tn) * 2
        + u32::from(ti || htc.radius.is_none()) * 2
        + u32::from(htc.rate_of_turn.is_none() || (tn && htc.turn_mode != Some(TurnMode::Radius)))
            * 2
}

fn frame(sentence: &Sentence<'_>, out: &mut Vec<String>) {
    let count = sentence.fields.len();
    if let Some(definition) = sentence.known
        && definition.group.is_none()
        && definition
            .lengths
            .iter()
            .all(|&length| usize::from(length) < count)
        && sentence.fields.get(count).is_empty()
    {
        out.push("an empty field stands at the end; some makers print one".into());
    }
    if let [.., b'*', high, low] = sentence.text
        && (high.is_ascii_lowercase() || low.is_ascii_lowercase())
    {
        out.push("the checksum is written in lower case".into());
    }
    if let Some(definition) = sentence.known
        && sentence
            .text
            .first()
            .is_some_and(|&b| b != definition.delimiter)
    {
        out.push(format!(
            "should begin with {}",
            char::from(definition.delimiter)
        ));
    }
}

/// A speed in knots beside the same in kilometres an hour.
fn speeds(sentence: &Sentence<'_>, out: &mut Vec<String>) {
    let first = match sentence.formatter {
        "VTG" | "VHW" => 5,
        _ => return,
    };
    let parse = |n: usize| Decimal::parse(sentence.fields.get(n));
    let (Some(knots), Some(kmh)) = (parse(first), parse(first + 2)) else {
        return;
    };
    let half = |d: Decimal| 0.55 / libm::pow(10.0, f64::from(d.scale()));
    let expected = knots.value() * 1.852;
    if libm::fabs(expected - kmh.value()) > half(knots) * 1.852 + half(kmh) {
        out.push(format!(
            "{knots} kn are {expected:.1} km/h, field {} says {kmh}",
            first + 2
        ));
    }
}

fn status_and_mode(sentence: &Sentence<'_>, out: &mut Vec<String>) {
    let (status, mode) = match sentence.formatter {
        "XTE" => Xte::from_sentence(sentence).map_or((None, None), |v| (v.status, v.mode)),
        "PNEY,001" => Pney1::from_sentence(sentence).map_or((None, None), |v| (v.status, v.mode)),
        "GLL" => Gll::from_sentence(sentence).map_or((None, None), |v| (v.status, v.mode)),
        _ => return,
    };
    contradiction(status, mode, out);
}

fn contradiction(status: Option<DataStatus>, mode: Option<ModeIndicator>, out: &mut Vec<String>) {
    match (status, mode) {
        (Some(DataStatus::Valid), Some(mode)) if !mode.valid() => out.push(format!(
            "status A contradicts mode {} ({}); it should be V",
            mode.letter(),
            mode.meaning()
        )),
        (Some(DataStatus::Invalid), Some(mode)) if mode.valid() => out.push(format!(
            "status V contradicts mode {} ({})",
            mode.letter(),
            mode.meaning()
        )),
        _ => {}
    }
}

/// Talkers that the tables name (SEN-3); any talker is accepted all the same.
fn talker(sentence: &Sentence<'_>, out: &mut Vec<String>) {
    let expected: &[&str] = match sentence.formatter {
        "HTC" => &["EI", "EC", "II", "IN"],
        "HTD" | "ROR" => &["AG", "AP", "II", "IN"],
        "HDT" | "THS" => &["HE", "HN", "HF", "HC", "TI", "II", "IN", "AG", "GP", "GN"],
        "HDM" | "HDG" => &["HC", "HF", "HE", "II", "IN", "TI"],
        _ => return,
    };
    if !sentence.talker.is_empty() && !expected.contains(&sentence.talker) {
        out.push(format!(
            "{} from talker {} is unusual",
            sentence.formatter, sentence.talker
        ));
    }
    if sentence.formatter == "HDT" && sentence.talker == "HC" {
        out.push("a true heading from a magnetic compass needs its variation".into());
    }
}

/// Ranges of the Furuno document that are narrower than the standard's (SEN-6).
fn device_ranges(sentence: &Sentence<'_>, out: &mut Vec<String>) {
    let number = |n: usize| Decimal::parse(sentence.fields.get(n)).map(Decimal::value);
    let mut faster = |n: usize, unit: &str| {
        if number(n).is_some_and(|speed| libm::fabs(speed) > 99.949) {
            out.push(format!("field {n}: Furuno devices go to 99.94 {unit}"));
        }
    };
    match sentence.formatter {
        "RMC" => faster(7, "kn"),
        "VTG" | "VHW" => {
            faster(5, "kn");
            faster(7, "km/h");
        }
        "VBW" => [1, 2, 4, 5].into_iter().for_each(|n| faster(n, "kn")),
        "ZDA" if number(4).is_some_and(|year| !(1970.0..=2037.0).contains(&year)) => {
            out.push("field 4: Furuno devices take years from 1970 to 2037".into());
        }
        _ => {}
    }
    let alert = match sentence.formatter {
        "ALF" => 9,
        "ARC" | "ACN" => 3,
        _ => return,
    };
    if number(alert).is_some_and(|id| id > 999.0 && !(10_001.0..=10_999.0).contains(&id)) {
        out.push(format!(
            "field {alert}: Furuno devices use 999 and 10001 to 10999"
        ));
    }
}

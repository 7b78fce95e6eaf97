//! Fields that contradict each other, and talkers that the tables do not name.

use crate::nmea::codes::{DataStatus, ModeIndicator};
use crate::nmea::{Decimal, Sentence};
use alloc::format;
use alloc::string::String;
use alloc::vec::Vec;

/// A speed in knots beside the same in kilometres an hour.
pub(super) fn speeds(sentence: &Sentence<'_>, out: &mut Vec<String>) {
    let first = match sentence.formatter {
        "VTG" | "VHW" => 5,
        _ => return,
    };
    let parse = |n: usize| match sentence.fields.get(n + 1) {
        b"N" | b"K" | b"" => Decimal::parse(sentence.fields.get(n)),
        _ => None,
    };
    if sentence.fields.get(first + 1) == b"K" || sentence.fields.get(first + 3) == b"N" {
        return;
    }
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

/// Formatter, field of the status, field of the mode indicator.
const STATUS_AND_MODE: &[(&str, usize, usize)] = &[
    ("APB", 1, 15),
    ("GLL", 6, 7),
    ("PNEY,001", 2, 7),
    ("RMB", 1, 14),
    ("RMC", 2, 12),
    ("XTE", 1, 6),
];

/// A status that the mode indicator contradicts: V belongs to E, M, S and N (Navis A.21, A.22).
pub(super) fn status_and_mode(sentence: &Sentence<'_>, out: &mut Vec<String>) {
    let place = STATUS_AND_MODE.iter().find(|place| sentence.is(place.0));
    let Some((_, status, mode)) = place else {
        return;
    };
    let letter = |n: usize| match sentence.fields.get(n) {
        [letter] => Some(*letter),
        _ => None,
    };
    let status = letter(*status).and_then(DataStatus::from_letter);
    let mode = letter(*mode).and_then(ModeIndicator::from_letter);
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
const TALKERS: &[(&[&str], &[&str])] = &[
    (&["HTC"], &["EI", "EC", "II", "IN"]),
    (
        &["HTD", "ROR", "HMS", "HMR", "ALA"],
        &["AG", "AP", "II", "IN"],
    ),
    (
        &["HDT", "THS"],
        &["HE", "HN", "HF", "HC", "TI", "II", "IN", "AG", "GP", "GN"],
    ),
    (&["HDM", "HDG"], &["HC", "HF", "HE", "II", "IN", "TI"]),
    (&["RSD", "TTD", "TTM"], &["RA", "II", "IN"]),
    (&["VDM", "VDO"], &["AI", "AB", "BS"]),
];

/// A talker that is not one of its table's.
pub(super) fn talker(sentence: &Sentence<'_>, out: &mut Vec<String>) {
    let row = TALKERS
        .iter()
        .find(|(formatters, _)| formatters.contains(&sentence.formatter));
    let Some((_, expected)) = row else {
        return;
    };
    if !sentence.talker().is_empty() && !expected.contains(&sentence.talker()) {
        out.push(format!(
            "{} from talker {} is unusual",
            sentence.formatter,
            sentence.talker()
        ));
    }
    if sentence.is("HDT") && sentence.talker() == "HC" {
        out.push("a true heading from a magnetic compass needs its variation".into());
    }
}

//! Ranges of a device that are narrower than the standard's, as its document prints them (SEN-6): a hint, no fault.

use crate::nmea::{Decimal, Sentence};
use alloc::format;
use alloc::string::String;
use alloc::vec::Vec;

/// Fields of a sentence, the least and the greatest value of the device, in thousandths.
type Range = (&'static str, &'static [u8], i64, i64);

/// Furuno's digital interface list, appendix, pages 10 to 15. Speeds are shown with two decimals, so 99.94 is the last below 99.949.
const FURUNO: &[Range] = &[
    ("ALF", &[11], 1_000, 99_000),
    ("ALF", &[12], 0, 2_000),
    ("ALC", &[4], 0, 3_000),
    ("HBT", &[1], 0, 99_900),
    ("MTW", &[1], -100_000, 100_000),
    ("MWV", &[3], 0, 9_999_990),
    ("OSD", &[1, 3, 7], 0, 359_990),
    ("OSD", &[5], 0, 999_990),
    ("OSD", &[8], 0, 99_990),
    ("RMC", &[7], 0, 99_949),
    ("RSD", &[1, 3, 7, 9], 0, 999_000),
    ("RSD", &[2, 4, 6, 10], 0, 359_900),
    ("RSD", &[5], 0, 999_900),
    ("RSD", &[11], 62, 120_000),
    ("TLB", &[1, 3, 5, 7], 1_000, 1_023_000),
    ("TTM", &[1], 0, 999_000),
    ("TTM", &[2], 0, 99_999),
    ("TTM", &[3, 6], 0, 359_900),
    ("TTM", &[5], 0, 999_990),
    ("TTM", &[8], 0, 99_990),
    ("TTM", &[9], -99_990, 99_990),
    ("VBW", &[1, 2, 4, 5, 7, 9], -99_949, 99_949),
    ("VDR", &[5], 0, 99_990),
    ("VHW", &[5, 7], 0, 99_949),
    ("VTG", &[5, 7], 0, 99_949),
    ("ZDA", &[4], 1_970_000, 2_037_000),
];

/// Alert identifiers of Furuno: 999 or 10001 to 10999; a refusal also names 1 to 999.
const ALERTS: &[(&str, usize, f64)] = &[("ALF", 9, 999.0), ("ARC", 3, 1.0), ("ACN", 3, 1.0)];

/// Says which values the device could not take or give.
pub(super) fn device_ranges(sentence: &Sentence<'_>, out: &mut Vec<String>) {
    let number = |n: usize| Decimal::parse(sentence.fields.get(n)).map(Decimal::value);
    for (_, fields, low, high) in FURUNO.iter().filter(|range| sentence.is(range.0)) {
        let (low, high) = (*low as f64 / 1000.0, *high as f64 / 1000.0);
        for n in fields.iter() {
            if number(usize::from(*n)).is_some_and(|value| !(low..=high).contains(&value)) {
                out.push(format!("field {n}: Furuno devices use {low} to {high}"));
            }
        }
    }
    if let Some((_, n, least)) = ALERTS.iter().find(|alert| sentence.is(alert.0))
        && number(*n).is_some_and(|id| {
            !(*least..=999.0).contains(&id) && !(10_001.0..=10_999.0).contains(&id)
        })
    {
        let first = if *least > 1.0 { "999" } else { "1 to 999" };
        out.push(format!(
            "field {n}: Furuno devices use {first} and 10001 to 10999"
        ));
    }
    if sentence.is("ALF") && sentence.fields.get(13).len() > 18 {
        out.push("field 13: Furuno devices show 18 characters".into());
    }
}

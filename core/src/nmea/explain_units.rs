//! Units that stand in another field of their sentence: what the letter there says of a number (EMC-3: APB in kilometres).

use super::Sentence;
use super::explained::Field;

/// Formatter, field of the unit, fields of distances, fields of speeds.
type Place = (&'static str, usize, &'static [usize], &'static [usize]);

const PLACES: &[Place] = &[
    ("APA", 5, &[3], &[]),
    ("APB", 5, &[3], &[]),
    ("MWV", 4, &[], &[3]),
    ("OSD", 9, &[], &[5, 8]),
    ("RSD", 12, &[1, 3, 5, 7, 9, 11], &[]),
    ("TTM", 10, &[2, 8], &[5]),
];

/// Gives each number of `fields` the unit that its sentence names elsewhere.
pub(super) fn name_units(sentence: &Sentence<'_>, fields: &mut [Field<'_>]) {
    if sentence.formatter == "XDR" {
        for reading in fields.chunks_mut(4) {
            if let [kind, number, unit, ..] = reading {
                number.unit = transducer(kind.raw, unit.raw);
            }
        }
        return;
    }
    let place = PLACES.iter().find(|place| place.0 == sentence.formatter);
    let Some((_, at, distances, speeds)) = place else {
        return;
    };
    let [letter] = sentence.fields.get(*at) else {
        return;
    };
    let mut name = |list: &[usize], unit: Option<&'static str>| {
        for n in list {
            if let (Some(field), Some(unit)) = (fields.get_mut(n - 1), unit) {
                field.unit = Some(unit);
            }
        }
    };
    name(distances, distance(*letter));
    name(speeds, speed(*letter));
}

const fn distance(letter: u8) -> Option<&'static str> {
    match letter {
        b'K' => Some("km"),
        b'N' => Some("nm"),
        b'S' => Some("mi"),
        _ => None,
    }
}

const fn speed(letter: u8) -> Option<&'static str> {
    match letter {
        b'K' => Some("km/h"),
        b'M' => Some("m/s"),
        b'N' => Some("kn"),
        b'S' => Some("mph"),
        _ => None,
    }
}

/// The unit of a transducer's reading, by its type and its letter (IEC 61162-1 XDR).
fn transducer(kind: &[u8], letter: &[u8]) -> Option<&'static str> {
    Some(match (kind, letter) {
        (b"A", b"D") => "deg",
        (b"C", b"C") => "°C",
        (b"D", b"M") => "m",
        (b"F", b"H") => "Hz",
        (b"H", b"P") => "%",
        (b"I", b"A") => "A",
        (b"N", b"N") => "N",
        (b"P", b"B") => "bar",
        (b"P", b"P") => "Pa",
        (b"B", b"K") => "kg/m³",
        (b"A" | b"D" | b"E", b"P") => "%",
        (b"L", b"S") => "‰",
        (b"R", b"L" | b"l") => "l/s",
        (b"T", b"R") => "rev/min",
        (b"U", b"V") => "V",
        (b"V", b"M") => "m³",
        _ => return None,
    })
}

//! What may have happened to a line with a wrong checksum: one character lost or changed (SEN-2).

use crate::nmea::{Checksum, Sentence};
use alloc::format;
use alloc::string::String;
use alloc::vec::Vec;

/// What the checksum should be is a fault; here is what may have happened to the line.
pub(super) fn checksum(sentence: &Sentence<'_>, out: &mut Vec<String>) {
    let Checksum::Wrong {
        given: Some(given),
        computed,
    } = sentence.checksum
    else {
        return;
    };
    // What one character more, or another one, adds to the exclusive-or of all.
    let difference = given ^ computed;
    let short = sentence
        .known
        .is_some_and(|known| known.group.is_none() && sentence.fields.len() < known.sent());
    if difference == b',' && short {
        out.push("one lost comma explains the checksum and the number of fields".into());
        return;
    }
    let written = matches!(difference, b'.' | b'-')
        || difference.is_ascii_digit()
        || difference.is_ascii_uppercase();
    if !sentence.fields.is_empty() && written {
        out.push(format!(
            "one lost '{}' would explain the checksum",
            char::from(difference)
        ));
    }
    if difference & 0xf0 == 0 || difference & 0x0f == 0 {
        out.push("one changed digit of the checksum itself would explain it".into());
    }
    changed(sentence, difference, out);
}

/// Places where another character of the same sort would make the checksum right.
fn changed(sentence: &Sentence<'_>, difference: u8, out: &mut Vec<String>) {
    let body = sentence.text.get(1..).unwrap_or_default();
    let body = body.split(|&b| b == b'*').next().unwrap_or_default();
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
                "'{}' for '{}' in {}",
                char::from(before),
                char::from(byte),
                match field {
                    0 => String::from("the address"),
                    field => format!("field {field}"),
                }
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

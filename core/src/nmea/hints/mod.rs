//! Hints: what is not wrong by the standard, or why something is wrong, in words for people.

mod checksum;
mod contradictions;
mod device;
mod short_htc;

use super::Sentence;
use super::value::hex_byte;
use alloc::format;
use alloc::string::String;
use alloc::vec::Vec;
use checksum::checksum;
use contradictions::{speeds, status_and_mode, talker};
use device::device_ranges;
use short_htc::short_htc;

/// Hints about a sentence.
///
/// ```
/// use wheelover_core::nmea::{decode, hints};
/// let sentence = decode(b"$EIVTG,234.5,T,,M,10.0,N,18.2,K,A*1C");
/// assert!(sentence.is_clean());
/// assert_eq!(hints(&sentence), ["10.0 kn are 18.5 km/h, field 7 says 18.2"]);
/// ```
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
    if sentence.known.is_none() && !sentence.address().is_empty() {
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

fn frame(sentence: &Sentence<'_>, out: &mut Vec<String>) {
    let count = sentence.fields.len();
    let has = |definition: &super::Definition, length: usize| {
        definition.lengths.iter().any(|&l| usize::from(l) == length)
    };
    if let Some(definition) = sentence.known
        && !has(definition, count)
        && has(definition, count.wrapping_sub(1))
        && sentence.fields.get(count).is_empty()
    {
        out.push("an empty field stands at the end; some makers print one".into());
    }
    if let [.., b'*', high, low] = sentence.text
        && hex_byte(&[*high, *low]).is_some()
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

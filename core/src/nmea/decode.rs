//! Decoding by the whole dictionary.

use super::known::Known;
use super::sentence::{Sentence, decode_knowing};
use super::table::Definition;
use super::tables;

/// Decodes one line. Never fails: what is wrong is found in [`Sentence::faults`].
///
/// ```
/// use wheelover_core::nmea::{decode, Checksum};
/// let sentence = decode(b"$HEHDT,216.8,T*2A");
/// assert_eq!(sentence.formatter, "HDT");
/// assert_eq!(sentence.checksum, Checksum::Wrong { given: Some(0x2A), computed: 0x22 });
/// assert!(sentence.fields.get(1) == b"216.8");
/// ```
#[must_use]
pub fn decode(line: &[u8]) -> Sentence<'_> {
    decode_knowing::<Whole>(line)
}

/// All sentences.
struct Whole;

impl Known for Whole {
    #[inline(always)]
    fn formatter(formatter: [u8; 3]) -> Option<&'static Definition> {
        tables::find(formatter)
    }
    fn proprietary(address: &str) -> Option<&'static Definition> {
        tables::proprietary(address)
    }
    fn query() -> Option<&'static Definition> {
        Some(tables::query())
    }
}

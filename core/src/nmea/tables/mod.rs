//! The dictionary: every sentence in tables by subject, and how one is found (SEN-7).

use super::table::{Definition, SentenceText, key};

/// Joins the lists of the subjects; the texts stand in a list of their own, in the same order.
macro_rules! subjects {
    ($($subject:ident),+ $(,)?) => {
        $( mod $subject; pub use $subject::*; )+
        const COUNT: usize = 0 $(+ $subject::DEFINITIONS.len())+;
        const LISTS: &[&[&Definition]] = &[$($subject::DEFINITIONS),+];
        const TEXT_LISTS: &[&[&SentenceText]] = &[$($subject::TEXTS),+];
    };
}

subjects! {
    steering, sensors, weather, position, route, alerts, ais, radar, machinery, communication,
    safety, proprietary
}

static ALL: [&Definition; COUNT] = {
    let mut all = [LISTS[0][0]; COUNT];
    let (mut list, mut n) = (0, 0);
    while list < LISTS.len() {
        let mut i = 0;
        while i < LISTS[list].len() {
            all[n] = LISTS[list][i];
            n += 1;
            i += 1;
        }
        list += 1;
    }
    all
};

static ALL_TEXTS: [&SentenceText; COUNT] = {
    let mut all = [TEXT_LISTS[0][0]; COUNT];
    let (mut list, mut n) = (0, 0);
    while list < TEXT_LISTS.len() {
        let mut i = 0;
        while i < TEXT_LISTS[list].len() {
            all[n] = TEXT_LISTS[list][i];
            n += 1;
            i += 1;
        }
        list += 1;
    }
    all
};

/// Slots of the index; at most half of them are in use.
const SLOTS: usize = 512;

const fn slot(key: u32) -> usize {
    (key.wrapping_mul(0x9E37_79B1) >> 23) as usize % SLOTS
}

/// Number of the definition plus one, at the slot of its key or the next free one.
static INDEX: [u8; SLOTS] = {
    let mut index = [0u8; SLOTS];
    let mut n = 0;
    while n < COUNT {
        if ALL[n].key != 0 {
            let mut at = slot(ALL[n].key);
            while index[at] != 0 {
                at = (at + 1) % SLOTS;
            }
            index[at] = n as u8 + 1;
        }
        n += 1;
    }
    index
};
const _: () = assert!(COUNT < 255 && COUNT * 2 <= SLOTS);

/// The sentence of a formatter of three letters.
#[inline]
pub(crate) fn find(formatter: [u8; 3]) -> Option<&'static Definition> {
    let key = key(&formatter);
    let mut at = slot(key);
    while INDEX[at] != 0 {
        let definition = ALL[usize::from(INDEX[at]) - 1];
        if definition.key == key {
            return Some(definition);
        }
        at = (at + 1) % SLOTS;
    }
    None
}

/// The proprietary sentence (they are the last subject) with that address and sub-address, such as `PNEY,001`.
pub(crate) fn proprietary(formatter: &str) -> Option<&'static Definition> {
    LISTS[LISTS.len() - 1]
        .iter()
        .copied()
        .find(|definition| definition.formatter == formatter)
}

/// A query, `$--ccQ,FMT`.
pub(crate) fn query() -> &'static Definition {
    &query::DEFINITION
}

/// The texts of a sentence.
pub(crate) fn text(definition: &'static Definition) -> Option<&'static SentenceText> {
    ALL.iter()
        .position(|d| core::ptr::eq(*d, definition))
        .map(|n| ALL_TEXTS[n])
}

/// All sentences of the dictionary.
///
/// ```
/// use wheelover_core::nmea::dictionary;
/// assert!(dictionary().iter().any(|definition| definition.formatter == "PNEY,002"));
/// ```
#[must_use]
pub fn dictionary() -> &'static [&'static Definition] {
    &ALL
}

//! One wrong field: it is reported, and every other member keeps its value, in every sentence of the dictionary.

use super::generate::{bytes, line};
use super::random::Random;
use crate::nmea::*;
use alloc::format;
use alloc::string::String;
use alloc::vec::Vec;

/// What no member takes: no number, no code, no time, no text.
const WRONG: &[&str] = &["?\u{1}", "1e5~", "^zz", "0x\u{7f}", "~"];

/// Field and width of each member, and its value as text.
fn values(raw: &[u8]) -> Vec<(usize, usize, String)> {
    let mut out = Vec::new();
    let mut take = |item: Item<'_>| {
        let text = format!("{:?}", item.value);
        out.push((item.field, item.kind.width(), text));
    };
    decode(raw).walk(&mut take, &mut Vec::new());
    out
}

#[test]
fn one_wrong_field_is_reported_and_the_others_keep_their_values() {
    let mut random = Random::seeded("one wrong field");
    let mut reported = 0;
    for round in 0..40 * dictionary().len() {
        let definition = dictionary()[round % dictionary().len()];
        let text = line(&mut random, definition);
        let before = values(&bytes(text));
        let parts: Vec<&str> = text[..text.len() - 3].split(',').collect();
        for at in 1..parts.len() {
            let mut changed = parts.clone();
            changed[at] = random.pick(WRONG);
            let raw = bytes(&with_checksum(&changed.join(",")));
            let sentence = decode(&raw);
            // Another sub-address is another sentence, another count another group.
            if sentence
                .known
                .is_none_or(|known| !core::ptr::eq(known, definition))
            {
                continue;
            }
            let after = values(&raw);
            if after.len() != before.len() {
                continue;
            }
            let faults = sentence.field_faults();
            for (old, new) in before.iter().zip(&after) {
                let (field, width, value) = new;
                let member = *field..field + width;
                if !member.contains(&at) {
                    assert_eq!(old, new, "field {at} of {changed:?}");
                    continue;
                }
                let mut named = faults.iter().filter_map(|fault| fault.field);
                let named = named.any(|n| member.contains(&usize::from(n)));
                // A reserved field takes anything.
                assert!(
                    named || value.starts_with("Text"),
                    "field {at} of {changed:?}: {faults:?}"
                );
                reported += usize::from(named);
                if named {
                    assert!(
                        matches!(value.as_str(), "Invalid" | "Null"),
                        "{value} of {changed:?}"
                    );
                }
            }
            for fault in faults {
                assert!(!fault.text().is_empty() && !fault.kind.name().is_empty());
            }
        }
    }
    assert!(reported > 30_000, "{reported} fields");
}

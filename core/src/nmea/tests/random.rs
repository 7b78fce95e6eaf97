//! Random valid values of every table entry round-trip (SEN-4, SEN-7, SEN-9).

use super::generate::{Random, bytes, line, seed};
use crate::nmea::explain::explain;
use crate::nmea::*;
use alloc::vec::Vec;

#[test]
fn random_valid_values_come_back_byte_for_byte() {
    let mut random = Random(seed("values"));
    for definition in dictionary() {
        for _ in 0..200 {
            let text = line(&mut random, definition);
            let raw = bytes(&text);
            let sentence = decode(&raw);
            assert!(
                sentence
                    .known
                    .is_some_and(|d| core::ptr::eq(d, *definition)),
                "{text}"
            );
            let faults: Vec<_> = sentence
                .faults()
                .into_iter()
                .filter(|f| !matches!(f.kind, FaultKind::TooLong(_)))
                .collect();
            assert_eq!(faults, [], "{text}");
            assert_eq!(encode(&sentence).as_deref(), Some(text.as_str()));
            assert_eq!(
                explain(&sentence).fields.len(),
                sentence.fields.len(),
                "{text}"
            );
        }
    }
}

//! Random valid values of every table entry round-trip (SEN-4, SEN-7, SEN-9).

use super::generate::{bytes, lines};
use super::given::for_all;
use crate::nmea::explain::explain;
use crate::nmea::*;
use alloc::vec::Vec;
use proptest::{prop_assert, prop_assert_eq};

#[test]
fn random_valid_values_come_back_byte_for_byte() {
    for definition in dictionary() {
        for_all(150, &lines(definition), |text| {
            let raw = bytes(&text);
            let sentence = decode(&raw);
            let known = sentence.known.unwrap();
            prop_assert!(core::ptr::eq(known, *definition), "{}", known.formatter);
            let mut faults = sentence.faults();
            faults.retain(|fault| !matches!(fault.kind, FaultKind::TooLong(_)));
            prop_assert_eq!(faults, Vec::new());
            prop_assert_eq!(encode(&sentence), Some(text));
            let explained = explain(&sentence).fields.len();
            prop_assert_eq!(explained, sentence.fields.len());
            Ok(())
        });
    }
}

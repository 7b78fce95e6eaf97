//! Any body with its checksum repaired: values, faults, encoding, steering, JSON (FB2).
#![no_main]

use libfuzzer_sys::fuzz_target;
use wheelover_core::nmea::{decode, encode, json, steering};

/// The body with the right checksum.
fn repaired(body: &[u8]) -> Vec<u8> {
    let sum = body.iter().fold(0u8, |sum, b| sum ^ b);
    let mut line = vec![b'$'];
    line.extend_from_slice(body);
    line.extend_from_slice(format!("*{sum:02X}").as_bytes());
    line
}

fuzz_target!(|body: &[u8]| {
    if body.len() > 256 {
        return;
    }
    let line = repaired(body);
    let sentence = decode(&line);
    let count = sentence.fields.len();
    for fault in sentence.faults() {
        assert!(
            fault
                .field
                .is_none_or(|n| n >= 1 && usize::from(n) <= count)
        );
    }
    let _ = (steering(&sentence, true), json(1, None, &line));
    let again = encode(&sentence).map(|text| text.chars().map(|c| c as u8).collect::<Vec<u8>>());
    if let Some(once) = again {
        let twice = encode(&decode(&once));
        assert!(twice.is_some());
    }
});

//! Any body with its checksum repaired: values, faults, encoding, JSON, radio messages of any bits (FB2).
#![no_main]

mod radio;

use libfuzzer_sys::fuzz_target;
use wheelover_core::nmea::ais::Gatherer;
use wheelover_core::command::htc;
use wheelover_core::nmea::{decode, encode, json};
use wheelover_core::time::Stamp;

/// The body with the right checksum.
fn repaired(body: &[u8]) -> Vec<u8> {
    let sum = body.iter().fold(0u8, |sum, b| sum ^ b);
    let mut line = vec![b'$'];
    line.extend_from_slice(body);
    line.extend_from_slice(format!("*{sum:02X}").as_bytes());
    line
}

/// Sentences that carry six-bit characters, up to where these stand.
const CARRIERS: [&str; 5] = [
    "AIVDM,1,1,,A,",
    "AIVDO,1,1,,,",
    "AIABM,1,1,0,211234560,1,6,",
    "AIBBM,1,1,0,1,8,",
    "RATTD,01,01,1,",
];

/// A body of any bits: a byte for the carrier, one for the fill bits, then a character from each byte.
fn radio_body(bytes: &[u8]) -> Option<Vec<u8>> {
    let [carrier, fill_bits, bits @ ..] = bytes else {
        return None;
    };
    let mut body = CARRIERS.get(usize::from(*carrier))?.as_bytes().to_vec();
    body.extend(bits.iter().map(|byte| match byte & 63 {
        low @ 0..40 => low + b'0',
        high => high - 40 + b'`',
    }));
    body.extend_from_slice(format!(",{}", fill_bits % 7).as_bytes());
    Some(body)
}

fuzz_target!(|bytes: &[u8]| {
    if bytes.len() > 256 {
        return;
    }
    let radio_body = radio_body(bytes);
    let line = repaired(radio_body.as_deref().unwrap_or(bytes));
    let sentence = decode(&line);
    if let Some(gathered) = Gatherer::new().push(Stamp(0), &sentence) {
        radio::ask(&sentence, &gathered);
    }
    let count = sentence.fields.len();
    for fault in sentence.faults() {
        assert!(
            fault
                .field
                .is_none_or(|n| n >= 1 && usize::from(n) <= count)
        );
    }
    let _ = (htc(&sentence, true), json(1, None, &line));
    let again = encode(&sentence).map(|text| text.chars().map(|c| c as u8).collect::<Vec<u8>>());
    if let Some(once) = again {
        let twice = encode(&decode(&once));
        assert!(twice.is_some());
    }
});

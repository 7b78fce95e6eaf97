//! What no field may do to the decoder: FB1, FB2 and FB6 over every table entry; how long it may take is measured by `benches/hostile`.

use super::generate::{bytes, line};
use super::random::Random;
use crate::nmea::explain::explain;
use crate::nmea::*;
use alloc::vec::Vec;

const HOSTILE: &[&str] = &[
    "",
    "-",
    "+",
    ".",
    "-0",
    "-0.0",
    "NaN",
    "inf",
    "1e308",
    "0x10",
    "360",
    "360.0000001",
    "90",
    "180",
    "270",
    "359.99",
    "99999999999999999999",
    "9999999999999999999",
    "0.0000000000000000001",
    "-180.0",
    "9000.0001",
    "12365.635",
    "246060",
    "235960.99",
    "300299",
    "290299",
    "310499",
    "^",
    "^2",
    "^2C",
    "^zz",
    "$",
    "!",
    "\\",
    "*",
    "\u{0}",
    "\u{ff}",
    "A",
    "V",
    "a",
    "AA",
    "7777777777777777777777777777777777777777777777777777777777777777777777777777777777777777",
];

/// FB2.
#[test]
fn hostile_fields_never_panic_and_each_fault_names_a_field() {
    let mut random = Random::seeded("hostile");
    // A million in the long form.
    let rounds = if std::env::var_os("WHEELOVER_LONG").is_some() {
        1_000_000
    } else {
        200_000
    };
    for round in 0..rounds {
        let definition = dictionary()[round % dictionary().len()];
        let text = line(&mut random, definition);
        let body = &text[..text.len() - 3];
        let mut parts: Vec<&str> = body.split(',').collect();
        for _ in 0..=random.below(3) {
            let at = 1 + random.below(parts.len());
            match random.below(8) {
                0 => parts.insert(at, random.pick(HOSTILE)),
                1 if at < parts.len() => drop(parts.remove(at)),
                _ if at < parts.len() => parts[at] = random.pick(HOSTILE),
                _ => parts.push(random.pick(HOSTILE)),
            }
        }
        let raw = bytes(&with_checksum(&parts.join(",")));
        let sentence = decode(&raw);
        let count = sentence.fields.len();
        let named = |fault: &Fault| {
            fault
                .field
                .is_none_or(|n| n >= 1 && usize::from(n) <= count)
        };
        let explanation = explain(&sentence);
        assert!(
            explanation.faults.iter().all(named),
            "{parts:?} {:?}",
            explanation.faults
        );
        assert_eq!(explanation.fields.len(), count);
        sentence.walk(
            |item| assert!(item.value.number().is_none_or(f64::is_finite), "{parts:?}"),
            &mut Vec::new(),
        );
        if round % 16 == 0 {
            let _ = (
                hints(&sentence),
                json(1, None, &raw),
                crate::command::htc(&sentence, true),
            );
        }
        if sentence.field_faults().is_empty()
            && let Some(first) = encode(&sentence)
        {
            assert_eq!(encode(&decode(&bytes(&first))), Some(first), "{parts:?}");
        }
        // What is encoded is stable. A count that was faulty is gone the first time, its group the second.
        if let Some(again) = encode(&sentence).and_then(|first| encode(&decode(&bytes(&first)))) {
            let raw = bytes(&again);
            assert_eq!(
                encode(&decode(&raw)).as_deref(),
                Some(again.as_str()),
                "{parts:?}"
            );
        }
    }
}

/// Bytes of FB1.
const MUTATED: usize = 1_000_000_000;

/// FB1: any bytes, with overflow checks on.
#[test]
fn mutated_bytes_never_panic() {
    let mut random = Random::seeded("bytes");
    let mut stream = Vec::new();
    for round in 0..4 * dictionary().len() {
        let definition = dictionary()[round % dictionary().len()];
        stream.extend(bytes(line(&mut random, definition)));
        stream.extend_from_slice(b"\r\n");
    }
    let mut framer = Framer::new();
    let (mut read, mut frames, mut faults) = (0, 0usize, Vec::new());
    while read < MUTATED {
        let whole = core::mem::take(&mut stream);
        random.spoil(&whole, &mut stream);
        for piece in stream.chunks(1 + random.below(4_096)) {
            framer.push(piece, &mut |frame| {
                frames += 1;
                let sentence = decode(frame.text);
                faults.clear();
                sentence.walk(|_| (), &mut faults);
            });
        }
        read += stream.len();
        if read % 7 == 0 || stream.len() > whole.len() * 2 {
            stream = whole;
        }
    }
    std::eprintln!("{read} bytes in {frames} frames");
    assert!(frames > read / 400, "{frames} frames");
}

//! Any bytes through framer, decoder, explanation, assembler and radio messages; a split stream gives the same frames
//! (FB1, FB4).
#![no_main]

mod radio;

use libfuzzer_sys::fuzz_target;
use wheelover_core::nmea::ais::Gatherer;
use wheelover_core::nmea::{Assembler, Framer, decode, explain, hints};
use wheelover_core::time::Stamp;

fn frames(pieces: &[&[u8]]) -> Vec<(Vec<u8>, usize)> {
    let mut framer = Framer::new();
    let mut out = Vec::new();
    for piece in pieces {
        framer.push(piece, &mut |frame| {
            out.push((frame.text.to_vec(), frame.length))
        });
    }
    framer.flush(&mut |frame| out.push((frame.text.to_vec(), frame.length)));
    out
}

fuzz_target!(|bytes: &[u8]| {
    let whole = frames(&[bytes]);
    let at = bytes
        .first()
        .map_or(0, |&b| usize::from(b) % (bytes.len() + 1));
    let (a, b) = bytes.split_at(at);
    assert_eq!(frames(&[a, b]), whole);
    let (mut assembler, mut gatherer) = (Assembler::new(), Gatherer::new());
    for (text, _) in &whole {
        let sentence = decode(text);
        let explanation = explain(&sentence);
        assert_eq!(explanation.fields.len(), sentence.fields.len());
        let _ = (hints(&sentence), assembler.push(Stamp(0), &sentence));
        if let Some(gathered) = gatherer.push(Stamp(0), &sentence) {
            radio::ask(&sentence, &gathered);
        }
    }
});

//! Framing: SEN-1, SEN-8, FB4, FB5.

use super::generate::{bytes, line};
use super::random::Random;
use crate::nmea::{Fault, FrameKind, Framer, decode, dictionary, with_checksum};
use alloc::string::String;
use alloc::vec::Vec;

fn frames(pieces: &[&[u8]]) -> Vec<(bool, String, usize)> {
    let mut framer = Framer::new();
    let mut out = Vec::new();
    let mut sink = |frame: crate::nmea::Frame<'_>| {
        let text = frame.text.iter().map(|&b| char::from(b)).collect();
        out.push((frame.kind == FrameKind::Sentence, text, frame.length));
    };
    for piece in pieces {
        framer.push(piece, &mut sink);
    }
    framer.flush(&mut sink);
    out
}

fn check(stream: &str, expect: &[(bool, &str)]) {
    let found = frames(&[stream.as_bytes()]);
    let short: Vec<_> = found
        .iter()
        .map(|(kind, text, _)| (*kind, text.as_str()))
        .collect();
    assert_eq!(short, expect, "{stream:?}");
}

#[test]
fn terminators_are_tolerated_and_garbage_is_skipped() {
    check(
        "$A,1*00\r\n$B,2*00\n$C*00\r",
        &[(true, "$A,1*00"), (true, "$B,2*00"), (true, "$C*00")],
    );
    check(
        "noise$A*00\r\n\0\u{1}\r\n",
        &[(false, "noise"), (true, "$A*00"), (false, "\0\u{1}")],
    );
    check(
        "$A*00$B*00!C*00",
        &[(true, "$A*00"), (true, "$B*00"), (true, "!C*00")],
    );
    check(
        "$GPGLL,12$B*00\r\n",
        &[(false, "$GPGLL,12"), (true, "$B*00")],
    );
    check("\\c:1*00\\$A*00\r\n", &[(true, "\\c:1*00\\$A*00")]);
    check(
        "$A*00\\s:b*00\\!B*00\r\n",
        &[(true, "$A*00"), (true, "\\s:b*00\\!B*00")],
    );
    check("\\c:1$A*00\r\n", &[(false, "\\c:1"), (true, "$A*00")]);
    check("$A", &[(true, "$A")]);
    check("\r\n\r\n", &[]);
}

/// FB4.
#[test]
fn every_split_gives_the_same_frames() {
    let long = alloc::format!("${}\r\n", "x".repeat(600));
    let stream = alloc::format!(
        "x$EIHTC,V,,,S,N*00\r\n\\g:1-2-3*00\\!AIVDM,1,1,,A,15,0*00\r\n$A*00$B\\x*0$C\r\r\n{long}junk\n$D*00"
    );
    let bytes = stream.as_bytes();
    let whole = frames(&[bytes]);
    for at in 0..=bytes.len() {
        let (a, b) = bytes.split_at(at);
        assert_eq!(frames(&[a, b]), whole, "split at {at}");
    }
    for size in 1..20 {
        assert_eq!(
            frames(&bytes.chunks(size).collect::<Vec<_>>()),
            whole,
            "pieces of {size}"
        );
    }
}

/// FB5.
#[test]
fn ten_megabytes_without_an_end_stay_bounded() {
    let mut framer = Framer::new();
    let mut length = 0;
    for _ in 0..10_000 {
        framer.push(&[b'x'; 1000], &mut |frame| {
            assert!(frame.text.len() <= 256);
            length += frame.length;
        });
    }
    assert!(framer.capacity() <= 1024, "{}", framer.capacity());
    framer.push(b"\r\n$A*00\r\n", &mut |frame| {
        if frame.kind == FrameKind::Garbage {
            length += frame.length;
        } else {
            assert_eq!(frame.text, b"$A*00");
        }
    });
    assert_eq!(length, 10_000_000);
}

/// What a port's frames say: kind, text, formatter, faults.
fn events(framer: &mut Framer, pieces: &[&[u8]]) -> Vec<(FrameKind, Vec<u8>, Vec<Fault>)> {
    let mut out = Vec::new();
    let mut sink = |frame: crate::nmea::Frame<'_>| {
        out.push((frame.kind, frame.text.to_vec(), decode(frame.text).faults()));
    };
    for piece in pieces {
        framer.push(piece, &mut sink);
    }
    framer.flush(&mut sink);
    out
}

/// FB4: random sentences and noise, split at random places.
#[test]
fn random_streams_split_at_random_places_give_the_same_events() {
    let mut random = Random::seeded("splits");
    let noise: [&[u8]; 10] = [
        b"\r\n",
        b"\n",
        b"\r",
        b"$",
        b"!",
        b"\\",
        b"\0\xff",
        b"*2",
        b"\\s:a*00\\",
        b"",
    ];
    for round in 0..300 {
        let mut stream = Vec::new();
        for _ in 0..1 + random.below(12) {
            let definition = dictionary()[random.below(dictionary().len())];
            let mut raw = bytes(line(&mut random, definition));
            if random.below(3) == 0 {
                raw.truncate(random.below(raw.len()));
            }
            stream.extend(raw);
            stream.extend_from_slice(random.pick(&noise));
            stream.extend_from_slice(random.pick(&noise));
        }
        if round % 50 == 0 {
            stream.extend([b'x'; 70_000]);
        }
        let whole = events(&mut Framer::new(), &[&stream]);
        for most in [2, 3, 8, 64, 300] {
            let (mut pieces, mut rest) = (Vec::new(), stream.as_slice());
            while !rest.is_empty() {
                let (piece, after) = rest.split_at((1 + random.below(most)).min(rest.len()));
                pieces.push(piece);
                rest = after;
            }
            assert_eq!(
                events(&mut Framer::new(), &pieces),
                whole,
                "pieces to {most}"
            );
        }
    }
}

/// FB5: whatever is wrong with one sentence, only that one is lost, and at most 1 KiB is held.
#[test]
fn a_damaged_sentence_costs_no_other() {
    let good: Vec<Vec<u8>> = ["HEHDT,216.8,T", "EIHTC,V,,,T,R,,,0.35,,,,280.0,T,C"]
        .map(|body| bytes(&with_checksum(body)))
        .into();
    let long = |length: usize| [b"$EIEVE,".as_slice(), &alloc::vec![b'A'; length]].concat();
    let damaged: [(&str, Vec<u8>); 12] = [
        ("no terminator", b"$HEROT,-027.5,A*2F".to_vec()),
        ("merged", b"$HEROT,-027.5,A*2F$HETHS,1.0,A*00".to_vec()),
        ("a dollar inside", b"$HEROT,-0$27.5,A*2F\r\n".to_vec()),
        (
            "an exclamation mark inside",
            b"$HEROT,-0!27.5,A*2F\r\n".to_vec(),
        ),
        ("cut off", b"$HEROT,-0\r\n".to_vec()),
        ("zeros", b"$HEROT,-0\0\0.5,A*2F\r\n\0\0\0".to_vec()),
        (
            "8-bit noise",
            b"\xff\x80\xfe$HEROT,\xb27.5,A*2F\r\n\xa4".to_vec(),
        ),
        ("no checksum", b"$HEROT,-027.5,A\r\n".to_vec()),
        ("over 82", [long(100), b"\r\n".to_vec()].concat()),
        ("over 256", [long(400), b"\r\n".to_vec()].concat()),
        ("over 512, no end", long(5_000)),
        ("an open TAG block", b"\\s:EI0001,c:17".to_vec()),
    ];
    for (name, damage) in &damaged {
        let mut stream = good[0].clone();
        stream.extend_from_slice(b"\r\n");
        stream.extend_from_slice(damage);
        stream.extend_from_slice(&good[1]);
        stream.extend_from_slice(b"\r\n");
        for size in [1, 7, stream.len()] {
            let mut framer = Framer::new();
            let found = events(&mut framer, &stream.chunks(size).collect::<Vec<_>>());
            let clean = found.iter().filter(|event| event.2.is_empty());
            let clean: Vec<&[u8]> = clean.map(|event| event.1.as_slice()).collect();
            for line in &good {
                let there = clean.contains(&line.as_slice());
                assert!(there, "{name}: {} is lost", String::from_utf8_lossy(line));
            }
            assert!(framer.capacity() <= 1024, "{name}: {}", framer.capacity());
        }
    }
}

//! Framing: SEN-1, SEN-8, FB4, FB5.

use crate::nmea::{FrameKind, Framer};
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
    framer.push(b"\r\n$A*00\r\n", &mut |frame| {
        if frame.kind == FrameKind::Garbage {
            length += frame.length;
        } else {
            assert_eq!(frame.text, b"$A*00");
        }
    });
    assert_eq!(length, 10_000_000);
}

//! What a port may hold, whatever is sent to it: framer and assembler together at most 64 KiB (FB5, FB7).

use crate::nmea::{Assembler, Framer, decode, with_checksum};
use crate::time::Stamp;
use alloc::format;

/// Bytes a framer may hold (FB5).
const FRAMER: usize = 1024;
const PORT: usize = 64 * 1024;

/// FB7: groups that are never completed, with numbers that cannot be; a million in the long form.
#[test]
fn a_million_groups_that_never_end_stay_within_64_kib() {
    let rounds = if std::env::var_os("WHEELOVER_LONG").is_some() {
        1_000_000
    } else {
        100_000
    };
    let mut assembler = Assembler::new();
    let mut most = 0;
    let mut completed = 0;
    for i in 0..rounds {
        let id = i % 10;
        let payload = "w".repeat(i % 60);
        let body = match i % 7 {
            0 => format!("!AIVDM,9,1,{id},A,{payload},0"),
            1 => format!("!AIVDM,9,2,{id},A,{payload},0"),
            2 => format!("!AIVDM,{},{},{id},B,{payload},0", i % 11, i % 13),
            3 => format!("IIRTE,99,1,c,{i},{}", "WPT,".repeat(i % 12)),
            4 => format!("IIRTE,99,{},c,{},WPT", i % 101, i - i % 7 + 3),
            5 => format!("AGALF,2,1,{id},,B,A,V,,{i},,1,0,{}", "T".repeat(i % 16)),
            _ => format!("GPGSV,9,{},36,01,40,083,46", i % 10),
        };
        let line = with_checksum(&body);
        let whole = assembler.push(Stamp(i as u64 / 100), &decode(line.as_bytes()));
        completed += usize::from(whole.is_some());
        most = most.max(assembler.held());
    }
    assert!(most > 1024 && most + FRAMER <= PORT, "{most} bytes");
    assert!(completed < rounds / 10, "{completed} completed");
}

/// FB7: as many short lines as a message may have, in as many messages as are held.
#[test]
fn many_short_parts_stay_within_64_kib() {
    let mut assembler = Assembler::new();
    for route in 0..100 {
        for number in 1..99 {
            let line = with_checksum(&format!("IIRTE,99,{number},c,{route},A"));
            assembler.push(Stamp(0), &decode(line.as_bytes()));
            assert!(assembler.held() + FRAMER <= PORT, "{}", assembler.held());
        }
    }
    assert!(assembler.held() > 8 * 1024, "the parts are kept");
}

/// FB5: what a framer holds, as its state, is at most 1 KiB.
#[test]
fn a_framer_holds_at_most_a_kibibyte() {
    let mut framer = Framer::new();
    let noise: [&[u8]; 6] = [
        b"$",
        b"\\",
        b"$GPGGA,",
        &[0; 700],
        &[0xff; 700],
        &[b'x'; 70_000],
    ];
    for i in 0..600 {
        framer.push(noise[i * 7 % 6], &mut |frame| {
            assert!(frame.text.len() <= 256)
        });
        framer.push(noise[i % 6], &mut |frame| assert!(frame.text.len() <= 256));
        assert!(framer.held() <= FRAMER, "{}", framer.held());
    }
}

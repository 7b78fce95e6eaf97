//! Broken lines against whole ones, as ratios, and the limits of FB1 (100 MB/s) and FB2 (100 us); exits with 1 where one is missed.
//!
//! `cargo bench -p wheelover-core --bench hostile`
#![allow(clippy::disallowed_types, reason = "what is measured is time")]

#[path = "../../tests/random.rs"]
mod random;

use random::Random;
use std::hint::black_box;
use std::time::Instant;
use wheelover_core::nmea::{Framer, decode, encode, with_checksum};

/// Bytes that are read of each stream.
const BYTES: usize = 200_000_000;
const LEAST_MB_S: f64 = 100.0;
const WORST_US: f64 = 100.0;

const HOSTILE: &[&str] = &[
    "",
    "-",
    "1e308",
    "360.0000001",
    "99999999999999999999",
    "246060",
    "^zz",
    "$",
    "\u{0}",
    "A",
    "7777777777777777777777777777777777777777777777777777777777777777777777777777777777777777",
];

/// Every line of the samples, which are of every sentence.
fn samples() -> Vec<String> {
    let folder = concat!(env!("CARGO_MANIFEST_DIR"), "/../tests/data/samples");
    let mut lines = Vec::new();
    for file in std::fs::read_dir(folder).expect("samples").flatten() {
        let text = std::fs::read_to_string(file.path()).expect("a text");
        let sentences = text.lines().filter(|line| line.starts_with(['$', '!']));
        lines.extend(sentences.map(str::to_owned));
    }
    assert!(lines.len() > 100, "{} samples", lines.len());
    lines
}

/// Millions of bytes a second through framer, decoder and every field.
fn rate(stream: &[u8]) -> f64 {
    let (mut framer, mut faults) = (Framer::new(), Vec::new());
    let rounds = BYTES / stream.len();
    let begun = Instant::now();
    for _ in 0..rounds {
        for piece in stream.chunks(4_096) {
            framer.push(piece, &mut |frame| {
                faults.clear();
                decode(frame.text).walk(|item| _ = black_box(item.value), &mut faults);
            });
        }
    }
    (rounds * stream.len()) as f64 / 1e6 / begun.elapsed().as_secs_f64()
}

/// The least of some times that a line takes to be decoded, judged and encoded, microseconds.
fn time(line: &[u8]) -> f64 {
    let once = |_| {
        let begun = Instant::now();
        let sentence = decode(line);
        black_box((sentence.faults().len(), encode(&sentence)));
        begun.elapsed().as_secs_f64() * 1e6
    };
    (0..5).map(once).fold(f64::INFINITY, f64::min)
}

fn main() {
    let lines = samples();
    let mut random = Random::seeded("hostile");
    let whole: Vec<u8> = lines.join("\r\n").into_bytes();
    let mut broken = Vec::new();
    random.spoil(&whole, &mut broken);
    let (clean, rate) = (rate(&whole), rate(&broken));
    println!(
        "FB1: broken bytes {rate:.0} MB/s, {:.2} of whole lines ({clean:.0} MB/s)",
        rate / clean
    );

    let mut times: Vec<f64> = lines.iter().map(|line| time(line.as_bytes())).collect();
    times.sort_by(f64::total_cmp);
    let median = times[times.len() / 2];
    let mut worst = 0f64;
    for _ in 0..100_000 {
        let line = &lines[random.below(lines.len())];
        let mut parts: Vec<&str> = line
            .split('*')
            .next()
            .unwrap_or_default()
            .split(',')
            .collect();
        let at = random.below(parts.len());
        parts[at] = random.pick(HOSTILE);
        worst = worst.max(time(with_checksum(&parts.join(",")).as_bytes()));
    }
    println!(
        "FB2: worst broken sentence {worst:.1} us, {:.0} times the median of whole ones ({median:.2} us)",
        worst / median
    );
    if rate < LEAST_MB_S || worst > WORST_US {
        println!("slower than asked for");
        std::process::exit(1);
    }
}

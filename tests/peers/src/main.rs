//! Wheelover's decoder beside nmea-0183-rs 0.9.6 in one run: one core, processor time, files of 10^6 lines from a seeded generator,
//! every field typed, every checksum verified, best of 7.

mod lines;

use nmea_0183_rs::{NmeaSentence, parse_frame};
use std::hint::black_box;
use wheelover_core::nmea::{self, Value};

const LINES: usize = 1_000_000;
const ROUNDS: usize = 7;
const AGAIN: usize = 50;

fn file(one: fn(&mut lines::Random) -> String) -> String {
    let mut random = lines::Random::new(0x5EED_0183);
    let mut text = String::with_capacity(LINES * 60);
    for _ in 0..LINES {
        text.push_str(&nmea::with_checksum(&one(&mut random)));
        text.push_str("\r\n");
    }
    text
}

/// Processor time of this thread in seconds, so that a busy machine does not count.
fn now() -> f64 {
    let text = std::fs::read_to_string("/proc/thread-self/schedstat").unwrap_or_default();
    let nanoseconds = text.split(' ').next().and_then(|n| n.parse::<u64>().ok());
    nanoseconds.unwrap_or(0) as f64 / 1e9
}

/// Best of the rounds, in millions of lines a second.
fn race(count: usize, mut run: impl FnMut() -> usize) -> (f64, usize) {
    let mut best = f64::INFINITY;
    let mut typed = 0;
    for _ in 0..ROUNDS {
        let start = now();
        typed = run();
        best = best.min(now() - start);
    }
    (count as f64 / best / 1e6, typed)
}

/// What a value costs to make may not be left out by the compiler.
fn use_value(value: &Value<'_>) -> u64 {
    match value {
        // The exact decimal is the typed value.
        Value::Number(n) | Value::Angle(n) | Value::Time(n) | Value::Date(n) => {
            n.mantissa() ^ u64::from(n.scale()) << 56 ^ u64::from(n.negative())
        }
        Value::Position(lat, lon) => lat.mantissa() ^ lon.mantissa(),
        Value::Code(letter) => u64::from(*letter),
        Value::Text(text) => text.len() as u64,
        Value::Null | Value::Invalid => 0,
    }
}

/// The lines of a file, the same way for both.
fn split(text: &str) -> impl Iterator<Item = &str> {
    let mut start = 0;
    memchr::memchr_iter(b'\n', text.as_bytes()).filter_map(move |end| {
        let line = text.get(start..end);
        start = end + 1;
        line
    })
}

fn ours(text: &str) -> usize {
    let mut typed = 0;
    let mut faults = Vec::new();
    for line in split(text).map(str::as_bytes) {
        if line.is_empty() {
            continue;
        }
        let sentence = nmea::decode(line);
        if !sentence.checksum.is_right() {
            continue;
        }
        let mut sum = 0u64;
        sentence.walk(|item| sum ^= use_value(&item.value), &mut faults);
        black_box(sum);
        typed += usize::from(sentence.known.is_some() && faults.is_empty());
        faults.clear();
    }
    typed
}

fn rival(text: &str) -> usize {
    let mut typed = 0;
    for line in split(text) {
        if line.is_empty() {
            continue;
        }
        if let Ok(frame) = parse_frame(line) {
            let sentence = NmeaSentence::parse(&frame);
            typed += usize::from(!matches!(sentence, NmeaSentence::Unknown { .. }));
            black_box(&sentence);
        }
    }
    typed
}

fn encode(text: &str) -> (f64, f64) {
    let part: Vec<&str> = text.lines().take(2_000).collect();
    let frames: Vec<_> = part
        .iter()
        .filter_map(|line| parse_frame(line).ok())
        .collect();
    let theirs: Vec<_> = frames.iter().map(NmeaSentence::parse).collect();
    // A part that stays in the cache, again and again.
    let (rival, _) = race(theirs.len() * AGAIN, || {
        let mut sum = 0;
        for sentence in theirs.iter().cycle().take(theirs.len() * AGAIN) {
            sum += sentence
                .to_sentence("GP")
                .map_or(0, |line| black_box(line).len());
        }
        sum
    });
    let decoded: Vec<_> = part
        .iter()
        .map(|line| nmea::decode(line.as_bytes()))
        .collect();
    let values: Vec<nmea::Values<'_>> = decoded.iter().filter_map(nmea::Values::of).collect();
    let mut out = Vec::with_capacity(128);
    let (ours, _) = race(values.len() * AGAIN, || {
        let mut sum = 0;
        for values in values.iter().cycle().take(values.len() * AGAIN) {
            out.clear();
            values.write(&mut out);
            sum += black_box(&out).len();
        }
        sum
    });
    (rival, ours)
}

fn main() {
    println!(
        "{:<8} {:>8} {:>8} {:>6}   typed",
        "decode", "rival", "ours", "ratio"
    );
    let files: [(&str, fn(&mut lines::Random) -> String); 3] = [
        ("gnss", lines::gnss),
        ("bridge", lines::bridge),
        ("tcs", lines::tcs),
    ];
    let mut slow = false;
    for (name, one) in files {
        let text = file(one);
        let (rival_rate, rival_typed) = race(LINES, || rival(&text));
        let (our_rate, our_typed) = race(LINES, || ours(&text));
        let ratio = our_rate / rival_rate;
        println!(
            "{name:<8} {rival_rate:>8.2} {our_rate:>8.2} {ratio:>6.2}   rival {:.1} %, ours {:.1} %",
            rival_typed as f64 / LINES as f64 * 100.0,
            our_typed as f64 / LINES as f64 * 100.0
        );
        slow |= name != "tcs" && ratio < 2.0;
        if name != "tcs" {
            let (rival_rate, our_rate) = encode(&text);
            println!(
                "{:<8} {rival_rate:>8.2} {our_rate:>8.2} {:>6.2}   encode",
                "",
                our_rate / rival_rate
            );
            slow |= our_rate / rival_rate < 10.0;
        }
        let part: Vec<&str> = text.lines().take(200_000).collect();
        let (rate, _) = race(part.len(), || {
            part.iter()
                .map(|l| {
                    black_box(nmea::explain(&nmea::decode(l.as_bytes())))
                        .fields
                        .len()
                })
                .sum()
        });
        println!("{:<8} {:>8} {rate:>8.2} {:>6}   explain", "", "-", "-");
        slow |= rate < 1.0;
    }
    if slow {
        println!("slower than asked for");
        std::process::exit(1);
    }
}

//! Wheelover's decoder beside nmea-0183-rs 0.9.6, and with AIS beside `ais` 0.12.0 too, in one run: one core, processor time, files from
//! a seeded generator, every field typed, every checksum verified, all in every one of 9 rounds.

mod ais;
mod lines;
mod race;

use nmea_0183_rs::{NmeaSentence, parse_frame};
use race::{ROUNDS, Race, now, race, split};
use std::hint::black_box;
use wheelover_core::nmea::{self, Value};

const LINES: usize = 1_000_000;
const AGAIN: usize = 200;

fn file(one: fn(&mut lines::Random) -> String) -> String {
    let mut random = lines::Random(0x5EED_0183);
    let mut text = String::with_capacity(LINES * 60);
    for _ in 0..LINES {
        text.push_str(&nmea::with_checksum(&one(&mut random)));
        text.push_str("\r\n");
    }
    text
}

impl Race<2> {
    fn print(&self, name: &str, note: &str) {
        let [rival, ours] = self.best;
        println!(
            "{name:<8} {rival:>8.2} {ours:>8.2} {:>6.2} {:>7.2}   {note}",
            ours / rival,
            self.ratio
        );
    }
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

fn encode(text: &str) -> Race<2> {
    let part: Vec<&str> = text.lines().take(500).collect();
    let frames: Vec<_> = part
        .iter()
        .filter_map(|line| parse_frame(line).ok())
        .collect();
    let theirs: Vec<_> = frames.iter().map(NmeaSentence::parse).collect();
    let decoded: Vec<_> = part
        .iter()
        .map(|line| nmea::decode(line.as_bytes()))
        .collect();
    let values: Vec<nmea::Values<'_>> = decoded.iter().filter_map(nmea::Values::of).collect();
    let mut out = Vec::with_capacity(128);
    // A part that stays in the cache, again and again.
    race(
        part.len() * AGAIN,
        [
            &mut || {
                let mut sum = 0;
                for sentence in theirs.iter().cycle().take(theirs.len() * AGAIN) {
                    sum += sentence
                        .to_sentence("GP")
                        .map_or(0, |line| black_box(line).len());
                }
                sum
            },
            &mut || {
                let mut sum = 0;
                for values in values.iter().cycle().take(values.len() * AGAIN) {
                    out.clear();
                    values.write(&mut out);
                    sum += black_box(&out).len();
                }
                sum
            },
        ],
    )
}

/// Races named on the command line, or all.
fn main() {
    let named: Vec<String> = std::env::args().skip(1).collect();
    let runs = |name: &str| named.is_empty() || named.iter().any(|n| n == name);
    let mut slow = false;
    slow |= runs("sentences") && sentences();
    slow |= runs("ais") && radio();
    if slow {
        println!("slower than asked for");
        std::process::exit(1);
    }
}

/// The race of AIS decoders; says whether we are too slow.
fn radio() -> bool {
    let (radio, share) = ais::run();
    for (n, name) in ais::NAMES.iter().enumerate() {
        let (rate, share) = (radio.best[n], share[n]);
        println!("ais      {rate:>8.2} {name:<14} typed: {share:.1} % of the messages");
    }
    println!(
        "ais      {:>8.2} median of the rounds' ratios, ours to the best of the others",
        radio.ratio
    );
    radio.ratio < 2.0
}

/// The races of decoders and encoders of sentences; says whether we are too slow.
fn sentences() -> bool {
    println!(
        "{:<8} {:>8} {:>8} {:>6} {:>7}   M lines a second, best of {ROUNDS}; median of the rounds' ratios",
        "", "rival", "ours", "ratio", "median"
    );
    let files: [(&str, fn(&mut lines::Random) -> String); 3] = [
        ("gnss", lines::gnss),
        ("bridge", lines::bridge),
        ("tcs", lines::tcs),
    ];
    let mut slow = false;
    for (name, one) in files {
        let text = file(one);
        let decoding = race(LINES, [&mut || rival(&text), &mut || ours(&text)]);
        let [theirs, typed] = decoding.typed.map(|n| n as f64 / LINES as f64 * 100.0);
        let note = format!("decode, typed: rival {theirs:.1} %, ours {typed:.1} %");
        decoding.print(name, &note);
        slow |= name != "tcs" && decoding.ratio < 2.0;
        if name != "tcs" {
            let encoding = encode(&text);
            encoding.print("", "encode");
            slow |= encoding.ratio < 10.0;
        }
        let part: Vec<&str> = text.lines().take(200_000).collect();
        let mut rate = 0f64;
        for _ in 0..ROUNDS {
            let start = now();
            for line in &part {
                black_box(nmea::explain(&nmea::decode(line.as_bytes())).fields.len());
            }
            rate = rate.max(part.len() as f64 / (now() - start) / 1e6);
        }
        println!(
            "{:<8} {:>8} {rate:>8.2} {:>6} {:>7}   explain",
            "", "-", "-", "-"
        );
        slow |= rate < 1.0;
    }
    slow
}

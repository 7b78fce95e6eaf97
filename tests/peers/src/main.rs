//! Wheelover's decoder beside nmea-0183-rs 0.9.6 in one run: one core, processor time, files of 10^6 lines from a seeded generator,
//! every field typed, every checksum verified, both in every one of 9 rounds.

mod lines;

use nmea_0183_rs::{NmeaSentence, parse_frame};
use std::hint::black_box;
use wheelover_core::nmea::{self, Value};

const LINES: usize = 1_000_000;
const ROUNDS: usize = 9;
const AGAIN: usize = 200;

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
    let clock = nix::time::ClockId::CLOCK_THREAD_CPUTIME_ID;
    let time = nix::time::clock_gettime(clock).expect("a clock of the thread");
    time.tv_sec() as f64 + time.tv_nsec() as f64 / 1e9
}

/// What a race showed.
struct Race {
    /// Best of the rounds in millions of lines a second: the rival's and ours.
    best: [f64; 2],
    /// Median over the rounds of ours to the rival's, each round's two measured right after each other.
    ratio: f64,
    /// Lines each gave typed.
    typed: [usize; 2],
}

/// Runs both in every round, so that a machine that is slow for a while is slow for both.
fn race(count: usize, mut rival: impl FnMut() -> usize, mut ours: impl FnMut() -> usize) -> Race {
    let mut best = [f64::INFINITY; 2];
    let mut ratios = Vec::with_capacity(ROUNDS);
    let mut typed = [0; 2];
    for _ in 0..ROUNDS {
        let start = now();
        typed[0] = rival();
        let middle = now();
        typed[1] = ours();
        let times = [middle - start, now() - middle];
        ratios.push(times[0] / times[1]);
        best = [best[0].min(times[0]), best[1].min(times[1])];
    }
    ratios.sort_by(f64::total_cmp);
    Race {
        best: best.map(|time| count as f64 / time / 1e6),
        ratio: ratios[ROUNDS / 2],
        typed,
    }
}

impl Race {
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

fn encode(text: &str) -> Race {
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
        || {
            let mut sum = 0;
            for sentence in theirs.iter().cycle().take(theirs.len() * AGAIN) {
                sum += sentence
                    .to_sentence("GP")
                    .map_or(0, |line| black_box(line).len());
            }
            sum
        },
        || {
            let mut sum = 0;
            for values in values.iter().cycle().take(values.len() * AGAIN) {
                out.clear();
                values.write(&mut out);
                sum += black_box(&out).len();
            }
            sum
        },
    )
}

fn main() {
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
        let decoding = race(LINES, || rival(&text), || ours(&text));
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
    if slow {
        println!("slower than asked for");
        std::process::exit(1);
    }
}

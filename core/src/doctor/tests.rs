//! The doctor against lines that are played bit by bit to a receiver at any rate.

use super::*;
use crate::world::Random;
use alloc::vec;

/// A line: bytes as levels, ten bits each; `gap_s` of rest behind every sentence.
fn levels(
    sentences: &[&str],
    baud: f64,
    swapped: bool,
    gap_s: f64,
    seconds: f64,
) -> Vec<(f64, bool)> {
    let bit = 1.0 / baud;
    let mut time = 0.01;
    let mut edges = vec![(0.0, !swapped)];
    let mut put = |time: &mut f64, level: bool| {
        edges.push((*time, level != swapped));
        *time += bit;
    };
    'all: loop {
        for sentence in sentences {
            for byte in sentence.bytes() {
                put(&mut time, false);
                for shift in 0..8 {
                    put(&mut time, byte >> shift & 1 == 1);
                }
                put(&mut time, true);
            }
            if time > seconds {
                break 'all;
            }
            time += gap_s;
        }
    }
    edges
}

/// What a receiver makes of it: a start bit is an edge to 0, bits are looked at in their middle; a stop bit of 0 may be the next
/// start bit, as in a 16550; a break is one zero.
fn received(edges: &[(f64, bool)], baud: f64) -> Vec<u8> {
    let bit = 1.0 / baud;
    let end = edges.last().map_or(0.0, |(time, _)| *time);
    let mut index = 0;
    let mut level = |time: f64| {
        while index + 1 < edges.len() && edges[index + 1].0 <= time {
            index += 1;
        }
        edges[index].1
    };
    let mut bytes = Vec::new();
    let (mut time, mut was) = (0.0, true);
    while time < end {
        let now = level(time);
        if now || !was {
            was = now;
            time += bit / 16.0;
            continue;
        }
        let mut start = time;
        loop {
            let mut byte = 0_u8;
            for shift in 0..8 {
                let at = start + bit * (1.5 + f64::from(shift));
                byte |= u8::from(level(at)) << shift;
            }
            let stop = level(start + bit * 9.5);
            bytes.push(byte);
            if stop || byte == 0 {
                (time, was) = (start + bit * 9.5, stop);
                break;
            }
            start += bit * 9.0;
            if start > end {
                return bytes;
            }
        }
    }
    bytes
}

const RATES: [u32; 4] = [4_800, 9_600, 38_400, 115_200];
const GYRO: [&str; 2] = ["$HEHDT,216.8,T*22\r\n", "$HEROT,-027.5,A*20\r\n"];
const GPS: [&str; 3] = [
    "$GPGLL,5400.1234,N,00730.5678,E,120000.00,A,D*6B\r\n",
    "$GPVTG,216.8,T,,M,15.0,N,27.8,K,D*13\r\n",
    "$GPZDA,120000.00,29,11,2026,00,00*60\r\n",
];

/// Sentences with their right checksums.
fn mended(sentences: &[&str]) -> Vec<String> {
    let mend = |line: &&str| {
        let text = line
            .trim_start_matches('$')
            .split('*')
            .next()
            .unwrap_or_default();
        let sum = text.bytes().fold(0, |sum, byte| sum ^ byte);
        format!("${text}*{sum:02X}\r\n")
    };
    sentences.iter().map(mend).collect()
}

struct Prepared<'a> {
    sentences: &'a [&'a str],
    baud: u32,
    swapped: bool,
    gap_s: f64,
    set: u32,
}

fn diagnosed(line: &Prepared<'_>, spoil: impl Fn(&mut Vec<u8>), said: bool) -> Diagnosis {
    let sentences = mended(line.sentences);
    let sentences: Vec<&str> = sentences.iter().map(String::as_str).collect();
    let edges = levels(
        &sentences,
        f64::from(line.baud),
        line.swapped,
        line.gap_s,
        2.0,
    );
    let heard: Vec<Vec<u8>> = RATES
        .iter()
        .map(|baud| {
            let mut bytes = received(&edges, f64::from(*baud));
            spoil(&mut bytes);
            bytes
        })
        .collect();
    let samples: Vec<Sample<'_>> = (RATES.iter().zip(&heard))
        .map(|(baud, bytes)| Sample {
            baud: *baud,
            goes: *baud,
            ms: 2_000,
            bytes,
        })
        .collect();
    let said: Vec<Vec<u8>> = if said {
        sentences
            .iter()
            .map(|line| line.trim_end().as_bytes().to_vec())
            .collect()
    } else {
        Vec::new()
    };
    diagnose(Some(line.set), &samples, &said)
}

// FB10, FB12: each rate against each rate that is set, both polarities, two sorts of lines.
#[test]
fn every_prepared_line_is_told_right() {
    let mut told = 0;
    for sentences in [&GYRO[..], &GPS[..]] {
        for (baud, set) in [
            (4_800, 4_800),
            (4_800, 38_400),
            (38_400, 38_400),
            (38_400, 4_800),
            (9_600, 4_800),
        ] {
            for swapped in [false, true] {
                let line = Prepared {
                    sentences,
                    baud,
                    swapped,
                    gap_s: 0.1,
                    set,
                };
                let found = diagnosed(&line, |_| {}, false);
                let expect = if swapped {
                    Finding::Swapped
                } else if baud == set {
                    Finding::Good
                } else {
                    Finding::OtherRate { baud }
                };
                assert_eq!(
                    found.findings,
                    [expect],
                    "{baud} {set} {swapped} {:?}",
                    found.heard
                );
                assert_eq!(found.heard.baud, baud);
                told += 1;
            }
        }
    }
    assert_eq!(told, 20);
}

#[test]
fn damage_echo_load_noise_and_silence_are_told() {
    let line = |gap_s| Prepared {
        sentences: &GPS,
        baud: 4_800,
        swapped: false,
        gap_s,
        set: 4_800,
    };
    let damage = |bytes: &mut Vec<u8>| {
        let mut random = Random::new(3);
        for byte in bytes {
            if random.uniform() < 0.005 {
                *byte ^= 0x04;
            }
        }
    };
    let found = diagnosed(&line(0.05), damage, false);
    assert!(
        matches!(found.findings[..], [Finding::Damaged { percent: 5..=50 }]),
        "{:?}",
        found.findings
    );
    assert_eq!(
        diagnosed(&line(0.2), |_| {}, true).findings,
        [Finding::Echo]
    );
    let full = diagnosed(&line(0.0), |_| {}, false);
    assert!(
        matches!(
            full.findings[..],
            [Finding::Overloaded { percent: 95..=101 }]
        ),
        "{:?}",
        full.findings
    );
    let noise = |bytes: &mut Vec<u8>| {
        let mut random = Random::new(5);
        bytes
            .iter_mut()
            .for_each(|byte| *byte = (random.bits() >> 40) as u8);
    };
    assert_eq!(
        diagnosed(&line(0.1), noise, false).findings,
        [Finding::Noise]
    );
    assert_eq!(
        diagnosed(&line(0.1), Vec::clear, false).findings,
        [Finding::Silent]
    );
}

#[test]
fn bytes_whose_bits_alone_are_inverted_are_told() {
    let bytes: Vec<u8> = mended(&GPS).concat().bytes().map(|byte| !byte).collect();
    let sample = Sample {
        baud: 4_800,
        goes: 4_800,
        ms: 1_000,
        bytes: &bytes,
    };
    let found = diagnose(Some(4_800), &[sample], &[]);
    assert_eq!(found.findings, [Finding::Swapped]);
}

#[test]
fn an_adapter_that_does_not_go_at_a_rate_is_told() {
    let sentences = mended(&GYRO).concat();
    let sample = |baud| Sample {
        baud,
        goes: 9_600,
        ms: 1_000,
        bytes: sentences.as_bytes(),
    };
    let found = diagnose(Some(38_400), &[sample(38_400), sample(4_800)], &[]);
    assert_eq!(found.findings, [Finding::RateRefused { baud: 9_600 }]);
    assert_eq!(found.heard.talkers(), ["HE"]);
}

#[test]
fn every_finding_says_what_to_change() {
    for finding in [
        Finding::Silent,
        Finding::Noise,
        Finding::OtherRate { baud: 4_800 },
        Finding::Swapped,
        Finding::Echo,
        Finding::Overloaded { percent: 97 },
        Finding::Damaged { percent: 9 },
        Finding::RateRefused { baud: 9_600 },
    ] {
        assert!(finding.text().contains(": "), "{}", finding.text());
    }
}

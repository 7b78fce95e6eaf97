//! Speed of decoding, encoding, explanation and framing, in millions of lines a second; the best of some rounds.
//!
//! `cargo bench -p wheelover-core --bench decode`; beside another crate: `tests/peers`.
#![allow(clippy::disallowed_types, reason = "what is measured is time")]

use std::hint::black_box;
use std::time::Instant;
use wheelover_core::nmea::ais::{self, Gatherer, RadioMessage};
use wheelover_core::nmea::{self, Framer, Values};
use wheelover_core::time::Stamp;

const LINES: &[&str] = &[
    "EIHTC,V,,,T,R,,,0.35,,,,280.0,T,C",
    "AGHTD,V,14.0,R,T,R,35.0,20.0,0.35,017.5,279.5,,280.0,T,A,A,,267.2",
    "EIXTE,A,A,0.015,R,N,A",
    "PNEY,001,A,A,0.015,R,N,A",
    "PNEY,002,6235.234,N,12343.231,W,001",
    "EIGLL,5345.345,N,12335.635,W,123423,A,A",
    "EIVTG,234.5,T,,M,10.0,N,18.5,K,A",
    "EIVHW,235.2,T,238.2,M,11.2,N,20.7,K",
    "AGRSA,11.2,A,,V",
    "AGROR,14.0,A,,V,B",
    "HEHDT,216.8,T",
];

/// Types 1 to 5, 18, 21 and 24; two of twelve lines are parts.
const RADIO: &[&str] = &[
    "!AIVDM,1,1,,A,15RTgt0PAso;90TKcjM8h6g208CQ,0",
    "!AIVDM,1,1,,A,16SteH0P00Jt63hHaa6SagvJ087r,0",
    "!AIVDM,1,1,,B,25Cjtd0Oj;Jp7ilG7=UkKBoB0<06,0",
    "!AIVDM,1,1,,A,38Id705000rRVJhE7cl9n;160000,0",
    "!AIVDM,1,1,,A,403OviQuMGCqWrRO9>E6fE700@GO,0",
    "!AIVDM,2,1,1,A,55?MbV02;H;s<HtKR20EHE:0@T4@Dn2222222216L961O5Gf0NSQEp6ClRp8,0",
    "!AIVDM,2,2,1,A,88888888880,2",
    "!AIVDM,1,1,,A,B52K>;h00Fc>jpUlNV@ikwpUoP06,0",
    "!AIVDM,1,1,,B,B5O6hr00<veEKmUaMFdEow`UWP06,0",
    "!AIVDM,1,1,,B,E>m1c1>9TV`9WW@97QUP0000000F@lEpmdceP00003b,0",
    "!AIVDM,1,1,,A,H42O55i18tMET00000000000000,2",
    "!AIVDM,1,1,,A,H42O55lti4hhhilD3nink000?050,0",
];

fn bench(name: &str, lines: &[Vec<u8>], mut run: impl FnMut(&[u8])) {
    let mut best = f64::INFINITY;
    for _ in 0..7 {
        let start = Instant::now();
        for line in lines {
            run(line);
        }
        best = best.min(start.elapsed().as_secs_f64());
    }
    println!(
        "{name:<10} {:>8.2} M lines/s",
        lines.len() as f64 / best / 1e6
    );
}

fn main() {
    let lines: Vec<Vec<u8>> = (0..200_000)
        .map(|i| nmea::with_checksum(LINES[i % LINES.len()]).into_bytes())
        .collect();
    bench("decode", &lines, |line| {
        let sentence = nmea::decode(line);
        let mut sum = u64::from(sentence.checksum.is_right());
        sentence.walk(
            |item| sum ^= item.value.number().unwrap_or(0.0).to_bits(),
            &mut Vec::new(),
        );
        black_box(sum);
    });
    bench("scan", &lines, |line| {
        _ = black_box(nmea::decode(line)).checksum
    });
    bench("faults", &lines, |line| {
        _ = black_box(nmea::decode(line).faults())
    });
    bench("explain", &lines, |line| {
        _ = black_box(nmea::explain(&nmea::decode(line)))
    });
    bench("json", &lines[..20_000], |line| {
        _ = black_box(nmea::json(1, None, line))
    });
    let radio: Vec<Vec<u8>> = (0..200_000)
        .map(|i| nmea::with_checksum(RADIO[i % RADIO.len()]).into_bytes())
        .collect();
    let mut gatherer = Gatherer::new();
    bench("ais", &radio, |line| {
        let sentence = nmea::decode(line);
        let mut sum = 0;
        let mut add = |payload: &[u8], fill_bits| {
            RadioMessage::decode(payload, fill_bits).walk(
                |entry| {
                    sum ^= match entry.value {
                        ais::Value::Number(value) => value.to_bits(),
                        ais::Value::Integer(value) => value as u64,
                        ais::Value::Text(text) => text.chars().map(u64::from).sum(),
                        _ => 1,
                    }
                },
                &mut Vec::new(),
            );
        };
        // A message of one line is read from it.
        if sentence.fields.get(1) == b"1" && sentence.checksum.is_right() {
            let fill_bits = sentence
                .fields
                .get(6)
                .first()
                .map_or(0, |digit| digit - b'0');
            add(sentence.fields.get(5), fill_bits.into());
        } else if let Some(gathered) = gatherer.push(Stamp(0), &sentence) {
            let (payload, fill_bits) = gathered.payload();
            add(payload, fill_bits);
        }
        black_box(sum);
    });
    let mut out = Vec::new();
    bench("encode", &lines, |line| {
        out.clear();
        if let Some(values) = Values::of(&nmea::decode(line)) {
            values.write(&mut out);
        }
        black_box(&out);
    });
    bench("view", &lines, |line| {
        let sentence = nmea::decode(line);
        let _ = black_box(nmea::Htc::from_sentence(&sentence).map(|htc| htc.line("EI")));
    });
    let mut framer = Framer::new();
    bench("framer", &lines, |line| {
        framer.push(line, &mut |frame| _ = black_box(frame.length));
        framer.push(b"\r\n", &mut |frame| _ = black_box(frame.length));
    });
}

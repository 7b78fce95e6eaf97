//! The race of AIS decoders: seeded messages of types 1 to 5, 18, 21 and 24, every field typed, parts joined.

use crate::lines::Random;
use crate::race::{Race, race, split};
use ais::{AisFragments, AisParser};
use nmea_0183_rs::ais::{AisDecodeOutcome, AisMessage, AisParser as PeerParser};
use nmea_0183_rs::parse_frame;
use std::hint::black_box;
use wheelover_core::nmea;
use wheelover_core::nmea::ais::{Draft, Gatherer, RadioMessage, Value};
use wheelover_core::time::Stamp;

/// What they are called in the table, ours last.
pub const NAMES: [&str; 3] = ["nmea-0183-rs", "ais", "ours"];

/// Messages in the file; one of thirteen is of two lines.
const MESSAGES: usize = 500_000;

fn text(r: &mut Random, most: u64) -> String {
    let length = most / 4 + r.below(most - most / 4 + 1);
    (0..length)
        .map(|_| r.pick(&["A", "E", "I", "N", "R", "S", "T", "V", " ", "2"]))
        .collect()
}

/// A position of a report, and what moves with it.
fn report(r: &mut Random, kind: u8) -> Draft {
    let position = |limit: u64, value: u64| (value as f64 - limit as f64) / 600_000.0;
    let heading = r.below(361);
    let draft = Draft::new(kind)
        .with("mmsi", 200_000_000 + r.below(500_000_000) as i32)
        .with("position_accuracy", r.below(2) as i32)
        .with("longitude", position(108_000_000, r.below(216_000_000)))
        .with("latitude", position(54_000_000, r.below(108_000_000)))
        .with("speed_over_ground", r.below(300) as f64 / 10.0)
        .with("course_over_ground", r.below(3600) as f64 / 10.0)
        .with("time_stamp", r.below(60) as i32)
        .with("raim", r.below(2) == 1);
    match heading {
        360 => draft,
        heading => draft.with("true_heading", heading as i32),
    }
}

fn state(r: &mut Random, draft: Draft) -> Draft {
    draft
        .with("sync_state", r.below(3) as i32)
        .with("slot_timeout", r.below(8) as i32)
        .with("received_stations", r.below(9000) as i32)
        .with("slot_number", r.below(2250) as i32)
        .with("utc_hour", r.below(24) as i32)
        .with("utc_minute", r.below(60) as i32)
        .with("slot_increment", r.below(8000) as i32)
        .with("number_of_slots", r.below(8) as i32)
}

fn dimensions(r: &mut Random, draft: Draft) -> Draft {
    draft
        .with("ship_type", 60 + r.below(30) as i32)
        .with("to_bow", r.below(300) as i32)
        .with("to_stern", r.below(300) as i32)
        .with("to_port", r.below(30) as i32)
        .with("to_starboard", r.below(30) as i32)
        .with("position_fixing_device", 1 + r.below(8) as i32)
}

fn message(r: &mut Random) -> Draft {
    match r.below(13) {
        n @ 0..=5 => {
            let kind = [1, 1, 1, 1, 2, 3][n as usize];
            let draft = report(r, kind).with("navigational_status", r.below(9) as i32);
            let draft = match r.below(4) {
                0 => draft,
                1 => draft.with("rate_of_turn", 0),
                _ => draft.with("rate_of_turn", r.below(600) as f64 / 10.0 - 30.0),
            };
            state(r, draft)
        }
        6 => {
            let draft = report(r, 4)
                .with("year", 2026)
                .with("month", 1 + r.below(12) as i32)
                .with("day", 1 + r.below(28) as i32)
                .with("hour", r.below(24) as i32)
                .with("minute", r.below(60) as i32)
                .with("second", r.below(60) as i32)
                .with("position_fixing_device", 1);
            state(r, draft)
        }
        7 | 8 => {
            let draft = report(r, 18).with("class_b_unit", 1).with("display", true);
            state(r, draft.with("communication_state", 1))
        }
        9 => {
            let draft = report(r, 21)
                .with("aid_type", 1 + r.below(31) as i32)
                .with("name", text(r, 20).as_str());
            dimensions(r, draft)
        }
        10 => report(r, 24)
            .with("part", 0)
            .with("name", text(r, 20).as_str()),
        11 => {
            let draft = report(r, 24)
                .with("part", 1)
                .with("vendor", text(r, 3).as_str())
                .with("call_sign", text(r, 7).as_str());
            dimensions(r, draft)
        }
        _ => {
            let draft = report(r, 5)
                .with("imo_number", 9_000_000 + r.below(900_000) as i32)
                .with("call_sign", text(r, 7).as_str())
                .with("name", text(r, 20).as_str())
                .with("arrival_month", 1 + r.below(12) as i32)
                .with("arrival_day", 1 + r.below(28) as i32)
                .with("arrival_hour", r.below(24) as i32)
                .with("arrival_minute", r.below(60) as i32)
                .with("draught", (1 + r.below(200)) as f64 / 10.0)
                .with("destination", text(r, 20).as_str());
            dimensions(r, draft)
        }
    }
}

/// Lines with their ends, and how many there are.
pub fn file() -> (String, usize) {
    let mut random = Random(0x5EED_1371);
    let (mut text, mut lines) = (String::with_capacity(MESSAGES * 56), 0);
    let mut add = |body: String| {
        text.push_str(&nmea::with_checksum(&body));
        text.push_str("\r\n");
        lines += 1;
    };
    for n in 0..MESSAGES {
        let (payload, fill) = message(&mut random).payload().expect("values that fit");
        let channel = random.pick(&["A", "B"]);
        match payload.split_at_checked(60) {
            Some((first, second)) if !second.is_empty() => {
                let id = n % 10;
                add(format!("!AIVDM,2,1,{id},{channel},{first},0"));
                add(format!("!AIVDM,2,2,{id},{channel},{second},{fill}"));
            }
            _ => add(format!("!AIVDM,1,1,,{channel},{payload},{fill}")),
        }
    }
    (text, lines)
}

/// A value as the others give theirs: made, and a text in characters.
fn use_value(value: &Value<'_>) -> u64 {
    match value {
        Value::Text(text) => text.chars().map(u64::from).sum(),
        value => {
            black_box(value);
            0
        }
    }
}

/// Decodes a file with Wheelover; gives how many messages it typed without a fault.
pub fn ours(text: &str) -> usize {
    let mut gatherer = Gatherer::new();
    let (mut faults, mut others) = (Vec::new(), Vec::new());
    let mut typed = 0;
    for line in split(text).map(str::as_bytes) {
        let sentence = nmea::decode(line);
        let Some(gathered) = gatherer.push(Stamp(0), &sentence) else {
            continue;
        };
        let mut sum = 0;
        let walk = |message: &RadioMessage<'_>| {
            message.walk(|entry| sum ^= use_value(&entry.value), &mut faults);
        };
        gathered.each(walk, &mut others);
        black_box(sum);
        typed += usize::from(faults.is_empty() && others.is_empty());
        faults.clear();
        others.clear();
    }
    typed
}

fn nmea_0183_rs(text: &str) -> usize {
    let mut parser = PeerParser::new();
    let mut typed = 0;
    for line in split(text) {
        if let Ok(frame) = parse_frame(line)
            && let Ok(AisDecodeOutcome::Message(message)) = parser.decode(&frame)
        {
            typed += usize::from(!matches!(message, AisMessage::Unknown { .. }));
            black_box(&message);
        }
    }
    typed
}

fn ais(text: &str) -> usize {
    let mut parser = AisParser::new();
    let mut typed = 0;
    for line in split(text) {
        if let Ok(AisFragments::Complete(sentence)) = parser.parse(line.as_bytes(), true) {
            typed += usize::from(sentence.message.is_some());
            black_box(&sentence);
        }
    }
    typed
}

/// All three on one file; how many of its messages each gave typed.
pub fn run() -> (Race<3>, [f64; 3]) {
    let (text, lines) = file();
    let race = race(
        lines,
        [&mut || nmea_0183_rs(&text), &mut || ais(&text), &mut || {
            ours(&text)
        }],
    );
    let share = race.typed.map(|n| n as f64 / MESSAGES as f64 * 100.0);
    (race, share)
}

//! The page reads each frame as its text says it, and refuses what is damaged.
#![cfg(target_arch = "wasm32")]
#![allow(clippy::unwrap_used)]

use serde_json::Value;
use wasm_bindgen_test::wasm_bindgen_test;
use wheelover_core::nmea::with_checksum;
use wheelover_core::station::{Direction, Profile};
use wheelover_core::time::Stamp;
use wheelover_core::view::{Down, hello, snapshot};
use wheelover_core::voyage::Voyage;
use wheelover_web::link::frames::read;

/// What the page has no use for, it only counts.
const NOT_SHOWN: [&str; 2] = ["settings", "gap"];

/// Frames of a voyage under way, and the sample of each message.
fn frames() -> Vec<String> {
    let mut voyage = Voyage::embedded(7);
    let mut out = Vec::new();
    voyage.handle(Stamp(90_000), wheelover_core::voyage::Event::Tick, &mut out);
    // A fact that is one of several kinds, each with numbers of its own (AP-10).
    let mut magnetic = hello(&voyage, "test");
    magnetic.picture.ports[1].profile = Profile::Magn;
    let line = with_checksum("HCHDG,98.3,1.0,E,12.6,W");
    magnetic
        .picture
        .fold(Stamp(90_000), 1, Direction::In, line.as_bytes());
    let said = [
        Down::Hello(hello(&voyage, "test")),
        Down::Hello(magnetic),
        Down::Snapshot(snapshot(&voyage)),
    ];
    let samples = include_str!("../../core/src/view/golden.txt")
        .lines()
        .skip(1);
    let down = |text: &&str| serde_json::from_str::<Down>(text).is_ok();
    said.iter()
        .map(|frame| serde_json::to_string(frame).unwrap())
        .chain(samples.filter(down).map(str::to_owned))
        .collect()
}

fn check(text: &str) {
    let expect = serde_json::from_str::<Down>(text).ok();
    assert_eq!(read(text), expect, "{text}");
}

#[wasm_bindgen_test]
fn every_frame_is_read_as_it_was_written() {
    let frames = frames();
    assert!(
        frames.len() > 10 && frames[0].contains("gyro1") && frames[1].contains("magnetic"),
        "{frames:?}"
    );
    for text in &frames {
        if NOT_SHOWN
            .iter()
            .any(|kind| text.contains(&format!("\"type\":\"{kind}\"")))
        {
            assert_eq!(read(text), Some(Down::Gap { lost: 0 }));
        } else {
            check(text);
        }
    }
}

/// Replaces each part of a frame in turn, and lets each field be missing.
fn damage(whole: &Value, path: &str, seen: &mut dyn FnMut(Value)) {
    for wrong in [
        Value::Null,
        true.into(),
        (-1.5).into(),
        3.into(),
        "?".into(),
        Value::Array(vec![]),
    ] {
        let mut damaged = whole.clone();
        *damaged.pointer_mut(path).unwrap() = wrong;
        seen(damaged);
    }
    match whole.pointer(path).unwrap() {
        Value::Object(fields) => {
            for name in fields.keys() {
                let mut damaged = whole.clone();
                damaged
                    .pointer_mut(path)
                    .unwrap()
                    .as_object_mut()
                    .unwrap()
                    .remove(name);
                seen(damaged);
                damage(whole, &format!("{path}/{name}"), seen);
            }
        }
        Value::Array(list) => {
            for index in 0..list.len().min(3) {
                damage(whole, &format!("{path}/{index}"), seen);
            }
        }
        _ => {}
    }
}

#[wasm_bindgen_test]
fn a_damaged_frame_is_read_as_little_as_its_text_may_be() {
    let mut tried = 0;
    for text in frames() {
        let whole: Value = serde_json::from_str(&text).unwrap();
        let kind = whole["type"].as_str().unwrap().to_owned();
        if NOT_SHOWN.contains(&kind.as_str()) {
            continue;
        }
        for name in whole
            .as_object()
            .unwrap()
            .keys()
            .filter(|name| *name != "type")
        {
            damage(&whole, &format!("/{name}"), &mut |damaged| {
                tried += 1;
                check(&damaged.to_string());
            });
        }
    }
    assert!(tried > 1_000, "{tried}");
    for text in [
        "",
        "{}",
        "[]",
        "null",
        "{\"type\":\"other\"}",
        "{\"type\":7}",
    ] {
        assert_eq!(read(text), None, "{text}");
    }
}

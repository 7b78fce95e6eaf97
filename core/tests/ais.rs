//! Sentences with AIS messages and tracked targets whose meaning is published, and what must stand in their JSON.
//!
//! The expectations in `tests/data/ais` are written by hand from the published dumps.

use serde_json::Value as Json;
use std::fmt::Write as _;
use std::fs;
use std::path::PathBuf;
use wheelover_core::nmea::ais::{Draft, Gathered, Gatherer, RadioMessage};
use wheelover_core::nmea::{decode, json_line};
use wheelover_core::time::Stamp;

fn data(file: &str) -> String {
    let path = PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("../tests/data/ais");
    fs::read_to_string(path.join(file)).expect("the vectors")
}

/// The message that the last of some sentences completes, and that line's JSON object.
fn message(sentences: &[&str]) -> (Gathered<'static>, Json) {
    let mut gatherer = Gatherer::new();
    let (last, before) = sentences.split_last().expect("a sentence");
    for line in before {
        assert_eq!(
            gatherer.push(Stamp(0), &decode(line.as_bytes())),
            None,
            "{line}"
        );
    }
    let sentence = decode(last.as_bytes());
    let message = gatherer
        .push(Stamp(1), &sentence)
        .unwrap_or_else(|| panic!("{last} completes a message"));
    let text = json_line(1, None, &sentence).text_with(&message);
    let json: Json = serde_json::from_str(&text).expect("JSON");
    let message_json = json.get("message").cloned().expect("a message");
    (message.into_owned(), message_json)
}

/// Equal; numbers to a fraction of the finest step of a position.
fn same(found: &Json, expected: &Json) -> bool {
    match (found.as_f64(), expected.as_f64()) {
        (Some(found), Some(expected)) => (found - expected).abs() < 1e-6,
        _ => found == expected,
    }
}

/// Checks a file of blocks; gives the messages.
fn check(file: &str) -> Vec<Gathered<'static>> {
    let text = data(file);
    let mut messages = Vec::new();
    let mut differ = String::new();
    let blocks = text
        .split("\n\n")
        .map(|block| block.lines().filter(|line| !line.starts_with('#')));
    for block in blocks {
        let (sentences, expected): (Vec<&str>, Vec<&str>) = block
            .filter(|line| !line.is_empty())
            .partition(|line| line.starts_with('!'));
        if sentences.is_empty() {
            continue;
        }
        let (message, json) = message(&sentences);
        assert!(!expected.is_empty(), "{sentences:?}");
        for line in expected {
            let (pointer, value) = line.split_once(' ').expect("a pointer and a value");
            let value: Json = serde_json::from_str(value).expect("a JSON value");
            let found = json.pointer(pointer).unwrap_or(&Json::Null);
            if !same(found, &value) {
                let first = sentences[0];
                let _ = writeln!(differ, "{first}\n  {pointer}: {found}, should be {value}");
            }
        }
        messages.push(message);
    }
    assert!(differ.is_empty(), "{file}:\n{differ}");
    messages
}

#[test]
fn published_messages_mean_what_their_dumps_say() {
    let messages = check("radio.txt");
    let mut kinds: Vec<u8> = messages
        .iter()
        .filter_map(|message| message.messages().0.first()?.kind())
        .collect();
    kinds.sort_unstable();
    kinds.dedup();
    kinds.retain(|kind| (1..=27).contains(kind));
    assert_eq!(
        kinds,
        (1..=27).collect::<Vec<u8>>(),
        "every type has a vector"
    );
}

#[test]
fn published_messages_encode_to_what_they_were() {
    let mut exact = 0;
    for gathered in check("radio.txt") {
        let (messages, _) = gathered.messages();
        let message = messages.first().expect("a message");
        if !message.faults().is_empty() {
            continue;
        }
        let (payload, fill) = Draft::of(message).payload().expect("its own values fit");
        let again = RadioMessage::decode(payload.as_bytes(), fill.into());
        assert_eq!(Draft::of(&again), Draft::of(message), "{payload}");
        exact += u32::from(payload.as_bytes() == message.payload());
    }
    assert!(exact >= 20, "{exact} came back character for character");
}

#[test]
fn tracked_targets_mean_what_their_layout_says() {
    assert_eq!(check("targets.txt").len(), 6);
}

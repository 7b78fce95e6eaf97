//! A recording runs again to the same bytes, from its beginning and from the middle, and survives what it was made for.

use super::*;
use crate::autopilot::ModeName;
use crate::command::{FaultKind, Order, Origin};
use std::format;
use std::path::PathBuf;

/// Records the embedded voyage; outputs from `from` on, in seconds.
fn record(from: u64, seconds: u64) -> Vec<String> {
    let config = VoyageConfig::embedded(3);
    let mut lines = alloc::vec![beginning(&config, "test")];
    let mut voyage = Voyage::configured(config);
    let mut out = Vec::new();
    let fault = |cable: &str, kind, on| Order::Fault {
        cable: cable.into(),
        kind,
        on,
    };
    for second in 1..=seconds {
        let now = Stamp(second * 1_000);
        let action = match second {
            20 => Some(fault("ecdis", FaultKind::Silent, true)),
            60 => Some(fault("ecdis", FaultKind::Silent, false)),
            200 => Some(fault("gyro1", FaultKind::Jump, true)),
            260 => Some(fault("gyro1", FaultKind::Jump, false)),
            400 => Some(fault("gps", FaultKind::Jump, true)),
            _ => None,
        };
        let happened = action.map_or(Event::Tick, |action| Event::Order {
            id: second,
            by: Origin::Officer,
            order: action,
        });
        if happened != Event::Tick {
            lines.push(event(now, &happened));
        }
        out.clear();
        voyage.handle(now, happened, &mut out);
        if second > from {
            lines.extend(out.iter().map(|o| output(now, o)));
        } else if second == from {
            lines.push(outputs_begin(now));
        }
    }
    lines
}

fn replayed(lines: &[String]) -> Result<Replayed, RecordingError> {
    replay(lines.iter().map(String::as_str))
}

// CFG-1
#[test]
fn a_recorded_voyage_with_faults_replays_with_identical_outputs() {
    let lines = record(0, 500);
    let replayed = replayed(&lines).unwrap();
    assert_eq!(replayed.difference, None);
    assert_eq!((replayed.format, replayed.program.as_str()), (2, "test"));
    assert_eq!(replayed.events, 5);
    assert_eq!(replayed.outputs + 6, lines.len() as u64);
}

#[test]
fn one_that_is_begun_under_way_replays_with_identical_outputs() {
    let lines = record(230, 500);
    let replayed = replayed(&lines).unwrap();
    assert_eq!(replayed.difference, None);
    assert_eq!(replayed.outputs + 7, lines.len() as u64);
}

#[test]
fn the_first_difference_is_named_with_line_and_time_and_the_rest_is_run() {
    let mut lines = record(0, 70);
    let index = lines
        .iter()
        .position(|line| line.contains("AGHTD"))
        .unwrap();
    lines[index] = lines[index].replace("AGHTD", "AGHTX");
    let replayed = replayed(&lines).unwrap();
    let difference = replayed.difference.unwrap();
    assert_eq!((difference.line, difference.at), (index + 1, 1_000));
    assert!(difference.recorded.contains("AGHTX"), "{difference}");
    assert!(difference.computed.contains("AGHTD"), "{difference}");
    assert_eq!(replayed.events, 2);
}

// Bytes are text in which each character is one byte, whatever they are; an order says whose it is.
#[test]
fn events_are_readable_and_come_back_byte_for_byte() {
    let bytes: Vec<u8> = (0..=255).collect();
    let heard = Event::Bytes { port: 3, bytes };
    let line = event(Stamp(7), &heard);
    assert!(line.starts_with(r#"[7,{"heard":[3,""#), "{line}");
    assert!(line.contains("ABCDEFG"), "{line}");
    assert!(!line.contains('\n'));
    let Ok(Timed(at, entry)) = serde_json::from_str(&line) else {
        panic!("{line}");
    };
    assert_eq!(at, Stamp(7));
    assert!(matches!(entry.taken(), Taken::In(event) if event == heard));
    let order = Event::Order {
        id: 9,
        by: Origin::Officer,
        order: Order::SetHeading(12.5),
    };
    assert_eq!(
        event(Stamp(8), &order),
        r#"[8,{"order":{"id":9,"by":"officer","order":{"set_heading":12.5}}}]"#
    );
    let no_byte = r#"[7,{"heard":[3,"€"]}]"#;
    assert!(serde_json::from_str::<Timed>(no_byte).is_err());
}

#[test]
fn what_is_no_recording_of_ours_is_said() {
    assert_eq!(replay(["nonsense"]), Err(RecordingError::NoRecording));
    assert_eq!(replay([]), Err(RecordingError::NoRecording));
    assert_eq!(replay([r#"{"a":1}"#]), Err(RecordingError::NoRecording));
    let newer = replay([r#"{"recording":3,"route":[]}"#]);
    assert_eq!(newer, Err(RecordingError::Newer { format: 3 }));
    let image = replay([r#"{"checkpoint":{"format":1,"voyage":{"now":130000}}}"#]);
    assert_eq!(image, Err(RecordingError::Image));
    let begin = record(0, 0).remove(0);
    let unknown = begin.replace("\"seed\":3", "\"seed\":3,\"tide\":1");
    let error = replay([unknown.as_str()]).unwrap_err().to_string();
    assert!(error.starts_with("line 1: unknown field `tide`"), "{error}");
    let error = replay([begin.as_str(), "[1,{"]).unwrap_err();
    assert!(error.to_string().starts_with("line 2: "), "{error}");
}

#[test]
fn a_setting_that_is_no_more_is_noted_and_the_rest_is_in_force() {
    let begin = record(0, 0).remove(0);
    // Each would contradict the default of the other.
    let other = begin.replace("\"track_caution\":3.0", "\"track_caution\":7.0");
    let other = other.replace("\"track_fail\":5.0", "\"track_fail\":9.0,\"trim\":1.0");
    assert_ne!(begin, other);
    let mut replay = Replay::default();
    replay.take(&other).unwrap();
    let settings = replay.voyage().unwrap().autopilot().unwrap().settings();
    assert_eq!((settings.track_caution, settings.track_fail), (7.0, 9.0));
    let notes = replay.end().unwrap().notes;
    assert_eq!(notes, ["setting trim: no setting is named trim"]);
}

/// Runs a kept recording to its end; what came of it, and the voyage.
fn kept(name: &str) -> (Replayed, Voyage) {
    let folder = PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("../tests/data/recordings");
    let text = std::fs::read_to_string(folder.join(name)).unwrap();
    let mut replay = Replay::default();
    for line in text.lines() {
        replay
            .take(line)
            .unwrap_or_else(|error| panic!("{name}: {error}"));
    }
    let voyage = replay.voyage().cloned().unwrap();
    let replayed = replay.end().unwrap();
    std::println!("{name}: {replayed:?}");
    (replayed, voyage)
}

// Files of before load and run whatever has changed inside; what the program does otherwise now is a difference, no error.
#[test]
fn kept_recordings_of_every_format_load_and_run_to_their_end() {
    for (name, format) in [("format-1-ports.jsonl", 1), ("format-2-ports.jsonl", 2)] {
        let (replayed, voyage) = kept(name);
        assert_eq!((replayed.format, replayed.events), (format, 338), "{name}");
        // AUTO, a setting, AutoNAV confirmed by the recorded chart system, STANDBY at last.
        let autopilot = voyage.autopilot().unwrap();
        assert_eq!(autopilot.mode().name(), ModeName::Standby, "{name}");
        assert_eq!(autopilot.settings().rudder_limit, 15.0, "{name}");
        assert_eq!(voyage.now(), Stamp(14_000), "{name}");
        assert!(replayed.outputs > 10, "{name}: {:?}", replayed.difference);
    }
    let (replayed, voyage) = kept("format-1-embedded.jsonl");
    assert_eq!(replayed.format, 1);
    assert!(voyage.is_embedded());
    assert!(replayed.outputs > 0, "{:?}", replayed.difference);
    let named = format!("{:?}", replayed.notes);
    assert!(named.contains("set_by_radius"), "{named}");
}

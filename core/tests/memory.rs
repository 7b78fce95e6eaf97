//! The memory of a voyage does not grow (issue 9's numbers): the size of all that the stations know, over simulated days.
//!
//! `WHEELOVER_HOURS=168 cargo test -p wheelover-core --test memory -- --nocapture` sails a week.
#![allow(clippy::unwrap_used)]

use serde_json::Value;
use wheelover_core::station::Role;
use wheelover_core::time::Stamp;
use wheelover_core::view::{FaultKind, Order, Origin};
use wheelover_core::voyage::{Event, Voyage};

/// Hours in CI.
const HOURS: u64 = 6;
/// The largest size is that of the first hours: in them the histories fill, and every fault below comes many times.
const FIRST: u64 = 3;
/// What texts of alerts, reasons and lines under way may differ in, as a part of the whole: 4.8 % in a week.
const SLACK: f64 = 1.08;

/// Bytes of what is held, each number as eight.
fn size(value: &Value) -> usize {
    match value {
        Value::Null | Value::Bool(_) | Value::Number(_) => 8,
        Value::String(text) => 24 + text.len(),
        Value::Array(list) => 24 + list.iter().map(size).sum::<usize>(),
        Value::Object(fields) => fields.values().map(size).sum(),
    }
}

fn at(voyage: &mut Voyage, now: Stamp, event: Event) {
    voyage.handle(now, event, &mut Vec::new());
}

/// What happens to the cables in each twelve minutes: minute, cable, fault, and whether it begins.
const FAULTS: [(u64, &str, FaultKind, bool); 8] = [
    (1, "gps", FaultKind::Jump, true),
    (2, "gps", FaultKind::Jump, false),
    (4, "ecdis", FaultKind::Cut, true),
    (5, "ecdis", FaultKind::Cut, false),
    (7, "gyro1", FaultKind::Stuck, true),
    (8, "gyro1", FaultKind::Stuck, false),
    (10, "gear", FaultKind::Cut, true),
    (11, "gear", FaultKind::Cut, false),
];

#[test]
fn the_memory_of_a_voyage_does_not_grow() {
    let asked = std::env::var("WHEELOVER_HOURS").ok();
    let hours = asked.map_or(HOURS, |hours| hours.parse().unwrap());
    let mut voyage = Voyage::embedded(9);
    let (mut first, mut later) = (0, 0);
    for minute in 0..hours * 60 {
        let now = Stamp(minute * 60_000);
        at(&mut voyage, now, Event::Tick);
        for (when, cable, kind, on) in FAULTS {
            if minute % 12 == when {
                let (cable, by) = (cable.into(), Origin::Officer);
                let order = Order::Fault { cable, kind, on };
                at(&mut voyage, now, Event::Order { id: 1, by, order });
            }
        }
        let held = size(&serde_json::to_value(&voyage).unwrap());
        if minute < FIRST * 60 {
            first = first.max(held);
        } else {
            later = later.max(held);
        }
    }
    println!("{hours} h: at most {first} bytes in the first {FIRST} h, {later} later");
    let autopilot = voyage.autopilot().unwrap();
    assert!(
        autopilot
            .picture()
            .counts
            .iter()
            .any(|count| count.heard > hours * 3_000)
    );
    assert_eq!(autopilot.picture().station, Role::Autopilot);
    assert!(
        later as f64 <= first as f64 * SLACK,
        "{first} and {later} bytes"
    );
}

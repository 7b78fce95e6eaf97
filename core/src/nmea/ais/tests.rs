//! Tests over every message table: random valid values come back, hostile bits never panic (FB2, FB6, FB7).

use super::field::{Field, Item, Kind, NEVER};
use super::tables::{HEADER, layouts};
use super::*;
use crate::nmea::explain::latin1;
use crate::nmea::tests::given::for_all;
use crate::nmea::tests::random::Random;
use crate::nmea::{decode, with_checksum};
use crate::time::Stamp;
use alloc::string::String;
use alloc::vec::Vec;
use proptest::collection::vec;
use proptest::prelude::{Just, Strategy, any};
use proptest::sample::select;
use proptest::strategy::{BoxedStrategy, Union};
use proptest::{prop_assert_eq, prop_oneof};

/// A valid value of a field; null is the least.
fn value(field: &Field) -> BoxedStrategy<Input> {
    let highest = match field.width {
        0..31 => (1 << field.width) - 1,
        _ => i32::MAX,
    };
    match field.kind {
        Kind::Whole(scale) | Kind::Number(scale) => {
            let itself = move |raw: &i32| ![scale.none, scale.none_too, scale.top].contains(raw);
            let number = (scale.low..=scale.high.min(highest))
                .prop_filter("means itself", itself)
                .prop_map(move |raw| {
                    let value = f64::from(raw + scale.plus) / f64::from(scale.divisor);
                    Input::Number(if scale.divisor < 600 {
                        value
                    } else {
                        libm::round(value * 1e7) / 1e7
                    })
                });
            let top = Input::AtLeast(f64::from(scale.top) / f64::from(scale.divisor));
            let special = [(8, scale.none, Input::Null), (4, scale.top, top)];
            let special = special.into_iter().filter(|(_, raw, _)| *raw != NEVER);
            let mut all: Vec<_> = special
                .map(|(weight, _, input)| (weight, Just(input).boxed()))
                .collect();
            all.push((28, number.boxed()));
            Union::new_weighted(all).boxed()
        }
        Kind::Code(none, _) => {
            let code = move |raw: i32| match raw {
                raw if raw == none => Input::Null,
                raw => raw.into(),
            };
            (0..=highest).prop_map(code).boxed()
        }
        Kind::Flag => any::<bool>().prop_map(Input::Flag).boxed(),
        Kind::Turn => {
            let turn = |raw: i32| match raw {
                -128 => Input::Null,
                127 | -127 => Input::AtLeast(10.0 * f64::from(raw.signum())),
                126 | -126 => Input::AtLeast(field::rate_of_turn(raw)),
                raw => Input::Number(field::rate_of_turn(raw)),
            };
            (-128..=127).prop_map(turn).boxed()
        }
        Kind::Text => {
            let most = match field.width {
                0 => 14,
                width => width / 6,
            };
            let characters: Vec<char> = ('!'..'`').filter(|&c| c != '@').collect();
            let text = vec(select(characters), 1..=most);
            let text = text.prop_map(|text| Input::Text(text.into_iter().collect()));
            prop_oneof![1 => Just(Input::Null), 4 => text].boxed()
        }
        Kind::Binary(_) => {
            let bytes = vec(any::<u8>(), 1..10);
            let bytes = bytes.prop_map(|bytes| Input::Binary(bytes.clone(), bytes.len() * 8));
            prop_oneof![1 => Just(Input::Null), 9 => bytes].boxed()
        }
        Kind::Spare => Just(Input::Null).boxed(),
    }
}

/// Name, entry and value of a field.
type Setting = (&'static str, usize, Input);

/// A value for every field of some items; a field on which others depend is set first, as it stands there twice.
fn settings(items: &'static [Item], entry: usize) -> BoxedStrategy<Vec<Setting>> {
    let each = items.iter().map(|item| match item {
        Item::Field(field) if field.name.is_empty() || field.name == "type" => {
            Just(Vec::new()).boxed()
        }
        Item::Field(field) => value(field)
            .prop_map(move |value| std::vec![(field.name, entry, value)])
            .boxed(),
        Item::Each(_, most, _, items) => {
            let entries: Vec<_> = (1..=*most).map(|entry| settings(items, entry)).collect();
            (1..=*most, entries)
                .prop_map(|(count, entries)| entries[..count].concat())
                .boxed()
        }
        Item::Part(items)
        | Item::When(_, items)
        | Item::Longer(_, items)
        | Item::Auxiliary(_, items) => settings(items, entry),
    });
    let each: Vec<_> = each.collect();
    each.prop_map(|settings| settings.concat()).boxed()
}

#[test]
fn random_valid_values_come_back_in_every_message() {
    for layout in layouts() {
        let values = (settings(HEADER, 0), settings(layout.items, 0));
        for_all(200, &values, |(header, values)| {
            let set =
                |draft: Draft, (name, entry, value): Setting| draft.with_entry(name, entry, value);
            let all = header.into_iter().chain(values);
            let draft = all.fold(Draft::new(layout.kind), set);
            let (payload, fill_bits) = draft.payload().unwrap();
            let message = RadioMessage::decode(payload.as_bytes(), fill_bits.into());
            prop_assert_eq!(message.faults(), Vec::new());
            prop_assert_eq!(message.kind(), Some(layout.kind));
            // What the message has is what was set.
            for entry in message.entries() {
                if entry.name() != "type" {
                    let set = draft.set(entry.name(), entry.entry);
                    prop_assert_eq!(Input::from(entry.value), set, "{}", entry.name());
                }
            }
            let again = Draft::of(&message).payload();
            prop_assert_eq!(again, Ok((payload, fill_bits)));
            Ok(())
        });
    }
}

/// Everything that a caller can ask of a message.
fn ask_all(gathered: &Gathered<'_>) {
    let text = serde_json::to_string(gathered).unwrap();
    assert!(
        serde_json::from_str::<serde_json::Value>(&text).is_ok(),
        "{text}"
    );
    let (messages, _) = gathered.messages();
    for message in &messages {
        // The plan and the table give the same.
        let (mut planned, mut faults) = (Vec::new(), Vec::new());
        message.walk(
            |entry| planned.push((entry.name(), entry.group, entry.entry, entry.value)),
            &mut faults,
        );
        let entries = message.entries();
        let walked = entries.iter();
        let walked = walked.map(|entry| (entry.name(), entry.group, entry.entry, entry.value));
        assert_eq!(planned, walked.collect::<Vec<_>>(), "{text}");
        assert_eq!(faults, message.faults(), "{text}");
        for entry in message.entries() {
            match entry.value {
                Value::Number(value) | Value::AtLeast(value) => assert!(value.is_finite()),
                Value::Text(text) => assert!(text.chars().all(|c| (' '..='_').contains(&c))),
                _ => {}
            }
        }
        for fault in message.faults() {
            let named = fault
                .field
                .is_none_or(|name| message.entries().iter().any(|e| e.name() == name));
            assert!(named, "{fault}");
        }
        // What is encoded is stable.
        if let Ok((first, fill)) = Draft::of(message).payload() {
            let once = RadioMessage::decode(first.as_bytes(), fill.into());
            let twice = Draft::of(&once).payload();
            if once.faults().is_empty() {
                let again = twice.clone().unwrap();
                let thrice = RadioMessage::decode(again.0.as_bytes(), again.1.into());
                assert_eq!(Draft::of(&thrice).payload(), twice, "{text}");
            }
        }
    }
}

const ARMOUR: &[u8] = b"0123456789:;<=>?@ABCDEFGHIJKLMNOPQRSTUVW`abcdefghijklmnopqrstuvw";

#[test]
fn hostile_bits_never_panic() {
    let mut random = Random::seeded("hostile");
    // A million in the long form.
    let rounds = if std::env::var_os("WHEELOVER_LONG").is_some() {
        1_000_000
    } else {
        60_000
    };
    for _ in 0..rounds {
        let length = match random.below(4) {
            0 => random.below(8),
            1 => random.below(300),
            _ => 10 + random.below(30),
        };
        let mut payload: String = (0..length)
            .map(|_| char::from(ARMOUR[random.below(64_usize)]))
            .collect();
        if random.below(16) == 0 {
            payload.push(random.below(256) as u8 as char);
        }
        if random.below(3) == 0 {
            payload = payload.replace(char::is_alphabetic, "w");
        }
        let fill_bits = if random.below(8) == 0 {
            random.next() as u32
        } else {
            random.below(6) as u32
        };
        let payload = payload.as_bytes().into();
        ask_all(&match random.below(4) {
            0 => Gathered::Targets { payload, fill_bits },
            1 => Gathered::ToSend {
                destination: (random.below(2) == 0).then_some(1),
                number: random.below(80) as u8,
                payload,
                fill_bits,
            },
            _ => Gathered::Radio { payload, fill_bits },
        });
    }
}

/// The message that the last of some bodies completes.
fn last(bodies: &[&str]) -> Option<Gathered<'static>> {
    let mut gatherer = Gatherer::new();
    let mut last = None;
    for body in bodies {
        let line = with_checksum(body);
        let gathered = gatherer.push(Stamp(0), &decode(line.as_bytes()));
        last = gathered.map(Gathered::into_owned);
    }
    last
}

#[test]
fn parts_are_joined_only_where_they_belong_together() {
    let whole = |bodies: &[&str]| last(bodies).map(|gathered| latin1(gathered.payload().0));
    let is = |payload: &str| Some(String::from(payload));
    assert_eq!(
        whole(&["!AIVDM,2,1,3,A,55,0", "!AIVDM,2,2,3,A,66,2"]),
        is("5566")
    );
    // An empty last part, a null channel.
    assert_eq!(
        whole(&["!AIVDM,2,1,3,A,55,0", "!AIVDM,2,2,3,A,,0"]),
        is("55")
    );
    assert_eq!(
        whole(&["!AIVDO,2,1,3,,55,0", "!AIVDO,2,2,3,,66,0"]),
        is("5566")
    );
    // Another channel, another talker, a part that is missing, a count of 0, part 3 of 2.
    assert_eq!(whole(&["!AIVDM,2,1,3,A,55,0", "!AIVDM,2,2,3,B,66,2"]), None);
    assert_eq!(whole(&["!AIVDM,2,1,3,A,55,0", "!BSVDM,2,2,3,A,66,2"]), None);
    assert_eq!(whole(&["!AIVDM,3,1,3,A,55,0", "!AIVDM,3,3,3,A,66,2"]), None);
    assert_eq!(whole(&["!AIVDM,0,0,3,A,55,0"]), None);
    assert_eq!(whole(&["!AIVDM,2,1,3,A,55,0", "!AIVDM,2,3,3,A,66,2"]), None);
    // Two messages at once.
    let both = [
        "!AIVDM,2,1,3,A,55,0",
        "!AIVDM,2,1,4,A,77,0",
        "!AIVDM,2,2,3,A,66,2",
        "!AIVDM,2,2,4,A,88,0",
    ];
    assert_eq!(whole(&both[..3]), is("5566"));
    assert_eq!(whole(&both), is("7788"));
    // Addresses stand in the first part only.
    let addressed = last(&["!AIABM,2,1,1,351809000,0,12,4hh,0", "!AIABM,2,2,1,,,,hh4,2"]);
    let expected = Gathered::ToSend {
        destination: Some(351_809_000),
        number: 12,
        payload: b"4hhhh4".into(),
        fill_bits: 2,
    };
    assert_eq!(addressed, Some(expected));
    // The numbers of a TTD are hexadecimal.
    let parts: Vec<String> = (1..=10)
        .map(|n| alloc::format!("!RATTD,0A,{n:02X},1,0,0"))
        .collect();
    let parts: Vec<&str> = parts.iter().map(String::as_str).collect();
    assert_eq!(whole(&parts), is("0000000000"));
}

#[test]
fn a_wrong_checksum_gives_no_message() {
    let mut gatherer = Gatherer::new();
    let mut push = |line: &str| gatherer.push(Stamp(0), &decode(line.as_bytes())).is_some();
    assert!(push("!AIVDM,1,1,,A,15RTgt0PAso;90TKcjM8h6g208CQ,0*4A"));
    assert!(push("!AIVDM,1,1,,A,15RTgt0PAso;90TKcjM8h6g208CQ,0"));
    assert!(!push("!AIVDM,1,1,,A,15RTgt0PAso;90TKcjM8h6g208CQ,0*4B"));
    assert!(!push("$HEHDT,216.8,T*22"));
}

#[test]
fn what_is_wrong_is_named_and_the_rest_stays() {
    let check = |payload: &str, fill_bits: u32, expect: &str| {
        let message = RadioMessage::decode(payload.as_bytes(), fill_bits);
        let faults: Vec<String> = message
            .faults()
            .iter()
            .map(|fault| alloc::format!("{fault}"))
            .collect();
        assert_eq!(faults, [expect], "{payload}");
        assert_eq!(message.payload(), payload.as_bytes());
        Draft::of(&message)
    };
    let draft = check(
        "15RTgt0PAso;90TKcjM8h6 g208CQ",
        0,
        "character 23 (0x20) is not six-bit armour",
    );
    assert_eq!(draft.set("speed_over_ground", 0), Input::Number(12.3));
    let draft = check(
        "15RTgt0PAso;90TKcjM8h6g208CQ",
        6,
        "6 fill bits, there are 0 to 5",
    );
    assert_eq!(draft.set("mmsi", 0), Input::from(371_798_000));
    check("", 0, "no data");
    check("0", 0, "no message type 0");
    check("w", 0, "no message type 63");
    check(
        "15RTgt0PAso;90TKcjM8h6g2",
        0,
        "144 bits, there should be at least 168",
    );
    check(
        "15RTgt0PAso;90TKcjM8h6g208CQ0",
        0,
        "174 bits, there should be at most 168",
    );
    let long = "8".repeat(400);
    check(&long, 0, "2400 bits, there should be at most 1008");
    // Latitude 95.
    let bad = Draft::new(1).with("latitude", 95.0).payload().unwrap_err();
    assert_eq!(
        alloc::format!("{bad}"),
        "latitude: a value that is not allowed"
    );
}

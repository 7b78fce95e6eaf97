//! Tests over every table entry: random valid values round-trip, hostile fields never panic (FB2, FB6).

use crate::nmea::decimal::Decimal;
use crate::nmea::explain::explain;
use crate::nmea::table::{Definition, Format, Kind, Repeat};
use crate::nmea::*;
use alloc::string::String;
use alloc::vec::Vec;

/// A small seeded generator (xorshift).
struct Random(u64);

impl Random {
    fn next(&mut self) -> u64 {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 7;
        self.0 ^= self.0 << 17;
        self.0
    }
    fn below(&mut self, limit: usize) -> usize {
        (self.next() % limit.max(1) as u64) as usize
    }
    fn from(&mut self, low: i64, high: i64) -> i64 {
        low + (self.next() % (high - low + 1) as u64) as i64
    }
    fn pick<T: Copy>(&mut self, list: &[T]) -> T {
        list[self.below(list.len())]
    }
}

fn push(out: &mut String, number: Decimal, unsigned: bool) {
    let mut digits = Vec::new();
    number.write(&mut digits, unsigned);
    out.push_str(core::str::from_utf8(&digits).unwrap());
}

fn number(random: &mut Random, format: Format, scale: u8) -> Decimal {
    let low = i64::from(format.low.max(-99_999));
    let high = i64::from(format.high.min(99_999));
    let whole = random.from(low, high);
    let scale = if whole == low || whole == high {
        0
    } else {
        scale
    };
    let one = 10u64.pow(u32::from(scale));
    let mantissa = whole.unsigned_abs() * one + random.next() % one;
    Decimal::new(whole < 0, mantissa, scale, format.whole)
}

/// Canonical fields of a member, or its null form.
fn fields(random: &mut Random, kind: &Kind, out: &mut Vec<String>) {
    let null = random.below(5) == 0;
    let mut field = String::new();
    let letter = |letter: u8| String::from(char::from(letter));
    match kind {
        Kind::Number(format) | Kind::Lettered(format, _) => {
            if !null {
                let scale = random.below(5) as u8;
                push(&mut field, number(random, *format, scale), false);
            }
            out.push(field);
            if let Kind::Lettered(_, l) = kind {
                out.push(letter(*l));
            }
        }
        Kind::Integer(format) => {
            if !null {
                push(&mut field, number(random, *format, 0), false);
            }
            out.push(field);
        }
        Kind::Sided(format, sides) | Kind::Crossed(format, sides, _) => {
            let mut side = String::new();
            if !null {
                let scale = random.below(5) as u8;
                push(&mut field, number(random, *format, scale), true);
                side = letter(random.pick(&[sides.negative, sides.positive]));
            }
            out.extend([field, side]);
            if let Kind::Crossed(_, _, l) = kind {
                out.push(letter(*l));
            }
        }
        Kind::Code(letters) => out.push(if null {
            field
        } else {
            letter(random.pick(letters))
        }),
        Kind::Text(limit) => {
            if !null {
                // Each piece is one character of the text.
                let pieces = ["A", "b", "7", " ", "-", "^2C", "\u{e9}", "^21", "/"];
                for _ in 0..1 + random.below(usize::from(*limit).min(12)) {
                    field.push_str(random.pick(&pieces));
                }
            }
            out.push(field);
        }
        Kind::Position(_) => {
            let mut half = |random: &mut Random, degrees: i64, digits, sides: [u8; 2]| {
                let mut field = String::new();
                let scale = random.below(6) as u8;
                let one = 10u64.pow(u32::from(scale));
                let minutes = random.from(0, degrees - 1) as u64 * 100 + random.next() % 60;
                let mantissa = minutes * one + random.next() % one;
                push(
                    &mut field,
                    Decimal::new(false, mantissa, scale, digits),
                    true,
                );
                let side = letter(random.pick(&sides));
                if null {
                    out.extend([String::new(), String::new()])
                } else {
                    out.extend([field, side])
                }
            };
            half(random, 90, 4, *b"NS");
            half(random, 180, 5, *b"EW");
        }
        Kind::Angle { degrees: 2, .. } => out.extend(["5959.9".into(), "S".into()]),
        Kind::Angle { .. } => out.extend(["17900.0".into(), "W".into()]),
        Kind::Time => {
            if !null {
                let clock = random.below(24) * 10_000 + random.below(60) * 100 + random.below(61);
                let scale = random.below(4) as u8;
                let one = 10u64.pow(u32::from(scale));
                let mantissa = clock as u64 * one + random.next() % one;
                push(&mut field, Decimal::new(false, mantissa, scale, 6), true);
            }
            out.push(field);
        }
        Kind::Date => {
            if !null {
                field = alloc::format!(
                    "{:02}{:02}{:02}",
                    random.from(1, 28),
                    random.from(1, 12),
                    random.from(0, 99)
                );
            }
            out.push(field);
        }
        Kind::Hex(digits) => {
            if !null {
                for _ in 0..=random.below(usize::from(*digits)) {
                    field.push(random.pick(&['0', '3', '9', 'A', 'F']));
                }
            }
            out.push(field);
        }
        Kind::Payload | Kind::Any => {
            if !null {
                for _ in 0..=random.below(20) {
                    field.push(random.pick(&['0', '9', ':', 'W', '`', 'w', 'k']));
                }
            }
            out.push(field);
        }
    }
}

/// A canonical line of a sentence.
fn line(random: &mut Random, definition: &Definition) -> String {
    let mut all = Vec::new();
    for kind in definition.members {
        fields(random, kind, &mut all);
    }
    if let Some(group) = &definition.group {
        let count = match group.repeat {
            Repeat::UpTo(most) if group.members.len() == 1 => usize::from(most),
            Repeat::UpTo(most) => random.below(usize::from(most) + 1),
            Repeat::Counted(at) => {
                let count = random.below(4);
                all[usize::from(at)] = alloc::format!("{count}");
                count
            }
            Repeat::Open => 1 + random.below(3),
        };
        for _ in 0..count {
            for kind in group.members {
                fields(random, kind, &mut all);
            }
        }
        if random.below(2) == 0 {
            for kind in definition.tail {
                fields(random, kind, &mut all);
            }
        }
    } else {
        let length = usize::from(random.pick(definition.lengths));
        all.truncate(length - definition.first());
    }
    let talker = if definition.first() == 1 || definition.formatter == "Q" {
        ""
    } else {
        "II"
    };
    let formatter = if definition.formatter == "Q" {
        "CCECQ"
    } else {
        definition.formatter
    };
    let start = char::from(definition.delimiter);
    let mut body = alloc::format!("{start}{talker}{formatter}");
    for field in &all {
        body.push(',');
        body.push_str(field);
    }
    with_checksum(&body)
}

/// The bytes of a line: ISO 8859-1.
fn bytes(line: &str) -> Vec<u8> {
    line.chars().map(|c| u32::from(c) as u8).collect()
}

fn seed(name: &str) -> u64 {
    // Fixed, so that a failure comes again; printed, so that it can be changed.
    let seed = 0x5EED_0183_u64 ^ name.len() as u64;
    std::eprintln!("{name}: seed {seed:#x}");
    seed
}

#[test]
fn random_valid_values_come_back_byte_for_byte() {
    let mut random = Random(seed("values"));
    for definition in dictionary() {
        for _ in 0..200 {
            let text = line(&mut random, definition);
            let raw = bytes(&text);
            let sentence = decode(&raw);
            assert!(
                sentence
                    .known
                    .is_some_and(|d| core::ptr::eq(d, *definition)),
                "{text}"
            );
            let faults: Vec<_> = sentence
                .faults()
                .into_iter()
                .filter(|f| !matches!(f.kind, FaultKind::TooLong(_)))
                .collect();
            assert_eq!(faults, [], "{text}");
            assert_eq!(encode(&sentence).as_deref(), Some(text.as_str()));
            assert_eq!(
                explain(&sentence).fields.len(),
                sentence.fields.len(),
                "{text}"
            );
        }
    }
}

const HOSTILE: &[&str] = &[
    "",
    "-",
    "+",
    ".",
    "-0",
    "-0.0",
    "NaN",
    "inf",
    "1e308",
    "0x10",
    "360",
    "360.0000001",
    "90",
    "180",
    "270",
    "359.99",
    "99999999999999999999",
    "9999999999999999999",
    "0.0000000000000000001",
    "-180.0",
    "9000.0001",
    "12365.635",
    "246060",
    "235960.99",
    "300299",
    "290299",
    "310499",
    "^",
    "^2",
    "^2C",
    "^zz",
    "$",
    "!",
    "\\",
    "*",
    "\u{0}",
    "\u{ff}",
    "A",
    "V",
    "a",
    "AA",
    "7777777777777777777777777777777777777777777777777777777777777777777777777777777777777777",
];

#[test]
fn hostile_fields_never_panic_and_each_fault_names_a_field() {
    let mut random = Random(seed("hostile"));
    // A million in the long form.
    let rounds = if std::env::var_os("WHEELOVER_LONG").is_some() {
        1_000_000
    } else {
        200_000
    };
    for round in 0..rounds {
        let definition = dictionary()[round % dictionary().len()];
        let text = line(&mut random, definition);
        let body = &text[..text.len() - 3];
        let mut parts: Vec<&str> = body.split(',').collect();
        for _ in 0..=random.below(3) {
            let at = 1 + random.below(parts.len());
            match random.below(8) {
                0 => parts.insert(at, random.pick(HOSTILE)),
                1 if at < parts.len() => drop(parts.remove(at)),
                _ if at < parts.len() => parts[at] = random.pick(HOSTILE),
                _ => parts.push(random.pick(HOSTILE)),
            }
        }
        let raw = bytes(&with_checksum(&parts.join(",")));
        let sentence = decode(&raw);
        let count = sentence.fields.len();
        let named = |fault: &Fault| {
            fault
                .field
                .is_none_or(|n| n >= 1 && usize::from(n) <= count)
        };
        let explanation = explain(&sentence);
        assert!(
            explanation.faults.iter().all(named),
            "{parts:?} {:?}",
            explanation.faults
        );
        assert_eq!(explanation.fields.len(), count);
        sentence.walk(
            |item| assert!(item.value.number().is_none_or(f64::is_finite), "{parts:?}"),
            &mut Vec::new(),
        );
        if round % 16 == 0 {
            let _ = (
                hints(&sentence),
                json(1, None, &raw),
                steering(&sentence, true),
            );
        }
        // What is encoded is stable. A count that was faulty is gone the first time, its group the second.
        if let Some(again) = encode(&sentence).and_then(|first| encode(&decode(&bytes(&first)))) {
            let raw = bytes(&again);
            assert_eq!(
                encode(&decode(&raw)).as_deref(),
                Some(again.as_str()),
                "{parts:?}"
            );
        }
    }
}

#[test]
fn mutated_bytes_never_panic() {
    let mut random = Random(seed("bytes"));
    let mut framer = Framer::new();
    for round in 0..200_000 {
        let definition = dictionary()[round % dictionary().len()];
        let mut raw = bytes(&line(&mut random, definition));
        for _ in 0..random.below(4) {
            let at = random.below(raw.len());
            match random.below(3) {
                0 => raw[at] = random.next() as u8,
                1 => drop(raw.remove(at)),
                _ => raw.insert(at, random.next() as u8),
            }
        }
        raw.extend_from_slice(b"\r\n");
        framer.push(&raw, &mut |frame| {
            let sentence = decode(frame.text);
            let _ = (sentence.faults(), encode(&sentence));
        });
    }
}

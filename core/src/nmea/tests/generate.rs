//! Random canonical lines of every table entry.

use crate::nmea::decimal::Decimal;
use crate::nmea::table::{Definition, Format, Kind, Repeat};
use crate::nmea::whole::key;
use crate::nmea::with_checksum;
use alloc::string::String;
use alloc::vec::Vec;

/// A small seeded generator (xorshift).
pub(super) struct Random(pub(super) u64);

impl Random {
    pub(super) fn next(&mut self) -> u64 {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 7;
        self.0 ^= self.0 << 17;
        self.0
    }
    pub(super) fn below(&mut self, limit: usize) -> usize {
        (self.next() % limit.max(1) as u64) as usize
    }
    pub(super) fn from(&mut self, low: i64, high: i64) -> i64 {
        low + (self.next() % (high - low + 1) as u64) as i64
    }
    pub(super) fn pick<T: Copy>(&mut self, list: &[T]) -> T {
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
        Kind::Letters(letters, most) => {
            if !null {
                for _ in 0..1 + random.below(usize::from(*most)) {
                    field.push(char::from(random.pick(letters)));
                }
            }
            out.push(field);
        }
        Kind::Words(words) => {
            if !null {
                field = random.pick(words).into();
            }
            out.push(field);
        }
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
        // A sentence that alone carries nothing has a fault.
        Kind::Payload | Kind::Any => {
            if !null || matches!(kind, Kind::Payload) {
                for _ in 0..=random.below(20) {
                    field.push(random.pick(&['0', '9', ':', 'W', '`', 'w', 'k']));
                }
            }
            out.push(field);
        }
    }
}

/// A canonical line of a sentence.
pub(super) fn line(random: &mut Random, definition: &Definition) -> String {
    let mut all = Vec::new();
    for kind in definition.members {
        fields(random, kind, &mut all);
    }
    if let Some(group) = &definition.group {
        let count = match group.repeat {
            Repeat::UpTo(most) if group.members.len() == 1 => usize::from(most),
            Repeat::UpTo(most) => 1 + random.below(usize::from(most)),
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
    whole(definition, &mut all);
    written(definition, &all)
}

/// What stands in a member that is not null, the same each time.
pub(super) fn sample(kind: &Kind) -> String {
    match kind {
        Kind::Code(letters) | Kind::Letters(letters, _) => char::from(letters[0]).into(),
        Kind::Words(words) => words[0].into(),
        Kind::Text(_) => "A".into(),
        _ => "1".into(),
    }
}

/// Makes of random fields those of a whole sentence: a number that its message has, and entries that say something.
fn whole(definition: &Definition, all: &mut [String]) {
    if definition.numbered && all.len() > 1 {
        let count = |field: &str| usize::from_str_radix(field, 16).unwrap_or(0);
        if all[0].chars().all(|c| c == '0') {
            all[1].clear();
        } else if count(&all[1]) > count(&all[0]) {
            all.swap(0, 1);
        }
    }
    let Some(group) = &definition.group else {
        return;
    };
    let begin = definition.fixed_width() - definition.first();
    let key = key(definition.formatter);
    let mut nothing = true;
    for entry in all
        .get_mut(begin..)
        .unwrap_or_default()
        .chunks_mut(group.width())
    {
        let told = entry.iter().any(|field| !field.is_empty());
        let counted = matches!(group.repeat, Repeat::Counted(_));
        if let Some(key) = key.filter(|_| told || counted)
            && entry.get(key).is_some_and(String::is_empty)
        {
            entry[key] = sample(&group.members[key]);
        }
        nothing &= !told;
    }
    if nothing && !matches!(group.repeat, Repeat::Counted(_)) && all.len() > begin {
        let key = key.unwrap_or(0);
        all[begin + key] = sample(&group.members[key]);
    }
}

/// The line with these fields.
pub(super) fn written(definition: &Definition, all: &[String]) -> String {
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
    for field in all {
        body.push(',');
        body.push_str(field);
    }
    with_checksum(&body)
}

/// The bytes of a line: ISO 8859-1.
pub(super) fn bytes(line: &str) -> Vec<u8> {
    line.chars().map(|c| u32::from(c) as u8).collect()
}

pub(super) fn seed(name: &str) -> u64 {
    // Fixed, so that a failure comes again; printed, so that it can be changed.
    let seed = 0x5EED_0183_u64 ^ name.len() as u64;
    std::eprintln!("{name}: seed {seed:#x}");
    seed
}

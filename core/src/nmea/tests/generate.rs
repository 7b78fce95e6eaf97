//! Canonical lines of every table entry as strategies made from its row: what fails shrinks to null and to the least values.

use super::given::some;
use super::random::Random;
use crate::nmea::decimal::Decimal;
use crate::nmea::dictionary;
use crate::nmea::table::{Definition, Format, Kind, Repeat};
use crate::nmea::whole::key;
use crate::nmea::with_checksum;
use alloc::string::String;
use alloc::vec::Vec;
use proptest::collection::vec;
use proptest::prelude::{Just, Strategy, any};
use proptest::sample::select;
use proptest::strategy::{BoxedStrategy, Union};
use std::sync::OnceLock;

/// The wire fields of a member.
type Fields = BoxedStrategy<Vec<String>>;

fn digits(number: Decimal, unsigned: bool) -> String {
    let mut digits = Vec::new();
    number.write(&mut digits, unsigned);
    String::from_utf8(digits).unwrap()
}

fn letter(letter: u8) -> String {
    char::from(letter).into()
}

/// A number of the range with up to so many decimals.
fn number(format: Format, decimals: u8) -> impl Strategy<Value = Decimal> {
    let low = i64::from(format.low.max(-99_999));
    let high = i64::from(format.high.min(99_999));
    (low..=high, 0..=decimals, any::<u64>()).prop_map(move |(whole, scale, part)| {
        let scale = if whole == low || whole == high {
            0
        } else {
            scale
        };
        let one = 10u64.pow(scale.into());
        let mantissa = whole.unsigned_abs() * one + part % one;
        Decimal::new(whole < 0, mantissa, scale, format.whole)
    })
}

/// One of five is null.
fn or_null<const N: usize>(value: impl Strategy<Value = [String; N]> + 'static) -> Fields {
    let null = Just(core::array::from_fn(|_| String::new())).boxed();
    let either: Union<BoxedStrategy<[String; N]>> =
        Union::new_weighted(std::vec![(1, null), (4, value.boxed())]);
    either.prop_map(|fields| fields.to_vec()).boxed()
}

/// Up to so many pieces, one after the other.
fn pieces(pieces: Vec<String>, most: usize) -> impl Strategy<Value = [String; 1]> {
    vec(select(pieces), 1..=most).prop_map(|all| [all.concat()])
}

fn characters(characters: &[u8], most: usize) -> impl Strategy<Value = [String; 1]> {
    pieces(characters.iter().map(|&c| letter(c)).collect(), most)
}

/// A latitude or a longitude and its side.
fn half(degrees: u64, whole: u8, sides: [u8; 2]) -> impl Strategy<Value = [String; 2]> {
    let parts = (
        0..degrees,
        0..60u64,
        0..=5u8,
        any::<u64>(),
        select(sides.to_vec()),
    );
    parts.prop_map(move |(degrees, minutes, scale, part, side)| {
        let one = 10u64.pow(scale.into());
        let mantissa = (degrees * 100 + minutes) * one + part % one;
        let angle = Decimal::new(false, mantissa, scale, whole);
        [digits(angle, true), letter(side)]
    })
}

/// Canonical fields of a member, or its null form.
fn member(kind: &Kind) -> Fields {
    match kind {
        Kind::Number(format) => or_null(number(*format, 4).prop_map(|n| [digits(n, false)])),
        Kind::Lettered(format, unit) => {
            let unit = letter(*unit);
            or_null(number(*format, 4).prop_map(|n| [digits(n, false)]))
                .prop_map(move |fields| [fields, std::vec![unit.clone()]].concat())
                .boxed()
        }
        Kind::Integer(format) => or_null(number(*format, 0).prop_map(|n| [digits(n, false)])),
        Kind::Sided(format, sides) | Kind::Crossed(format, sides, _) => {
            let sides = select(std::vec![sides.positive, sides.negative]);
            let sided = (number(*format, 4), sides);
            let sided = or_null(sided.prop_map(|(n, side)| [digits(n, true), letter(side)]));
            match kind {
                Kind::Crossed(_, _, unit) => {
                    let unit = letter(*unit);
                    sided
                        .prop_map(move |fields| [fields, std::vec![unit.clone()]].concat())
                        .boxed()
                }
                _ => sided,
            }
        }
        Kind::Code(letters) => or_null(characters(letters, 1)),
        Kind::Letters(letters, most) => or_null(characters(letters, usize::from(*most))),
        Kind::Words(words) => {
            let words = words.iter().map(|&word| word.into()).collect();
            or_null(pieces(words, 1))
        }
        Kind::Text(limit) => {
            // Each piece is one character of the text.
            let each = ["A", "b", "7", " ", "-", "^2C", "\u{e9}", "^21", "/"];
            let each = each.map(String::from).to_vec();
            or_null(pieces(each, usize::from(*limit).min(12)))
        }
        Kind::Position(_) => {
            let halves = (half(90, 4, *b"NS"), half(180, 5, *b"EW"));
            or_null(halves.prop_map(|([a, b], [c, d])| [a, b, c, d]))
        }
        Kind::Angle { degrees: 2, .. } => or_null(half(90, 4, *b"NS")),
        Kind::Angle { .. } => or_null(half(180, 5, *b"EW")),
        Kind::Time => {
            let parts = (0..24u64, 0..60u64, 0..=60u64, 0..=3u8, any::<u64>());
            or_null(parts.prop_map(|(hour, minute, second, scale, part)| {
                let one = 10u64.pow(scale.into());
                let clock = hour * 10_000 + minute * 100 + second;
                let time = Decimal::new(false, clock * one + part % one, scale, 6);
                [digits(time, true)]
            }))
        }
        Kind::Date => {
            let parts = (1..=28, 1..=12, 0..=99);
            or_null(parts.prop_map(|(d, m, y)| [alloc::format!("{d:02}{m:02}{y:02}")]))
        }
        Kind::Hex(most) => or_null(characters(b"039AF", usize::from(*most))),
        Kind::Any => or_null(characters(b"09:W`wk", 20)),
        // A sentence that alone carries nothing has a fault.
        Kind::Payload => characters(b"09:W`wk", 20)
            .prop_map(|fields| fields.to_vec())
            .boxed(),
    }
}

/// Canonical lines of a sentence.
pub(super) fn lines(definition: &'static Definition) -> BoxedStrategy<String> {
    let list = |members: &[Kind]| -> Vec<Fields> { members.iter().map(member).collect() };
    let (group, count) = match &definition.group {
        None => (&[][..], 0..=0),
        Some(group) => {
            let count = match group.repeat {
                Repeat::UpTo(most) if group.members.len() == 1 => most..=most,
                Repeat::UpTo(most) => 1..=most,
                Repeat::Counted(_) => 0..=3,
                Repeat::Open => 1..=3,
            };
            (group.members, count)
        }
    };
    let entries: Vec<Vec<Fields>> = (0..*count.end()).map(|_| list(group)).collect();
    let lengths = match definition.lengths {
        [] => std::vec![0],
        lengths => lengths.to_vec(),
    };
    let parts = (
        list(definition.members),
        (count, entries),
        (any::<bool>(), list(definition.tail)),
        select(lengths),
    );
    parts
        .prop_map(|(members, (count, entries), (with_tail, tail), length)| {
            let mut all = members.concat();
            if let Some(group) = &definition.group {
                if let Repeat::Counted(at) = group.repeat {
                    all[usize::from(at)] = alloc::format!("{count}");
                }
                let entries = entries.into_iter().take(usize::from(count));
                all.extend(entries.flatten().flatten());
                if with_tail {
                    all.extend(tail.concat());
                }
            } else {
                all.truncate(usize::from(length) - definition.first());
            }
            whole(definition, &mut all);
            written(definition, &all)
        })
        .boxed()
}

/// One of some canonical lines of a sentence.
pub(super) fn line(random: &mut Random, definition: &Definition) -> &'static str {
    static LINES: OnceLock<Vec<Vec<String>>> = OnceLock::new();
    let lines = LINES.get_or_init(|| {
        let all = dictionary().iter();
        all.map(|definition| some(64, &lines(definition))).collect()
    });
    let place = |one: &&Definition| core::ptr::eq(*one, definition);
    let place = dictionary().iter().position(place).unwrap();
    &lines[place][random.below(64_usize)]
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

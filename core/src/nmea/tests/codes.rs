//! Every coded field of every sentence: its codes are taken, all else is a fault that names the field.

use super::generate::{bytes, sample, written};
use crate::nmea::table::{Definition, Kind, SentenceText};
use crate::nmea::tables::text;
use crate::nmea::*;
use alloc::collections::BTreeSet;
use alloc::format;
use alloc::string::{String, ToString};
use alloc::vec::Vec;

/// A line with every field filled, its group once.
fn filled(definition: &Definition) -> Vec<String> {
    let mut all = Vec::new();
    let entries = match &definition.group {
        // Twelve satellites, or none.
        Some(group) if group.members.len() == 1 && !definition.tail.is_empty() => 12,
        _ => 1,
    };
    let group = definition.group.iter().flat_map(|group| group.members);
    let group: Vec<&Kind> = group.collect();
    let kinds = definition
        .members
        .iter()
        .chain(group.iter().copied().cycle().take(group.len() * entries));
    for kind in kinds.chain(definition.tail) {
        match kind {
            Kind::Lettered(format, letter) => {
                all.extend([number(format), char::from(*letter).into()]);
            }
            Kind::Sided(format, sides) => {
                all.extend([number(format), char::from(sides.positive).into()]);
            }
            Kind::Crossed(format, sides, letter) => all.extend([
                number(format),
                char::from(sides.positive).into(),
                char::from(*letter).into(),
            ]),
            Kind::Number(format) | Kind::Integer(format) => all.push(number(format)),
            Kind::Position(_) => all.extend(["5345.345", "N", "01234.500", "E"].map(String::from)),
            Kind::Angle { degrees: 2, .. } => all.extend(["5345.345", "N"].map(String::from)),
            Kind::Angle { .. } => all.extend(["01234.500", "E"].map(String::from)),
            Kind::Time => all.push("123456".into()),
            Kind::Date => all.push("230326".into()),
            kind => all.push(sample(kind)),
        }
    }
    all
}

fn number(format: &Format) -> String {
    format!("{}", 1.clamp(format.low, format.high))
}

/// What a coded field takes; all else is a fault.
enum Codes {
    Letters(Vec<u8>),
    /// Several letters in one field.
    Several(Vec<u8>),
    Words(Vec<&'static str>),
}

/// The coded fields of a member, each with its offset.
fn codes(kind: &Kind) -> Vec<(usize, Codes)> {
    let letters = |letters: &[u8]| Codes::Letters(letters.to_vec());
    let sides = |sides: &Sides| letters(&[sides.negative, sides.positive]);
    match kind {
        Kind::Code(list) => [(0, letters(list))].into(),
        Kind::Letters(list, _) => [(0, Codes::Several(list.to_vec()))].into(),
        Kind::Words(list) => [(0, Codes::Words(list.to_vec()))].into(),
        Kind::Lettered(_, letter) => [(1, letters(&[*letter]))].into(),
        Kind::Sided(_, list) => [(1, sides(list))].into(),
        Kind::Crossed(_, list, letter) => [(1, sides(list)), (2, letters(&[*letter]))].into(),
        Kind::Position(_) => [(1, letters(b"NS")), (3, letters(b"EW"))].into(),
        Kind::Angle { degrees: 2, .. } => [(1, letters(b"NS"))].into(),
        Kind::Angle { .. } => [(1, letters(b"EW"))].into(),
        _ => Vec::new(),
    }
}

/// Each offset of a coded field with what it takes and what it does not.
fn cases(codes: &Codes) -> (Vec<String>, Vec<String>) {
    let one = |byte: u8| String::from(char::from(byte));
    let printed = || (0x21..0x7f_u8).filter(|byte| !b",*$!\\^".contains(byte));
    let others = |list: &[u8]| {
        let others = printed().filter(|byte| !list.contains(byte));
        others.map(one).collect::<Vec<_>>()
    };
    match codes {
        Codes::Letters(list) => {
            let mut wrong = others(list);
            wrong.extend(list.iter().map(|letter| one(*letter) + &one(*letter)));
            wrong.extend(
                list.iter()
                    .map(|letter| format!(" {}", char::from(*letter))),
            );
            (list.iter().copied().map(one).collect(), wrong)
        }
        Codes::Several(list) => {
            let mut wrong = others(list);
            let mixed: Vec<_> = wrong.iter().map(|other| one(list[0]) + other).collect();
            wrong.extend(mixed);
            let mut right: Vec<_> = list.iter().copied().map(one).collect();
            right.push(one(list[0]) + &one(list[1]));
            (right, wrong)
        }
        Codes::Words(list) => {
            let alphabet = || {
                (b'0'..=b'9')
                    .chain(b'A'..=b'Z')
                    .chain(b"a?-".iter().copied())
            };
            let all = alphabet().flat_map(|a| alphabet().map(move |b| one(a) + &one(b)));
            let mut wrong: Vec<_> = all.collect();
            wrong.extend(printed().map(one));
            wrong.extend(list.iter().map(|word| format!("{word}A")));
            wrong.extend(list.iter().map(|word| word.to_lowercase()));
            wrong.retain(|word| !list.contains(&word.as_str()));
            (list.iter().map(ToString::to_string).collect(), wrong)
        }
    }
}

/// Faults that name a field, of a line with these fields.
fn named(definition: &Definition, fields: &[String]) -> Vec<(usize, FaultKind)> {
    let raw = bytes(&written(definition, fields));
    let faults = decode(&raw).field_faults();
    faults
        .iter()
        .filter_map(|fault| Some((usize::from(fault.field?), fault.kind)))
        .collect()
}

#[test]
fn every_code_is_taken_and_every_other_letter_is_named() {
    let (mut taken, mut refused) = (0, 0);
    for definition in dictionary() {
        let fields = filled(definition);
        assert_eq!(
            named(definition, &fields),
            [],
            "{} {fields:?}",
            definition.formatter
        );
        let raw = bytes(&written(definition, &fields));
        let sentence = decode(&raw);
        let mut places = Vec::new();
        sentence.walk(|item| places.push((item.field, item.kind)), &mut Vec::new());
        for (field, kind) in places {
            for (offset, codes) in codes(kind) {
                let (right, wrong) = cases(&codes);
                let at = field + offset;
                let mut changed = fields.clone();
                let index = at - 1 - definition.first();
                for code in right {
                    changed[index] = code;
                    let found = named(definition, &changed);
                    assert!(
                        !found.iter().any(|(n, _)| *n == at),
                        "{changed:?} {found:?}"
                    );
                    taken += 1;
                }
                for code in wrong {
                    changed[index] = code;
                    let found = named(definition, &changed);
                    assert!(
                        found.iter().any(|(n, _)| *n == at),
                        "field {at} of {} {changed:?}",
                        definition.formatter
                    );
                    refused += 1;
                }
            }
        }
    }
    assert!(
        taken > 1_100 && refused > 50_000,
        "{taken} taken, {refused} refused"
    );
}

/// Members of text, of single digits and of free data that are no codes by the standard, by their names; those of one sentence
/// only with its formatter.
const FREE: &[(&str, &[&str])] = &[
    (
        "a count, or a number among others",
        &[
            "total",
            "number",
            "sequence",
            "count",
            "revision",
            "escalation",
            "instance",
            "sender_instance",
            "satellites",
            "fill_bits",
            "section_1",
            "section_2",
            "section_3",
            "channel",
            "CUR.set",
            "TLL.target",
            "NLS.hours",
        ],
    ),
    (
        "a day, an hour or a duration in digits",
        &[
            "day",
            "month",
            "hour",
            "minute",
            "arrival_day",
            "arrival_month",
            "arrival_date",
            "reset_day",
            "reset_month",
            "date",
            "off_date",
            "on_date",
            "remaining",
            "elapsed",
        ],
    ),
    (
        "a step of a scale",
        &[
            "DDC.brightness",
            "FSI.power",
            "SPW.level",
            "VSD.flags",
            "system",
            "gyro",
            "accelerometer",
            "magnetometer",
        ],
    ),
    (
        "a name or words that people give",
        &[
            "name",
            "call_sign",
            "waypoint",
            "origin",
            "destination",
            "to",
            "from",
            "route",
            "label",
            "text",
            "description",
            "sub_mode",
            "version",
            "vendor",
            "model",
            "serial",
            "software",
            "hardware",
            "identifier",
            "identifier_1",
            "identifier_2",
            "identifier_3",
            "code_1",
            "code_2",
            "password",
            "value",
            "point",
            "sensor_1",
            "sensor_2",
            "manufacturer",
            "division_1",
            "division_2",
            "EVE.tag",
            "NRX.code",
        ],
    ),
    (
        "a talker or a formatter, of any edition and any maker",
        &[
            "source",
            "device",
            "equipment",
            "sender_system",
            "NAK.talker",
            "NAK.formatter",
            "Q.formatter",
            "SPW.protected",
        ],
    ),
    (
        "a station, a frequency or data in digits",
        &[
            "station",
            "address",
            "mmsi",
            "distress",
            "position",
            "time",
            "transmit",
            "receive",
            "frequency",
            "data",
            "beacon",
            "body",
        ],
    ),
    (
        "a number of another recommendation, all values of which are given away",
        &[
            "VSD.status",
            "LR3.cargo",
            "LR3.ship_type",
            "SM1.area",
            "SM2.area",
        ],
    ),
    (
        "a list that other standards keep open: subsystems, datums, languages, reasons from 50 on, services, systems and signals",
        &[
            "subsystem",
            "sender_subsystem",
            "DTM.datum",
            "DTM.subdivision",
            "TUT.coding",
            "NAK.reason",
            "service",
            "presentation",
            "signal",
            "signal_id",
        ],
    ),
    ("any letter of an area", &["SM2.coast"]),
    (
        "no meaning is printed",
        &["later_1", "later_2", "later_3", "PEMC,14.sensor"],
    ),
];

#[test]
fn what_has_no_list_of_codes_is_free_by_the_standard() {
    let free: BTreeSet<&str> = FREE
        .iter()
        .flat_map(|(_, names)| names.iter().copied())
        .collect();
    let (mut unlisted, mut met) = (BTreeSet::new(), BTreeSet::new());
    for definition in dictionary() {
        let texts: &SentenceText = text(definition).unwrap();
        let group = definition.group.iter().flat_map(|group| group.members);
        let kinds = definition
            .members
            .iter()
            .chain(group)
            .chain(definition.tail);
        let names = texts.members.iter().chain(texts.group).chain(texts.tail);
        for (kind, words) in kinds.zip(names) {
            let coded = match kind {
                Kind::Text(_) | Kind::Any | Kind::Hex(1) => true,
                Kind::Integer(format) => format.high <= 99 && format.unit == Unit::None,
                _ => false,
            };
            let whole = format!("{}.{}", definition.formatter, words.name);
            if !coded {
                continue;
            }
            match (free.get(words.name), free.get(whole.as_str())) {
                (Some(name), _) | (_, Some(name)) => drop(met.insert(*name)),
                _ => drop(unlisted.insert(whole)),
            }
        }
    }
    assert_eq!(
        unlisted,
        BTreeSet::new(),
        "neither a list of codes nor a reason to have none"
    );
    let unmet: Vec<_> = free.difference(&met).collect();
    assert!(
        unmet.is_empty(),
        "{unmet:?} are not there or have their codes"
    );
}

//! Whether a sentence is whole: its number of fields, its place among several, and that it carries what it is for.

use super::decimal::Decimal;
use super::fault::{Fault, FaultKind};
use super::group::group_count;
use super::read::read;
use super::scan::FieldList;
use super::table::{Definition, Group, Kind, Repeat};
use super::value::Value;
use alloc::vec::Vec;

/// The member of an entry (from 0) without which the others say nothing.
const KEYS: &[(&str, usize)] = &[
    ("ALC", 1),
    ("AGL", 2),
    ("DSE", 0),
    ("NLS", 0),
    ("SEL", 0),
    ("TLB", 0),
    ("XDR", 0),
];

pub(super) fn faults(definition: &Definition, fields: &FieldList<'_>, faults: &mut Vec<Fault>) {
    count_fault(definition, fields, faults);
    let before = faults.len();
    number_fault(definition, fields, faults);
    payload_fault(definition, fields, faults);
    if let Some(group) = &definition.group {
        group_faults(definition, group, fields, faults);
    }
    // Where the line ends before it, the last field bears the fault.
    let last = fields.len() as u8;
    for fault in faults.iter_mut().skip(before) {
        fault.field = fault.field.map(|n| n.min(last)).filter(|n| *n > 0);
    }
}

/// The key of the entries of a sentence.
pub(super) fn key(formatter: &str) -> Option<usize> {
    let key = KEYS.iter().find(|(name, _)| *name == formatter);
    key.map(|(_, key)| *key)
}

/// Whether it is the only sentence of its message.
fn alone(definition: &Definition, fields: &FieldList<'_>) -> bool {
    !definition.numbered || matches!(fields.at(0), b"" | b"1" | b"01" | b"001")
}

fn missing(at: usize) -> Fault {
    Fault::at(at, FaultKind::MissingPart)
}

/// A third sentence of two.
fn number_fault(definition: &Definition, fields: &FieldList<'_>, faults: &mut Vec<Fault>) {
    let value = |at: usize| {
        let kind = definition.members.get(at)?;
        match read(kind, &mut fields.cursor_at(at), &mut Vec::new())? {
            Value::Number(number) => Some(number.value() as i32),
            _ => None,
        }
    };
    if definition.numbered
        && let (Some(high), Some(number)) = (value(0), value(1))
        && number > high
    {
        faults.push(Fault::at(1, FaultKind::OutOfRange { low: 1, high }));
    }
}

/// No data in a sentence that alone carries data; of several the last may be empty.
fn payload_fault(definition: &Definition, fields: &FieldList<'_>, faults: &mut Vec<Fault>) {
    let payload = definition
        .members
        .iter()
        .position(|kind| matches!(kind, Kind::Payload));
    if let Some(at) = payload
        && alone(definition, fields)
        && fields.len() > at
        && fields.at(at).is_empty()
    {
        faults.push(missing(at));
    }
}

fn group_faults(
    definition: &Definition,
    group: &Group,
    fields: &FieldList<'_>,
    faults: &mut Vec<Fault>,
) {
    let first = definition.fixed_width();
    let nothing = fields.iter().skip(first).all(<[u8]>::is_empty);
    match group.repeat {
        // A list without an entry, such as a route without a waypoint.
        Repeat::Open if nothing && alone(definition, fields) => {
            faults.push(missing(first));
            return;
        }
        // Entries, and nobody says how many.
        Repeat::Counted(at) if !nothing && fields.at(usize::from(at)).is_empty() => {
            faults.push(missing(usize::from(at)));
            return;
        }
        // Satellites in view, and none of them is told.
        Repeat::UpTo(_)
            if definition.formatter == "GSV"
                && nothing
                && alone(definition, fields)
                && fields
                    .at(2)
                    .iter()
                    .any(|digit| matches!(digit, b'1'..=b'9')) =>
        {
            faults.push(missing(first));
            return;
        }
        _ => {}
    }
    let Some(key) = key(definition.formatter) else {
        return;
    };
    let counted = matches!(group.repeat, Repeat::Counted(_));
    let mut rest = fields.iter().skip(first);
    for entry in 0..group_count(definition, fields) {
        let (mut told, mut named) = (counted, false);
        for (at, field) in rest.by_ref().take(group.width()).enumerate() {
            told |= !field.is_empty();
            named |= at == key && !field.is_empty();
        }
        if told && !named {
            faults.push(missing(first + entry * group.width() + key));
        }
    }
}

/// Whether the number of fields is one of the editions'; one empty field too many is none (SEN-5).
fn count_fault(definition: &Definition, fields: &FieldList<'_>, faults: &mut Vec<Fault>) {
    let found = fields.len();
    let (accepted, expected) = match &definition.group {
        None => (
            definition.lengths.iter().any(|&length| {
                let length = usize::from(length);
                length == found || (length + 1 == found && fields.at(length).is_empty())
            }),
            definition
                .lengths
                .iter()
                .copied()
                .max()
                .map_or(definition.sent(), usize::from),
        ),
        Some(group) => {
            let tail = definition.tail_width();
            let fixed = definition.fixed_width();
            let entries = group_count(definition, fields);
            let mut expected = fixed + entries * group.width();
            let whole = match group.repeat {
                Repeat::Counted(at) => {
                    Decimal::parse(fields.at(usize::from(at))).is_none_or(|count| {
                        let said = count.value() as usize;
                        if said != entries {
                            expected = fixed + said.min(99) * group.width();
                        }
                        said == entries
                    })
                }
                Repeat::Open => found.saturating_sub(fixed).is_multiple_of(group.width()),
                Repeat::UpTo(_) => true,
            };
            (
                whole && (found == expected || found == expected + tail),
                expected + tail,
            )
        }
    };
    if accepted {
        return;
    }
    if found == expected + 1 && fields.at(found - 1).is_empty() {
        return;
    }
    let said = found as u8;
    if found > expected {
        let kind = FaultKind::ExtraField {
            found: said,
            expected: expected as u8,
        };
        faults.push(Fault::at(expected, kind));
    } else {
        let expected = definition
            .lengths
            .first()
            .map_or(expected as u8, |&length| length);
        let kind = FaultKind::FieldCount {
            found: said,
            expected,
        };
        // Where a list ends inside an entry, the last field bears the fault.
        faults.push(match (&definition.group, found) {
            (None, _) | (_, 0) => Fault::line(kind),
            (Some(_), _) => Fault::at(found - 1, kind),
        });
    }
}

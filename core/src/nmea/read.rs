//! Reads one member from its raw fields: the value, and the faults found on the way (SEN-4, SEN-6).

use super::decimal::{Decimal, POW10};
use super::fault::{Fault, FaultKind};
use super::scan::FieldList;
use super::table::{Format, Kind, Sides};
use super::value::{Value, hex_byte, hex_digit};
use alloc::vec::Vec;

/// The value of the member whose first field has index `at` (from 0).
pub(crate) fn read<'a>(
    kind: &Kind,
    fields: &FieldList<'a>,
    at: usize,
    faults: &mut Vec<Fault>,
) -> Value<'a> {
    match kind {
        Kind::Number(format) => number(fields, *format, at, faults),
        Kind::Lettered(format, letter) => {
            let value = number(fields, *format, at, faults);
            lettered(value, fields.at(at + 1), *letter, at + 1, faults)
        }
        Kind::Sided(format, sides) => sided(fields, *format, *sides, at, faults),
        Kind::Crossed(format, sides, letter) => {
            let value = sided(fields, *format, *sides, at, faults);
            lettered(value, fields.at(at + 2), *letter, at + 2, faults)
        }
        Kind::Code(letters) => match fields.at(at) {
            [] => Value::Null,
            [letter] if letters.contains(letter) => Value::Code(*letter),
            _ => fault(faults, at, FaultKind::UnknownCode),
        },
        Kind::Integer(format) => integer(fields, *format, at, faults),
        Kind::Position(_) => position(fields, at, faults),
        Kind::Time => time(fields, at, faults),
        Kind::Date => date(fields.at(at), at, faults),
        Kind::Text(limit) => text(fields.at(at), *limit, at, faults),
        Kind::Angle { degrees, .. } => single_angle(fields, *degrees, at, faults),
        Kind::Hex(_) => hex(fields.at(at), at, faults),
        Kind::Payload => payload(fields.at(at), at, faults),
        Kind::Any => match fields.at(at) {
            [] => Value::Null,
            field => Value::Text(field),
        },
    }
}

#[cold]
#[inline(never)]
fn fault<'a>(faults: &mut Vec<Fault>, at: usize, kind: FaultKind) -> Value<'a> {
    faults.push(Fault::at(at, kind));
    Value::Invalid
}

#[inline(always)]
fn number<'a>(
    fields: &FieldList<'a>,
    format: Format,
    at: usize,
    faults: &mut Vec<Fault>,
) -> Value<'a> {
    if fields.at(at).is_empty() {
        return Value::Null;
    }
    match fields.number(at) {
        Some(number) if number.within(format.low, format.high) => Value::Number(number),
        Some(_) => out_of_range(faults, at, format),
        None => fault(faults, at, FaultKind::NotANumber),
    }
}

#[cold]
fn out_of_range<'a>(faults: &mut Vec<Fault>, at: usize, format: Format) -> Value<'a> {
    fault(
        faults,
        at,
        FaultKind::OutOfRange {
            low: format.low,
            high: format.high,
        },
    )
}

fn integer<'a>(
    fields: &FieldList<'a>,
    format: Format,
    at: usize,
    faults: &mut Vec<Fault>,
) -> Value<'a> {
    match number(fields, format, at, faults) {
        Value::Number(number) if number.scale() != 0 => fault(faults, at, FaultKind::NotAnInteger),
        value => value,
    }
}

/// A value and the letter of its unit or reference: with another letter it is not known what the value is.
#[inline(always)]
fn lettered<'a>(
    value: Value<'a>,
    field: &[u8],
    letter: u8,
    at: usize,
    faults: &mut Vec<Fault>,
) -> Value<'a> {
    if field.is_empty() || field == [letter] {
        return value;
    }
    let invalid = fault(faults, at, FaultKind::WrongLetter(letter));
    if value.is_null() { value } else { invalid }
}

#[inline(always)]
fn side(field: &[u8], sides: Sides, at: usize, faults: &mut Vec<Fault>) -> Option<bool> {
    match field {
        [letter] if *letter == sides.positive => Some(false),
        [letter] if *letter == sides.negative => Some(true),
        [] => {
            fault(faults, at, FaultKind::MissingPart);
            None
        }
        _ => {
            fault(faults, at, FaultKind::UnknownCode);
            None
        }
    }
}

fn sided<'a>(
    fields: &FieldList<'a>,
    format: Format,
    sides: Sides,
    at: usize,
    faults: &mut Vec<Fault>,
) -> Value<'a> {
    let letter = fields.at(at + 1);
    match number(fields, format, at, faults) {
        Value::Number(number) => match side(letter, sides, at + 1, faults) {
            Some(_) if number.signed() => out_of_range(faults, at, format),
            Some(negative) => Value::Number(number.with_negative(negative)),
            None => Value::Invalid,
        },
        value => {
            if !letter.is_empty() {
                side(letter, sides, at + 1, faults);
            }
            value
        }
    }
}

/// Degrees and minutes, unsigned, with the digits of the format.
#[inline(always)]
fn angle(
    fields: &FieldList<'_>,
    degrees: u8,
    at: usize,
    faults: &mut Vec<Fault>,
) -> Option<Decimal> {
    let field = fields.at(at);
    let Some(angle) = fields.number(at) else {
        fault(faults, at, FaultKind::NotANumber);
        return None;
    };
    let limit = if degrees == 2 { 9_000 } else { 18_000 };
    if angle.signed() || angle.scale() > 14 {
        fault(faults, at, FaultKind::NotANumber);
        return None;
    }
    if angle.whole() != degrees + 2 {
        let kind = FaultKind::BadWidth {
            found: angle.whole(),
            expected: degrees + 2,
        };
        fault(faults, at, kind);
        return None;
    }
    let minute = POW10[usize::from(angle.scale())];
    // The tens of the minutes stand behind the degrees.
    if field
        .get(usize::from(degrees))
        .is_some_and(|&tens| tens >= b'6')
    {
        let minutes = angle.mantissa() % (100 * minute);
        minutes_too_large(faults, at, Decimal::new(false, minutes, angle.scale(), 2));
        return None;
    }
    if angle.mantissa() > limit * minute {
        fault(
            faults,
            at,
            FaultKind::OutOfRange {
                low: 0,
                high: limit as i32,
            },
        );
        return None;
    }
    Some(angle)
}

#[cold]
fn minutes_too_large(faults: &mut Vec<Fault>, at: usize, minutes: Decimal) {
    fault(faults, at, FaultKind::MinutesTooLarge(minutes));
}

const NS: Sides = Sides {
    negative: b'S',
    positive: b'N',
};
const EW: Sides = Sides {
    negative: b'W',
    positive: b'E',
};

fn half(
    fields: &FieldList<'_>,
    degrees: u8,
    at: usize,
    faults: &mut Vec<Fault>,
) -> Option<Decimal> {
    let value = if fields.at(at).is_empty() {
        fault(faults, at, FaultKind::MissingPart);
        None
    } else {
        angle(fields, degrees, at, faults)
    };
    let sides = if degrees == 2 { NS } else { EW };
    let negative = side(fields.at(at + 1), sides, at + 1, faults);
    Some(value?.with_negative(negative?))
}

fn position<'a>(fields: &FieldList<'a>, at: usize, faults: &mut Vec<Fault>) -> Value<'a> {
    if (0..4).all(|i| fields.at(at + i).is_empty()) {
        return Value::Null;
    }
    match (half(fields, 2, at, faults), half(fields, 3, at + 2, faults)) {
        (Some(lat), Some(lon)) => Value::Position(lat, lon),
        _ => Value::Invalid,
    }
}

fn single_angle<'a>(
    fields: &FieldList<'a>,
    degrees: u8,
    at: usize,
    faults: &mut Vec<Fault>,
) -> Value<'a> {
    if fields.at(at).is_empty() && fields.at(at + 1).is_empty() {
        return Value::Null;
    }
    half(fields, degrees, at, faults).map_or(Value::Invalid, Value::Angle)
}

fn time<'a>(fields: &FieldList<'a>, at: usize, faults: &mut Vec<Fault>) -> Value<'a> {
    let field = fields.at(at);
    if field.is_empty() {
        return Value::Null;
    }
    if let Some(time) = fields.number(at)
        && time.whole() == 6
        && !time.signed()
    {
        // Digits all, as the number was read.
        let two = |i: usize| (field[i] - b'0') * 10 + (field[i + 1] - b'0');
        if two(0) < 24 && two(2) < 60 && two(4) < 61 {
            return Value::Time(time);
        }
    }
    fault(faults, at, FaultKind::BadTime)
}

fn date<'a>(field: &[u8], at: usize, faults: &mut Vec<Fault>) -> Value<'a> {
    if field.is_empty() {
        return Value::Null;
    }
    if let Some(date) = Decimal::parse(field)
        && field.len() == 6
        && date.whole() == 6
    {
        let digits = date.mantissa();
        let day = digits / 10_000;
        let longest = match digits / 100 % 100 {
            2 if digits % 4 == 0 => 29,
            2 => 28,
            4 | 6 | 9 | 11 => 30,
            1..=12 => 31,
            _ => 0,
        };
        if (1..=longest).contains(&day) {
            return Value::Date(date);
        }
    }
    fault(faults, at, FaultKind::BadDate)
}

fn text<'a>(field: &'a [u8], limit: u8, at: usize, faults: &mut Vec<Fault>) -> Value<'a> {
    if field.is_empty() {
        return Value::Null;
    }
    let mut i = 0;
    let mut length = 0usize;
    while let Some(&byte) = field.get(i) {
        length += 1;
        match byte {
            b'^' if field.get(i + 1..i + 3).and_then(hex_byte).is_some() => i += 3,
            // The reserved characters of the standard; 8-bit characters are ISO 8859-1.
            b'^' | b'*' | b'\\' | b'!' | b'$' | b'~' | 0..=0x1f | 0x7f => {
                return fault(faults, at, FaultKind::BadCharacter(byte));
            }
            _ => i += 1,
        }
    }
    if length > usize::from(limit) {
        return fault(faults, at, FaultKind::TooMuchText(limit));
    }
    Value::Text(field)
}

fn hex<'a>(field: &[u8], at: usize, faults: &mut Vec<Fault>) -> Value<'a> {
    if field.is_empty() {
        return Value::Null;
    }
    let mut number = 0u64;
    for &byte in field {
        match hex_digit(byte) {
            Some(digit) if field.len() <= 8 => number = number << 4 | u64::from(digit),
            _ => return fault(faults, at, FaultKind::BadHex),
        }
    }
    Value::Number(Decimal::new(false, number, 0, field.len() as u8))
}

fn payload<'a>(field: &'a [u8], at: usize, faults: &mut Vec<Fault>) -> Value<'a> {
    if field.is_empty() {
        return Value::Null;
    }
    if field
        .iter()
        .all(|byte| matches!(byte, 0x30..=0x57 | 0x60..=0x77))
    {
        Value::Text(field)
    } else {
        fault(faults, at, FaultKind::BadPayload)
    }
}

//! Reads one member from its raw fields: the value, and the faults found on the way (SEN-4, SEN-6).

use super::angles::{date, position, single_angle, time};
use super::decimal::Decimal;
use super::fault::{Fault, FaultKind};
use super::scan::{Cursor, Field};
use super::table::{Format, Kind, Sides};
use super::value::{Value, hex_byte, hex_digit};
use alloc::vec::Vec;

/// The value of the member that begins with the next field; none behind the last.
#[inline(never)]
pub(crate) fn read<'a>(
    kind: &Kind,
    fields: &mut Cursor<'a>,
    faults: &mut Vec<Fault>,
) -> Option<Value<'a>> {
    read_here(kind, fields, faults)
}

/// As [`read`], in the caller: the value need not pass through memory.
#[inline(always)]
pub(crate) fn read_here<'a>(
    kind: &Kind,
    fields: &mut Cursor<'a>,
    faults: &mut Vec<Fault>,
) -> Option<Value<'a>> {
    let field = fields.next()?;
    let n = fields.taken();
    Some(match kind {
        Kind::Number(format) => number(field, format, n, faults),
        Kind::Lettered(format, letter) => {
            let value = number(field, format, n, faults);
            lettered(value, fields.part(), *letter, n + 1, faults)
        }
        Kind::Sided(format, sides) => sided(field, fields.part(), format, *sides, n, faults),
        Kind::Crossed(format, sides, letter) => {
            let value = sided(field, fields.part(), format, *sides, n, faults);
            lettered(value, fields.part(), *letter, n + 2, faults)
        }
        Kind::Integer(format) => match number(field, format, n, faults) {
            Value::Number(number) if number.scale() != 0 => {
                fault(faults, n, FaultKind::NotAnInteger)
            }
            value => value,
        },
        Kind::Code(letters) => match field.letter() {
            Some(letter) if letters.contains(&letter) => Value::Code(letter),
            None if field.is_empty() => Value::Null,
            _ => fault(faults, n, FaultKind::UnknownCode),
        },
        Kind::Position(_) => {
            let rest = [fields.part(), fields.part(), fields.part()];
            position(field, rest, n, faults)
        }
        Kind::Time => match time(field.head, field.length) {
            Some(time) => Value::Time(time),
            None => null_or_fault(field, n, faults, FaultKind::BadTime),
        },
        Kind::Date => match date(field.head, field.length) {
            Some(date) => Value::Date(date),
            None => null_or_fault(field, n, faults, FaultKind::BadDate),
        },
        Kind::Text(limit) => text(field.text(), *limit, n, faults),
        Kind::Angle { degrees, .. } => single_angle(field, fields.part(), *degrees, n, faults),
        Kind::Hex(_) => hex(field.text(), n, faults),
        Kind::Payload => payload(field.text(), n, faults),
        Kind::Any => match field.text() {
            [] => Value::Null,
            text => Value::Text(text),
        },
    })
}

#[cold]
#[inline(never)]
pub(super) fn fault<'a>(faults: &mut Vec<Fault>, n: usize, kind: FaultKind) -> Value<'a> {
    faults.push(Fault::at(n - 1, kind));
    Value::Invalid
}

#[inline(always)]
fn number<'a>(field: Field<'a>, format: &Format, n: usize, faults: &mut Vec<Fault>) -> Value<'a> {
    if field.length.wrapping_sub(1) < 8
        && let Some(number) = Decimal::short(field.head, field.length)
        && number.within(format.low, format.high)
    {
        return Value::Number(number);
    }
    if field.is_empty() {
        return Value::Null;
    }
    long_number(field.head, field.length, format, n, faults)
}

/// Numbers of more than eight characters or of a strange form.
#[inline(never)]
fn long_number<'a>(
    head: &[u8],
    length: usize,
    format: &Format,
    n: usize,
    faults: &mut Vec<Fault>,
) -> Value<'a> {
    match Decimal::parse_apart(head, length) {
        Some(number) if number.within(format.low, format.high) => Value::Number(number),
        Some(_) => out_of_range(faults, n, format),
        None => fault(faults, n, FaultKind::NotANumber),
    }
}

#[cold]
#[inline(never)]
fn out_of_range<'a>(faults: &mut Vec<Fault>, n: usize, format: &Format) -> Value<'a> {
    let (low, high) = (format.low, format.high);
    fault(faults, n, FaultKind::OutOfRange { low, high })
}

/// An empty field is null; another one has a fault.
#[inline(always)]
fn null_or_fault<'a>(
    field: Field<'_>,
    n: usize,
    faults: &mut Vec<Fault>,
    kind: FaultKind,
) -> Value<'a> {
    if field.is_empty() {
        Value::Null
    } else {
        fault(faults, n, kind)
    }
}

/// A value and the letter of its unit or reference: with another letter it is not known what the value is.
#[inline(always)]
fn lettered<'a>(
    value: Value<'a>,
    field: Field<'_>,
    letter: u8,
    n: usize,
    faults: &mut Vec<Fault>,
) -> Value<'a> {
    if field.letter() == Some(letter) || field.is_empty() {
        return value;
    }
    let invalid = fault(faults, n, FaultKind::WrongLetter(letter));
    if value.is_null() { value } else { invalid }
}

/// Whether the side is the negative one; none where it is missing or unknown.
#[inline(always)]
pub(super) fn side(
    field: Field<'_>,
    sides: Sides,
    n: usize,
    faults: &mut Vec<Fault>,
) -> Option<bool> {
    if let Some(letter) = field.letter() {
        // Without a branch, as it cannot be foreseen which side it is.
        let other = letter ^ sides.positive;
        let negative = other != 0;
        if other == (sides.positive ^ sides.negative) & 0u8.wrapping_sub(u8::from(negative)) {
            return Some(negative);
        }
    }
    wrong_side(field, n, faults);
    None
}

#[cold]
#[inline(never)]
fn wrong_side(field: Field<'_>, n: usize, faults: &mut Vec<Fault>) {
    let kind = if field.is_empty() {
        FaultKind::MissingPart
    } else {
        FaultKind::UnknownCode
    };
    fault(faults, n, kind);
}

#[inline(always)]
fn sided<'a>(
    field: Field<'a>,
    letter: Field<'a>,
    format: &Format,
    sides: Sides,
    n: usize,
    faults: &mut Vec<Fault>,
) -> Value<'a> {
    match number(field, format, n, faults) {
        Value::Number(number) => match side(letter, sides, n + 1, faults) {
            Some(_) if number.signed() => out_of_range(faults, n, format),
            Some(negative) => Value::Number(number.with_negative(negative)),
            None => Value::Invalid,
        },
        value => {
            if !letter.is_empty() {
                side(letter, sides, n + 1, faults);
            }
            value
        }
    }
}

fn text<'a>(field: &'a [u8], limit: u8, n: usize, faults: &mut Vec<Fault>) -> Value<'a> {
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
                return fault(faults, n, FaultKind::BadCharacter(byte));
            }
            _ => i += 1,
        }
    }
    if length > usize::from(limit) {
        return fault(faults, n, FaultKind::TooMuchText(limit));
    }
    Value::Text(field)
}

fn hex<'a>(field: &[u8], n: usize, faults: &mut Vec<Fault>) -> Value<'a> {
    if field.is_empty() {
        return Value::Null;
    }
    let mut number = 0u64;
    for &byte in field {
        match hex_digit(byte) {
            Some(digit) if field.len() <= 8 => number = number << 4 | u64::from(digit),
            _ => return fault(faults, n, FaultKind::BadHex),
        }
    }
    Value::Number(Decimal::new(false, number, 0, field.len() as u8))
}

fn payload<'a>(field: &'a [u8], n: usize, faults: &mut Vec<Fault>) -> Value<'a> {
    if field.is_empty() {
        return Value::Null;
    }
    if field
        .iter()
        .all(|byte| matches!(byte, 0x30..=0x57 | 0x60..=0x77))
    {
        Value::Text(field)
    } else {
        fault(faults, n, FaultKind::BadPayload)
    }
}

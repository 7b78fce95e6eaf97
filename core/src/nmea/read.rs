//! Reads one member from its raw fields: the value, and the faults found on the way (SEN-4, SEN-6).

use super::decimal::{Decimal, POW10};
use super::fault::{Fault, FaultKind};
use super::scan::{Field, Places, last};
use super::table::{Format, Kind, Sides};
use super::value::{Value, hex_byte, hex_digit};
use alloc::vec::Vec;

/// The value of the member whose first field has index `at` (from 0).
#[inline(never)]
pub(crate) fn read<'a>(
    kind: &Kind,
    places: &Places<'a>,
    at: usize,
    faults: &mut Vec<Fault>,
) -> Value<'a> {
    read_here(kind, places, at, faults)
}

/// As [`read`], in the caller: the value need not pass through memory.
#[inline(always)]
pub(crate) fn read_here<'a>(
    kind: &Kind,
    places: &Places<'a>,
    at: usize,
    faults: &mut Vec<Fault>,
) -> Value<'a> {
    let n = at + 1;
    let field = places.field(at);
    match kind {
        Kind::Number(format) => number(field, format, n, faults),
        Kind::Lettered(format, letter) => {
            let value = number(field, format, n, faults);
            lettered(value, places.field(at + 1), *letter, n + 1, faults)
        }
        Kind::Sided(format, sides) => sided(field, places.field(at + 1), format, *sides, n, faults),
        Kind::Crossed(format, sides, letter) => {
            let value = sided(field, places.field(at + 1), format, *sides, n, faults);
            lettered(value, places.field(at + 2), *letter, n + 2, faults)
        }
        Kind::Integer(format) => match number(field, format, n, faults) {
            Value::Number(number) if number.scale() != 0 => {
                fault(faults, n, FaultKind::NotAnInteger)
            }
            value => value,
        },
        Kind::Code(letters) => match field.text() {
            [] => Value::Null,
            [letter] if letters.contains(letter) => Value::Code(*letter),
            _ => fault(faults, n, FaultKind::UnknownCode),
        },
        Kind::Position(_) => {
            let rest = [1, 2, 3].map(|offset| places.field(at + offset));
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
        Kind::Angle { degrees, .. } => {
            single_angle(field, places.field(at + 1), *degrees, n, faults)
        }
        Kind::Hex(_) => hex(field.text(), n, faults),
        Kind::Payload => payload(field.text(), n, faults),
        Kind::Any => match field.text() {
            [] => Value::Null,
            text => Value::Text(text),
        },
    }
}

#[cold]
#[inline(never)]
fn fault<'a>(faults: &mut Vec<Fault>, n: usize, kind: FaultKind) -> Value<'a> {
    faults.push(Fault::at(n - 1, kind));
    Value::Invalid
}

#[inline(always)]
fn number<'a>(field: Field<'a>, format: &Format, n: usize, faults: &mut Vec<Fault>) -> Value<'a> {
    match measure(field.head, field.length, format) {
        Some(number) => Value::Number(number),
        None if field.is_empty() => Value::Null,
        None => wrong_number(field.head, field.length, format, n, faults),
    }
}

/// The number within its range.
#[inline(always)]
fn measure(head: &[u8], length: usize, format: &Format) -> Option<Decimal> {
    Decimal::parse_last(head, length).filter(|number| number.within(format.low, format.high))
}

/// What is wrong with a number.
#[cold]
#[inline(never)]
fn wrong_number<'a>(
    head: &[u8],
    length: usize,
    format: &Format,
    n: usize,
    faults: &mut Vec<Fault>,
) -> Value<'a> {
    match Decimal::parse_apart(head, length) {
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
    match field.text() {
        [] => value,
        [there] if *there == letter => value,
        _ => {
            let invalid = fault(faults, n, FaultKind::WrongLetter(letter));
            if value.is_null() { value } else { invalid }
        }
    }
}

/// Whether the side is the negative one; none where it is missing or unknown.
#[inline(always)]
fn side(field: Field<'_>, sides: Sides, n: usize, faults: &mut Vec<Fault>) -> Option<bool> {
    match field.text() {
        [letter] if *letter == sides.positive => Some(false),
        [letter] if *letter == sides.negative => Some(true),
        text => {
            wrong_side(text, n, faults);
            None
        }
    }
}

#[cold]
#[inline(never)]
fn wrong_side(text: &[u8], n: usize, faults: &mut Vec<Fault>) {
    let kind = if text.is_empty() {
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

/// Degrees and minutes up to `LIMIT`, unsigned, with so many digits before the point.
#[inline(never)]
fn angle<const DIGITS: usize, const LIMIT: u64>(head: &[u8], length: usize) -> Option<Decimal> {
    let angle = Decimal::parse_with::<DIGITS>(head, length)?;
    // The tens of the minutes stand behind the degrees.
    let tens = last(head, length).get(DIGITS - 2)?;
    let right = !angle.signed()
        && usize::from(angle.whole()) == DIGITS
        && angle.scale() <= 14
        && angle.mantissa() <= LIMIT * POW10[usize::from(angle.scale())]
        && *tens < b'6';
    right.then_some(angle)
}

/// What is wrong with an angle.
#[cold]
#[inline(never)]
fn wrong_angle(head: &[u8], length: usize, degrees: u8, n: usize, faults: &mut Vec<Fault>) {
    let kind = match Decimal::parse_apart(head, length) {
        _ if length == 0 => FaultKind::MissingPart,
        Some(angle) if !angle.signed() && angle.scale() <= 14 => {
            let minute = POW10[usize::from(angle.scale())];
            let minutes = angle.mantissa() % (100 * minute);
            if angle.whole() != degrees + 2 {
                FaultKind::BadWidth {
                    found: angle.whole(),
                    expected: degrees + 2,
                }
            } else if minutes >= 60 * minute {
                FaultKind::MinutesTooLarge(Decimal::new(false, minutes, angle.scale(), 2))
            } else {
                FaultKind::OutOfRange {
                    low: 0,
                    high: if degrees == 2 { 9_000 } else { 18_000 },
                }
            }
        }
        _ => FaultKind::NotANumber,
    };
    fault(faults, n, kind);
}

const NS: Sides = Sides {
    negative: b'S',
    positive: b'N',
};
const EW: Sides = Sides {
    negative: b'W',
    positive: b'E',
};

/// A latitude of two digits of degrees or a longitude of three, and its side.
#[inline(always)]
fn half(
    field: Field<'_>,
    letter: Field<'_>,
    degrees: u8,
    n: usize,
    faults: &mut Vec<Fault>,
) -> Option<Decimal> {
    let value = match degrees {
        2 => angle::<4, 9_000>(field.head, field.length),
        _ => angle::<5, 18_000>(field.head, field.length),
    };
    if value.is_none() {
        wrong_angle(field.head, field.length, degrees, n, faults);
    }
    let sides = if degrees == 2 { NS } else { EW };
    let negative = side(letter, sides, n + 1, faults);
    Some(value?.with_negative(negative?))
}

#[inline(always)]
fn position<'a>(
    field: Field<'a>,
    rest: [Field<'a>; 3],
    n: usize,
    faults: &mut Vec<Fault>,
) -> Value<'a> {
    let [north, longitude, east] = rest;
    if field.is_empty() && rest.iter().all(|field| field.is_empty()) {
        return Value::Null;
    }
    let latitude = half(field, north, 2, n, faults);
    let longitude = half(longitude, east, 3, n + 2, faults);
    match (latitude, longitude) {
        (Some(latitude), Some(longitude)) => Value::Position(latitude, longitude),
        _ => Value::Invalid,
    }
}

#[inline(never)]
fn single_angle<'a>(
    field: Field<'a>,
    letter: Field<'a>,
    degrees: u8,
    n: usize,
    faults: &mut Vec<Fault>,
) -> Value<'a> {
    if field.is_empty() && letter.is_empty() {
        return Value::Null;
    }
    half(field, letter, degrees, n, faults).map_or(Value::Invalid, Value::Angle)
}

#[inline(never)]
fn time(head: &[u8], length: usize) -> Option<Decimal> {
    let time = Decimal::parse_with::<6>(head, length)?;
    let &[h, hours, m, minutes, s, seconds, ..] = last(head, length) else {
        return None;
    };
    // Digits all, as the number was read.
    let below = |tens: u8, ones: u8, limit: [u8; 2]| [tens, ones] < limit;
    let right = time.whole() == 6
        && !time.signed()
        && below(h, hours, *b"24")
        && below(m, minutes, *b"60")
        && below(s, seconds, *b"61");
    right.then_some(time)
}

#[inline(never)]
fn date(head: &[u8], length: usize) -> Option<Decimal> {
    let date = Decimal::parse_last(head, length)?;
    let digits = date.mantissa() as u32;
    let longest = match digits / 100 % 100 {
        2 if digits.is_multiple_of(4) => 29,
        2 => 28,
        4 | 6 | 9 | 11 => 30,
        1..=12 => 31,
        _ => 0,
    };
    let right = length == 6 && date.whole() == 6 && (1..=longest).contains(&(digits / 10_000));
    right.then_some(date)
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

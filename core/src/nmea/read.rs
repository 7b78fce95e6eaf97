//! Reads one member from its raw fields: the value, and the faults found on the way (SEN-4, SEN-6).

use super::angles::{date, position, single_angle, time};
use super::armour::is_armour;
use super::decimal::Decimal;
use super::fault::{Fault, FaultKind};
use super::scan::{Cursor, Field};
use super::sides::{fault, note, side};
use super::table::{Format, Kind, Sides};
use super::value::{Value, hex_byte, hex_digit};
use alloc::vec::Vec;

/// The value of the member that begins with the next field; none behind the last.
#[inline(never)]
pub(crate) fn read<'a>(
    kind: &Kind,
    fields: &mut Cursor<'_, 'a>,
    faults: &mut Vec<Fault>,
) -> Option<Value<'a>> {
    read_here(kind, fields, faults)
}

/// As [`read`], in the caller: the value need not pass through memory.
#[inline(always)]
pub(crate) fn read_here<'a>(
    kind: &Kind,
    fields: &mut Cursor<'_, 'a>,
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
        Kind::Integer(_) if field.is_empty() => Value::Null,
        Kind::Integer(format)
            if let Some(number) = Decimal::whole_only(field.head, field.length)
                && number.within(format.low, format.high) =>
        {
            Value::Number(number)
        }
        Kind::Integer(format) => match number_apart(field.head, field.length, format, n, faults) {
            Some(number) if number.scale() != 0 => fault(faults, n, FaultKind::NotAnInteger),
            Some(number) => Value::Number(number),
            None => Value::Invalid,
        },
        Kind::Code(letters) => match field.letter() {
            Some(letter) if letters.contains(&letter) => Value::Code(letter),
            None if field.is_empty() => Value::Null,
            _ => fault(faults, n, FaultKind::UnknownCode),
        },
        Kind::Position(_) => {
            let rest = [fields.part(), fields.part(), fields.part()];
            position([field, rest[0], rest[1], rest[2]], n, faults)
        }
        Kind::Time => match time(field.head, field.length) {
            Some(time) => Value::Time(time),
            None => null_or_fault(field, n, faults, FaultKind::BadTime),
        },
        Kind::Date => match date(field.head, field.length) {
            Some(date) => Value::Date(date),
            None => null_or_fault(field, n, faults, FaultKind::BadDate),
        },
        Kind::Letters(..) | Kind::Words(_) | Kind::Text(_) | Kind::Payload | Kind::Any => {
            match field.text() {
                [] => Value::Null,
                text if stands(kind, text, n, faults) => Value::Text(text),
                _ => Value::Invalid,
            }
        }
        Kind::Angle { degrees, .. } => single_angle(field, fields.part(), *degrees, n, faults),
        Kind::Hex(_) if field.is_empty() => Value::Null,
        Kind::Hex(_) => match hex(field.text()) {
            Some(number) => Value::Number(number),
            None => fault(faults, n, FaultKind::BadHex),
        },
    })
}

// What is not in the caller gives no whole value: a value that may come from there would pass through memory.

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
    match number_apart(field.head, field.length, format, n, faults) {
        Some(number) => Value::Number(number),
        None => Value::Invalid,
    }
}

/// Numbers of more than eight characters or of a strange form.
#[cold]
#[inline(never)]
fn number_apart(
    head: &[u8],
    length: usize,
    format: &Format,
    n: usize,
    faults: &mut Vec<Fault>,
) -> Option<Decimal> {
    let kind = match Decimal::parse_apart(head, length) {
        Some(number) if number.within(format.low, format.high) => return Some(number),
        Some(_) => out_of_range(format),
        None => FaultKind::NotANumber,
    };
    note(faults, n, kind);
    None
}

const fn out_of_range(format: &Format) -> FaultKind {
    let (low, high) = (format.low, format.high);
    FaultKind::OutOfRange { low, high }
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
    let right = field.letter() == Some(letter) || field.is_empty();
    if !right {
        note(faults, n, FaultKind::WrongLetter(letter));
    }
    match value {
        Value::Number(number) if right => Value::Number(number),
        Value::Null => Value::Null,
        _ => Value::Invalid,
    }
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
            Some(_) if number.signed() => fault(faults, n, out_of_range(format)),
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

/// Whether what is written in letters is what may stand there; says what is wrong.
#[inline(never)]
fn stands(kind: &Kind, text: &[u8], n: usize, faults: &mut Vec<Fault>) -> bool {
    let wrong = match kind {
        Kind::Letters(letters, most) => wrong_letters(text, letters, *most),
        Kind::Words(words) => unknown_word(text, words),
        Kind::Text(limit) => wrong_text(text, *limit),
        Kind::Payload => (!is_armour(text)).then_some(FaultKind::BadPayload),
        _ => None,
    };
    if let Some(kind) = wrong {
        note(faults, n, kind);
    }
    wrong.is_none()
}

/// What is wrong with a text.
fn wrong_text(field: &[u8], limit: u8) -> Option<FaultKind> {
    let mut i = 0;
    let mut length = 0usize;
    while let Some(&byte) = field.get(i) {
        length += 1;
        match byte {
            b'^' if field.get(i + 1..i + 3).and_then(hex_byte).is_some() => i += 3,
            // The reserved characters of the standard; 8-bit characters are ISO 8859-1.
            b'^' | b'*' | b'\\' | b'!' | b'$' | b'~' | 0..=0x1f | 0x7f => {
                return Some(FaultKind::BadCharacter(byte));
            }
            _ => i += 1,
        }
    }
    (length > usize::from(limit)).then_some(FaultKind::TooMuchText(limit))
}

/// Whether a code of several characters is none of the field's.
fn unknown_word(field: &[u8], words: &[&str]) -> Option<FaultKind> {
    let known = words.iter().any(|word| word.as_bytes() == field);
    (!known).then_some(FaultKind::UnknownCode)
}

/// What is wrong with letters that each have a meaning.
fn wrong_letters(field: &[u8], letters: &[u8], most: u8) -> Option<FaultKind> {
    if !field.iter().all(|letter| letters.contains(letter)) {
        return Some(FaultKind::UnknownCode);
    }
    (field.len() > usize::from(most)).then_some(FaultKind::TooMuchText(most))
}

#[inline(never)]
fn hex(field: &[u8]) -> Option<Decimal> {
    let mut number = 0u64;
    for &byte in field {
        match hex_digit(byte) {
            Some(digit) if field.len() <= 8 => number = number << 4 | u64::from(digit),
            _ => return None,
        }
    }
    Some(Decimal::new(false, number, 0, field.len() as u8))
}

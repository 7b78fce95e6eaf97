//! Reads what counts in sixties: positions, angles, times of day; and dates (SEN-4, SEN-6).

use super::decimal::{Decimal, POW10};
use super::fault::{Fault, FaultKind};
use super::scan::{Field, last};
use super::sides::{fault, side, which_side};
use super::table::Sides;
use super::value::Value;
use alloc::vec::Vec;

/// Digits before a point of which the tens of the minutes, and of the seconds, are below 6.
const MINUTES: u64 = Decimal::limits([9, 9, 9, 9, 9, 9, 5, 9]);
const MINUTES_AND_SECONDS: u64 = Decimal::limits([9, 9, 9, 9, 5, 9, 5, 9]);

/// Degrees and minutes up to `LIMIT`, unsigned, with so many digits before the point.
#[inline(always)]
fn angle<const DIGITS: usize, const LIMIT: u64>(head: &[u8], length: usize) -> Option<Decimal> {
    match Decimal::parse_clock::<DIGITS>(head, length, LIMIT, MINUTES) {
        None => long_angle(head, length, DIGITS, LIMIT),
        angle => angle,
    }
}

/// As [`angle`], for any form.
#[cold]
#[inline(never)]
fn long_angle(head: &[u8], length: usize, digits: usize, limit: u64) -> Option<Decimal> {
    let angle = Decimal::parse_apart(head, length)?;
    // The tens of the minutes stand behind the degrees.
    let tens = last(head, length).get(digits - 2)?;
    let right = !angle.signed()
        && usize::from(angle.whole()) == digits
        && angle.scale() <= 14
        && angle.mantissa() <= limit * POW10[usize::from(angle.scale())]
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

/// A latitude of two digits of degrees or a longitude of three.
#[cold]
#[inline(never)]
fn half(
    head: &[u8],
    length: usize,
    degrees: u8,
    n: usize,
    faults: &mut Vec<Fault>,
) -> Option<Decimal> {
    let value = match degrees {
        2 => angle::<4, 9_000>(head, length),
        _ => angle::<5, 18_000>(head, length),
    };
    if value.is_none() {
        wrong_angle(head, length, degrees, n, faults);
    }
    value
}

/// The same and its side.
#[inline(always)]
fn half_and_side(
    field: Field<'_>,
    letter: Field<'_>,
    degrees: u8,
    n: usize,
    faults: &mut Vec<Fault>,
) -> Option<Decimal> {
    let value = half(field.head, field.length, degrees, n, faults);
    let sides = if degrees == 2 { NS } else { EW };
    let negative = side(letter, sides, n + 1, faults);
    Some(value?.with_negative(negative?))
}

/// The usual form of a latitude or a longitude: digits, a point, digits, and a side.
#[inline(always)]
fn usual<const DIGITS: usize, const LIMIT: u64>(
    field: Field<'_>,
    letter: Field<'_>,
    sides: Sides,
) -> Option<Decimal> {
    let value = Decimal::parse_clock::<DIGITS>(field.head, field.length, LIMIT, MINUTES)?;
    Some(value.with_negative(which_side(letter, sides)?))
}

#[inline(always)]
pub(super) fn position<'a>(fields: [Field<'a>; 4], n: usize, faults: &mut Vec<Fault>) -> Value<'a> {
    let [latitude, north, longitude, east] = fields;
    if let Some(latitude) = usual::<4, 9_000>(latitude, north, NS)
        && let Some(longitude) = usual::<5, 18_000>(longitude, east, EW)
    {
        return Value::Position(latitude, longitude);
    }
    if fields.iter().all(|field| field.is_empty()) {
        return Value::Null;
    }
    let latitude = half_and_side(latitude, north, 2, n, faults);
    let longitude = half_and_side(longitude, east, 3, n + 2, faults);
    match (latitude, longitude) {
        (Some(latitude), Some(longitude)) => Value::Position(latitude, longitude),
        _ => Value::Invalid,
    }
}

#[inline(always)]
pub(super) fn single_angle<'a>(
    field: Field<'a>,
    letter: Field<'a>,
    degrees: u8,
    n: usize,
    faults: &mut Vec<Fault>,
) -> Value<'a> {
    if field.is_empty() && letter.is_empty() {
        return Value::Null;
    }
    half_and_side(field, letter, degrees, n, faults).map_or(Value::Invalid, Value::Angle)
}

#[inline(always)]
pub(super) fn time(head: &[u8], length: usize) -> Option<Decimal> {
    match Decimal::parse_clock::<6>(head, length, 240_000, MINUTES_AND_SECONDS) {
        None => long_time(head, length),
        time => time,
    }
}

/// As [`time`], for any form.
#[cold]
#[inline(never)]
fn long_time(head: &[u8], length: usize) -> Option<Decimal> {
    let time = Decimal::parse_apart(head, length)?;
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
pub(super) fn date(head: &[u8], length: usize) -> Option<Decimal> {
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

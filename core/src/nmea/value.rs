//! What a member is worth: numbers, codes, texts, positions and times of the wire.

use super::decimal::{Decimal, POW10};
use crate::geo::Position;
use alloc::string::String;
use serde::{Deserialize, Serialize};

/// The typed value of a member; borrowed from its line, exact.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Value<'a> {
    /// Not available: the field is empty. Never zero (SEN-4).
    Null,
    /// The field has a fault.
    Invalid,
    /// A number; a magnitude with a side is signed, starboard, east and north positive.
    Number(Decimal),
    /// The letter of a code.
    Code(u8),
    /// A text, escapes not yet resolved.
    Text(&'a [u8]),
    /// Latitude as ddmm.mmm and longitude as dddmm.mmm, negative to the south and west.
    Position(Decimal, Decimal),
    /// A latitude or a longitude alone, as above.
    Angle(Decimal),
    /// A time as hhmmss.ss.
    Time(Decimal),
    /// A date as ddmmyy.
    Date(Decimal),
}

impl Value<'_> {
    /// The number, if it is one.
    #[must_use]
    pub fn number(&self) -> Option<f64> {
        match self {
            Self::Number(number) => Some(number.value()),
            Self::Angle(angle) => Some(degrees(*angle)),
            _ => None,
        }
    }
    /// The letter, if it is a code.
    #[must_use]
    pub const fn letter(&self) -> Option<char> {
        match self {
            Self::Code(letter) => Some(*letter as char),
            _ => None,
        }
    }
    /// The text with its escapes resolved, if it is one.
    #[must_use]
    pub fn text(&self) -> Option<String> {
        match self {
            Self::Text(text) => Some(unescape(text)),
            _ => None,
        }
    }
    /// The position, if it is one.
    #[must_use]
    pub fn position(&self) -> Option<Position> {
        match self {
            Self::Position(lat, lon) => Some(Position {
                lat: degrees(*lat),
                lon: degrees(*lon),
            }),
            _ => None,
        }
    }
    /// Whether it is not available.
    #[must_use]
    pub const fn is_null(&self) -> bool {
        matches!(self, Self::Null)
    }
}

/// Degrees of an angle written as degrees and minutes; rounded once.
pub(crate) fn degrees(angle: Decimal) -> f64 {
    let minute = POW10[usize::from(angle.scale().min(16))];
    let degree = minute * 100;
    let whole = angle.mantissa() / degree;
    let minutes = (angle.mantissa() % degree) as f64 / minute as f64;
    let size = if angle.scale() <= 9 {
        let ticks = whole * 60 * minute + angle.mantissa() % degree;
        ticks as f64 / (60 * minute) as f64
    } else {
        whole as f64 + minutes / 60.0
    };
    if angle.negative() { -size } else { size }
}

/// An angle in degrees as degrees and minutes; the two are never rounded apart.
pub(crate) fn degrees_and_minutes(value: f64, digits: u8, decimals: u8) -> Option<Decimal> {
    let decimals = decimals.min(9);
    let minute = POW10[usize::from(decimals)];
    let ticks = libm::round(libm::fabs(value) * (60 * minute) as f64);
    if ticks <= (180 * 60 * minute) as f64 {
        let ticks = ticks as u64;
        let mantissa = ticks / (60 * minute) * 100 * minute + ticks % (60 * minute);
        Some(Decimal::new(value < 0.0, mantissa, decimals, digits + 2))
    } else {
        None
    }
}

/// Text of a field: `^hh` resolved, ISO 8859-1.
#[must_use]
pub(crate) fn unescape(text: &[u8]) -> String {
    let mut out = String::with_capacity(text.len());
    let mut at = 0;
    while let Some(&byte) = text.get(at) {
        let code = if byte == b'^' {
            text.get(at + 1..at + 3).and_then(hex_byte)
        } else {
            None
        };
        out.push(char::from(code.unwrap_or(byte)));
        at += if code.is_some() { 3 } else { 1 };
    }
    out
}

/// Bytes of a line as text: ISO 8859-1.
#[must_use]
pub fn latin1(bytes: &[u8]) -> String {
    match core::str::from_utf8(bytes) {
        Ok(text) if text.is_ascii() => text.into(),
        _ => bytes.iter().map(|&b| char::from(b)).collect(),
    }
}

/// The two digits of a checksum.
#[inline(always)]
pub(crate) const fn hex_digits(byte: u8) -> [u8; 2] {
    const HEX: &[u8; 16] = b"0123456789ABCDEF";
    [HEX[byte as usize >> 4], HEX[byte as usize & 15]]
}

/// Two hexadecimal digits.
pub(crate) fn hex_byte(digits: &[u8]) -> Option<u8> {
    match digits {
        [high, low] => Some(hex_digit(*high)? << 4 | hex_digit(*low)?),
        _ => None,
    }
}

pub(crate) const fn hex_digit(digit: u8) -> Option<u8> {
    match digit {
        b'0'..=b'9' => Some(digit - b'0'),
        b'A'..=b'F' => Some(digit - b'A' + 10),
        b'a'..=b'f' => Some(digit - b'a' + 10),
        _ => None,
    }
}

/// Time of day, UTC; seconds up to 60.99 (leap second).
#[derive(
    Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord, Hash, Serialize, Deserialize,
)]
pub struct UtcTime {
    /// Hours, 0 to 23.
    pub hour: u8,
    /// Minutes, 0 to 59.
    pub minute: u8,
    /// Hundredths of a second, 0 to 6099.
    pub centisecond: u16,
}

impl UtcTime {
    pub(crate) fn from_wire(time: Decimal) -> Self {
        let second = POW10[usize::from(time.scale())];
        let clock = time.mantissa() / second;
        let rest = time.mantissa() % second;
        let hundredths = if time.scale() <= 2 {
            rest * POW10[usize::from(2 - time.scale())]
        } else {
            rest / POW10[usize::from(time.scale() - 2)]
        };
        Self {
            hour: (clock / 10_000 % 100) as u8,
            minute: (clock / 100 % 100) as u8,
            centisecond: (clock % 100 * 100 + hundredths) as u16,
        }
    }
    pub(crate) fn to_wire(self) -> Decimal {
        let clock = u64::from(self.hour) * 10_000 + u64::from(self.minute) * 100;
        Decimal::new(false, clock * 100 + u64::from(self.centisecond), 2, 6)
    }
    /// The time of day that is `seconds` after midnight; whole days are left out.
    #[must_use]
    pub fn from_seconds(seconds: f64) -> Self {
        let day = libm::fmod(seconds, 86_400.0);
        let hundredths = libm::floor(if day < 0.0 { day + 86_400.0 } else { day } * 100.0) as u32;
        Self {
            hour: (hundredths / 360_000 % 24) as u8,
            minute: (hundredths / 6_000 % 60) as u8,
            centisecond: (hundredths % 6_000) as u16,
        }
    }
    /// Seconds after midnight.
    #[must_use]
    pub fn seconds(self) -> f64 {
        f64::from(self.hour) * 3600.0
            + f64::from(self.minute) * 60.0
            + f64::from(self.centisecond) / 100.0
    }
}

/// A date with a year of two digits.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash, Serialize, Deserialize)]
pub struct Date {
    /// Day, 1 to 31.
    pub day: u8,
    /// Month, 1 to 12.
    pub month: u8,
    /// Year without its century, 0 to 99.
    pub year: u8,
}

impl Date {
    pub(crate) const fn from_wire(date: Decimal) -> Self {
        let digits = date.mantissa();
        Self {
            day: (digits / 10_000 % 100) as u8,
            month: (digits / 100 % 100) as u8,
            year: (digits % 100) as u8,
        }
    }
    pub(crate) fn to_wire(self) -> Decimal {
        let digits =
            u64::from(self.day) * 10_000 + u64::from(self.month) * 100 + u64::from(self.year);
        Decimal::new(false, digits, 0, 6)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn minutes_that_round_to_sixty_carry_into_the_degrees() {
        let text = |value| {
            let mut out = alloc::vec::Vec::new();
            if let Some(angle) = degrees_and_minutes(value, 3, 4) {
                angle.write(&mut out, true);
            }
            String::from_utf8(out).unwrap()
        };
        assert_eq!(text(93.599_999_999_9), "09336.0000");
        assert_eq!(text(-93.999_999_999_9), "09400.0000");
        assert_eq!(text(180.0), "18000.0000");
        assert_eq!(text(f64::NAN), "");
    }

    #[test]
    fn texts_are_latin_1_with_escapes() {
        assert_eq!(unescape(b"a^2Cb\xe9^"), "a,b\u{e9}^");
    }
}

//! Faults: what is wrong with a line or with one of its fields, as values.

use super::decimal::Decimal;
use alloc::string::{String, ToString};
use core::fmt;

/// Something wrong in a line. The other fields stay usable.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Fault {
    /// The field, counted from 1 as the documents count; none where it is the whole line.
    pub field: Option<u8>,
    /// What is wrong.
    pub kind: FaultKind,
}

/// What is wrong.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum FaultKind {
    /// The address is not letters and digits of the right length.
    BadAddress,
    /// A character that must not stand in a field, or an incomplete `^hh`.
    BadCharacter(u8),
    /// A date that no calendar has.
    BadDate,
    /// The checksum differs; `given` is none where its digits cannot be read.
    BadChecksum {
        /// What the line says.
        given: Option<u8>,
        /// What it should be.
        computed: u8,
    },
    /// Not hexadecimal digits.
    BadHex,
    /// Characters that are no six-bit armour.
    BadPayload,
    /// Not hhmmss with hours to 23, minutes to 59 and seconds to 60.99.
    BadTime,
    /// Degrees and minutes with the wrong number of digits before the point.
    BadWidth {
        /// Digits found.
        found: u8,
        /// Digits of the format.
        expected: u8,
    },
    /// More fields than any edition has; the field is the first one too many.
    ExtraField {
        /// Fields found.
        found: u8,
        /// Fields of the longest edition.
        expected: u8,
    },
    /// Another number of fields than any edition has.
    FieldCount {
        /// Fields found.
        found: u8,
        /// Fields of the edition that is sent.
        expected: u8,
    },
    /// Minutes of an angle that are not below 60.
    MinutesTooLarge(Decimal),
    /// The line has no checksum.
    MissingChecksum(u8),
    /// A part is missing: a magnitude without its side, half a position.
    MissingPart,
    /// Not a whole number.
    NotAnInteger,
    /// Not a decimal number.
    NotANumber,
    /// Outside the range of the standard.
    OutOfRange {
        /// Least value.
        low: i32,
        /// Greatest value.
        high: i32,
    },
    /// More than 82 characters.
    TooLong(u16),
    /// More text than the field takes.
    TooMuchText(u8),
    /// A letter or word that the field does not know.
    UnknownCode,
    /// Another unit or reference letter than the one that belongs there.
    WrongLetter(u8),
}

impl FaultKind {
    /// Its name in JSON, such as `out_of_range`.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::BadAddress => "bad_address",
            Self::BadCharacter(_) => "bad_character",
            Self::BadDate => "bad_date",
            Self::BadChecksum { .. } => "bad_checksum",
            Self::BadHex => "bad_hex",
            Self::BadPayload => "bad_payload",
            Self::BadTime => "bad_time",
            Self::BadWidth { .. } => "bad_width",
            Self::ExtraField { .. } => "extra_field",
            Self::FieldCount { .. } => "field_count",
            Self::MinutesTooLarge(_) => "minutes_too_large",
            Self::MissingChecksum(_) => "missing_checksum",
            Self::MissingPart => "missing_part",
            Self::NotAnInteger => "not_an_integer",
            Self::NotANumber => "not_a_number",
            Self::OutOfRange { .. } => "out_of_range",
            Self::TooLong(_) => "too_long",
            Self::TooMuchText(_) => "too_much_text",
            Self::UnknownCode => "unknown_code",
            Self::WrongLetter(_) => "wrong_letter",
        }
    }

    /// Whether the fault is of the frame (length, checksum) and not of the contents.
    #[must_use]
    pub const fn of_frame(self) -> bool {
        matches!(
            self,
            Self::BadChecksum { .. } | Self::MissingChecksum(_) | Self::TooLong(_)
        )
    }
}

impl Fault {
    pub(crate) const fn line(kind: FaultKind) -> Self {
        Self { field: None, kind }
    }
    /// The fault of the field with index `at`, counted from 0.
    pub(crate) const fn at(at: usize, kind: FaultKind) -> Self {
        Self {
            field: Some(at as u8 + 1),
            kind,
        }
    }
    /// The fault in words, without the number of its field.
    #[must_use]
    pub fn text(&self) -> String {
        self.kind.to_string()
    }
}

impl fmt::Display for Fault {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self.field {
            Some(field) => write!(f, "field {field}: {}", self.kind),
            None => self.kind.fmt(f),
        }
    }
}

impl fmt::Display for FaultKind {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match *self {
            Self::BadAddress => f.write_str("the address is not a talker and a formatter"),
            Self::BadCharacter(c) => write!(f, "character 0x{c:02X} must not stand here"),
            Self::BadDate => f.write_str("no such date"),
            Self::BadChecksum {
                given: Some(given),
                computed,
            } => {
                write!(f, "checksum is {given:02X}, should be {computed:02X}")
            }
            Self::BadChecksum {
                given: None,
                computed,
            } => {
                write!(f, "checksum is unreadable, should be {computed:02X}")
            }
            Self::BadHex => f.write_str("not a hexadecimal number"),
            Self::BadPayload => f.write_str("not six-bit armoured data"),
            Self::BadTime => f.write_str("not a time from 000000 to 235960.99"),
            Self::BadWidth { found, expected } => {
                write!(f, "{found} digits before the point, should be {expected}")
            }
            Self::ExtraField { found, expected } => {
                write!(f, "{found} fields, there should be {expected}")
            }
            Self::FieldCount { found, expected } => {
                write!(f, "{found} fields, there should be {expected}")
            }
            Self::MinutesTooLarge(minutes) => {
                write!(f, "minutes are {minutes}, should be below 60")
            }
            Self::MissingChecksum(computed) => {
                write!(f, "no checksum, should be {computed:02X}")
            }
            Self::MissingPart => f.write_str("empty, though the fields with it are filled"),
            Self::NotAnInteger => f.write_str("not a whole number"),
            Self::NotANumber => f.write_str("not a number"),
            Self::OutOfRange {
                low,
                high: i32::MAX,
            } => write!(f, "below {low}"),
            Self::OutOfRange { low, high } => write!(f, "not from {low} to {high}"),
            Self::TooLong(length) => write!(f, "{length} characters, more than 82"),
            Self::TooMuchText(limit) => write!(f, "more than {limit} characters"),
            Self::UnknownCode => f.write_str("not one of the field's codes"),
            Self::WrongLetter(letter) => write!(f, "should be {}", char::from(letter)),
        }
    }
}

//! What is wrong in a message, as values.

use core::fmt;

/// Something wrong in a message. The other fields stay usable.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct MessageFault {
    /// The field; none where it is the whole message.
    pub field: Option<&'static str>,
    /// What is wrong.
    pub kind: MessageFaultKind,
}

/// What is wrong in a message.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum MessageFaultKind {
    /// A character that is not six-bit armour; what follows it is not read.
    BadCharacter {
        /// Its place, from 1.
        place: usize,
        /// What it is.
        byte: u8,
    },
    /// More fill bits than a character has besides one.
    BadFillBits(u32),
    /// There is no bit.
    Empty,
    /// A value that the table does not allow.
    OutOfRange,
    /// More bits than the message has.
    TooLong {
        /// Bits found.
        found: usize,
        /// Bits of the longest form.
        most: usize,
    },
    /// Fewer bits than the message has.
    TooShort {
        /// Bits found.
        found: usize,
        /// Bits of the shortest form.
        least: usize,
    },
    /// A type that the recommendation does not have; a target of another protocol version.
    UnknownType(u8),
}

impl MessageFaultKind {
    /// Its name in JSON, such as `too_short`.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::BadCharacter { .. } => "bad_character",
            Self::BadFillBits(_) => "bad_fill_bits",
            Self::Empty => "empty",
            Self::OutOfRange => "out_of_range",
            Self::TooLong { .. } => "too_long",
            Self::TooShort { .. } => "too_short",
            Self::UnknownType(_) => "unknown_type",
        }
    }
}

impl fmt::Display for MessageFaultKind {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match *self {
            Self::BadCharacter { place, byte } => {
                write!(f, "character {place} (0x{byte:02X}) is not six-bit armour")
            }
            Self::BadFillBits(fill) => write!(f, "{fill} fill bits, there are 0 to 5"),
            Self::Empty => f.write_str("no data"),
            Self::OutOfRange => f.write_str("a value that is not allowed"),
            Self::TooLong { found, most } => {
                write!(f, "{found} bits, there should be at most {most}")
            }
            Self::TooShort { found, least } => {
                write!(f, "{found} bits, there should be at least {least}")
            }
            Self::UnknownType(kind) => write!(f, "no message type {kind}"),
        }
    }
}

impl fmt::Display for MessageFault {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self.field {
            Some(field) => write!(f, "{field}: {}", self.kind),
            None => self.kind.fmt(f),
        }
    }
}

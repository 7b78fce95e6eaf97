//! What a field of a message is worth.

use super::bits::Bits;
use core::fmt;

/// The typed value of a field.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Value<'m> {
    /// Not available, or faulty.
    Null,
    /// A whole number or a code.
    Integer(i64),
    /// A number in the field's unit; north, east and starboard positive.
    Number(f64),
    /// At least so much: the last step of the scale; of a negative number at least so much the other way.
    AtLeast(f64),
    /// Whether what the field says is so.
    Flag(bool),
    /// A text.
    Text(SixBitText<'m>),
    /// Data that the message only carries.
    Binary(Binary<'m>),
}

/// Six-bit characters of a message; what follows an `@`, and spaces at the end, do not count.
#[derive(Clone, Copy)]
pub struct SixBitText<'m> {
    bits: &'m Bits,
    at: usize,
    length: usize,
}

/// Bits of a message.
#[derive(Clone, Copy)]
pub struct Binary<'m> {
    bits: &'m Bits,
    at: usize,
    length: usize,
}

impl<'m> SixBitText<'m> {
    /// The text of so many characters from bit `at` on; none where nothing stands there.
    pub(super) fn read(bits: &'m Bits, at: usize, characters: usize) -> Option<Self> {
        let mut length = 0;
        for n in 0..characters {
            match bits.get(at + n * 6, 6) {
                0 => break,
                0x20 => {}
                _ => length = n + 1,
            }
        }
        (length > 0).then_some(Self { bits, at, length })
    }

    /// Its characters.
    pub fn chars(&self) -> impl Iterator<Item = char> + use<'m> {
        let (bits, at) = (self.bits, self.at);
        (0..self.length).map(move |n| {
            let six = bits.get(at + n * 6, 6) as u8;
            char::from(if six < 32 { six + 64 } else { six })
        })
    }
}

impl<'m> Binary<'m> {
    pub(super) const fn new(bits: &'m Bits, at: usize, length: usize) -> Self {
        Self { bits, at, length }
    }

    /// How many bits they are.
    #[must_use]
    pub const fn len(&self) -> usize {
        self.length
    }

    /// Whether there is none.
    #[must_use]
    pub const fn is_empty(&self) -> bool {
        self.length == 0
    }

    /// Byte by byte, the last one filled up with zeros.
    pub fn bytes(&self) -> impl Iterator<Item = u8> + use<'m> {
        let (bits, at, length) = (self.bits, self.at, self.length);
        (0..length.div_ceil(8)).map(move |n| {
            let width = (length - n * 8).min(8);
            (bits.get(at + n * 8, width) << (8 - width)) as u8
        })
    }
}

impl fmt::Display for SixBitText<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        use fmt::Write as _;
        self.chars().try_for_each(|c| f.write_char(c))
    }
}

impl fmt::Display for Binary<'_> {
    /// Hexadecimal.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.bytes().try_for_each(|byte| write!(f, "{byte:02x}"))
    }
}

impl fmt::Debug for SixBitText<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "\"{self}\"")
    }
}

impl fmt::Debug for Binary<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}:{self}", self.length)
    }
}

impl PartialEq for SixBitText<'_> {
    fn eq(&self, other: &Self) -> bool {
        self.chars().eq(other.chars())
    }
}

impl PartialEq for Binary<'_> {
    fn eq(&self, other: &Self) -> bool {
        self.length == other.length && self.bytes().eq(other.bytes())
    }
}

impl fmt::Display for Value<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Null => Ok(()),
            Self::Integer(value) => value.fmt(f),
            Self::Number(value) | Self::AtLeast(value) => value.fmt(f),
            Self::Flag(flag) => f.write_str(if *flag { "yes" } else { "no" }),
            Self::Text(text) => text.fmt(f),
            Self::Binary(binary) => binary.fmt(f),
        }
    }
}

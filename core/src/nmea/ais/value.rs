//! What a field of a message is worth.

use super::bits::Bits;
use core::fmt;

/// The typed value of a field.
// What it holds begins at one place, whatever it is: else a flag is copied in pieces, which a processor has to wait for.
#[repr(C)]
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
    at: u16,
    length: u16,
}

/// Bits of a message.
#[derive(Clone, Copy)]
pub struct Binary<'m> {
    bits: &'m Bits,
    at: u16,
    length: u16,
}

/// Characters that are read at once.
const GROUP: usize = 8;

impl<'m> SixBitText<'m> {
    /// The text of so many characters from bit `at` on; none where nothing stands there.
    #[inline]
    pub(super) fn read(bits: &'m Bits, at: usize, characters: usize) -> Option<Self> {
        let mut length = 0;
        let mut first = 0;
        while first < characters {
            let group = bits.window(at + first * 6) & TOP_48;
            // Characters behind the text count as an end.
            let ends = not(group) | TOP_48 >> ((characters - first).min(GROUP) * 6) & HIGH;
            let before = ends.leading_zeros() as usize / 6;
            let printed = HIGH & !not(group ^ SPACES) & !(TOP_48 >> (before * 6));
            if printed != 0 {
                // The last one that is no space.
                length = first + GROUP - (printed.trailing_zeros() as usize - 16) / 6;
            }
            if before < GROUP {
                break;
            }
            first += GROUP;
        }
        (length > 0).then_some(Self {
            bits,
            at: at as u16,
            length: length as u16,
        })
    }

    /// Its characters.
    pub fn chars(&self) -> impl Iterator<Item = char> + use<'m> {
        let (bits, at, length) = (self.bits, usize::from(self.at), usize::from(self.length));
        let mut group = 0;
        (0..length).map(move |n| {
            if n % GROUP == 0 {
                group = printable(bits.window(at + n * 6));
            }
            group = group.rotate_left(8);
            char::from(group as u8)
        })
    }
}

const TOP_48: u64 = 0xFFFF_FFFF_FFFF_0000;
/// The highest bit of each of eight characters.
const HIGH: u64 = 0x8208_2082_0820_0000;
/// Eight spaces.
const SPACES: u64 = HIGH;

/// The highest bit of each of eight characters that is 0.
#[inline(always)]
const fn not(group: u64) -> u64 {
    let low = !HIGH & TOP_48;
    !((group & low).wrapping_add(low) | group) & HIGH
}

/// Eight six-bit characters as bytes that can be printed, the first one on top.
#[inline(always)]
const fn printable(window: u64) -> u64 {
    let six = window >> 16;
    let fours = (six & 0xFF_FFFF) | (six & 0xFFFF_FF00_0000) << 8;
    let pairs = (fours & 0x0000_0FFF_0000_0FFF) | (fours & 0x00FF_F000_00FF_F000) << 4;
    let bytes = (pairs & 0x003F_003F_003F_003F) | (pairs & 0x0FC0_0FC0_0FC0_0FC0) << 2;
    // What is below 32 stands 64 further on.
    bytes | (!bytes & 0x2020_2020_2020_2020) << 1
}

impl<'m> Binary<'m> {
    pub(super) const fn new(bits: &'m Bits, at: usize, length: usize) -> Self {
        Self {
            bits,
            at: at as u16,
            length: length as u16,
        }
    }

    /// How many bits they are.
    #[must_use]
    pub const fn len(&self) -> usize {
        self.length as usize
    }

    /// Whether there is none.
    #[must_use]
    pub const fn is_empty(&self) -> bool {
        self.length == 0
    }

    /// Byte by byte, the last one filled up with zeros.
    pub fn bytes(&self) -> impl Iterator<Item = u8> + use<'m> {
        let (bits, at, length) = (self.bits, usize::from(self.at), self.len());
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

#[cfg(test)]
mod tests {
    use super::*;
    use alloc::string::String;

    #[test]
    fn a_text_ends_at_its_end_and_has_no_spaces_behind() {
        // Every length and place, with each of these at each place of it.
        for at in 0..13 {
            for length in 0..=20 {
                for changed in 0..=length {
                    for six in [0, 0x20, 1, 31, 63] {
                        let mut bits = Bits::new();
                        (0..at).for_each(|_| bits.put(1, 1));
                        let mut plain = String::new();
                        for n in 0..length {
                            let six = if n == changed { six } else { 40 + n as u32 % 8 };
                            bits.put(six, 6);
                            plain.push(match six {
                                0..32 => (six as u8 + 64).into(),
                                _ => (six as u8).into(),
                            });
                        }
                        // What stands behind the text does not belong to it.
                        (0..9).for_each(|_| bits.put(33, 6));
                        let plain = plain.split('@').next().unwrap_or_default().trim_end();
                        let text = SixBitText::read(&bits, at, length);
                        let found: String = text.iter().flat_map(SixBitText::chars).collect();
                        assert_eq!(found, plain, "{length} characters from {at} on");
                        assert_eq!(text.is_none(), plain.is_empty());
                    }
                }
            }
        }
    }
}

//! Reading a decimal: eight characters at a time where eight are there, one at a time elsewhere.
//!
//! The last eight characters of a field are read as one word, the first of them in its lowest byte. So the digits
//! stand where their weight wants them, whatever the length; what stands before the field is masked out as zeros.

use super::{Decimal, NEGATIVE, PLUS, POINT, POW10, Shape};

const ZEROS: u64 = u64::from_ne_bytes([b'0'; 8]);
/// What carries a byte over 9 into its highest bit.
const OVER_NINE: u64 = u64::from_ne_bytes([0x76; 8]);
const HIGH: u64 = u64::from_ne_bytes([0x80; 8]);
/// Point and minus after the exclusive-or with zeros.
const POINT_SIGN: u8 = b'.' ^ b'0';
const MINUS: u8 = b'-' ^ b'0';

/// The number of eight digits, one a byte, the first in the lowest byte.
#[inline(always)]
const fn number_of(digits: u64) -> u64 {
    const PAIRS: u64 = 0x0000_00FF_0000_00FF;
    let pairs = digits.wrapping_mul(10).wrapping_add(digits >> 8);
    let upper = (pairs & PAIRS).wrapping_mul(100 + (1_000_000 << 32));
    let lower = ((pairs >> 16) & PAIRS).wrapping_mul(1 + (10_000 << 32));
    upper.wrapping_add(lower) >> 32
}

/// The highest bits of the bytes that are no digits; right up to the first one, which is all that is asked.
#[inline(always)]
const fn strange(digits: u64) -> u64 {
    over(digits, OVER_NINE)
}

/// As [`strange`], with other limits than nine: what carries each byte over its own into its highest bit.
#[inline(always)]
const fn over(digits: u64, limits: u64) -> u64 {
    (digits.wrapping_add(limits) | digits) & HIGH
}

/// The last `length` characters (1 to 8) of `head`, less `0` each; zeros before them.
#[inline(always)]
fn last_digits(head: &[u8], length: usize) -> Option<u64> {
    let word = u64::from_le_bytes(*head.last_chunk::<8>()?);
    Some((word ^ ZEROS) & u64::MAX << (((8 - length) * 8) & 63))
}

#[inline(always)]
const fn byte(digits: u64, at: u32) -> u8 {
    (digits >> (8 * at)) as u8
}

impl Decimal {
    /// Reads a field; none where it is not a plain decimal number of at most 19 digits.
    #[must_use]
    #[inline(never)]
    pub fn parse(text: &[u8]) -> Option<Self> {
        let (sign, digits) = match text.first()? {
            b'-' => (NEGATIVE, &text[1..]),
            b'+' => (PLUS, &text[1..]),
            _ => (0, text),
        };
        let mut mantissa = 0u64;
        let mut at = 0;
        while at < digits.len() {
            let digit = digits[at].wrapping_sub(b'0');
            if digit > 9 {
                break;
            }
            mantissa = mantissa.wrapping_mul(10).wrapping_add(u64::from(digit));
            at += 1;
        }
        let whole = at;
        let mut sign = sign;
        let mut scale = 0;
        if at < digits.len() {
            if digits[at] != b'.' {
                return None;
            }
            at += 1;
            while at < digits.len() {
                let digit = digits[at].wrapping_sub(b'0');
                if digit > 9 {
                    return None;
                }
                mantissa = mantissa.wrapping_mul(10).wrapping_add(u64::from(digit));
                at += 1;
            }
            scale = at - whole - 1;
            if scale == 0 {
                sign |= POINT;
            }
        }
        let count = whole + scale;
        if count == 0 || count > 19 {
            return None;
        }
        Some(Self {
            mantissa,
            shape: Shape::new(whole as u8, scale as u8, sign),
        })
    }

    /// Reads the field that is the last `length` characters of `head`.
    #[must_use]
    #[inline(always)]
    pub(crate) fn parse_last(head: &[u8], length: usize) -> Option<Self> {
        let quick = match length {
            1..=8 => Self::short(head, length),
            9..=16 => Self::long(head, length),
            _ => None,
        };
        match quick {
            None => Self::parse(head.get(head.len().checked_sub(length)?..)?),
            number => number,
        }
    }

    /// The most that each of eight digits may be.
    pub(crate) const fn limits(most: [u8; 8]) -> u64 {
        u64::from_le_bytes([0x7f; 8]) - u64::from_le_bytes(most)
    }

    /// A number with `WHOLE` (1 to 8) digits before a point and 1 to 8 behind it; none for all else.
    ///
    /// None also where it is not less than `below`, or one of its digits before the point exceeds its [`Self::limits`].
    #[must_use]
    #[inline(always)]
    pub(crate) fn parse_clock<const WHOLE: usize>(
        head: &[u8],
        length: usize,
        below: u64,
        limits: u64,
    ) -> Option<Self> {
        let scale = length.wrapping_sub(WHOLE + 1);
        if scale.wrapping_sub(1) < 8
            && let Some((before, [b'.', ..])) = head.split_at_checked(head.len() - scale - 1)
            && let Some(before) = last_digits(before, WHOLE)
            && let Some(after) = last_digits(head, scale)
            && over(before, limits) | strange(after) == 0
            && let whole = number_of(before)
            && whole < below
        {
            return Some(Self {
                mantissa: whole * POW10[scale] + number_of(after),
                shape: Shape::new(WHOLE as u8, scale as u8, 0),
            });
        }
        None
    }

    /// As [`Self::parse_last`], in one copy.
    #[must_use]
    #[inline(never)]
    pub(crate) fn parse_apart(head: &[u8], length: usize) -> Option<Self> {
        Self::parse_last(head, length)
    }

    /// One to eight digits; none for all else.
    #[inline(always)]
    pub(crate) fn whole_only(head: &[u8], length: usize) -> Option<Self> {
        if length.wrapping_sub(1) >= 8 {
            return None;
        }
        let digits = last_digits(head, length)?;
        (strange(digits) == 0).then(|| Self {
            mantissa: number_of(digits),
            shape: Shape::new(length as u8, 0, 0),
        })
    }

    /// One to eight characters: a minus perhaps, digits, a point between them perhaps; none for all else.
    #[inline(always)]
    pub(crate) fn short(head: &[u8], length: usize) -> Option<Self> {
        let mut digits = last_digits(head, length)?;
        let mut odd = strange(digits);
        let mut whole = length as u32;
        let mut sign = 0;
        if odd & odd.wrapping_sub(1) != 0 {
            // Two of them: a minus is the first.
            let first = 8 * (8 - whole);
            if (digits >> (first & 63)) as u8 != MINUS {
                return None;
            }
            // A zero in its place changes nothing.
            digits ^= u64::from(MINUS) << (first & 63);
            odd = strange(digits);
            whole -= 1;
            sign = NEGATIVE;
        }
        if odd == 0 {
            return Some(Self {
                mantissa: number_of(digits),
                shape: Shape::new(whole as u8, 0, sign),
            });
        }
        // The lowest bit of the point, which is the only one left, and its place.
        let point = odd >> 7;
        let place = point.trailing_zeros();
        let scale = (63 - place) / 8;
        if odd & odd.wrapping_sub(1) != 0 || (digits >> place) as u8 != POINT_SIGN || scale == 0 {
            return None;
        }
        let before = digits & (point - 1);
        let after = digits & !((point << 8).wrapping_sub(1));
        Some(Self {
            mantissa: number_of(before << 8 | after),
            shape: Shape::new((whole - 1 - scale) as u8, scale as u8, sign),
        })
    }

    /// Nine to sixteen characters: up to eight digits, a point, up to seven digits; none for all else.
    #[inline(always)]
    fn long(head: &[u8], length: usize) -> Option<Self> {
        let digits = last_digits(head, 8)?;
        let odd = strange(digits);
        let point = odd.trailing_zeros() / 8;
        if odd & odd.wrapping_sub(1) != 0 || point >= 7 || byte(digits, point) != POINT_SIGN {
            return None;
        }
        let scale = 7 - point as usize;
        let whole = length - 1 - scale;
        if whole > 8 {
            return None;
        }
        let before = last_digits(&head[..head.len() - 1 - scale], whole)?;
        if strange(before) != 0 {
            return None;
        }
        let after = digits >> (8 * point + 8) << (8 * point + 8);
        Some(Self {
            mantissa: number_of(before) * POW10[scale] + number_of(after),
            shape: Shape::new(whole as u8, scale as u8, 0),
        })
    }
}

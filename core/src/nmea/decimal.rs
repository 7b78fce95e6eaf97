//! Numbers as they stand on the wire: an exact mantissa and scale that print back as they came.

use alloc::vec::Vec;

/// Powers of ten that a `u64` holds.
pub(crate) const POW10: [u64; 20] = {
    let mut table = [1u64; 20];
    let mut i = 1;
    while i < 20 {
        table[i] = table[i - 1] * 10;
        i += 1;
    }
    table
};

const FLOAT_POW10: [f64; 20] = {
    let mut table = [1f64; 20];
    let mut i = 1;
    while i < 20 {
        table[i] = POW10[i] as f64;
        i += 1;
    }
    table
};

const ZEROS: u128 = u128::from_ne_bytes([b'0'; 16]);
/// What carries a byte over 9 into its highest bit.
const OVER_NINE: u128 = u128::from_ne_bytes([0x76; 16]);
const HIGH: u128 = u128::from_ne_bytes([0x80; 16]);
/// A point after the exclusive-or with zeros.
const POINT_DIGIT: u64 = (b'.' ^ b'0') as u64;

/// The number of eight digits, one a byte, the first in the lowest byte.
#[inline]
const fn number_of(digits: u64) -> u64 {
    const PAIRS: u64 = 0x0000_00FF_0000_00FF;
    let pairs = digits.wrapping_mul(10).wrapping_add(digits >> 8);
    let upper = (pairs & PAIRS).wrapping_mul(100 + (1_000_000 << 32));
    let lower = ((pairs >> 16) & PAIRS).wrapping_mul(1 + (10_000 << 32));
    upper.wrapping_add(lower) >> 32
}

/// A number of the wire: `0.350` and `028` come back as they were.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Decimal {
    mantissa: u64,
    scale: u8,
    whole: u8,
    sign: u8,
}

const NEGATIVE: u8 = 1;
const PLUS: u8 = 2;
/// A point stands although no decimals follow it.
const POINT: u8 = 4;

impl Decimal {
    /// A number of `mantissa` times ten to the minus `scale`, with at least `whole` digits before the point.
    #[must_use]
    pub const fn new(negative: bool, mantissa: u64, scale: u8, whole: u8) -> Self {
        let scale = if scale > 19 { 19 } else { scale };
        Self {
            mantissa,
            scale,
            whole,
            sign: negative as u8,
        }
    }

    /// Rounds `value` to `decimals`; none where it is not finite or too large.
    #[must_use]
    pub fn from_f64(value: f64, whole: u8, decimals: u8) -> Option<Self> {
        let scaled = libm::round(libm::fabs(value) * FLOAT_POW10[usize::from(decimals.min(15))]);
        // Written so that a NaN is refused too.
        if scaled < 1e18 {
            let mantissa = scaled as u64;
            Some(Self::new(
                value < 0.0 && mantissa != 0,
                mantissa,
                decimals.min(15),
                whole,
            ))
        } else {
            None
        }
    }

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
            scale: scale as u8,
            whole: whole as u8,
            sign,
        })
    }

    /// Reads the field that stands at `start..end` of `body`; eight or sixteen bytes at a time where they are there.
    #[must_use]
    #[inline(always)]
    pub(crate) fn parse_in(body: &[u8], start: usize, end: usize) -> Option<Self> {
        let length = end.wrapping_sub(start);
        if length.wrapping_sub(1) < 8
            && let Some(Ok(bytes)) = body.get(start..start + 8).map(<[u8; 8]>::try_from)
            && let Some(number) = Self::eight(u64::from_le_bytes(bytes), length)
        {
            return Some(number);
        }
        if length.wrapping_sub(9) < 8
            && let Some(Ok(bytes)) = body.get(start..start + 16).map(<[u8; 16]>::try_from)
            && let Some(number) = Self::sixteen(u128::from_le_bytes(bytes), length)
        {
            return Some(number);
        }
        Self::parse(body.get(start..end)?)
    }

    /// Digits with at most one point inside; none where there is anything else, a sign too.
    #[inline(always)]
    fn eight(word: u64, length: usize) -> Option<Self> {
        let digits = (word ^ ZEROS as u64) & (u64::MAX >> (64 - 8 * length));
        let strange = (digits.wrapping_add(OVER_NINE as u64) | digits) & (HIGH as u64);
        if strange == 0 {
            let mantissa = number_of(digits << (64 - 8 * length));
            return Some(Self {
                mantissa,
                scale: 0,
                whole: length as u8,
                sign: 0,
            });
        }
        let point = (strange.trailing_zeros() / 8) as usize;
        let scale = length - 1 - point;
        if strange & (strange - 1) != 0 || digits >> (8 * point) & 0xff != POINT_DIGIT || scale == 0
        {
            return None;
        }
        let before = digits & ((1 << (8 * point)) - 1);
        let after = digits >> (8 * point) >> 8;
        let joined = before | after << (8 * point);
        let mantissa = number_of(joined << (64 - 8 * (length - 1)));
        Some(Self {
            mantissa,
            scale: scale as u8,
            whole: point as u8,
            sign: 0,
        })
    }

    /// As [`Self::eight`], for 9 to 16 characters.
    #[inline(always)]
    fn sixteen(word: u128, length: usize) -> Option<Self> {
        let digits = (word ^ ZEROS) & (u128::MAX >> (128 - 8 * length));
        let strange = (digits.wrapping_add(OVER_NINE) | digits) & HIGH;
        let point = (strange.trailing_zeros() / 8) as usize;
        if strange == 0 || strange & (strange - 1) != 0 {
            return None;
        }
        let scale = length - 1 - point;
        if digits >> (8 * point) & 0xff != u128::from(POINT_DIGIT) || scale == 0 {
            return None;
        }
        let before = digits & ((1 << (8 * point)) - 1);
        let after = digits >> (8 * point) >> 8;
        let joined = (before | after << (8 * point)) << (128 - 8 * (length - 1));
        let mantissa = number_of(joined as u64) * 100_000_000 + number_of((joined >> 64) as u64);
        Some(Self {
            mantissa,
            scale: scale as u8,
            whole: point as u8,
            sign: 0,
        })
    }

    /// The digits as one number, without sign and point.
    #[must_use]
    pub const fn mantissa(self) -> u64 {
        self.mantissa
    }
    /// Digits after the point.
    #[must_use]
    pub const fn scale(self) -> u8 {
        self.scale
    }
    /// Digits before the point, leading zeros counted.
    #[must_use]
    pub const fn whole(self) -> u8 {
        self.whole
    }
    /// Whether it is written with a minus, or was given a side that counts as negative.
    #[must_use]
    pub const fn negative(self) -> bool {
        self.sign & NEGATIVE != 0
    }
    /// Whether a sign is written before it.
    #[must_use]
    pub(crate) const fn signed(self) -> bool {
        self.sign & (NEGATIVE | PLUS) != 0
    }
    /// The same size with the other or the same sign.
    #[must_use]
    pub const fn with_negative(mut self, negative: bool) -> Self {
        self.sign = (self.sign & !NEGATIVE) | negative as u8;
        self
    }

    /// The nearest floating-point number.
    #[must_use]
    #[inline]
    pub fn value(self) -> f64 {
        let size = self.mantissa as f64 / FLOAT_POW10[usize::from(self.scale)];
        if self.negative() && self.mantissa != 0 {
            -size
        } else {
            size
        }
    }

    /// Whether it lies from `low` to `high`, both included; exact.
    #[must_use]
    #[inline(always)]
    pub fn within(self, low: i32, high: i32) -> bool {
        if self.scale <= 9 && self.mantissa < 1 << 62 {
            let one = POW10[usize::from(self.scale)] as i64;
            let size = self.mantissa as i64;
            let value = if self.negative() { -size } else { size };
            return i64::from(low) * one <= value && value <= i64::from(high) * one;
        }
        let one = POW10[usize::from(self.scale)];
        let not_above = |limit: u64| limit.checked_mul(one).is_none_or(|l| self.mantissa <= l);
        if self.negative() && self.mantissa != 0 {
            let above_high = high < 0
                && u64::from(high.unsigned_abs())
                    .checked_mul(one)
                    .is_none_or(|l| self.mantissa < l);
            low < 0 && not_above(u64::from(low.unsigned_abs())) && !above_high
        } else {
            let below_low = low > 0
                && u64::from(low.unsigned_abs())
                    .checked_mul(one)
                    .is_none_or(|l| self.mantissa < l);
            high >= 0 && not_above(u64::from(high.unsigned_abs())) && !below_low
        }
    }

    /// Appends the number; the sign is left out where `unsigned`, because a side follows.
    pub(crate) fn write(self, out: &mut Vec<u8>, unsigned: bool) {
        if !unsigned && self.sign != 0 {
            if self.sign & PLUS != 0 {
                out.push(b'+');
            } else if self.negative() {
                out.push(b'-');
            }
        }
        let wanted = self.scale + self.whole.min(19) + 1;
        if self.mantissa < 10_000_000 && wanted <= 8 {
            return self.write_short(out);
        }
        // Point and 19 digits on each side of it at most.
        let mut digits = [b'0'; 40];
        let mut at = digits.len();
        let mut rest = self.mantissa;
        let scale = usize::from(self.scale.min(19));
        let point = scale > 0 || self.sign & POINT != 0;
        for _ in 0..scale {
            at -= 1;
            digits[at] = b'0' + (rest % 10) as u8;
            rest /= 10;
        }
        if point {
            at -= 1;
            digits[at] = b'.';
        }
        let end = at;
        let whole = usize::from(self.whole.min(19));
        while rest > 0 {
            at -= 1;
            digits[at] = b'0' + (rest % 10) as u8;
            rest /= 10;
        }
        // What is left of the array is zeros.
        out.extend_from_slice(&digits[at.min(end - whole)..]);
    }

    /// At most eight characters, made in a register.
    #[inline]
    fn write_short(self, out: &mut Vec<u8>) {
        let mut packed = 0u64;
        let mut count = 0;
        let mut rest = self.mantissa as u32;
        for _ in 0..self.scale {
            packed = packed << 8 | u64::from(b'0' + (rest % 10) as u8);
            rest /= 10;
            count += 1;
        }
        if self.scale > 0 || self.sign & POINT != 0 {
            packed = packed << 8 | u64::from(b'.');
            count += 1;
        }
        let mut whole = 0;
        while rest > 0 || whole < self.whole {
            packed = packed << 8 | u64::from(b'0' + (rest % 10) as u8);
            rest /= 10;
            count += 1;
            whole += 1;
        }
        let length = out.len() + count;
        out.extend_from_slice(&packed.to_le_bytes());
        out.truncate(length);
    }
}

impl core::fmt::Display for Decimal {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        let mut text = Vec::new();
        self.write(&mut text, false);
        f.write_str(core::str::from_utf8(&text).unwrap_or_default())
    }
}

#[cfg(test)]
mod tests;

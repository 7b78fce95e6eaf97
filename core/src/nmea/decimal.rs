//! Numbers as they stand on the wire: an exact mantissa and scale that print back as they came.

mod parse;
mod write;

use core::num::NonZeroU32;

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

const NEGATIVE: u8 = 1;
const PLUS: u8 = 2;
/// A point stands although no decimals follow it.
const POINT: u8 = 4;

/// A number of the wire: `0.350` and `028` come back as they were.
#[derive(Clone, Copy, PartialEq, Eq)]
pub struct Decimal {
    mantissa: u64,
    shape: Shape,
}

/// How a number is written: digits before the point, digits after it (at most 19), signs.
///
/// One word that is never zero, so that a number, and one that may be missing, travels in two registers.
#[derive(Clone, Copy, PartialEq, Eq)]
struct Shape(NonZeroU32);

impl Shape {
    #[inline(always)]
    const fn new(whole: u8, scale: u8, sign: u8) -> Self {
        let word = 1 << 24 | (sign as u32) << 16 | (scale as u32) << 8 | whole as u32;
        match NonZeroU32::new(word) {
            Some(word) => Self(word),
            None => Self(NonZeroU32::MIN),
        }
    }
    #[inline(always)]
    const fn whole(self) -> u8 {
        self.0.get() as u8
    }
    #[inline(always)]
    const fn scale(self) -> u8 {
        (self.0.get() >> 8) as u8
    }
    #[inline(always)]
    const fn sign(self) -> u8 {
        (self.0.get() >> 16) as u8
    }
}

impl Decimal {
    /// A number of `mantissa` times ten to the minus `scale`, with at least `whole` digits before the point.
    #[must_use]
    pub const fn new(negative: bool, mantissa: u64, scale: u8, whole: u8) -> Self {
        let scale = if scale > 19 { 19 } else { scale };
        Self {
            mantissa,
            shape: Shape::new(whole, scale, negative as u8),
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

    /// The digits as one number, without sign and point.
    #[must_use]
    pub const fn mantissa(self) -> u64 {
        self.mantissa
    }
    /// Digits after the point.
    #[must_use]
    pub const fn scale(self) -> u8 {
        self.shape.scale()
    }
    /// Digits before the point, leading zeros counted.
    #[must_use]
    pub const fn whole(self) -> u8 {
        self.shape.whole()
    }
    /// Whether it is written with a minus, or was given a side that counts as negative.
    #[must_use]
    pub const fn negative(self) -> bool {
        self.shape.sign() & NEGATIVE != 0
    }
    /// Whether a sign is written before it.
    #[must_use]
    pub(crate) const fn signed(self) -> bool {
        self.shape.sign() & (NEGATIVE | PLUS) != 0
    }
    /// The same size with the other or the same sign.
    #[must_use]
    pub const fn with_negative(mut self, negative: bool) -> Self {
        let sign = (self.shape.sign() & !NEGATIVE) | negative as u8;
        self.shape = Shape::new(self.whole(), self.scale(), sign);
        self
    }

    /// The size alone, where a side says the rest.
    #[must_use]
    pub(crate) const fn without_sign(mut self) -> Self {
        let point = self.shape.sign() & POINT;
        self.shape = Shape::new(self.whole(), self.scale(), point);
        self
    }

    /// The nearest floating-point number.
    #[must_use]
    #[inline]
    pub fn value(self) -> f64 {
        let size = self.mantissa as f64 / FLOAT_POW10[usize::from(self.scale())];
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
        if self.scale() <= 9 && self.mantissa < 1 << 62 {
            let one = POW10[usize::from(self.scale())] as i64;
            let size = self.mantissa as i64;
            let value = if self.negative() { -size } else { size };
            return i64::from(low) * one <= value && value <= i64::from(high) * one;
        }
        let one = POW10[usize::from(self.scale())];
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
}

impl Default for Decimal {
    /// Nothing: no digits at all.
    fn default() -> Self {
        Self::new(false, 0, 0, 0)
    }
}

impl core::fmt::Debug for Decimal {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        write!(f, "Decimal({self})")
    }
}

#[cfg(test)]
mod tests;

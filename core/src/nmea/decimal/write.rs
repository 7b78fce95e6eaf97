//! Writing a decimal: digit for digit as it was read.

use super::{Decimal, PLUS, POINT};
use alloc::vec::Vec;

impl Decimal {
    /// Appends the number; the sign is left out where `unsigned`, because a side follows.
    pub(crate) fn write(self, out: &mut Vec<u8>, unsigned: bool) {
        if !unsigned && self.shape.sign() != 0 {
            if self.shape.sign() & PLUS != 0 {
                out.push(b'+');
            } else if self.negative() {
                out.push(b'-');
            }
        }
        let wanted = self.scale() + self.whole().min(19) + 1;
        if self.mantissa < 10_000_000 && wanted <= 8 {
            return self.write_short(out);
        }
        // Point and 19 digits on each side of it at most.
        let mut digits = [b'0'; 40];
        let mut at = digits.len();
        let mut rest = self.mantissa;
        let scale = usize::from(self.scale().min(19));
        let point = scale > 0 || self.shape.sign() & POINT != 0;
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
        let whole = usize::from(self.whole().min(19));
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
        for _ in 0..self.scale() {
            packed = packed << 8 | u64::from(b'0' + (rest % 10) as u8);
            rest /= 10;
            count += 1;
        }
        if self.scale() > 0 || self.shape.sign() & POINT != 0 {
            packed = packed << 8 | u64::from(b'.');
            count += 1;
        }
        let mut whole = 0;
        while rest > 0 || whole < self.whole() {
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

//! Writing a decimal: digit for digit as it was read.

use super::{Decimal, PLUS, POINT, POW10};
use alloc::vec::Vec;

impl Decimal {
    /// Appends the number; the sign is left out where `unsigned`, because a side follows.
    pub(crate) fn write(self, out: &mut Vec<u8>, unsigned: bool) {
        if !unsigned {
            out.extend(self.sign());
        }
        match self.packed() {
            Some((packed, length)) => {
                let end = out.len() + length;
                out.extend_from_slice(&packed.to_le_bytes());
                out.truncate(end);
            }
            None => self.write_long(out),
        }
    }

    /// The sign that is written.
    pub(crate) const fn sign(self) -> Option<u8> {
        if self.shape.sign() & PLUS != 0 {
            Some(b'+')
        } else if self.negative() {
            Some(b'-')
        } else {
            None
        }
    }

    /// A comma and the number at the start of `place`: their length and exclusive-or, the lanes still apart.
    ///
    /// None where it has a sign or more than eight digits; these are [`Self::packed`].
    #[inline(always)]
    pub(crate) fn write_short(self, place: &mut [u8; 24]) -> Option<(usize, u64)> {
        let (mantissa, scale) = (self.mantissa, usize::from(self.scale()));
        let mut count = usize::from(self.whole()) + scale;
        while count < 9 && mantissa >= POW10[count] {
            count += 1;
        }
        if count == 0 || count > 8 || self.shape.sign() & !POINT != 0 {
            return None;
        }
        const ZEROS: u64 = u64::from_ne_bytes([b'0'; 8]);
        let digits = (eight_digits(mantissa) | ZEROS) >> (8 * (8 - count));
        place[0] = b',';
        place[1..9].copy_from_slice(&digits.to_le_bytes());
        let mut sum = digits ^ u64::from(b',');
        if scale > 0 || self.shape.sign() != 0 {
            let whole = (count - scale) & 15;
            place[whole + 1] = b'.';
            // In two steps, as all eight digits may stand before the point.
            let behind = (digits >> (4 * whole)) >> (4 * whole);
            place[whole + 2..whole + 10].copy_from_slice(&behind.to_le_bytes());
            sum ^= u64::from(b'.');
            count += 1;
        }
        Some((count + 1, sum))
    }

    /// Any number of digits, one after the other.
    #[cold]
    pub(super) fn write_long(self, out: &mut Vec<u8>) {
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

    /// The number without its sign in at most 16 characters, zeros behind, and how many they are. None where it takes more.
    #[inline]
    pub(crate) fn packed(self) -> Option<(u128, usize)> {
        let (mantissa, scale) = (self.mantissa, usize::from(self.scale()));
        let mut count = usize::from(self.whole()) + scale;
        while count < 16 && mantissa >= POW10[count] {
            count += 1;
        }
        if count == 0 || count > 15 {
            return None;
        }
        const ZEROS: u128 = u128::from_ne_bytes([b'0'; 16]);
        let (high, low) = (mantissa / 100_000_000, mantissa % 100_000_000);
        let all = u128::from(eight_digits(high)) | (u128::from(eight_digits(low)) << 64);
        let digits = (all | ZEROS) >> (8 * (16 - count));
        let point = scale > 0 || self.shape.sign() & POINT != 0;
        if point {
            let whole = 8 * (count - scale);
            let before = digits & ((1 << whole) - 1);
            let behind = ((digits >> whole) << 8) | u128::from(b'.');
            Some((before | (behind << whole), count + 1))
        } else {
            Some((digits, count))
        }
    }
}

/// The eight digits of a number below 10^8, one a byte, the first in the lowest byte: halved three times, in lanes.
#[inline]
const fn eight_digits(number: u64) -> u64 {
    let fours = (number / 10_000) | ((number % 10_000) << 32);
    // A hundredth and a tenth as multiplications that are exact below 10,000 and below 100.
    let hundreds = ((fours * 10_486) >> 20) & 0x0000_007F_0000_007F;
    let twos = hundreds | ((fours - hundreds * 100) << 16);
    let tens = ((twos * 103) >> 10) & 0x000F_000F_000F_000F;
    tens | ((twos - tens * 10) << 8)
}

impl core::fmt::Display for Decimal {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        let mut text = Vec::new();
        self.write(&mut text, false);
        f.write_str(core::str::from_utf8(&text).unwrap_or_default())
    }
}

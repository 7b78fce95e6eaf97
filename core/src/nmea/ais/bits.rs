//! Six-bit characters and the bits in them.

use crate::nmea::armour::{ONES, TOPS, at_least, foreign, six};
use alloc::string::String;

/// Bytes of the buffer; the last ones stay zero, so that eight may be read from where the last field begins.
const BYTES: usize = Bits::MOST / 8 + 8;

/// Bits of a message, the first one first. The longest message (26) has 1064.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Bits {
    bytes: [u8; BYTES],
    length: usize,
}

/// A character that is not six-bit armour.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct NoArmour {
    pub(super) at: usize,
    pub(super) byte: u8,
}

impl Bits {
    /// More bits than this are never held.
    pub const MOST: usize = 18 * 64;

    pub(super) const fn new() -> Self {
        Self {
            bytes: [0; BYTES],
            length: 0,
        }
    }

    /// How many there are.
    #[must_use]
    pub const fn len(&self) -> usize {
        self.length
    }

    /// Whether there is none.
    #[must_use]
    pub const fn is_empty(&self) -> bool {
        self.length == 0
    }

    /// Takes the bits of armoured characters into an empty buffer, as far as there is room. Stops at a character that is none.
    #[inline]
    pub(super) fn fill(&mut self, payload: &[u8]) -> Option<NoArmour> {
        let room = &payload[..payload.len().min(Self::MOST / 6)];
        let (eights, rest) = room.as_chunks::<8>();
        let mut wrong = 0;
        // Eight characters are six bytes; the two zeros behind them are overwritten by the next ones.
        for (n, eight) in eights.iter().enumerate() {
            wrong |= self.put_eight(n, u64::from_be_bytes(*eight));
        }
        if !rest.is_empty() {
            wrong |= self.put_eight(eights.len(), filled_up(room, rest.len()));
        }
        if wrong != 0 {
            return self.up_to_fault(room);
        }
        self.length = room.len() * 6;
        None
    }

    /// The eight characters with index `n`; not 0 where one of them is no armour.
    #[inline(always)]
    fn put_eight(&mut self, n: usize, raw: u64) -> u64 {
        let (packed, wrong) = pack(raw);
        if let Some(place) = self.bytes.get_mut(n * 6..n * 6 + 8) {
            place.copy_from_slice(&(packed << 16).to_be_bytes());
        }
        wrong
    }

    #[cold]
    #[inline(never)]
    fn up_to_fault(&mut self, payload: &[u8]) -> Option<NoArmour> {
        *self = Self::new();
        for (at, &byte) in payload.iter().enumerate() {
            match six(byte) {
                Some(value) => self.put(u32::from(value), 6),
                None => return Some(NoArmour { at, byte }),
            }
        }
        None
    }

    /// The armoured characters, and how many bits of the last one do not count.
    pub(super) fn armour(&self) -> (String, u8) {
        let characters = self.length.div_ceil(6);
        let text = (0..characters)
            .map(|n| {
                let value = self.get(n * 6, 6) as u8;
                char::from(if value < 40 { value + 48 } else { value + 56 })
            })
            .collect();
        (text, (characters * 6 - self.length) as u8)
    }

    /// Leaves the last bits out.
    pub(super) fn drop_last(&mut self, count: usize) {
        let length = self.length.saturating_sub(count);
        for at in length..self.length {
            self.bytes[at / 8] &= !(0x80 >> (at % 8));
        }
        self.length = length;
    }

    /// Whether there were fewer than `at + width`.
    #[inline(always)]
    pub(super) const fn lacks(&self, at: usize, width: usize) -> bool {
        at + width > self.length
    }

    /// At least 57 bits from bit `at` on, the first one on top; zeros stand behind the end.
    #[inline(always)]
    pub(super) fn window(&self, at: usize) -> u64 {
        self.word(at / 8) << (at % 8)
    }

    /// The 64 bits from that byte on.
    #[inline(always)]
    pub(super) fn word(&self, byte: usize) -> u64 {
        match self.bytes.get(byte..).and_then(<[u8]>::first_chunk) {
            Some(bytes) => u64::from_be_bytes(*bytes),
            None => 0,
        }
    }

    /// The unsigned number of `width` bits (1 to 32) from bit `at` on.
    #[inline(always)]
    pub(super) fn get(&self, at: usize, width: usize) -> u32 {
        (self.window(at) >> ((64 - width) & 63)) as u32
    }

    /// The same, where `signed` as a number in two's complement; without a branch.
    #[inline(always)]
    pub(super) fn get_scaled(&self, at: usize, width: usize, signed: bool) -> i32 {
        let sign = u32::from(signed) << ((width - 1) & 31);
        ((self.get(at, width) ^ sign).wrapping_sub(sign)) as i32
    }

    /// The same as a number in two's complement.
    #[inline(always)]
    pub(super) fn get_signed(&self, at: usize, width: usize) -> i32 {
        (self.window(at) as i64 >> ((64 - width) & 63)) as i32
    }

    /// Adds the last `width` bits (1 to 32) of a number, as far as there is room.
    pub(super) fn put(&mut self, value: u32, width: usize) {
        if self.length + width > Self::MOST {
            return;
        }
        let value = u64::from(value) << (64 - width) >> (self.length % 8);
        let bytes = self.bytes[self.length / 8..].iter_mut();
        bytes
            .zip(value.to_be_bytes())
            .for_each(|(byte, more)| *byte |= more);
        self.length += width;
    }
}

/// The last `length` (1 to 7) of some characters, filled up to eight with those of the value 0.
#[inline(always)]
fn filled_up(characters: &[u8], length: usize) -> u64 {
    let raw = match characters.last_chunk::<8>() {
        Some(last) => u64::from_be_bytes(*last),
        None => characters
            .iter()
            .fold(0, |raw, &byte| raw << 8 | u64::from(byte)),
    };
    raw << ((64 - length * 8) & 63) | ZEROS >> ((length * 8) & 63)
}

/// Eight characters of the value 0.
const ZEROS: u64 = b'0' as u64 * ONES;

/// Eight characters at once, the first one on top, in 48 bits; not 0 where one of them is no armour.
#[inline(always)]
const fn pack(raw: u64) -> (u64, u64) {
    // High ones are 8 further on.
    let high = at_least(raw, 0x60) & TOPS;
    let six = raw.wrapping_sub(ZEROS).wrapping_sub(high >> 4);
    let pairs = (six & 0x003F_003F_003F_003F) | (six & 0x3F00_3F00_3F00_3F00) >> 2;
    let fours = (pairs & 0x0000_0FFF_0000_0FFF) | (pairs & 0x0FFF_0000_0FFF_0000) >> 4;
    let packed = (fours & 0xFF_FFFF) | (fours & 0x00FF_FFFF_0000_0000) >> 8;
    (packed, foreign(raw))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn armour_comes_back_and_every_character_is_told_apart() {
        for byte in 0..=255u8 {
            for place in 0..9 {
                let mut text = *b"15RTgt0PA";
                text[place] = byte;
                let mut bits = Bits::new();
                let fault = bits.fill(&text);
                if six(byte).is_some() {
                    assert_eq!(fault, None);
                    assert_eq!(bits.armour().0.as_bytes(), text);
                } else {
                    assert_eq!(fault, Some(NoArmour { at: place, byte }));
                    assert_eq!(bits.len(), place * 6);
                }
            }
        }
    }

    #[test]
    fn a_field_is_read_where_it_was_put() {
        for start in 0..130 {
            for width in 1..=32 {
                let mut bits = Bits::new();
                (0..start).for_each(|_| bits.put(1, 1));
                let value = 0xA5C3_96F1 >> (32 - width);
                bits.put(value, width);
                bits.put(u32::MAX, 32);
                assert_eq!(bits.get(start, width), value);
                assert!(bits.get_signed(start, width) < 0, "the first bit is set");
                bits.drop_last(32 + width);
                assert_eq!((bits.len(), bits.get(start, 32)), (start, 0));
            }
        }
    }
}

//! Six-bit characters and the bits in them.

use alloc::string::String;

/// Words of the buffer; the last one stays zero, so that a field may end anywhere.
const WORDS: usize = 19;

/// Bits of a message, the first one first. The longest message (26) has 1064.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Bits {
    words: [u64; WORDS],
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
    pub const MOST: usize = (WORDS - 1) * 64;

    pub(super) const fn new() -> Self {
        Self {
            words: [0; WORDS],
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

    /// The bits of armoured characters, as far as there is room. Stops at a character that is none.
    pub(super) fn from_armour(payload: &[u8]) -> (Self, Option<NoArmour>) {
        let mut bits = Self::new();
        let room = &payload[..payload.len().min(Self::MOST / 6)];
        let (eights, rest) = room.as_chunks::<8>();
        for (n, eight) in eights.iter().enumerate() {
            let raw = u64::from_be_bytes(*eight);
            let Some(packed) = pack(raw) else {
                return bits.up_to_fault(payload, n * 8);
            };
            bits.put_wide(packed, 48);
        }
        for (n, &byte) in rest.iter().enumerate() {
            let Some(value) = six(byte) else {
                return bits.up_to_fault(payload, eights.len() * 8 + n);
            };
            bits.put(u32::from(value), 6);
        }
        (bits, None)
    }

    #[cold]
    fn up_to_fault(mut self, payload: &[u8], from: usize) -> (Self, Option<NoArmour>) {
        for (n, &byte) in payload[from..].iter().enumerate() {
            match six(byte) {
                Some(value) => self.put(u32::from(value), 6),
                None => return (self, Some(NoArmour { at: from + n, byte })),
            }
        }
        (self, None)
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
            self.words[at / 64] &= !(1 << (63 - at % 64));
        }
        self.length = length;
    }

    /// Whether there were fewer than `at + width`.
    pub(super) const fn lacks(&self, at: usize, width: usize) -> bool {
        at + width > self.length
    }

    /// The unsigned number of `width` bits (1 to 32) from bit `at` on; zeros stand behind the end.
    #[inline]
    pub(super) fn get(&self, at: usize, width: usize) -> u32 {
        let (word, shift) = (at / 64, at % 64);
        let first = self.words.get(word).copied().unwrap_or(0) << shift;
        let second = self.words.get(word + 1).copied().unwrap_or(0);
        let both = first | (second >> 1) >> (63 - shift);
        (both >> (64 - width)) as u32
    }

    /// The same as a number in two's complement.
    #[inline]
    pub(super) fn get_signed(&self, at: usize, width: usize) -> i32 {
        let up = 32 - width;
        ((self.get(at, width) << up) as i32) >> up
    }

    /// Adds the last `width` bits (1 to 32) of a number, as far as there is room.
    pub(super) fn put(&mut self, value: u32, width: usize) {
        self.put_wide(u64::from(value), width);
    }

    #[inline]
    fn put_wide(&mut self, value: u64, width: usize) {
        if self.length + width > Self::MOST {
            return;
        }
        let value = value << (64 - width);
        let (word, shift) = (self.length / 64, self.length % 64);
        self.words[word] |= value >> shift;
        self.words[word + 1] |= (value << 1) << (63 - shift);
        self.length += width;
    }
}

/// The value of an armoured character.
const fn six(byte: u8) -> Option<u8> {
    match byte {
        0x30..=0x57 => Some(byte - 48),
        0x60..=0x77 => Some(byte - 56),
        _ => None,
    }
}

/// Eight characters at once, the first one on top; none where one of them is no armour.
#[inline]
fn pack(raw: u64) -> Option<u64> {
    const ONES: u64 = 0x0101_0101_0101_0101;
    const TOP: u64 = 0x80 * ONES;
    // The top bit of each byte says whether it is at least so much; all bytes are below 128.
    let at_least = |least: u64| (raw | TOP).wrapping_sub(least * ONES) & TOP;
    let low = at_least(0x30) & !at_least(0x58);
    let high = at_least(0x60) & !at_least(0x78);
    if raw & TOP != 0 || low | high != TOP {
        return None;
    }
    // High ones are 8 further on.
    let six = raw - 0x30 * ONES - (high >> 4);
    let pairs = (six & 0x003F_003F_003F_003F) | (six & 0x3F00_3F00_3F00_3F00) >> 2;
    let fours = (pairs & 0x0000_0FFF_0000_0FFF) | (pairs & 0x0FFF_0000_0FFF_0000) >> 4;
    Some((fours & 0xFF_FFFF) | (fours & 0x00FF_FFFF_0000_0000) >> 8)
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
                let (bits, fault) = Bits::from_armour(&text);
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

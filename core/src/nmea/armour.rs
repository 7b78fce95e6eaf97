//! The characters that carry six bits each (AIS and tracked targets), eight at a time.

/// A one in each byte.
pub(super) const ONES: u64 = 0x0101_0101_0101_0101;
/// The top bit of each byte.
pub(super) const TOPS: u64 = 0x80 * ONES;

/// The value of a character; none where it is no armour.
pub(super) const fn six(byte: u8) -> Option<u8> {
    match byte {
        0x30..=0x57 => Some(byte - 48),
        0x60..=0x77 => Some(byte - 56),
        _ => None,
    }
}

/// The top bits of the bytes that are at least so much; right of bytes below 128, as the other bits are not.
#[inline(always)]
pub(super) const fn at_least(raw: u64, least: u64) -> u64 {
    raw.wrapping_add((0x80 - least) * ONES)
}

/// Not 0 where one of eight characters is no armour.
#[inline(always)]
pub(super) const fn foreign(raw: u64) -> u64 {
    // Behind a byte of more than 127 the sums are wrong, and it is foreign itself.
    let between = at_least(raw, 0x58) ^ at_least(raw, 0x60);
    (raw | !at_least(raw, 0x30) | between | at_least(raw, 0x78)) & TOPS
}

/// Whether all characters are armour.
pub(super) fn is_armour(text: &[u8]) -> bool {
    let (eights, rest) = text.as_chunks::<8>();
    let foreign = eights.iter().fold(0, |found, eight| {
        found | foreign(u64::from_le_bytes(*eight))
    });
    foreign == 0 && rest.iter().all(|&byte| six(byte).is_some())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_character_is_told_apart_at_every_place() {
        for byte in 0..=255 {
            for place in 0..17 {
                let mut text = *b"0W`w15RTgt0PA:;<=";
                text[place] = byte;
                assert_eq!(is_armour(&text), six(byte).is_some(), "{byte:#x}");
            }
        }
    }
}

//! One pass over a line: where the fields are, and the checksum.

/// Longest body whose fields are told apart; offsets fit a byte.
pub(crate) const LONGEST_BODY: usize = 255;
/// Most fields that are told apart; a line of 82 characters cannot have more.
pub(crate) const MAX_FIELDS: usize = 100;

/// Raw fields of a line, numbered from 1.
#[derive(Clone, Copy)]
pub struct FieldList<'a> {
    body: &'a [u8],
    /// Offset of the separator before each field; one more for the end.
    separators: [u8; MAX_FIELDS + 1],
    count: u8,
}

impl<'a> FieldList<'a> {
    /// How many fields there are.
    #[must_use]
    pub const fn len(&self) -> usize {
        self.count as usize
    }
    /// Whether there are none.
    #[must_use]
    pub const fn is_empty(&self) -> bool {
        self.count == 0
    }
    /// Field `n`, counted from 1; empty where there is none.
    #[must_use]
    pub fn get(&self, n: usize) -> &'a [u8] {
        if n == 0 { &[] } else { self.at(n - 1) }
    }
    /// Field with index `at`, counted from 0; empty where there is none.
    #[inline(always)]
    pub(crate) fn at(&self, at: usize) -> &'a [u8] {
        if at < usize::from(self.count) {
            let from = usize::from(self.separators[at]) + 1;
            let to = usize::from(self.separators[at + 1]);
            self.body.get(from..to).unwrap_or(&[])
        } else {
            &[]
        }
    }
    /// The number in the field with index `at`; none where it is not one.
    #[inline(always)]
    pub(crate) fn number(&self, at: usize) -> Option<super::Decimal> {
        let start = usize::from(*self.separators.get(at)?) + 1;
        let end = usize::from(*self.separators.get(at + 1)?);
        super::Decimal::parse_in(self.body, start, end)
    }
    /// All fields in order.
    pub fn iter(&self) -> impl Iterator<Item = &'a [u8]> + '_ {
        (0..self.len()).map(|at| self.at(at))
    }
    /// Offset of the separator before field `at` (from 0), which is the end of the field before it.
    pub(crate) fn start(&self, at: usize) -> usize {
        usize::from(self.separators[at.min(usize::from(self.count))])
    }
}

impl core::fmt::Debug for FieldList<'_> {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        f.debug_list()
            .entries(self.iter().map(alloc::string::String::from_utf8_lossy))
            .finish()
    }
}

const COMMAS: u64 = u64::from_ne_bytes([b','; 8]);
const LOW7: u64 = u64::from_ne_bytes([0x7f; 8]);

/// Separators and exclusive-or of `body`, the characters between `$` and `*`.
///
/// Eight bytes at a time; bytes after [`MAX_FIELDS`] separators belong to the last field.
#[inline]
pub(crate) fn scan(body: &[u8]) -> (FieldList<'_>, u8) {
    let mut separators = [0u8; MAX_FIELDS + 1];
    let mut count = 0usize;
    let mut xor = 0u64;
    let mut take = |word: u64, base: usize, count: &mut usize| {
        let y = word ^ COMMAS;
        let mut found = !(((y & LOW7) + LOW7) | y | LOW7);
        while found != 0 {
            if *count < MAX_FIELDS {
                separators[*count] = (base + (found.trailing_zeros() >> 3) as usize) as u8;
                *count += 1;
            }
            found &= found - 1;
        }
    };
    let (words, rest) = body.as_chunks::<8>();
    for (i, word) in words.iter().enumerate() {
        let word = u64::from_le_bytes(*word);
        xor ^= word;
        take(word, i * 8, &mut count);
    }
    if !rest.is_empty() {
        let mut word = 0u64;
        for (i, &byte) in rest.iter().enumerate() {
            word |= u64::from(byte) << (i * 8);
        }
        xor ^= word;
        take(word, words.len() * 8, &mut count);
    }
    separators[count] = body.len() as u8;
    xor ^= xor >> 32;
    xor ^= xor >> 16;
    xor ^= xor >> 8;
    (
        FieldList {
            body,
            separators,
            count: count as u8,
        },
        xor as u8,
    )
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn finds_what_a_plain_loop_finds() {
        let text = b"EIHTC,V,,,T,R,,,0.35,,,280.0,\xac,T,C,,";
        for length in 0..=text.len() {
            let body = &text[..length];
            let (fields, xor) = scan(body);
            assert_eq!(xor, body.iter().fold(0, |x, b| x ^ b));
            let plain: alloc::vec::Vec<&[u8]> = body.split(|&b| b == b',').skip(1).collect();
            assert_eq!(fields.iter().collect::<alloc::vec::Vec<_>>(), plain);
        }
    }

    #[test]
    fn a_line_of_commas_is_bounded() {
        let (fields, _) = scan(&[b','; LONGEST_BODY]);
        assert_eq!(fields.len(), MAX_FIELDS);
    }
}

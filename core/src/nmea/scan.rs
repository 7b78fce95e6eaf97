//! One pass over a line: where the fields are, and the checksum.

/// Longest body whose fields are told apart: a bit of four words for each byte.
pub(crate) const LONGEST_BODY: usize = 255;
/// Most fields that are told apart; a line of 82 characters cannot have more.
pub(crate) const MAX_FIELDS: usize = 100;

/// Raw fields of a line, numbered from 1.
#[derive(Clone, Copy)]
pub struct FieldList<'a> {
    body: &'a [u8],
    /// One bit a byte of the body that is a comma, the first byte in the lowest bit of the first word; one for its end.
    separators: [u64; 4],
}

impl<'a> FieldList<'a> {
    /// The fields of `body`, the characters between `$` and `*`, and its exclusive-or.
    ///
    /// Eight bytes at a time; bytes after [`MAX_FIELDS`] separators belong to the last field.
    #[inline(always)]
    pub(crate) fn scan(body: &'a [u8]) -> (Self, u8) {
        // The words are values until the list is made: one that was written alone and is read with another has to be waited for.
        let (first, mut xor) = block(body, 0);
        let separators = if body.len() < 64 {
            [first | 1 << body.len(), 0, 0, 0]
        } else if body.len() <= MAX_FIELDS {
            let (second, sum) = block_apart(body, 64);
            xor ^= sum;
            [first, second | 1 << (body.len() & 63), 0, 0]
        } else {
            let (rest, sum) = further(body, first);
            xor ^= sum;
            rest
        };
        xor ^= xor >> 32;
        xor ^= xor >> 16;
        xor ^= xor >> 8;
        (Self { body, separators }, xor as u8)
    }

    /// How many fields there are.
    #[must_use]
    pub const fn len(&self) -> usize {
        let [a, b, c, d] = self.separators;
        (a.count_ones() + b.count_ones() + c.count_ones() + d.count_ones()) as usize - 1
    }
    /// Whether there are none.
    #[must_use]
    pub const fn is_empty(&self) -> bool {
        self.len() == 0
    }
    /// Field `n`, counted from 1; empty where there is none.
    #[must_use]
    pub fn get(&self, n: usize) -> &'a [u8] {
        if n == 0 { &[] } else { self.at(n - 1) }
    }
    /// Field with index `at`, counted from 0; empty where there is none.
    pub(crate) fn at(&self, at: usize) -> &'a [u8] {
        self.cursor_at(at).next().map_or(&[], Field::text)
    }
    /// All fields in order.
    pub fn iter(&self) -> impl Iterator<Item = &'a [u8]> + '_ {
        let mut cursor = self.cursor();
        core::iter::from_fn(move || cursor.next().map(Field::text))
    }
    /// The body up to the first separator.
    #[inline(always)]
    pub(crate) fn address(&self) -> &'a [u8] {
        match self.separators[0] {
            0 => self.body.split(|&b| b == b',').next().unwrap_or(&[]),
            bits => self
                .body
                .get(..bits.trailing_zeros() as usize)
                .unwrap_or(self.body),
        }
    }
    /// The fields one after the other, from the first on.
    #[inline(always)]
    pub(crate) fn cursor(&self) -> Cursor<'_, 'a> {
        let mut cursor = Cursor {
            body: self.body,
            separators: &self.separators,
            bits: self.separators[0],
            base: 0,
            start: 0,
            taken: 0,
        };
        // The address is none.
        cursor.next();
        cursor.taken = 0;
        cursor
    }
    /// The fields from index `at` (from 0) on.
    pub(crate) fn cursor_at(&self, at: usize) -> Cursor<'_, 'a> {
        let mut cursor = self.cursor();
        for _ in 0..at {
            if cursor.next().is_none() {
                break;
            }
        }
        cursor.taken = at;
        cursor
    }
}

impl core::fmt::Debug for FieldList<'_> {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        f.debug_list()
            .entries(self.iter().map(alloc::string::String::from_utf8_lossy))
            .finish()
    }
}

/// Gives the fields of a line one after the other.
pub(crate) struct Cursor<'s, 'a> {
    body: &'a [u8],
    separators: &'s [u64; 4],
    /// Those of the word at hand that are not yet passed.
    bits: u64,
    /// Offset of the word at hand.
    base: usize,
    /// Offset of the next field.
    start: usize,
    /// How many fields were asked for.
    taken: usize,
}

impl<'a> Cursor<'_, 'a> {
    /// How many fields were asked for, those behind the end too.
    #[inline(always)]
    pub(crate) const fn taken(&self) -> usize {
        self.taken
    }
    /// The next field; none behind the last.
    #[inline(always)]
    pub(crate) fn next(&mut self) -> Option<Field<'a>> {
        self.taken += 1;
        while self.bits == 0 {
            if self.start > self.body.len() {
                return None;
            }
            self.base += 64;
            self.bits = self.separators[(self.base / 64) & 3];
        }
        let end = self.base + self.bits.trailing_zeros() as usize;
        self.bits &= self.bits - 1;
        let length = end.wrapping_sub(self.start);
        self.start = end + 1;
        let head = self.body.get(..end).unwrap_or(self.body);
        Some(Field { head, length })
    }
    /// The next field as a part of a member; empty behind the last.
    #[inline(always)]
    pub(crate) fn part(&mut self) -> Field<'a> {
        self.next().unwrap_or(Field {
            head: &[],
            length: 0,
        })
    }
}

/// One field of a line: the last characters of a head of the body.
///
/// What stands before it is kept, because a number is read from behind.
#[derive(Clone, Copy)]
pub(crate) struct Field<'a> {
    /// The body up to the end of the field.
    pub(crate) head: &'a [u8],
    /// How many of the last characters are the field.
    pub(crate) length: usize,
}

impl<'a> Field<'a> {
    /// What stands in it.
    #[inline(always)]
    pub(crate) fn text(self) -> &'a [u8] {
        last(self.head, self.length)
    }
    /// The character that stands in it, if it is one.
    #[inline(always)]
    pub(crate) fn letter(self) -> Option<u8> {
        match self.head {
            [.., letter] if self.length == 1 => Some(*letter),
            _ => None,
        }
    }
    /// Whether nothing stands in it, or there is none.
    #[inline(always)]
    pub(crate) const fn is_empty(self) -> bool {
        self.length == 0
    }
}

/// The last `length` characters of `head`.
#[inline(always)]
pub(crate) fn last(head: &[u8], length: usize) -> &[u8] {
    head.get(head.len().wrapping_sub(length)..).unwrap_or(&[])
}

/// One bit a byte that is a comma of up to 64 bytes from `start` on, and the exclusive-or of their words.
#[inline(always)]
fn block(body: &[u8], start: usize) -> (u64, u64) {
    let block = &body[start..];
    let (words, rest) = block[..block.len().min(64)].as_chunks::<8>();
    let (mut others, mut xor, mut count) = (u64::MAX, 0, words.len());
    for word in words {
        let word = u64::from_le_bytes(*word);
        xor ^= word;
        others = others << 8 | others_of(word);
    }
    if !rest.is_empty() {
        let word = last_bytes(body, rest.len());
        xor ^= word;
        others = others << 8 | others_of(word);
        count += 1;
    }
    // The first word came in first and stands on top.
    let commas = (!others << ((64 - count * 8) & 63)).swap_bytes();
    (commas, xor)
}

/// As [`block`], in one copy.
#[inline(never)]
fn block_apart(body: &[u8], start: usize) -> (u64, u64) {
    block(body, start)
}

/// The separators of a body of more than [`MAX_FIELDS`] bytes, whose first word is known, and the exclusive-or of the words behind.
#[cold]
#[inline(never)]
fn further(body: &[u8], first: u64) -> ([u64; 4], u64) {
    let mut separators = [first, 0, 0, 0];
    let mut xor = 0;
    for (n, bits) in separators.iter_mut().enumerate().skip(1) {
        if n * 64 < body.len() {
            let (commas, sum) = block_apart(body, n * 64);
            *bits = commas;
            xor ^= sum;
        }
    }
    let mut room = MAX_FIELDS;
    for word in &mut separators {
        while word.count_ones() as usize > room {
            *word &= !(1 << (63 - word.leading_zeros()));
        }
        room -= word.count_ones() as usize;
    }
    separators[(body.len() / 64) & 3] |= 1 << (body.len() & 63);
    (separators, xor)
}

/// The last `length` bytes (1 to 7) of `body`, the first in the lowest; zeros behind them.
#[inline(always)]
fn last_bytes(body: &[u8], length: usize) -> u64 {
    match body.last_chunk::<8>() {
        Some(last) => u64::from_le_bytes(*last) >> (((8 - length) * 8) & 63),
        None => body
            .iter()
            .rev()
            .fold(0, |word, &b| word << 8 | u64::from(b)),
    }
}

/// One bit a byte of `word` that is no comma, the first byte in the lowest bit.
#[inline(always)]
const fn others_of(word: u64) -> u64 {
    const COMMAS: u64 = u64::from_ne_bytes([b','; 8]);
    const LOW7: u64 = u64::from_ne_bytes([0x7f; 8]);
    const HIGH: u64 = u64::from_ne_bytes([0x80; 8]);
    let y = word ^ COMMAS;
    let found = (((y & LOW7) + LOW7) | y) & HIGH;
    // Gathers the highest bits of the bytes in the highest byte.
    found.wrapping_mul(0x0002_0408_1020_4081) >> 56
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn finds_what_a_plain_loop_finds() {
        let text = b"EIHTC,V,,,T,R,,,0.35,,,280.0,\xac,T,C,,";
        for length in 0..=text.len() {
            let body = &text[..length];
            let (fields, xor) = FieldList::scan(body);
            assert_eq!(xor, body.iter().fold(0, |x, b| x ^ b));
            let plain: alloc::vec::Vec<&[u8]> = body.split(|&b| b == b',').skip(1).collect();
            assert_eq!(fields.iter().collect::<alloc::vec::Vec<_>>(), plain);
        }
    }

    #[test]
    fn a_line_of_commas_is_bounded() {
        let (fields, _) = FieldList::scan(&[b','; LONGEST_BODY]);
        assert_eq!(fields.len(), MAX_FIELDS);
    }

    #[test]
    fn fields_behind_the_last_are_empty() {
        for length in 0..=LONGEST_BODY {
            for every in [1, 2, 7, 70, 300] {
                let body: alloc::vec::Vec<u8> = (0..length)
                    .map(|i| if i % every == every - 1 { b',' } else { b'1' })
                    .collect();
                let (fields, _) = FieldList::scan(&body);
                for at in (fields.len()..300).chain([usize::MAX - 1]) {
                    assert_eq!(fields.at(at), b"");
                }
                let plain: alloc::vec::Vec<_> = body
                    .splitn(MAX_FIELDS + 1, |&b| b == b',')
                    .skip(1)
                    .collect();
                assert_eq!(fields.iter().collect::<alloc::vec::Vec<_>>(), plain);
                assert_eq!(Some(fields.address()), body.split(|&b| b == b',').next());
                for (at, field) in plain.iter().enumerate() {
                    assert_eq!(fields.at(at), *field);
                }
            }
        }
    }
}

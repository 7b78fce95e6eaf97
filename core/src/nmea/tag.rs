//! TAG blocks (NMEA 4.x, IEC 61162-450): `\c:1700000000,s:AG0001*hh\` before a sentence.

use super::value::hex_byte;
use alloc::string::String;

/// The TAG block before a sentence. Its checksum is advisory: it never decides about the sentence.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct TagBlock<'a> {
    parameters: &'a [u8],
    /// Whether its own checksum is right.
    pub right: bool,
}

/// Place of a sentence in a group: its number, how many there are, and the group's code.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct TagGroup {
    /// Which sentence of the group, from 1.
    pub number: u32,
    /// How many there are.
    pub total: u32,
    /// The group's code.
    pub code: u32,
}

impl<'a> TagBlock<'a> {
    /// Takes the TAG blocks at the start of a line; what follows is the sentence.
    #[inline(never)]
    pub(crate) fn take(line: &'a [u8]) -> (Option<Self>, &'a [u8]) {
        let mut rest = line;
        let mut found = None;
        while let Some(inside) = rest.strip_prefix(b"\\") {
            let Some(end) = inside.iter().position(|&b| b == b'\\') else {
                break;
            };
            let block = &inside[..end];
            let (parameters, given) = match block {
                [parameters @ .., b'*', high, low] => (parameters, hex_byte(&[*high, *low])),
                _ => (block, None),
            };
            let computed = parameters.iter().fold(0, |sum, b| sum ^ b);
            if found.is_none() {
                found = Some(Self {
                    parameters,
                    right: given == Some(computed),
                });
            }
            rest = &inside[end + 1..];
        }
        (found, rest)
    }

    /// The value of a parameter, such as `b's'`; commas part first, then the first colon.
    #[must_use]
    pub fn parameter(&self, code: u8) -> Option<&'a [u8]> {
        self.parameters
            .split(|&b| b == b',')
            .find_map(|part| match part {
                [name, b':', value @ ..] if *name == code => Some(value),
                _ => None,
            })
    }

    /// Its parameters as text.
    #[must_use]
    pub fn text(&self) -> String {
        self.parameters.iter().map(|&b| char::from(b)).collect()
    }

    /// Its time in seconds since 1970: seconds, milliseconds or seconds with decimals.
    #[must_use]
    pub fn time(&self) -> Option<f64> {
        let time = super::Decimal::parse(self.parameter(b'c')?)?.value();
        if time < 0.0 {
            None
        } else if time >= 1e11 {
            Some(time / 1000.0)
        } else {
            Some(time)
        }
    }

    /// Its source (`s`).
    #[must_use]
    pub fn source(&self) -> Option<String> {
        Some(super::value::unescape(self.parameter(b's')?))
    }

    /// Its destination (`d`).
    #[must_use]
    pub fn destination(&self) -> Option<String> {
        Some(super::value::unescape(self.parameter(b'd')?))
    }

    /// Its line count (`n`).
    #[must_use]
    pub fn line_count(&self) -> Option<u32> {
        integer(self.parameter(b'n')?)
    }

    /// Its relative time (`r`).
    #[must_use]
    pub fn relative_time(&self) -> Option<f64> {
        super::Decimal::parse(self.parameter(b'r')?).map(super::Decimal::value)
    }

    /// Its free text (`t`).
    #[must_use]
    pub fn free_text(&self) -> Option<String> {
        Some(super::value::unescape(self.parameter(b't')?))
    }

    /// Its group, `g:1-2-1234`, or in the other notation `1G2:1234`.
    #[must_use]
    pub fn group(&self) -> Option<TagGroup> {
        if let Some(group) = self.parameter(b'g') {
            let mut parts = group.splitn(3, |&b| b == b'-');
            let (number, total, code) = (parts.next()?, parts.next()?, parts.next()?);
            return Some(TagGroup {
                number: integer(number)?,
                total: integer(total)?,
                code: integer(code)?,
            });
        }
        self.parameters.split(|&b| b == b',').find_map(|part| {
            let colon = part.iter().position(|&b| b == b':')?;
            let letter = part.iter().position(|&b| b == b'G')?;
            Some(TagGroup {
                number: integer(part.get(..letter)?)?,
                total: integer(part.get(letter + 1..colon)?)?,
                code: integer(&part[colon + 1..])?,
            })
        })
    }
}

fn integer(digits: &[u8]) -> Option<u32> {
    if digits.is_empty() || digits.len() > 9 {
        return None;
    }
    digits.iter().try_fold(0u32, |sum, &b| {
        b.is_ascii_digit().then(|| sum * 10 + u32::from(b - b'0'))
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    fn block(parameters: &str) -> (bool, Option<f64>, Option<TagGroup>) {
        let line = alloc::format!("\\{parameters}\\$GPGLL");
        let (tag, rest) = TagBlock::take(line.as_bytes());
        assert_eq!(rest, b"$GPGLL");
        let tag = tag.expect("a block");
        (tag.right, tag.time(), tag.group())
    }

    #[test]
    fn parameters_are_read() {
        assert_eq!(block("c:1700000000*5E").1, Some(1_700_000_000.0));
        assert_eq!(block("c:1700000000123").1, Some(1_700_000_000.123));
        assert_eq!(block("s:AG0001,c:1700000000.5").1, Some(1_700_000_000.5));
        let group = Some(TagGroup {
            number: 1,
            total: 2,
            code: 34,
        });
        assert_eq!(block("g:1-2-34,s:r3669961").2, group);
        assert_eq!(block("1G2:34").2, group);
        assert!(!block("c:1*00").0);
    }

    #[test]
    fn an_open_block_is_no_block() {
        assert_eq!(TagBlock::take(b"\\c:1"), (None, b"\\c:1".as_slice()));
    }
}

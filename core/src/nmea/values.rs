//! The values of a decoded sentence, written again: a canonical line comes back byte for byte.

use super::decimal::Decimal;
use super::encode::{checksum, hex_digits_of, text};
use super::table::{Kind, Sides};
use super::value::Value;
use super::{Item, Sentence};
use alloc::string::String;
use alloc::vec::Vec;

/// The typed values of a sentence, ready to be written again as often as wanted.
///
/// ```
/// use wheelover_core::nmea::{decode, Values};
/// let sentence = decode(b"$HEHDT,216.80,T*12");
/// let values = Values::of(&sentence).expect("a known sentence");
/// let mut port = Vec::new();
/// values.write(&mut port);
/// assert_eq!(port, b"$HEHDT,216.80,T*12");
/// ```
#[derive(Clone, Debug)]
pub struct Values<'a> {
    delimiter: u8,
    /// The address, with the sub-address where there is one.
    head: &'a str,
    /// What the fields behind it hold.
    fields: Vec<Content<'a>>,
    /// Room for the longest line that they may become.
    room: usize,
}

/// What one field holds.
#[derive(Clone, Copy, Debug)]
enum Content<'a> {
    /// Nothing.
    Null,
    /// A number with the sign that it has.
    Number(Decimal),
    /// The letter of a code, a unit, a reference or a side.
    Letter(u8),
    /// A text as it stood.
    Text(&'a [u8]),
    /// A number in hexadecimal digits, as many as its whole digits.
    Hex(Decimal),
}

impl Content<'_> {
    /// The most characters that it takes with its comma.
    fn room(&self) -> usize {
        match self {
            Self::Null => 1,
            Self::Letter(_) => 2,
            Self::Text(text) => 1 + text.len(),
            // A sign, the point, and digits that may be more than those that were read.
            Self::Number(number) | Self::Hex(number) => {
                3 + usize::from(number.whole().max(20)) + usize::from(number.scale())
            }
        }
    }
}

impl<'a> Values<'a> {
    /// All values of a decoded sentence; none where its formatter is unknown.
    #[must_use]
    pub fn of(sentence: &Sentence<'a>) -> Option<Self> {
        let definition = sentence.known?;
        // A sub-address, such as the `001` of `PNEY,001`, is part of the formatter.
        let (head, count) = match definition.first() {
            0 => (sentence.address(), sentence.fields.len()),
            first => (
                sentence.formatter,
                sentence.fields.len().saturating_sub(first),
            ),
        };
        let mut fields = Vec::with_capacity(count + 4);
        sentence.visit(
            &mut |item| member(&item, sentence, &mut fields),
            &mut Vec::new(),
        );
        // A line that ends inside a member, and one that goes on behind the last.
        fields.resize(count, Content::Null);
        let room = fields
            .iter()
            .fold(head.len(), |sum, content| sum + content.room());
        Some(Self {
            delimiter: definition.delimiter,
            head,
            fields,
            room: room + Pen::SPARE,
        })
    }

    /// Appends the line with its checksum, without CR LF; faulty fields are empty.
    pub fn write(&self, out: &mut Vec<u8>) {
        let start = out.len();
        out.resize(start + self.room, 0);
        let mut pen = Pen {
            line: out.get_mut(start..).unwrap_or_default(),
            at: 0,
            sum: 0,
        };
        pen.byte(self.delimiter);
        // The delimiter is no part of the sum.
        pen.sum = 0;
        pen.text(self.head.as_bytes());
        for content in &self.fields {
            match content {
                Content::Null => pen.byte(b','),
                Content::Letter(letter) => pen.pair(b',', *letter),
                Content::Number(number) => pen.number(*number),
                Content::Text(text) => {
                    pen.byte(b',');
                    pen.text(text);
                }
                Content::Hex(number) => {
                    pen.byte(b',');
                    hex_digits_of(number.mantissa(), number.whole(), |digit| pen.byte(digit));
                }
            }
        }
        let end = start + pen.close();
        out.truncate(end);
    }
}

/// What the fields of a member hold.
fn member<'a>(item: &Item<'a>, sentence: &Sentence<'a>, fields: &mut Vec<Content<'a>>) {
    // A letter that was left out stays out, a side without a magnitude stays.
    let letter = |offset: usize, allowed: &[u8]| match sentence.fields.get(item.field + offset) {
        [letter] if allowed.contains(letter) => Content::Letter(*letter),
        _ => Content::Null,
    };
    let side = |offset, sides: Sides| letter(offset, &[sides.negative, sides.positive]);
    let magnitude = |value| match value {
        Value::Number(number) => Content::Number(number.without_sign()),
        _ => Content::Null,
    };
    match *item.kind {
        Kind::Lettered(_, unit) => fields.extend([content(item.value), letter(1, &[unit])]),
        Kind::Sided(_, sides) => fields.extend([magnitude(item.value), side(1, sides)]),
        Kind::Crossed(_, sides, unit) => {
            fields.extend([magnitude(item.value), side(1, sides), letter(2, &[unit])]);
        }
        Kind::Position(_) => match item.value {
            Value::Position(latitude, longitude) => {
                fields.extend(half(latitude, b'N', b'S'));
                fields.extend(half(longitude, b'E', b'W'));
            }
            _ => fields.extend([Content::Null; 4]),
        },
        Kind::Angle { degrees, .. } => match item.value {
            Value::Angle(angle) if degrees == 2 => fields.extend(half(angle, b'N', b'S')),
            Value::Angle(angle) => fields.extend(half(angle, b'E', b'W')),
            _ => fields.extend([Content::Null; 2]),
        },
        Kind::Hex(_) => fields.push(match item.value {
            Value::Number(number) => Content::Hex(number),
            _ => Content::Null,
        }),
        _ => fields.push(content(item.value)),
    }
}

fn half<'a>(angle: Decimal, positive: u8, negative: u8) -> [Content<'a>; 2] {
    let side = if angle.negative() { negative } else { positive };
    [Content::Number(angle.without_sign()), Content::Letter(side)]
}

fn content(value: Value<'_>) -> Content<'_> {
    match value {
        Value::Number(number) | Value::Time(number) | Value::Date(number) => {
            Content::Number(number)
        }
        Value::Code(letter) => Content::Letter(letter),
        Value::Text(text) => Content::Text(text),
        Value::Null | Value::Invalid | Value::Position(..) | Value::Angle(_) => Content::Null,
    }
}

/// Writes into a line that is long enough, and sums up what it writes.
struct Pen<'o> {
    line: &'o mut [u8],
    at: usize,
    /// The exclusive-or of all bytes, in eight lanes.
    sum: u64,
}

impl Pen<'_> {
    /// Room behind the line: delimiter, checksum, and whole words written for a few characters.
    const SPARE: usize = 4 + 24;

    #[inline(always)]
    fn byte(&mut self, byte: u8) {
        if let Some(place) = self.line.get_mut(self.at) {
            *place = byte;
        }
        self.at += 1;
        self.sum ^= u64::from(byte);
    }

    #[inline(always)]
    fn pair(&mut self, first: u8, second: u8) {
        if let Some(place) = self.line.get_mut(self.at..self.at + 2) {
            place.copy_from_slice(&[first, second]);
        }
        self.at += 2;
        self.sum ^= u64::from(first ^ second);
    }

    #[inline(always)]
    fn text(&mut self, text: &[u8]) {
        let (words, rest) = text.as_chunks::<8>();
        for word in words {
            if let Some(place) = self.line.get_mut(self.at..self.at + 8) {
                place.copy_from_slice(word);
            }
            self.at += 8;
            self.sum ^= u64::from_le_bytes(*word);
        }
        for byte in rest {
            self.byte(*byte);
        }
    }

    /// A comma and a number.
    #[inline(always)]
    fn number(&mut self, number: Decimal) {
        if let Some(place) = self
            .line
            .get_mut(self.at..)
            .and_then(<[u8]>::first_chunk_mut)
            && let Some((length, sum)) = number.write_short(place)
        {
            self.at += length;
            self.sum ^= sum;
        } else {
            self.long_number(number);
        }
    }

    #[inline(never)]
    fn long_number(&mut self, number: Decimal) {
        self.byte(b',');
        if let Some(sign) = number.sign() {
            self.byte(sign);
        }
        if let Some((packed, length)) = number.packed() {
            if let Some(place) = self.line.get_mut(self.at..self.at + 16) {
                place.copy_from_slice(&packed.to_le_bytes());
            }
            self.at += length;
            self.sum ^= packed as u64 ^ (packed >> 64) as u64;
        } else {
            let mut digits = Vec::new();
            number.write(&mut digits, true);
            self.text(&digits);
        }
    }

    /// Ends the line with its checksum; says how long it is.
    #[inline(always)]
    fn close(self) -> usize {
        let sum = checksum(self.sum);
        if let Some(place) = self.line.get_mut(self.at..self.at + 3) {
            place.copy_from_slice(&sum);
        }
        self.at + 3
    }
}

/// Encodes the values of a decoded sentence again, with as many fields as it had.
///
/// A canonical line comes back byte for byte; faulty fields come back empty. None where the formatter is unknown.
///
/// ```
/// use wheelover_core::nmea::{decode, encode};
/// let line = "$AGRSA,03.2,A,,V*4E";
/// assert_eq!(encode(&decode(line.as_bytes())).as_deref(), Some(line));
/// // Another checksum, another field: what is wrong is left out.
/// assert_eq!(encode(&decode(b"$AGRSA,wrong,A,,V*00")).as_deref(), Some("$AGRSA,,A,,V*51"));
/// ```
#[must_use]
pub fn encode(sentence: &Sentence<'_>) -> Option<String> {
    let mut out = Vec::with_capacity(96);
    Values::of(sentence)?.write(&mut out);
    Some(text(out))
}

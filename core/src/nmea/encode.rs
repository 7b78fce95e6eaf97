//! Encoding: the mirror of reading. Decimals by the table (SEN-9), null stays null, never over 82 characters.

use super::decimal::Decimal;
use super::table::{Definition, Format, Kind, Sides};
use super::value::{Value, degrees_and_minutes};
use super::{Item, Sentence};
use crate::geo::Position;
use alloc::string::String;
use alloc::vec::Vec;

/// What a member is written from.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Cell<'a> {
    /// An empty field.
    Null,
    /// A number to be rounded to the decimals of the table.
    Float(f64),
    /// A whole number.
    Integer(u32),
    /// The letter of a code.
    Letter(u8),
    /// A text to be escaped.
    Str(&'a str),
    /// A position to be rounded.
    Position(Position),
    /// A value as it was read; written as it was.
    Value(Value<'a>),
}

/// Writes a sentence member by member, in the order of its table.
pub(crate) struct Writer<'o> {
    definition: &'static Definition,
    members: core::slice::Iter<'static, Kind>,
    out: &'o mut Vec<u8>,
    start: usize,
    fields: usize,
    wanted: usize,
}

const HEX: &[u8; 16] = b"0123456789ABCDEF";

impl<'o> Writer<'o> {
    /// Begins a line at the end of `out`.
    pub(crate) fn new(out: &'o mut Vec<u8>, definition: &'static Definition, talker: &str) -> Self {
        let start = out.len();
        out.push(definition.delimiter);
        if definition.first() == 0 {
            out.extend_from_slice(talker.as_bytes());
        }
        out.extend_from_slice(definition.formatter.as_bytes());
        Self {
            definition,
            members: definition.members.iter(),
            out,
            start,
            fields: definition.first(),
            wanted: definition.sent(),
        }
    }

    /// Writes the next member.
    pub(crate) fn put(&mut self, cell: Cell<'_>) {
        if let Some(kind) = self.members.next() {
            self.member(kind, &cell);
        }
    }

    /// Begins an entry of the group.
    pub(crate) fn entry(&mut self) {
        self.members = self
            .definition
            .group
            .as_ref()
            .map_or([].iter(), |group| group.members.iter());
    }

    /// Begins the members after the group.
    pub(crate) fn tail(&mut self) {
        self.members = self.definition.tail.iter();
    }

    fn comma(&mut self) {
        self.out.push(b',');
        self.fields += 1;
    }

    fn member(&mut self, kind: &Kind, cell: &Cell<'_>) {
        self.comma();
        match kind {
            Kind::Number(format) | Kind::Integer(format) => self.number(format, cell, false),
            Kind::Lettered(format, letter) => {
                self.number(format, cell, false);
                self.comma();
                self.out.push(*letter);
            }
            Kind::Sided(format, sides) => self.sided(format, *sides, cell),
            Kind::Crossed(format, sides, letter) => {
                self.sided(format, *sides, cell);
                self.comma();
                self.out.push(*letter);
            }
            Kind::Position(decimals) => self.position(*decimals, cell),
            Kind::Angle { degrees, decimals } => self.angle(*degrees, *decimals, cell),
            Kind::Hex(digits) => self.hex(*digits, cell),
            Kind::Time | Kind::Date | Kind::Code(_) => self.plain(cell, 255),
            Kind::Text(limit) => self.plain(cell, *limit),
            Kind::Payload | Kind::Any => self.plain(cell, 255),
        }
    }

    fn number(&mut self, format: &Format, cell: &Cell<'_>, unsigned: bool) {
        if let Some(number) = decimal(format, cell) {
            number.write(self.out, unsigned);
        }
    }

    fn sided(&mut self, format: &Format, sides: Sides, cell: &Cell<'_>) {
        let number = decimal(format, cell);
        if let Some(number) = number {
            number.write(self.out, true);
        }
        self.comma();
        if let Some(number) = number {
            let side = if number.negative() {
                sides.negative
            } else {
                sides.positive
            };
            self.out.push(side);
        }
    }

    /// A fixed letter as it stood: there, or left out.
    fn letter(&mut self, raw: u8, letter: u8) {
        self.comma();
        if raw != 0 {
            self.out.push(letter);
        }
    }

    /// A side as it stood.
    fn side(&mut self, raw: u8, sides: Sides) {
        self.comma();
        if raw == sides.negative || raw == sides.positive {
            self.out.push(raw);
        }
    }

    fn position(&mut self, decimals: u8, cell: &Cell<'_>) {
        let (lat, lon) = match *cell {
            Cell::Value(Value::Position(lat, lon)) => (Some(lat), Some(lon)),
            Cell::Position(position) if libm::fabs(position.lat) <= 90.0 => (
                degrees_and_minutes(position.lat, 2, decimals),
                degrees_and_minutes(position.lon, 3, decimals),
            ),
            _ => (None, None),
        };
        let both = lat.zip(lon);
        self.half(both.map(|(lat, _)| lat), b'N', b'S');
        self.comma();
        self.half(both.map(|(_, lon)| lon), b'E', b'W');
    }

    fn angle(&mut self, digits: u8, decimals: u8, cell: &Cell<'_>) {
        let angle = match *cell {
            Cell::Value(Value::Angle(angle)) => Some(angle),
            Cell::Float(value) => degrees_and_minutes(value, digits, decimals),
            _ => None,
        };
        let (positive, negative) = if digits == 2 {
            (b'N', b'S')
        } else {
            (b'E', b'W')
        };
        self.half(angle, positive, negative);
    }

    fn half(&mut self, angle: Option<Decimal>, positive: u8, negative: u8) {
        if let Some(angle) = angle {
            angle.write(self.out, true);
        }
        self.comma();
        if let Some(angle) = angle {
            self.out
                .push(if angle.negative() { negative } else { positive });
        }
    }

    fn hex(&mut self, digits: u8, cell: &Cell<'_>) {
        let (number, digits) = match *cell {
            Cell::Integer(number) => (u64::from(number), digits),
            Cell::Value(Value::Number(number)) => (number.mantissa(), number.whole()),
            _ => return,
        };
        let needed = (64 - number.leading_zeros()).div_ceil(4) as u8;
        for i in (0..digits.max(needed).max(1)).rev() {
            let digit = number.checked_shr(u32::from(i) * 4).unwrap_or(0) & 15;
            self.out.push(HEX[digit as usize]);
        }
    }

    fn plain(&mut self, cell: &Cell<'_>, limit: u8) {
        match *cell {
            Cell::Letter(letter) | Cell::Value(Value::Code(letter)) => {
                self.out.push(letter);
            }
            Cell::Value(Value::Time(number) | Value::Date(number) | Value::Number(number)) => {
                number.write(self.out, false);
            }
            Cell::Value(Value::Text(text)) => self.out.extend_from_slice(text),
            Cell::Str(text) => self.escaped(text, limit),
            Cell::Integer(number) => {
                Decimal::new(false, u64::from(number), 0, 1).write(self.out, false)
            }
            Cell::Null | Cell::Float(_) | Cell::Position(_) | Cell::Value(_) => {}
        }
    }

    /// Reserved characters as `^hh`; what Latin-1 does not have as `?`; the rest of a text that is too long left out.
    fn escaped(&mut self, text: &str, limit: u8) {
        for c in text.chars().take(usize::from(limit)) {
            let byte = u8::try_from(u32::from(c)).unwrap_or(b'?');
            match byte {
                b',' | b'*' | b'\\' | b'!' | b'^' | b'~' | b'$' | 0..=0x1f | 0x7f..=0xff => {
                    self.out.push(b'^');
                    self.out.push(HEX[usize::from(byte >> 4)]);
                    self.out.push(HEX[usize::from(byte & 15)]);
                }
                _ => self.out.push(byte),
            }
        }
    }

    /// Ends the line with its checksum, without CR LF.
    pub(crate) fn finish(self) {
        if self.definition.group.is_none() {
            let missing = self.wanted.saturating_sub(self.fields);
            self.out.resize(self.out.len() + missing, b',');
            for _ in self.wanted..self.fields {
                if self.out.last() == Some(&b',') {
                    self.out.pop();
                }
            }
        }
        close(self.out, self.start);
    }
}

/// Adds the checksum to the line that begins with `$` or `!` at `start`.
fn close(out: &mut Vec<u8>, start: usize) {
    let (words, rest) = out[(start + 1).min(out.len())..].as_chunks::<8>();
    let wide = words
        .iter()
        .fold(0, |sum, word| sum ^ u64::from_ne_bytes(*word));
    let sum = wide
        .to_ne_bytes()
        .iter()
        .chain(rest)
        .fold(0, |sum, b| sum ^ b);
    out.extend_from_slice(&[b'*', HEX[usize::from(sum >> 4)], HEX[usize::from(sum & 15)]]);
}

/// A line as text: ISO 8859-1.
pub(crate) fn text(out: Vec<u8>) -> String {
    if out.is_ascii() {
        String::from_utf8(out).unwrap_or_default()
    } else {
        super::explain::latin1(&out)
    }
}

/// `body`, the characters between `$` and `*`, as a line with its checksum, without CR LF.
#[must_use]
pub fn with_checksum(body: &str) -> String {
    let mut out = Vec::with_capacity(body.len() + 4);
    if !body.starts_with(['$', '!']) {
        out.push(b'$');
    }
    // A line is ISO 8859-1.
    out.extend(
        body.chars()
            .map(|c| u8::try_from(u32::from(c)).unwrap_or(b'?')),
    );
    close(&mut out, 0);
    super::explain::latin1(&out)
}

fn decimal(format: &Format, cell: &Cell<'_>) -> Option<Decimal> {
    match *cell {
        Cell::Float(value) => Decimal::from_f64(value, format.whole, format.decimals),
        Cell::Integer(value) => Some(Decimal::new(false, u64::from(value), 0, format.whole)),
        Cell::Value(Value::Number(number)) => Some(number),
        _ => None,
    }
}

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
    definition: &'static Definition,
    address: &'a str,
    talker: &'a str,
    /// Fields that are written.
    count: usize,
    items: Vec<(&'static Kind, Cell<'a>, [u8; 2])>,
}

impl<'a> Values<'a> {
    /// All values of a decoded sentence; none where its formatter is unknown.
    #[must_use]
    pub fn of(sentence: &Sentence<'a>) -> Option<Self> {
        let mut items = Vec::with_capacity(16);
        sentence.visit(
            &mut |item: Item<'a>| {
                // Letters behind a magnitude; 0 where there is none.
                let raw = |offset: usize| match sentence.fields.get(item.field + offset) {
                    [letter] => *letter,
                    [] => 0,
                    _ => b'?',
                };
                let cell = if item.value.is_null() {
                    Cell::Null
                } else {
                    Cell::Value(item.value)
                };
                items.push((item.kind, cell, [raw(1), raw(2)]));
            },
            &mut Vec::new(),
        );
        Some(Self {
            definition: sentence.known?,
            address: sentence.address,
            talker: sentence.talker,
            count: sentence.fields.len(),
            items,
        })
    }

    /// Appends the line with its checksum, without CR LF; faulty fields are empty.
    pub fn write(&self, out: &mut Vec<u8>) {
        let mut writer = Writer::new(out, self.definition, self.talker);
        if self.definition.formatter.len() == 1 {
            writer.out.truncate(writer.start + 1);
            writer.out.extend_from_slice(self.address.as_bytes());
        }
        for (kind, cell, raw) in &self.items {
            match kind {
                // A letter that was left out stays out; a side without a magnitude stays.
                Kind::Lettered(format, letter) => {
                    writer.comma();
                    writer.number(format, cell, false);
                    writer.letter(raw[0], *letter);
                }
                Kind::Sided(format, sides) => {
                    writer.comma();
                    writer.number(format, cell, true);
                    writer.side(raw[0], *sides);
                }
                Kind::Crossed(format, sides, letter) => {
                    writer.comma();
                    writer.number(format, cell, true);
                    writer.side(raw[0], *sides);
                    writer.letter(raw[1], *letter);
                }
                kind => writer.member(kind, cell),
            }
        }
        // A line that ends inside a member, or behind the last one.
        for _ in self.count..writer.fields {
            let comma = writer.out.iter().rposition(|&b| b == b',');
            writer.out.truncate(comma.unwrap_or(writer.out.len()));
        }
        let missing = self.count.saturating_sub(writer.fields);
        writer.out.resize(writer.out.len() + missing, b',');
        let start = writer.start;
        close(out, start);
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

//! Encoding: the mirror of reading. Decimals by the table (SEN-9), null stays null, never over 82 characters.

use super::decimal::Decimal;
use super::table::{Definition, Format, Kind, Sides};
use super::value::{Value, degrees_and_minutes, latin1};
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
            Kind::Number(format) | Kind::Integer(format) => self.number(format, cell),
            Kind::Lettered(format, letter) => {
                self.number(format, cell);
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
            Kind::Text(limit) | Kind::Letters(_, limit) => self.plain(cell, *limit),
            Kind::Words(_) | Kind::Payload | Kind::Any => self.plain(cell, 255),
        }
    }

    fn number(&mut self, format: &Format, cell: &Cell<'_>) {
        if let Some(number) = decimal(format, cell) {
            number.write(self.out, false);
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
        hex_digits_of(number, digits, |digit| self.out.push(digit));
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

/// The hexadecimal digits of a number, at least so many.
#[inline(always)]
pub(super) fn hex_digits_of(number: u64, digits: u8, mut put: impl FnMut(u8)) {
    let needed = (64 - number.leading_zeros()).div_ceil(4) as u8;
    for i in (0..digits.max(needed).max(1)).rev() {
        let digit = number.checked_shr(u32::from(i) * 4).unwrap_or(0) & 15;
        put(HEX[digit as usize]);
    }
}

/// `*` and the two digits of an exclusive-or, whose lanes are still apart.
#[inline(always)]
pub(super) fn checksum(lanes: u64) -> [u8; 3] {
    let sum = lanes.to_ne_bytes().iter().fold(0, |sum, b| sum ^ b);
    [b'*', HEX[usize::from(sum >> 4)], HEX[usize::from(sum & 15)]]
}

/// Adds the checksum to the line that begins with `$` or `!` at `start`.
fn close(out: &mut Vec<u8>, start: usize) {
    let (words, rest) = out[(start + 1).min(out.len())..].as_chunks::<8>();
    let lanes = words
        .iter()
        .map(|word| u64::from_ne_bytes(*word))
        .chain(rest.iter().map(|byte| u64::from(*byte)))
        .fold(0, |sum, lane| sum ^ lane);
    out.extend_from_slice(&checksum(lanes));
}

/// A line as text: ISO 8859-1.
pub(crate) fn text(out: Vec<u8>) -> String {
    if out.is_ascii() {
        String::from_utf8(out).unwrap_or_default()
    } else {
        latin1(&out)
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
    latin1(&out)
}

fn decimal(format: &Format, cell: &Cell<'_>) -> Option<Decimal> {
    match *cell {
        Cell::Float(value) => Decimal::from_f64(value, format.whole, format.decimals),
        Cell::Integer(value) => Some(Decimal::new(false, u64::from(value), 0, format.whole)),
        Cell::Value(Value::Number(number)) => Some(number),
        _ => None,
    }
}

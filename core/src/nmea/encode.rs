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
pub(crate) struct Writer {
    definition: &'static Definition,
    members: core::slice::Iter<'static, Kind>,
    out: String,
    fields: usize,
    wanted: usize,
}

const HEX: &[u8; 16] = b"0123456789ABCDEF";

impl Writer {
    pub(crate) fn new(definition: &'static Definition, talker: &str) -> Self {
        let mut out = String::with_capacity(84);
        out.push(char::from(definition.delimiter));
        if definition.first() == 0 {
            out.push_str(talker);
        }
        out.push_str(definition.formatter);
        Self {
            definition,
            members: definition.members.iter(),
            out,
            fields: definition.first(),
            wanted: definition.sent(),
        }
    }

    /// Writes the next member.
    pub(crate) fn put(&mut self, cell: Cell<'_>) {
        if let Some(kind) = self.members.next() {
            self.member(kind, cell);
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
        self.out.push(',');
        self.fields += 1;
    }

    fn member(&mut self, kind: &Kind, cell: Cell<'_>) {
        self.comma();
        match kind {
            Kind::Number(format) | Kind::Integer(format) => self.number(*format, cell, false),
            Kind::Lettered(format, letter) => {
                self.number(*format, cell, false);
                self.comma();
                self.out.push(char::from(*letter));
            }
            Kind::Sided(format, sides) => self.sided(*format, *sides, cell),
            Kind::Crossed(format, sides, letter) => {
                self.sided(*format, *sides, cell);
                self.comma();
                self.out.push(char::from(*letter));
            }
            Kind::Position(decimals) => self.position(*decimals, cell),
            Kind::Angle { degrees, decimals } => self.angle(*degrees, *decimals, cell),
            Kind::Hex(digits) => self.hex(*digits, cell),
            Kind::Time | Kind::Date | Kind::Code(_) => self.plain(cell, 255),
            Kind::Text(limit) => self.plain(cell, *limit),
            Kind::Payload | Kind::Any => self.plain(cell, 255),
        }
    }

    fn number(&mut self, format: Format, cell: Cell<'_>, unsigned: bool) {
        if let Some(number) = decimal(format, cell) {
            number.write(&mut self.out, unsigned);
        }
    }

    fn sided(&mut self, format: Format, sides: Sides, cell: Cell<'_>) {
        let number = decimal(format, cell);
        if let Some(number) = number {
            number.write(&mut self.out, true);
        }
        self.comma();
        if let Some(number) = number {
            let side = if number.negative() {
                sides.negative
            } else {
                sides.positive
            };
            self.out.push(char::from(side));
        }
    }

    fn position(&mut self, decimals: u8, cell: Cell<'_>) {
        let (lat, lon) = match cell {
            Cell::Value(Value::Position(lat, lon)) => (Some(lat), Some(lon)),
            Cell::Position(position) if libm::fabs(position.lat) <= 90.0 => (
                degrees_and_minutes(position.lat, 2, decimals),
                degrees_and_minutes(position.lon, 3, decimals),
            ),
            _ => (None, None),
        };
        let both = lat.zip(lon);
        self.half(both.map(|(lat, _)| lat), 'N', 'S');
        self.comma();
        self.half(both.map(|(_, lon)| lon), 'E', 'W');
    }

    fn angle(&mut self, digits: u8, decimals: u8, cell: Cell<'_>) {
        let angle = match cell {
            Cell::Value(Value::Angle(angle)) => Some(angle),
            Cell::Float(value) => degrees_and_minutes(value, digits, decimals),
            _ => None,
        };
        let (positive, negative) = if digits == 2 { ('N', 'S') } else { ('E', 'W') };
        self.half(angle, positive, negative);
    }

    fn half(&mut self, angle: Option<Decimal>, positive: char, negative: char) {
        if let Some(angle) = angle {
            angle.write(&mut self.out, true);
        }
        self.comma();
        if let Some(angle) = angle {
            self.out
                .push(if angle.negative() { negative } else { positive });
        }
    }

    fn hex(&mut self, digits: u8, cell: Cell<'_>) {
        let (number, digits) = match cell {
            Cell::Integer(number) => (u64::from(number), digits),
            Cell::Value(Value::Number(number)) => (number.mantissa(), number.whole()),
            _ => return,
        };
        let needed = (64 - number.leading_zeros()).div_ceil(4) as u8;
        for i in (0..digits.max(needed).max(1)).rev() {
            let digit = number.checked_shr(u32::from(i) * 4).unwrap_or(0) & 15;
            self.out.push(char::from(HEX[digit as usize]));
        }
    }

    fn plain(&mut self, cell: Cell<'_>, limit: u8) {
        match cell {
            Cell::Letter(letter) | Cell::Value(Value::Code(letter)) => {
                self.out.push(char::from(letter));
            }
            Cell::Value(Value::Time(number) | Value::Date(number) | Value::Number(number)) => {
                number.write(&mut self.out, false);
            }
            // Bytes stay bytes: the line is Latin-1 in the end.
            Cell::Value(Value::Text(text)) => self.out.extend(text.iter().map(|&b| char::from(b))),
            Cell::Str(text) => self.escaped(text, limit),
            Cell::Integer(number) => {
                Decimal::new(false, u64::from(number), 0, 1).write(&mut self.out, false)
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
                    self.out.push('^');
                    self.out.push(char::from(HEX[usize::from(byte >> 4)]));
                    self.out.push(char::from(HEX[usize::from(byte & 15)]));
                }
                _ => self.out.push(char::from(byte)),
            }
        }
    }

    /// The line with its checksum, without CR LF.
    pub(crate) fn finish(mut self) -> String {
        while self.definition.group.is_none() && self.fields < self.wanted {
            self.comma();
        }
        while self.definition.group.is_none()
            && self.fields > self.wanted
            && self.out.ends_with(',')
        {
            self.out.pop();
            self.fields -= 1;
        }
        close(self.out)
    }
}

/// Adds the checksum to a line that begins with `$` or `!`.
fn close(mut out: String) -> String {
    let sum = out
        .chars()
        .skip(1)
        .fold(0u8, |sum, c| sum ^ u32::from(c) as u8);
    out.push('*');
    out.push(char::from(HEX[usize::from(sum >> 4)]));
    out.push(char::from(HEX[usize::from(sum & 15)]));
    out
}

/// `body`, the characters between `$` and `*`, as a line with its checksum, without CR LF.
#[must_use]
pub fn with_checksum(body: &str) -> String {
    let mut out = String::with_capacity(body.len() + 4);
    if !body.starts_with(['$', '!']) {
        out.push('$');
    }
    out.push_str(body);
    close(out)
}

fn decimal(format: Format, cell: Cell<'_>) -> Option<Decimal> {
    match cell {
        Cell::Float(value) => Decimal::from_f64(value, format.whole, format.decimals),
        Cell::Integer(value) => Some(Decimal::new(false, u64::from(value), 0, format.whole)),
        Cell::Value(Value::Number(number)) => Some(number),
        _ => None,
    }
}

/// Encodes the values of a decoded sentence again, with as many fields as it had.
///
/// A canonical line comes back byte for byte; faulty fields come back empty. None where the formatter is unknown.
#[must_use]
pub fn encode(sentence: &Sentence<'_>) -> Option<String> {
    let definition = sentence.known?;
    let mut writer = Writer::new(definition, sentence.talker);
    if definition.formatter.len() == 1 {
        writer.out.truncate(1);
        writer.out.push_str(sentence.address);
    }
    let mut faults = Vec::new();
    sentence.walk(
        |item: Item<'_>| {
            let cell = if item.value.is_null() {
                Cell::Null
            } else {
                Cell::Value(item.value)
            };
            writer.member(item.kind, cell);
        },
        &mut faults,
    );
    writer.wanted = sentence.fields.len();
    let over = writer.fields.saturating_sub(writer.wanted);
    for _ in 0..over {
        if let Some(comma) = writer.out.rfind(',') {
            writer.out.truncate(comma);
            writer.fields -= 1;
        }
    }
    while writer.fields < writer.wanted {
        writer.comma();
    }
    Some(close(writer.out))
}

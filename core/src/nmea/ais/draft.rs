//! The way back: values by name become a payload, by the same tables.

use super::bits::Bits;
use super::fault::{MessageFault, MessageFaultKind};
use super::field::{Field, Item, Kind, NEVER, NO_INDICATOR, Scale, rate_of_turn};
use super::message::RadioMessage;
use super::tables::{HEADER, layout};
use super::value::Value;
use super::walk::auxiliary;
use alloc::string::{String, ToString};
use alloc::vec::Vec;

/// Values of a message that is to be sent. What is not set is "not available", or 0.
///
/// ```
/// use wheelover_core::nmea::ais::Draft;
/// let draft = Draft::new(14).with("mmsi", 351_809_000).with("text", "RCVD YR TEST MSG");
/// assert_eq!(draft.payload(), Ok((">5?Per18=HB1U:1@E=B0m<L".into(), 2)));
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Draft {
    kind: u8,
    values: Vec<(String, usize, Input)>,
}

/// A value that is set.
#[derive(Clone, Debug, PartialEq)]
pub enum Input {
    /// Not available.
    Null,
    /// A number in the field's unit, or a code.
    Number(f64),
    /// At least so much: the last step of the scale.
    AtLeast(f64),
    /// Whether something is so.
    Flag(bool),
    /// A text; six-bit characters have no small letters.
    Text(String),
    /// Data, and how many bits of it count.
    Binary(Vec<u8>, usize),
}

impl From<i32> for Input {
    fn from(value: i32) -> Self {
        Self::Number(value.into())
    }
}
impl From<f64> for Input {
    fn from(value: f64) -> Self {
        Self::Number(value)
    }
}
impl From<bool> for Input {
    fn from(value: bool) -> Self {
        Self::Flag(value)
    }
}
impl From<&str> for Input {
    fn from(value: &str) -> Self {
        Self::Text(value.into())
    }
}
impl From<Value<'_>> for Input {
    fn from(value: Value<'_>) -> Self {
        match value {
            Value::Null => Self::Null,
            Value::Integer(value) => Self::Number(value as f64),
            Value::Number(value) => Self::Number(value),
            Value::AtLeast(value) => Self::AtLeast(value),
            Value::Flag(flag) => Self::Flag(flag),
            Value::Text(text) => Self::Text(text.to_string()),
            Value::Binary(binary) => Self::Binary(binary.bytes().collect(), binary.len()),
        }
    }
}

impl Draft {
    /// A message of that type without values.
    #[must_use]
    pub const fn new(kind: u8) -> Self {
        Self {
            kind,
            values: Vec::new(),
        }
    }

    /// Sets a field.
    #[must_use]
    pub fn with(self, name: &str, value: impl Into<Input>) -> Self {
        self.with_entry(name, 0, value)
    }

    /// Sets a field of an entry of a list, from 1.
    #[must_use]
    pub fn with_entry(mut self, name: &str, entry: usize, value: impl Into<Input>) -> Self {
        self.values.push((name.into(), entry, value.into()));
        self
    }

    /// The values of a message.
    #[must_use]
    pub fn of(message: &RadioMessage<'_>) -> Self {
        let mut draft = Self::new(message.kind().unwrap_or(0));
        message.visit(
            &mut |entry| {
                if entry.name() != "type" {
                    let value = Input::from(entry.value);
                    draft.values.push((entry.name().into(), entry.entry, value));
                }
            },
            &mut Vec::new(),
        );
        draft
    }

    /// What is set for a field; null where nothing is.
    #[must_use]
    pub fn set(&self, name: &str, entry: usize) -> Input {
        self.value(name, entry).clone()
    }

    /// The armoured characters, and the fill bits of the last one.
    ///
    /// # Errors
    /// There is no such message type, or a value does not fit into its field.
    pub fn payload(&self) -> Result<(String, u8), MessageFault> {
        let layout = layout(self.kind).ok_or(MessageFault {
            field: None,
            kind: MessageFaultKind::UnknownType(self.kind),
        })?;
        let mut bits = Bits::new();
        self.items(HEADER, 0, &mut bits)?;
        self.items(layout.items, 0, &mut bits)?;
        // Messages end with a byte; data that are carried end where they end.
        if !self.values.iter().any(|(name, ..)| name == "data") {
            (0..bits.len().next_multiple_of(8) - bits.len()).for_each(|_| bits.put(0, 1));
        }
        Ok(bits.armour())
    }

    fn value(&self, name: &str, entry: usize) -> &Input {
        let found = self
            .values
            .iter()
            .find(|(n, e, _)| n == name && *e == entry);
        found.map_or(&Input::Null, |(.., value)| value)
    }

    fn number(&self, name: &str) -> u32 {
        match self.value(name, 0) {
            Input::Number(value) => *value as u32,
            Input::Flag(flag) => u32::from(*flag),
            _ => 0,
        }
    }

    fn items(
        &self,
        items: &'static [Item],
        entry: usize,
        bits: &mut Bits,
    ) -> Result<(), MessageFault> {
        for item in items {
            match item {
                Item::Field(field) => self.field(field, entry, bits)?,
                Item::Part(items) => self.items(items, entry, bits)?,
                Item::When(when, items) => {
                    if when.values >> (self.number(when.field) & 31) & 1 == 1 {
                        self.items(items, entry, bits)?;
                    }
                }
                Item::Auxiliary(are, items) => {
                    if auxiliary(self.number("mmsi")) == *are {
                        self.items(items, entry, bits)?;
                    }
                }
                Item::Longer(_, items) => {
                    if self.sets_any(items, 0) {
                        self.items(items, entry, bits)?;
                    }
                }
                Item::Each(_, most, _, items) => {
                    for entry in 1..=*most {
                        if entry == 1 || self.sets_any(items, entry) {
                            self.items(items, entry, bits)?;
                        }
                    }
                }
            }
        }
        Ok(())
    }

    /// Whether a field of a list has a value.
    fn sets_any(&self, items: &'static [Item], entry: usize) -> bool {
        items.iter().any(|item| match item {
            Item::Field(field) => *self.value(field.name, entry) != Input::Null,
            _ => false,
        })
    }

    fn field(
        &self,
        field: &'static Field,
        entry: usize,
        bits: &mut Bits,
    ) -> Result<(), MessageFault> {
        if field.name == "type" {
            bits.put(self.kind.into(), 6);
            return Ok(());
        }
        let wrong = Err(MessageFault {
            field: Some(field.name),
            kind: MessageFaultKind::OutOfRange,
        });
        match (&field.kind, self.value(field.name, entry)) {
            (Kind::Spare, _) => bits.put(0, field.width),
            (Kind::Text, Input::Text(text)) => {
                return put_text(text, field, bits).map_or(wrong, Ok);
            }
            (Kind::Text, Input::Null) => (0..field.width / 6).for_each(|_| bits.put(0, 6)),
            (Kind::Binary(_), Input::Binary(bytes, length)) => {
                for n in 0..(*length).min(bytes.len() * 8) {
                    bits.put(u32::from(bytes[n / 8] >> (7 - n % 8)), 1);
                }
            }
            (Kind::Binary(_), Input::Null) => {}
            (Kind::Flag, value) => {
                let set = matches!(value, Input::Flag(true)) || *value == Input::Number(1.0);
                bits.put(u32::from(set), 1);
            }
            (_, value) => match raw(field, value) {
                Some(raw) => bits.put(raw as u32, field.width),
                None => return wrong,
            },
        }
        Ok(())
    }
}

fn put_text(text: &str, field: &Field, bits: &mut Bits) -> Option<()> {
    let most = if field.width == 0 {
        161
    } else {
        field.width / 6
    };
    let length = text.chars().count();
    if length > most {
        return None;
    }
    for character in text.chars() {
        match character.to_ascii_uppercase() {
            character @ '@'..='_' => bits.put(character as u32 - 64, 6),
            character @ ' '..='?' => bits.put(character as u32, 6),
            _ => return None,
        }
    }
    (length..field.width / 6).for_each(|_| bits.put(0, 6));
    Some(())
}

/// The coded value of a number.
fn raw(field: &Field, value: &Input) -> Option<i32> {
    let most = if field.width < 32 {
        1i64 << field.width
    } else {
        i64::MAX
    };
    match (&field.kind, value) {
        (
            Kind::Whole(Scale { none: NEVER, .. })
            | Kind::Number(Scale { none: NEVER, .. })
            | Kind::Code(NEVER, _),
            Input::Null,
        ) => Some(0),
        (Kind::Whole(scale) | Kind::Number(scale), Input::Null) => Some(scale.none),
        (Kind::Code(none, _), Input::Null) => Some(*none),
        (Kind::Whole(scale) | Kind::Number(scale), Input::AtLeast(_)) if scale.top != NEVER => {
            Some(scale.top)
        }
        (Kind::Whole(scale) | Kind::Number(scale), Input::Number(value)) => {
            let raw = libm::round(value * f64::from(scale.divisor)) - f64::from(scale.plus);
            let fits =
                raw >= f64::from(scale.low) && raw <= f64::from(scale.high) && raw < most as f64;
            fits.then_some(raw as i32)
        }
        (Kind::Code(..), Input::Number(value)) => {
            (*value >= 0.0 && *value < most as f64).then_some(*value as i32)
        }
        (Kind::Turn, Input::Null) => Some(-128),
        (Kind::Turn, Input::AtLeast(rate)) => {
            let size = if libm::fabs(*rate) == NO_INDICATOR {
                127
            } else {
                126
            };
            Some(if *rate < 0.0 { -size } else { size })
        }
        (Kind::Turn, Input::Number(rate)) => {
            let root = libm::round(4.733 * libm::sqrt(libm::fabs(*rate)));
            let fits = libm::fabs(*rate) <= rate_of_turn(126);
            fits.then_some(libm::copysign(root, *rate) as i32)
        }
        _ => None,
    }
}

//! What a table of a message is made of.

use super::bits::Bits;
use super::value::{Binary, SixBitText, Value};
use crate::nmea::table::Unit;

/// A message type: its fields behind number, repeat indicator and station.
#[derive(Debug)]
pub(in crate::nmea) struct Layout {
    /// Number of the message.
    pub(in crate::nmea) kind: u8,
    pub(in crate::nmea) title: &'static str,
    /// Fewest and most bits.
    pub(in crate::nmea) least: usize,
    pub(in crate::nmea) most: usize,
    pub(in crate::nmea) items: &'static [Item],
}

/// A part of a table.
#[derive(Debug)]
pub(in crate::nmea) enum Item {
    /// A field.
    Field(Field),
    /// A list that several messages share.
    Part(&'static [Item]),
    /// Fields that are there where another field has one of some values.
    When(When, &'static [Item]),
    /// Fields that are there in messages of at least so many bits.
    Longer(usize, &'static [Item]),
    /// Fields of craft whose MMSI begins with 98, or of all others.
    Auxiliary(bool, &'static [Item]),
    /// Fields that stand several times, one entry after the other: name, most entries, bits of one.
    Each(&'static str, usize, usize, &'static [Item]),
}

/// On which field fields depend.
#[derive(Debug)]
pub(in crate::nmea) struct When {
    pub(in crate::nmea) field: &'static str,
    pub(super) place: Place,
    pub(super) width: usize,
    /// Bit n is set where the value n is meant.
    pub(in crate::nmea) values: u32,
}

/// Where a field begins.
#[derive(Clone, Copy, Debug)]
pub(super) enum Place {
    /// So many bits behind the beginning of the list in which the condition stands.
    List(usize),
    /// At this bit of the message.
    Bit(usize),
}

/// A field of a message.
#[derive(Debug)]
pub(in crate::nmea) struct Field {
    pub(in crate::nmea) name: &'static str,
    /// Its bits; 0 for what goes to the end.
    pub(in crate::nmea) width: usize,
    pub(in crate::nmea) kind: Kind,
    pub(in crate::nmea) note: &'static str,
}

/// What a field is.
#[derive(Debug)]
pub(in crate::nmea) enum Kind {
    /// A number.
    Number(Scale),
    /// A code: the value that means "not available", and the meanings of the others.
    Code(i32, fn(u32) -> Option<&'static str>),
    /// Whether something is so.
    Flag,
    /// Text; to the end where the width is 0.
    Text,
    /// Data to the end, less so many bits.
    Binary(usize),
    /// Rate of turn: the root of it, 4.733 to the unit.
    Turn,
    /// Not used.
    Spare,
}

/// How a number is coded.
#[derive(Clone, Copy, Debug)]
pub(in crate::nmea) struct Scale {
    pub(super) signed: bool,
    /// Steps to the unit.
    pub(in crate::nmea) divisor: i32,
    /// The value that means "not available".
    pub(in crate::nmea) none: i32,
    /// Another value that means it.
    pub(super) none_too: i32,
    /// The value that means "so much or more".
    pub(in crate::nmea) top: i32,
    /// What is added to the coded value.
    pub(super) plus: i32,
    pub(in crate::nmea) low: i32,
    pub(in crate::nmea) high: i32,
    pub(in crate::nmea) unit: Unit,
}

/// No such value.
pub(super) const NEVER: i32 = i32::MIN;

impl Scale {
    pub(super) const fn new(divisor: i32, low: i32, high: i32, unit: Unit) -> Self {
        Self {
            signed: low < 0,
            divisor,
            none: NEVER,
            none_too: NEVER,
            top: NEVER,
            plus: 0,
            low,
            high,
            unit,
        }
    }
    pub(super) const fn none(mut self, none: i32) -> Self {
        self.none = none;
        self
    }
    pub(super) const fn none_too(mut self, none: i32) -> Self {
        self.none_too = none;
        self
    }
    pub(super) const fn plus(mut self, plus: i32) -> Self {
        self.plus = plus;
        self
    }
    pub(super) const fn top(mut self, top: i32) -> Self {
        self.top = top;
        self
    }

    fn value(&self, raw: i32) -> f64 {
        if self.divisor < 600 {
            return f64::from(raw) / f64::from(self.divisor);
        }
        // Degrees to the seventh decimal, a centimetre.
        let (raw, divisor) = (i64::from(raw) * 10_000_000, i64::from(self.divisor));
        let half = if raw < 0 { -divisor / 2 } else { divisor / 2 };
        ((raw + half) / divisor) as f64 / 1e7
    }
}

/// Rate of turn in degrees a minute, to a tenth.
pub(super) fn rate_of_turn(raw: i32) -> f64 {
    let root = f64::from(raw) / 4.733;
    libm::copysign(libm::round(root * root * 10.0) / 10.0, root)
}

/// The value of a rate of turn without indicator: more than 5 degrees in 30 seconds.
pub(super) const NO_INDICATOR: f64 = 10.0;

impl Field {
    /// What stands in it; the second says that no such value is allowed. It is there with all its bits.
    #[inline]
    pub(super) fn read<'m>(&self, bits: &'m Bits, at: usize) -> (Value<'m>, bool) {
        let value = match &self.kind {
            Kind::Number(scale) => {
                let raw = if scale.signed {
                    bits.get_signed(at, self.width)
                } else {
                    bits.get(at, self.width) as i32
                };
                if raw == scale.none || raw == scale.none_too {
                    Value::Null
                } else if raw == scale.top {
                    Value::AtLeast(scale.value(raw))
                } else if raw < scale.low || raw > scale.high {
                    return (Value::Null, true);
                } else if scale.divisor == 1 {
                    Value::Integer(i64::from(raw + scale.plus))
                } else {
                    Value::Number(scale.value(raw))
                }
            }
            Kind::Code(none, _) => match bits.get(at, self.width) as i32 {
                raw if raw == *none => Value::Null,
                raw => Value::Integer(i64::from(raw)),
            },
            Kind::Flag => Value::Flag(bits.get(at, 1) == 1),
            Kind::Text => {
                SixBitText::read(bits, at, self.width / 6).map_or(Value::Null, Value::Text)
            }
            Kind::Turn => match bits.get_signed(at, 8) {
                -128 => Value::Null,
                raw @ (127 | -127) => Value::AtLeast(NO_INDICATOR * f64::from(raw.signum())),
                raw @ (126 | -126) => Value::AtLeast(rate_of_turn(raw)),
                raw => Value::Number(rate_of_turn(raw)),
            },
            Kind::Binary(_) | Kind::Spare => Value::Null,
        };
        (value, false)
    }

    /// What stands in it where the message may end before it does.
    pub(super) fn read_rest<'m>(&self, bits: &'m Bits, at: usize) -> Value<'m> {
        let rest = bits.len().saturating_sub(at);
        match self.kind {
            Kind::Text => SixBitText::read(bits, at, rest / 6).map_or(Value::Null, Value::Text),
            Kind::Binary(but) if rest > but => Value::Binary(Binary::new(bits, at, rest - but)),
            _ => Value::Null,
        }
    }

    /// What its value means.
    pub(super) fn meaning(&self, value: &Value<'_>) -> Option<&'static str> {
        match (&self.kind, value) {
            (Kind::Code(_, meaning), Value::Integer(code)) => meaning(*code as u32),
            (Kind::Turn, Value::AtLeast(rate)) if libm::fabs(*rate) == NO_INDICATOR => {
                Some("more than 5 degrees in 30 s, no turn indicator")
            }
            (_, Value::AtLeast(_)) => Some("or more"),
            _ => None,
        }
    }

    /// Its unit.
    pub(in crate::nmea) const fn unit(&self) -> Unit {
        match &self.kind {
            Kind::Number(scale) => scale.unit,
            Kind::Turn => Unit::DegreesPerMinute,
            _ => Unit::None,
        }
    }
}

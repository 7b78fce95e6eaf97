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
    /// A whole number.
    Whole(Scale),
    /// A number with decimals.
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
    /// Whether it is coded in two's complement.
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
    /// How far the greatest value that means itself is from the least.
    pub(super) span: u32,
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
            span: high.abs_diff(low),
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
    /// The greatest value means so much or more.
    pub(super) const fn top(mut self) -> Self {
        self.top = self.high;
        self.span -= 1;
        self
    }

    /// The kind of a field with this scale.
    pub(super) const fn kind(self) -> Kind {
        match self.divisor {
            1 => Kind::Whole(self),
            _ => Kind::Number(self),
        }
    }

    /// Whether a coded value means itself.
    #[inline(always)]
    pub(super) const fn holds(&self, raw: i32) -> bool {
        raw.wrapping_sub(self.low) as u32 <= self.span
    }

    /// What a coded value is worth in the unit.
    #[inline(always)]
    pub(super) fn value(&self, raw: i32) -> f64 {
        // A division by a constant costs a fraction.
        match self.divisor {
            10 => f64::from(raw) / 10.0,
            600_000 => degrees::<600_000>(raw),
            600 => degrees::<600>(raw),
            divisor => f64::from(raw) / f64::from(divisor),
        }
    }
}

/// Degrees to the seventh decimal, a centimetre.
#[inline(always)]
pub(super) fn degrees<const STEPS: i64>(raw: i32) -> f64 {
    let raw = i64::from(raw) * 10_000_000;
    let half = if raw < 0 { -STEPS / 2 } else { STEPS / 2 };
    ((raw + half) / STEPS) as f64 / 1e7
}

/// Rate of turn in degrees a minute, to a tenth: the square of a 4.733th of the coded value.
#[inline]
pub(super) fn rate_of_turn(raw: i32) -> f64 {
    let tenths = TENTHS[raw.unsigned_abs() as usize & 127];
    let rate = f64::from(tenths) / 10.0;
    if raw < 0 { -rate } else { rate }
}

/// Tenths of a degree a minute of each coded value; 4.733 is squared in whole millionths.
static TENTHS: [u16; 128] = {
    let mut tenths = [0; 128];
    let mut raw = 0u64;
    while raw < 128 {
        tenths[raw as usize] = ((raw * raw * 10_000_000 + 22_401_289 / 2) / 22_401_289) as u16;
        raw += 1;
    }
    tenths
};

/// The value of a rate of turn without indicator: more than 5 degrees in 30 seconds.
pub(super) const NO_INDICATOR: f64 = 10.0;

impl Field {
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
            Kind::Whole(scale) | Kind::Number(scale) => scale.unit,
            Kind::Turn => Unit::DegreesPerMinute,
            _ => Unit::None,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn rates_of_turn_are_the_square_of_the_root_to_a_tenth() {
        for raw in -127..=127 {
            let root = f64::from(raw) / 4.733;
            let rate = libm::round(root * root * 10.0) / 10.0;
            assert_eq!(rate_of_turn(raw), if raw < 0 { -rate } else { rate });
        }
    }

    #[test]
    fn positions_are_rounded_to_the_seventh_decimal() {
        for (steps, raw, degrees) in [
            (600_000, 1, 0.000_001_7),
            (600_000, -1, -0.000_001_7),
            (600_000, 108_000_000, 180.0),
            (600_000, -53_999_999, -89.999_998_3),
            (600, 1, 0.001_666_7),
            (600, -107_999, -179.998_333_3),
        ] {
            let scale = Scale::new(steps, -108_000_000, 108_000_000, Unit::Degrees);
            assert_eq!(scale.value(raw), degrees, "{raw}/{steps}");
        }
    }
}

//! Names, values and meanings of an explanation as text.

use super::decimal::{Decimal, POW10};
use super::explained::{Facet, FieldValue, Name};
use super::table::Sides;
use super::{Date, UtcTime};
use crate::geo::to_millimetre;
use core::fmt;

impl fmt::Display for Name {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let angle = match self.facet {
            Facet::Whole | Facet::Side | Facet::Unit => None,
            Facet::Latitude | Facet::LatitudeSide => Some("latitude"),
            Facet::Longitude | Facet::LongitudeSide => Some("longitude"),
        };
        match angle {
            Some(angle) if self.member == "position" => f.write_str(angle)?,
            Some(angle) => write!(f, "{}_{angle}", self.member)?,
            // The document's word is a keyword of the language.
            None if self.member == "override_status" => f.write_str("override")?,
            None => f.write_str(self.member)?,
        }
        match self.facet {
            Facet::Side | Facet::LatitudeSide | Facet::LongitudeSide => f.write_str("_side")?,
            Facet::Unit => f.write_str("_unit")?,
            _ => {}
        }
        if self.entry > 0 {
            write!(f, "_{}", self.entry)?;
        }
        Ok(())
    }
}

impl fmt::Display for FieldValue<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::None => Ok(()),
            Self::Number(value) => value.fmt(f),
            Self::Degrees(value) => to_millimetre(*value).fmt(f),
            Self::Integer(value) => value.fmt(f),
            Self::Letter(letter) => char::from(*letter).fmt(f),
            Self::Text(text) => super::unescape(text).fmt(f),
            Self::Time(time) => clock(*time, f),
            Self::Date(date) => date.fmt(f),
        }
    }
}

/// A time of day with every decimal of its seconds (SEN-9): none, or two and more.
fn clock(time: Decimal, f: &mut fmt::Formatter<'_>) -> fmt::Result {
    let mut scale = usize::from(time.scale());
    let (clock, mut rest) = (
        time.mantissa() / POW10[scale],
        time.mantissa() % POW10[scale],
    );
    let (hour, minute, second) = (clock / 10_000, clock / 100 % 100, clock % 100);
    write!(f, "{hour:02}:{minute:02}:{second:02}")?;
    if rest == 0 {
        return Ok(());
    }
    while scale > 2 && rest.is_multiple_of(10) {
        (scale, rest) = (scale - 1, rest / 10);
    }
    if scale == 1 {
        (scale, rest) = (2, rest * 10);
    }
    write!(f, ".{rest:0scale$}")
}

impl fmt::Display for UtcTime {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let (second, rest) = (self.centisecond / 100, self.centisecond % 100);
        write!(f, "{:02}:{:02}:{second:02}", self.hour, self.minute)?;
        if rest > 0 {
            write!(f, ".{rest:02}")
        } else {
            Ok(())
        }
    }
}

impl fmt::Display for Date {
    /// The year is one of 1970 to 2069.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let century = if self.year >= 70 { 19 } else { 20 };
        write!(
            f,
            "{century}{:02}-{:02}-{:02}",
            self.year, self.month, self.day
        )
    }
}

pub(super) fn unit_meaning(letter: u8, unit: Option<&'static str>) -> Option<&'static str> {
    Some(match (letter, unit) {
        (b'T', _) => "true",
        (b'M', Some("deg")) => "magnetic",
        (b'N', Some("kn")) => "knots",
        (b'N', Some("nm")) => "nautical miles",
        (b'K', Some("km")) => "kilometres",
        (b'K', _) => "kilometres an hour",
        (b'M', Some("m")) => "metres",
        (b'M', Some("m/s")) => "metres a second",
        (b'C', _) => "degrees Celsius",
        (b'f', _) => "feet",
        (b'F', _) => "fathoms",
        (b'B', _) => "bars",
        (b'I', _) => "inches of mercury",
        _ => return None,
    })
}

pub(super) fn side_meaning(letter: u8, sides: Sides) -> Option<&'static str> {
    Some(match (letter, sides) {
        (b'L', Sides { positive: b'L', .. }) => "steer to port: the ship is right of the track",
        (b'R', Sides { negative: b'R', .. }) => "steer to starboard: the ship is left of the track",
        (b'L' | b'P', _) => "port",
        (b'R' | b'S', _) => "starboard",
        _ => return compass(letter),
    })
}

pub(super) const fn compass(letter: u8) -> Option<&'static str> {
    Some(match letter {
        b'N' => "north",
        b'S' => "south",
        b'E' => "east",
        b'W' => "west",
        _ => return None,
    })
}

#[cfg(test)]
mod tests {
    use crate::nmea::{decode, explain};

    #[test]
    fn a_time_keeps_its_decimals() {
        let shown = |time: &str| {
            let line = crate::nmea::with_checksum(&alloc::format!("GPZDA,{time},22,11,2026,,"));
            let sentence = decode(line.as_bytes());
            alloc::format!("{}", explain(&sentence).fields[0].value)
        };
        assert_eq!(shown("152829"), "15:28:29");
        assert_eq!(shown("152829.00"), "15:28:29");
        assert_eq!(shown("152829.5"), "15:28:29.50");
        assert_eq!(shown("152829.353"), "15:28:29.353");
        assert_eq!(shown("000000.0501"), "00:00:00.0501");
    }
}

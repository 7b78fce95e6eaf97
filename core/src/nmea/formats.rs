//! Ranges, units and decimals that many fields share (SEN-6, SEN-9).

use super::table::{Format, Sides, Unit};

const MAX: i32 = i32::MAX;

pub(crate) const LR: Sides = Sides {
    negative: b'L',
    positive: b'R',
};
/// To which side to steer: the ship is on the other one. Ship right of the track is positive.
pub(crate) const STEER_TO: Sides = Sides {
    negative: b'R',
    positive: b'L',
};
pub(crate) const EW: Sides = Sides {
    negative: b'W',
    positive: b'E',
};

pub(crate) const DIRECTION: Format = Format::new(Unit::Degrees, 0, 360, 3, 1);
pub(crate) const RUDDER: Format = Format::new(Unit::Degrees, -180, 180, 1, 1);
pub(crate) const RUDDER_SIZE: Format = Format::new(Unit::Degrees, 0, 180, 1, 1);
pub(crate) const LIMIT: Format = Format::new(Unit::Degrees, 0, 180, 1, 1);
pub(crate) const RATE: Format = Format::new(Unit::DegreesPerMinute, -9999, 9999, 3, 1);
pub(crate) const RATE_SIZE: Format = Format::new(Unit::DegreesPerMinute, 0, 9999, 3, 1);
pub(crate) const MILES: Format = Format::new(Unit::NauticalMiles, 0, MAX, 1, 3);
pub(crate) const CROSS: Format = Format::new(Unit::NauticalMiles, 0, MAX, 1, 4);
pub(crate) const KNOTS: Format = Format::new(Unit::Knots, 0, MAX, 1, 1);
pub(crate) const KMH: Format = Format::new(Unit::KilometresPerHour, 0, MAX, 1, 1);
pub(crate) const DEVIATION: Format = Format::new(Unit::Degrees, 0, 180, 1, 1);

pub(crate) const METRES: Format = Format::new(Unit::Metres, -MAX, MAX, 1, 1);
pub(crate) const MPS: Format = Format::new(Unit::MetresPerSecond, 0, MAX, 1, 1);
pub(crate) const CELSIUS: Format = Format::new(Unit::Celsius, -273, MAX, 1, 1);
pub(crate) const SECONDS: Format = Format::new(Unit::Seconds, 0, MAX, 1, 1);
pub(crate) const FEET: Format = Format::new(Unit::Feet, -MAX, MAX, 1, 1);
pub(crate) const FATHOMS: Format = Format::new(Unit::Fathoms, -MAX, MAX, 1, 1);
/// A number whose unit stands in another field, or that has none.
pub(crate) const BARE: Format = Format::new(Unit::None, -MAX, MAX, 1, 1);
/// The same, never negative.
pub(crate) const SIZE: Format = Format::new(Unit::None, 0, MAX, 1, 3);
/// A whole number of a `x.x` field, never negative.
pub(crate) const COUNT: Format = Format::new(Unit::None, 0, MAX, 1, 0);
pub(crate) const SPEED_THROUGH: Format = Format::new(Unit::Knots, -999, 9999, 1, 1);
pub(crate) const KMH_THROUGH: Format = Format::new(Unit::KilometresPerHour, -1999, 19999, 1, 1);
pub(crate) const PERCENT: Format = Format::new(Unit::Percent, -100, 100, 1, 1);
pub(crate) const SIGNED_ANGLE: Format = Format::new(Unit::Degrees, -180, 180, 1, 1);
pub(crate) const MMSI: Format = whole(0, 999_999_999, 9);

/// A whole number of `digits` digits from `low` to `high`.
pub(crate) const fn whole(low: i32, high: i32, digits: u8) -> Format {
    Format::new(Unit::None, low, high, digits, 0)
}

//! Random values on the grid of what is sent, so that encoding them loses nothing.

use wheelover_core::geo::Position;
use wheelover_core::nmea::{Date, UtcTime};

/// A small seeded generator (xorshift).
pub(crate) struct Random(pub(crate) u64);

impl Random {
    /// The next 64 bits.
    pub(crate) fn bits(&mut self) -> u64 {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 7;
        self.0 ^= self.0 << 17;
        self.0
    }
    /// A whole number, both ends included.
    pub(crate) fn whole(&mut self, low: i64, high: i64) -> i64 {
        low + (self.bits() % (high - low + 1) as u64) as i64
    }
    /// A number with one decimal.
    pub(crate) fn tenths(&mut self, low: i64, high: i64) -> f64 {
        self.whole(low * 10, high * 10) as f64 / 10.0
    }
    /// One of a list.
    pub(crate) fn pick<T: Copy>(&mut self, list: &[T]) -> T {
        list[self.whole(0, list.len() as i64 - 1) as usize]
    }
    /// A direction below 360 degrees, one decimal.
    pub(crate) fn direction(&mut self) -> f64 {
        self.whole(0, 3_599) as f64 / 10.0
    }
    /// A position in every quarter of the world, five decimals of a minute.
    pub(crate) fn position(&mut self) -> Position {
        let ticks = 6_000_000;
        Position {
            lat: self.whole(-89 * ticks, 89 * ticks) as f64 / ticks as f64,
            lon: self.whole(-179 * ticks, 179 * ticks) as f64 / ticks as f64,
        }
    }
    /// A time of day, hundredths of a second.
    pub(crate) fn time(&mut self) -> UtcTime {
        UtcTime {
            hour: self.whole(0, 23) as u8,
            minute: self.whole(0, 59) as u8,
            centisecond: self.whole(0, 5_999) as u16,
        }
    }
    /// A date that gpsd's century makes no riddle.
    pub(crate) fn date(&mut self) -> Date {
        Date {
            day: self.whole(1, 28) as u8,
            month: self.whole(1, 12) as u8,
            year: self.whole(23, 36) as u8,
        }
    }
}

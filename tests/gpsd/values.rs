//! Random values on the grid of what is sent, so that encoding them loses nothing.

use crate::random::Random;
use wheelover_core::geo::Position;
use wheelover_core::nmea::{Date, UtcTime};

impl Random {
    /// A number with one decimal.
    pub(crate) fn tenths(&mut self, low: i64, high: i64) -> f64 {
        self.from(low * 10, high * 10) as f64 / 10.0
    }
    /// A direction below 360 degrees, one decimal.
    pub(crate) fn direction(&mut self) -> f64 {
        self.from(0, 3_599) as f64 / 10.0
    }
    /// A position in every quarter of the world, five decimals of a minute.
    pub(crate) fn position(&mut self) -> Position {
        let ticks = 6_000_000;
        Position {
            lat: self.from(-89 * ticks, 89 * ticks) as f64 / ticks as f64,
            lon: self.from(-179 * ticks, 179 * ticks) as f64 / ticks as f64,
        }
    }
    /// A time of day, hundredths of a second.
    pub(crate) fn time(&mut self) -> UtcTime {
        UtcTime {
            hour: self.from(0, 23) as u8,
            minute: self.from(0, 59) as u8,
            centisecond: self.from(0, 5_999) as u16,
        }
    }
    /// A date that gpsd's century makes no riddle.
    pub(crate) fn date(&mut self) -> Date {
        Date {
            day: self.from(1, 28) as u8,
            month: self.from(1, 12) as u8,
            year: self.from(23, 36) as u8,
        }
    }
}

//! The only clock: milliseconds and microseconds since the start, suspend included (FD6).

use std::time::Duration;

/// A monotonic clock that began at its making.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Clock {
    start: u64,
}

impl Clock {
    /// A clock that begins now.
    #[must_use]
    pub(crate) fn start() -> Self {
        Self { start: reading() }
    }

    /// Microseconds since the start.
    #[must_use]
    pub(crate) fn micros(&self) -> u64 {
        reading().saturating_sub(self.start)
    }
}

/// Microseconds of the machine's clock that goes on in suspend.
#[cfg(any(target_os = "linux", target_os = "android"))]
fn reading() -> u64 {
    use nix::time::{ClockId, clock_gettime};
    let Ok(time) = clock_gettime(ClockId::CLOCK_BOOTTIME) else {
        return 0;
    };
    let seconds = u64::try_from(time.tv_sec()).unwrap_or_default();
    let nanos = u64::try_from(time.tv_nsec()).unwrap_or_default();
    seconds * 1_000_000 + nanos / 1_000
}

/// Microseconds of the machine's monotonic clock, the best there is elsewhere.
#[cfg(not(any(target_os = "linux", target_os = "android")))]
fn reading() -> u64 {
    use std::sync::LazyLock;
    use std::time::Instant;
    static START: LazyLock<Instant> = LazyLock::new(Instant::now);
    u64::try_from(START.elapsed().as_micros()).unwrap_or(u64::MAX)
}

/// Ship's time for the time on the wall: equal with real equipment, faster in the embedded voyage and in a trial without
/// real equipment.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Pace {
    wall: u64,
    ship: f64,
    rate: f64,
}

impl Pace {
    /// Ship's time and time on the wall begin together.
    #[must_use]
    pub(crate) fn new(rate: f64) -> Self {
        Self {
            wall: 0,
            ship: 0.0,
            rate,
        }
    }

    /// Ship's time in milliseconds at a time on the wall in microseconds.
    #[must_use]
    pub(crate) fn ship(&self, wall: u64) -> u64 {
        self.exact(wall) as u64
    }

    fn exact(&self, wall: u64) -> f64 {
        self.ship + wall.saturating_sub(self.wall) as f64 / 1_000.0 * self.rate
    }

    /// Time on the wall, in microseconds, at which it is `ship` milliseconds on board.
    #[must_use]
    pub(crate) fn wall(&self, ship: u64) -> u64 {
        let ahead = (ship as f64 - self.ship).max(0.0) / self.rate;
        self.wall + (ahead * 1_000.0).ceil() as u64
    }

    /// Another pace from `wall` on.
    pub(crate) fn change(&mut self, wall: u64, rate: f64) {
        if (rate - self.rate).abs() > f64::EPSILON && rate > 0.0 {
            *self = Self {
                wall,
                ship: self.exact(wall),
                rate,
            };
        }
    }

    /// Lets ship's time stand still up to `wall`, where it is `ship` milliseconds.
    pub(crate) fn slip(&mut self, wall: u64, ship: u64) {
        self.wall = wall;
        self.ship = ship as f64;
    }
}

/// How fast ship's time runs where bytes come and go: a time on board is so much shorter on the wall.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Tempo(f64);

impl Tempo {
    /// The clock on the wall: all there is with real equipment.
    pub(crate) const REAL: Self = Self(1.0);

    /// Ship's time at so many times the clock's.
    pub(crate) fn new(rate: f64) -> Self {
        Self(rate)
    }

    /// How many times faster than the clock.
    pub(crate) fn rate(self) -> f64 {
        self.0
    }

    /// Whether it is another time than the clock's: then nothing real is behind the ports.
    pub(crate) fn is_trial(self) -> bool {
        (self.0 - 1.0).abs() > f64::EPSILON
    }

    /// Microseconds on the wall of so many on board.
    pub(crate) fn micros(self, on_board: u64) -> u64 {
        (on_board as f64 / self.0) as u64
    }

    /// How long a time on board takes.
    pub(crate) fn wall(self, on_board: Duration) -> Duration {
        on_board.div_f64(self.0)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_clock_goes_forward() {
        let clock = Clock::start();
        let first = clock.micros();
        std::thread::sleep(Duration::from_millis(2));
        assert!(clock.micros() >= first + 2_000);
    }

    #[test]
    fn a_change_of_pace_does_not_jump() {
        let mut pace = Pace::new(1.0);
        assert_eq!(pace.ship(1_000_000), 1_000);
        pace.change(1_000_000, 60.0);
        assert_eq!(pace.ship(1_000_000), 1_000);
        assert_eq!(pace.ship(2_000_000), 61_000);
        assert_eq!(pace.wall(61_000), 2_000_000);
        pace.change(2_000_000, 1.0);
        assert_eq!(pace.ship(3_000_000), 62_000);
        pace.slip(9_000_000, 62_000);
        assert_eq!(pace.ship(9_000_000), 62_000);
        assert_eq!(pace.wall(62_100), 9_100_000);
    }
}

//! Whether the program stood still: what its lines then hold was said long ago, and is not used (FA16).

use crate::clock::Clock;
use std::time::Duration;

/// The task of a port looks at the clock at least so often.
pub(super) const LOOK: Duration = Duration::from_millis(100);
/// Longer between two looks, the program stood still, microseconds.
const STOOD: u64 = 500_000;
/// For so long the lines are emptied then, microseconds.
const EMPTIED: u64 = 300_000;

/// The looks of one task.
#[derive(Debug)]
pub(super) struct Stood {
    clock: Clock,
    looked: u64,
    until: u64,
}

impl Stood {
    pub(super) fn new() -> Self {
        let clock = Clock::start();
        Self {
            looked: clock.micros(),
            clock,
            until: 0,
        }
    }

    /// Looks; whether what is read now may have been said before the program went on. True once more for the first look
    /// after a standstill of which nobody was told.
    pub(super) fn look(&mut self) -> bool {
        self.look_at(self.clock.micros())
    }

    fn look_at(&mut self, now: u64) -> bool {
        if now.saturating_sub(self.looked) > STOOD {
            self.until = now + EMPTIED;
        }
        self.looked = now;
        now < self.until
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    // FA16
    #[test]
    fn what_waited_while_the_program_stood_still_is_old() {
        let mut stood = Stood::new();
        stood.looked = 0;
        for now in [100_000, 200_000, 690_000] {
            assert!(!stood.look_at(now), "{now}");
        }
        for now in [10_690_000, 10_690_200, 10_989_000] {
            assert!(stood.look_at(now), "{now}");
        }
        for now in [10_990_000, 11_090_000] {
            assert!(!stood.look_at(now), "{now}");
        }
    }
}

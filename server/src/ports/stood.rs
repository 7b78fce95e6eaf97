//! Whether the program stood still: what its lines then hold was said long ago, and is not used (FA16).

use crate::clock::{Clock, Tempo};
use std::time::Duration;

/// The task of a port looks at the clock at least so often, on board.
const LOOK: Duration = Duration::from_millis(100);
/// Longer between two looks on board, the program stood still.
const STOOD: Duration = Duration::from_millis(500);
/// For so long on board the lines are emptied then.
const EMPTIED: Duration = Duration::from_millis(300);
/// A shorter time on the wall is the computer's, and no standstill at any pace.
const SHORTEST: Duration = Duration::from_millis(100);

/// The looks of one task.
#[derive(Debug)]
pub(super) struct Stood {
    clock: Clock,
    tempo: Tempo,
    /// Microseconds.
    looked: u64,
    /// Microseconds.
    until: u64,
}

impl Stood {
    pub(super) fn new(tempo: Tempo) -> Self {
        let clock = Clock::start();
        Self {
            tempo,
            looked: clock.micros(),
            clock,
            until: 0,
        }
    }

    /// How long the task may wait for the next look.
    pub(super) fn wait(&self) -> Duration {
        self.tempo.wall(LOOK)
    }

    /// Looks; whether what is read now may have been said before the program went on. True once more for the first look
    /// after a standstill of which nobody was told.
    pub(super) fn look(&mut self) -> bool {
        self.look_at(self.clock.micros())
    }

    fn look_at(&mut self, now: u64) -> bool {
        let passed = Duration::from_micros(now.saturating_sub(self.looked));
        if passed > self.tempo.wall(STOOD).max(SHORTEST) {
            self.until = now + self.tempo.wall(EMPTIED).as_micros() as u64;
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
        let mut stood = Stood::new(Tempo::REAL);
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

    // FA16
    #[test]
    fn at_another_pace_the_times_are_those_on_board() {
        let mut stood = Stood::new(Tempo::new(5.0));
        assert_eq!(stood.wait(), Duration::from_millis(20));
        stood.looked = 0;
        assert!(!stood.look_at(100_000));
        assert!(stood.look_at(201_000));
        assert!(stood.look_at(260_000));
        assert!(!stood.look_at(262_000));
        // What a busy computer takes for itself is no standstill.
        let mut fast = Stood::new(Tempo::new(60.0));
        fast.looked = 0;
        assert!(!fast.look_at(90_000));
        assert!(fast.look_at(200_000));
    }
}

//! The share of a line that reports of changes may take, by its rate (AP-11).

use super::table::SECOND_MS;
use crate::time::Stamp;
use alloc::collections::VecDeque;
use serde::{Deserialize, Serialize};

/// Per cent of the line: AP-11 allows 30, and HMR has to fit on the slowest line beside them.
const PERCENT: u64 = 27;
/// A port without a rate of its own may lead to the slowest line (IEC 61162-1), baud.
const SLOWEST: u32 = 4_800;
const SECOND_US: u64 = 1_000_000;

/// Bytes a second that a line carries: a start bit, eight data bits, a stop bit.
pub(super) const fn line_rate(baud: u32) -> u64 {
    baud as u64 / 10
}

/// Bytes a second for reports of changes.
pub(crate) const fn alert_share(baud: u32) -> u64 {
    let baud = if baud == 0 { SLOWEST } else { baud };
    line_rate(baud) * PERCENT / 100
}

/// What is left of the share: in any second no more leaves than it allows, and spread over the second.
#[derive(Clone, Debug, Default, Serialize, Deserialize)]
pub(crate) struct Share {
    /// Time that may still be taken, microseconds.
    credit: u64,
    /// When it was last counted.
    at: Stamp,
    /// What left in the last second: when, and bytes. Lines of unequal length fit no even spread.
    left: VecDeque<(Stamp, u64)>,
}

impl Share {
    /// Whether a line may leave in the step at `now`; if so it is counted. Time in which nothing waited is not saved up.
    pub(crate) fn take(&mut self, now: Stamp, step_ms: u64, baud: u32, line: &str) -> bool {
        let cost = cost(baud, line);
        let passed = now.since(self.at) * 1_000;
        self.at = now;
        self.credit = (self.credit + passed).min(cost.max(step_ms * 1_000));
        self.left.retain(|(at, _)| now.since(*at) < SECOND_MS);
        let bytes = line.len() as u64 + 2;
        let before: u64 = self.left.iter().map(|(_, bytes)| bytes).sum();
        let fits = before == 0 || before + bytes <= alert_share(baud);
        let may = cost <= self.credit && fits;
        if may {
            self.credit -= cost;
            self.left.push_back((now, bytes));
        }
        may
    }
}

/// The part of a second that a line takes: as many of its length as the share holds fill it.
const fn cost(baud: u32, line: &str) -> u64 {
    let fit = alert_share(baud) / (line.len() as u64 + 2);
    SECOND_US.div_ceil(if fit == 0 { 1 } else { fit })
}

#[cfg(test)]
mod tests {
    use super::*;
    use alloc::string::String;
    use alloc::vec::Vec;

    /// Bytes that leave in each step of `ms`, with endless lines of `length` bytes waiting.
    fn steps(baud: u32, ms: u64, length: usize) -> Vec<u64> {
        let line: String = "x".repeat(length - 2);
        let mut share = Share::default();
        let step = |number| {
            let now = Stamp(60_000 + number * ms);
            let mut sent = 0;
            while share.take(now, ms, baud, &line) {
                sent += length as u64;
            }
            sent
        };
        (0..100).map(step).collect()
    }

    #[test]
    fn in_no_second_more_than_the_share_leaves_at_any_step_and_rate() {
        for baud in [4_800, 38_400, 0] {
            for ms in [50, 100, 200] {
                for length in [21, 40, 82] {
                    let sent = steps(baud, ms, length);
                    let seconds = sent.windows((1_000 / ms) as usize);
                    let most = seconds.map(|second| second.iter().sum()).max();
                    let share = alert_share(baud);
                    let least = share / length as u64 * length as u64 * 2 / 3;
                    assert!(
                        most.is_some_and(|most: u64| (least..=share).contains(&most)),
                        "{baud} baud, {ms} ms, {length} bytes: {most:?} of {share}"
                    );
                }
            }
        }
    }
}

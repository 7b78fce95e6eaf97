//! From the wanted rudder of one side to its order: bumpless transfer, limit, slew.
//!
//! `order = slew(clip(wanted + x))`, where `x` makes the first order after a change equal to the last one
//! before it and then dies away, `x' = -x / 8 s` (FA6). Angles in degrees, starboard positive.
//!
//! **Invariant:** an order never leaves its limit and never moves faster than the slew; where the limit
//! shrinks below the order, the order walks in at the slew.

use serde::{Deserialize, Serialize};

/// Time in which the bumpless offset dies away, s.
const TRANSFER_TIME: f64 = 8.0;

/// The last order, and what is left of the last transfer.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub(super) struct Rudder {
    order: f64,
    transfer: f64,
    /// The next wanted rudder is to be joined without a bump.
    joining: bool,
    /// Order without limit and slew minus order with them, degrees.
    cut: f64,
}

impl Rudder {
    /// Begins at an order that somebody else gave.
    pub(super) fn engage(&mut self, order: f64) {
        *self = Self {
            order,
            transfer: 0.0,
            joining: true,
            cut: 0.0,
        };
    }

    /// The law behind the next order is another one: join it without a bump.
    pub(super) fn join(&mut self) {
        self.joining = true;
    }

    /// What is wanted next is ordered as it stands: nothing is left of a transfer.
    pub(super) fn obey(&mut self) {
        self.joining = false;
        self.transfer = 0.0;
    }

    /// The order in force, degrees.
    pub(super) const fn order(&self) -> f64 {
        self.order
    }

    /// By how much limit and slew cut what was wanted, degrees.
    pub(super) const fn cut(&self) -> f64 {
        self.cut
    }

    /// Goes towards what is wanted for `dt` seconds, at most `slew` degrees a second; whether the order is at its limit.
    pub(super) fn step(&mut self, wanted: f64, limit: f64, slew: f64, dt: f64) -> bool {
        let limit = libm::fabs(limit);
        if self.joining {
            self.transfer = self.order - wanted.clamp(-limit, limit);
            self.joining = false;
        }
        self.transfer -= self.transfer * (dt / TRANSFER_TIME).min(1.0);
        let sum = wanted + self.transfer;
        let most = libm::fabs(slew) * dt;
        let move_by = (sum.clamp(-limit, limit) - self.order).clamp(-most, most);
        self.order += move_by;
        self.cut = sum - self.order;
        libm::fabs(self.order) >= limit - 1e-9
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_first_order_after_a_change_is_the_last_before_it() {
        let mut rudder = Rudder::default();
        rudder.engage(12.0);
        rudder.step(-20.0, 35.0, 5.0, 0.1);
        assert!((rudder.order() - 12.0).abs() <= 0.5, "{rudder:?}");
        let mut last = rudder.order();
        for _ in 0..1000 {
            rudder.step(-20.0, 35.0, 5.0, 0.1);
            let next = rudder.order();
            assert!((next - last).abs() <= 0.5 + 1e-12);
            last = next;
        }
        assert!((last + 20.0).abs() < 0.01, "{last}");
    }

    #[test]
    fn a_shrinking_limit_is_walked_into() {
        let mut rudder = Rudder::default();
        rudder.engage(30.0);
        let mut last = 30.0;
        for _ in 0..200 {
            rudder.step(40.0, 10.0, 2.3, 0.1);
            let next = rudder.order();
            assert!((next - last).abs() <= 0.23 + 1e-12);
            last = next;
        }
        assert!((last - 10.0).abs() < 1e-9);
    }
}

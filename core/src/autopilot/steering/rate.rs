//! Rate of turn: a reference that turns at the ordered rate, for the regulator that keeps the ship on it.
//!
//! ```text
//! r_d'' = clip(r - r_d)/3 s - r_d', r_d' <= a, r_d'' <= a/4 s          ordered rate r [rad/s], acceleration a [rad/s^2]
//! psi_d' = r_d,  |psi - psi_d| <= 3 deg while she turns                 [rad]
//! ```
//! The heading error is the integral of the error of the rate, so the law of `heading.rs` regulates both; it is bounded, so
//! that nothing winds up where the rudder is at its limit. At no rate the reference stands, and the heading is held without
//! drift.

use super::angle::wrap;
use super::heading::{PULL, RISE, ReferenceModel};

/// Largest heading error while she turns, rad.
const LARGEST_ERROR: f64 = 0.052;
/// A rate that is as good as ordered, rad/s.
const SAME: f64 = 1e-6;

impl ReferenceModel {
    /// Turns at `rate` (rad/s), reached with at most `acceleration` (rad/s^2); `heading` is the ship's, rad.
    pub(super) fn turn(&mut self, rate: f64, acceleration: f64, heading: f64, dt: f64) {
        let most = acceleration.max(1e-6);
        let left = rate - self.rate;
        if libm::fabs(left) < SAME && libm::fabs(self.acceleration) < SAME {
            self.rate = rate;
            self.acceleration = 0.0;
        } else {
            let pull = (left / PULL).clamp(-most, most);
            let jerk = most / RISE * dt;
            self.acceleration += (pull - self.acceleration).clamp(-jerk, jerk);
            self.rate += self.acceleration * dt;
        }
        self.heading = wrap(self.heading + self.rate * dt);
        if self.rate != 0.0 {
            let error = wrap(heading - self.heading).clamp(-LARGEST_ERROR, LARGEST_ERROR);
            self.heading = wrap(heading - error);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_reference_comes_to_the_rate_and_stands_still_at_none() {
        for rate in [0.002, -0.0087, 0.02] {
            let mut reference = ReferenceModel::default();
            let mut fastest = 0.0_f64;
            for _ in 0..1_500 {
                let heading = reference.heading;
                reference.turn(rate, 3.5e-4, heading, 0.1);
                fastest = fastest.max(reference.rate / rate);
            }
            assert!((1.0..1.05).contains(&fastest), "{rate}: {fastest}");
            assert_eq!(reference.rate, rate);
            for _ in 0..1_500 {
                let heading = reference.heading;
                reference.turn(0.0, 3.5e-4, heading, 0.1);
            }
            let stands = reference.heading;
            reference.turn(0.0, 3.5e-4, stands + 0.3, 0.1);
            assert_eq!((reference.rate, reference.heading), (0.0, stands));
        }
    }

    #[test]
    fn a_ship_that_cannot_follow_winds_nothing_up() {
        let mut reference = ReferenceModel::default();
        for _ in 0..3_000 {
            reference.turn(0.02, 3.5e-4, 0.0, 0.1);
        }
        assert!((reference.heading - LARGEST_ERROR).abs() < 1e-9);
    }
}

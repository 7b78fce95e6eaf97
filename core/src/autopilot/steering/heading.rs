//! Heading: a reference that a ship can follow, and the regulator that keeps her on it.
//!
//! ```text
//! delta = f(r_d, r_d') - K_p e - K_d (r - r_d) - K_i int e                      [rad]
//! K_p = w^2 T/K,  K_d = (2 zeta w T - 1)/K,  K_i = i w K_p                       e = psi - psi_d
//! ```
//! Fossen 2021, 15.3.4, with the ship's model inverted (`f`, steady turn `delta_ss` and both time
//! constants) for the feed-forward and an S-shaped rate profile for
//! the third-order reference model, whose acceleration winds up where the rate is limited. The bias in
//! `delta_ss` is learned by the integral; it is held in turns and runs back while the order is cut (3.3).

use super::angle::wrap;
use super::observer::Motion;
use super::settings::{ShipAtSpeed, SteeringSettings};
use serde::{Deserialize, Serialize};

/// ReferenceModel of heading (rad), rate (rad/s) and acceleration (rad/s^2).
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub(super) struct ReferenceModel {
    pub(super) heading: f64,
    pub(super) rate: f64,
    pub(super) acceleration: f64,
}

impl ReferenceModel {
    /// As the ship moves now.
    pub(super) const fn of(motion: &Motion) -> Self {
        Self {
            heading: motion.heading,
            rate: motion.rate,
            acceleration: 0.0,
        }
    }

    /// Moves towards `set` at no more than `rate` and `acceleration`, without overshoot.
    pub(super) fn step(&mut self, set: f64, rate: f64, acceleration: f64, dt: f64) {
        let left = wrap(set - self.heading);
        let most = acceleration.max(1e-6);
        if libm::fabs(left) < 1e-5 && libm::fabs(self.rate) < 1e-5 {
            *self = Self {
                heading: set,
                rate: 0.0,
                acceleration: 0.0,
            };
            return;
        }
        let brake = 0.6 * most;
        // Linear near the end, so that the rate meets the square root smoothly.
        let near = brake * SETTLE * SETTLE;
        let distance = libm::fabs(left);
        let wanted = if distance < near {
            distance / SETTLE
        } else {
            libm::sqrt(2.0 * brake * (distance - near / 2.0))
        };
        let wanted = libm::copysign(wanted.min(libm::fabs(rate)), left);
        let pull = ((wanted - self.rate) / PULL).clamp(-most, most);
        let jerk = most / RISE * dt;
        self.acceleration += (pull - self.acceleration).clamp(-jerk, jerk);
        self.rate += self.acceleration * dt;
        self.heading = wrap(self.heading + self.rate * dt);
    }
}

/// Time constant of the last degrees, s.
const SETTLE: f64 = 10.0;
/// Time in which the rate follows the profile, s.
pub(super) const PULL: f64 = 3.0;
/// Time in which the acceleration rises to its full value, s.
pub(super) const RISE: f64 = 4.0;

/// The regulator's integral.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub(super) struct Regulator {
    integral: f64,
    quick: f64,
}

/// What moves the rudder, rad.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Terms {
    pub(super) proportional: f64,
    pub(super) integral: f64,
    pub(super) rate: f64,
    pub(super) feedforward: f64,
}

impl Terms {
    pub(super) fn sum(&self) -> f64 {
        self.proportional + self.integral + self.rate + self.feedforward
    }
}

impl Regulator {
    /// One step from heading and rate (rad, rad/s); `cut` is what limit and slew took last time (rad).
    pub(super) fn step(
        &mut self,
        (heading, rate): (f64, f64),
        reference: &ReferenceModel,
        (ship, settings): (&ShipAtSpeed, &SteeringSettings),
        cut: f64,
        dt: f64,
    ) -> Terms {
        let w = settings.natural_frequency * ship.ratio;
        let time_constant = settings.time_constant / ship.ratio;
        let gain = settings.gain * ship.ratio;
        let kp = w * w * ship.inertia;
        let kd = ((2.0 * settings.damping * w * time_constant - 1.0) / gain).max(0.0);
        let ki = settings.integral_share * w * kp;
        let error = wrap(heading - reference.heading);
        let turning = libm::fabs(reference.rate) > HELD_ABOVE * ship.ratio;
        if !turning && libm::fabs(error) < INTEGRATED_BELOW {
            let tracking = libm::sqrt(kd / ki.max(1e-9));
            self.integral += (-ki * error - cut / tracking) * dt;
        }
        self.integral = self.integral.clamp(-LARGEST_BIAS, LARGEST_BIAS);
        let feedforward = ship.rudder_for(reference.rate, reference.acceleration, self.quick);
        self.quick = ship.quick_rate(self.quick, feedforward, dt);
        Terms {
            proportional: -kp * error,
            integral: self.integral,
            rate: -kd * (rate - reference.rate),
            feedforward,
        }
    }
}

/// Rate above which the integral is held, rad/s at the reference speed.
const HELD_ABOVE: f64 = 0.0015;
/// Heading error beyond which the integral is held, rad.
const INTEGRATED_BELOW: f64 = 0.09;
/// Largest rudder that the integral may ask for, rad.
const LARGEST_BIAS: f64 = 0.17;

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_reference_reaches_the_heading_without_passing_it() {
        for (change, rate) in [(0.17, 0.007), (0.52, 0.007), (1.4, 0.007), (-3.0, 0.017)] {
            let mut reference = ReferenceModel::default();
            let (mut furthest, mut fastest) = (0.0_f64, 0.0_f64);
            for _ in 0..12_000 {
                reference.step(change, rate, 5e-4, 0.1);
                furthest = furthest.max(reference.heading / change);
                fastest = fastest.max(reference.rate.abs());
            }
            assert!(furthest < 1.004, "{change}: {furthest}");
            assert!((reference.heading - change).abs() < 1e-4 && fastest < rate * 1.1);
        }
    }
}

//! The position loop of a motor: from order and feedback to its speed.
//!
//! ```text
//! e = order - feedback - t v                 what is left when it has run out        [deg]
//! starts where |order - feedback| > d,  stops where e has come to zero
//! u = sign(e) max(|e| / s, u_min), at most 1                                         [-]
//! ```
//! `v` speed of the rudder, deg/s; `t` rudder damping, s; `d` dead band, deg; `s` the distance over which it slows down;
//! `u_min` the least that moves a rudder. The automatic dead band grows by a quarter where the motor starts against its last
//! direction within three seconds, which is hunting, and shrinks to the least with a time constant of two minutes.
//!
//! **Invariant:** `|u| <= 1`; within the dead band a motor that stands stays so.

use super::setup::MotorSetup;
use serde::{Deserialize, Serialize};

/// Distance over which the motor slows down, degrees.
const SLOW_DEG: f64 = 4.0;
/// The least speed that moves a rudder, as a part of the full one.
const LEAST: f64 = 0.25;
/// Time constant of the measured speed, s.
const SPEED_TIME: f64 = 0.15;
/// A start against the last direction within so many seconds is hunting.
const HUNTING_S: f64 = 3.0;
/// What hunting makes of the band.
const WIDER: f64 = 1.25;
/// Time constant with which the band shrinks, s.
const NARROWER_S: f64 = 120.0;

/// What the loop remembers.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub(super) struct Drive {
    /// -1, 0 or 1: the direction in which the motor runs.
    running: f64,
    /// The direction in which it ran last.
    last: f64,
    /// Since it stopped, s.
    stood: f64,
    /// Width of the automatic dead band, degrees.
    automatic: f64,
    /// The feedback before and the speed of the rudder, deg and deg/s.
    before: Option<f64>,
    speed: f64,
    /// How often the motor has started.
    starts: u64,
}

impl Drive {
    /// How often the motor has started.
    pub(super) const fn starts(&self) -> u64 {
        self.starts
    }

    /// Forgets where it was going; the band and the count stay.
    pub(super) const fn halt(&mut self) {
        self.running = 0.0;
        self.before = None;
        self.speed = 0.0;
    }

    /// The motor's speed, -1 to 1, starboard positive, towards an order (degrees); `dt` in seconds.
    pub(super) fn step(&mut self, order: f64, feedback: f64, setup: &MotorSetup, dt: f64) -> f64 {
        let moved = feedback - self.before.replace(feedback).unwrap_or(feedback);
        self.speed += (moved / dt - self.speed) * (dt / (dt + SPEED_TIME));
        self.stood += dt;
        let least = setup.dead_band_min_deg;
        self.automatic = self.automatic.max(least);
        self.automatic += (least - self.automatic) * (dt / NARROWER_S);
        let off = order - feedback;
        let left = off - setup.damping_s * self.speed;
        if self.running != 0.0 && left * self.running <= 0.0 {
            (self.last, self.running, self.stood) = (self.running, 0.0, 0.0);
        }
        if self.running == 0.0 && libm::fabs(off) > setup.band(self.automatic) && left * off > 0.0 {
            self.running = libm::copysign(1.0, off);
            self.starts += 1;
            if self.running * self.last < 0.0 && self.stood < HUNTING_S {
                self.automatic = (self.automatic * WIDER).min(setup.dead_band_max_deg.max(least));
            }
        }
        self.running * (libm::fabs(left) / SLOW_DEG).clamp(LEAST, 1.0)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::settings::DeadBand;

    /// A rudder that runs on for `coast` seconds, at 6 deg/s with full speed; told a sine of half a degree over an order.
    fn hunted(setup: &MotorSetup, coast: f64, wave_deg: f64, seconds: f64) -> (Drive, f64) {
        let (mut drive, mut rudder, mut speed, mut worst) =
            (Drive::default(), 0.0_f64, 0.0, 0.0_f64);
        let dt = 0.1;
        for step in 0..(seconds / dt) as u32 {
            let time = f64::from(step) * dt;
            let order = 10.0 + wave_deg * libm::sin(time * 0.8);
            let asked = drive.step(order, rudder, setup, dt);
            speed += (6.0 * asked - speed) * (dt / (dt + coast));
            rudder += speed * dt;
            if time > 10.0 {
                worst = worst.max((order - rudder).abs());
            }
        }
        (drive, worst)
    }

    #[test]
    fn it_comes_to_its_order_and_stands_there() {
        let setup = MotorSetup::default();
        let (drive, worst) = hunted(&setup, 0.1, 0.0, 60.0);
        assert_eq!(drive.starts(), 1);
        assert!(worst <= setup.dead_band_min_deg, "{worst}");
    }

    // EMC-7, AP-18: the dead band acts, whichever it is.
    #[test]
    fn a_wider_dead_band_starts_less_often() {
        let of = |dead_band| MotorSetup {
            dead_band,
            ..MotorSetup::default()
        };
        let starts = |band| hunted(&of(band), 0.1, 1.2, 300.0).0.starts();
        let (least, most) = (starts(DeadBand::Minimum), starts(DeadBand::Maximum));
        assert!(least > 60 && most <= 2, "{least} and {most}");
    }

    #[test]
    fn the_automatic_band_ends_hunting() {
        // It runs on for so long that the least band is overrun each time.
        let setup = |dead_band| MotorSetup {
            dead_band,
            damping_s: 0.0,
            dead_band_min_deg: 0.2,
            ..MotorSetup::default()
        };
        let (hunting, _) = hunted(&setup(DeadBand::Minimum), 0.6, 0.0, 300.0);
        let (quiet, worst) = hunted(&setup(DeadBand::Automatic), 0.6, 0.0, 300.0);
        assert!(hunting.starts() > 100, "{}", hunting.starts());
        assert!(
            quiet.starts() < hunting.starts() / 4,
            "{} of {}",
            quiet.starts(),
            hunting.starts()
        );
        assert!(worst < 3.0, "{worst}");
    }

    // EMC-7, AP-18: rudder damping.
    #[test]
    fn damping_stops_it_before_it_has_passed_the_order() {
        let setup = |damping_s| MotorSetup {
            damping_s,
            dead_band_min_deg: 0.2,
            dead_band: DeadBand::Minimum,
            ..MotorSetup::default()
        };
        let starts = |damping| hunted(&setup(damping), 0.4, 0.0, 60.0).0.starts();
        assert!(
            starts(0.4) * 2 < starts(0.0),
            "{} and {}",
            starts(0.4),
            starts(0.0)
        );
    }
}

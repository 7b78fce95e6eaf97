//! Heading of a small craft: three gains, a dead band, and an order that rests (EMC-2, EMC-7).
//!
//! ```text
//! e = psi - psi_d,  r_e = r - r_d,  v = e + (K_d/K_p) r_e                       [deg, deg/s]
//! k = max(0, 1 - b/|v|)                             nothing inside the dead band b [deg]
//! u = -f k (K_p e + K_d r_e) + I,  I' = -f K_i k e                 each T_s [s]; rudder [deg]
//! f = clip(U_c/U, 1/2, 2)                           U_c cruise speed, U speed, U_c where none is measured
//! b = 1 or 4, or clip(1.5 s, 1, 4),  w = v - v_l,  v_l' = w/10 s,  (s^2)' = (w^2 - s^2)/60 s
//! the wanted rudder is u, or stays while |u - it| <= n         rudder damping n [deg]
//! ```
//! `psi_d` and `r_d` are the reference of `heading.rs`, which turns by the set radius or rate. The integral, which is the trim,
//! is held in turns, beyond 10 degrees off, and while it asks for more of what the gear cuts. Without a proportional gain there is
//! no dead band. A textbook's PID with a dead zone; dead band and damping are what EMACUA's hand unit sets.

use super::angle::wrap;
use super::heading::ReferenceModel;
use crate::settings::{DeadBand, HeadingLaw, Settings};
use crate::units::{Heading, RateOfTurn, Speed};
use serde::{Deserialize, Serialize};

/// The dead band, degrees off the heading.
const LEAST: f64 = 1.0;
const GREATEST: f64 = 4.0;
/// The automatic one, in standard deviations of what the waves make.
const SHARE: f64 = 1.5;
/// What is slower than this is no wave; their strength is measured over so long, s.
const SLOW: f64 = 10.0;
const MEASURED_OVER: f64 = 60.0;
/// Speed factor of the gains.
const FACTOR: (f64, f64) = (0.5, 2.0);
/// The integral is held while the reference turns faster, degrees a second, and farther off, degrees.
const TURNS: f64 = 0.1;
const FAR: f64 = 10.0;
/// Largest trim, degrees.
const LARGEST_TRIM: f64 = 10.0;
/// The gear cuts what is wanted by more than the noise of a step, degrees.
const CUT: f64 = 2.0;

/// What is set of the law.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub(super) struct Gains {
    /// Degrees of rudder a degree.
    kp: f64,
    /// Degrees of rudder a second and degree.
    ki: f64,
    /// Degrees of rudder a degree a second.
    kd: f64,
    /// Time between two samples, s.
    sample: f64,
    dead_band: DeadBand,
    /// The wanted rudder rests within so much, degrees.
    damping: f64,
    /// Speed at which the gains hold.
    cruise: Speed,
}

impl Gains {
    /// As they are set; absent where another law steers.
    pub(super) fn of(settings: &Settings) -> Option<Self> {
        let chosen = settings.heading_law == HeadingLaw::Pid;
        chosen.then_some(Self {
            kp: settings.pid_kp,
            ki: settings.pid_ki,
            kd: settings.pid_kd,
            sample: settings.sample_time / 1000.0,
            dead_band: settings.dead_band,
            damping: settings.rudder_damping,
            cruise: Speed::from_knots(settings.cruise_speed),
        })
    }
}

/// What moves the rudder, degrees.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub(super) struct Moved {
    pub(super) proportional: f64,
    pub(super) integral: f64,
    pub(super) rate: f64,
}

/// The law's memory.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub(super) struct Pid {
    trim: f64,
    /// What was sampled last, and how long ago, s; absent where the law begins.
    sampled: Option<(Moved, f64)>,
    /// The rudder that is wanted, degrees.
    wanted: f64,
    /// Slow part of what is steered by, and the variance of the rest.
    slow: Option<f64>,
    variance: f64,
}

impl Pid {
    /// It begins, or begins anew; what is known of trim and waves stays.
    pub(super) fn begin(&mut self) {
        (self.sampled, self.slow) = (None, None);
    }

    /// The dead band in force, degrees.
    pub(super) fn dead_band(&self, gains: &Gains) -> f64 {
        match gains.dead_band {
            DeadBand::Minimum => LEAST,
            DeadBand::Maximum => GREATEST,
            DeadBand::Automatic => (SHARE * libm::sqrt(self.variance)).clamp(LEAST, GREATEST),
        }
    }

    /// One control step of `dt` seconds: the wanted rudder, degrees, and what it is made of. `cut` is what limit and slew took
    /// last time, degrees.
    pub(super) fn step(
        &mut self,
        gains: &Gains,
        (heading, rate): (Heading, RateOfTurn),
        reference: &ReferenceModel,
        (speed, cut): (Speed, f64),
        dt: f64,
    ) -> (f64, Moved) {
        // A millisecond less: sums of steps are not exact.
        if let Some((moved, age)) = self.sampled
            && age + dt < gains.sample - 1e-3
        {
            self.sampled = Some((moved, age + dt));
            return (self.wanted, moved);
        }
        let error = wrap(heading.rad() - reference.heading).to_degrees();
        let turns = reference.rate.to_degrees();
        let rate = rate.deg_per_s() - turns;
        let lead = if gains.kp > 0.0 {
            gains.kd / gains.kp
        } else {
            0.0
        };
        let off = error + lead * rate;
        self.look_at_waves(off, gains.sample);
        let share = self.outside(gains, off);
        let factor = (gains.cruise.mps() / speed.mps().max(0.1)).clamp(FACTOR.0, FACTOR.1);
        let by = -factor * gains.ki * share * error;
        let held = libm::fabs(turns) > TURNS
            || libm::fabs(error) > FAR
            || (libm::fabs(cut) > CUT && by * cut > 0.0);
        if !held {
            self.trim = (self.trim + by * gains.sample).clamp(-LARGEST_TRIM, LARGEST_TRIM);
        }
        let moved = Moved {
            proportional: -factor * share * gains.kp * error,
            integral: self.trim,
            rate: -factor * share * gains.kd * rate,
        };
        let sum = moved.proportional + moved.integral + moved.rate;
        if self.sampled.is_none() || libm::fabs(sum - self.wanted) > gains.damping {
            self.wanted = sum;
        }
        self.sampled = Some((moved, 0.0));
        (self.wanted, moved)
    }

    /// The part of what she is off that is outside the dead band.
    fn outside(&self, gains: &Gains, off: f64) -> f64 {
        if gains.kp <= 0.0 {
            return 1.0;
        }
        let (size, band) = (libm::fabs(off), self.dead_band(gains));
        if size <= band { 0.0 } else { 1.0 - band / size }
    }

    /// How strongly she yaws in the waves.
    fn look_at_waves(&mut self, off: f64, dt: f64) {
        let slow = self.slow.unwrap_or(off);
        let fast = off - slow;
        self.slow = Some(slow + fast * (dt / SLOW).min(1.0));
        self.variance += (fast * fast - self.variance) * (dt / MEASURED_OVER).min(1.0);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use alloc::vec::Vec;

    fn gains(change: impl FnOnce(&mut Settings)) -> Gains {
        let mut settings = Settings {
            heading_law: HeadingLaw::Pid,
            pid_kp: 2.0,
            pid_ki: 0.0,
            pid_kd: 0.0,
            sample_time: 100.0,
            rudder_damping: 0.0,
            cruise_speed: 6.0,
            dead_band: DeadBand::Minimum,
            ..Settings::default()
        };
        change(&mut settings);
        Gains::of(&settings).unwrap()
    }

    /// The wanted rudder after each step, `off` degrees to starboard of the heading at that time (s) and `rate` (deg/min).
    fn run(
        gains: &Gains,
        seconds: f64,
        at: impl Fn(f64) -> (f64, f64),
        knots: f64,
    ) -> (Pid, Vec<f64>) {
        let (mut pid, mut wanted) = (Pid::default(), Vec::new());
        for step in 0..(seconds * 10.0) as u32 {
            let (off, rate) = at(f64::from(step) / 10.0);
            let said = (Heading::from_deg(off), RateOfTurn::from_deg_per_min(rate));
            let reference = ReferenceModel::default();
            let by = (Speed::from_knots(knots), 0.0);
            wanted.push(pid.step(gains, said, &reference, by, 0.1).0);
        }
        (pid, wanted)
    }

    // EMC-2: each gain moves the rudder by its own term, against the error.
    #[test]
    fn each_gain_acts_by_its_formula() {
        let check = |change: fn(&mut Settings), off: f64, rate: f64, knots: f64, expect: f64| {
            let (_, wanted) = run(&gains(change), 10.0, |_| (off, rate), knots);
            let last = wanted.last().unwrap();
            assert!(
                (last - expect).abs() < 0.02,
                "{off} {rate}: {last}, not {expect}"
            );
        };
        // K_p = 2, five degrees off less one of the dead band.
        check(|_| {}, 5.0, 0.0, 6.0, -8.0);
        check(|_| {}, -5.0, 0.0, 6.0, 8.0);
        check(|set| set.pid_kp = 3.0, 5.0, 0.0, 6.0, -12.0);
        check(|set| set.dead_band = DeadBand::Maximum, 5.0, 0.0, 6.0, -2.0);
        check(|_| {}, 0.9, 0.0, 6.0, 0.0);
        // v = 5 + 4/2 * 0.5 = 6, k = 5/6: -5/6 (10 + 2).
        check(|set| set.pid_kd = 4.0, 5.0, 30.0, 6.0, -10.0);
        // Ten seconds of 0.01 * 4 degrees.
        check(|set| set.pid_ki = 0.01, 5.0, 0.0, 6.0, -8.4);
        // EMC-7: the cruise speed is the speed of the gains.
        check(|_| {}, 5.0, 0.0, 12.0, -4.0);
        check(|_| {}, 5.0, 0.0, 1.0, -16.0);
        check(|set| set.cruise_speed = 12.0, 5.0, 0.0, 12.0, -8.0);
    }

    // EMC-2: between two samples the rudder stays.
    #[test]
    fn the_rudder_is_sampled_at_the_sample_time() {
        let changes = |sample: f64| {
            let gains = gains(|set| set.sample_time = sample);
            let (_, wanted) = run(&gains, 20.0, |t| (5.0 + t / 10.0, 0.0), 6.0);
            let changed = wanted.windows(2).filter(|pair| pair[0] != pair[1]);
            changed.count()
        };
        assert_eq!(
            [100.0, 200.0, 1000.0, 5000.0].map(changes),
            [199, 99, 19, 3]
        );
    }

    // EMC-7: the order rests until the wanted rudder is farther off it than the damping.
    #[test]
    fn damping_lets_the_order_rest() {
        let sea = |t: f64| (5.0 + libm::sin(t), 0.0);
        let moves = |damping: f64| {
            let gains = gains(|set| set.rudder_damping = damping);
            let (_, wanted) = run(&gains, 60.0, sea, 6.0);
            let changed = wanted.windows(2).filter(|pair| pair[0] != pair[1]);
            changed.count()
        };
        let [none, little, much] = [0.0, 1.0, 5.0].map(moves);
        assert!(
            none > 500 && little < 100 && little > 10 && much == 0,
            "{none} {little} {much}"
        );
    }

    // EMC-2: the automatic dead band follows the waves, between the least and the greatest.
    #[test]
    fn the_automatic_dead_band_grows_with_the_waves() {
        let band = |yaw: f64, band: DeadBand| {
            let gains = gains(|set| set.dead_band = band);
            let sea = |t: f64| (yaw * libm::sin(1.5 * t), 0.0);
            run(&gains, 300.0, sea, 6.0).0.dead_band(&gains)
        };
        assert_eq!(band(0.0, DeadBand::Automatic), LEAST);
        let middle = band(2.0, DeadBand::Automatic);
        assert!((middle - 1.5 * libm::sqrt(2.0)).abs() < 0.2, "{middle}");
        assert_eq!(band(9.0, DeadBand::Automatic), GREATEST);
        assert_eq!(band(9.0, DeadBand::Minimum), LEAST);
        assert_eq!(band(0.0, DeadBand::Maximum), GREATEST);
    }

    #[test]
    fn the_trim_is_held_in_turns_and_while_the_order_is_cut() {
        let gains = gains(|set| set.pid_ki = 0.1);
        let trim = |rate: f64, cut: f64| {
            let mut pid = Pid::default();
            let reference = ReferenceModel {
                rate,
                ..ReferenceModel::default()
            };
            let said = (Heading::from_deg(5.0), RateOfTurn::default());
            for _ in 0..100 {
                pid.step(&gains, said, &reference, (Speed::from_knots(6.0), cut), 0.1);
            }
            pid.trim
        };
        assert!((trim(0.0, 0.0) + 4.0).abs() < 0.01);
        assert_eq!(trim(0.01, 0.0), 0.0);
        assert_eq!(trim(0.0, -4.0), 0.0, "more than the limit gives");
        assert!((trim(0.0, 4.0) + 4.0).abs() < 0.01, "back from the limit");
    }
}

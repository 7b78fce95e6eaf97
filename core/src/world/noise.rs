//! A small seeded generator and the noises made with it.

use core::f64::consts::PI;
use serde::{Deserialize, Serialize};

/// SplitMix64: the same seed gives the same numbers everywhere.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct Random(u64);

impl Random {
    /// From a seed.
    #[must_use]
    pub const fn new(seed: u64) -> Self {
        Self(seed)
    }

    /// Any 64 bits.
    pub const fn bits(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^ (z >> 31)
    }

    /// Uniform, above 0 and up to 1.
    pub const fn uniform(&mut self) -> f64 {
        ((self.bits() >> 11) + 1) as f64 / (1_u64 << 53) as f64
    }

    /// Normal, mean 0, deviation 1 (Box and Muller).
    pub fn normal(&mut self) -> f64 {
        let radius = libm::sqrt(-2.0 * libm::log(self.uniform()));
        radius * libm::cos(2.0 * PI * self.uniform())
    }
}

/// Yaw by waves: white noise through `s/(s^2 + 2 lambda w s + w^2)`, lambda 0.1, unit deviation.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Waves {
    integral: f64,
    yaw: f64,
}

impl Waves {
    /// One step; gives yaw and its rate of change for a unit deviation.
    pub fn step(&mut self, frequency: f64, random: &mut Random, dt: f64) -> (f64, f64) {
        let kick = libm::sqrt(0.4 * frequency * dt) * random.normal();
        let before = self.yaw;
        self.yaw += dt * (-frequency * frequency * self.integral - 0.2 * frequency * self.yaw);
        self.yaw += kick;
        self.integral += dt * self.yaw;
        (self.yaw, (self.yaw - before) / dt)
    }
}

/// Slow error of a position receiver: first-order Gauss-Markov, unit deviation.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Drift(f64);

impl Drift {
    /// One step with time constant `tau`.
    pub fn step(&mut self, tau: f64, random: &mut Random, dt: f64) -> f64 {
        let keep = libm::exp(-dt / tau);
        self.0 = keep * self.0 + libm::sqrt(1.0 - keep * keep) * random.normal();
        self.0
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn noises_have_unit_deviation() {
        let mut random = Random::new(7);
        let (mut waves, mut drift) = (Waves::default(), Drift::default());
        let mut sums = [0.0; 3];
        let count = 200_000;
        for _ in 0..count {
            let yaw = waves.step(0.55, &mut random, 0.1).0;
            let slow = drift.step(6.0, &mut random, 0.1);
            for (sum, x) in sums.iter_mut().zip([random.normal(), yaw, slow]) {
                *sum += x * x;
            }
        }
        for sum in sums {
            let deviation = libm::sqrt(sum / f64::from(count));
            assert!((0.85..1.15).contains(&deviation), "{deviation}");
        }
    }
}

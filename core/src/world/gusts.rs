//! Gusts: the wind's speed and direction wander about their means.

use super::noise::{Drift, Random};
use crate::units::{Course, Speed};
use serde::{Deserialize, Serialize};

/// Time constants of speed and direction, s.
const SPEED_TIME: f64 = 6.0;
const VEER_TIME: f64 = 25.0;
/// Deviation of the direction for a gustiness of one, degrees.
const VEER_DEG: f64 = 30.0;

/// What the gusts make of the wind now.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub(super) struct Gusts {
    speed: Drift,
    veer: Drift,
    /// Deviations: of the speed as a part of it, of the direction in degrees.
    now: (f64, f64),
}

impl Gusts {
    /// Goes on for `dt` seconds; `gustiness` is the deviation of the speed as a part of its mean, 0 for a steady wind.
    pub(super) fn step(&mut self, gustiness: f64, random: &mut Random, dt: f64) {
        if gustiness > 0.0 {
            let speed = gustiness * self.speed.step(SPEED_TIME, random, dt);
            let veer = gustiness * VEER_DEG * self.veer.step(VEER_TIME, random, dt);
            self.now = (speed, veer);
        }
    }

    /// Where the wind comes from and its speed, by its means.
    pub(super) fn of(&self, (from, speed): (Course, Speed)) -> (Course, Speed) {
        let (gust, veer) = self.now;
        let from = Course::from_deg(from.deg() + veer);
        (from, Speed::from_mps(speed.mps() * (1.0 + gust).max(0.0)))
    }
}

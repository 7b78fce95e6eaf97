//! What the ship's sensors measure: truth, noise, and the injuries done to them.

use super::noise::{Drift, Random, Waves};
use crate::geo::{Plane, Point, Position};
use serde::{Deserialize, Serialize};

/// How noisy the sensors are: standard deviations.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Noise {
    /// Yaw by waves, degrees; also in the rate of turn.
    pub wave_yaw: f64,
    /// Encounter frequency of the waves, rad/s.
    pub wave_frequency: f64,
    /// Gyro, degrees.
    pub gyro: f64,
    /// Rate of turn, degrees a second.
    pub rate: f64,
    /// Slow error of the position (60 s), metres in each axis.
    pub position_drift: f64,
    /// Fast error of the position, metres in each axis.
    pub position: f64,
    /// Velocity over ground, m/s in each axis.
    pub velocity: f64,
}

impl Default for Noise {
    fn default() -> Self {
        Self {
            wave_yaw: 0.2,
            wave_frequency: 0.55,
            gyro: 0.05,
            rate: 0.01,
            position_drift: 1.0,
            position: 0.3,
            velocity: 0.03,
        }
    }
}

impl Noise {
    /// Perfect sensors.
    pub const NONE: Self = Self {
        wave_yaw: 0.0,
        wave_frequency: 0.55,
        gyro: 0.0,
        rate: 0.0,
        position_drift: 0.0,
        position: 0.0,
        velocity: 0.0,
    };
}

/// An injury of one sensor: its value jumps, or stays.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub(super) struct Injury {
    pub(super) jump: bool,
    pub(super) stuck: bool,
}

/// Compass: heading and rate of turn, degrees and degrees a minute.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub(super) struct Compass {
    waves: Waves,
    pub(super) injury: Injury,
    pub(super) heading: f64,
    pub(super) rate: f64,
}

const HEADING_JUMP: f64 = 20.0;
const POSITION_JUMP: f64 = 0.2 * crate::units::METRES_PER_NAUTICAL_MILE;

impl Compass {
    /// Measures at ten times a second; truth in degrees and degrees a second.
    pub(super) fn measure(
        &mut self,
        heading: f64,
        rate: f64,
        noise: &Noise,
        random: &mut Random,
        dt: f64,
    ) {
        let (yaw, yaw_rate) = self.waves.step(noise.wave_frequency, random, dt);
        let measured = heading + noise.wave_yaw * yaw + noise.gyro * random.normal();
        let rate = rate + noise.wave_yaw * yaw_rate + noise.rate * random.normal();
        self.rate = rate * 60.0;
        if !self.injury.stuck {
            let jump = if self.injury.jump { HEADING_JUMP } else { 0.0 };
            self.heading = crate::units::wrap_360(measured + jump);
        }
    }
}

/// Position receiver: place, course and speed over ground (m/s).
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub(super) struct Receiver {
    drift: [Drift; 2],
    pub(super) injury: Injury,
    pub(super) position: Position,
    pub(super) course: f64,
    pub(super) speed: f64,
}

impl Receiver {
    pub(super) fn at(position: Position) -> Self {
        Self {
            drift: [Drift::default(); 2],
            injury: Injury::default(),
            position,
            course: 0.0,
            speed: 0.0,
        }
    }

    /// Measures once a second; the velocity is over ground, m/s north and east.
    pub(super) fn measure(
        &mut self,
        plane: &Plane,
        place: Point,
        velocity: (f64, f64),
        noise: &Noise,
        random: &mut Random,
    ) {
        let mut error = [0.0; 2];
        for (drift, error) in self.drift.iter_mut().zip(&mut error) {
            *error = noise.position_drift * drift.step(60.0, random, 1.0)
                + noise.position * random.normal();
        }
        let north = velocity.0 + noise.velocity * random.normal();
        let east = velocity.1 + noise.velocity * random.normal();
        if self.injury.stuck {
            return;
        }
        let jump = if self.injury.jump { POSITION_JUMP } else { 0.0 };
        self.position = plane.position(Point {
            north: place.north + error[0] + jump,
            east: place.east + error[1],
        });
        self.course = crate::units::wrap_360(libm::atan2(east, north).to_degrees());
        self.speed = libm::hypot(north, east);
    }
}

//! Position and current between the fixes.
//!
//! ```text
//! v_w  = u (cos psi, sin psi) + v (-sin psi, cos psi)   through the water [m/s]; sway v from the observer
//! V_c' = (v_ground - v_w - V_c) / tau                   current [m/s], tau 40-60 s
//! p'   = v_w + V_c + (p_fix - p) / tau_p                position [m]
//! ```
//! So the crab angle is known at once on any course. A fix more than 100 m away begins anew there.

use super::measured::Measured;
use super::observer::Motion;
use super::settings::SteeringSettings;
use crate::geo::Point;
use serde::{Deserialize, Serialize};

const JUMP: f64 = 100.0;

/// Estimated position and current.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub(super) struct Reckoning {
    current: Point,
    samples: f64,
    last_velocity: Option<Point>,
    velocity_age: f64,
    position: Option<Point>,
    last_fix: Option<Point>,
    fix_age: f64,
}

/// Position, velocity over ground and current, metres and seconds.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Sailing {
    pub(super) position: Option<Point>,
    /// Velocity over ground.
    pub(super) velocity: Point,
    /// Speed through the water with the sway.
    pub(super) water_speed: f64,
    pub(super) current: Point,
}

impl Reckoning {
    pub(super) fn step(
        &mut self,
        m: &Measured,
        motion: &Motion,
        surge: f64,
        settings: &SteeringSettings,
        dt: f64,
    ) -> Sailing {
        let (sine, cosine) = (libm::sin(motion.heading), libm::cos(motion.heading));
        let water = Point {
            north: surge * cosine - motion.sway * sine,
            east: surge * sine + motion.sway * cosine,
        };
        if let Some((course, speed)) = m.ground {
            let measured = Point {
                north: speed.mps() * libm::cos(course.rad()),
                east: speed.mps() * libm::sin(course.rad()),
            };
            self.hear_velocity(measured, water, settings.current_time, dt);
        }
        let velocity = Point {
            north: water.north + self.current.north,
            east: water.east + self.current.east,
        };
        if let Some(position) = &mut self.position {
            position.north += velocity.north * dt;
            position.east += velocity.east * dt;
        }
        self.hear_fix(m.position, settings, dt);
        Sailing {
            position: self.position,
            velocity,
            water_speed: libm::hypot(water.north, water.east),
            current: self.current,
        }
    }

    /// A repeated value is an old one until a second has passed.
    fn hear_velocity(&mut self, measured: Point, water: Point, tau: f64, dt: f64) {
        self.velocity_age += dt;
        if self.last_velocity == Some(measured) && self.velocity_age < 1.0 {
            return;
        }
        self.samples += 1.0;
        let weight = (self.velocity_age / tau.max(1.0))
            .max(1.0 / self.samples)
            .min(1.0);
        self.current.north += weight * (measured.north - water.north - self.current.north);
        self.current.east += weight * (measured.east - water.east - self.current.east);
        self.last_velocity = Some(measured);
        self.velocity_age = 0.0;
    }

    fn hear_fix(&mut self, fix: Option<Point>, settings: &SteeringSettings, dt: f64) {
        self.fix_age += dt;
        let Some(fix) = fix else {
            self.last_fix = None;
            return;
        };
        if self.last_fix == Some(fix) {
            return;
        }
        self.position = Some(match self.position {
            Some(p) if p.distance(fix) < JUMP => {
                let weight = (self.fix_age / settings.fix_time.max(1.0)).min(1.0);
                Point {
                    north: p.north + weight * (fix.north - p.north),
                    east: p.east + weight * (fix.east - p.east),
                }
            }
            _ => fix,
        });
        self.last_fix = Some(fix);
        self.fix_age = 0.0;
    }
}

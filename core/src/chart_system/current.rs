//! The current as the chart system estimates it in "Tn", to aim off on a leg.
//!
//! `V = LP(v_ground - v_water)` with a time constant of 40 s; on a course `c` the crab angle is
//! `asin(-V_across / U_water)` and so is known at once on any other course.

use super::position::OverGround;
use crate::units::{Course, Heading, Speed};
use serde::{Deserialize, Serialize};

const TIME_CONSTANT_S: f64 = 40.0;

/// Current in metres a second north and east.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub(super) struct Current {
    estimate: Option<(f64, f64)>,
}

impl Current {
    /// Learns from one second on a steady course.
    pub(super) fn learn(&mut self, ground: OverGround, heading: Heading, water: Speed) {
        let component = |f: fn(f64) -> f64| {
            ground.speed.mps() * f(ground.course.rad()) - water.mps() * f(heading.rad())
        };
        let (north, east) = (component(libm::cos), component(libm::sin));
        let (old_north, old_east) = self.estimate.unwrap_or((north, east));
        let share = 1.0 / TIME_CONSTANT_S;
        self.estimate = Some((
            old_north + share * (north - old_north),
            old_east + share * (east - old_east),
        ));
    }

    /// Degrees to add to a course so that the ship makes it good.
    pub(super) fn crab_deg(&self, course: Course, water: Speed) -> f64 {
        let Some((north, east)) = self.estimate else {
            return 0.0;
        };
        let across = east * libm::cos(course.rad()) - north * libm::sin(course.rad());
        let ratio = (-across / water.mps().max(1.0)).clamp(-0.5, 0.5);
        libm::asin(ratio) * 180.0 / core::f64::consts::PI
    }
}

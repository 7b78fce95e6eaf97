//! The current as the chart system estimates it in "Tn", to aim off on a leg.
//!
//! `V = LP(v_ground - v_water)` with a time constant of 40 s; on a course `c` the crab angle is
//! `asin(-V_across / U_water)` and so is known at once on any other course.

use super::place::OverGround;
use crate::geo::Point;
use crate::units::{Course, Heading, Speed};
use serde::{Deserialize, Serialize};

const TIME_CONSTANT_S: f64 = 40.0;

/// Current: where a second of it carries the ship.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub(super) struct Current {
    estimate: Option<Point>,
}

impl Current {
    /// Learns from one second on a steady course.
    pub(super) fn learn(&mut self, ground: OverGround, heading: Heading, water: Speed) {
        let second = |degrees, speed: Speed| Point::default().towards(degrees, speed.mps());
        let over_ground = second(ground.course.deg(), ground.speed);
        let through_water = second(heading.deg(), water);
        let seen = Point {
            north: over_ground.north - through_water.north,
            east: over_ground.east - through_water.east,
        };
        let before = self.estimate.unwrap_or(seen);
        let share = 1.0 / TIME_CONSTANT_S;
        self.estimate = Some(Point {
            north: before.north + share * (seen.north - before.north),
            east: before.east + share * (seen.east - before.east),
        });
    }

    /// Where a second of it carries the ship, metres.
    pub(super) fn mps(&self) -> Point {
        self.estimate.unwrap_or_default()
    }

    /// Degrees to add to a course so that the ship makes it good.
    pub(super) fn crab_deg(&self, course: Course, water: Speed) -> f64 {
        let Some(current) = self.estimate else {
            return 0.0;
        };
        let (_, across) = current.off_line(Point::default(), course);
        let ratio = (-across / water.mps().max(1.0)).clamp(-0.5, 0.5);
        libm::asin(ratio) * 180.0 / core::f64::consts::PI
    }
}

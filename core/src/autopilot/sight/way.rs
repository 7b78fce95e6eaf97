//! Course and speed over ground by the fixes of one receiver (AP-9: marked C).
//!
//! ```text
//! v_s = sum (t - t_m)(p - p_m) / sum (t - t_m)^2              slope of the fixes of the last T seconds [m/s], t_m their mean time
//! v   = R(r dt) v + dt/(dt + tau) (R(r (t - t_m)) v_s - R(r dt) v)
//! ```
//! `R` turns by the rate of turn `r` [rad/s] over the same time, low-passed, since a slope is of the middle of its fixes; `T` is 10 s,
//! in a tight turn less, `tau` 2 s.
//! A fix off where the last one and `v` put it, or fixes that lie on no line, are no way made by the ship: the fixes are gathered
//! anew from the last one, and `v` stays until its age limit. So a position that jumps, or one of two decimals, gives no speed.

use crate::geo::Point;
use crate::time::Stamp;
use crate::units::RateOfTurn;
use alloc::vec::Vec;
use serde::{Deserialize, Serialize};

/// Fixes that count: not nearer in time than this, of no more than the last seconds, and of no fewer.
const APART_MS: u64 = 700;
const WINDOW_MS: u64 = 10_000;
const LEAST_MS: u64 = 3_000;
/// The window is shorter where the ship turns by more in it, degrees, but never shorter than this.
const WINDOW_TURN_DEG: f64 = 20.0;
const SHORT_WINDOW_MS: u64 = 4_000;
/// A fix that is off by more is no way made, metres, and metres for each second since the one before.
const STEP: (f64, f64) = (4.0, 1.0);
/// Fixes that are off their line by more are no way made, metres.
const OFF_LINE_M: f64 = 4.0;
/// Time constant of what the slopes say, seconds.
const SMOOTH_S: f64 = 2.0;
/// Time constant of the rate of turn, seconds.
const TURN_S: f64 = 5.0;
/// A velocity is used for so long after its last fix (AP-9).
const LOST_MS: u64 = 5_000;

/// The fixes of a receiver, and the velocity that they make, metres a second.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub(super) struct Way {
    fixes: Vec<(Point, Stamp)>,
    velocity: Option<(Point, Stamp)>,
    /// How she has turned of late: her course over ground follows the bow.
    turn: Option<RateOfTurn>,
}

impl Way {
    /// Takes a fix that is believed, while the ship turns at `turn`.
    pub(super) fn take(&mut self, point: Point, at: Stamp, turn: RateOfTurn) {
        let Some((last, then)) = self.fixes.last().copied() else {
            self.fixes.push((point, at));
            return;
        };
        let (ms, dt) = (at.since(then), seconds(then, at));
        if ms < APART_MS {
            return;
        }
        let turn = self.turned_of_late(turn, dt);
        let before = (self.velocity).map(|(v, when)| (turned(v, turn, dt), when));
        let off = before.map_or(0.0, |(v, _)| {
            let there = Point {
                north: last.north + v.north * dt,
                east: last.east + v.east * dt,
            };
            point.distance(there)
        });
        if off > STEP.0 + STEP.1 * dt || ms > LOST_MS {
            self.fixes.clear();
        }
        self.fixes.push((point, at));
        let window = window(turn);
        self.fixes.retain(|(_, then)| at.since(*then) <= window);
        self.velocity = before;
        let Some((slope, middle)) = self.slope(at) else {
            return;
        };
        let slope = turned(slope, turn, -middle);
        let share = dt / (dt + SMOOTH_S);
        let velocity = before.map_or(slope, |(v, _)| Point {
            north: v.north + share * (slope.north - v.north),
            east: v.east + share * (slope.east - v.east),
        });
        self.velocity = Some((velocity, at));
    }

    fn turned_of_late(&mut self, turn: RateOfTurn, dt: f64) -> RateOfTurn {
        let late = self.turn.unwrap_or(turn).deg_per_min();
        let share = dt / (dt + TURN_S);
        let turn = RateOfTurn::from_deg_per_min(late + share * (turn.deg_per_min() - late));
        self.turn = Some(turn);
        turn
    }

    /// The velocity and when it was found, unless that is too long ago.
    pub(super) fn velocity(&self, now: Stamp) -> Option<(Point, Stamp)> {
        (self.velocity).filter(|(_, at)| now.since(*at) <= LOST_MS)
    }

    /// Carries its places into another plane.
    pub(super) fn carry(&mut self, carry: &impl Fn(&mut Point)) {
        self.fixes.iter_mut().for_each(|(point, _)| carry(point));
    }

    /// The slope of the fixes and their mean time, seconds from `at`; absent where they are too few or on no line.
    fn slope(&mut self, at: Stamp) -> Option<(Point, f64)> {
        let first = self.fixes.first()?.1;
        if at.since(first) < LEAST_MS {
            return None;
        }
        let count = self.fixes.len() as f64;
        let (mut t, mut north, mut east) = (0.0, 0.0, 0.0);
        for (point, then) in &self.fixes {
            t -= seconds(*then, at) / count;
            north += point.north / count;
            east += point.east / count;
        }
        let (mut spread, mut slope) = (0.0, Point::default());
        for (point, then) in &self.fixes {
            let by = -seconds(*then, at) - t;
            spread += by * by;
            slope.north += by * (point.north - north);
            slope.east += by * (point.east - east);
        }
        slope = Point {
            north: slope.north / spread,
            east: slope.east / spread,
        };
        let off_line = |(point, then): &(Point, Stamp)| {
            let by = -seconds(*then, at) - t;
            let there = Point {
                north: north + slope.north * by,
                east: east + slope.east * by,
            };
            point.distance(there) > OFF_LINE_M
        };
        if self.fixes.iter().any(off_line) {
            self.fixes.drain(..self.fixes.len() - 1);
            return None;
        }
        Some((slope, t))
    }
}

fn window(turn: RateOfTurn) -> u64 {
    let rate = libm::fabs(turn.deg_per_s()).max(1e-3);
    let most = (WINDOW_TURN_DEG / rate * 1000.0) as u64;
    most.clamp(SHORT_WINDOW_MS, WINDOW_MS)
}

fn seconds(from: Stamp, to: Stamp) -> f64 {
    to.since(from) as f64 / 1000.0
}

/// Turned to starboard at a rate for so many seconds.
fn turned(velocity: Point, turn: RateOfTurn, seconds: f64) -> Point {
    let angle = turn.deg_per_s().to_radians() * seconds;
    let (sine, cosine) = (libm::sin(angle), libm::cos(angle));
    Point {
        north: velocity.north * cosine - velocity.east * sine,
        east: velocity.east * cosine + velocity.north * sine,
    }
}

#[cfg(test)]
mod tests;

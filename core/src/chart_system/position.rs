//! What the chart system makes of its picture: where the ship is at the moment of sending, and how she moves (AP-9, FA9, TCS-3).

use super::place::{Here, OverGround};
use super::state::ChartSystem;
use crate::geo::{Point, Position};
use crate::limits::{Quantity, limits};
use crate::nmea::{SteeringMode, UtcTime};
use crate::time::Stamp;
use crate::units::{Course, Heading, Speed};

/// A fix that differs from dead reckoning by more than this is not used at once, metres (FA9).
const JUMP_M: f64 = 50.0;
/// So many fixes in a row off dead reckoning are a new position.
const JUMPS: u8 = 3;
/// Without course and speed over ground a fix can only be held, and not for longer, milliseconds.
const HELD_MS: u64 = 2_000;
/// Slower than this a course over ground means nothing and may be missing, knots.
const STILL_KNOTS: f64 = 0.5;

impl ChartSystem {
    /// Judges a fix that has come since the last call.
    pub(super) fn judge_fix(&mut self, now: Stamp) {
        let Some(heard) = self.post.picture.fix(now) else {
            return;
        };
        if heard.not_valid.is_some() {
            self.guard.fix = None; // TCS-3: not valid is known at once
            return;
        }
        if self.guard.judged.is_some_and(|judged| judged >= heard.at) {
            return;
        }
        let (fix, at) = (heard.value, heard.at);
        self.guard.judged = Some(at);
        if let Some((expected, age)) = self.reckoned(now)
            && age <= limits(Quantity::Position).1
            && expected.distance(fix.position) > JUMP_M
        {
            self.guard.off += 1;
            if self.guard.off < JUMPS {
                return; // FA9: not used
            }
            self.guard.jumped = true;
        }
        self.guard.off = 0;
        self.guard.fix = Some((fix, at));
    }

    /// The antenna's place by dead reckoning from the last fix, and the age of that fix.
    fn reckoned(&self, now: Stamp) -> Option<(Position, u64)> {
        let (fix, at) = self.guard.fix?;
        let age = now.since(at);
        let Some(ground) = self.ground_at(now) else {
            return Some((fix.position, age));
        };
        let run = ground.speed.mps() * age as f64 / 1000.0;
        let by = Point::default().towards(ground.course.deg(), run);
        Some((fix.position.moved(by), age))
    }

    /// The conning position at the moment of sending, by dead reckoning where that goes on (TCS-14); else none once the last
    /// fix is older than 5 s.
    pub(super) fn here(&self, now: Stamp) -> Option<Here> {
        self.fixed_here(now)
            .or_else(|| Some(self.reckoning.as_ref()?.here(now)))
    }

    /// The conning position by the receiver.
    pub(super) fn fixed_here(&self, now: Stamp) -> Option<Here> {
        let (antenna, age) = self.reckoned(now)?;
        let limit = if self.ground_at(now).is_some() {
            limits(Quantity::Position).1
        } else {
            HELD_MS
        };
        if age > limit {
            return None;
        }
        let (fix, _) = self.guard.fix?;
        let offset_m = self.config.conning_offset_m;
        let position = match self.heading_at(now) {
            Some(heading) if offset_m != [0.0, 0.0] => {
                let there = Point::default()
                    .towards(heading.deg(), offset_m[0])
                    .towards(heading.deg() + 90.0, offset_m[1]);
                antenna.moved(there)
            }
            _ => antenna,
        };
        let utc = fix
            .utc
            .map(|utc| UtcTime::from_seconds(utc + age as f64 / 1000.0));
        Some(Here {
            position,
            utc,
            mode: fix.mode,
        })
    }

    /// Course and speed over ground, at most 5 s old, or by dead reckoning (TCS-14).
    pub(super) fn ground_at(&self, now: Stamp) -> Option<OverGround> {
        let reckoned = || Some(self.reckoning.as_ref()?.over_ground());
        self.fixed_ground(now).or_else(reckoned)
    }

    fn fixed_ground(&self, now: Stamp) -> Option<OverGround> {
        let heard = self.post.picture.ground(now);
        let ground = self.post.fresh(heard, Quantity::Ground, now)?;
        let still = ground.speed.knots() < STILL_KNOTS;
        let course = ground.course.or(still.then(|| Course::from_deg(0.0)))?;
        Some(OverGround {
            course,
            speed: ground.speed,
            mode: ground.mode,
        })
    }

    /// Heading of a compass, else the one that the autopilot forwards; at most 2 s old.
    pub(super) fn heading_at(&self, now: Stamp) -> Option<Heading> {
        let heard = self.post.picture.heading(now);
        let bearing = self.post.fresh(heard, Quantity::Heading, now)?;
        bearing.true_heading(self.post.picture.variation(now))
    }

    /// Speed through the water, at most 5 s old.
    pub(super) fn water_at(&self, now: Stamp) -> Option<Speed> {
        let heard = self.post.picture.water_speed(now);
        self.post.fresh(heard, Quantity::WaterSpeed, now)
    }

    /// The autopilot's steering mode by HTD; the outer none where no HTD was heard for 5 s.
    pub(super) fn steering_at(&self, now: Stamp) -> Option<Option<SteeringMode>> {
        let heard = self.post.picture.htd.as_ref();
        let htd = self.post.fresh(heard, Quantity::Report, now)?;
        Some(htd.steering_mode)
    }
}

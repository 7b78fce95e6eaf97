//! What the sensors say, judged: heading, rate of turn, position, speeds (AP-9, FA7 to FA10).

use super::guard::{FixVerdict, HeadingVerdict};
use super::modes::{Cause, Event};
use super::steering::Measured;
use super::{Autopilot, Mode};
use crate::alerts::Alert;
use crate::limits::{Quantity, limits};
use crate::picture::Heard;
use crate::time::Stamp;
use crate::units::{Heading, RateOfTurn, Speed, Turn};
use alloc::format;

impl Autopilot {
    /// A heard value that is fresh and was heard since the last stall.
    pub(super) fn fresh<T: Clone>(
        &self,
        heard: Option<&Heard<T>>,
        quantity: Quantity,
    ) -> Option<T> {
        self.post.fresh(heard, quantity, self.now)
    }

    pub(super) fn read_sensors(&mut self, now: Stamp) {
        let rate = self.fresh(self.post.picture.rate(now), Quantity::RateOfTurn);
        let sensed = rate.unwrap_or(self.rate);
        // A slow compass is carried on by the rate of turn until it is heard again.
        let read = self
            .fresh(self.post.picture.heading(now), Quantity::Heading)
            .zip(self.post.picture.heading(now))
            .map(|(read, heard)| {
                let age = now.since(heard.at) as f64 / 1000.0;
                read + Turn::from_deg(sensed.deg_per_s() * age)
            });
        let judged = read.map(|read| {
            self.heading_guard
                .judge(now, read, sensed, self.settings.heading_jump)
        });
        let before = self.heading;
        self.heading = match judged {
            Some(HeadingVerdict::Good(heading) | HeadingVerdict::Bridged(heading)) => Some(heading),
            Some(HeadingVerdict::Invalid) | None => None,
        };
        if read.is_none() {
            self.heading_guard.reset();
        }
        let jumped = matches!(
            judged,
            Some(HeadingVerdict::Bridged(_) | HeadingVerdict::Invalid)
        );
        self.alerts.set(now, Alert::HeadingJump, jumped, "");
        self.rate =
            rate.unwrap_or_else(|| derived_rate(before, self.heading, self.rate, self.step_ms()));
        if self.heading.is_none()
            && !self.recovers(now)
            && self.mode != Mode::Standby
            && !matches!(self.mode, Mode::RudderHold { .. })
        {
            let why = if judged.is_some() {
                "the heading jumped"
            } else {
                "no heading for 2 s"
            };
            self.alerts.raise(now, Alert::HeadingLost, "");
            self.pending = None;
            self.apply(now, &Event::HeadingLost, &format!("{why}: rudder held"));
        }
        self.read_position(now);
    }

    /// FA16: after a stall the order is frozen, and a heading is lost only when none comes again.
    fn recovers(&self, now: Stamp) -> bool {
        let (_, lost) = limits(Quantity::Heading);
        self.post
            .stalled_at()
            .is_some_and(|after| now.since(after) <= lost)
    }

    pub(super) fn read_position(&mut self, now: Stamp) {
        if let Some(ground) = self.fresh(self.post.picture.ground(now), Quantity::Ground) {
            self.position_guard.ground(ground.course, ground.speed);
        }
        let heard = self.post.picture.fix(now);
        let new = heard.filter(|fix| self.last_fix.is_none_or(|last| fix.at > last));
        let new = new.map(|fix| (fix.at, fix.value));
        if let Some((at, fix)) = new {
            self.last_fix = Some(at);
            let verdict = self
                .position_guard
                .judge(at, fix.position, self.settings.position_jump);
            self.alerts
                .set(now, Alert::PositionJump, verdict != FixVerdict::Taken, "");
            let engaged = self.mode.is_autonav();
            self.alerts
                .set(now, Alert::NoDifferential, engaged && !fix.corrected(), "");
            if verdict == FixVerdict::Jumped && matches!(self.mode, Mode::AutonavTi { .. }) {
                self.track_fail(now, Cause::PositionJump, "the position jumped");
            }
        }
        self.recentre();
        let speed = self
            .fresh(self.post.picture.ground(now), Quantity::Ground)
            .is_some()
            || self
                .fresh(self.post.picture.water_speed(now), Quantity::WaterSpeed)
                .is_some();
        self.alerts.set(
            now,
            Alert::SpeedLost,
            !speed && self.mode != Mode::Standby,
            "",
        );
    }

    pub(super) fn measured(&self, now: Stamp) -> Option<Measured> {
        let ground = self.fresh(self.post.picture.ground(now), Quantity::Ground);
        let water = self.fresh(self.post.picture.water_speed(now), Quantity::WaterSpeed);
        let cruise = Speed::from_knots(self.settings.cruise_speed);
        let speed = water
            .or(ground.as_ref().map(|ground| ground.speed))
            .unwrap_or(cruise);
        Some(Measured {
            heading: self.heading?,
            rate: self.rate,
            rudder: self.fresh(self.post.picture.rudder.as_ref(), Quantity::Rudder),
            water_speed: Some(speed),
            ground: ground.and_then(|ground| ground.course.map(|course| (course, ground.speed))),
            position: self.position_guard.fix(now),
        })
    }
}

/// Rate of turn from the heading where no sensor gives it, smoothed over about 3 s.
fn derived_rate(
    before: Option<Heading>,
    now: Option<Heading>,
    rate: RateOfTurn,
    step_ms: u64,
) -> RateOfTurn {
    let (Some(before), Some(now)) = (before, now) else {
        return RateOfTurn::default();
    };
    let dt = step_ms as f64 / 1000.0;
    let raw = (now - before).deg() / dt * 60.0;
    let share = dt / 3.0;
    RateOfTurn::from_deg_per_min(rate.deg_per_min() + share * (raw - rate.deg_per_min()))
}

//! What the chart system does without a position, where dead reckoning is set: goes on, calls for the helm, ends (TCS-14).

use super::control::Commanding;
use super::reckoning::{Known, Reckoning};
use super::state::ChartSystem;
use crate::alerts::Alert;
use crate::geo::{Point, Position};
use crate::time::Stamp;
use crate::units::Distance;
use alloc::format;

/// The last known place must be younger than this, milliseconds.
const BEGINS_MS: u64 = 10_000;
/// Longest dead reckoning, milliseconds.
const LONGEST_MS: u64 = 600_000;
/// Between two calls for manual steering, milliseconds.
const CALL_MS: u64 = 120_000;

impl ChartSystem {
    /// One second of it, where it is set and control needs it; ends control where it may be too far off.
    pub(super) fn reckon(&mut self, now: Stamp) {
        if !self.config.dead_reckoning {
            return;
        }
        if let Some(here) = self.fixed_here(now) {
            self.compare_with_reckoning(now, here.position);
            let over_ground = self.ground_at(now).map(|ground| ground.speed);
            let speed = self.water_at(now).or(over_ground).unwrap_or_default();
            let (place, at) = (here.position, now);
            self.known = Some(Known { place, at, speed });
            return;
        }
        let controls = matches!(
            self.control,
            Commanding::Track { .. } | Commanding::Heading { leg: None }
        );
        if !controls {
            self.stop_reckoning(now);
            return;
        }
        let known = self.known.filter(|known| now.since(known.at) <= BEGINS_MS);
        let Some(before) = self.reckoning.or_else(|| known.map(Reckoning::from)) else {
            return;
        };
        let Some(heading) = self.heading_at(now) else {
            return self.give_up_reckoning(now, "no position and no heading");
        };
        let speed = self.water_at(now).unwrap_or(before.speed);
        let water = Point::default().towards(heading.deg(), speed.mps());
        let current = self.current.mps();
        let drift = Point {
            north: water.north + current.north,
            east: water.east + current.east,
        };
        let moved = Reckoning { drift, ..before };
        let seconds = now.since(before.at) as f64 / 1_000.0;
        let next = Reckoning {
            place: moved.here(now).position,
            at: now,
            way_m: before.way_m + speed.mps() * seconds,
            ..moved
        };
        self.reckoning = Some(next);
        let off = next.two_sigma();
        if self.corridor().is_some_and(|corridor| off > corridor) {
            self.give_up_reckoning(now, "dead reckoning may be off by more than the corridor");
        } else if now.since(next.since) >= LONGEST_MS {
            self.give_up_reckoning(now, "ten minutes of dead reckoning");
        } else {
            self.call_for_the_helm(now, off);
        }
    }

    /// "Use manual steering", each two minutes anew.
    fn call_for_the_helm(&mut self, now: Stamp, off: Distance) {
        let Some(reckoning) = &mut self.reckoning else {
            return;
        };
        let text = format!(
            "No position: dead reckoning, two sigma {:.0} m. Use manual steering",
            off.m()
        );
        self.why.clone_from(&text);
        if now.since(reckoning.called) >= CALL_MS {
            reckoning.called = now;
            self.watch.alerts.end(now, Alert::ManualSteering);
        }
        self.watch.raise(now, Alert::ManualSteering, &text);
    }

    /// The position is back: what it says must be what was reckoned, else nobody knows where control would go on.
    fn compare_with_reckoning(&mut self, now: Stamp, place: Position) {
        let Some(reckoning) = self.reckoning else {
            return;
        };
        let off = reckoning.here(now).position.distance(place);
        let allowed = reckoning.two_sigma().m();
        self.stop_reckoning(now);
        if off > allowed {
            self.end_control(&format!(
                "the position is back, {off:.0} m off the dead reckoning"
            ));
        }
    }

    fn give_up_reckoning(&mut self, now: Stamp, why: &str) {
        self.stop_reckoning(now);
        self.end_control(why);
    }

    pub(super) fn stop_reckoning(&mut self, now: Stamp) {
        if self.reckoning.take().is_some() {
            self.watch.rectify(now, Alert::ManualSteering);
        }
        self.known = None;
    }

    /// Half the corridor of the leg that is sailed, its smaller side.
    fn corridor(&self) -> Option<Distance> {
        let leg = self.progress?.leg()?;
        Some(self.route.as_ref()?.leg(leg).corridor())
    }

    /// Where the dead reckoning has her, and what it may be off, two sigma; none while the position is known.
    #[must_use]
    pub fn adrift(&self) -> Option<(Position, Distance)> {
        let reckoning = self.reckoning?;
        Some((reckoning.place, reckoning.two_sigma()))
    }
}

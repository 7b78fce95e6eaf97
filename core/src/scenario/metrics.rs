//! The bench's figures: distances from the track, heading overshoot, rudder work.

use super::sample::{STEP, Sample, Stage};
use crate::units::METRES_PER_NAUTICAL_MILE;
use alloc::format;
use alloc::string::String;
use alloc::vec::Vec;
use serde::{Deserialize, Serialize};

/// Names and values in the order of the peers' table.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Report(pub Vec<(String, Option<f64>)>);

impl Report {
    /// The value of a figure.
    #[must_use]
    pub fn value(&self, name: &str) -> Option<f64> {
        self.0.iter().find(|(n, _)| n == name).and_then(|(_, v)| *v)
    }

    pub(super) fn push(&mut self, name: &str, value: Option<f64>) {
        let value = value.filter(|v| v.is_finite());
        self.0
            .push((name.into(), value.map(|v| libm::round(v * 1000.0) / 1000.0)));
    }
}

/// Largest and root of the mean square.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
struct Spread {
    largest: f64,
    squares: f64,
    count: f64,
}

impl Spread {
    fn take(&mut self, x: f64) {
        self.largest = self.largest.max(libm::fabs(x));
        self.squares += x * x;
        self.count += 1.0;
    }

    fn largest(&self) -> Option<f64> {
        (self.count > 0.0).then_some(self.largest)
    }

    fn rms(&self) -> Option<f64> {
        (self.count > 0.0).then(|| libm::sqrt(self.squares / self.count))
    }
}

/// Degrees of rudder moved, and minutes.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
struct Travel {
    degrees: f64,
    minutes: f64,
}

impl Travel {
    fn take(&mut self, change: f64) {
        self.degrees += libm::fabs(change);
        self.minutes += STEP / 60.0;
    }

    fn per_minute(&self) -> Option<f64> {
        (self.minutes > 0.0).then(|| self.degrees / self.minutes)
    }
}

/// Turns of the rudder's direction beyond 0.3 degrees.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
struct Reversals {
    extreme: f64,
    direction: f64,
    count: f64,
    running: bool,
}

impl Reversals {
    fn take(&mut self, rudder: f64, counted: bool) {
        if !counted {
            self.running = false;
            return;
        }
        if !self.running {
            (self.running, self.extreme, self.direction) = (true, rudder, 0.0);
        }
        let moved = rudder - self.extreme;
        if self.direction * moved > 0.0 {
            self.extreme = rudder;
        } else if libm::fabs(moved) > 0.3 {
            self.count += if self.direction == 0.0 { 0.0 } else { 1.0 };
            self.direction = libm::copysign(1.0, moved);
            self.extreme = rudder;
        }
    }
}

/// Heading of one turn and of the leg after it, for the overshoot.
#[derive(Clone, Debug, Default, PartialEq)]
struct Swing {
    /// Heading before the turn, to know its direction.
    before: f64,
    /// Metres along the leg (negative on the arc) and heading.
    trace: Vec<(f64, f64)>,
}

impl Swing {
    /// Largest excess over the mean of the last 0.75 nm, in the direction of the turn.
    fn overshoot(&self) -> Option<f64> {
        let end = self.trace.last()?.0 - 0.75 * METRES_PER_NAUTICAL_MILE;
        let last = self.trace.iter().filter(|(along, _)| *along >= end);
        let (sum, count) = last.fold((0.0, 0.0), |(s, n), (_, heading)| (s + heading, n + 1.0));
        let mean = sum / count;
        let side = libm::copysign(1.0, mean - self.before);
        let first = self.trace.iter().filter(|(along, _)| *along < end);
        Some(
            first
                .map(|(_, heading)| side * (heading - mean))
                .fold(0.0, f64::max),
        )
    }
}

/// Takes the samples of a run.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Meter {
    settled: Spread,
    legs: Spread,
    arcs: Spread,
    arc: Vec<Spread>,
    swings: Vec<Swing>,
    capture_overshoot: f64,
    capture_time: Option<f64>,
    settled_travel: Travel,
    arc_travel: Travel,
    travel: Travel,
    reversals: Reversals,
    rudder: Spread,
    settled_rudder: Spread,
    rate: Spread,
    last: Option<Sample>,
}

impl Meter {
    pub(super) fn new(legs: usize) -> Self {
        let turns = legs.saturating_sub(1);
        Self {
            settled: Spread::default(),
            legs: Spread::default(),
            arcs: Spread::default(),
            arc: alloc::vec![Spread::default(); turns],
            swings: alloc::vec![Swing::default(); turns],
            capture_overshoot: 0.0,
            capture_time: None,
            settled_travel: Travel::default(),
            arc_travel: Travel::default(),
            travel: Travel::default(),
            reversals: Reversals::default(),
            rudder: Spread::default(),
            settled_rudder: Spread::default(),
            rate: Spread::default(),
            last: None,
        }
    }

    /// Takes a sample; `along` is the way made on the present leg.
    pub(super) fn take(&mut self, sample: &Sample, along: f64) {
        let change = self.last.map_or(0.0, |last| sample.rudder - last.rudder);
        let distance = sample.cross_track;
        self.travel.take(change);
        self.rudder.take(sample.rudder);
        self.rate.take(sample.rate * 60.0);
        let mut settled = false;
        match sample.stage {
            Stage::Leg(i) => {
                let after = if i == 0 { 2.0 } else { 1.0 } * METRES_PER_NAUTICAL_MILE;
                settled = along >= after;
                if i == 0 {
                    self.capture(sample);
                } else {
                    self.legs.take(distance);
                    self.swings[i - 1].trace.push((along, sample.heading));
                }
            }
            Stage::Arc(i) => {
                self.arcs.take(distance);
                self.arc[i].take(distance);
                self.arc_travel.take(change);
                let swing = &mut self.swings[i];
                if swing.trace.is_empty() {
                    swing.before = sample.heading;
                }
                swing.trace.push((f64::MIN, sample.heading));
            }
        }
        if settled {
            self.settled.take(distance);
            self.settled_travel.take(change);
            self.settled_rudder.take(sample.rudder);
        }
        self.reversals.take(sample.rudder, settled);
        self.last = Some(*sample);
    }

    fn capture(&mut self, sample: &Sample) {
        self.capture_overshoot = self.capture_overshoot.max(-sample.cross_track);
        if libm::fabs(sample.cross_track) >= 10.0 {
            self.capture_time = None;
        } else if self.capture_time.is_none() {
            self.capture_time = Some(sample.time);
        }
    }

    pub(super) fn report(&self) -> Report {
        let mut report = Report::default();
        report.push("leg_settled_max_m", self.settled.largest());
        report.push("leg_settled_rms_m", self.settled.rms());
        report.push("leg_all_max_m", self.legs.largest());
        report.push("leg_all_rms_m", self.legs.rms());
        report.push("arc_max_m", self.arcs.largest());
        report.push("arc_rms_m", self.arcs.rms());
        for (i, arc) in self.arc.iter().enumerate() {
            report.push(&format!("arc{}_max_m", i + 1), arc.largest());
        }
        report.push("capture_overshoot_m", Some(self.capture_overshoot));
        report.push("capture_time_to_10m_s", self.capture_time);
        let overshoots: Vec<f64> = self.swings.iter().filter_map(Swing::overshoot).collect();
        let most = overshoots.iter().copied().reduce(f64::max);
        let mean = overshoots.iter().sum::<f64>() / overshoots.len() as f64;
        report.push("hdg_overshoot_max_deg", most);
        report.push("hdg_overshoot_mean_deg", Some(mean));
        report.push(
            "rudder_travel_settled_deg_per_min",
            self.settled_travel.per_minute(),
        );
        report.push(
            "rudder_travel_arc_deg_per_min",
            self.arc_travel.per_minute(),
        );
        report.push("rudder_travel_all_deg_per_min", self.travel.per_minute());
        let minutes = self.settled_travel.minutes;
        let reversals = (minutes > 0.0).then(|| self.reversals.count / minutes);
        report.push("rudder_reversals_settled_per_min", reversals);
        report.push("rudder_max_deg", self.rudder.largest());
        report.push("rudder_rms_settled_deg", self.settled_rudder.rms());
        report.push("rot_max_deg_min", self.rate.largest());
        report.push("time_s", self.last.map(|s| s.time));
        report
    }
}

//! Open-loop manoeuvres: turning circle, zigzag, spiral.

use super::metrics::Report;
use crate::command::Refusal;
use crate::units::METRES_PER_SECOND_PER_KNOT;
use crate::world::{Drive, Hull};
use alloc::format;
use alloc::string::String;
use alloc::vec::Vec;
use serde::{Deserialize, Serialize};

/// Integration step, s: that of the reference runs.
const STEP: f64 = 0.05;
const STEPS_PER_ROW: usize = 20;
/// Time after which a turn of the spiral counts as steady, s.
const STEADY: f64 = 3000.0;
/// Rudder angles of the spiral, degrees.
const SPIRAL: [f64; 23] = [
    -35.0, -30.0, -25.0, -20.0, -15.0, -10.0, -7.5, -5.0, -3.0, -2.0, -1.0, 0.0, 1.0, 2.0, 3.0,
    5.0, 7.5, 10.0, 15.0, 20.0, 25.0, 30.0, 35.0,
];

/// A manoeuvre with its ship and times.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Plan {
    /// Name of the ship.
    pub ship: String,
    /// Approach speed, knots.
    pub speed_kn: f64,
    /// When the rudder is put over, s.
    #[serde(default)]
    pub execute_s: f64,
    /// Length of the run, s.
    #[serde(default)]
    pub duration_s: f64,
    /// Largest rudder, degrees.
    #[serde(default)]
    pub rudder_limit_deg: Option<f64>,
    /// What is done.
    pub manoeuvre: Manoeuvre,
}

/// What is done with the rudder.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(tag = "kind", rename_all = "snake_case")]
pub enum Manoeuvre {
    /// The rudder is put over and held.
    Turn {
        /// Rudder, degrees.
        rudder_deg: f64,
    },
    /// The rudder is put over to the other side each time the heading has changed so far.
    Zigzag {
        /// Rudder, degrees.
        rudder_deg: f64,
        /// Heading, degrees.
        heading_deg: f64,
    },
    /// Steady turns for a row of rudder angles.
    Spiral,
}

/// The ship each second.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ManoeuvreRow {
    /// Seconds.
    pub time: f64,
    /// The hull then.
    pub hull: Hull,
    /// Rudder order, degrees.
    pub order: f64,
}

/// One steady turn.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SpiralRow {
    /// Rudder, degrees.
    pub rudder: f64,
    /// Rate of turn, degrees a second.
    pub rate: f64,
    /// Speed through the water, m/s.
    pub speed: f64,
    /// Drift angle, degrees.
    pub drift: f64,
    /// Radius, m.
    pub radius: f64,
}

impl Plan {
    pub(super) fn checked(self) -> Result<Self, Refusal> {
        if self.ship != "mariner" {
            return Err(Refusal::because(format!(
                "ship `{}`: only `mariner` is there",
                self.ship
            )));
        }
        if !(self.speed_kn > 0.0 && self.speed_kn <= 40.0) {
            return Err(Refusal::because(format!(
                "speed_kn is {}, allowed 0 to 40",
                self.speed_kn
            )));
        }
        let times = [self.execute_s, self.duration_s];
        if times.iter().any(|t| !(0.0..=100_000.0).contains(t)) {
            return Err(Refusal::because(
                "execute_s, duration_s: 0 to 100000 allowed",
            ));
        }
        Ok(self)
    }

    fn order(&self, order: f64) -> f64 {
        let limit = self.rudder_limit_deg.map_or(40.0, libm::fabs);
        order.clamp(-limit, limit)
    }

    fn drive(&self, order: f64) -> Drive {
        Drive {
            order: self.order(order).to_radians(),
            approach_speed: self.speed(),
            ..Drive::default()
        }
    }

    fn speed(&self) -> f64 {
        self.speed_kn * METRES_PER_SECOND_PER_KNOT
    }

    /// Sails a turn or a zigzag; `row` is called each second.
    pub fn sail(&self, row: &mut dyn FnMut(&ManoeuvreRow)) {
        let mut hull = Hull::running(0.0, self.speed());
        let mut side = 0.0;
        let rows = libm::floor(self.duration_s) as usize;
        for second in 0..=rows {
            for k in 0..STEPS_PER_ROW {
                let time = (second * STEPS_PER_ROW + k) as f64 * STEP;
                let begun = time >= self.execute_s - STEP / 2.0;
                let order = match self.manoeuvre {
                    Manoeuvre::Turn { rudder_deg } if begun => rudder_deg,
                    Manoeuvre::Zigzag {
                        rudder_deg,
                        heading_deg,
                    } if begun => {
                        let heading = hull.heading.to_degrees();
                        if side == 0.0 {
                            side = 1.0;
                        } else if side * heading >= heading_deg {
                            side = -side;
                        }
                        side * rudder_deg
                    }
                    _ => 0.0,
                };
                if k == 0 {
                    row(&ManoeuvreRow {
                        time,
                        hull,
                        order: self.order(order),
                    });
                }
                hull.step(&self.drive(order), STEP);
            }
        }
    }

    /// The steady turns of the spiral.
    #[must_use]
    pub fn spiral(&self) -> Vec<SpiralRow> {
        SPIRAL.iter().map(|&rudder| self.steady(rudder)).collect()
    }

    fn steady(&self, rudder: f64) -> SpiralRow {
        let mut hull = Hull::running(0.0, self.speed());
        let drive = self.drive(rudder);
        for _ in 0..(STEADY / 0.1) as usize {
            hull.step(&drive, 0.1);
        }
        SpiralRow {
            rudder,
            rate: hull.rate.to_degrees(),
            speed: hull.speed(),
            drift: libm::atan2(hull.sway, hull.surge).to_degrees(),
            radius: libm::fabs(hull.speed() / hull.rate),
        }
    }

    /// The figures of a turn (advance, transfer, tactical diameter) or a zigzag (overshoots).
    #[must_use]
    pub fn report(&self) -> Report {
        let mut report = Report::default();
        match self.manoeuvre {
            Manoeuvre::Turn { .. } => self.turn_figures(&mut report),
            Manoeuvre::Zigzag { heading_deg, .. } => self.zigzag_figures(heading_deg, &mut report),
            Manoeuvre::Spiral => {
                let rows = self.spiral();
                let smallest = rows.iter().map(|r| r.radius).reduce(f64::min);
                report.push("smallest_radius_m", smallest);
                let neutral = rows
                    .windows(2)
                    .find(|w| w[0].rate < 0.0 && w[1].rate >= 0.0);
                let crossing = neutral.map(|w| {
                    w[0].rudder + (w[1].rudder - w[0].rudder) * w[0].rate / (w[0].rate - w[1].rate)
                });
                report.push("neutral_rudder_deg", crossing);
            }
        }
        report
    }

    fn turn_figures(&self, report: &mut Report) {
        let (mut begin, mut quarter, mut half, mut last) = (None, None, None, None);
        self.sail(&mut |row| {
            if row.time >= self.execute_s && begin.is_none() {
                begin = Some(row.hull);
            }
            let turned = begin.map_or(0.0, |b: Hull| {
                libm::fabs(row.hull.heading - b.heading).to_degrees()
            });
            if turned >= 90.0 && quarter.is_none() {
                quarter = Some(row.hull);
            }
            if turned >= 180.0 && half.is_none() {
                half = Some(row.hull);
            }
            last = Some(row.hull);
        });
        let from = |then: Option<Hull>, measure: fn(Hull) -> f64| {
            then.zip(begin)
                .map(|(then, begin)| libm::fabs(measure(then) - measure(begin)))
        };
        report.push("advance_m", from(quarter, |h| h.north));
        report.push("transfer_m", from(quarter, |h| h.east));
        report.push("tactical_diameter_m", from(half, |h| h.east));
        report.push(
            "steady_radius_m",
            last.map(|h| libm::fabs(h.speed() / h.rate)),
        );
        report.push(
            "steady_rate_deg_per_min",
            last.map(|h| h.rate.to_degrees() * 60.0),
        );
        report.push("steady_speed_mps", last.map(|h| h.speed()));
    }

    fn zigzag_figures(&self, heading: f64, report: &mut Report) {
        let (mut peaks, mut side, mut peak) = (Vec::new(), 0.0, 0.0_f64);
        self.sail(&mut |row| {
            if row.time < self.execute_s {
                return;
            }
            let now = row.hull.heading.to_degrees();
            let sign = libm::copysign(1.0, row.order);
            if side != sign {
                if side != 0.0 {
                    peaks.push(peak);
                }
                peak = 0.0;
                side = sign;
            }
            peak = peak.max(-sign * now - heading);
        });
        // The first rudder has no overshoot behind it.
        for (i, name) in ["first_overshoot_deg", "second_overshoot_deg"]
            .into_iter()
            .enumerate()
        {
            report.push(name, peaks.get(i + 1).copied());
        }
        report.push("reversals", Some(peaks.len() as f64));
    }
}

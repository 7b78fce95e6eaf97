//! The scenario files: the bench with its noise series, or one open-loop manoeuvre.

use super::manoeuvre::Plan;
use crate::command::Refusal;
use crate::geo::Point;
use crate::path::Path;
use crate::units::{Course, Radius};
use alloc::collections::BTreeMap;
use alloc::format;
use alloc::string::String;
use alloc::vec::Vec;
use serde::{Deserialize, Serialize};

/// What a scenario file holds.
#[derive(Clone, Debug, PartialEq)]
pub enum Document {
    /// A track-keeping bench with one or more scenarios.
    Bench(Bench),
    /// One open-loop manoeuvre.
    Manoeuvre(Plan),
}

/// A route, a ship and the conditions in which she sails it.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Bench {
    ship: ShipText,
    initial: Initial,
    legs: Vec<Leg>,
    turns: Vec<ArcText>,
    waypoints: Vec<[f64; 2]>,
    scenarios: BTreeMap<String, Conditions>,
    #[serde(default)]
    disturbance_files: Vec<String>,
}

#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
struct ShipText {
    model: String,
    #[serde(default = "thirty_five")]
    rudder_limit_deg: f64,
}

const fn thirty_five() -> f64 {
    35.0
}

#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
struct Initial {
    north_m: f64,
    east_m: f64,
    heading_deg: f64,
}

#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
struct Leg {
    course_deg: f64,
}

#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
struct ArcText {
    #[serde(rename = "R_nm")]
    radius_nm: f64,
    centre: [f64; 2],
}

/// Speed, current and noise of one scenario.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Conditions {
    /// Nominal speed through the water, knots.
    pub kn: f64,
    /// Speed of the current, knots.
    pub cur_kn: f64,
    /// Direction to which the current flows, degrees.
    pub cur_set: f64,
    /// Deviation of the yaw by waves, degrees.
    pub wave_deg: f64,
    /// 1 with sensor noise, 0 without.
    pub noise: f64,
}

/// The noise series: ten times a second (wave yaw, its rate, gyro, rate of turn) and once a second
/// (slow position north, east, fast position north, east, velocity north, east), all of unit size.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Disturbance {
    /// Ten times a second.
    pub fast: Vec<[f64; 4]>,
    /// Once a second.
    pub slow: Vec<[f64; 6]>,
}

impl Document {
    /// Reads a scenario file.
    ///
    /// # Errors
    /// Text that is not such a document, a ship that is not there, a route that does not hang together.
    pub fn parse(text: &str) -> Result<Self, Refusal> {
        let value: serde_json::Value =
            serde_json::from_str(text).map_err(|e| Refusal::because(format!("not JSON: {e}")))?;
        if value.get("manoeuvre").is_some() {
            let plan: Plan = serde_json::from_value(value)
                .map_err(|e| Refusal::because(format!("manoeuvre: {e}")))?;
            return plan.checked().map(Self::Manoeuvre);
        }
        if value.get("scenarios").is_none() {
            return Err(Refusal::because(
                "neither `scenarios` nor `manoeuvre` is in it",
            ));
        }
        let bench: Bench = serde_json::from_value(value)
            .map_err(|e| Refusal::because(format!("scenario: {e}")))?;
        bench.checked().map(Self::Bench)
    }
}

impl Bench {
    fn checked(self) -> Result<Self, Refusal> {
        if !self.ship.model.to_lowercase().contains("mariner") {
            return Err(Refusal::because(format!(
                "ship `{}`: only the Mariner is there",
                self.ship.model
            )));
        }
        let legs = self.legs.len();
        if legs == 0 || self.waypoints.len() != legs + 1 || self.turns.len() + 1 != legs {
            return Err(Refusal::because(format!(
                "{legs} legs need {} waypoints and {} turns",
                legs + 1,
                legs.saturating_sub(1)
            )));
        }
        for (name, c) in &self.scenarios {
            let all = [c.kn, c.cur_kn, c.cur_set, c.wave_deg, c.noise];
            if !(c.kn > 0.0 && c.kn <= 40.0) || all.iter().any(|x| !x.is_finite()) {
                return Err(Refusal::because(format!(
                    "{name}: kn is {}, allowed 0 to 40",
                    c.kn
                )));
            }
        }
        if let Some((i, turn)) = self
            .turns
            .iter()
            .enumerate()
            .find(|(_, t)| t.radius_nm <= 0.0)
        {
            return Err(Refusal::because(format!(
                "turn {}: radius {} nm",
                i + 1,
                turn.radius_nm
            )));
        }
        Ok(self)
    }

    /// Names and conditions of the scenarios.
    pub fn scenarios(&self) -> impl Iterator<Item = (&str, &Conditions)> {
        self.scenarios
            .iter()
            .map(|(name, conditions)| (name.as_str(), conditions))
    }

    /// Names of the files with the noise series, beside the scenario.
    #[must_use]
    pub fn disturbance_files(&self) -> &[String] {
        &self.disturbance_files
    }

    pub(super) fn rudder_limit(&self) -> f64 {
        self.ship.rudder_limit_deg
    }

    pub(super) fn start(&self) -> (Point, f64) {
        let Initial {
            north_m,
            east_m,
            heading_deg,
        } = self.initial;
        (
            Point {
                north: north_m,
                east: east_m,
            },
            heading_deg,
        )
    }

    pub(super) fn leg_count(&self) -> usize {
        self.legs.len()
    }

    /// The leg from waypoint `i` to the next one.
    pub(super) fn leg(&self, i: usize) -> Path {
        let [north, east] = self.waypoints[i];
        Path::leg(
            Point { north, east },
            Course::from_deg(self.legs[i].course_deg),
        )
    }

    /// Leg `i` with the turn at its end; the last leg has none.
    pub(super) fn leg_and_turn(&self, i: usize) -> Path {
        let Some(turn) = self.turns.get(i) else {
            return self.leg(i);
        };
        let centre = Point {
            north: turn.centre[0],
            east: turn.centre[1],
        };
        let course = |i: usize| Course::from_deg(self.legs[i].course_deg);
        Path::turn(
            course(i),
            centre,
            Radius::from_nm(turn.radius_nm),
            course(i + 1),
        )
    }

    /// The last waypoint.
    pub(super) fn end(&self) -> Point {
        let [north, east] = self.waypoints[self.legs.len()];
        Point { north, east }
    }
}

impl Disturbance {
    /// Reads both series: a heading line, then the time and the columns.
    ///
    /// # Errors
    /// A line with a wrong number of columns or something that is not a number.
    pub fn parse(fast: &str, slow: &str) -> Result<Self, Refusal> {
        Ok(Self {
            fast: columns(fast)?,
            slow: columns(slow)?,
        })
    }
}

fn columns<const N: usize>(text: &str) -> Result<Vec<[f64; N]>, Refusal> {
    let mut rows = Vec::new();
    for (number, line) in text
        .lines()
        .enumerate()
        .skip(1)
        .filter(|(_, l)| !l.trim().is_empty())
    {
        let mut row = [0.0; N];
        let mut fields = line.split(',').skip(1);
        for cell in &mut row {
            *cell = fields
                .next()
                .and_then(|f| f.trim().parse().ok())
                .filter(|x: &f64| x.is_finite())
                .ok_or_else(|| {
                    Refusal::because(format!("line {}: {N} numbers expected", number + 1))
                })?;
        }
        rows.push(row);
    }
    Ok(rows)
}

//! The steering laws: from what is measured and what is demanded to the rudder that is wanted, once a control step.
//!
//! ```text
//! Demand::Track -> track.rs --+                       observer.rs: heading and rate without the waves
//! Demand::Rate --> rate.rs ---+-> heading.rs -> the rudder that is wanted
//! Demand::Heading ------------+                       reckoning.rs: position and current
//!   of a small craft ---> pid.rs ------------> the rudder that is wanted
//! Demand::Rudder -----------------------------> the rudder that is wanted
//! ```
//! In: heading, rate, rudder, speeds, position, and what the gear gave last. Out: the wanted rudder with its terms, which
//! the gear limits. Absent on purpose: modes, alarms, ages (a value that is too old is absent here).

mod angle;
mod heading;
mod intercept;
mod measured;
mod observer;
mod pid;
mod rate;
mod reckoning;
mod settings;
mod ship;
mod track;

pub use intercept::Intercept;
pub use measured::Measured;
pub use settings::SteeringSettings;
pub use ship::has_own_constants;

use crate::path::Path;
use crate::settings::Settings;
use crate::units::{Distance, Heading, Radius, RateOfTurn, RudderAngle, SignedAngle, Speed};
use angle::wrap;
use serde::{Deserialize, Serialize};

/// What limits the rate of a heading change.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum TurnBy {
    /// A radius, held with the speed over ground (through the water where that is unknown).
    Radius(Radius),
    /// A rate of turn; its sign does not matter.
    Rate(RateOfTurn),
    /// The regulator's own rate.
    Free,
}

/// What is demanded of the steering.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Demand {
    /// Come to a heading and keep it.
    Heading {
        /// The heading.
        set: Heading,
        /// How fast to turn there.
        by: TurnBy,
    },
    /// Sail along a path. Without a position the present heading reference is kept.
    Track(Path),
    /// Turn at a rate, starboard positive; at none, hold the heading that she has then.
    Rate(RateOfTurn),
    /// This rudder. It needs no heading.
    Rudder(RudderAngle),
}

/// What moves the rudder, degrees, starboard positive.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Terms {
    /// By the heading error.
    pub proportional: f64,
    /// By what was learned of the bias.
    pub integral: f64,
    /// By the error of the rate of turn.
    pub rate: f64,
    /// By the ship's model, for the turn that is planned.
    pub feedforward: f64,
}

/// The rudder that is wanted and why.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Wanted {
    /// The rudder, before limit and slew.
    pub rudder: RudderAngle,
    /// The law is another one than before: the order is to join it without a bump (FA6).
    pub joins: bool,
    /// The rudder itself is ordered: nothing of a former law is carried over into it.
    pub ordered: bool,
    /// The heading that is steered now; the last one where a rudder is ordered without a heading.
    pub hts: Heading,
    /// The rate of turn that is steered now.
    pub rate_reference: RateOfTurn,
    /// Cross-track distance from the path, ship right of it positive.
    pub cross_track: Option<Distance>,
    /// What it is made of.
    pub terms: Terms,
}

/// What the gear made of the rudder that was wanted last.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Given {
    /// The order in force.
    pub order: RudderAngle,
    /// By how much limit and slew cut what was wanted, degrees.
    pub cut: f64,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
enum Law {
    Heading,
    /// A heading, by the gains of a small craft.
    Pid,
    Track,
    Rate,
    Rudder,
}

/// Part of the rudder limit that a heading change is planned with.
const RUDDER_SHARE: f64 = 0.7;
/// Part of the rudder limit that an ordered rate of turn is held with.
const RATE_SHARE: f64 = 0.9;

/// The steering: settings, and all state of the laws.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Steering {
    /// The constants of the ship that was named in the configuration (AP-20).
    named_ship: Option<SteeringSettings>,
    settings: SteeringSettings,
    observer: observer::Observer,
    ground: reckoning::Reckoning,
    reference: heading::ReferenceModel,
    regulator: heading::Regulator,
    /// The gains of a small craft; absent where the ship's model steers a heading.
    gains: Option<pid::Gains>,
    pid: pid::Pid,
    /// Other gains than in the last step.
    other_gains: bool,
    guidance: track::Guidance,
    law: Option<Law>,
}

impl Steering {
    /// Steering that has not begun.
    #[must_use]
    pub fn new(settings: SteeringSettings) -> Self {
        Self {
            named_ship: None,
            settings,
            observer: observer::Observer::new(),
            ground: reckoning::Reckoning::default(),
            reference: heading::ReferenceModel::default(),
            regulator: heading::Regulator::default(),
            gains: None,
            pid: pid::Pid::default(),
            other_gains: false,
            guidance: track::Guidance::default(),
            law: None,
        }
    }

    /// Steering of a ship by what is set; `named_ship` is one whose constants are known by her name (AP-20).
    #[must_use]
    pub fn of(named_ship: Option<SteeringSettings>, settings: &Settings) -> Self {
        let ship = SteeringSettings::of(named_ship.as_ref(), settings);
        Self {
            named_ship,
            gains: pid::Gains::of(settings),
            ..Self::new(ship)
        }
    }

    /// The ship as the laws have her.
    #[must_use]
    pub const fn ship(&self) -> &SteeringSettings {
        &self.settings
    }

    /// Other settings from the next step on; other gains are joined without a bump (FA6).
    pub fn change(&mut self, settings: &Settings) {
        self.settings = SteeringSettings::of(self.named_ship.as_ref(), settings);
        let gains = pid::Gains::of(settings);
        self.other_gains |= gains != self.gains;
        self.gains = gains;
    }

    /// The dead band of a small craft in force, degrees; absent where the ship's model steers.
    #[must_use]
    pub fn dead_band(&self) -> Option<f64> {
        self.gains.as_ref().map(|gains| self.pid.dead_band(gains))
    }

    /// Takes over from hand steering or another mode. Estimates of heading, position and current begin anew, since they
    /// were not kept up; what was learned of the bias stays.
    pub fn engage(&mut self, m: &Measured) {
        self.observer = observer::Observer::new();
        self.ground = reckoning::Reckoning::default();
        self.guidance = track::Guidance::default();
        self.reference = heading::ReferenceModel {
            heading: m.heading.rad(),
            rate: m.rate.rad_per_s(),
            acceleration: 0.0,
        };
        self.law = None;
    }

    /// Another compass is read: its heading differs by `change` from the one before, and the ship has not turned (AP-9).
    pub fn another_compass(&mut self, change: SignedAngle) {
        self.observer.turn_frame(change.rad());
        self.reference.heading = wrap(self.reference.heading + change.rad());
    }

    /// One control step of `dt` seconds; a heading change is planned within `rudder_limit`.
    pub fn step(
        &mut self,
        m: &Measured,
        demand: &Demand,
        rudder_limit: RudderAngle,
        given: Given,
        dt: f64,
    ) -> Wanted {
        let settings = &self.settings;
        let surge = m.water_speed.unwrap_or(settings.cruise_speed).mps();
        let ship = settings.at_speed(surge);
        let rudder = m
            .rudder
            .map_or(given.order.deg().to_radians(), RudderAngle::rad);
        let motion = self.observer.step(
            m.heading.rad(),
            m.rate.rad_per_s(),
            rudder,
            &ship,
            settings,
            dt,
        );
        let sailing = self.ground.step(m, &motion, surge, settings, dt);
        let acceleration = settings.turn_acceleration.to_radians() * ship.ratio * ship.ratio;
        let limit = rudder_limit.deg().min(self.settings.rudder_max.deg());
        let (mut cross_track, mut joins) = (None, false);
        match (demand, sailing.position) {
            (Demand::Track(path), Some(p)) => {
                joins = self.change_law(Law::Track);
                let kin = (&sailing, motion.heading);
                let steer = self
                    .guidance
                    .step(path, p, kin, (&ship, &self.settings), dt);
                self.reference = steer.reference;
                cross_track = Some(Distance::from_m(steer.cross_track));
            }
            (Demand::Heading { set, by }, _) => {
                let other = !matches!(self.law, Some(Law::Heading | Law::Pid));
                joins = self.change_law(match self.gains {
                    Some(_) => Law::Pid,
                    None => Law::Heading,
                });
                if joins && other {
                    self.reference = heading::ReferenceModel::of(&motion);
                }
                let over_ground = m.ground.map_or(surge, |(_, speed)| speed.mps());
                let rate = match by {
                    TurnBy::Radius(radius) => over_ground / radius.m().max(10.0),
                    TurnBy::Rate(rate) => rate.rad_per_s(),
                    TurnBy::Free => self.settings.free_rate.rad_per_s(),
                };
                // No faster than the ship can: the rest of the rudder is left to the regulator.
                let side = wrap(set.rad() - self.reference.heading);
                let rudder = libm::copysign(RUDDER_SHARE * limit.to_radians(), side);
                let rate = libm::fabs(rate).min(ship.steady_rate(rudder));
                self.reference.step(wrap(set.rad()), rate, acceleration, dt);
            }
            (Demand::Rate(rate), _) => {
                joins = self.change_law(Law::Rate);
                if joins {
                    self.reference = heading::ReferenceModel::of(&motion);
                }
                let rate = rate.rad_per_s();
                let rudder = libm::copysign(RATE_SHARE * limit.to_radians(), rate);
                let most = ship.steady_rate(rudder);
                self.reference
                    .turn(rate.clamp(-most, most), acceleration, motion.heading, dt);
            }
            (Demand::Rudder(angle), _) => {
                self.change_law(Law::Rudder);
                self.reference = heading::ReferenceModel::of(&motion);
                return self.ordered(*angle);
            }
            (Demand::Track(_), None) => self.reference.acceleration = 0.0,
        }
        if let (Some(Law::Pid), Some(gains)) = (self.law, &self.gains) {
            let (speed, cut) = (Speed::from_mps(surge), given.cut);
            let said = (m.heading, m.rate);
            if core::mem::take(&mut self.other_gains) {
                self.pid.begin(); // it samples at once
                joins = true;
            }
            let pid = self
                .pid
                .step(gains, said, &self.reference, (speed, cut), dt);
            return self.by_gains(pid, joins);
        }
        let terms = self.regulator.step(
            (motion.heading, motion.rate),
            &self.reference,
            (&ship, &self.settings),
            given.cut.to_radians(),
            dt,
        );
        Wanted {
            rudder: RudderAngle::from_deg(terms.sum().to_degrees()),
            joins,
            ordered: false,
            hts: Heading::from_rad(self.reference.heading),
            rate_reference: RateOfTurn::from_rad_per_s(self.reference.rate),
            cross_track,
            terms: Terms {
                proportional: terms.proportional.to_degrees(),
                integral: terms.integral.to_degrees(),
                rate: terms.rate.to_degrees(),
                feedforward: terms.feedforward.to_degrees(),
            },
        }
    }

    /// The rudder that a small craft's gains want, in degrees.
    fn by_gains(&self, (rudder, moved): (f64, pid::Moved), joins: bool) -> Wanted {
        Wanted {
            joins,
            ordered: false,
            terms: Terms {
                proportional: moved.proportional,
                integral: moved.integral,
                rate: moved.rate,
                feedforward: 0.0,
            },
            ..self.ordered(RudderAngle::from_deg(rudder))
        }
    }

    /// A rudder is ordered and there is no heading: what is estimated by one begins anew when it is back.
    pub fn without_heading(&mut self, rudder: RudderAngle) -> Wanted {
        self.change_law(Law::Rudder);
        self.observer = observer::Observer::new();
        self.ground = reckoning::Reckoning::default();
        self.ordered(rudder)
    }

    /// The rudder as it is ordered.
    fn ordered(&self, rudder: RudderAngle) -> Wanted {
        Wanted {
            rudder,
            joins: false,
            ordered: true,
            hts: Heading::from_rad(self.reference.heading),
            rate_reference: RateOfTurn::from_rad_per_s(self.reference.rate),
            cross_track: None,
            terms: Terms {
                proportional: 0.0,
                integral: 0.0,
                rate: 0.0,
                feedforward: rudder.deg(),
            },
        }
    }

    /// Whether the law is another one than before.
    fn change_law(&mut self, law: Law) -> bool {
        let changed = self.law != Some(law);
        if changed {
            self.law = Some(law);
            match law {
                Law::Track => self.guidance = track::Guidance::default(),
                Law::Pid => self.pid.begin(),
                Law::Heading | Law::Rate | Law::Rudder => {}
            }
        }
        changed
    }
}

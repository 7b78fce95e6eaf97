//! The world station: a simulated ship with her steering gear and sensors.
//!
//! In: rudder orders (ROR) on the gear's port. Out: gyro HDT and ROT and rudder angles RSA ten times a second,
//! position GLL, velocity VTG, log VHW and, where there is any, wind MWV once a second; or, where a motor turns the rudder, its
//! controller on the gear's port. Absent on purpose: what wind does to a ship that is no yacht, roll in waves, shallow water.
//!
//! **Invariant:** a rudder order older than 2 s, or with status V, leaves the rudder where it is.

mod config;
mod gusts;
mod hull;
mod mariner;
mod motion;
mod noise;
mod sensors;
mod sentences;
mod steering;
mod tiller;
mod truth;
mod wind;
mod yacht;

pub use config::WorldConfig;
use gusts::Gusts;
pub use hull::{Drive, Hull, ShipModel};
pub use noise::{Drift, Random, Waves};
pub use sensors::Noise;
use steering::Steering;
pub use tiller::{Tiller, TillerFaults};
pub use truth::Truth;

use crate::command::{FaultKind, Order, Refusal};
use crate::geo::{Plane, Point, Position};
use crate::nmea::{Ror, Sentence};
use crate::picture::Picture;
use crate::post::{self, Post, Station};
use crate::station::{Input, Output, PortIndex, PortSetup, Profile, Role};
use crate::talk::{self, Row, SECOND_MS, Saying};
use crate::time::Stamp;
use crate::timers::Timers;
use crate::units::{Course, Distance, Heading, RateOfTurn, RudderAngle, SignedAngle, Speed};
use alloc::format;
use alloc::string::String;
use alloc::vec::Vec;
use sensors::{Compass, Receiver};
use serde::{Deserialize, Serialize};

/// Milliseconds of one step.
const STEP: u64 = 100;
/// Where the plane is laid anew under the ship, metres from its origin.
const PLANE_REACH: f64 = 3000.0;

/// The ship's own times.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
enum Timer {
    /// When the next step is due.
    Step,
}

/// Hull, steering gear and sensors behind ports.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct World {
    config: WorldConfig,
    hull: Hull,
    drive: Drive,
    plane: Plane,
    random: Random,
    compass: Compass,
    receiver: Receiver,
    log_injury: sensors::Injury,
    log_speed: f64,
    steering: Steering,
    gusts: Gusts,
    tiller: Option<Tiller>,
    post: Post,
    timers: Timers<Timer>,
    steps: u64,
    sailed: f64,
}

impl World {
    /// A ship running straight; the first step is at time 0.
    #[must_use]
    pub fn new(config: WorldConfig) -> Self {
        let speed = config.speed.mps();
        let hull = Hull::of(config.ship, config.heading.rad(), speed);
        // Whether anything leaves the house is for its owner to say; a cable inside hears the sensors in any case.
        let ports = config.ports.iter().cloned();
        let ports = ports.map(|port| PortSetup {
            output: true,
            ..port
        });
        let ports = ports.collect();
        let mut world = Self {
            hull,
            drive: Drive {
                approach_speed: speed,
                ..Drive::default()
            },
            plane: Plane::at(config.start),
            random: Random::new(config.seed),
            compass: Compass::default(),
            receiver: Receiver::at(config.start),
            log_injury: sensors::Injury::default(),
            log_speed: speed,
            steering: Steering::default(),
            gusts: Gusts::default(),
            tiller: (config.motor).map(|protocol| Tiller::new(protocol, config.seed)),
            post: Post::new(Role::World, ports),
            timers: Timers::new(&[(Timer::Step, Stamp(0))]),
            steps: 0,
            sailed: 0.0,
            config,
        };
        world.set_current(world.config.current_set, world.config.current_drift);
        world
    }

    /// When the next step is due.
    #[must_use]
    pub fn due(&self) -> Stamp {
        self.timers.at(Timer::Step).unwrap_or_default()
    }

    /// What it has heard and said; pages fold the same lines.
    #[must_use]
    pub const fn picture(&self) -> &Picture {
        &self.post.picture
    }

    /// Its ports.
    #[must_use]
    pub fn ports(&self) -> &[PortSetup] {
        self.post.ports()
    }

    /// Index of the port with that profile.
    #[must_use]
    pub fn port(&self, profile: Profile) -> Option<PortIndex> {
        let ports = self.post.ports();
        ports.iter().position(|port| port.profile == profile)
    }

    /// Runs all steps due up to `now`, then takes the input.
    pub fn handle(&mut self, now: Stamp, input: Input<'_>, out: &mut Vec<Output>) {
        while self.due() <= now {
            let at = self.due();
            self.timers.set(Timer::Step, at + STEP);
            // After a stall the ship stood still as her computer did.
            if !matches!(input, Input::Stalled { .. }) {
                self.step(at, out);
            }
        }
        match input {
            Input::Bytes { port, bytes } => match &mut self.tiller {
                Some(tiller) if self.post.ports()[port].profile == Profile::Gear => {
                    tiller.hear(bytes);
                }
                _ => post::hear(self, now, port, bytes, out),
            },
            Input::Order { order, .. } => out.push(Output::Answer(self.obey(order))),
            Input::Stalled { .. } | Input::Contact { .. } | Input::Port { .. } | Input::Tick => {}
        }
    }

    fn obey(&mut self, order: &Order) -> Result<String, Refusal> {
        match order {
            Order::Current { set, drift } if !(0.0..=5.0).contains(drift) || !set.is_finite() => {
                let text = format!("drift is {drift}, allowed are 0 to 5 kn");
                Err(Refusal::because(text))
            }
            Order::Current { set, drift } => {
                self.set_current(Course::from_deg(*set), Speed::from_knots(*drift));
                Ok(format!("current {drift} kn to {set:03}"))
            }
            _ => Err(Refusal::because("not a command to the ship")),
        }
    }

    fn set_current(&mut self, set: Course, drift: Speed) {
        self.drive.current_north = drift.mps() * libm::cos(set.rad());
        self.drive.current_east = drift.mps() * libm::sin(set.rad());
        self.config.current_set = set;
        self.config.current_drift = drift;
    }

    /// Direction and speed of the current.
    #[must_use]
    pub const fn current(&self) -> (Course, Speed) {
        (self.config.current_set, self.config.current_drift)
    }

    /// Puts the ship elsewhere for a new round: running straight, rudder amidships. Injuries stay.
    pub fn reset(&mut self, position: Position, heading: Heading) {
        self.hull = Hull::of(self.config.ship, heading.rad(), self.config.speed.mps());
        self.plane = Plane::at(position);
        self.steering = self.steering.forgotten();
    }

    /// Injures or heals the sensors of a profile, or a rudder; false where that is not what that profile can suffer.
    pub fn injure(&mut self, profile: Profile, kind: FaultKind, on: bool) -> bool {
        if profile == Profile::Gear {
            return self.steering.injure(kind, self.config.pair, on);
        }
        let injury = match profile {
            Profile::Gyro1 => &mut self.compass.injury,
            Profile::Gps => &mut self.receiver.injury,
            Profile::Log => &mut self.log_injury,
            _ => return false,
        };
        match kind {
            FaultKind::Jump => injury.jump = on,
            FaultKind::Stuck => injury.stuck = on,
            _ => return false,
        }
        true
    }

    /// The truth.
    #[must_use]
    pub fn truth(&self) -> Truth {
        let (north, east) = self.hull.ground_velocity(&self.drive);
        Truth {
            position: self.plane.position(self.place()),
            heading: Heading::from_rad(self.hull.heading),
            rate: RateOfTurn::from_rad_per_s(self.hull.rate),
            water_speed: Speed::from_mps(self.hull.surge),
            ground_speed: Speed::from_mps(libm::hypot(north, east)),
            rudder: RudderAngle::from_deg(self.hull.rudder.to_degrees()),
            heel: SignedAngle::from_deg(self.hull.heel.to_degrees()),
            port_rudder: self
                .config
                .pair
                .then(|| RudderAngle::from_deg(self.hull.port_rudder.to_degrees())),
        }
    }

    /// Distance sailed through the water since the beginning.
    #[must_use]
    pub const fn sailed(&self) -> Distance {
        Distance::from_m(self.sailed)
    }

    const fn place(&self) -> Point {
        Point {
            north: self.hull.north,
            east: self.hull.east,
        }
    }

    fn step(&mut self, now: Stamp, out: &mut Vec<Output>) {
        post::time_out(self, now, out);
        let dt = STEP as f64 / 1000.0;
        self.gusts.step(self.config.gustiness, &mut self.random, dt);
        let (from, wind) = self.wind();
        self.drive.wind_north = wind.mps() * libm::cos(from.rad());
        self.drive.wind_east = wind.mps() * libm::sin(from.rad());
        self.steering
            .drive(now, &self.hull, self.config.pair, &mut self.drive);
        self.turn_tiller(dt, out);
        self.hull.step(&self.drive, dt);
        self.sailed += self.hull.surge * dt;
        if libm::hypot(self.hull.north, self.hull.east) > PLANE_REACH {
            self.plane = Plane::at(self.plane.position(self.place()));
            (self.hull.north, self.hull.east) = (0.0, 0.0);
        }
        let noise = self.config.noise;
        let rate = self.hull.rate.to_degrees();
        self.compass.measure(
            self.hull.heading.to_degrees(),
            rate,
            &noise,
            &mut self.random,
            dt,
        );
        if self.steps.is_multiple_of(SECOND_MS / STEP) {
            self.measure_each_second();
        }
        for told in talk::TABLE
            .iter()
            .filter(|told| told.station == Role::World)
        {
            let due = |row: &&Row| {
                let period = row.period_ms().unwrap_or(STEP);
                self.steps.is_multiple_of(period / STEP)
            };
            let lines = told.rows.iter().filter(due);
            let lines: Vec<String> = lines.filter_map(|row| self.line(now, row)).collect();
            let lines: Vec<&str> = lines.iter().map(String::as_str).collect();
            if lines.is_empty() {
                continue;
            }
            for profile in told.profiles {
                if let Some(port) = self.port(*profile) {
                    self.post.say_together(now, port, &lines, out);
                }
            }
        }
        self.steps += 1;
    }

    /// The wind over ground now.
    fn wind(&self) -> (Course, Speed) {
        (self.gusts).of((self.config.wind_from, self.config.wind_speed))
    }

    /// Where a motor turns the rudder: it goes on, moves the hull's rudder, and its controller speaks.
    fn turn_tiller(&mut self, dt: f64, out: &mut Vec<Output>) {
        let port = self.port(Profile::Gear);
        let Some(tiller) = &mut self.tiller else {
            return;
        };
        const PARTS: u32 = 5;
        for _ in 0..PARTS {
            tiller.step(dt / f64::from(PARTS));
        }
        self.hull.rudder = tiller.rudder().to_radians();
        self.drive.stuck[0] = true;
        let bytes = tiller.say();
        if let Some(port) = port
            && !bytes.is_empty()
        {
            out.push(Output::Send { port, bytes });
        }
    }

    /// The motor that turns her rudder, where one does.
    pub const fn tiller(&mut self) -> Option<&mut Tiller> {
        self.tiller.as_mut()
    }

    fn measure_each_second(&mut self) {
        let velocity = self.hull.ground_velocity(&self.drive);
        let noise = self.config.noise;
        let place = self.place();
        self.receiver
            .measure(&self.plane, place, velocity, &noise, &mut self.random);
        if !self.log_injury.stuck {
            let jump = if self.log_injury.jump { 5.0 } else { 0.0 };
            self.log_speed = self.hull.surge + jump;
        }
    }

    /// A sentence as it is measured now; absent what is not a sensor's to say.
    fn line(&self, now: Stamp, row: &Row) -> Option<String> {
        let talker = row.talker?;
        Some(match row.saying {
            Saying::Hdt => sentences::heading(self.compass.heading, talker),
            Saying::Rot => sentences::rate(self.compass.rate, talker),
            Saying::Rsa if self.tiller.is_some() => return None,
            Saying::Rsa => Steering::rsa(&self.hull, self.config.pair).line(talker),
            Saying::Gll => sentences::position(self.receiver.position, now, talker),
            Saying::Vtg => sentences::velocity(self.receiver.course, self.receiver.speed, talker),
            Saying::Vhw => sentences::log(self.log_speed, talker),
            Saying::Mwv => {
                // In turn, each once a second.
                let apparent = self.steps.is_multiple_of(SECOND_MS / STEP);
                wind::line(self.wind(), &self.hull, &self.drive, apparent, talker)?
            }
            _ => return None,
        })
    }
}

impl Station for World {
    fn post(&mut self) -> &mut Post {
        &mut self.post
    }

    fn heard(&mut self, now: Stamp, port: PortIndex, sentence: &Sentence<'_>) {
        if self.post.ports()[port].profile == Profile::Gear
            && let Some(ror) = Ror::from_sentence(sentence)
        {
            self.steering.hear(now, &ror);
        }
    }
}

#[cfg(test)]
mod tests;

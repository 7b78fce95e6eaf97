//! The world station: a simulated ship with her steering gear and sensors.
//!
//! In: rudder orders (ROR) on the gear's port. Out: gyro HDT and ROT and rudder angles RSA ten times a second,
//! position GLL, velocity VTG, log VHW and, where there is any, wind MWV once a second. Absent on purpose: what wind does to
//! the hull, roll, shallow water.
//!
//! **Invariant:** a rudder order older than 2 s, or with status V, leaves the rudder where it is.

mod hull;
mod noise;
mod sensors;
mod sentences;
mod steering;
mod truth;
mod wind;

pub use hull::{Drive, Hull};
pub use noise::{Drift, Random, Waves};
pub use sensors::Noise;
use steering::Steering;
pub use truth::Truth;

use crate::command::{FaultKind, Order, Refusal};
use crate::geo::{Plane, Point, Position};
use crate::nmea::{Ror, Sentence};
use crate::picture::Picture;
use crate::post::{self, Post, Station};
use crate::station::{ChecksumPolicy, Input, Output, PortIndex, PortSetup, Profile, Role};
use crate::talk::{self, Row, SECOND_MS, Saying};
use crate::time::Stamp;
use crate::timers::Timers;
use crate::units::{Course, Distance, Heading, RateOfTurn, RudderAngle, Speed};
use alloc::format;
use alloc::string::String;
use alloc::vec::Vec;
use sensors::{Compass, Receiver};
use serde::{Deserialize, Serialize};

/// Milliseconds of one step.
const STEP: u64 = 100;
/// Where the plane is laid anew under the ship, metres from its origin.
const PLANE_REACH: f64 = 3000.0;

/// How the world begins.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct WorldConfig {
    /// Where the ship is.
    pub start: Position,
    /// Her heading.
    pub heading: Heading,
    /// Speed that the engine keeps on a straight course.
    pub speed: Speed,
    /// Direction towards which the current sets.
    pub current_set: Course,
    /// Speed of the current.
    pub current_drift: Speed,
    /// Where the wind comes from, over ground; it is felt by its sensor alone.
    pub wind_from: Course,
    /// Its speed; at none no wind is measured.
    pub wind_speed: Speed,
    /// Ports; a profile that is not here sends nothing.
    pub ports: Vec<PortSetup>,
    /// Seed of all noise.
    pub seed: u64,
    /// How noisy the sensors are.
    pub noise: Noise,
    /// Whether she has an independent pair of rudders, which act as their mean; else a single one (AP-4).
    pub pair: bool,
}

impl Default for WorldConfig {
    fn default() -> Self {
        let port = |name: &str, profile| PortSetup {
            name: String::from(name),
            profile,
            checksum: ChecksumPolicy::Required,
            talkers: Vec::new(),
            baud: 38_400,
            output: true,
        };
        Self {
            start: Position {
                lat: 54.0,
                lon: 7.5,
            },
            heading: Heading::from_deg(0.0),
            speed: Speed::from_knots(15.0),
            current_set: Course::from_deg(0.0),
            current_drift: Speed::from_knots(0.0),
            wind_from: Course::from_deg(0.0),
            wind_speed: Speed::from_knots(0.0),
            ports: alloc::vec![
                port("gyro1", Profile::Gyro1),
                port("gps", Profile::Gps),
                port("log", Profile::Log),
                port("gear", Profile::Gear),
            ],
            seed: 1,
            noise: Noise::default(),
            pair: false,
        }
    }
}

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
        let hull = Hull::running(config.heading.rad(), speed);
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
            Input::Bytes { port, bytes } => post::hear(self, now, port, bytes, out),
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
        self.hull = Hull::running(heading.rad(), self.config.speed.mps());
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
        self.steering
            .drive(now, &self.hull, self.config.pair, &mut self.drive);
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
            Saying::Rsa => Steering::rsa(&self.hull, self.config.pair).line(talker),
            Saying::Gll => sentences::position(self.receiver.position, now, talker),
            Saying::Vtg => sentences::velocity(self.receiver.course, self.receiver.speed, talker),
            Saying::Vhw => sentences::log(self.log_speed, talker),
            Saying::Mwv => {
                // In turn, each once a second.
                let apparent = self.steps.is_multiple_of(SECOND_MS / STEP);
                let wind = (self.config.wind_from, self.config.wind_speed);
                wind::line(wind, &self.hull, &self.drive, apparent, talker)?
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

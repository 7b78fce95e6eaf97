//! The chart system: monitors a route from heard positions and says once a second what the autopilot needs
//! (TCS-1, situations 1 to 6, "Ti" and "Tn").
//!
//! In: bytes of the position receiver, gyro, log and autopilot; requests of an officer. Out: HTC, XTE,
//! PNEY,001, PNEY,002, GLL, VTG and VHW on the autopilot's port.
//!
//! **Invariant:** situations change by geometry, never by time; no position older than 5 s is sent as valid.

mod commanding;
mod current;
mod followed;
mod indications;
mod position;
mod sentences;
mod sight;

use crate::alerts::Standing;
use crate::nmea::Sentence;
use crate::picture::Picture;
use crate::post::{self, Post, Station};
use crate::route::{Progress, Route};
use crate::station::{ChecksumPolicy, Input, Output, PortIndex, PortSetup, Profile, Role};
use crate::talk::SECOND_MS;
use crate::time::Stamp;
use crate::units::{Distance, Speed};
use alloc::string::String;
use alloc::vec::Vec;
use commanding::Commanding;
use current::Current;
use followed::Followed;
use indications::TurnIndications;
use position::PositionGuard;
use serde::{Deserialize, Serialize};

/// How a chart system is set up.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct ChartConfig {
    /// The route that is monitored from the start.
    pub route: Option<Route>,
    /// Its ports.
    pub ports: Vec<PortSetup>,
    /// Time on the forwarding distance in "Ti", seconds; absent: the route's own.
    pub forwarding_s: Option<f64>,
    /// Time from the start of a turn in "Tn" to the beginning of the arc, seconds.
    pub forwarding_tn_s: f64,
    /// Early course change indication before wheel-over, seconds; at least 60 (TCS-11).
    pub early_s: f64,
    /// Indication before wheel-over, seconds.
    pub soon_s: f64,
    /// Largest cross-track distance at which control may begin.
    pub begin_cross_track: Distance,
    /// Largest difference of heading and track at which control may begin, degrees.
    pub begin_angle_deg: f64,
    /// From the antenna to the conning position: metres forward, metres to starboard (AP-16).
    pub conning_offset_m: [f64; 2],
}

impl Default for ChartConfig {
    fn default() -> Self {
        let port = |name: &str, profile, output| PortSetup {
            name: name.into(),
            profile,
            checksum: ChecksumPolicy::Required,
            baud: 0,
            output,
        };
        Self {
            route: None,
            ports: alloc::vec![
                port("ecdis", Profile::Ecdis, true),
                port("gps", Profile::Gps, false),
                port("gyro1", Profile::Gyro1, false),
                port("log", Profile::Log, false),
            ],
            forwarding_s: None,
            forwarding_tn_s: 26.0,
            early_s: 180.0,
            soon_s: 30.0,
            begin_cross_track: Distance::from_nm(0.5),
            begin_angle_deg: 90.0,
            conning_offset_m: [0.0, 0.0],
        }
    }
}

/// The chart system as a station.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct ChartSystem {
    config: ChartConfig,
    route: Option<Route>,
    revision: u64,
    post: Post,
    guard: PositionGuard,
    current: Current,
    progress: Option<Progress>,
    /// Forwarding distance before the next turn; fixed a minute before the wheel-over line.
    forwarding: Distance,
    control: Commanding,
    followed: Followed,
    shown: sight::CrossTracks,
    watch: TurnIndications,
    why: String,
    now: Stamp,
    next: Option<Stamp>,
}

impl ChartSystem {
    /// A chart system that controls nothing yet.
    #[must_use]
    pub fn new(config: ChartConfig) -> Self {
        let mut system = Self {
            post: Post::new(Role::ChartSystem, config.ports.clone()),
            guard: PositionGuard::default(),
            current: Current::default(),
            progress: None,
            forwarding: Distance::default(),
            control: Commanding::Off,
            followed: Followed::default(),
            shown: sight::CrossTracks::default(),
            watch: TurnIndications::default(),
            why: String::new(),
            now: Stamp::default(),
            next: None,
            route: None,
            revision: 0,
            config,
        };
        if let Some(route) = system.config.route.clone() {
            system.load(route);
        }
        system
    }

    /// Loads a route: control ends, and the ship is looked for on it.
    pub fn load(&mut self, route: Route) {
        self.forwarding = self.forwarding_at(route.limits().speed, &route);
        self.route = Some(route);
        self.revision += 1;
        self.control = Commanding::Off;
        self.progress = None;
        self.shown = sight::CrossTracks::default();
        self.watch = TurnIndications::default();
        self.why = String::from("route loaded");
    }

    /// Takes the route out of monitoring; control ends.
    pub fn unload(&mut self) {
        self.route = None;
        self.revision += 1;
        self.control = Commanding::Off;
        self.progress = None;
        self.shown = sight::CrossTracks::default();
        self.watch = TurnIndications::default();
        self.why = String::from("no route");
    }

    /// Runs what is due at `now`, then takes the input.
    pub fn handle(&mut self, now: Stamp, input: Input<'_>, out: &mut Vec<Output>) {
        self.run(now, out);
        match input {
            Input::Bytes { port, bytes } => post::hear(self, now, port, bytes, out),
            Input::Stalled { .. } => {
                self.post.stalled(now);
                self.guard.forget();
                self.followed.stalled(now);
            }
            Input::Order { order, .. } => out.push(Output::Answer(self.obey(now, order))),
            Input::Tick => {}
        }
    }

    /// When the next sentences are due, or a silent autopilot is to be noticed.
    #[must_use]
    pub fn due(&self) -> Stamp {
        let next = self.next.unwrap_or(self.now);
        self.silent_at().map_or(next, |silent| next.min(silent))
    }

    fn run(&mut self, now: Stamp, out: &mut Vec<Output>) {
        let mut next = self.next.unwrap_or(now);
        // Late by more than two periods: the missed sentences are not made up for.
        if now.since(next) > 2 * SECOND_MS {
            next = next + now.since(next) / SECOND_MS * SECOND_MS;
        }
        while next <= now {
            self.step(next, out);
            next = next + SECOND_MS;
        }
        self.next = Some(next);
        self.now = self.now.max(now);
        self.supervise(now);
    }

    /// One second: where the ship is, what is indicated, what is said.
    fn step(&mut self, now: Stamp, out: &mut Vec<Output>) {
        self.now = now;
        post::time_out(self, now, out);
        self.monitor(now);
        self.watch_over(now);
        for port in 0..self.post.ports().len() {
            let profile = self.post.ports()[port].profile;
            let lines: Vec<String> = self.sentences(now, profile).collect();
            for line in &lines {
                self.post.say(now, port, line, out);
            }
        }
    }

    /// The forwarding distance at a speed.
    fn forwarding_at(&self, speed: Speed, route: &Route) -> Distance {
        let seconds = self
            .config
            .forwarding_s
            .unwrap_or(route.limits().forwarding_s);
        Distance::from_m(speed.mps() * seconds)
    }

    /// The route in monitoring.
    #[must_use]
    pub const fn route(&self) -> Option<&Route> {
        self.route.as_ref()
    }

    /// Raised on every change of the route.
    #[must_use]
    pub const fn revision(&self) -> u64 {
        self.revision
    }

    /// Index of the leg that is sailed, from 0.
    #[must_use]
    pub fn leg(&self) -> Option<usize> {
        self.progress.and_then(|progress| progress.leg())
    }

    /// The forwarding distance in force.
    #[must_use]
    pub const fn forwarding(&self) -> Distance {
        self.forwarding
    }

    /// `off`, `heading` (Tn) or `track` (Ti).
    #[must_use]
    pub const fn control_name(&self) -> &'static str {
        self.control.name()
    }

    /// Its time.
    #[must_use]
    pub const fn now(&self) -> Stamp {
        self.now
    }

    /// What it has heard and sent; pages fold the same lines.
    #[must_use]
    pub const fn picture(&self) -> &Picture {
        &self.post.picture
    }

    /// Its alerts that are not normal, the highest first.
    #[must_use]
    pub fn alerts(&self) -> &[Standing] {
        self.watch.alerts().standing()
    }
}

impl Station for ChartSystem {
    fn post(&mut self) -> &mut Post {
        &mut self.post
    }

    fn heard(&mut self, now: Stamp, _port: PortIndex, _sentence: &Sentence<'_>) {
        self.judge_fix(now);
        self.supervise(now);
    }
}

#[cfg(test)]
pub(crate) mod tests;

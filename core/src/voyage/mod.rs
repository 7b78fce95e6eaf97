//! A voyage: the stations that run here, the cables between them, and the ports to real equipment.
//!
//! In: bytes from real ports, commands, time. Out: bytes to real ports, numbered lines, answers.
//! The embedded voyage, two processes over serial lines, the fault tests and a recording are all this.
//!
//! **Invariant:** stations exchange bytes only; the same events at the same times give the same outputs.

mod cable;
mod officer;
mod setup;

use crate::autopilot::Autopilot;
use crate::chart_system::ChartSystem;
use crate::picture::Picture;
use crate::route::Route;
use crate::station::{Input, Output, PortIndex, PortSetup};
use crate::stream::{
    Answer, Do, FaultKind, Hello, Line, PROTOCOL, PortView, PortsDocument, RouteDocument,
    SettingsDocument, Snapshot, VoyageOwn,
};
use crate::time::Stamp;
use crate::units::{Course, Speed};
use crate::world::World;
use alloc::collections::VecDeque;
use alloc::format;
use alloc::string::{String, ToString};
use alloc::vec::Vec;
use cable::Cables;
use officer::{Action, Officer, Watch};
use serde::{Deserialize, Serialize};
pub use setup::{Role, VoyageConfig};

/// What happens to a voyage. A log of `(time, event)` is the whole story (CFG-1).
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Event {
    /// Bytes heard on a real port.
    Bytes {
        /// Number of the port in the configuration.
        port: usize,
        /// The bytes.
        bytes: Vec<u8>,
    },
    /// A real port came or went.
    PortUp {
        /// Number of the port in the configuration.
        port: usize,
        /// Whether it is there.
        up: bool,
    },
    /// Somebody commands.
    Command {
        /// Number for the answer.
        id: u64,
        /// What.
        action: Do,
    },
    /// The caller's loop was late.
    Stalled {
        /// By so many milliseconds.
        ms: u64,
    },
    /// Only time has passed.
    Tick,
}

/// What a voyage gives.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum VoyageOutput {
    /// Bytes for a real port.
    Send {
        /// Number of the port in the configuration.
        port: usize,
        /// The bytes.
        bytes: Vec<u8>,
    },
    /// A line of the station that is shown.
    Line(Line),
    /// What became of a command.
    Answer(Answer),
    /// A setting to be kept.
    Persist {
        /// Name in the settings table.
        key: String,
        /// Value.
        value: f64,
    },
    /// The route document has changed.
    Route,
    /// The settings document has changed.
    Settings,
}

/// The stations, their cables and the ports to the outside.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct Voyage {
    autopilot: Option<Autopilot>,
    chart: Option<ChartSystem>,
    world: Option<World>,
    cables: Cables,
    /// Configured ports: whose, and which of its ports.
    outside: Vec<(Role, PortIndex)>,
    up: Vec<bool>,
    shown: Role,
    /// Picture of the shown station, where that is not the autopilot.
    picture: Option<Picture>,
    line: u64,
    embedded: Option<Route>,
    officer: Officer,
    round: u32,
    speed: f64,
    route_revision: u64,
    settings_revision: u64,
    now: Stamp,
    officer_due: Stamp,
    #[serde(skip)]
    scratch: Vec<Output>,
    #[serde(skip)]
    deliveries: VecDeque<(Role, PortIndex, Vec<u8>)>,
}

impl Voyage {
    /// When time alone next changes something.
    #[must_use]
    pub fn due(&self) -> Stamp {
        let mut due = self.officer_due;
        let stations = [
            self.world.as_ref().map(World::due),
            self.chart.as_ref().map(ChartSystem::due),
            self.autopilot.as_ref().map(Autopilot::due),
            self.cables.due(),
        ];
        for station in stations.into_iter().flatten() {
            due = due.min(station);
        }
        due
    }

    /// Runs everything due up to `now`, in order of time, then takes the event.
    pub fn handle(&mut self, now: Stamp, event: Event, out: &mut Vec<VoyageOutput>) {
        while self.due() <= now {
            let at = self.due();
            self.now = self.now.max(at);
            self.run(at, out);
        }
        self.now = self.now.max(now);
        match event {
            Event::Bytes { port, bytes } => {
                if let Some((role, index)) = self.outside.get(port).copied() {
                    self.input(
                        now,
                        role,
                        Input::Bytes {
                            port: index,
                            bytes: &bytes,
                        },
                    );
                    self.settle(now, role, out);
                }
            }
            Event::PortUp { port, up } => {
                if let Some(state) = self.up.get_mut(port) {
                    *state = up;
                }
            }
            Event::Command { id, action } => {
                let answer = self.command(now, &action, out);
                let (ok, text) = match answer {
                    Ok(text) => (true, text),
                    Err(text) => (false, text),
                };
                out.push(VoyageOutput::Answer(Answer { id, ok, text }));
            }
            Event::Stalled { ms } => {
                for role in Role::ALL {
                    self.input(now, role, Input::Stalled { ms });
                    self.settle(now, role, out);
                }
            }
            Event::Tick => {}
        }
    }

    fn run(&mut self, at: Stamp, out: &mut Vec<VoyageOutput>) {
        while let Some((role, port, bytes)) = self.cables.take_due(at) {
            self.deliveries.push_back((role, port, bytes));
        }
        self.deliver(at, out);
        for role in Role::ALL {
            let due = match role {
                Role::World => self.world.as_ref().map(World::due),
                Role::ChartSystem => self.chart.as_ref().map(ChartSystem::due),
                Role::Autopilot => self.autopilot.as_ref().map(Autopilot::due),
            };
            if due.is_some_and(|due| due <= at) {
                self.input(at, role, Input::Tick);
                self.settle(at, role, out);
            }
        }
        if self.officer_due <= at {
            self.officer_due = at + 1_000;
            self.watch(at, out);
        }
    }

    fn input(&mut self, now: Stamp, role: Role, input: Input<'_>) {
        let out = &mut self.scratch;
        match role {
            Role::World => {
                if let Some(world) = &mut self.world {
                    world.handle(now, input, out);
                }
            }
            Role::ChartSystem => {
                if let Some(chart) = &mut self.chart {
                    chart.handle(now, input, out);
                }
            }
            Role::Autopilot => {
                if let Some(autopilot) = &mut self.autopilot {
                    autopilot.handle(now, input, out);
                }
            }
        }
    }

    /// Carries what a station gave to the cables, the ports and the lines.
    fn settle(&mut self, now: Stamp, from: Role, out: &mut Vec<VoyageOutput>) {
        self.sort_out(now, from, out);
        self.deliver(now, out);
    }

    fn deliver(&mut self, now: Stamp, out: &mut Vec<VoyageOutput>) {
        while let Some((role, port, bytes)) = self.deliveries.pop_front() {
            self.input(
                now,
                role,
                Input::Bytes {
                    port,
                    bytes: &bytes,
                },
            );
            self.sort_out(now, role, out);
        }
    }

    fn sort_out(&mut self, now: Stamp, from: Role, out: &mut Vec<VoyageOutput>) {
        let mut outputs = core::mem::take(&mut self.scratch);
        for output in outputs.drain(..) {
            match output {
                Output::Send { port, bytes } => {
                    let outside = self.outside.iter().position(|end| *end == (from, port));
                    self.cables
                        .carry(now, (from, port), &bytes, &mut self.deliveries);
                    if let Some(port) = outside {
                        out.push(VoyageOutput::Send { port, bytes });
                    }
                }
                Output::Line { port, dir, text } if from == self.shown => {
                    if let Some(picture) = &mut self.picture {
                        picture.fold(now, port, dir, &text);
                    }
                    self.line += 1;
                    let text = text.iter().map(|byte| char::from(*byte)).collect();
                    out.push(VoyageOutput::Line(Line(self.line, now.0, port, dir, text)));
                }
                Output::Line { .. } => {}
                Output::Persist { key, value } => out.push(VoyageOutput::Persist { key, value }),
            }
        }
        self.scratch = outputs;
        let revision = self.chart.as_ref().map_or(0, ChartSystem::revision);
        if revision != self.route_revision {
            self.route_revision = revision;
            out.push(VoyageOutput::Route);
        }
    }

    fn command(
        &mut self,
        now: Stamp,
        action: &Do,
        out: &mut Vec<VoyageOutput>,
    ) -> Result<String, String> {
        if self.embedded.is_some() && takes_the_watch(action) && self.officer.on {
            self.officer.on = false;
        }
        self.carry_out(now, action, out)
    }

    /// Gives a command to whom it concerns.
    fn carry_out(
        &mut self,
        now: Stamp,
        action: &Do,
        out: &mut Vec<VoyageOutput>,
    ) -> Result<String, String> {
        match action {
            Do::Speed(_) | Do::Officer(_) | Do::Fault { .. } | Do::Current { .. } => {
                self.conduct(now, action)
            }
            Do::Chart(request) => match &mut self.chart {
                Some(chart) => chart.command(now, request).map_err(|refusal| refusal.0),
                None => Err("the chart system is a foreign one".into()),
            },
            Do::Acknowledge(number) if *number >= 200 => {
                let taken = self
                    .chart
                    .as_mut()
                    .is_some_and(|chart| chart.acknowledge(now, *number));
                if taken {
                    Ok(format!("alert {number} acknowledged"))
                } else {
                    Err(format!("alert {number} waits for no acknowledgement"))
                }
            }
            _ => {
                if let (Do::Silence(_), Some(chart)) = (action, &mut self.chart) {
                    chart.silence(now);
                }
                let Some(autopilot) = &mut self.autopilot else {
                    return Err("the autopilot is a foreign one: command it there".into());
                };
                let answer = autopilot.command(now, action).map_err(|refusal| refusal.0);
                if let (Do::Setting { key, value }, Ok(_)) = (action, &answer) {
                    self.settings_revision += 1;
                    out.push(VoyageOutput::Persist {
                        key: key.clone(),
                        value: *value,
                    });
                    out.push(VoyageOutput::Settings);
                }
                answer
            }
        }
    }

    /// Commands that only the embedded voyage knows.
    fn conduct(&mut self, now: Stamp, action: &Do) -> Result<String, String> {
        if self.embedded.is_none() {
            return Err("only in the embedded voyage".into());
        }
        match action {
            Do::Speed(speed) if (1.0..=60.0).contains(speed) => {
                self.speed = *speed;
                Ok(format!("{speed}x"))
            }
            Do::Speed(speed) => Err(format!("speed is {speed}, allowed are 1 to 60")),
            Do::Officer(on) => {
                self.officer = Officer::new(now, *on);
                let text = if *on {
                    "the scripted officer has the watch"
                } else {
                    "you have the watch"
                };
                Ok(text.into())
            }
            Do::Current { set, drift } => {
                if !(0.0..=5.0).contains(drift) || !set.is_finite() {
                    return Err(format!("drift is {drift}, allowed are 0 to 5 kn"));
                }
                if let Some(world) = &mut self.world {
                    world.set_current(Course::from_deg(*set), Speed::from_knots(*drift));
                }
                Ok(format!("current {drift} kn to {set:03}"))
            }
            Do::Fault { cable, kind, on } => {
                let sensor = matches!(kind, FaultKind::Jump | FaultKind::Stuck);
                let profile = self.cables.profile(cable);
                let known = match (sensor, &mut self.world, profile) {
                    (_, _, None) => return Err(format!("no cable is named {cable}")),
                    (true, Some(world), Some(profile)) => world.injure(profile, *kind, *on),
                    (true, ..) => false,
                    (false, ..) => true,
                };
                if !known {
                    return Err(format!(
                        "{cable} cannot do that: only gyro1, gps and log jump or stick"
                    ));
                }
                self.cables.injure(cable, *kind, *on);
                Ok(format!(
                    "{cable} {}",
                    if *on { "injured" } else { "healed" }
                ))
            }
            _ => Err("not a command to the embedded voyage".into()),
        }
    }

    /// Once a second the scripted officer looks around.
    fn watch(&mut self, now: Stamp, out: &mut Vec<VoyageOutput>) {
        if self.embedded.is_none() {
            return;
        }
        let (Some(autopilot), Some(chart)) = (&self.autopilot, &self.chart) else {
            return;
        };
        let mut alerts = autopilot.alerts().views();
        alerts.extend(chart.alerts());
        let own = chart.own();
        let watch = Watch {
            mode: autopilot.mode().name(),
            pending: autopilot.pending(),
            situation: own.situation,
            commanded: own.control != "off",
            alerts: &alerts,
        };
        match self.officer.next(now, &watch) {
            Some(Action::Command(action)) => {
                // A refused command is tried again; the reason stands in the snapshot.
                let _ = self.carry_out(now, &action, out);
            }
            Some(Action::NewRound) => {
                self.round += 1;
                if let (Some(chart), Some(route)) = (&mut self.chart, &self.embedded) {
                    chart.load(route.clone());
                }
            }
            None => {}
        }
    }

    /// Ship's time for each second of the clock on the wall: 1 while a confirmation is open.
    #[must_use]
    pub fn rate(&self) -> f64 {
        let pending = self.autopilot.as_ref().is_some_and(Autopilot::pending);
        if pending { 1.0 } else { self.speed }
    }

    /// The voyage's time.
    #[must_use]
    pub const fn now(&self) -> Stamp {
        self.now
    }

    /// Number of the last line.
    #[must_use]
    pub const fn line(&self) -> u64 {
        self.line
    }

    /// The simulated ship, for tests.
    #[must_use]
    pub const fn world(&self) -> Option<&World> {
        self.world.as_ref()
    }

    /// The autopilot, where it runs here.
    #[must_use]
    pub const fn autopilot(&self) -> Option<&Autopilot> {
        self.autopilot.as_ref()
    }

    /// The chart system, where it runs here.
    #[must_use]
    pub const fn chart_system(&self) -> Option<&ChartSystem> {
        self.chart.as_ref()
    }

    /// The picture of the station that is shown.
    #[must_use]
    pub fn picture(&self) -> &Picture {
        static EMPTY: Picture = Picture::empty();
        match (&self.picture, &self.autopilot) {
            (Some(picture), _) => picture,
            (None, Some(autopilot)) => autopilot.picture(),
            (None, None) => &EMPTY,
        }
    }

    /// Own facts; the caller gives the frame its number.
    #[must_use]
    pub fn snapshot(&self) -> Snapshot {
        let now = self.now;
        let mut alerts = self
            .autopilot
            .as_ref()
            .map_or_else(Vec::new, |autopilot| autopilot.alerts().views());
        if let Some(chart) = &self.chart {
            alerts.extend(chart.alerts());
        }
        alerts.sort_by_key(|alert| alert.priority);
        Snapshot {
            frame: 0,
            at: now.0,
            rate: self.rate(),
            line: self.line,
            digest: self.picture().digest(),
            own: self.autopilot.as_ref().map(|autopilot| autopilot.own(now)),
            chart: self.chart.as_ref().map(ChartSystem::own),
            voyage: self.embedded.as_ref().map(|_| self.voyage_own()),
            alerts,
        }
    }

    fn voyage_own(&self) -> VoyageOwn {
        let current = self.world.as_ref().map(World::current);
        VoyageOwn {
            officer: self.officer.on,
            round: self.round,
            speed: self.speed,
            faults: self.cables.faults(),
            current: current.map_or([0.0; 2], |(set, drift)| [set.deg(), drift.knots()]),
        }
    }

    /// First frame of a connection; the caller says whether that client may command.
    #[must_use]
    pub fn hello(&self, build: &str) -> Hello {
        let picture = self.picture();
        Hello {
            protocol: PROTOCOL,
            build: build.to_string(),
            dictionary: crate::nmea::dictionary().len() as u32,
            picture: picture.clone(),
            line: self.line,
            at: self.now.0,
            rate: self.rate(),
            ports: picture.ports.clone(),
            station: self.shown.name().to_string(),
            simulated: self.embedded.is_some(),
            may_command: false,
        }
    }

    /// The route with its geometry; empty where the chart system is a foreign one.
    #[must_use]
    pub fn route_document(&self) -> RouteDocument {
        self.chart
            .as_ref()
            .map_or_else(RouteDocument::default, ChartSystem::document)
    }

    /// All settings.
    #[must_use]
    pub fn settings_document(&self) -> SettingsDocument {
        SettingsDocument {
            revision: self.settings_revision,
            values: self
                .autopilot
                .as_ref()
                .map_or_else(Vec::new, |autopilot| autopilot.settings().values()),
        }
    }

    /// State of the shown station's ports.
    #[must_use]
    pub fn ports_document(&self) -> PortsDocument {
        let picture = self.picture();
        let view = |(index, (port, count)): (usize, (&PortSetup, &crate::picture::PortCount))| {
            let outside = self
                .outside
                .iter()
                .position(|end| *end == (self.shown, index));
            let up = match outside {
                Some(port) => self.up.get(port).copied().unwrap_or(false),
                None => !self.cables.cut((self.shown, index)),
            };
            PortView {
                name: port.name.clone(),
                up,
                trouble: if up {
                    String::new()
                } else {
                    "the port is gone; it is tried again".into()
                },
                heard: count.heard,
                sent: count.sent,
                bad_checksum: count.bad_checksum,
                garbage: count.garbage,
            }
        };
        PortsDocument {
            revision: self.line,
            ports: picture
                .ports
                .iter()
                .zip(&picture.counts)
                .enumerate()
                .map(view)
                .collect(),
        }
    }

    /// Whether a command reaches anything but the embedded voyage.
    #[must_use]
    pub const fn is_embedded(&self) -> bool {
        self.embedded.is_some()
    }
}

/// Whether a human command takes the watch from the scripted officer.
const fn takes_the_watch(action: &Do) -> bool {
    !matches!(
        action,
        Do::Speed(_)
            | Do::Officer(_)
            | Do::Fault { .. }
            | Do::Current { .. }
            | Do::Acknowledge(_)
            | Do::Silence(_)
    )
}

#[cfg(test)]
mod tests;

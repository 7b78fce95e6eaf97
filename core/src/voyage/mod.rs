//! A voyage: the stations that run here, the cables between them, and the ports to real equipment.
//!
//! In: bytes from real ports, commands, time. Out: bytes to real ports, numbered lines, answers.
//! The embedded voyage, two processes over serial lines, the fault tests and a recording are all this.
//!
//! **Invariant:** stations exchange bytes only; the same events at the same times give the same outputs.

mod cable;
mod conduct;
mod line;
mod officer;
mod see;
mod setup;
mod tap;

use crate::autopilot::Autopilot;
use crate::chart_system::ChartSystem;
use crate::command::{Answer, Order, Origin};
use crate::route::Route;
use crate::settings::Value;
use crate::station::{Input, Output, PortIndex};
use crate::time::Stamp;
use crate::world::World;
use alloc::collections::VecDeque;
use alloc::string::String;
use alloc::vec::Vec;
use cable::Cables;
pub use line::Line;
use officer::Officer;
use serde::{Deserialize, Serialize};
pub use setup::{Role, VoyageConfig};
pub use tap::{Parcel, Tap};

/// What happens to a voyage. A log of `(time, event)` is the whole story (CFG-1).
#[derive(Clone, Debug, PartialEq)]
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
    /// Somebody asks for something.
    Order {
        /// Number for the answer.
        id: u64,
        /// Who.
        by: Origin,
        /// What.
        order: Order,
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
#[derive(Clone, Debug, PartialEq)]
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
        value: Value,
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
    #[serde(skip)]
    tap: tap::Slot,
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
        // FA16: what a stall has missed is not made up for.
        while self.due() <= now && !matches!(event, Event::Stalled { .. }) {
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
            Event::Order { id, by, order } => {
                let answer = self.order(now, by, &order, out);
                let (ok, text) = match answer {
                    Ok(text) => (true, text),
                    Err(text) => (false, text),
                };
                out.push(VoyageOutput::Answer(Answer { id, ok, text }));
            }
            Event::Stalled { ms } => {
                // Every station knows of it before it hears another, which would make it run what was missed.
                for role in Role::ALL {
                    self.input(now, role, Input::Stalled { ms });
                    self.sort_out(now, role, out);
                }
                self.deliver(now, out);
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
        while let Some((role, port, mut bytes)) = self.deliveries.pop_front() {
            if self.tap.is_set() {
                let Some(profile) = self.ports_of(role).get(port).map(|port| port.profile) else {
                    continue;
                };
                let parcel = Parcel {
                    at: now,
                    to: role,
                    profile,
                    bytes: &bytes,
                };
                match self.tap.pass(parcel) {
                    Some(heard) => bytes = heard,
                    None => continue,
                }
            }
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
                    self.line += 1;
                    let text = text.iter().map(|byte| char::from(*byte)).collect();
                    out.push(VoyageOutput::Line(Line {
                        seq: self.line,
                        at: now.0,
                        port,
                        dir,
                        text,
                    }));
                }
                Output::Line { .. } => {}
                Output::Persist { key, value } => {
                    self.settings_revision += 1;
                    out.push(VoyageOutput::Persist { key, value });
                    out.push(VoyageOutput::Settings);
                }
                Output::Answer(_) => {} // taken where the order was given
            }
        }
        self.scratch = outputs;
        let revision = self.chart.as_ref().map_or(0, ChartSystem::revision);
        if revision != self.route_revision {
            self.route_revision = revision;
            out.push(VoyageOutput::Route);
        }
    }
}

#[cfg(test)]
mod tests;

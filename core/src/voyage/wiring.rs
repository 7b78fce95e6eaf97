//! The stations, the cables between them and the ports to the outside: what one says, the others hear.

use super::cable::Cables;
use super::event::VoyageOutput;
use super::line::Line;
use super::officer::Officer;
use super::tap::{Parcel, Slot, Tap};
use crate::autopilot::Autopilot;
use crate::chart_system::ChartSystem;
use crate::route::Route;
use crate::station::{Input, Output, PortIndex, PortSetup, Profile, Role};
use crate::time::Stamp;
use crate::world::World;
use alloc::collections::VecDeque;
use alloc::vec::Vec;
use serde::{Deserialize, Serialize};

/// The stations, their cables and the ports to the outside.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct Voyage {
    pub(super) autopilot: Option<Autopilot>,
    pub(super) chart: Option<ChartSystem>,
    pub(super) world: Option<World>,
    pub(super) cables: Cables,
    /// Configured ports: whose, and which of its ports.
    pub(super) outside: Vec<(Role, PortIndex)>,
    pub(super) up: Vec<bool>,
    pub(super) shown: Role,
    pub(super) line: u64,
    pub(super) embedded: Option<Route>,
    pub(super) officer: Officer,
    pub(super) round: u32,
    pub(super) speed: f64,
    pub(super) route_revision: u64,
    pub(super) settings_revision: u64,
    pub(super) now: Stamp,
    pub(super) officer_due: Stamp,
    #[serde(skip)]
    pub(super) scratch: Vec<Output>,
    #[serde(skip)]
    pub(super) deliveries: VecDeque<(Role, PortIndex, Vec<u8>)>,
    #[serde(skip)]
    pub(super) tap: Slot,
}

impl Voyage {
    /// From now on everything on the cables inside passes `tap` before it is heard.
    pub fn tap(&mut self, tap: Tap) {
        self.tap = Slot(Some(tap));
    }

    /// The ports of a station; none where it does not run here.
    fn ports_of(&self, role: Role) -> &[PortSetup] {
        let picture = match role {
            Role::Autopilot => self.autopilot.as_ref().map(Autopilot::picture),
            Role::ChartSystem => self.chart.as_ref().map(ChartSystem::picture),
            Role::World => self.world.as_ref().map(World::picture),
        };
        picture.map_or(&[], |picture| &picture.ports)
    }

    /// Puts bytes on a cable inside, towards `to`, as if its other end had said them.
    pub fn say(
        &mut self,
        now: Stamp,
        (to, profile): (Role, Profile),
        bytes: &[u8],
        out: &mut Vec<VoyageOutput>,
    ) {
        let ports = self.ports_of(to);
        if let Some(port) = ports.iter().position(|port| port.profile == profile) {
            self.deliveries.push_back((to, port, bytes.to_vec()));
            self.deliver(now, out);
        }
    }

    pub(super) fn input(&mut self, now: Stamp, role: Role, input: Input<'_>) {
        let out = &mut self.scratch;
        match role {
            Role::World => {
                if let Some(world) = &mut self.world {
                    World::handle(world, now, input, out);
                }
            }
            Role::ChartSystem => {
                if let Some(chart) = &mut self.chart {
                    ChartSystem::handle(chart, now, input, out);
                }
            }
            Role::Autopilot => {
                if let Some(autopilot) = &mut self.autopilot {
                    Autopilot::handle(autopilot, now, input, out);
                }
            }
        }
    }

    /// Carries what a station gave to the cables, the ports and the lines.
    pub(super) fn settle(&mut self, now: Stamp, from: Role, out: &mut Vec<VoyageOutput>) {
        self.sort_out(now, from, out);
        self.deliver(now, out);
    }

    pub(super) fn deliver(&mut self, now: Stamp, out: &mut Vec<VoyageOutput>) {
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

    pub(super) fn sort_out(&mut self, now: Stamp, from: Role, out: &mut Vec<VoyageOutput>) {
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
                Output::Settings => {
                    self.settings_revision += 1;
                    out.push(VoyageOutput::Settings);
                }
                Output::Contact { contact, closed } => out.push(VoyageOutput::Contact {
                    station: from,
                    contact,
                    closed,
                }),
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

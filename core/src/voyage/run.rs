//! The course of a voyage: what is due is run in order of time, then what happens is taken.

use super::event::{Event, VoyageOutput};
use super::wiring::Voyage;
use crate::autopilot::Autopilot;
use crate::chart_system::ChartSystem;
use crate::command::Answer;
use crate::station::{Input, Role};
use crate::time::Stamp;
use crate::world::World;
use alloc::vec::Vec;

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
                if let Some((role, port)) = self.outside.get(port).copied() {
                    self.input(now, role, Input::Port { port, up });
                    self.settle(now, role, out);
                }
            }
            Event::Contact { switch, closed } => {
                let role = Role::Autopilot;
                self.input(now, role, Input::Contact { switch, closed });
                self.settle(now, role, out);
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
}

//! Commands: to whom each goes, what the embedded voyage does with its own, what the officer presses.

use super::event::VoyageOutput;
use super::officer::{Action, InView, Officer};
use super::wiring::Voyage;
use crate::alerts::Alert;
use crate::command::{FaultKind, Order, Origin};
use crate::station::{Input, Output, Role};
use crate::time::Stamp;
use alloc::format;
use alloc::string::{String, ToString};
use alloc::vec::Vec;

const NOT_EMBEDDED: &str = "only in the embedded voyage";

impl Voyage {
    /// An officer's order takes the watch from the scripted officer.
    pub(super) fn order(
        &mut self,
        now: Stamp,
        by: Origin,
        action: &Order,
        out: &mut Vec<VoyageOutput>,
    ) -> Result<String, String> {
        if by == Origin::Officer && self.embedded.is_some() && takes_the_watch(action) {
            self.officer.on = false;
        }
        self.carry_out(now, by, action, out)
    }

    /// Gives an order to the station that it concerns.
    fn carry_out(
        &mut self,
        now: Stamp,
        by: Origin,
        order: &Order,
        out: &mut Vec<VoyageOutput>,
    ) -> Result<String, String> {
        match order {
            Order::Speed(_) | Order::Officer(_) | Order::Fault { .. } => self.conduct(now, order),
            Order::Current { .. } if self.embedded.is_none() => Err(NOT_EMBEDDED.into()),
            Order::Current { .. } => self
                .ask(now, Role::World, by, order, out)
                .unwrap_or_else(|| Err(NOT_EMBEDDED.into())),
            Order::Chart(_) | Order::LoadRoute(_) => self
                .ask(now, Role::ChartSystem, by, order, out)
                .unwrap_or_else(|| Err("the chart system is a foreign one".into())),
            Order::Acknowledge(number)
                if of_the_chart_system(*number) || self.autopilot.is_none() =>
            {
                self.ask(now, Role::ChartSystem, by, order, out)
                    .unwrap_or_else(|| Err(format!("alert {number} waits for no acknowledgement")))
            }
            _ => {
                if matches!(order, Order::Silence(_)) {
                    self.ask(now, Role::ChartSystem, by, order, out);
                }
                self.ask(now, Role::Autopilot, by, order, out)
                    .unwrap_or_else(|| {
                        Err("the autopilot is a foreign one: command it there".into())
                    })
            }
        }
    }

    /// A station's answer to an order; none where it does not run here.
    fn ask(
        &mut self,
        now: Stamp,
        role: Role,
        by: Origin,
        order: &Order,
        out: &mut Vec<VoyageOutput>,
    ) -> Option<Result<String, String>> {
        self.input(now, role, Input::Order { by, order });
        let mut answer = None;
        self.scratch.retain(|output| match output {
            Output::Answer(given) => {
                answer = Some(given.clone().map_err(|refusal| refusal.to_string()));
                false
            }
            _ => true,
        });
        self.settle(now, role, out);
        answer
    }

    /// Commands that only the embedded voyage knows.
    pub(super) fn conduct(&mut self, now: Stamp, action: &Order) -> Result<String, String> {
        if self.embedded.is_none() {
            return Err(NOT_EMBEDDED.into());
        }
        match action {
            Order::Speed(speed) if (1.0..=60.0).contains(speed) => {
                self.speed = *speed;
                Ok(format!("{speed}x"))
            }
            Order::Speed(speed) => Err(format!("speed is {speed}, allowed are 1 to 60")),
            Order::Officer(on) => {
                self.officer = Officer::new(now, *on);
                let text = if *on {
                    "the scripted officer has the watch"
                } else {
                    "you have the watch"
                };
                Ok(text.into())
            }
            Order::Fault { cable, kind, on } => {
                let sensor = matches!(
                    kind,
                    FaultKind::Jump | FaultKind::Stuck | FaultKind::StuckPort
                );
                let profile = self.cables.profile(cable);
                let known = match (sensor, &mut self.world, profile) {
                    (_, _, None) => return Err(format!("no cable is named {cable}")),
                    (true, Some(world), Some(profile)) => world.injure(profile, *kind, *on),
                    (true, ..) => false,
                    (false, ..) => true,
                };
                if !known {
                    return Err(format!(
                        "{cable} cannot do that: only gyro1, gps and log jump or stick, and rudders stick"
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
    pub(super) fn watch(&mut self, now: Stamp, out: &mut Vec<VoyageOutput>) {
        if self.embedded.is_none() {
            return;
        }
        let (Some(autopilot), Some(chart)) = (&self.autopilot, &self.chart) else {
            return;
        };
        let alerts: Vec<_> = autopilot
            .alerts()
            .standing()
            .iter()
            .chain(chart.alerts())
            .collect();
        let view = InView {
            mode: autopilot.mode().name(),
            pending: autopilot.pending().is_some(),
            situation: chart.situation(),
            commanded: chart.control_name() != "off",
            alerts: &alerts,
        };
        match self.officer.next(now, &view) {
            Some(Action::Command(action)) => {
                // A refused command is tried again; the reason stands in the snapshot.
                let _ = self.order(now, Origin::Script, &action, out);
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
}

/// Whether an alert of that number is one of the chart system's.
fn of_the_chart_system(number: u16) -> bool {
    Alert::of_number(number).is_some_and(|alert| alert.station() == Role::ChartSystem)
}

/// Whether a human command takes the watch from the scripted officer.
const fn takes_the_watch(action: &Order) -> bool {
    !matches!(
        action,
        Order::Speed(_)
            | Order::Officer(_)
            | Order::Fault { .. }
            | Order::Current { .. }
            | Order::Acknowledge(_)
            | Order::Silence(_)
    )
}

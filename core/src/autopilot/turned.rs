//! The motor that turns the rudder, where one does: told the order in each control step, heard as the gear's RSA (AP-18, FA11).
//!
//! A motor that fails stands, the rudder is held, and an alarm says why; it is driven again when the operator selects a mode
//! anew, and not before. What it feeds back is a line of the gear's port, so that everybody sees the same.

use super::gear::{Gear, Mount};
use super::notices::Notice;
use crate::alerts::Alert;
use crate::command::Order;
use crate::motor::{Motor, MotorFault, MotorSetup};
use crate::nmea::{DataStatus, Rsa};
use crate::post::Post;
use crate::settings::Settings;
use crate::station::{Output, PortIndex, Profile};
use crate::time::Stamp;
use crate::units::RudderAngle;
use alloc::string::{String, ToString};
use alloc::vec::Vec;
use serde::{Deserialize, Serialize};

/// A motor, and whether it is held.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub(super) struct Turned {
    motor: Motor,
    /// Why it failed while it was driven; until a mode is selected anew.
    held: Option<MotorFault>,
}

/// Where a motor is, by the ports and the settings.
#[derive(Clone, Copy, Debug)]
pub(super) struct Place<'a>(pub(super) &'a Post, pub(super) &'a Settings);

impl Place<'_> {
    /// The gear's port and the motor behind it, where one is.
    fn motor(self) -> Option<(PortIndex, MotorSetup)> {
        let setup = MotorSetup::of(self.1)?;
        let mut ports = self.0.ports().iter();
        Some((ports.position(|port| port.profile == Profile::Gear)?, setup))
    }

    fn tell(self, port: PortIndex, bytes: Vec<u8>, out: &mut Vec<Output>) {
        let may = self.0.ports().get(port).is_some_and(|port| port.output);
        if may && !bytes.is_empty() {
            out.push(Output::Send { port, bytes });
        }
    }
}

impl Turned {
    /// That is expected to speak from `now` on.
    pub(super) fn new(now: Stamp) -> Self {
        Self {
            motor: Motor::new(now),
            held: None,
        }
    }

    /// What keeps the rudder from being turned by it: what is wrong and does not end by trying again.
    pub(super) fn prevents(&self) -> Option<MotorFault> {
        let tried = |fault: &MotorFault| !fault.may_be_tried_again();
        self.motor.fault().or(self.held).filter(tried)
    }

    /// How often it has started.
    pub(super) const fn starts(&self) -> u64 {
        self.motor.starts()
    }

    /// FA16: nothing that was heard before counts.
    pub(super) fn stalled(&mut self, now: Stamp) {
        self.motor.stalled(now);
    }

    /// Takes bytes of a motor; false where the port is none's.
    pub(super) fn hear(
        &mut self,
        now: Stamp,
        port: PortIndex,
        bytes: &[u8],
        at: Place<'_>,
    ) -> bool {
        let motor = at.motor().filter(|(of, _)| *of == port);
        motor.is_some_and(|(_, setup)| {
            self.motor.hear(now, bytes, &setup);
            true
        })
    }

    /// What the motor feeds back, as the gear's RSA with its end, and the port.
    pub(super) fn said(&self, now: Stamp, at: Place<'_>) -> Option<(PortIndex, String)> {
        let (port, _) = at.motor()?;
        let response = self.motor.response(now).map(RudderAngle::deg);
        let status = match response {
            Some(_) => DataStatus::Valid,
            None => DataStatus::Invalid,
        };
        let rsa = Rsa {
            starboard: response,
            starboard_status: Some(status),
            port: None,
            port_status: Some(DataStatus::Invalid),
        };
        Some((port, rsa.line("II") + "\r\n"))
    }

    /// One control step of the motor, where orders are `given`. Gives why it fails, where it does so now, and what is to be said.
    pub(super) fn drive(
        &mut self,
        now: Stamp,
        (gear, given): (&Gear, bool),
        at: Place<'_>,
        out: &mut Vec<Output>,
    ) -> (Option<MotorFault>, Notice) {
        let mut failed = None;
        if let Some((port, setup)) = at.motor() {
            let driven = given && self.held.is_none();
            // EMC-7: the motor is told its positions.
            let orders = Mount::of(at.1).positions(gear.ror(driven));
            let order = orders.starboard.map(RudderAngle::from_deg);
            let dt = at.1.step_ms() as f64 / 1000.0;
            at.tell(port, self.motor.step(now, order, &setup, dt), out);
            failed = self.motor.fault().filter(|_| driven);
            self.held = self.held.or(failed);
        } else {
            self.held = None;
        }
        let fault = self.motor.fault().or(self.held);
        let fault = fault.filter(|_| at.motor().is_some());
        let text = fault.map(|fault| fault.text().to_string());
        (failed, Notice::of(Alert::Motor, text))
    }

    /// The motor stands as soon as no order is given, without waiting for a control step.
    pub(super) fn stop(&mut self, at: Place<'_>, out: &mut Vec<Output>) {
        if let Some((port, setup)) = at.motor() {
            at.tell(port, self.motor.stop(&setup), out);
        }
    }

    /// Somebody asks for something that steers: a motor that was held may be driven again, but not one that goes the wrong
    /// way. Gives why it was held.
    pub(super) fn try_again(
        &mut self,
        now: Stamp,
        order: &Order,
        at: Place<'_>,
        out: &mut Vec<Output>,
    ) -> Option<MotorFault> {
        let (port, setup) = at.motor().filter(|_| order.steers())?;
        let held = self.held.take_if(|fault| *fault != MotorFault::Reversed)?;
        at.tell(port, self.motor.try_again(now, &setup), out);
        Some(held)
    }

    /// What was asked for was refused: the motor is held as before.
    pub(super) fn hold(&mut self, held: Option<MotorFault>) {
        self.held = self.held.or(held);
    }

    /// What the motor is told of itself was changed from what it was: it may be driven again.
    pub(super) fn renew(&mut self, now: Stamp, before: &Settings, settings: &Settings) {
        let (before, setup) = (MotorSetup::of(before), MotorSetup::of(settings));
        if let Some(setup) = setup.filter(|setup| before.as_ref() != Some(setup)) {
            self.held = None;
            let _unsaid = self.motor.try_again(now, &setup);
        }
    }
}

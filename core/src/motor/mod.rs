//! A motor that turns a rudder or a tiller, behind its controller (AP-18, `[gear] kind = "motor"`).
//!
//! In: the rudder order of each control step, the bytes of the controller's line. Out: bytes to it, where the rudder is, and why
//! the motor stands where it does. The controller may speak either of two public protocols ([`Protocol`]); both are told the
//! motor's speed, so that dead band, damping, travel and what stops it are the same.
//!
//! **Invariant:** without an order, or with a fault, the motor is told to stand, and nothing else.

mod drive;
mod fault;
mod guard;
mod heard;
pub mod jrk;
pub mod pypilot;
mod setup;

pub use fault::MotorFault;
pub use setup::{MotorSetup, Protocol};

use crate::time::Stamp;
use crate::units::RudderAngle;
use alloc::vec::Vec;
use drive::Drive;
use guard::Guard;
use heard::Heard;
use serde::{Deserialize, Serialize};

/// What a controller is told again so often, milliseconds: its largest current.
const RENEWED_MS: u64 = 2_000;
/// So long after it is tried again may a controller still speak of what was before, milliseconds.
const FORGIVEN_MS: u64 = 300;

/// A motor, as the autopilot knows it.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Motor {
    heard: Heard,
    drive: Drive,
    guard: Guard,
    /// Since when its controller may be expected to speak.
    since: Stamp,
    /// What it was told last, -1 to 1, starboard positive; absent while it is not engaged.
    told: Option<f64>,
    renewed: Option<Stamp>,
    /// What was seen while it ran, until it is tried again.
    lasting: Option<MotorFault>,
    /// When it was tried again: what its controller complained of before does not count.
    tried: Option<Stamp>,
    fault: Option<MotorFault>,
}

impl Motor {
    /// A motor that is expected to speak from `now` on.
    #[must_use]
    pub fn new(now: Stamp) -> Self {
        Self {
            heard: Heard::default(),
            drive: Drive::default(),
            guard: Guard::default(),
            since: now,
            told: None,
            renewed: None,
            lasting: None,
            tried: None,
            fault: None,
        }
    }

    /// Takes bytes of the controller's line.
    pub fn hear(&mut self, now: Stamp, bytes: &[u8], setup: &MotorSetup) {
        self.heard.take(now, bytes, setup);
    }

    /// Where the rudder is; absent where that was not said within 230 ms.
    #[must_use]
    pub fn response(&self, now: Stamp) -> Option<RudderAngle> {
        self.heard.position(now).map(RudderAngle::from_deg)
    }

    /// Why the motor stands though it has an order, or would.
    #[must_use]
    pub const fn fault(&self) -> Option<MotorFault> {
        self.fault
    }

    /// How often the motor has started.
    #[must_use]
    pub const fn starts(&self) -> u64 {
        self.drive.starts()
    }

    /// FA16: nothing that was heard before counts.
    pub fn stalled(&mut self, now: Stamp) {
        self.heard = Heard::default();
        self.since = now;
        self.guard.forget();
    }

    /// Somebody engages it anew, or has changed what it is told of itself: what may be tried again is forgotten. The bytes
    /// say so to the controller.
    pub fn try_again(&mut self, now: Stamp, setup: &MotorSetup) -> Vec<u8> {
        self.guard.forget();
        self.lasting = None;
        self.tried = Some(now);
        self.fault = self.seen(now);
        self.renewed = None;
        match setup.protocol {
            Protocol::Pypilot => packet(pypilot::code::RESET, 0),
            Protocol::Jrk => Vec::new(), // a command clears its errors
        }
    }

    /// One control step of `dt` seconds: what the controller is told. Without an order the motor stands, disengaged.
    pub fn step(
        &mut self,
        now: Stamp,
        order: Option<RudderAngle>,
        setup: &MotorSetup,
        dt: f64,
    ) -> Vec<u8> {
        let position = self.heard.position(now);
        self.fault = self.watch(now, position, setup, dt);
        let speed = match (order, position, self.fault) {
            (Some(order), Some(position), None) => {
                let order =
                    (order.deg() + setup.trim_deg).clamp(-setup.travel_deg, setup.travel_deg);
                let speed = self.drive.step(order, position, setup, dt);
                Some(self.heard.within_ends(speed))
            }
            _ => None,
        };
        let mut out = Vec::new();
        match speed {
            Some(speed) => self.tell(now, speed, setup, &mut out),
            None => self.stand(setup, &mut out),
        }
        if setup.protocol == Protocol::Jrk {
            self.heard.begin();
            jrk::ask(&mut out);
        }
        out
    }

    /// Stops it at once, without waiting for a control step.
    pub fn stop(&mut self, setup: &MotorSetup) -> Vec<u8> {
        let mut out = Vec::new();
        self.stand(setup, &mut out);
        out
    }

    /// What can be seen of it while it stands.
    fn seen(&self, now: Stamp) -> Option<MotorFault> {
        let forgiven = self.tried.is_some_and(|at| now.since(at) <= FORGIVEN_MS);
        Guard::standing(now, self.since, &self.heard)
            .filter(|fault| !(forgiven && fault.may_be_tried_again()))
    }

    /// What is wrong now; what was seen while it ran stays until it is tried again.
    fn watch(
        &mut self,
        now: Stamp,
        position: Option<f64>,
        setup: &MotorSetup,
        dt: f64,
    ) -> Option<MotorFault> {
        if let (Some(told), Some(angle)) = (self.told, position) {
            let current = self.heard.current();
            let seen = self.guard.running(told, angle, current, setup, dt);
            self.lasting = self.lasting.or(seen);
        }
        // It runs, and nobody says where the rudder is.
        let blind = self.told.is_some() && position.is_none();
        let blind = blind.then_some(MotorFault::NoFeedback);
        self.seen(now).or(blind).or(self.lasting)
    }

    fn tell(&mut self, now: Stamp, speed: f64, setup: &MotorSetup, out: &mut Vec<u8>) {
        self.told = Some(speed);
        let sign = if setup.reversed { -1.0 } else { 1.0 };
        match setup.protocol {
            Protocol::Pypilot => {
                if self.renewed.is_none_or(|at| now.since(at) >= RENEWED_MS) {
                    self.renewed = Some(now);
                    let current = (setup.current_max_a * 100.0).clamp(0.0, 65_535.0) as u16;
                    out.extend(packet(pypilot::code::MAX_CURRENT, current));
                }
                out.extend(pypilot::speed(sign * speed).bytes());
            }
            Protocol::Jrk => jrk::say_speed(sign * speed, out),
        }
    }

    fn stand(&mut self, setup: &MotorSetup, out: &mut Vec<u8>) {
        let ran = self.told.take().is_some();
        self.drive.halt();
        self.guard.forget();
        match setup.protocol {
            Protocol::Pypilot => {
                if ran {
                    out.extend(pypilot::speed(0.0).bytes());
                }
                out.extend(packet(pypilot::code::DISENGAGE, 0));
            }
            Protocol::Jrk => out.push(jrk::STOP),
        }
    }
}

fn packet(code: u8, value: u16) -> Vec<u8> {
    pypilot::Packet { code, value }.bytes().to_vec()
}

#[cfg(test)]
mod tests;

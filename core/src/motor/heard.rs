//! What a motor controller says, whichever protocol it speaks.

use super::fault::MotorFault;
use super::setup::{MotorSetup, Protocol};
use super::{jrk, pypilot};
use crate::time::Stamp;
use crate::units::RudderAngle;
use serde::{Deserialize, Serialize};

/// Feedback that is older is lost, milliseconds: at the next control step of 100 ms the motor stands, within 300 ms.
const FEEDBACK_MS: u64 = 230;
/// Faster than this no rudder goes; feedback that leaps is used when it comes twice, degrees a second.
const FASTEST: f64 = 60.0;
/// Two leaps that agree within this are where the rudder is, degrees.
const AGREES_DEG: f64 = 3.0;

/// What was heard last.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub(super) struct Heard {
    pypilot: pypilot::Reader,
    jrk: jrk::Reader,
    /// When anything whole came.
    at: Option<Stamp>,
    /// Where the rudder is, degrees, and when that was said.
    position: Option<(f64, Stamp)>,
    /// Where it leapt to.
    leapt: Option<f64>,
    /// Amperes.
    current: Option<f64>,
    fault: Option<MotorFault>,
    /// End switches to port and to starboard.
    ends: [bool; 2],
}

impl Heard {
    /// Takes bytes of the line.
    pub(super) fn take(&mut self, now: Stamp, bytes: &[u8], setup: &MotorSetup) {
        for byte in bytes {
            match setup.protocol {
                Protocol::Pypilot => {
                    if let Some(packet) = self.pypilot.take(*byte) {
                        self.packet(now, packet, setup);
                    }
                }
                Protocol::Jrk => {
                    if let Some(answer) = self.jrk.take(*byte) {
                        self.answer(now, answer, setup);
                    }
                }
            }
        }
    }

    /// Before it is asked again.
    pub(super) fn begin(&mut self) {
        self.jrk.begin();
    }

    fn packet(&mut self, now: Stamp, packet: pypilot::Packet, setup: &MotorSetup) {
        use pypilot::{FULL, NONE, code, flag};
        let value = packet.value;
        match packet.code {
            code::RUDDER if value == NONE => self.position = None,
            code::RUDDER => self.place(now, f64::from(value) / f64::from(FULL), setup),
            code::CURRENT => self.current = Some(f64::from(value) / 100.0),
            code::FLAGS => {
                let any = |flags: u16| value & flags != 0;
                self.ends = [any(flag::END_PORT), any(flag::END_STARBOARD)];
                // Feedback at its least is the port end where it is mounted so.
                let turned = setup.feedback_starboard < setup.feedback_port;
                self.ends[usize::from(turned)] |= any(flag::LEAST_RUDDER);
                self.ends[usize::from(!turned)] |= any(flag::MOST_RUDDER);
                self.fault = if any(flag::OVER_CURRENT) {
                    Some(MotorFault::OverCurrent)
                } else if any(flag::TOO_HOT) {
                    Some(MotorFault::TooHot)
                } else if any(flag::BAD_VOLTAGE) {
                    Some(MotorFault::Supply)
                } else {
                    None
                };
            }
            code::VOLTAGE => {}
            // A controller says more than is used here; what it cannot say was damaged without the CRC seeing it.
            _ => return,
        }
        self.at = Some(now);
    }

    fn answer(&mut self, now: Stamp, answer: jrk::Answer, setup: &MotorSetup) {
        use jrk::{FULL, error};
        let any = |errors: u16| answer.errors & errors != 0;
        self.at = Some(now);
        self.current = Some(f64::from(answer.current) / 1000.0);
        self.fault = if any(error::HARD_CURRENT | error::SOFT_CURRENT) {
            Some(MotorFault::OverCurrent)
        } else if any(error::NO_POWER) {
            Some(MotorFault::Supply)
        } else if any(error::DRIVER) {
            Some(MotorFault::Driver)
        } else {
            None
        };
        if any(error::NO_FEEDBACK) {
            self.position = None;
        } else {
            self.place(now, f64::from(answer.feedback) / f64::from(FULL), setup);
        }
    }

    fn place(&mut self, now: Stamp, feedback: f64, setup: &MotorSetup) {
        let Some(angle) = setup.angle(feedback).map(RudderAngle::deg) else {
            self.position = None;
            return;
        };
        let leaps = self.position.is_some_and(|(before, at)| {
            let most = FASTEST * (now.since(at) as f64 / 1000.0) + AGREES_DEG;
            libm::fabs(angle - before) > most
        });
        let agrees = (self.leapt).is_some_and(|there| libm::fabs(there - angle) <= AGREES_DEG);
        if leaps && !agrees {
            self.leapt = Some(angle);
            return;
        }
        self.leapt = None;
        self.position = Some((angle, now));
    }

    /// Where the rudder is, where that is not too old.
    pub(super) fn position(&self, now: Stamp) -> Option<f64> {
        let (angle, at) = self.position?;
        (now.since(at) <= FEEDBACK_MS).then_some(angle)
    }

    pub(super) const fn current(&self) -> Option<f64> {
        self.current
    }

    pub(super) const fn fault(&self) -> Option<MotorFault> {
        self.fault
    }

    /// The speed that the end switches leave of one.
    pub(super) fn within_ends(&self, speed: f64) -> f64 {
        let [port, starboard] = self.ends;
        if (port && speed < 0.0) || (starboard && speed > 0.0) {
            0.0
        } else {
            speed
        }
    }

    /// Whether it has said anything since `since` or within `ms`.
    pub(super) fn is_there(&self, now: Stamp, since: Stamp, ms: u64) -> bool {
        let last = self.at.unwrap_or(since).max(since);
        now.since(last) <= ms
    }
}

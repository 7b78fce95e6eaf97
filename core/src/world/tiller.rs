//! The simulated boat's tiller: a motor with backlash behind a controller that speaks either public protocol.
//!
//! ```text
//! w' = (w_max u - w) / T      motor, deg/s of rudder       m' = w
//! the rudder is moved by the motor when the play between them is used up: |m - rudder| <= play / 2
//! ```
//! Also the counterpart of tests over a pseudo-terminal: its line loses bytes, its feedback fails, it blocks, runs backwards,
//! takes too much current or says nothing, as it is told.

use super::noise::Random;
use crate::motor::{Protocol, jrk, pypilot};
use alloc::vec::Vec;
use serde::{Deserialize, Serialize};

/// Full speed, degrees of rudder a second.
const FULL_SPEED: f64 = 8.0;
/// Time constant of the motor, s.
const SPIN_UP: f64 = 0.12;
/// The rudder's travel, degrees.
const TRAVEL: f64 = 35.0;
/// Feedback at the ends, as a part of its range.
const FEEDBACK: (f64, f64) = (0.1, 0.9);
/// A controller that is not spoken to stops the motor, s.
const TIMEOUT: f64 = 0.7;

/// What is done to a motor and its line.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct TillerFaults {
    /// It says nothing.
    pub silent: bool,
    /// Its feedback is cut.
    pub no_feedback: bool,
    /// The rudder is blocked.
    pub blocked: bool,
    /// Its wires are changed.
    pub reversed: bool,
    /// It takes 30 A.
    pub over_current: bool,
    /// Of both directions, so many bytes in a hundred are lost.
    pub lost_percent: u8,
}

/// A motor, its controller and the rudder that it turns.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Tiller {
    protocol: Protocol,
    /// What is done to it.
    pub faults: TillerFaults,
    /// Play between motor and rudder, degrees.
    pub play: f64,
    random: Random,
    /// Told, -1 to 1; absent while it is not engaged.
    told: Option<f64>,
    quiet: f64,
    speed: f64,
    motor: f64,
    rudder: f64,
    /// Latched by the controller.
    tripped: bool,
    pypilot: pypilot::Reader,
    /// Bytes of a command of the other protocol.
    command: Vec<u8>,
    asked: Vec<u8>,
}

impl Tiller {
    /// At rest amidships.
    #[must_use]
    pub fn new(protocol: Protocol, seed: u64) -> Self {
        Self {
            protocol,
            faults: TillerFaults::default(),
            play: 0.4,
            random: Random::new(seed),
            told: None,
            quiet: 0.0,
            speed: 0.0,
            motor: 0.0,
            rudder: 0.0,
            tripped: false,
            pypilot: pypilot::Reader::default(),
            command: Vec::new(),
            asked: Vec::new(),
        }
    }

    /// Where the rudder is, degrees, starboard positive.
    #[must_use]
    pub const fn rudder(&self) -> f64 {
        self.rudder
    }

    /// Whether the motor is driven now.
    #[must_use]
    pub fn runs(&self) -> bool {
        self.told.is_some_and(|told| told != 0.0)
    }

    /// Takes bytes of the line.
    pub fn hear(&mut self, bytes: &[u8]) {
        for byte in bytes {
            if self.loses() {
                continue;
            }
            match self.protocol {
                Protocol::Pypilot => self.hear_packet(*byte),
                Protocol::Jrk => self.hear_command(*byte),
            }
        }
    }

    fn hear_packet(&mut self, byte: u8) {
        use pypilot::code;
        let Some(packet) = self.pypilot.take(byte) else {
            return;
        };
        self.quiet = 0.0;
        match packet.code {
            code::COMMAND => self.told = pypilot::commanded(packet),
            code::DISENGAGE => self.told = None,
            code::RESET => self.tripped = false,
            _ => {}
        }
    }

    fn hear_command(&mut self, byte: u8) {
        if byte >= 0x80 {
            self.command.clear();
        }
        self.command.push(byte);
        match *self.command.as_slice() {
            [jrk::STOP] => self.told = None,
            [jrk::DUTY, low, high] => {
                self.told = jrk::speed([low, high]);
                self.tripped = false;
            }
            [jrk::ASK, offset, length] => self.asked.extend([offset, length]),
            [jrk::DUTY | jrk::ASK] | [jrk::DUTY | jrk::ASK, _] => return,
            _ => {}
        }
        self.quiet = 0.0;
        self.command.clear();
    }

    fn loses(&mut self) -> bool {
        let lost = f64::from(self.faults.lost_percent) / 100.0;
        lost > 0.0 && self.random.uniform() < lost
    }

    /// Goes on for `dt` seconds.
    pub fn step(&mut self, dt: f64) {
        self.quiet += dt;
        if self.quiet > TIMEOUT {
            self.told = None;
        }
        self.tripped |= self.faults.over_current && self.runs();
        let told = self.told.filter(|_| !self.tripped).unwrap_or(0.0);
        let told = if self.faults.reversed { -told } else { told };
        self.speed += (FULL_SPEED * told - self.speed) * (dt / (dt + SPIN_UP));
        if self.faults.blocked {
            self.speed = 0.0;
        }
        self.motor = (self.motor + self.speed * dt).clamp(-TRAVEL - self.play, TRAVEL + self.play);
        let half = self.play / 2.0;
        self.rudder =
            (self.rudder.clamp(self.motor - half, self.motor + half)).clamp(-TRAVEL, TRAVEL);
    }

    /// What its controller says now: by itself, or because it was asked.
    pub fn say(&mut self) -> Vec<u8> {
        let (low, high) = FEEDBACK;
        let part = low + (high - low) * (self.rudder + TRAVEL) / (2.0 * TRAVEL);
        let amperes = if self.faults.over_current && self.runs() {
            30.0
        } else {
            self.speed.abs() * 0.4
        };
        let mut said = match self.protocol {
            Protocol::Pypilot => self.packets(part, amperes),
            Protocol::Jrk => self.answers(part, amperes),
        };
        if self.faults.silent {
            said.clear();
        }
        said.retain(|_| !self.loses());
        said
    }

    fn packets(&self, part: f64, amperes: f64) -> Vec<u8> {
        use pypilot::{FULL, NONE, Packet, code, flag};
        let mut flags = 1;
        if self.told.is_some() {
            flags |= flag::ENGAGED;
        }
        if self.tripped {
            flags |= flag::OVER_CURRENT;
        }
        if self.rudder <= -TRAVEL {
            flags |= flag::END_PORT;
        }
        if self.rudder >= TRAVEL {
            flags |= flag::END_STARBOARD;
        }
        let rudder = if self.faults.no_feedback {
            NONE
        } else {
            (part * f64::from(FULL) + 0.5) as u16
        };
        let said = [
            (code::FLAGS, flags),
            (code::RUDDER, rudder),
            (code::CURRENT, (amperes * 100.0) as u16),
            (code::VOLTAGE, 1_250),
        ];
        let bytes = said.map(|(code, value)| Packet { code, value }.bytes());
        bytes.concat()
    }

    fn answers(&mut self, part: f64, amperes: f64) -> Vec<u8> {
        use jrk::{ASKED, Answer, FULL, error};
        let mut errors = 0;
        if self.faults.no_feedback {
            errors |= error::NO_FEEDBACK;
        }
        if self.tripped {
            errors |= error::SOFT_CURRENT;
        }
        let answer = Answer {
            feedback: (part * f64::from(FULL) + 0.5) as u16,
            errors,
            voltage: 12_500,
            current: (amperes * 1000.0) as u16,
        };
        let bytes = answer.bytes();
        let mut said = Vec::new();
        for asked in core::mem::take(&mut self.asked).chunks(2) {
            if asked == [ASKED[0].0, ASKED[0].1] {
                said.extend(&bytes[..2]);
            } else if asked == [ASKED[1].0, ASKED[1].1] {
                said.extend(&bytes[2..]);
            }
        }
        said
    }
}

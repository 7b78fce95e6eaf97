//! What stops a motor: it is not there, its feedback is lost, it does not move, moves the wrong way, takes too much current,
//! or its controller says so (FA11).

use super::fault::MotorFault;
use super::heard::Heard;
use super::setup::MotorSetup;
use crate::time::Stamp;
use serde::{Deserialize, Serialize};

/// A controller that has said nothing for so long is not there, milliseconds.
const ABSENT_MS: u64 = 1_000;
/// A motor that runs for so many seconds must have moved the rudder by so many degrees.
const STALL_S: f64 = 1.5;
const STALL_DEG: f64 = 0.7;
/// A rudder that has gone so many degrees against the motor goes the wrong way; so long may it run on after the motor was
/// turned round, s.
const WRONG_DEG: f64 = 2.5;
const TURNED_S: f64 = 0.5;
/// So long may the current be above its limit, s.
const CURRENT_S: f64 = 0.3;

/// What is watched while the motor runs.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub(super) struct Guard {
    /// The direction in which it runs, since when (s), and where the rudder was then.
    run: Option<(f64, f64, f64)>,
    over: f64,
}

impl Guard {
    /// Begins anew.
    pub(super) fn forget(&mut self) {
        *self = Self::default();
    }

    /// What can be seen of a motor that stands.
    pub(super) fn standing(now: Stamp, since: Stamp, heard: &Heard) -> Option<MotorFault> {
        if !heard.is_there(now, since, ABSENT_MS) {
            return Some(MotorFault::Absent);
        }
        if let Some(fault) = heard.fault() {
            return Some(fault);
        }
        (heard.position(now).is_none() && now.since(since) > ABSENT_MS)
            .then_some(MotorFault::NoFeedback)
    }

    /// What is seen of a motor that was told to run at `speed` with the rudder at `angle` (degrees), `dt` seconds ago.
    pub(super) fn running(
        &mut self,
        speed: f64,
        angle: f64,
        current: Option<f64>,
        setup: &MotorSetup,
        dt: f64,
    ) -> Option<MotorFault> {
        let over = current.is_some_and(|current| current > setup.current_max_a);
        self.over = if over { self.over + dt } else { 0.0 };
        if self.over >= CURRENT_S {
            return Some(MotorFault::OverCurrent);
        }
        if speed == 0.0 {
            self.run = None;
            return None;
        }
        let direction = libm::copysign(1.0, speed);
        let (_, lasted, from) = match self.run {
            Some((same, lasted, from)) if same == direction => (same, lasted + dt, from),
            _ => (direction, 0.0, angle),
        };
        let from = if lasted < TURNED_S { angle } else { from };
        self.run = Some((direction, lasted, from));
        let gone = (angle - from) * direction;
        if gone < -WRONG_DEG {
            return Some(MotorFault::Reversed);
        }
        if gone > STALL_DEG {
            // It moves: counted from here.
            self.run = Some((direction, 0.0, angle));
        } else if lasted >= STALL_S {
            return Some(MotorFault::Stalled);
        }
        None
    }
}

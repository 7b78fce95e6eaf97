//! The autopilot station: bytes, commands and time in; rudder orders, reports and alerts out.
//!
//! Every control step (10 Hz, AP-15): picture -> supervision -> mode -> steering -> order. Everything
//! the step uses is at most as old as [`crate::limits`] allows.
//!
//! **Invariant:** orders leave only in a mode that gives them, within limit and slew, and the operator's
//! STANDBY is always granted.

pub mod gear;
mod modes;
mod operator;
mod readings;
mod remote;
mod report;
mod selection;
mod sight;
pub mod steering;

use crate::alerts::{Alert, Alerts};
use crate::limits::Quantity;
use crate::nmea::{self, Sentence};
use crate::post::{self, Post, Station};
use crate::settings::Settings;
use crate::station::{Input, Output, PortIndex, PortSetup, Profile, Role};
use crate::talk::{SECOND_MS, Share, When};
use crate::time::Stamp;
use crate::timers::Timers;
use crate::units::{Heading, RateOfTurn, RudderAngle, Speed};
use alloc::collections::VecDeque;
use alloc::format;
use alloc::string::{String, ToString};
use alloc::vec::Vec;
use gear::Gear;
pub use modes::{
    Auto, AutonavTi, AutonavTn, Finish, Mode, ModeName, RudderHold, Standby,
    document as modes_document,
};
use modes::{Event, Facts, Need, Row};
use remote::Remote;
use serde::{Deserialize, Serialize};
pub use sight::Refused;
use sight::{Compasses, PositionGuard, Preferred, RateGuard, SpeedGuard};
use steering::{Steering, SteeringSettings};

/// A selection of AutoNAV that waits for the chart system (AP-6).
pub const CONFIRM_MS: u64 = 20_000;
/// A control loop that kept its time for so long has recovered (FA16).
const STALL_OVER_MS: u64 = 10_000;

/// The autopilot.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct Autopilot {
    post: Post,
    alerts: Alerts,
    settings: Settings,
    steering: Steering,
    gear: Gear,
    mode: Mode,
    why: String,
    heading: Option<Heading>,
    rate: RateOfTurn,
    compasses: Compasses,
    /// Whether position, ground and water come from the preferred source.
    preferred: [Preferred; 3],
    position_guard: PositionGuard,
    rate_guard: RateGuard,
    speed_guard: SpeedGuard,
    remote: Remote,
    timers: Timers<Timer>,
    /// How near the heading to steer she has come since she was off it, degrees, and that heading.
    nearest: Option<(f64, Heading)>,
    /// Alert reports that wait for their share of the line (AP-11).
    reports: VecDeque<Alert>,
    share: Share,
    now: Stamp,
}

/// The autopilot's own times. What ends with a mode stands in the mode.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
enum Timer {
    /// When the next control step is due.
    Step,
    /// When the next reports are due.
    Second,
    /// Since when the control loop keeps its time again (FA16).
    Stalled,
    /// Since when the ship is off the set heading (AP-5).
    OffHeading,
}

impl Autopilot {
    /// An autopilot in STANDBY with these ports; `named_ship` is a ship whose constants are known by her name (AP-20).
    #[must_use]
    pub fn new(
        ports: Vec<PortSetup>,
        settings: Settings,
        named_ship: Option<SteeringSettings>,
        now: Stamp,
    ) -> Self {
        Self {
            steering: Steering::of(named_ship, &settings),
            gear: Gear::default(),
            post: Post::new(Role::Autopilot, ports),
            alerts: Alerts::default(),
            settings,
            mode: Mode::STANDBY,
            why: "start-up".into(),
            heading: None,
            rate: RateOfTurn::from_deg_per_min(0.0),
            compasses: Compasses::default(),
            preferred: Default::default(),
            position_guard: PositionGuard::default(),
            rate_guard: RateGuard::default(),
            speed_guard: SpeedGuard::default(),
            remote: Remote::default(),
            nearest: None,
            timers: Timers::new(&[(Timer::Step, now + 100), (Timer::Second, now + SECOND_MS)]),
            reports: Alert::ALL
                .iter()
                .copied()
                .filter(|alert| alert.number() < 200)
                .collect(),
            share: Share::default(),
            now,
        }
    }

    /// When time alone next changes something.
    #[must_use]
    pub fn due(&self) -> Stamp {
        self.due_next().1
    }

    /// Runs everything due, then takes the input.
    pub fn handle(&mut self, now: Stamp, input: Input<'_>, out: &mut Vec<Output>) {
        if let Input::Stalled { ms } = input {
            self.stalled(now, ms);
            return;
        }
        self.advance(now, out);
        match input {
            Input::Bytes { port, bytes } => post::hear(self, now, port, bytes, out),
            Input::Order { order, .. } => self.obey(now, order, out),
            Input::Stalled { .. } | Input::Tick => {}
        }
    }

    /// FA16: no burst of what was missed; ages count the gap, and every input must be heard again.
    fn stalled(&mut self, now: Stamp, ms: u64) {
        self.now = now;
        self.post.stalled(now);
        self.timers.set(Timer::Step, now + self.step_ms());
        let mut second = self.timers.at(Timer::Second).unwrap_or(now);
        while second <= now {
            second = second + SECOND_MS;
        }
        self.timers.set(Timer::Second, second);
        let text = format!("the control loop was {ms} ms late");
        self.alerts.raise(now, Alert::Stalled, &text);
        self.timers.set(Timer::Stalled, now);
        self.fail_if_old(now);
    }

    fn step_ms(&self) -> u64 {
        (1000.0 / self.settings.step_hz) as u64
    }

    /// What time alone does next, a step before the reports; both timers always run.
    fn due_next(&self) -> (Timer, Stamp) {
        let next = self.timers.earliest(&[Timer::Step, Timer::Second]);
        next.unwrap_or((Timer::Step, self.now))
    }

    fn advance(&mut self, now: Stamp, out: &mut Vec<Output>) {
        while self.due() <= now {
            let (timer, at) = self.due_next();
            self.now = at;
            if timer == Timer::Step {
                self.timers.set(timer, at + self.step_ms());
                self.step(at, out);
            } else {
                self.timers.set(timer, at + SECOND_MS);
                self.report(at, When::Every(SECOND_MS), out);
            }
        }
        self.now = now;
    }

    /// One control step.
    fn step(&mut self, now: Stamp, out: &mut Vec<Output>) {
        post::time_out(self, now, out);
        self.alerts.tick(now);
        // The stall is over once the loop has kept its time for a while.
        let stalled = self.timers.at(Timer::Stalled);
        if stalled.is_some_and(|at| now.since(at) >= STALL_OVER_MS) {
            self.timers.stop(Timer::Stalled);
            self.alerts.rectify(now, Alert::Stalled);
        }
        self.look(now);
        self.supervise(now);
        match (self.mode.demand(&self.facts(now)), self.measured(now)) {
            (Some(demand), Some(measured)) => {
                let limit = RudderAngle::from_deg(self.rudder_limit());
                let dt = self.step_ms() as f64 / 1000.0;
                let given = self.gear.given();
                let wanted = self.steering.step(&measured, &demand, limit, given, dt);
                self.gear
                    .steer(&wanted, limit, self.steering.settings(), dt);
            }
            _ => self.gear.freeze(), // FA7
        }
        self.watch_rudder(now);
        self.watch_heading(now);
        self.report(now, When::Step, out);
        self.report_alerts(now, out);
    }

    /// Takes a transition; the order does not jump (FA6).
    fn apply(&mut self, now: Stamp, event: &Event, why: &str) {
        let before = self.mode.row();
        self.mode = self.mode.next(event, &self.facts(now));
        self.why = why.to_string();
        // While orders are given the steering joins one law to the next by itself; else it begins anew.
        let steers = |row: &Row| row.needs(Need::Heading);
        if !steers(before) && steers(self.mode.row()) {
            // The gear stands where the hand left it.
            let left = self.fresh(self.post.picture.rudder.as_ref(), Quantity::Rudder);
            let left = left.filter(|_| !before.gives_orders());
            self.gear.engage(left.unwrap_or(self.gear.order()));
            if let Some(measured) = self.measured(now) {
                self.steering.engage(&measured);
            }
        }
    }

    /// What modes know of the ship and of what is set.
    fn facts(&self, now: Stamp) -> Facts {
        let heard = self.post.picture.heading(now).map(|heard| heard.value);
        Facts {
            now,
            heading: self.heading.or(heard).unwrap_or(Heading::from_deg(0.0)),
            order: self.gear.order(),
            place: self.position_guard.long_dead_reckoning(now),
            steered: self.gear.steered().copied(),
            settings: self.settings.clone(),
        }
    }

    /// Measured speed, else the set cruise speed (FA10).
    fn speed(&self) -> Speed {
        let cruise = Speed::from_knots(self.settings.cruise_speed);
        self.speed_guard.for_gains().unwrap_or(cruise)
    }
}

impl Station for Autopilot {
    fn post(&mut self) -> &mut Post {
        &mut self.post
    }

    fn heard(&mut self, now: Stamp, port: PortIndex, sentence: &Sentence<'_>) {
        if self.post.ports()[port].profile != Profile::Ecdis {
            return;
        }
        match sentence.formatter {
            "HTC" => self.on_htc(now, port, sentence),
            "XTE" | "PNEY,001" | "PNEY,002" => self.on_distance(now, sentence, true),
            "ACK" => {
                let number = nmea::Ack::from_sentence(sentence).and_then(|ack| ack.number);
                if let Some(number) = number.and_then(|number| u16::try_from(number).ok()) {
                    self.alerts.acknowledge(now, number);
                }
            }
            _ => {}
        }
    }

    fn refused(&mut self, now: Stamp, port: PortIndex, sentence: &Sentence<'_>) {
        let profile = self.post.ports().get(port).map(|port| port.profile);
        match (profile, sentence.formatter) {
            (Some(Profile::Ecdis), "HTC") => self.on_broken_htc(now),
            (Some(Profile::Ecdis), _) => self.on_distance(now, sentence, false),
            _ => {}
        }
    }
}

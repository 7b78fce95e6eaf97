//! The autopilot station: bytes, commands and time in; rudder orders, reports and alerts out.
//!
//! Every control step (10 Hz, AP-15): picture -> supervision -> mode -> steering -> order. Everything
//! the step uses is at most as old as [`crate::limits`] allows.
//!
//! **Invariant:** orders leave only in a mode that gives them, within limit and slew, and the operator's
//! STANDBY is always granted.

mod alerting;
pub mod gear;
mod modes;
mod notices;
mod operator;
mod readings;
mod remote;
mod report;
mod selection;
mod sight;
pub mod steering;

use crate::alerts::Alert;
use crate::limits::Quantity;
use crate::nmea::{self, Sentence};
use crate::picture::Heard;
use crate::post::{self, Post, Station};
use crate::settings::Settings;
use crate::station::{Input, Output, PortIndex, PortSetup, Profile, Role};
use crate::talk::{SECOND_MS, When};
use crate::time::Stamp;
use crate::timers::Timers;
use crate::units::{Heading, RudderAngle};
use alerting::Alerting;
use alloc::format;
use alloc::string::{String, ToString};
use alloc::vec::Vec;
use gear::Gear;
pub use modes::{
    Auto, AutonavTi, AutonavTn, Finish, Mode, ModeName, RudderHold, Standby,
    document as modes_document,
};
use modes::{Cause, Event, Facts, Need, Row};
use notices::Notice;
use remote::Remote;
use serde::{Deserialize, Serialize};
pub use sight::Refused;
use sight::{Sight, Sighted};
use steering::{Measured, Steering, SteeringSettings};

/// A selection of AutoNAV that waits for the chart system (AP-6).
pub const CONFIRM_MS: u64 = 20_000;
/// A control loop that kept its time for so long has recovered (FA16).
const STALL_OVER_MS: u64 = 10_000;

/// The autopilot.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct Autopilot {
    post: Post,
    sight: Sight,
    alerts: Alerting,
    settings: Settings,
    steering: Steering,
    gear: Gear,
    mode: Mode,
    why: String,
    remote: Remote,
    timers: Timers<Timer>,
    /// How near the heading to steer she has come since she was off it, degrees, and that heading.
    nearest: Option<(f64, Heading)>,
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
            sight: Sight::default(),
            alerts: Alerting::new(),
            settings,
            mode: Mode::STANDBY,
            why: "start-up".into(),
            remote: Remote::default(),
            nearest: None,
            timers: Timers::new(&[(Timer::Step, now + 100), (Timer::Second, now + SECOND_MS)]),
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
        self.timers.set(Timer::Step, now + self.settings.step_ms());
        let mut second = self.timers.at(Timer::Second).unwrap_or(now);
        while second <= now {
            second = second + SECOND_MS;
        }
        self.timers.set(Timer::Second, second);
        let text = format!("the control loop was {ms} ms late");
        self.alerts.machine.raise(now, Alert::Stalled, &text);
        self.timers.set(Timer::Stalled, now);
        self.fail_if_old(now);
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
                self.timers.set(timer, at + self.settings.step_ms());
                self.step(at, out);
            } else {
                self.timers.set(timer, at + SECOND_MS);
                self.report(at, When::Every(SECOND_MS), out);
                self.report_monitor(at, out);
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
            self.alerts.machine.rectify(now, Alert::Stalled);
        }
        let unknown = Notice::when(!self.steering.settings().known, Alert::ShipUnknown);
        self.alerts.take(now, unknown);
        self.look(now);
        self.supervise(now);
        match (self.mode.demand(&self.facts(now)), self.measured()) {
            (Some(demand), Some(measured)) => {
                let limit = RudderAngle::from_deg(self.rudder_limit());
                let dt = self.settings.step_ms() as f64 / 1000.0;
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
        let step_ms = self.settings.step_ms();
        self.alerts.report(now, step_ms, &mut self.post, out);
    }

    /// Looks at the sensors; what happened to them is taken in its order (AP-9, FA7 to FA9).
    fn look(&mut self, now: Stamp) {
        let free = !self.mode.row().gives_orders();
        let seen = self.post.seen(now);
        for sighted in self.sight.look(seen, &self.settings, free) {
            match sighted {
                Sighted::Notice(notice) => self.alerts.take(now, notice),
                Sighted::OtherCompass(change) => {
                    self.steering.another_compass(change);
                    self.gear.join();
                }
                Sighted::Heading => {
                    if !matches!(self.mode, Mode::RudderHold(_)) {
                        self.alerts.machine.rectify(now, Alert::HeadingLost);
                    }
                }
                Sighted::NoHeading { heard } => {
                    if self.mode.row().needs(Need::Heading) {
                        let why = if heard {
                            "the heading jumped: rudder held"
                        } else {
                            "no heading for 2 s: rudder held"
                        };
                        self.alerts.machine.raise(now, Alert::HeadingLost, "");
                        self.apply(now, &Event::HeadingLost, why);
                    }
                }
                Sighted::PlaneMoved(by) => {
                    if let Some(offset) = &mut self.remote.offset {
                        // The chart system's places have not moved with the plane.
                        offset.north += by.north;
                        offset.east += by.east;
                    }
                }
                Sighted::Uncorrected(plain) => {
                    let plain = plain && self.mode.is_autonav();
                    self.alerts
                        .machine
                        .set(now, Alert::NoDifferential, plain, "");
                }
                Sighted::PositionJumped => {
                    if matches!(self.mode, Mode::AutonavTi(_)) {
                        self.track_fail(now, Cause::PositionJump, "the position jumped");
                    }
                }
            }
        }
        self.recentre();
    }

    /// A heard value that is fresh and was heard since the last stall.
    fn fresh<T: Clone>(&self, heard: Option<&Heard<T>>, quantity: Quantity) -> Option<T> {
        self.post.seen(self.now).fresh(heard, quantity)
    }

    fn measured(&self) -> Option<Measured> {
        let seen = self.post.seen(self.now);
        self.sight.measured(seen, &self.settings, self.gear.order())
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
            if let Some(measured) = self.measured() {
                self.steering.engage(&measured);
            }
        }
    }

    /// What modes know of the ship and of what is set.
    fn facts(&self, now: Stamp) -> Facts {
        Facts {
            now,
            heading: self
                .sight
                .heading()
                .or_else(|| self.sight.heard(&self.post.picture, now, &self.settings))
                .unwrap_or(Heading::from_deg(0.0)),
            order: self.gear.order(),
            place: self.sight.long_place(now),
            steered: self.gear.steered().copied(),
            settings: self.settings.clone(),
        }
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

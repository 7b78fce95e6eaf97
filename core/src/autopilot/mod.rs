//! The autopilot station: bytes, commands and time in; rudder orders, reports and alerts out.
//!
//! It is its parts, and joins them: `post` hears and says, `sight` judges the sensors, `modes` decides what is steered and
//! why, `steering` which rudder that wants, `gear` makes the order of it and watches the rudder, `alerts` keeps what is
//! said of all this. Each owns its state and its timers, is told what it needs, and gives back what happened; none knows
//! another. Every control step (10 Hz, AP-15) is `step` below. What it uses is no older than [`crate::limits`] allows.
//!
//! **Invariant:** orders leave only in a mode that gives them, within limit and slew; the operator's STANDBY is always granted.

mod alerting;
mod begun;
mod by_hand;
mod change;
mod facts;
pub mod gear;
mod hand_unit;
mod hears;
mod modes;
mod notices;
mod plotter;
mod readings;
mod remote;
mod report;
mod sight;
mod stand;
pub mod steering;
mod times;
mod turned;

use crate::alerts::Alert;
use crate::command::{Order, Origin, Refusal};
use crate::post::{self, Post};
use crate::settings::{Settings, Value};
use crate::station::{Input, Output, Profile};
use crate::talk::{self, SECOND_MS, When};
use crate::time::Stamp;
use crate::timers::Timers;
use crate::units::RudderAngle;
use alerting::Alerting;
use alloc::format;
use alloc::string::String;
use alloc::vec::Vec;
use change::{While, changed};
use facts::Outlook;
use gear::{Angles, Gear, Mount};
use hand_unit::HandUnit;
use modes::Modes;
pub use modes::{
    Auto, AutonavTi, AutonavTn, Autotuning, Dodge, FfuOverride, Finish, Former, Installation, Mode,
    ModeName, NfuOverride, RiverPilot, RudderHold, Standby, Track, WindVane,
    document as modes_document, title_of,
};
use notices::{Notice, Notices};
use serde::{Deserialize, Serialize};
pub use sight::Refused;
use sight::{Sight, Sighted};
use steering::{Demand, Steering};
use times::{STALL_OVER_MS, Timer};
use turned::{Place, Turned};

/// The autopilot.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct Autopilot {
    post: Post,
    sight: Sight,
    modes: Modes,
    steering: Steering,
    gear: Gear,
    turned: Turned,
    hand_unit: HandUnit,
    alerts: Alerting,
    settings: Settings,
    timers: Timers<Timer>,
    now: Stamp,
}

impl Autopilot {
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
            Input::Bytes { port, bytes } => {
                if !(self.turned).hear(now, port, bytes, Place(&self.post, &self.settings)) {
                    post::hear(self, now, port, bytes, out);
                }
            }
            Input::Order { by, order } => self.obey(now, by, order, out),
            Input::Contact { switch, closed } => self.decide(now, |modes, outlook, notices| {
                modes.on_contact(outlook, (switch, closed), notices);
            }),
            Input::Port { port, up } => self.post.port_up(now, port, up),
            Input::Stalled { .. } | Input::Tick => {}
        }
    }

    /// FA16: no burst of what was missed; ages count the gap, and every input must be heard again.
    fn stalled(&mut self, now: Stamp, ms: u64) {
        self.now = now;
        self.post.stalled(now);
        self.turned.stalled(now);
        self.timers.set(Timer::Step, now + self.settings.step_ms());
        let mut second = self.timers.at(Timer::Second).unwrap_or(now);
        while second <= now {
            second = second + SECOND_MS;
        }
        self.timers.set(Timer::Second, second);
        let text = format!("the control loop was {ms} ms late");
        (self.alerts).take(now, Notice::Raised(Alert::Stalled, text));
        self.timers.set(Timer::Stalled, now);
        self.decide(now, |modes, outlook, notices| {
            modes.fail_if_old(outlook, notices)
        });
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
                // HMS: each 30 s, and when what is set has changed (AP-10).
                if self.sight.hms_is_due(at, talk::HMS_MS) {
                    self.report(at, When::Renewed(talk::HMS_MS), out);
                }
                if at.since(self.timers.begin(Timer::HandUnit, at)) >= talk::HAND_UNIT_MS {
                    self.timers.set(Timer::HandUnit, at);
                    self.report(at, When::Every(talk::HAND_UNIT_MS), out);
                }
            }
        }
        self.now = now;
    }

    /// One control step: what is heard, what is believed of it, what is steered and why, the order, what is said.
    fn step(&mut self, now: Stamp, out: &mut Vec<Output>) {
        post::time_out(self, now, out);
        if let Some((port, line)) = self.turned.said(now, Place(&self.post, &self.settings)) {
            post::hear(self, now, port, line.as_bytes(), out);
        }
        self.keep_time(now, out);
        self.look(now);
        self.decide(now, |modes, outlook, notices| {
            modes.supervise(outlook, notices);
        });
        self.steer(now);
        let given = (&self.gear, self.modes.gives_orders());
        let (failed, notice) =
            self.turned
                .drive(now, given, Place(&self.post, &self.settings), out);
        if let Some(fault) = failed {
            self.decide(now, |modes, outlook, _| {
                modes.rudder_lost(outlook, fault.text())
            });
        }
        self.alerts.take(now, notice);
        self.watch(now);
        self.report(now, When::Step, out);
        let (step_ms, unit) = (self.settings.step_ms(), self.modes.unit());
        (self.alerts).report(now, step_ms, unit, &mut self.post, out);
    }

    /// What time alone changes of the alerts; a stall is over once the loop has kept its time for a while (FA16).
    fn keep_time(&mut self, now: Stamp, out: &mut Vec<Output>) {
        self.alerts.tick(now, &self.post, out);
        let stalled = self.timers.at(Timer::Stalled);
        if stalled.is_some_and(|at| now.since(at) >= STALL_OVER_MS) {
            self.timers.stop(Timer::Stalled);
            self.alerts.take(now, Notice::Rectified(Alert::Stalled));
        }
        let known = self.steering.ship().known;
        self.alerts
            .take(now, Notice::when(!known, Alert::ShipUnknown));
    }

    /// Looks at the sensors; what happened to them is taken in its order (AP-9, FA7 to FA9).
    fn look(&mut self, now: Stamp) {
        let (seen, free) = (self.post.seen(now), !self.modes.gives_orders());
        for sighted in self.sight.look(seen, &self.settings, free) {
            match sighted {
                Sighted::Notice(notice) => self.alerts.take(now, notice),
                Sighted::OtherCompass(change) => {
                    self.steering.another_compass(change);
                    self.gear.join();
                }
                Sighted::HeadingBack(change) => {
                    if self.modes.steers_by_rate() {
                        self.steering.another_compass(change);
                        self.gear.join();
                    }
                }
                Sighted::Heading => {
                    if !self.modes.holds_the_rudder() {
                        (self.alerts).take(now, Notice::Rectified(Alert::HeadingLost));
                    }
                }
                Sighted::NoHeading { heard } => self.decide(now, |modes, outlook, notices| {
                    modes.heading_lost(outlook, heard, notices);
                }),
                Sighted::PlaneMoved(by) => self.modes.plane_moved(by),
                Sighted::Uncorrected(plain) => {
                    let plain = plain && self.modes.is_commanded();
                    (self.alerts).take(now, Notice::when(plain, Alert::NoDifferential));
                }
                Sighted::PositionJumped => self.decide(now, |modes, outlook, notices| {
                    modes.position_jumped(outlook, notices);
                }),
            }
        }
        self.recentre(now);
        (self.hand_unit).look(self.post.seen(now), &self.sight, &self.settings, free);
    }

    /// Lays the local plane anew where the ship is, as soon as the mode lets it move.
    fn recentre(&mut self, now: Stamp) {
        let Some(metres) = self.modes.plane_m() else {
            return;
        };
        let Some(old) = self.sight.recentre(metres) else {
            return;
        };
        if let Some(new) = self.sight.plane() {
            self.modes.carry(&|point| new.point(old.position(point)));
            self.engage(now, Angles::default());
        }
    }

    /// The modes, and what they decide by.
    fn modes_and_outlook(&mut self, now: Stamp) -> (&mut Modes, Outlook<'_>) {
        let outlook = Outlook::at(
            now,
            &self.post,
            &self.sight,
            &self.steering,
            (&self.gear, self.turned.prevents()),
            &self.settings,
        );
        (&mut self.modes, outlook)
    }

    /// Has the modes decide something by all that is known; an order does not jump by it (FA6).
    fn decide<R>(
        &mut self,
        now: Stamp,
        act: impl FnOnce(&mut Modes, &Outlook<'_>, &mut Notices) -> R,
    ) -> R {
        let (steered, ordered) = (self.modes.steers(), self.modes.gives_orders());
        let mut notices = Notices::new();
        let (modes, outlook) = self.modes_and_outlook(now);
        let decided = act(modes, &outlook, &mut notices);
        for notice in notices {
            self.alerts.take(now, notice);
        }
        // While orders are given the steering joins one law to the next by itself; else it begins anew.
        if !steered && self.modes.steers() {
            // The gear stands where the hand left it.
            let left = self.rudders(now);
            self.engage(now, left.map(|side| side.filter(|_| !ordered)));
        }
        decided
    }

    fn rudders(&self, now: Stamp) -> Angles {
        Mount::of(&self.settings).rudders(self.post.seen(now).rudders())
    }

    /// Steering and gear begin anew, at the orders where the rudders were left or else at their own.
    fn engage(&mut self, now: Stamp, left: Angles) {
        self.gear.engage_at(left);
        let by_rate = self.modes.steers_by_rate();
        let (_, outlook) = self.modes_and_outlook(now);
        if let Some(measured) = outlook.measured(by_rate) {
            self.steering.engage(&measured);
        }
    }

    /// What is demanded becomes an order; without a demand, or a heading where one is needed, the order is frozen (FA7).
    fn steer(&mut self, now: Stamp) {
        let (modes, outlook) = self.modes_and_outlook(now);
        let measured = outlook.measured(modes.steers_by_rate());
        let demand = modes.demand(&outlook.facts);
        let limit = RudderAngle::from_deg(self.modes.limit(&self.settings));
        let dt = self.settings.step_ms() as f64 / 1000.0;
        let given = self.gear.given();
        let wanted = match (demand, measured) {
            (Some(demand), Some(measured)) => {
                (self.steering).step(&measured, &demand, limit, given, dt)
            }
            (Some(Demand::Rudder(rudder)), None) => self.steering.without_heading(rudder),
            _ => {
                self.gear.freeze();
                return;
            }
        };
        self.gear.steer(&wanted, limit, self.steering.ship(), dt);
    }

    /// What became of the order: the rudder follows it (FA11, AP-4), the ship comes to her heading (AP-5).
    fn watch(&mut self, now: Stamp) {
        let mut ports = self.post.ports().iter();
        let ordered = ports.any(|port| port.profile == Profile::Gear && port.output)
            && self.modes.gives_orders();
        let slew = self.settings.rudder_slew;
        for notice in (self.gear).watch(now, ordered, self.rudders(now), slew) {
            self.alerts.take(now, notice);
        }
        let off = self.decide(now, |modes, outlook, _| modes.is_off_heading(outlook));
        (self.alerts).take(now, Notice::when(off, Alert::OffHeading));
    }

    /// What is due on each port, by the table: once a second, or in a control step.
    fn report(&mut self, now: Stamp, due: When, out: &mut Vec<Output>) {
        let followed = !self.alerts.raised(Alert::Rudder);
        let (modes, outlook) = self.modes_and_outlook(now);
        for (port, line) in report::due(due, modes, &outlook, followed) {
            self.post.say(now, port, &line, out);
        }
    }

    /// Does what the operator asks, or says why not; his STANDBY is always granted (AP-6, HTC-4).
    fn obey(&mut self, now: Stamp, by: Origin, order: &Order, out: &mut Vec<Output>) {
        let setting = self.modes.as_setting(order);
        let order = setting.as_ref().unwrap_or(order);
        let held = self
            .turned
            .try_again(now, order, Place(&self.post, &self.settings), out);
        let answer = self.carry_out(now, by, order);
        self.turned.hold(held.filter(|_| answer.is_err()));
        if !self.modes.gives_orders() {
            self.turned.stop(Place(&self.post, &self.settings), out);
        }
        match (&answer, order) {
            (Err(refusal), _) => self.modes.refuse(&refusal.text),
            (Ok(_), Order::Setting { key, value }) => out.push(Output::Persist {
                key: key.clone(),
                value: value.clone(),
            }),
            (Ok(_), _) => {}
        }
        out.push(Output::Answer(answer));
    }

    fn carry_out(&mut self, now: Stamp, by: Origin, order: &Order) -> Result<String, Refusal> {
        if order.steers() {
            self.modes.yields(now, by, order)?;
        }
        let act = |modes: &mut Modes, outlook: &Outlook<'_>, notices: &mut Notices| {
            modes.carry_out(outlook, order, notices)
        };
        if let Some(done) = self.decide(now, act) {
            return done;
        }
        match order {
            Order::Acknowledge(number) => self.alerts.acknowledge(now, *number),
            Order::Silence(silent) => Ok(self.alerts.silence(now, *silent).into()),
            Order::Setting { key, value } => {
                self.change([(key.as_str(), value)])?;
                Ok(format!("{key} is {value}"))
            }
            _ => Err(Refusal::because("not a command to the autopilot")),
        }
    }

    /// Other settings are in force from now on.
    fn change<'a>(
        &mut self,
        changes: impl IntoIterator<Item = (&'a str, &'a Value)>,
    ) -> Result<(), Refusal> {
        let now = While {
            steering: self.modes.gives_orders(),
            autonav: self.modes.is_or_will_be_commanded(),
        };
        let changed = changed(&self.settings, changes, now)?;
        self.turned.renew(self.now, &self.settings, &changed);
        self.settings = changed;
        self.steering.change(&self.settings);
        self.gear.fit(self.settings.rudders);
        Ok(())
    }
}

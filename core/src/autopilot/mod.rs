//! The autopilot station: bytes, commands and time in; rudder orders, reports and alerts out.
//!
//! Every control step (10 Hz, AP-15): picture -> supervision -> mode -> steering -> order. Everything
//! the step uses is at most as old as [`crate::limits`] allows.
//!
//! **Invariant:** orders leave only in a mode that gives them, within limit and slew, and the operator's
//! STANDBY is always granted.

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
use crate::path::Part;
use crate::post::{self, Post, Station};
use crate::settings::{Settings, SteeringBy};
use crate::station::{Input, Output, PortIndex, PortSetup, Profile, Role};
use crate::time::Stamp;
use crate::units::{Heading, RateOfTurn, RudderAngle, Speed};
use alloc::collections::VecDeque;
use alloc::format;
use alloc::string::{String, ToString};
use alloc::vec::Vec;
use modes::{Event, Ship};
pub use modes::{Finish, Mode, ModeName};
use remote::Remote;
use serde::{Deserialize, Serialize};
pub use sight::Refused;
use sight::{Compasses, PositionGuard, Preferred, RateGuard, SpeedGuard};
use steering::{Demand, Steered, Steering, SteeringSettings, TurnBy};

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
    /// The constants of the ship that was named in the configuration (AP-20).
    named_ship: Option<SteeringSettings>,
    steering: Steering,
    mode: Mode,
    /// Until when the operator's AutoNAV selection stands.
    pending: Option<Stamp>,
    why: String,
    order: RudderAngle,
    steered: Option<Steered>,
    heading: Option<Heading>,
    rate: RateOfTurn,
    compasses: Compasses,
    /// Whether position, ground and water come from the preferred source.
    preferred: [Preferred; 3],
    position_guard: PositionGuard,
    rate_guard: RateGuard,
    speed_guard: SpeedGuard,
    remote: Remote,
    /// The ship has been within half the off-track limit since track control began.
    captured: bool,
    off_track_since: Option<Stamp>,
    stalled_since: Option<Stamp>,
    /// Until when a stop by the chart system may still turn out to be the end of the route (TCS-10).
    stop_cause_until: Option<Stamp>,
    off_heading_since: Option<Stamp>,
    rudder_error_since: Option<Stamp>,
    /// Alert reports that wait for their share of the line (AP-11).
    reports: VecDeque<Alert>,
    now: Stamp,
    next_step: Stamp,
    next_second: Stamp,
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
        let ship = SteeringSettings::of(named_ship.as_ref(), &settings);
        Self {
            named_ship,
            post: Post::new(Role::Autopilot, ports),
            alerts: Alerts::default(),
            settings,
            steering: Steering::new(ship),
            mode: Mode::Standby,
            pending: None,
            why: "start-up".into(),
            order: RudderAngle::from_deg(0.0),
            steered: None,
            heading: None,
            rate: RateOfTurn::from_deg_per_min(0.0),
            compasses: Compasses::default(),
            preferred: Default::default(),
            position_guard: PositionGuard::default(),
            rate_guard: RateGuard::default(),
            speed_guard: SpeedGuard::default(),
            remote: Remote::default(),
            captured: false,
            off_track_since: None,
            stalled_since: None,
            stop_cause_until: None,
            off_heading_since: None,
            rudder_error_since: None,
            reports: Alert::ALL
                .iter()
                .copied()
                .filter(|alert| alert.number() < 200)
                .collect(),
            now,
            next_step: now + 100,
            next_second: now + 1_000,
        }
    }

    /// When time alone next changes something.
    #[must_use]
    pub fn due(&self) -> Stamp {
        self.next_step.min(self.next_second)
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
        self.next_step = now + self.step_ms();
        while self.next_second <= now {
            self.next_second = self.next_second + 1_000;
        }
        let text = format!("the control loop was {ms} ms late");
        self.alerts.raise(now, Alert::Stalled, &text);
        self.stalled_since = Some(now);
        self.fail_if_old(now);
    }

    fn step_ms(&self) -> u64 {
        (1000.0 / self.settings.step_hz) as u64
    }

    fn advance(&mut self, now: Stamp, out: &mut Vec<Output>) {
        while self.due() <= now {
            if self.next_step <= self.next_second {
                let at = self.next_step;
                self.next_step = at + self.step_ms();
                self.now = at;
                self.step(at, out);
            } else {
                let at = self.next_second;
                self.next_second = at + 1_000;
                self.now = at;
                self.report(at, out);
            }
        }
        self.now = now;
    }

    /// One control step.
    fn step(&mut self, now: Stamp, out: &mut Vec<Output>) {
        post::time_out(self, now, out);
        self.alerts.tick(now);
        // The stall is over once the loop has kept its time for a while.
        if self
            .stalled_since
            .is_some_and(|at| now.since(at) >= STALL_OVER_MS)
        {
            self.stalled_since = None;
            self.alerts.rectify(now, Alert::Stalled);
        }
        self.look(now);
        self.supervise(now);
        let before = self.order;
        self.steered = None;
        match (self.demand(now), self.measured(now)) {
            (Some(demand), Some(measured)) => {
                let autonav = self.mode.is_autonav();
                let limit = if autonav {
                    self.settings.rudder_max
                } else {
                    self.settings.rudder_limit
                };
                let dt = self.step_ms() as f64 / 1000.0;
                let steered =
                    self.steering
                        .step(&measured, &demand, RudderAngle::from_deg(limit), dt);
                self.order = steered.order;
                self.steered = Some(steered);
            }
            _ => self.order = before, // FA7: frozen
        }
        self.watch_rudder(now);
        self.watch_heading(now);
        self.send_order(out);
    }

    /// What the mode asks of the steering; absent where no orders are computed.
    fn demand(&mut self, now: Stamp) -> Option<Demand> {
        let own = if self.settings.steering_by == SteeringBy::Radius {
            TurnBy::Radius(crate::units::Radius::from_nm(self.settings.set_radius))
        } else {
            TurnBy::Rate(RateOfTurn::from_deg_per_min(self.settings.set_rate))
        };
        match &mut self.mode {
            Mode::Standby | Mode::RudderHold { .. } => None,
            Mode::Auto { set, finish } => {
                if let Some(Finish {
                    by,
                    wait: Some(path),
                }) = *finish
                {
                    let before_arc = self
                        .position_guard
                        .long_dead_reckoning(now)
                        .is_some_and(|point| path.progress(point).part == Part::LegIn);
                    if before_arc {
                        let set = path.course_in.as_heading();
                        return Some(Demand::Heading {
                            set,
                            by: TurnBy::Free,
                        });
                    }
                    *finish = Some(Finish { by, wait: None });
                }
                Some(Demand::Heading {
                    set: *set,
                    by: finish.map_or(own, |finish| finish.by),
                })
            }
            Mode::AutonavTn { hts, rate, .. } => Some(Demand::Heading {
                set: *hts,
                by: rate.map_or(TurnBy::Free, TurnBy::Rate),
            }),
            Mode::AutonavTi { path, .. } => Some(Demand::Track(*path)),
        }
    }

    /// Takes a transition; the order does not jump (FA6).
    fn apply(&mut self, now: Stamp, event: &Event, why: &str) {
        let ship = self.ship(now);
        let before = self.mode.name();
        let mode = core::mem::replace(&mut self.mode, Mode::Standby);
        self.mode = mode.next(event, &ship);
        self.why = why.to_string();
        // While orders are given the steering joins one law to the next by itself; else it begins anew.
        let idle = |name| matches!(name, ModeName::Standby | ModeName::RudderHold);
        if idle(before) && !idle(self.mode.name()) {
            if before == ModeName::Standby {
                // The gear stands where the hand left it.
                let response = self.fresh(self.post.picture.rudder.as_ref(), Quantity::Rudder);
                self.order = response.unwrap_or(self.order);
            }
            if let Some(measured) = self.measured(now) {
                self.steering.engage(self.order, &measured);
            }
        }
    }

    fn ship(&self, now: Stamp) -> Ship {
        let before_arc = match (&self.mode, self.position_guard.long_dead_reckoning(now)) {
            (Mode::AutonavTi { path, .. }, Some(point)) => path.progress(point).part == Part::LegIn,
            _ => false,
        };
        Ship {
            heading: self
                .heading
                .or_else(|| self.post.picture.heading(now).map(|heard| heard.value))
                .unwrap_or(Heading::from_deg(0.0)),
            hts: self.hts(),
            order: self.order,
            before_arc,
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

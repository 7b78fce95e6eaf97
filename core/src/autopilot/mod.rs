//! The autopilot station: bytes, commands and time in; rudder orders, reports and alerts out.
//!
//! Every control step (10 Hz, AP-15): picture -> supervision -> mode -> steering -> order. Everything
//! the step uses is at most as old as [`crate::limits`] allows.
//!
//! **Invariant:** orders leave only in a mode that gives them, within limit and slew, and the operator's
//! STANDBY is always granted.

mod entry;
mod follow;
mod guard;
mod modes;
mod report;
pub mod steering;

use crate::alerts::{Alert, Alerts};
use crate::limits::Quantity;
use crate::nmea::{self, Framer};
use crate::picture::{Heard, Picture};
use crate::settings::Settings;
use crate::station::{Direction, Input, Output, PortIndex, PortSetup, Profile, Refusal};
use crate::stream::{Do, ModeRequest, Own, Pending};
use crate::time::Stamp;
use crate::units::{Heading, RateOfTurn, RudderAngle, Turn};
use alloc::collections::VecDeque;
use alloc::format;
use alloc::string::{String, ToString};
use alloc::vec::Vec;
use guard::{HeadingGuard, HeadingVerdict, PositionGuard};
use modes::{Event, Ship};
pub use modes::{Finish, Mode};
use serde::{Deserialize, Serialize};
use steering::{Demand, Measured, Steered, Steering, SteeringSettings, TurnBy};

/// A selection of AutoNAV that waits for the chart system (AP-6).
pub const CONFIRM_MS: u64 = 20_000;

/// The autopilot.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct Autopilot {
    picture: Picture,
    framers: Vec<Framer>,
    alerts: Alerts,
    settings: Settings,
    steering: Steering,
    mode: Mode,
    /// Until when the operator's AutoNAV selection stands.
    pending: Option<Stamp>,
    why: String,
    order: RudderAngle,
    steered: Option<Steered>,
    heading: Option<Heading>,
    rate: RateOfTurn,
    heading_guard: HeadingGuard,
    position_guard: PositionGuard,
    last_fix: Option<Stamp>,
    /// Times of the valid HTC in a row that command H or T (FA14).
    commands: VecDeque<Stamp>,
    /// When an HTC was last followed (TCS-8).
    followed: Stamp,
    /// Until when a stop by the chart system may still turn out to be the end of the route (TCS-10).
    stop_cause_until: Option<Stamp>,
    off_heading_since: Option<Stamp>,
    rudder_error_since: Option<Stamp>,
    /// Nothing heard before counts (FA16).
    fresh_after: Option<Stamp>,
    /// Alert reports that wait for their share of the line (AP-11).
    reports: VecDeque<Alert>,
    now: Stamp,
    next_step: Stamp,
    next_second: Stamp,
}

impl Autopilot {
    /// An autopilot in STANDBY with these ports.
    #[must_use]
    pub fn new(
        ports: Vec<PortSetup>,
        settings: Settings,
        ship: SteeringSettings,
        now: Stamp,
    ) -> Self {
        let framers = ports.iter().map(|_| Framer::new()).collect();
        let mut ship = ship;
        ship.slew = settings.rudder_slew;
        ship.rudder_max = RudderAngle::from_deg(settings.rudder_max);
        Self {
            picture: Picture::new(ports),
            framers,
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
            heading_guard: HeadingGuard::default(),
            position_guard: PositionGuard::default(),
            last_fix: None,
            commands: VecDeque::new(),
            followed: now,
            stop_cause_until: None,
            off_heading_since: None,
            rudder_error_since: None,
            fresh_after: None,
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
        self.advance(now, out);
        match input {
            Input::Bytes { port, bytes } => self.hear(now, port, bytes, out),
            Input::Stalled { ms } => {
                // FA16: no burst; every input must be heard again.
                self.fresh_after = Some(now);
                self.next_step = now + self.step_ms();
                self.next_second = self.next_second.max(now);
                self.alerts.raise(
                    now,
                    Alert::Stalled,
                    &format!("the control loop was {ms} ms late"),
                );
            }
            Input::Tick => {}
        }
    }

    /// Does what an operator asks, or says why not.
    ///
    /// # Errors
    /// The reason an officer would give.
    pub fn command(&mut self, now: Stamp, action: &Do) -> Result<String, Refusal> {
        let result = match action {
            Do::Mode(ModeRequest::Standby) => {
                self.pending = None;
                self.alerts.rectify(now, Alert::HeadingLost);
                self.alerts.rectify(now, Alert::Override);
                self.apply(now, &Event::Standby, "operator selected STANDBY");
                Ok("STANDBY".into())
            }
            Do::Mode(ModeRequest::Auto) => self.select_auto(now),
            Do::Mode(ModeRequest::Autonav) => self.request_autonav(now),
            Do::Mode(ModeRequest::Cancel) => {
                self.pending = None;
                Ok("AutoNAV selection withdrawn".into())
            }
            Do::Mode(ModeRequest::Track) => {
                Err(Refusal("TRACK needs valid APB: none is heard".into()))
            }
            Do::SetHeading(degrees) => self.set_heading(now, Heading::from_deg(*degrees)),
            Do::AdjustHeading(degrees) => match &self.mode {
                Mode::Auto { set, .. } => {
                    let set = *set + Turn::from_deg(*degrees);
                    self.set_heading(now, set)
                }
                _ => Err(Refusal("the heading is set in AUTO only".into())),
            },
            Do::Acknowledge(number) if self.alerts.acknowledge(now, *number) => {
                Ok(format!("alert {number} acknowledged"))
            }
            Do::Acknowledge(number) => Err(Refusal(format!(
                "alert {number} waits for no acknowledgement"
            ))),
            Do::Silence(_) => {
                self.alerts.silence(now);
                Ok("silenced for 30 s".into())
            }
            Do::Setting { key, value } => {
                self.settings.set(key, *value).map_err(Refusal)?;
                let ship = self.steering.settings_mut();
                ship.slew = self.settings.rudder_slew;
                ship.rudder_max = RudderAngle::from_deg(self.settings.rudder_max);
                Ok(format!("{key} is {value}"))
            }
            _ => Err(Refusal("not a command to the autopilot".into())),
        };
        if let Err(refusal) = &result {
            self.why = refusal.0.clone();
        }
        result
    }

    fn select_auto(&mut self, now: Stamp) -> Result<String, Refusal> {
        let Some(heading) = self.heading else {
            return Err(Refusal("no heading".into()));
        };
        if self.override_heard(now) {
            return Err(Refusal("override is in use".into()));
        }
        self.pending = None;
        self.alerts.rectify(now, Alert::HeadingLost);
        self.alerts.rectify(now, Alert::TrackFail);
        self.alerts.rectify(now, Alert::Override);
        self.apply(now, &Event::Auto, "operator selected AUTO");
        Ok(format!("AUTO on {:05.1}", heading.deg()))
    }

    fn set_heading(&mut self, now: Stamp, set: Heading) -> Result<String, Refusal> {
        if !matches!(self.mode, Mode::Auto { .. }) {
            return Err(Refusal("the heading is set in AUTO only".into()));
        }
        self.off_heading_since = None;
        self.apply(now, &Event::SetHeading(set), "operator set the heading");
        Ok(format!("set heading {:05.1}", set.deg()))
    }

    fn hear(&mut self, now: Stamp, port: PortIndex, bytes: &[u8], out: &mut Vec<Output>) {
        let Some(mut framer) = self.framers.get_mut(port).map(core::mem::take) else {
            return;
        };
        framer.push(bytes, &mut |frame| {
            let sentence = nmea::decode(frame.text);
            let accepted = self
                .picture
                .fold_sentence(now, port, Direction::In, &sentence);
            out.push(Output::Line {
                port,
                dir: Direction::In,
                text: frame.text.to_vec(),
            });
            if accepted && self.picture.ports[port].profile == Profile::Ecdis {
                match sentence.formatter {
                    "HTC" => self.on_htc(now),
                    "ACK" => {
                        let number = nmea::Ack::from_sentence(&sentence).and_then(|ack| ack.number);
                        if let Some(number) = number {
                            self.alerts.acknowledge(now, number as u16);
                        }
                    }
                    _ => {}
                }
            }
        });
        self.framers[port] = framer;
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
        self.alerts.tick(now);
        self.read_sensors(now);
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

    /// A heard value that is fresh and was heard since the last stall.
    fn fresh<T: Clone>(&self, heard: Option<&Heard<T>>, quantity: Quantity) -> Option<T> {
        let heard = heard?;
        if self.fresh_after.is_some_and(|after| heard.at <= after) {
            return None;
        }
        heard.usable(quantity, self.now).cloned()
    }

    fn read_sensors(&mut self, now: Stamp) {
        let rate = self.fresh(self.picture.rate(now), Quantity::RateOfTurn);
        let read = self.fresh(self.picture.heading(now), Quantity::Heading);
        let sensed = rate.unwrap_or_default();
        let judged = read.map(|read| {
            self.heading_guard
                .judge(now, read, sensed, self.settings.heading_jump)
        });
        let before = self.heading;
        self.heading = match judged {
            Some(HeadingVerdict::Good(heading) | HeadingVerdict::Bridged(heading)) => Some(heading),
            Some(HeadingVerdict::Invalid) | None => None,
        };
        if read.is_none() {
            self.heading_guard.reset();
        }
        let jumped = matches!(
            judged,
            Some(HeadingVerdict::Bridged(_) | HeadingVerdict::Invalid)
        );
        self.alerts.set(now, Alert::HeadingJump, jumped, "");
        self.rate =
            rate.unwrap_or_else(|| derived_rate(before, self.heading, self.rate, self.step_ms()));
        if self.heading.is_none()
            && self.mode != Mode::Standby
            && !matches!(self.mode, Mode::RudderHold { .. })
        {
            let why = if judged.is_some() {
                "the heading jumped"
            } else {
                "no heading for 2 s"
            };
            self.alerts.raise(now, Alert::HeadingLost, "");
            self.pending = None;
            self.apply(now, &Event::HeadingLost, &format!("{why}: rudder held"));
        }
        self.read_position(now);
    }

    fn read_position(&mut self, now: Stamp) {
        if let Some(ground) = self.fresh(self.picture.ground(now), Quantity::Ground) {
            self.position_guard.ground(ground.course, ground.speed);
        }
        let heard = self.picture.fix(now);
        let new = heard.filter(|fix| self.last_fix.is_none_or(|last| fix.at > last));
        let new = new.map(|fix| (fix.at, fix.value));
        if let Some((at, fix)) = new {
            self.last_fix = Some(at);
            let verdict = self
                .position_guard
                .judge(at, fix.position, self.settings.position_jump);
            self.alerts.set(
                now,
                Alert::PositionJump,
                verdict != guard::FixVerdict::Taken,
                "",
            );
            let engaged = self.mode.is_autonav();
            self.alerts
                .set(now, Alert::NoDifferential, engaged && !fix.corrected, "");
            if verdict == guard::FixVerdict::Jumped && matches!(self.mode, Mode::AutonavTi { .. }) {
                self.track_fail(now, modes::Cause::PositionJump, "the position jumped");
            }
        }
        self.recentre();
        let speed = self
            .fresh(self.picture.ground(now), Quantity::Ground)
            .is_some()
            || self
                .fresh(self.picture.water_speed(now), Quantity::WaterSpeed)
                .is_some();
        self.alerts.set(
            now,
            Alert::SpeedLost,
            !speed && self.mode != Mode::Standby,
            "",
        );
    }

    fn measured(&self, now: Stamp) -> Option<Measured> {
        let ground = self.fresh(self.picture.ground(now), Quantity::Ground);
        let water = self.fresh(self.picture.water_speed(now), Quantity::WaterSpeed);
        let cruise = crate::units::Speed::from_knots(self.settings.cruise_speed);
        let speed = water
            .or(ground.as_ref().map(|ground| ground.speed))
            .unwrap_or(cruise);
        Some(Measured {
            heading: self.heading?,
            rate: self.rate,
            rudder: self.fresh(self.picture.rudder.as_ref(), Quantity::Rudder),
            water_speed: Some(speed),
            ground: ground.and_then(|ground| ground.course.map(|course| (course, ground.speed))),
            position: self.position_guard.fix(now),
        })
    }

    /// What the mode asks of the steering; absent where no orders are computed.
    fn demand(&mut self, now: Stamp) -> Option<Demand> {
        let own = if self.settings.set_by_radius >= 0.5 {
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
                        .is_some_and(|point| path.progress(point).part == steering::Part::LegIn);
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
        if self.mode.name() != before && self.mode.name() != crate::stream::ModeName::Standby {
            if matches!(before, crate::stream::ModeName::Standby) {
                // From STANDBY the gear stands where the hand left it.
                let response = self.fresh(self.picture.rudder.as_ref(), Quantity::Rudder);
                self.order = response.unwrap_or(self.order);
            }
            if let Some(measured) = self.measured(now) {
                self.steering.engage(self.order, &measured);
            }
        }
    }

    fn ship(&self, now: Stamp) -> Ship {
        let before_arc = match (&self.mode, self.position_guard.long_dead_reckoning(now)) {
            (Mode::AutonavTi { path, .. }, Some(point)) => {
                path.progress(point).part == steering::Part::LegIn
            }
            _ => false,
        };
        Ship {
            heading: self
                .heading
                .or_else(|| self.picture.heading(now).map(|heard| heard.value))
                .unwrap_or(Heading::from_deg(0.0)),
            hts: self.hts(),
            order: self.order,
            before_arc,
        }
    }

    /// Heading to steer in force.
    fn hts(&self) -> Option<Heading> {
        match &self.mode {
            Mode::Auto { set, .. } => Some(*set),
            Mode::AutonavTn { hts, .. } => Some(*hts),
            Mode::AutonavTi { path, .. } => Some(
                self.steered
                    .as_ref()
                    .map_or(path.course_in.as_heading(), |steered| steered.hts),
            ),
            Mode::Standby | Mode::RudderHold { .. } => None,
        }
    }

    /// The picture of what is heard and sent.
    #[must_use]
    pub fn picture(&self) -> &Picture {
        &self.picture
    }

    /// Whether an AutoNAV selection waits for its confirmation.
    #[must_use]
    pub const fn pending(&self) -> bool {
        self.pending.is_some()
    }

    /// Its alerts.
    #[must_use]
    pub fn alerts(&self) -> &Alerts {
        &self.alerts
    }

    /// Its settings.
    #[must_use]
    pub fn settings(&self) -> &Settings {
        &self.settings
    }

    /// Its mode.
    #[must_use]
    pub fn mode(&self) -> &Mode {
        &self.mode
    }

    /// Rudder order in force; absent where none is given.
    #[must_use]
    pub fn rudder_order(&self) -> Option<RudderAngle> {
        (self.mode != Mode::Standby).then_some(self.order)
    }

    /// Own facts for the page.
    #[must_use]
    pub fn own(&self, now: Stamp) -> Own {
        let steered = self.steered.as_ref();
        Own {
            mode: self.mode.name(),
            why: self.why.clone(),
            pending: self.pending.map(|until| Pending {
                request: crate::stream::ModeName::AutonavTi,
                until: until.0,
                waits_for: self.waits_for(now),
            }),
            set_heading: match &self.mode {
                Mode::Auto { set, .. } => Some(set.deg()),
                _ => None,
            },
            hts: self.hts().map(Heading::deg),
            set_rate: self.settings.set_rate,
            set_radius: self.settings.set_radius,
            by_radius: self.settings.set_by_radius >= 0.5,
            rudder_limit: if self.mode.is_autonav() {
                self.settings.rudder_max
            } else {
                self.settings.rudder_limit
            },
            rudder_order: self.rudder_order().map(RudderAngle::deg),
            cross_track: steered
                .and_then(|steered| steered.cross_track)
                .map(crate::units::Distance::m),
            sources: self.sources(now),
            terms: steered.map_or([0.0; 4], |steered| steered.terms),
            limited: steered.is_some_and(|steered| steered.limited),
            output: self
                .picture
                .ports
                .iter()
                .any(|port| port.profile == Profile::Gear && port.output),
        }
    }

    fn sources(&self, now: Stamp) -> Vec<(String, String)> {
        let picture = &self.picture;
        let list = [
            ("heading", picture.heading(now).map(|heard| &heard.source)),
            ("rate", picture.rate(now).map(|heard| &heard.source)),
            ("position", picture.fix(now).map(|heard| &heard.source)),
            ("ground", picture.ground(now).map(|heard| &heard.source)),
            ("water", picture.water_speed(now).map(|heard| &heard.source)),
        ];
        list.into_iter()
            .filter_map(|(name, source)| Some((name.to_string(), picture.source_name(source?))))
            .collect()
    }
}

/// Rate of turn from the heading where no sensor gives it, smoothed over about 3 s.
fn derived_rate(
    before: Option<Heading>,
    now: Option<Heading>,
    rate: RateOfTurn,
    step_ms: u64,
) -> RateOfTurn {
    let (Some(before), Some(now)) = (before, now) else {
        return RateOfTurn::default();
    };
    let dt = step_ms as f64 / 1000.0;
    let raw = (now - before).deg() / dt * 60.0;
    let share = dt / 3.0;
    RateOfTurn::from_deg_per_min(rate.deg_per_min() + share * (raw - rate.deg_per_min()))
}

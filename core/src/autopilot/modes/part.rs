//! The part of the autopilot that holds the mode: which it is and why, and what the chart system has said of it.

use super::event::Event;
use super::mode::Mode;
use super::need::Need;
use super::off_heading::OffHeading;
use super::steady_speed::SteadySpeed;
use super::table::ModeName;
use crate::autopilot::facts::{Facts, Outlook};
use crate::autopilot::plotter::Plotter;
use crate::autopilot::remote::{Positions, Remote};
use crate::autopilot::stand::Stand;
use crate::autopilot::steering::Demand;
use crate::geo::Point;
use crate::nmea::{Htd, LimitStatus, OverrideStatus, Reference, Sentence, TurnMode};
use crate::settings::Settings;
use crate::time::Stamp;
use crate::units::{Heading, RudderAngle};
use alloc::string::String;
use serde::{Deserialize, Serialize};

/// Mode, reason, the selection that stands in the mode, and the chart system.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub(in super::super) struct Modes {
    pub(super) mode: Mode,
    pub(super) why: String,
    pub(super) remote: Remote,
    pub(super) positions: Positions,
    pub(super) plotter: Plotter,
    pub(super) stand: Stand,
    /// The operator took the ship from the stand's lever.
    pub(super) over_the_lever: bool,
    pub(super) off_heading: OffHeading,
    pub(super) speed: SteadySpeed,
    /// AutoNAV was refused by a speed entered by hand, until STANDBY and another source (AP-7).
    pub(super) speed_by_hand: bool,
}

impl Modes {
    /// STANDBY.
    pub(in super::super) fn new() -> Self {
        Self {
            mode: Mode::STANDBY,
            why: "start-up".into(),
            remote: Remote::default(),
            positions: Positions::default(),
            plotter: Plotter::default(),
            stand: Stand::default(),
            over_the_lever: false,
            off_heading: OffHeading::default(),
            speed: SteadySpeed::default(),
            speed_by_hand: false,
        }
    }

    /// The mode that is on.
    pub(in super::super) const fn mode(&self) -> &Mode {
        &self.mode
    }

    /// Why it is on: the last refusal or cause, in an officer's words.
    pub(in super::super) fn why(&self) -> &str {
        &self.why
    }

    /// Something was refused.
    pub(in super::super) fn refuse(&mut self, why: &str) {
        self.why = why.into();
    }

    /// Whether the rudder is held, until the operator ends it (FA7).
    pub(in super::super) const fn holds_the_rudder(&self) -> bool {
        matches!(self.mode, Mode::RudderHold(_))
    }

    /// Whether the mode steers by a heading.
    pub(super) fn steers_by_heading(&self) -> bool {
        self.mode.row().needs(Need::Heading)
    }

    /// Whether a measured rate of turn is enough for the mode (AP-21).
    pub(in super::super) fn steers_by_rate(&self) -> bool {
        self.mode.row().needs(Need::HeadingOrRate)
    }

    /// Whether the mode asks for a rudder, by a heading or not.
    pub(in super::super) fn steers(&self) -> bool {
        self.gives_orders() && !self.holds_the_rudder()
    }

    /// The unit of the autopilot that reports (ALA 4: 00 standby, 01 autopilot, 03 installation).
    pub(in super::super) fn unit(&self) -> u32 {
        match self.mode.name() {
            ModeName::Installation => 3,
            _ => u32::from(self.gives_orders()),
        }
    }

    /// Whether the chart system commands.
    pub(in super::super) const fn is_commanded(&self) -> bool {
        self.mode.is_autonav()
    }

    /// Whether the chart system commands, or AutoNAV is selected and waits for it: no speed is entered by hand then (AP-7).
    pub(in super::super) const fn is_or_will_be_commanded(&self) -> bool {
        self.mode.is_autonav() || self.mode.selected_until().is_some()
    }

    /// Whether rudder orders are given.
    pub(in super::super) fn gives_orders(&self) -> bool {
        self.mode.row().gives_orders()
    }

    /// Takes a transition.
    pub(super) fn apply(&mut self, facts: &Facts<'_>, event: &Event, why: &str) {
        self.mode = self.mode.next(event, facts);
        self.why = why.into();
    }

    /// What is asked of the steering; absent where no orders are computed.
    pub(in super::super) fn demand(&mut self, facts: &Facts<'_>) -> Option<Demand> {
        self.mode.state_mut().demand(facts)
    }

    /// Another receiver is in use, and the plane has moved with it, metres.
    pub(in super::super) fn plane_moved(&mut self, by: Point) {
        self.positions.plane_moved(by);
    }

    /// Carries the places of the mode into another plane.
    pub(in super::super) fn carry(&mut self, carry: &dyn Fn(Point) -> Point) {
        self.mode.state_mut().carry(carry);
    }

    /// How far from where the plane touches it may be laid anew, metres; absent while it has to lie.
    pub(in super::super) fn plane_m(&self) -> Option<f64> {
        self.mode.state().plane_m()
    }

    /// How far off the heading to steer she is beyond the limit, degrees, and that heading; absent within it.
    fn off_heading(&self, outlook: &Outlook<'_>) -> Option<(f64, Heading)> {
        let hts = self.mode.state().hts(&outlook.facts)?;
        let off = (outlook.sight.heading()? - hts).abs().deg();
        (off > outlook.facts.settings.off_heading_limit).then_some((off, hts))
    }

    /// AP-5: whether she has been off the heading to steer for too long; in a turn along a path nothing is asked.
    pub(in super::super) fn is_off_heading(&mut self, outlook: &Outlook<'_>) -> bool {
        let turning = self
            .mode
            .state()
            .path()
            .is_some_and(|path| path.turn.is_some());
        let off = self.off_heading(outlook).filter(|_| !turning);
        self.off_heading.watch(outlook.facts.now, off)
    }

    /// Rudder limit in force, degrees; in STANDBY the one that AUTO will have.
    pub(in super::super) const fn limit(&self, settings: &Settings) -> f64 {
        self.mode.row().rudder_limit(settings)
    }

    /// The order in force, absent where none is given.
    pub(in super::super) fn order(&self, order: RudderAngle) -> Option<RudderAngle> {
        self.gives_orders().then_some(order)
    }

    /// The 17 fields of HTD by mode (AP-1, AP-2, AP-3, AP-5).
    pub(in super::super) fn htd(&self, outlook: &Outlook<'_>) -> Htd {
        let facts = &outlook.facts;
        let within = |ok: bool| {
            Some(if ok {
                LimitStatus::Within
            } else {
                LimitStatus::Reached
            })
        };
        let row = self.mode.row();
        let mut htd = Htd {
            override_status: Some(OverrideStatus::NotInUse),
            rudder_angle: self.order(facts.order).map(RudderAngle::deg),
            steering_mode: row.htd,
            reference: Some(if outlook.sight.is_magnetic() {
                Reference::Magnetic
            } else {
                Reference::True
            }),
            rudder_status: within(!facts.steered.is_some_and(|steered| steered.limited)),
            off_heading_status: within(self.off_heading(outlook).is_none()),
            heading: outlook.sight.heading().map(Heading::deg),
            ..Htd::default()
        };
        if row.gives_orders() {
            htd.turn_mode = Some(TurnMode::NotControlled);
        }
        // AP-1: where no orders are given, the maximum rudder angle.
        htd.rudder_limit = Some(match row.gives_orders() {
            true => row.rudder_limit(facts.settings),
            false => facts.settings.rudder_max,
        });
        htd.off_heading_limit = Some(facts.settings.off_heading_limit);
        self.mode.state().htd(facts, &mut htd);
        htd
    }

    /// The chart system's sentences other than HTC: what spoils them is kept for the officer.
    pub(in super::super) fn on_distance(
        &mut self,
        outlook: &Outlook<'_>,
        sentence: &Sentence<'_>,
        checked: bool,
    ) {
        self.remote.on_distance(outlook.seen, sentence, checked);
    }

    /// An HTC that the port's policy does not accept breaks the row (FA14, SEN-2).
    pub(in super::super) fn on_broken_htc(&mut self, now: Stamp) {
        self.remote.htc.disprove();
        let why = "HTC refused: checksum missing or wrong";
        self.remote.htc.refuse(now, why.into());
    }
}

//! What the autopilot says: HTD, RSA, ROR and HDT each second, ALR on change, orders to the gear.

use super::gear::{self, Follows};
use super::{Autopilot, Mode, Timer};
use crate::alerts::{Alert, State};
use crate::limits::Quantity;
use crate::nmea::{
    AcknowledgeState, AlarmCondition, Alr, Hdt, Htd, LimitStatus, OverrideStatus, Reference, Rsa,
    TurnMode,
};
use crate::path::Part;
use crate::station::{Output, PortIndex, Profile, Role};
use crate::talk::{self, Row, Saying, When};
use crate::time::Stamp;
use crate::units::{Heading, RudderAngle};
use alloc::string::String;
use alloc::vec::Vec;

/// Off the set heading for so long before the alert, which a turn would else raise.
const OFF_HEADING_MS: u64 = 60_000;
/// A turn brings her nearer by at least so much, degrees.
const NEARER_DEG: f64 = 1.0;

impl Autopilot {
    /// What is due on each port, by the table: once a second, or in a control step.
    pub(super) fn report(&mut self, now: Stamp, due: When, out: &mut Vec<Output>) {
        for port in 0..self.post.picture.ports.len() {
            let profile = self.post.picture.ports[port].profile;
            let rows = talk::told(Role::Autopilot, profile).iter();
            for row in rows.filter(|row| row.when == due) {
                if let Some(line) = self.line(now, row) {
                    self.post.say(now, port, &line, out);
                }
            }
        }
    }

    /// A sentence as it is now; absent where there is nothing to say, and what is not an autopilot's to say.
    fn line(&self, now: Stamp, row: &Row) -> Option<String> {
        Some(match (row.saying, row.talker) {
            (Saying::Htd, Some(talker)) => self.htd().line(talker),
            (Saying::Rsa, Some(talker)) => self.rsa().line(talker),
            (Saying::Ror, Some(talker)) => gear::ror(self.rudder_order()).line(talker),
            // AP-12: the heading goes on with its source's talker.
            (Saying::Hdt, None) => {
                let source = &self.post.picture.heading(now)?.source;
                let heading = Some(self.heading?.deg());
                Hdt { heading }.line(&source.talker)
            }
            _ => return None,
        })
    }

    /// Reports of alerts, within their share of the line (AP-11); where they are told to several, of the slowest.
    pub(super) fn report_alerts(&mut self, now: Stamp, out: &mut Vec<Output>) {
        for alert in self.alerts.take_changed() {
            self.reports.retain(|waiting| *waiting != alert);
            self.reports.push_front(alert);
        }
        let ports = self.post.ports().iter().enumerate();
        let told: Vec<(PortIndex, u32, &Row)> = ports
            .filter(|(_, port)| port.output)
            .filter_map(|(index, port)| {
                let rows = talk::told(Role::Autopilot, port.profile);
                let row = rows.iter().find(|row| row.saying == Saying::Alr)?;
                Some((index, port.baud, row))
            })
            .collect();
        let Some(&(_, baud, row)) = told
            .iter()
            .min_by_key(|(_, baud, _)| talk::alert_share(*baud))
        else {
            self.reports.clear(); // there is nobody to tell
            return;
        };
        while let Some(alert) = self.reports.front().copied() {
            let line = self.alr(alert).line(row.talker.unwrap_or_default());
            if !self.share.take(now, self.step_ms(), baud, &line) {
                return;
            }
            self.reports.pop_front();
            for (port, ..) in &told {
                self.post.say(now, *port, &line, out);
            }
        }
    }

    fn alr(&self, alert: Alert) -> Alr {
        let state = self.alerts.state(alert);
        let raised = self.alerts.raised(alert);
        let taken = matches!(
            state,
            State::Acknowledged | State::Transferred | State::Normal
        );
        Alr {
            number: Some(u32::from(alert.number())),
            condition: Some(if raised {
                AlarmCondition::Raised
            } else {
                AlarmCondition::NotRaised
            }),
            acknowledged: Some(if taken {
                AcknowledgeState::Acknowledged
            } else {
                AcknowledgeState::NotAcknowledged
            }),
            ..Alr::default()
        }
    }

    fn rsa(&self) -> Rsa {
        let failed = self.alerts.raised(Alert::Rudder);
        let response = self.fresh(self.post.picture.rudder.as_ref(), Quantity::Rudder);
        gear::rsa(response, !failed)
    }

    /// The 17 fields by mode (AP-1, AP-2, AP-3, AP-5).
    fn htd(&self) -> Htd {
        let steered = self.gear.steered();
        let limited = steered.is_some_and(|steered| steered.limited);
        let within = |ok: bool| {
            Some(if ok {
                LimitStatus::Within
            } else {
                LimitStatus::Reached
            })
        };
        let mut htd = Htd {
            override_status: Some(OverrideStatus::NotInUse),
            rudder_angle: self.rudder_order().map(RudderAngle::deg),
            reference: Some(Reference::True),
            rudder_status: within(!limited),
            off_heading_status: within(self.off_heading().is_none()),
            heading: self.heading.map(Heading::deg),
            ..Htd::default()
        };
        let row = self.mode.row();
        htd.steering_mode = Some(row.htd);
        if row.gives_orders() {
            htd.turn_mode = Some(TurnMode::NotControlled);
            htd.rudder_limit = Some(row.rudder_limit(&self.settings));
            htd.off_heading_limit = Some(self.settings.off_heading_limit);
            self.mode.htd(&self.facts(self.now), &mut htd);
        }
        htd
    }

    /// How far off the heading to steer she is beyond the limit, degrees, and that heading; absent within it.
    fn off_heading(&self) -> Option<(f64, Heading)> {
        let (hts, heading) = (self.hts()?, self.heading?);
        let off = (heading - hts).abs().deg();
        (off > self.settings.off_heading_limit).then_some((off, hts))
    }

    /// AP-5: the alert waits while a turn brings her nearer; one that goes round and round does not.
    pub(super) fn watch_heading(&mut self, now: Stamp) {
        let turning = matches!(&self.mode, Mode::AutonavTi(ti) if ti.path.turn.is_some());
        let off = self.off_heading().filter(|_| !turning);
        let stays_off = |(off, hts): (f64, Heading)| {
            self.nearest.is_some_and(|(nearest, before)| {
                off > nearest - NEARER_DEG && (hts - before).abs().deg() <= NEARER_DEG
            })
        };
        if !off.is_some_and(stays_off) {
            self.timers.stop(Timer::OffHeading);
            self.nearest = off;
        }
        let since = self.timers.begin(Timer::OffHeading, now);
        let condition = off.is_some() && now.since(since) >= OFF_HEADING_MS;
        self.alerts.set(now, Alert::OffHeading, condition, "");
    }

    /// FA11, AP-4: no feedback, or feedback that does not follow.
    pub(super) fn watch_rudder(&mut self, now: Stamp) {
        let response = self.fresh(self.post.picture.rudder.as_ref(), Quantity::Rudder);
        let has_gear = self
            .post
            .picture
            .ports
            .iter()
            .any(|port| port.profile == Profile::Gear && port.output);
        let order = self.rudder_order().filter(|_| has_gear);
        match (self.gear).watch(now, order, response, self.settings.rudder_slew) {
            Follows::Yes => self.alerts.rectify(now, Alert::Rudder),
            Follows::NotYet => {}
            Follows::No(why) => self.alerts.raise(now, Alert::Rudder, why),
        }
    }

    /// Where the ship is on the commanded path.
    #[must_use]
    pub fn part(&self, now: Stamp) -> Option<Part> {
        match &self.mode {
            Mode::AutonavTi(ti) => Some(
                ti.path
                    .progress(self.position_guard.dead_reckoning(now)?)
                    .part,
            ),
            _ => None,
        }
    }
}

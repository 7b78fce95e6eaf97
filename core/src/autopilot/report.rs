//! What the autopilot says: HTD, RSA, ROR and HDT each second, ALR on change, orders to the gear.

use super::gear::{self, Follows};
use super::{Autopilot, Mode, Timer};
use crate::alerts::Alert;
use crate::limits::Quantity;
use crate::nmea::{Hdt, Htd, LimitStatus, OverrideStatus, Reference, Rsa, TurnMode};
use crate::path::Part;
use crate::station::{Output, Profile, Role};
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
                if let Some(line) = self.line(row) {
                    self.post.say(now, port, &line, out);
                }
            }
        }
    }

    /// HMS: each 30 s, and when what is set has changed (AP-10).
    pub(super) fn report_monitor(&mut self, now: Stamp, out: &mut Vec<Output>) {
        if self.sight.hms_is_due(now, talk::HMS_MS) {
            self.report(now, When::Renewed(talk::HMS_MS), out);
        }
    }

    /// A sentence as it is now; absent where there is nothing to say, and what is not an autopilot's to say.
    fn line(&self, row: &Row) -> Option<String> {
        Some(match (row.saying, row.talker) {
            (Saying::Htd, Some(talker)) => self.htd().line(talker),
            (Saying::Rsa, Some(talker)) => self.rsa().line(talker),
            (Saying::Ror, Some(talker)) => gear::ror(self.rudder_order()).line(talker),
            (Saying::Hms, Some(talker)) => self.sight.monitor().hms().line(talker),
            (Saying::Hmr, Some(talker)) => self.sight.monitor().hmr().line(talker),
            // AP-12: the heading goes on with its source's talker.
            (Saying::Hdt, None) => {
                if self.sight.is_magnetic() {
                    return None; // AP-10
                }
                let source = self.sight.compass()?;
                let heading = Some(self.sight.heading()?.deg());
                Hdt { heading }.line(&source.talker)
            }
            _ => return None,
        })
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
            reference: Some(if self.sight.is_magnetic() {
                Reference::Magnetic
            } else {
                Reference::True
            }),
            rudder_status: within(!limited),
            off_heading_status: within(self.off_heading().is_none()),
            heading: self.sight.heading().map(Heading::deg),
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
        let (hts, heading) = (self.hts()?, self.sight.heading()?);
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
        self.alerts
            .machine
            .set(now, Alert::OffHeading, condition, "");
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
            Follows::Yes => self.alerts.machine.rectify(now, Alert::Rudder),
            Follows::NotYet => {}
            Follows::No(why) => self.alerts.machine.raise(now, Alert::Rudder, why),
        }
    }

    /// Where the ship is on the commanded path.
    #[must_use]
    pub fn part(&self, now: Stamp) -> Option<Part> {
        match &self.mode {
            Mode::AutonavTi(ti) => Some(ti.path.progress(self.sight.place(now)?).part),
            _ => None,
        }
    }
}

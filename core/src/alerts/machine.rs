//! The state machine of one station's alerts (IEC 62923-1, MSC.302(87) 7.3; FA15).
//!
//! In: conditions, acknowledgements, commands of other systems, time. Out: states, what has changed, the history.
//!
//! **Invariant:** an alarm or a warning whose condition has ended without an answer stays until it has one; a caution
//! waits for nobody.

use super::elsewhere::{CommandRefused, Elsewhere};
use super::history::{History, Past};
use super::standing::{Standing, State};
use super::table::{Alert, Category, Priority};
use crate::nmea::AlertCommand;
use crate::time::Stamp;
use alloc::string::{String, ToString};
use alloc::vec::Vec;
use serde::{Deserialize, Serialize};

/// How long a silenced alert stays silent (MSC.302(87) 7.3.5).
pub const SILENCE_MS: u64 = 30_000;
/// An alarm that nobody has taken for so long calls the back-up navigator (MSC.74(69) A2 5.3.4).
pub const UNANSWERED_MS: u64 = 30_000;
/// A warning that nobody has taken is repeated after so long (IEC 62923-1: at most 5 min).
pub const REPEAT_MS: u64 = 300_000;
/// The escalation counter goes on with 1 behind it (IEC 61162-1 ALF).
const ESCALATION_MOST: u8 = 9;
/// The revision counter goes on with 1 behind it (IEC 61162-1 ALF).
const REVISION_MOST: u8 = 99;

/// The alerts of one station.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Alerts {
    active: Vec<Standing>,
    /// Raised, taken or gone since it was last asked: for ALR, which tells no more.
    changed: Vec<Alert>,
    /// Changed in any way since it was last asked: for ALF.
    revised: Vec<Alert>,
    /// How often each has changed: 1 to 99 and again from 1.
    revisions: Vec<(Alert, u8)>,
    history: History,
    /// The contact of the back-up navigator is closed.
    calls: bool,
}

impl Alerts {
    /// Raises an alert, or gives a raised one a new detail. Nothing else changes while it lasts.
    pub fn raise(&mut self, now: Stamp, alert: Alert, detail: &str) {
        match self.active.iter_mut().find(|active| active.alert == alert) {
            Some(active) if active.state != State::RectifiedUnacknowledged => {
                if active.detail != detail {
                    active.detail = detail.to_string();
                }
                return;
            }
            Some(active) => *active = Standing::new(now, alert, detail),
            None => {
                self.active.push(Standing::new(now, alert, detail));
                self.active
                    .sort_by_key(|active| (active.alert.definition().priority, active.alert));
            }
        }
        self.history.raised(now, alert, detail);
        self.note(alert);
    }

    /// Gives a raised alert a better text.
    pub fn retext(&mut self, alert: Alert, detail: &str) {
        if let Some(active) = self.active.iter_mut().find(|active| active.alert == alert) {
            active.detail = detail.to_string();
            self.history.retext(alert, detail);
            self.revise(alert);
        }
    }

    /// Raises or rectifies an alert as `condition` says.
    pub fn set(&mut self, now: Stamp, alert: Alert, condition: bool, detail: &str) {
        if condition {
            self.raise(now, alert, detail);
        } else {
            self.rectify(now, alert);
        }
    }

    /// Raises an alert with what happened, or rectifies it where nothing did.
    pub fn tell(&mut self, now: Stamp, alert: Alert, happened: Option<String>) {
        match happened {
            Some(detail) => self.raise(now, alert, &detail),
            None => self.rectify(now, alert),
        }
    }

    /// The same, and what happens now is said anew wherever it changes, as of an alert that several ports share.
    pub fn tell_anew(&mut self, now: Stamp, alert: Alert, happened: Option<String>) {
        if let (Some(detail), true) = (&happened, self.raised(alert)) {
            let says = |active: &Standing| active.detail == *detail;
            if !self.standing_of(alert).is_some_and(says) {
                self.retext(alert, detail);
            }
        }
        self.tell(now, alert, happened);
    }

    /// The condition is over: gone if it was taken, else kept until it is.
    pub fn rectify(&mut self, now: Stamp, alert: Alert) {
        let Some(index) = self.place(alert) else {
            return;
        };
        match self.active[index].state {
            State::Unacknowledged | State::Silenced => {
                self.active[index].state = State::RectifiedUnacknowledged;
                self.active[index].at = now;
            }
            State::Acknowledged | State::Transferred => {
                self.active.remove(index);
            }
            State::RectifiedUnacknowledged | State::Normal => return,
        }
        self.history.back(now, alert);
        self.note(alert);
    }

    /// Another alert takes its place, or what it called for has come: gone without an answer (IEC 62923-1 6.3.7.1).
    pub fn end(&mut self, now: Stamp, alert: Alert) {
        if let Some(index) = self.place(alert) {
            self.active.remove(index);
            self.history.back(now, alert);
            self.note(alert);
        }
    }

    /// Acknowledges by number, at the station itself, whose page shows the reason. False where there is nothing to acknowledge.
    pub fn acknowledge(&mut self, now: Stamp, number: u16) -> bool {
        let alert = Alert::of_number(number);
        let Some((alert, index)) = alert.and_then(|alert| Some((alert, self.place(alert)?))) else {
            return false;
        };
        let active = &mut self.active[index];
        match active.state {
            // A caution is shown as acknowledged, and so it stays.
            State::Unacknowledged | State::Silenced | State::Transferred => {
                active.state = State::Acknowledged;
                active.at = now;
            }
            State::RectifiedUnacknowledged => {
                self.active.remove(index);
            }
            State::Acknowledged | State::Normal => return false,
        }
        self.history.acknowledged(now, alert);
        self.note(alert);
        true
    }

    /// Does what another system asks of an alert (ACN, ACK).
    ///
    /// # Errors
    /// It may not ask that, or there is nothing to do.
    pub(crate) fn obey(
        &mut self,
        now: Stamp,
        alert: Alert,
        command: AlertCommand,
        by: Elsewhere,
    ) -> Result<(), CommandRefused> {
        let index = self.place(alert).ok_or(CommandRefused::NotWaiting)?;
        let waits = self.active[index].waits();
        match command {
            // Who hears it tells it again.
            AlertCommand::Request => {}
            AlertCommand::Acknowledge => {
                if alert.definition().category == Category::A && !by.shows_reason {
                    return Err(CommandRefused::ReasonNotShown);
                }
                if !self.acknowledge(now, alert.number()) {
                    return Err(CommandRefused::NotWaiting);
                }
            }
            AlertCommand::Silence if waits => self.silence_at(now, index),
            AlertCommand::Transfer if waits && !by.alive => {
                return Err(CommandRefused::NoHeartbeat);
            }
            AlertCommand::Transfer if waits && alert.definition().category == Category::A => {
                return Err(CommandRefused::ReasonNotShown);
            }
            AlertCommand::Transfer if waits => {
                self.active[index].state = State::Transferred;
                self.active[index].at = now;
                self.note(alert);
            }
            AlertCommand::Silence | AlertCommand::Transfer => {
                return Err(CommandRefused::NotWaiting);
            }
        }
        Ok(())
    }

    /// Who answered for others is not heard any more: what was transferred waits again.
    pub(crate) fn take_back(&mut self, now: Stamp) {
        for index in 0..self.active.len() {
            let active = &mut self.active[index];
            if active.state == State::Transferred {
                active.state = State::Unacknowledged;
                active.at = now;
                active.unanswered = now;
                let alert = active.alert;
                self.note(alert);
            }
        }
    }

    /// Silences everything that sounds, for 30 s.
    pub fn silence(&mut self, now: Stamp) {
        for index in 0..self.active.len() {
            self.silence_at(now, index);
        }
    }

    fn silence_at(&mut self, now: Stamp, index: usize) {
        let active = &mut self.active[index];
        if active.state == State::Unacknowledged {
            active.state = State::Silenced;
            active.silent_until = now + SILENCE_MS;
            let alert = active.alert;
            self.revise(alert);
        }
    }

    /// Lets everything that was silenced sound again at once.
    pub fn sound_again(&mut self) {
        self.sound_where(|_| true);
    }

    fn sound_where(&mut self, again: impl Fn(&Standing) -> bool) {
        for index in 0..self.active.len() {
            let active = &mut self.active[index];
            if active.state == State::Silenced && again(active) {
                active.state = State::Unacknowledged;
                let alert = active.alert;
                self.revise(alert);
            }
        }
    }

    /// What time alone does: what was silenced sounds again after 30 s (FA15), what nobody takes escalates.
    pub fn tick(&mut self, now: Stamp) {
        self.sound_where(|active| now >= active.silent_until);
        for index in 0..self.active.len() {
            let active = &mut self.active[index];
            if !active.waits() || active.alert.calls_backup() {
                continue;
            }
            let due = now.since(active.unanswered);
            match active.alert.definition().priority {
                // Once: then the back-up navigator is called.
                Priority::Alarm if active.escalation == 0 && due >= UNANSWERED_MS => {
                    active.escalation = 1;
                }
                // It is repeated: it sounds again, and its time begins anew.
                Priority::Warning if due >= REPEAT_MS => {
                    active.escalation = active.escalation % ESCALATION_MOST + 1;
                    active.unanswered = now;
                    active.state = State::Unacknowledged;
                }
                _ => continue,
            }
            let alert = active.alert;
            self.revise(alert);
        }
    }

    /// Calls the back-up navigator by the alert `call` while an alarm is left without an answer for 30 s (FA15). Gives
    /// whether the contact is to be closed, where that changes: it is while nobody has answered the call.
    pub(crate) fn call_backup(&mut self, now: Stamp, call: Alert) -> Option<bool> {
        let left = |active: &Standing| {
            let alarm = active.alert.definition().priority == Priority::Alarm;
            alarm && active.waits() && active.escalation > 0
        };
        if self.active.iter().any(left) {
            self.raise(now, call, "");
        } else {
            self.end(now, call);
        }
        let calls = self.standing_of(call).is_some_and(Standing::waits);
        let changed = calls != self.calls;
        self.calls = calls;
        changed.then_some(calls)
    }

    /// State of an alert.
    #[must_use]
    pub fn state(&self, alert: Alert) -> State {
        self.standing_of(alert)
            .map_or(State::Normal, |active| active.state)
    }

    /// Whether the alert's condition holds.
    #[must_use]
    pub fn raised(&self, alert: Alert) -> bool {
        !matches!(
            self.state(alert),
            State::Normal | State::RectifiedUnacknowledged
        )
    }

    /// When the alert last changed.
    #[must_use]
    pub fn changed_at(&self, alert: Alert) -> Option<Stamp> {
        self.standing_of(alert).map(|active| active.at)
    }

    /// The alert, where it is not normal.
    #[must_use]
    pub fn standing_of(&self, alert: Alert) -> Option<&Standing> {
        self.active.iter().find(|active| active.alert == alert)
    }

    /// How often it has changed: 1 to 99 and again from 1; 1 where it never did.
    #[must_use]
    pub fn revision(&self, alert: Alert) -> u8 {
        let found = self.revisions.iter().find(|(of, _)| *of == alert);
        found.map_or(1, |(_, revision)| *revision)
    }

    /// Alerts that were raised, taken or ended since the last call, for ALR.
    pub fn take_changed(&mut self) -> Vec<Alert> {
        core::mem::take(&mut self.changed)
    }

    /// Alerts that changed in any way since the last call, for ALF.
    pub fn take_revised(&mut self) -> Vec<Alert> {
        core::mem::take(&mut self.revised)
    }

    /// All alerts that are not normal, highest first.
    #[must_use]
    pub fn standing(&self) -> &[Standing] {
        &self.active
    }

    /// The newest alerts with the times at which they came, were taken and went, the newest first.
    pub fn history(&self) -> impl Iterator<Item = &Past> {
        self.history.iter().rev()
    }

    fn place(&self, alert: Alert) -> Option<usize> {
        self.active.iter().position(|active| active.alert == alert)
    }

    /// It was raised, taken or has ended.
    fn note(&mut self, alert: Alert) {
        if !self.changed.contains(&alert) {
            self.changed.push(alert);
        }
        self.revise(alert);
    }

    /// It has changed.
    fn revise(&mut self, alert: Alert) {
        match self.revisions.iter_mut().find(|(of, _)| *of == alert) {
            Some((_, revision)) => *revision = *revision % REVISION_MOST + 1,
            None => self.revisions.push((alert, 1)),
        }
        if !self.revised.contains(&alert) {
            self.revised.push(alert);
        }
    }
}

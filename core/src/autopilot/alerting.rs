//! The autopilot's alerts: the machine that keeps them, and their reports on the line (AP-11, FA15).

use super::notices::Notice;
use crate::alerts::{Alert, Alerts, State};
use crate::nmea::{Ack, AcknowledgeState, AlarmCondition, Alr, Sentence};
use crate::post::Post;
use crate::station::{Output, PortIndex, Role};
use crate::talk::{self, Row, Saying, Share};
use crate::time::Stamp;
use alloc::collections::VecDeque;
use alloc::vec::Vec;
use serde::{Deserialize, Serialize};

/// Alerts, and the reports that wait for their share of the line.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub(super) struct Alerting {
    machine: Alerts,
    waiting: VecDeque<Alert>,
    share: Share,
}

impl Alerting {
    /// Nothing is raised, and each alert waits to be reported as it is.
    pub(super) fn new() -> Self {
        let own = Alert::ALL.iter().copied();
        Self {
            machine: Alerts::default(),
            waiting: own.filter(|alert| alert.number() < 200).collect(),
            share: Share::default(),
        }
    }

    /// The alerts as they stand.
    pub(super) const fn standing(&self) -> &Alerts {
        &self.machine
    }

    /// Whether an alert is raised.
    pub(super) fn raised(&self, alert: Alert) -> bool {
        self.machine.raised(alert)
    }

    /// Takes what is said of an alert.
    pub(super) fn take(&mut self, now: Stamp, notice: Notice) {
        match notice {
            Notice::Raised(alert, text) => self.machine.raise(now, alert, &text),
            Notice::Rectified(alert) => self.machine.rectify(now, alert),
            Notice::Retold(alert, text) => self.machine.retext(alert, &text),
        }
    }

    /// Acknowledges by number. False where there is nothing to acknowledge.
    pub(super) fn acknowledge(&mut self, now: Stamp, number: u16) -> bool {
        self.machine.acknowledge(now, number)
    }

    /// The chart system acknowledges.
    pub(super) fn on_ack(&mut self, now: Stamp, sentence: &Sentence<'_>) {
        let number = Ack::from_sentence(sentence).and_then(|ack| ack.number);
        if let Some(number) = number.and_then(|number| u16::try_from(number).ok()) {
            self.acknowledge(now, number);
        }
    }

    /// Silences everything that sounds, or lets it sound again; the answer to it.
    pub(super) fn silence(&mut self, now: Stamp, silent: bool) -> &'static str {
        if silent {
            self.machine.silence(now);
            "silenced for 30 s"
        } else {
            self.machine.sound_again();
            "alerts sound again"
        }
    }

    /// What time alone changes.
    pub(super) fn tick(&mut self, now: Stamp) {
        self.machine.tick(now);
    }

    /// Reports what changed within its share of the line (AP-11); where it is told to several, of the slowest.
    pub(super) fn report(
        &mut self,
        now: Stamp,
        step_ms: u64,
        post: &mut Post,
        out: &mut Vec<Output>,
    ) {
        for alert in self.machine.take_changed() {
            self.waiting.retain(|waiting| *waiting != alert);
            self.waiting.push_front(alert);
        }
        let ports = post.ports().iter().enumerate();
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
            self.waiting.clear(); // there is nobody to tell
            return;
        };
        while let Some(alert) = self.waiting.front().copied() {
            let line = self.alr(alert).line(row.talker.unwrap_or_default());
            if !self.share.take(now, step_ms, baud, &line) {
                return;
            }
            self.waiting.pop_front();
            for (port, ..) in &told {
                post.say(now, *port, &line, out);
            }
        }
    }

    fn alr(&self, alert: Alert) -> Alr {
        let state = self.machine.state(alert);
        let taken = matches!(
            state,
            State::Acknowledged | State::Transferred | State::Normal
        );
        Alr {
            number: Some(u32::from(alert.number())),
            condition: Some(if self.machine.raised(alert) {
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
}

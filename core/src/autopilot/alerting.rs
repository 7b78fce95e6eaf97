//! The autopilot's alerts: the machine that keeps them, and what is said and heard of them (AP-11, FA15).

use super::modes::Modes;
use super::notices::Notice;
use crate::alerts::{Alert, Alerts, Reports};
use crate::command::Refusal;
use crate::nmea::Sentence;
use crate::post::Post;
use crate::station::{Output, PortIndex, PortSetup, Role};
use crate::time::Stamp;
use alloc::format;
use alloc::string::String;
use alloc::vec::Vec;
use serde::{Deserialize, Serialize};

/// Alerts, and what is said of them on the ports.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub(super) struct Alerting {
    machine: Alerts,
    reports: Reports,
}

impl Alerting {
    /// Nothing is raised, and each alert waits to be reported as it is.
    pub(super) fn new(ports: &[PortSetup]) -> Self {
        Self {
            machine: Alerts::default(),
            reports: Reports::new(Role::Autopilot, ports),
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

    /// Acknowledges by number, or says that there is nothing to acknowledge.
    pub(super) fn acknowledge(&mut self, now: Stamp, number: u16) -> Result<String, Refusal> {
        if self.machine.acknowledge(now, number) {
            Ok(format!("alert {number} acknowledged"))
        } else {
            let text = format!("alert {number} waits for no acknowledgement");
            Err(Refusal::because(text))
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

    /// What time alone changes: sound, escalation, the call of the back-up navigator, heartbeats and ports that are not
    /// heard (FB8, FB10).
    pub(super) fn tick(&mut self, now: Stamp, post: &Post, out: &mut Vec<Output>) {
        self.machine.tick(now);
        self.machine.tell_anew(now, Alert::PortFail, post.gone(now));
        let quiet = post.no_sentence(now);
        self.machine.tell_anew(now, Alert::NoSentence, quiet);
        let call = self.machine.call_backup(now, Alert::BackupCalled);
        out.extend(call.map(Output::backup_navigator));
        let lost = Alert::HeartbeatLost;
        self.reports
            .supervise(now, lost, post.ports(), &mut self.machine);
    }

    /// Takes ACK, ACN and HBT of a port; what they ask in vain is said beside the mode.
    pub(super) fn hear(
        &mut self,
        now: Stamp,
        port: PortIndex,
        sentence: &Sentence<'_>,
        post: &Post,
        modes: &mut Modes,
    ) {
        let Some(setup) = post.ports().get(port) else {
            return;
        };
        let alerts = &mut self.machine;
        if let Some(refused) = (self.reports).hear(now, port, setup.profile, sentence, alerts) {
            modes.refuse(&refused);
        }
    }

    /// Says on each port what is due there, within its share, as that unit of the autopilot (AP-11, ALA 4).
    pub(super) fn report(
        &mut self,
        now: Stamp,
        step_ms: u64,
        unit: u32,
        post: &mut Post,
        out: &mut Vec<Output>,
    ) {
        self.reports
            .say(now, step_ms, unit, &mut self.machine, post, out);
    }
}

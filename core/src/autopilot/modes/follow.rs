//! Obeying the chart system: each HTC is accepted or refused, then followed (HTC-1 to HTC-4, TCS-6 to TCS-10).

use super::event::{Cause, Event};
use super::met::mode_of;
use super::mode::Mode;
use super::part::Modes;
use super::selection::why_of;
use crate::alerts::Alert;
use crate::autopilot::facts::Outlook;
use crate::autopilot::notices::Notices;
use crate::autopilot::remote::can_do;
use crate::command::{self, Refusal, Remote};
use crate::nmea::{Sentence, SteeringMode};
use crate::picture::Source;
use crate::station::PortIndex;
use alloc::format;

impl Modes {
    /// An HTC was heard on a port that may command.
    pub(in super::super) fn on_htc(
        &mut self,
        outlook: &Outlook<'_>,
        port: PortIndex,
        sentence: &Sentence<'_>,
        notices: &mut Notices,
    ) {
        let now = outlook.facts.now;
        let source = Source {
            port,
            talker: sentence.talker().into(),
            formatter: "HTC".into(),
        };
        if self.has_another_authority(outlook, &source, notices) {
            return;
        }
        let command = command::htc(sentence, outlook.facts.settings.accept_null_status)
            .and_then(|command| self.accept(outlook, command));
        let command = match command {
            Ok(command) => command,
            Err(refusal) => {
                self.remote.htc.disprove();
                let text = format!("HTC refused: {refusal}");
                if self.mode.selected_until().is_some() || self.mode.is_autonav() {
                    self.why.clone_from(&text);
                }
                self.remote.htc.refuse(now, text);
                return;
            }
        };
        self.remote.htc.take(now, source, command);
        self.remote.by_hsc = false; // HTC-4
        match command {
            Remote::Override => self.override_reported(outlook, notices),
            Remote::Stop(mode) => {
                self.remote.htc.disprove();
                notices.rectify(Alert::Override);
                if self.mode.is_autonav() {
                    self.stopped(outlook, mode, notices);
                }
            }
            Remote::Heading { .. } | Remote::Track { .. } => {
                notices.rectify(Alert::Override);
                self.remote.htc.prove(now);
                self.follow(outlook, command);
            }
        }
    }

    /// FB13: the first that commands keeps the authority while it is fresh; the other is shown and never obeyed.
    fn has_another_authority(
        &mut self,
        outlook: &Outlook<'_>,
        source: &Source,
        notices: &mut Notices,
    ) -> bool {
        let (now, picture) = (outlook.facts.now, outlook.seen.picture);
        let fresh = outlook.facts.settings.track_fail_ms();
        let Some(authority) = self.remote.htc.other_holder(now, source, fresh) else {
            return false;
        };
        let text = format!(
            "HTC SOURCE CONFLICT: {} is obeyed, {} commands too and is not",
            picture.source_name(authority),
            picture.source_name(source)
        );
        notices.raise(Alert::HtcConflict, text);
        true
    }

    /// What a ship like this can do, and what does not contradict itself or what is steered.
    pub(super) fn accept(
        &mut self,
        outlook: &Outlook<'_>,
        command: Remote,
    ) -> Result<Remote, Refusal> {
        can_do(command, outlook.ship, outlook.speed())?;
        self.mode.state_mut().accepts(command)?;
        Ok(command)
    }

    /// HTC-1: STANDBY within one tick, and no way back but the operator's.
    fn override_reported(&mut self, outlook: &Outlook<'_>, notices: &mut Notices) {
        self.remote.htc.disprove();
        if self.mode == Mode::STANDBY {
            return;
        }
        notices.raise(Alert::Override, "");
        let why = "override reported by the chart system";
        self.apply(&outlook.facts, &Event::Override, why);
    }

    /// TCS-6: Tn and Ti may be switched without leaving AutoNAV.
    fn follow(&mut self, outlook: &Outlook<'_>, command: Remote) {
        let Some(wanted) = mode_of(command) else {
            return;
        };
        let now = outlook.facts.now;
        let missing = self.missing(outlook, wanted);
        if !self.mode.is_autonav() {
            // Not over what another mode says, or over the limits of AUTOTUNING while they are shown.
            let free = match &self.mode {
                Mode::Auto(auto) => {
                    auto.selected_until.is_none() && auto.tuning_until.is_none_or(|at| now >= at)
                }
                Mode::Standby(_) | Mode::RudderHold(_) => true,
                _ => false,
            };
            if free && missing.is_none() {
                self.why = "the chart system offers control: select AutoNAV".into();
            }
            return;
        }
        if let Some(missing) = missing {
            let why = format!("HTC not followed: {missing}");
            self.why.clone_from(&why);
            self.remote.htc.refuse(now, why);
            return;
        }
        if self.mode.name() != wanted {
            if let Some(event) = self.engagement(outlook, wanted) {
                self.apply(&outlook.facts, &event, "switched by the chart system");
            }
            return;
        }
        if self.why.starts_with("HTC ") {
            self.why = why_of(wanted).into(); // what was refused is obeyed again
        }
        self.mode.state_mut().follow(now, command);
    }

    /// TCS-9, TCS-10: the chart system commands another mode.
    fn stopped(&mut self, outlook: &Outlook<'_>, mode: SteeringMode, notices: &mut Notices) {
        if mode == SteeringMode::StandAlone {
            let text = "stopped by chart system";
            self.track_fail(outlook, Cause::StandAlone, text, notices);
            self.name_stop(outlook, notices);
        } else {
            let text = format!("HTC commands {}", mode.meaning());
            self.track_fail(outlook, Cause::ModeRefused, &text, notices);
        }
    }
}

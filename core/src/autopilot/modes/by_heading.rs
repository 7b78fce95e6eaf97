//! HSC as a source of the heading to steer in Tn, behind HTC (AP-13, HTC-4).

use super::mode::Mode;
use super::part::Modes;
use super::table::ModeName;
use crate::alerts::Alert;
use crate::autopilot::facts::Outlook;
use crate::autopilot::notices::Notices;
use crate::autopilot::plotter::north;
use crate::autopilot::remote::Authority;
use crate::command::{self, Origin, Refusal, Remote};
use crate::nmea::Sentence;
use crate::picture::Source;
use crate::station::PortIndex;
use alloc::format;

impl Modes {
    /// Whose commands are obeyed: HTC, or HSC where it is set and no HTC is heard.
    pub(super) fn commands(&self, outlook: &Outlook<'_>) -> &Authority<Remote> {
        if self.obeys_hsc(outlook) {
            &self.remote.hsc
        } else {
            &self.remote.htc
        }
    }

    /// Whether HSC commands. It never takes over from HTC in AutoNAV.
    pub(super) fn obeys_hsc(&self, outlook: &Outlook<'_>) -> bool {
        let settings = outlook.facts.settings;
        let htc = (self.remote.htc).command(outlook.facts.now, settings.track_fail_ms());
        let free = !self.mode.is_autonav() || self.remote.by_hsc;
        settings.hsc && htc.is_none() && free
    }

    /// An HSC was heard on a port that may say it.
    pub(in super::super) fn on_hsc(
        &mut self,
        outlook: &Outlook<'_>,
        port: PortIndex,
        sentence: &Sentence<'_>,
        notices: &mut Notices,
    ) {
        let (now, settings) = (outlook.facts.now, outlook.facts.settings);
        if !settings.hsc {
            return;
        }
        let source = Source {
            port,
            talker: sentence.talker().into(),
            formatter: "HSC".into(),
        };
        let fresh = settings.track_fail_ms();
        if let Some(holder) = self.remote.hsc.other_holder(now, &source, fresh) {
            let picture = outlook.seen.picture;
            let text = format!(
                "HSC SOURCE CONFLICT: {} is obeyed, {} commands too and is not",
                picture.source_name(holder),
                picture.source_name(&source)
            );
            notices.raise(Alert::HscConflict, text);
            return;
        }
        match self.hsc_command(outlook, sentence) {
            Ok(command) => {
                self.remote.hsc.take(now, source, command);
                self.remote.hsc.prove(now);
                let follows = matches!(self.mode, Mode::AutonavTn(_));
                if follows && self.missing(outlook, ModeName::AutonavTn).is_none() {
                    self.mode.state_mut().follow(now, command);
                }
            }
            Err(refusal) => {
                self.remote.hsc.disprove();
                self.remote
                    .hsc
                    .refuse(now, format!("HSC refused: {refusal}"));
            }
        }
    }

    /// What an HSC commands, or why it is not obeyed.
    fn hsc_command(
        &mut self,
        outlook: &Outlook<'_>,
        sentence: &Sentence<'_>,
    ) -> Result<Remote, Refusal> {
        if !self.obeys_hsc(outlook) {
            return Err(Refusal::because(format!(
                "{} goes before {}",
                Origin::Htc.title(),
                Origin::Hsc.title()
            )));
        }
        let accept_null = outlook.facts.settings.accept_null_status;
        let command = command::hsc(sentence, accept_null, |said| north(said, outlook))?;
        self.accept(outlook, command)
    }
}

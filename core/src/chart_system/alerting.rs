//! What the chart system hears of alerts, its own and the autopilot's, and what it acknowledges there (TCS-13).

use super::state::ChartSystem;
use crate::alerts::Alert;
use crate::nmea::Sentence;
use crate::station::{PortIndex, Profile};
use crate::time::Stamp;

/// Which system somebody operates (F2: EI0001 to EI0016).
const OPERATED: &str = "EI0001";
/// As whom it asks and acknowledges (SEN-3).
const TALKER: &str = "EI";

impl ChartSystem {
    /// Takes what the autopilot says of its alerts, and what others say of ours.
    pub(super) fn hear_of_alerts(&mut self, now: Stamp, port: PortIndex, sentence: &Sentence<'_>) {
        let profile = self.post.ports()[port].profile;
        let alerts = &mut self.watch.alerts;
        if let Some(refused) = self.reports.hear(now, port, profile, sentence, alerts) {
            self.why = refused;
        }
        if profile == Profile::Ecdis {
            for asked in self.heard.hear(now, sentence) {
                self.reports.add(port, asked.line(TALKER));
            }
        }
    }

    /// What is wrong with the ports to real equipment (FB8, FB10).
    pub(super) fn watch_ports(&mut self, now: Stamp) {
        let (gone, quiet) = (self.post.gone(now), self.post.no_sentence(now));
        let alerts = &mut self.watch.alerts;
        alerts.tell_anew(now, Alert::ChartPortFail, gone);
        alerts.tell_anew(now, Alert::ChartNoSentence, quiet);
    }

    /// TCS-13: an officer operates the chart system; told where that is asked for.
    pub(super) fn operated(&mut self, now: Stamp) {
        if self.config.eve {
            self.reports.operated(now, OPERATED, TALKER, &self.post);
        }
    }

    /// Acknowledges an alert of the autopilot; false where none of that number waits for it.
    pub(super) fn acknowledge_there(&mut self, number: u16) -> bool {
        let line = self.heard.acknowledgement(u32::from(number), TALKER);
        let mut ports = self.post.ports().iter();
        let port = ports.position(|port| port.profile == Profile::Ecdis && port.output);
        let (Some(line), Some(port)) = (line, port) else {
            return false;
        };
        self.reports.add(port, line);
        true
    }
}

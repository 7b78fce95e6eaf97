//! What the chart system hears of alerts, its own and the autopilot's, and what it acknowledges there (TCS-13).

use super::state::ChartSystem;
use crate::nmea::Sentence;
use crate::station::{PortIndex, Profile};
use crate::time::Stamp;

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

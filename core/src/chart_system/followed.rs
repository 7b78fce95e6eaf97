//! Whether the autopilot follows: control that it has left, or under which it fell silent, is not commanded on (TCS-13).

use super::control::Commanding;
use super::state::ChartSystem;
use crate::alerts::Alert;
use crate::nmea::SteeringMode;
use crate::time::Stamp;

/// An autopilot that followed and has not said so for so long is silent, milliseconds.
const SILENT_MS: u64 = 5_000;

impl ChartSystem {
    /// TCS-13: ends control that the autopilot has left, or under which it fell silent.
    pub(super) fn supervise(&mut self, now: Stamp) {
        if self.control == Commanding::Off {
            return;
        }
        if let (Some(Some(mode)), Some(heard)) = (self.steering_at(now), &self.post.picture.htd) {
            let follows = matches!(
                mode,
                SteeringMode::TrackControl | SteeringMode::HeadingControl
            );
            if follows && heard.at > self.followed.begun {
                self.followed.at = Some(heard.at);
            } else if !follows && self.followed.at.is_some() {
                self.give_up(now, "the autopilot has left it");
                return;
            }
        }
        if self.silent_at().is_some_and(|silent| now >= silent) {
            self.give_up(now, "the autopilot is silent");
        }
    }

    /// When an autopilot that followed is taken to be silent.
    pub(super) fn silent_at(&self) -> Option<Stamp> {
        if self.control == Commanding::Off {
            return None;
        }
        Some(self.followed.at? + SILENT_MS)
    }

    fn give_up(&mut self, now: Stamp, why: &str) {
        self.end_control(why);
        let text = alloc::format!("Control stopped: {why}. Check who steers");
        self.watch.raise(now, Alert::AutopilotLeft, &text);
    }
}

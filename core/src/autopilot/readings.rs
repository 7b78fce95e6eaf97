//! What can be read of the autopilot: its mode and why, what it steers, what it has heard.

use super::Timer;
use super::gear::Steered;
use super::sight::Refused;
use super::{Autopilot, Mode};
use crate::alerts::{Alert, Alerts};
use crate::facts::Quantity;
use crate::geo::Position;
use crate::picture::{Picture, Source};
use crate::settings::Settings;
use crate::time::Stamp;
use crate::units::{Heading, RudderAngle};
use alloc::string::String;
use alloc::vec::Vec;

impl Autopilot {
    /// Heading to steer in force.
    #[must_use]
    pub fn hts(&self) -> Option<Heading> {
        self.mode.hts(&self.facts(self.now))
    }

    /// The picture of what is heard and sent.
    #[must_use]
    pub fn picture(&self) -> &Picture {
        &self.post.picture
    }

    /// Until when an AutoNAV selection waits for its confirmation.
    #[must_use]
    pub const fn pending(&self) -> Option<Stamp> {
        self.mode.selected_until()
    }

    /// Why the mode is what it is: last refusal or cause, in an officer's words.
    #[must_use]
    pub fn why(&self) -> &str {
        &self.why
    }

    /// What the steering gave in the last step; absent where no order was computed.
    #[must_use]
    pub const fn steered(&self) -> Option<&Steered> {
        self.gear.steered()
    }

    /// Its alerts.
    #[must_use]
    pub fn alerts(&self) -> &Alerts {
        self.alerts.standing()
    }

    /// Its settings.
    #[must_use]
    pub fn settings(&self) -> &Settings {
        &self.settings
    }

    /// Its mode.
    #[must_use]
    pub fn mode(&self) -> &Mode {
        &self.mode
    }

    /// The heading that is believed: of the compass in use, or its prediction while that stands in; absent where none is.
    #[must_use]
    pub const fn believed_heading(&self) -> Option<Heading> {
        self.sight.heading()
    }

    /// Whether that heading is of magnetic north: no variation is known (AP-10).
    #[must_use]
    pub fn heading_is_magnetic(&self) -> bool {
        self.sight.is_magnetic()
    }

    /// When the sources were judged last, at the control step before this: what was heard then or later waits for the next.
    #[must_use]
    pub fn judged_at(&self) -> Stamp {
        let next = self.timers.at(Timer::Step).unwrap_or(self.now);
        Stamp(next.0.saturating_sub(self.settings.step_ms()))
    }

    /// The position that is believed: of the receiver in use, carried on; absent 5 s after its last good fix.
    #[must_use]
    pub fn believed_position(&self, now: Stamp) -> Option<Position> {
        self.sight.position(now)
    }

    /// The compass in use.
    #[must_use]
    pub const fn compass_in_use(&self) -> Option<&Source> {
        self.sight.compass()
    }

    /// The receiver in use.
    #[must_use]
    pub const fn receiver_in_use(&self) -> Option<&Source> {
        self.sight.receiver()
    }

    /// Every source that is heard and not believed (AP-9, FA8, FA9, TCS-8).
    #[must_use]
    pub fn refused(&self) -> Vec<Refused<'_>> {
        let mut refused = self.sight.refused_places();
        let commands = (self.post.picture.pney1.as_ref())
            .filter(|_| self.alerts.raised(Alert::TrackDataRefused))
            .map(|heard| Refused {
                quantity: Quantity::Control,
                source: &heard.source,
                why: "does not fit",
            });
        refused.extend(commands);
        refused.extend(self.sight.refused_motions(self.post.seen(self.now)));
        refused
    }

    /// Name of a source as `port/talker/formatter`.
    #[must_use]
    pub fn source_name(&self, source: &Source) -> String {
        self.post.picture.source_name(source)
    }

    /// Rudder order in force; absent where none is given.
    #[must_use]
    pub fn rudder_order(&self) -> Option<RudderAngle> {
        self.mode.row().gives_orders().then_some(self.gear.order())
    }

    /// Rudder limit in force, degrees; in STANDBY the one that AUTO will have.
    #[must_use]
    pub const fn rudder_limit(&self) -> f64 {
        self.mode.row().rudder_limit(&self.settings)
    }
}

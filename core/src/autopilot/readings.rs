//! What can be read of the autopilot: its mode and why, what it steers, what it has heard.

use super::gear::Steered;
use super::{Autopilot, Mode};
use crate::alerts::Alerts;
use crate::picture::Picture;
use crate::settings::Settings;
use crate::time::Stamp;
use crate::units::{Heading, RudderAngle};

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
        &self.alerts
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

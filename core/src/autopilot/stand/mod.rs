//! The steering stand: what its selector, levers and contacts say of who steers (AP-22).
//!
//! In: HTD of the stand's port, and contacts. Out: a claim of the stand, which goes before every mode that is selected here.
//! A claim is taken at the first sign of it and given up once its end is certain.

mod contacts;
mod selector;

use crate::nmea::Sentence;
use crate::picture::Picture;
use crate::station::{Profile, Switch};
use crate::time::Stamp;
use crate::units::RudderAngle;
use alloc::string::String;
use contacts::Contacts;
use selector::{Says, Selector};
use serde::{Deserialize, Serialize};

/// What the stand knows and says.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub(super) struct Stand {
    selector: Selector,
    contacts: Contacts,
}

/// What the stand claims.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Claim {
    /// The line of the hardware override is in use.
    NfuLine,
    /// The ship is steered by hand; how that is known, in an officer's words.
    Hand(&'static str),
    /// The follow-up lever orders this rudder.
    Rudder(RudderAngle),
}

impl Stand {
    /// Takes an HTD of the stand's port.
    pub(super) fn on_htd(&mut self, now: Stamp, sentence: &Sentence<'_>) {
        self.selector.take(now, sentence);
    }

    /// Takes a contact as it is now; absent where it cannot be read.
    pub(super) fn on_contact(&mut self, now: Stamp, switch: Switch, closed: Option<bool>) {
        self.contacts.take(now, switch, closed);
    }

    /// What the stand claims now; absent where the autopilot may be engaged.
    pub(super) fn claim(&self, now: Stamp) -> Option<Claim> {
        let says = self.selector.says(now);
        let active = |switch| self.contacts.is_active(now, switch);
        if active(Switch::Nfu) || says == Some(Says::NfuLine) {
            return Some(Claim::NfuLine);
        }
        match says {
            Some(Says::Hand) => Some(Claim::Hand("the steering stand is switched to hand")),
            Some(Says::Rudder(order)) => Some(Claim::Rudder(order)),
            _ if active(Switch::Ffu) => Some(Claim::Hand("the FFU lever steers")),
            _ if active(Switch::Autopilot) => {
                Some(Claim::Hand("the mode switch is not at autopilot"))
            }
            _ => None,
        }
    }

    /// What is wrong with what it says, in an officer's words.
    pub(super) fn trouble(&self, now: Stamp, picture: &Picture) -> Option<String> {
        let wired = (picture.ports.iter()).any(|port| port.profile == Profile::Stand);
        let wrong = self.selector.wrong(now, wired);
        wrong.or_else(|| self.contacts.unread())
    }
}

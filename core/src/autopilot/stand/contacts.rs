//! Contacts of the steering stand: each acts at the first sign of its safe side, and no longer once that is over for certain (AP-22).

use crate::station::Switch;
use crate::time::Stamp;
use alloc::format;
use alloc::string::String;
use serde::{Deserialize, Serialize};

/// A contact that bounces is not at rest before so long, milliseconds.
const STEADY_MS: u64 = 200;

/// The contacts that are wired.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub(super) struct Contacts([Option<Contact>; Switch::ALL.len()]);

#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
struct Contact {
    /// It takes the ship from the autopilot.
    active: bool,
    /// Since when it is as it is.
    since: Stamp,
    /// It cannot be read.
    unread: bool,
}

impl Contacts {
    /// Takes a contact as it is now; absent where it cannot be read: it stays as it was.
    pub(super) fn take(&mut self, now: Stamp, switch: Switch, closed: Option<bool>) {
        let slot = &mut self.0[switch as usize];
        // The autopilot's own position of the mode switch is the closed one: a broken wire is steering by hand.
        let active = closed.map(|closed| closed != (switch == Switch::Autopilot));
        match (slot.as_mut(), active) {
            (Some(contact), None) => contact.unread = true,
            (None, None) => {
                *slot = Some(Contact {
                    active: switch == Switch::Autopilot,
                    since: now,
                    unread: true,
                });
            }
            (Some(contact), Some(active)) if contact.active == active => contact.unread = false,
            (_, Some(active)) => {
                // The first reading is at rest.
                let since = if slot.is_none() { Stamp(0) } else { now };
                *slot = Some(Contact {
                    active,
                    since,
                    unread: false,
                });
            }
        }
    }

    /// Whether a contact takes the ship from the autopilot: at once, and until it has been at rest for a while.
    pub(super) fn is_active(&self, now: Stamp, switch: Switch) -> bool {
        self.0[switch as usize].is_some_and(|contact| {
            contact.active || contact.since > Stamp(0) && now.since(contact.since) < STEADY_MS
        })
    }

    /// The contacts that cannot be read.
    pub(super) fn unread(&self) -> Option<String> {
        let unread =
            |switch: &&Switch| self.0[**switch as usize].is_some_and(|contact| contact.unread);
        let switch = Switch::ALL.iter().find(unread)?;
        Some(format!("The contact {} cannot be read", switch.name()))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    // AP-22
    #[test]
    fn a_contact_acts_at_once_and_is_over_when_it_has_been_at_rest() {
        let mut contacts = Contacts::default();
        assert!(!contacts.is_active(Stamp(0), Switch::Nfu), "not wired");
        contacts.take(Stamp(10), Switch::Nfu, Some(false));
        assert!(!contacts.is_active(Stamp(10), Switch::Nfu));
        // It bounces while it closes and while it opens.
        for (at, closed) in [(1_000, true), (1_003, false), (1_005, true)] {
            contacts.take(Stamp(at), Switch::Nfu, Some(closed));
            assert!(contacts.is_active(Stamp(at), Switch::Nfu), "{at}");
        }
        for (at, closed) in [(2_000, false), (2_100, true), (2_150, false)] {
            contacts.take(Stamp(at), Switch::Nfu, Some(closed));
            assert!(contacts.is_active(Stamp(at), Switch::Nfu), "{at}");
        }
        assert!(contacts.is_active(Stamp(2_349), Switch::Nfu));
        assert!(!contacts.is_active(Stamp(2_350), Switch::Nfu));
    }

    #[test]
    fn an_open_mode_switch_is_steering_by_hand_and_what_cannot_be_read_stays_as_it_was() {
        let mut contacts = Contacts::default();
        let by_hand = |contacts: &Contacts| contacts.is_active(Stamp(9_000), Switch::Autopilot);
        contacts.take(Stamp(1), Switch::Autopilot, None);
        assert!(by_hand(&contacts) && contacts.unread().is_some());
        contacts.take(Stamp(2), Switch::Autopilot, Some(true));
        assert!(!by_hand(&contacts) && contacts.unread().is_none());
        contacts.take(Stamp(3), Switch::Autopilot, None);
        assert!(!by_hand(&contacts));
        let unread = contacts.unread().unwrap();
        assert!(unread.contains("autopilot"), "{unread}");
        contacts.take(Stamp(4), Switch::Autopilot, Some(false));
        assert!(by_hand(&contacts));
    }
}

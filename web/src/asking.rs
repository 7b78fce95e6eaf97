//! Commands: asked, answered, or said at once that they were not sent. Nothing waits, and nothing is sent later (AP-25).

use crate::deck::{Asked, Deck, LinkAge, STANDBY};
use crate::link;
use crate::steady::steady;
use leptos::prelude::*;
use wheelover_core::view::Order;

/// An answer that takes longer is not waited for, milliseconds.
const PATIENCE: f64 = 2_000.0;

impl Deck {
    /// Sends a command for a button; says at once where it was not sent.
    pub(crate) fn command(&self, button: &str, action: Order) {
        self.press(button, None, action);
    }

    /// Number of the snapshot that is shown.
    pub(crate) fn frame(&self) -> Option<u64> {
        self.own
            .with_untracked(|own| own.as_ref().map(|own| own.frame))
    }

    /// As [`Deck::command`], for a button that was pressed beside this frame (AP-26).
    pub(crate) fn press(&self, button: &str, frame: Option<u64>, action: Order) {
        let link = LinkAge {
            age: self.silent(),
            frames: 0,
        };
        // A socket may be open and lead nowhere: what it takes now would come late.
        let sent = if link.lost() {
            None
        } else {
            link::command(frame, action)
        };
        match sent {
            Some(id) => self.asked.update(|asked| {
                asked.push(Asked {
                    id,
                    button: button.to_owned(),
                    at: steady(),
                });
            }),
            None => self.refuse(if button == STANDBY {
                "NO LINK: STANDBY not sent, use the ship's own override"
            } else {
                "NO LINK: not sent"
            }),
        }
    }

    /// Gives up what is not answered in time.
    fn hurry(&self) {
        let now = steady();
        let late = self
            .asked
            .with_untracked(|asked| asked.iter().any(|asked| now - asked.at > PATIENCE));
        let dead = || {
            let link = LinkAge {
                age: self.silent(),
                frames: 0,
            };
            link.lost() && self.asked.with_untracked(|asked| !asked.is_empty())
        };
        if late || dead() {
            self.unanswered();
            // Nothing that may still be on its way is sent later.
            link::renew();
        }
    }
}

/// Looks at the clocks before each picture of the browser, and four times a second.
pub(crate) fn look(deck: Deck) {
    let slept = deck.look();
    deck.hurry();
    if slept && !document().hidden() {
        // A socket may look open and be dead, or full of what is long past.
        link::renew();
    }
}

/// The page is about to stand still, or is looked at again.
pub(crate) fn leave(deck: Deck, leaving: bool) {
    deck.leave(leaving);
    if !leaving {
        look(deck);
    }
}

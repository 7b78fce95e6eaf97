//! Commands: asked, answered, or said at once that they were not sent. Nothing waits, and nothing is sent later (AP-25).

use crate::deck::{Asked, Deck, LinkAge};
use crate::link::{self, steady};
use leptos::prelude::*;
use std::time::Duration;
use wheelover_core::view::{Answer, Order};

/// So long a refusal is shown.
const REFUSAL: Duration = Duration::from_secs(20);

/// An answer that takes longer is not waited for, milliseconds.
const PATIENCE: f64 = 2_000.0;

/// The button whose command is never refused quietly.
const STANDBY: &str = "standby";

impl Deck {
    /// Sends a command for a button; says at once where it was not sent.
    pub(crate) fn command(&self, button: &str, action: Order) {
        let link = LinkAge {
            age: self.silent(),
            frames: 0,
        };
        // A socket may be open and lead nowhere: what it takes now would come late.
        let sent = if link.lost() {
            None
        } else {
            link::command(action)
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

    /// Takes an answer.
    pub(crate) fn answered(&self, answer: Answer) {
        self.asked
            .update(|asked| asked.retain(|asked| asked.id != answer.id));
        let shown = self.answer;
        let mine = answer.clone();
        self.answer.set(Some(answer));
        // A refusal need not stand beside a mode that has long changed.
        let fade = move || {
            if shown.with_untracked(|shown| shown.as_ref() == Some(&mine)) {
                shown.set(None);
            }
        };
        set_timeout(fade, REFUSAL);
    }

    /// The connection has ended, or nothing comes on it: what was asked and not answered is not waited for.
    pub(crate) fn unanswered(&self) {
        let asked = self.asked.get_untracked();
        if asked.is_empty() {
            return;
        }
        self.asked.set(Vec::new());
        let standby = asked.iter().any(|asked| asked.button == STANDBY);
        self.refuse(if standby {
            "NO ANSWER: STANDBY may not be done, use the ship's own override"
        } else {
            "NO ANSWER: look at the mode"
        });
    }

    /// Gives up what is not answered in time.
    pub(crate) fn hurry(&self, lost: bool) {
        let now = steady();
        let late = self
            .asked
            .with_untracked(|asked| asked.iter().any(|asked| now - asked.at > PATIENCE));
        if late || lost && self.asked.with_untracked(|asked| !asked.is_empty()) {
            self.unanswered();
            // Nothing that may still be on its way is sent later.
            link::renew();
        }
    }

    fn refuse(&self, text: &str) {
        self.answered(Answer {
            id: 0,
            ok: false,
            text: text.to_owned(),
        });
    }
}

//! What says the frames and takes the commands: the one that is open, and what becomes of its frames.

use crate::deck::Deck;
use leptos::prelude::*;
use std::cell::RefCell;
use std::time::Duration;
use wheelover_core::view::{Down, Order, Up};

/// Where frames come from and commands go to. What it hears it gives to [`receive`], never while it is being called.
pub(crate) trait Source {
    /// Says something; false where it cannot be said now.
    fn say(&mut self, up: &Up) -> bool;

    /// Looks after itself, four times a second; `silent` is the age of the last believed frame, milliseconds.
    fn watch(&mut self, silent: Option<u64>);

    /// Begins anew, because what it says cannot be believed.
    fn renew(&mut self);
}

struct Link {
    source: Box<dyn Source>,
    next_command: u64,
}

thread_local! {
    static LINK: RefCell<Option<Link>> = const { RefCell::new(None) };
}

/// Opens the link to a source; from then on it keeps itself open.
pub(crate) fn open(source: Box<dyn Source>) {
    LINK.set(Some(Link {
        source,
        next_command: 1,
    }));
}

fn with<T>(act: impl FnOnce(&mut Link) -> T) -> Option<T> {
    LINK.with_borrow_mut(|link| link.as_mut().map(act))
}

/// Looks after the source. Called by the page's tick.
pub(crate) fn watch(silent: Option<u64>) {
    with(|link| link.source.watch(silent));
}

/// Begins the link anew: the page has slept, or lines are missing.
pub(crate) fn renew() {
    with(|link| link.source.renew());
}

/// Sends a command; gives back its number, or nothing where it was not sent.
pub(crate) fn command(frame: Option<u64>, action: Order) -> Option<u64> {
    with(|link| {
        link.next_command += 1;
        let id = link.next_command;
        let up = Up::Command { id, frame, action };
        link.source.say(&up).then_some(id)
    })
    .flatten()
}

fn say(up: &Up) {
    // Whatever is not said now is said anew after the next hello.
    with(|link| link.source.say(up));
}

/// Takes one frame from the source, that came at a time of the steady clock.
pub(crate) fn receive(deck: Deck, frame: Down, came: f64) {
    match frame {
        Down::Hello(hello) => {
            let first = deck.greeting.with_untracked(Option::is_none);
            let from = deck.greet(hello, came);
            let follow = move || {
                say(&Up::Subscribe {
                    rate: 10.0,
                    lines: true,
                });
                say(&Up::Resume { seq: from });
            };
            if first && !document().hidden() {
                // What the hello says is on the screen before the lines of the past are read.
                request_animation_frame(move || set_timeout(follow, Duration::ZERO));
            } else {
                follow();
            }
        }
        Down::Snapshot(snapshot) => {
            say(&Up::Ack {
                frame: snapshot.frame,
            });
            deck.snapshot(snapshot, came);
        }
        Down::Lines(lines) => {
            if !deck.lines(&lines, came) {
                // Lines are missing: only a new hello can mend the picture.
                renew();
            }
        }
        Down::Route(route) => deck.route.set(route),
        Down::Ports(ports) => deck.ports.set(ports.ports),
        Down::Answer(answer) => deck.answered(answer),
        Down::Settings(_) | Down::Gap { .. } => {}
    }
}

//! The embedded voyage in the page itself: the same stations, without a server. What is said is what a server would say.

use super::source::{Source, receive};
use crate::deck::Deck;
use crate::steady::steady;
use leptos::prelude::*;
use std::cell::RefCell;
use std::collections::VecDeque;
use std::rc::Rc;
use std::time::Duration;
use wheelover_core::time::Stamp;
use wheelover_core::view::{
    Answer, Down, Line, Lines, Order, Origin, Presses, Up, hello, route_document, snapshot,
};
use wheelover_core::voyage::{Event, Voyage, VoyageOutput};

/// Between two snapshots.
const PUBLISH: Duration = Duration::from_millis(100);
/// Lines that are held for a page that resumes.
const HELD: usize = 20_000;
/// A page that stood still sails on from where it was, milliseconds: nothing is made up for.
const LONGEST_STEP: f64 = 1_000.0;

struct State {
    voyage: Voyage,
    held: VecDeque<Line>,
    /// Ship's time, milliseconds, and the steady time for which it holds.
    ship: f64,
    wall: f64,
    frame: u64,
    presses: Presses,
    follows: bool,
    answers: Vec<Answer>,
    out: Vec<VoyageOutput>,
}

/// A voyage that runs here. A copy is a handle.
#[derive(Clone)]
pub(crate) struct InPage {
    deck: Deck,
    state: Rc<RefCell<State>>,
}

impl InPage {
    /// A voyage that has not begun.
    pub(crate) fn new(deck: Deck, voyage: Voyage) -> Self {
        let state = State {
            ship: voyage.now().0 as f64,
            voyage,
            held: VecDeque::new(),
            wall: steady(),
            frame: 0,
            presses: Presses::default(),
            follows: false,
            answers: Vec::new(),
            out: Vec::new(),
        };
        Self {
            deck,
            state: Rc::new(RefCell::new(state)),
        }
    }

    /// Says hello and sails.
    pub(crate) fn sail(&self) {
        self.greet();
        let voyage = self.clone();
        set_interval(move || voyage.publish(), PUBLISH);
    }

    fn greet(&self) {
        let (hello, route) = {
            let state = self.state.borrow();
            let mut hello = hello(&state.voyage, env!("CARGO_PKG_VERSION"));
            hello.may_command = true;
            (hello, route_document(&state.voyage))
        };
        for frame in [Down::Hello(hello), Down::Route(route)] {
            receive(self.deck, frame, steady());
        }
    }

    /// Sails as far as time has gone, and says what there is to say.
    fn publish(&self) {
        let frames = {
            let mut state = self.state.borrow_mut();
            let fresh = state.advance();
            let mut frames: Vec<Down> = state.answers.drain(..).map(Down::Answer).collect();
            if state.follows {
                frames.extend(lines(fresh));
                state.frame += 1;
                let mut snapshot = snapshot(&state.voyage);
                snapshot.frame = state.frame;
                state.presses.show(&snapshot);
                frames.push(Down::Snapshot(snapshot));
            }
            frames
        };
        for frame in frames {
            receive(self.deck, frame, steady());
        }
    }
}

impl State {
    fn advance(&mut self) -> Vec<Line> {
        let wall = steady();
        let passed = (wall - std::mem::replace(&mut self.wall, wall)).min(LONGEST_STEP);
        self.ship += passed * self.voyage.rate();
        self.happen(Event::Tick)
    }

    /// An order, where it was pressed beside what is still so (AP-26).
    fn ask(&mut self, id: u64, frame: Option<u64>, order: Order) -> Vec<Line> {
        let now = self.voyage.now();
        let refused = (self.voyage.autopilot())
            .and_then(|autopilot| self.presses.allow(frame, &order, autopilot, now).err());
        if let Some(text) = refused {
            let ok = false;
            self.answers.push(Answer { id, ok, text });
            return Vec::new();
        }
        let by = Origin::Officer;
        self.happen(Event::Order { id, by, order })
    }

    fn happen(&mut self, event: Event) -> Vec<Line> {
        let now = Stamp(self.ship as u64).max(self.voyage.now());
        self.voyage.handle(now, event, &mut self.out);
        let mut fresh = Vec::new();
        for output in self.out.drain(..) {
            match output {
                VoyageOutput::Line(line) => fresh.push(line),
                VoyageOutput::Answer(answer) => self.answers.push(answer),
                // No port, no file, and a route that stays as it is.
                _ => {}
            }
        }
        self.held.extend(fresh.iter().cloned());
        while self.held.len() > HELD {
            self.held.pop_front();
        }
        fresh
    }
}

fn lines(lines: Vec<Line>) -> Option<Down> {
    let from = lines.first()?.seq;
    Some(Down::Lines(Lines { from, lines }))
}

impl Source for InPage {
    fn say(&mut self, up: &Up) -> bool {
        let voyage = self.clone();
        let up = up.clone();
        // Not at once: what answers must not be called by who asks.
        set_timeout(
            move || match up {
                Up::Command { id, frame, action } => {
                    let fresh = voyage.state.borrow_mut().ask(id, frame, action);
                    let follows = voyage.state.borrow().follows;
                    if let Some(frame) = lines(fresh).filter(|_| follows) {
                        receive(voyage.deck, frame, steady());
                    }
                    voyage.publish();
                }
                Up::Resume { seq } => {
                    let held = {
                        let mut state = voyage.state.borrow_mut();
                        state.follows = true;
                        state
                            .held
                            .iter()
                            .filter(|line| line.seq >= seq)
                            .cloned()
                            .collect::<Vec<_>>()
                    };
                    if let Some(frame) = lines(held) {
                        receive(voyage.deck, frame, steady());
                    }
                }
                Up::Ack { .. } | Up::Subscribe { .. } => {}
            },
            Duration::ZERO,
        );
        true
    }

    fn watch(&mut self, _: Option<u64>) {
        // It cannot be away.
    }

    fn renew(&mut self) {
        self.state.borrow_mut().follows = false;
        let voyage = self.clone();
        set_timeout(move || voyage.greet(), Duration::ZERO);
    }
}

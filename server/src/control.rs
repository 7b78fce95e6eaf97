//! The control thread: it owns the voyage and the only clock, and waits for nobody.
//!
//! In: bytes and commands from a bounded queue, and time. Out: bytes into outboxes, news for the feed,
//! entries for the recorder; each of these takes what it can and never holds the thread up.

use crate::clock::{Clock, Pace};
use crate::feed::News;
use crate::persist::Keeper;
use crate::ports::Link;
use crate::realtime;
use crate::recorder::Recorder;
use std::collections::BTreeMap;
use std::sync::mpsc::{Receiver, RecvTimeoutError, SyncSender, sync_channel};
use std::thread::JoinHandle;
use std::time::{Duration, Instant};
use tokio::sync::{mpsc, oneshot};
use wheelover_core::time::Stamp;
use wheelover_core::view::{self, Answer, Hello, Line, Order, Origin, Outline};
use wheelover_core::voyage::{Event, Voyage, VoyageOutput};

/// Inputs that may wait.
const QUEUE: usize = 2_048;
/// Inputs that are taken before the next step is looked at.
const BUDGET: usize = 64;
/// Later than this is a stall, microseconds (FA16).
const LATE: u64 = 200_000;
/// A simulated world stands still while its computer does, but a stop of this length is told, microseconds.
const LONG_STOP: u64 = 2_000_000;
/// Between two snapshots, microseconds.
const PUBLISH: u64 = 100_000;
/// Between two looks at the ports, in snapshots.
const PORTS_EVERY: u64 = 10;

/// What the thread is told.
#[derive(Debug)]
pub enum Input {
    /// Bytes were heard.
    Bytes {
        /// Number of the port.
        port: usize,
        /// The bytes.
        bytes: Vec<u8>,
    },
    /// A port came or went.
    PortUp {
        /// Number of the port.
        port: usize,
        /// Whether it is there.
        up: bool,
    },
    /// Somebody commands.
    Command {
        /// What.
        action: Order,
        /// Where the answer goes.
        answer: oneshot::Sender<Answer>,
    },
    /// A client wants to begin.
    Hello(oneshot::Sender<Hello>),
    /// The server ends.
    Stop,
}

/// The way to the control thread.
#[derive(Clone, Debug)]
pub struct Control {
    sender: SyncSender<Input>,
}

impl Control {
    /// Gives an input if there is room for it; whether there was.
    #[must_use]
    pub fn offer(&self, input: Input) -> bool {
        self.sender.try_send(input).is_ok()
    }

    /// Says that a port came or went; this is never lost.
    pub async fn port_up(&self, port: usize, up: bool) {
        while !self.offer(Input::PortUp { port, up }) {
            tokio::time::sleep(Duration::from_millis(20)).await;
        }
    }

    /// The first frame for a client, as of now.
    pub async fn hello(&self) -> Option<Hello> {
        let (sender, receiver) = oneshot::channel();
        if self.offer(Input::Hello(sender)) {
            receiver.await.ok()
        } else {
            None
        }
    }
}

/// What the thread works with.
pub struct Parts {
    /// The stations.
    pub voyage: Voyage,
    /// Own ship as the plan draws her.
    pub ship: Outline,
    /// Their ports, in the order of the configuration.
    pub links: Vec<Link>,
    /// Which of them may send.
    pub may_send: Vec<bool>,
    /// Where news go.
    pub news: mpsc::Sender<News>,
    /// Who writes everything down.
    pub recorder: Option<Recorder>,
    /// Who keeps settings over a restart.
    pub keeper: Option<Keeper>,
}

/// Makes the way to the thread; the thread itself is started by [`start`].
#[must_use]
pub fn channel() -> (Control, Receiver<Input>) {
    let (sender, receiver) = sync_channel(QUEUE);
    (Control { sender }, receiver)
}

/// Starts the thread; says through `granted` whether it has real-time priority.
///
/// # Errors
/// The system gives no thread.
pub fn start(
    parts: Parts,
    inputs: Receiver<Input>,
    granted: oneshot::Sender<bool>,
) -> std::io::Result<JoinHandle<()>> {
    std::thread::Builder::new()
        .name("control".to_owned())
        .spawn(move || {
            let _ = granted.send(realtime::ask());
            Thread::new(parts).run(&inputs);
        })
}

struct Thread {
    parts: Parts,
    clock: Clock,
    pace: Pace,
    simulated: bool,
    next_publish: u64,
    published: u64,
    commands: u64,
    answers: BTreeMap<u64, oneshot::Sender<Answer>>,
    out: Vec<VoyageOutput>,
    lines: Vec<Line>,
    stop: bool,
}

impl Thread {
    fn new(parts: Parts) -> Self {
        Self {
            clock: Clock::start(),
            pace: Pace::new(parts.voyage.rate()),
            simulated: parts.voyage.is_embedded(),
            parts,
            next_publish: 0,
            published: 0,
            commands: 0,
            answers: BTreeMap::new(),
            out: Vec::new(),
            lines: Vec::new(),
            stop: false,
        }
    }

    fn run(mut self, inputs: &Receiver<Input>) {
        self.tell(News::Route(view::route_document(&self.parts.voyage)));
        self.tell(News::Settings(view::settings_document(&self.parts.voyage)));
        let mut planned = self.clock.micros();
        while !self.stop {
            let wall = self.clock.micros();
            self.note_lateness(planned, wall);
            self.step(wall);
            if wall >= self.next_publish {
                self.publish(wall);
            }
            self.send_lines();
            self.pace
                .change(self.clock.micros(), self.parts.voyage.rate());
            planned = self
                .pace
                .wall(self.parts.voyage.due().0)
                .min(self.next_publish);
            let wait = planned.saturating_sub(self.clock.micros());
            match inputs.recv_timeout(Duration::from_micros(wait)) {
                Ok(input) => {
                    self.take(input);
                    for input in inputs.try_iter().take(BUDGET) {
                        self.take(input);
                    }
                }
                Err(RecvTimeoutError::Timeout) => {}
                Err(RecvTimeoutError::Disconnected) => return,
            }
        }
    }

    /// FA16: with real equipment the gap counts and every input has to be heard again. The embedded world
    /// stood still as long as its computer did, so that nothing in it is late; a long stop is told all the same.
    fn note_lateness(&mut self, planned: u64, wall: u64) {
        let late = wall.saturating_sub(planned);
        if late <= LATE {
            return;
        }
        if self.simulated {
            self.pace.slip(wall, self.parts.voyage.now().0);
            if late <= LONG_STOP {
                return;
            }
        }
        self.happen(wall, Event::Stalled { ms: late / 1_000 });
    }

    /// Runs what is due, step by step, also at sixty times real time.
    fn step(&mut self, wall: u64) {
        let ship = Stamp(self.pace.ship(wall));
        loop {
            let due = self.parts.voyage.due();
            if due > ship {
                return;
            }
            self.parts.voyage.handle(due, Event::Tick, &mut self.out);
            self.deliver();
            // A computer that is too slow for the pace sails slower.
            if self.simulated && self.clock.micros().saturating_sub(wall) > LATE / 4 {
                self.pace.slip(self.clock.micros(), due.0);
                return;
            }
        }
    }

    fn take(&mut self, input: Input) {
        let wall = self.clock.micros();
        match input {
            Input::Bytes { port, bytes } => self.happen(wall, Event::Bytes { port, bytes }),
            Input::PortUp { port, up } => self.happen(wall, Event::PortUp { port, up }),
            Input::Command { action, answer } => {
                self.commands += 1;
                let id = self.commands;
                // Those who went away before their answer came are forgotten.
                self.answers.retain(|_, waiting| !waiting.is_closed());
                self.answers.insert(id, answer);
                self.happen(
                    wall,
                    Event::Order {
                        id,
                        by: Origin::Officer,
                        order: action,
                    },
                );
            }
            Input::Hello(reply) => {
                let mut hello = view::hello(&self.parts.voyage, env!("CARGO_PKG_VERSION"));
                hello.ship = self.parts.ship;
                let _ = reply.send(hello);
            }
            Input::Stop => self.stop = true,
        }
    }

    fn happen(&mut self, wall: u64, event: Event) {
        let ship = Stamp(self.pace.ship(wall)).max(self.parts.voyage.now());
        if let Some(recorder) = &mut self.parts.recorder {
            recorder.event(ship, &event);
        }
        self.parts.voyage.handle(ship, event, &mut self.out);
        self.deliver();
    }

    fn deliver(&mut self) {
        let mut out = std::mem::take(&mut self.out);
        let at = self.parts.voyage.now();
        for output in out.drain(..) {
            if let Some(recorder) = &mut self.parts.recorder {
                recorder.output(at, &output);
            }
            match output {
                VoyageOutput::Send { port, bytes } => {
                    if self.parts.may_send.get(port) == Some(&true)
                        && let Some(link) = self.parts.links.get(port)
                    {
                        link.outbox.push(&bytes, Instant::now());
                    }
                }
                VoyageOutput::Line(line) => self.lines.push(line),
                VoyageOutput::Answer(answer) => {
                    if let Some(waiting) = self.answers.remove(&answer.id) {
                        let _ = waiting.send(answer);
                    }
                }
                VoyageOutput::Persist { key, value } => {
                    if let Some(keeper) = &self.parts.keeper {
                        keeper.keep(key, value);
                    }
                }
                VoyageOutput::Route => {
                    self.tell(News::Route(view::route_document(&self.parts.voyage)))
                }
                VoyageOutput::Settings => {
                    self.tell(News::Settings(view::settings_document(&self.parts.voyage)));
                }
            }
        }
        self.out = out;
    }

    fn publish(&mut self, wall: u64) {
        self.next_publish = wall - wall % PUBLISH + PUBLISH;
        // The snapshot is of now, not of the last step; time alone changes nothing else.
        let ship = Stamp(self.pace.ship(wall)).max(self.parts.voyage.now());
        self.parts.voyage.handle(ship, Event::Tick, &mut self.out);
        self.deliver();
        self.send_lines();
        if self.published.is_multiple_of(PORTS_EVERY) {
            self.tell(News::Ports(view::ports_document(&self.parts.voyage)));
        }
        self.published += 1;
        self.tell(News::Snapshot(Box::new(view::snapshot(&self.parts.voyage))));
    }

    fn send_lines(&mut self) {
        if !self.lines.is_empty() {
            let lines = std::mem::take(&mut self.lines);
            self.tell(News::Lines(lines));
        }
    }

    /// News that find no room are lost; lines then show as a gap.
    fn tell(&self, news: News) {
        let _ = self.parts.news.try_send(news);
    }
}

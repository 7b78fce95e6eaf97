//! The control thread: it owns the voyage and the only clock, and waits for nobody.
//!
//! In: what is asked, then what was heard, and time. Out: bytes into outboxes, news for the feed,
//! entries for the recorder; each of these takes what it can and never holds the thread up.

#[cfg(debug_assertions)]
mod drill;
use crate::bus::{Asked, Document, FromPort, Link, News, Place, Queues};
use crate::clock::{Clock, Pace, Tempo};
use crate::config::Rules;
use crate::lines::Lines;
use crate::persist::Keeper;
use crate::realtime;
use crate::recorder::Recorder;
use crossbeam_channel::{TryRecvError, select_biased};
use std::collections::BTreeMap;
use std::thread::JoinHandle;
use std::time::{Duration, Instant};
use tokio::sync::{mpsc, oneshot};
use wheelover_core::time::Stamp;
use wheelover_core::view::{self, Answer, Down, Line, Order, Origin, Outline, Presses};
use wheelover_core::voyage::{Event, Voyage, VoyageOutput};

/// Inputs that are taken before the next step is looked at.
const BUDGET: usize = 64;
/// Later than this on board is a stall, microseconds (FA16).
const LATE: u64 = 200_000;
/// A simulated world stands still while its computer does, but a stop of this length is told, microseconds.
const LONG_STOP: u64 = 2_000_000;
/// Between two snapshots, microseconds.
const PUBLISH: u64 = 100_000;
/// Between two looks at the ports, in snapshots.
const PORTS_EVERY: u64 = 10;

/// What the thread works with.
pub(crate) struct Parts {
    /// The stations.
    pub(crate) voyage: Voyage,
    /// Own ship as the plan draws her.
    pub(crate) ship: Outline,
    /// What changed settings have to agree with.
    pub(crate) rules: Rules,
    /// Their ports, in the order of the configuration.
    pub(crate) links: Vec<Link>,
    /// Where news go.
    pub(crate) news: mpsc::Sender<News>,
    /// Who writes everything down.
    pub(crate) recorder: Option<Recorder>,
    /// Who keeps settings over a restart.
    pub(crate) keeper: Option<Keeper>,
    /// What a trial's clock waits for.
    pub(crate) lines: Option<Lines>,
}

/// Why the thread ended by itself; a panic is another way.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum End {
    /// It was asked to.
    Asked,
    /// Nobody is left who could ask for anything.
    Deserted,
}

/// Starts the thread; says through `granted` whether it has real-time priority.
///
/// # Errors
/// The system gives no thread.
pub(crate) fn start(
    parts: Parts,
    queues: Queues,
    granted: oneshot::Sender<bool>,
) -> std::io::Result<JoinHandle<End>> {
    std::thread::Builder::new()
        .name("control".to_owned())
        .spawn(move || {
            let _ = granted.send(realtime::ask(realtime::CONTROL));
            Thread::new(parts).run(&queues)
        })
}

/// Who waits for the answer to an order.
struct Waiting {
    /// The client's number for it.
    id: u64,
    client: mpsc::UnboundedSender<Answer>,
    /// Free again with the answer.
    _place: Option<Place>,
}

struct Thread {
    parts: Parts,
    clock: Clock,
    pace: Pace,
    /// The clock stands still while the computer is late, by more than that many microseconds.
    slips: bool,
    late: u64,
    /// When the next step or snapshot is due, microseconds.
    planned: u64,
    next_publish: u64,
    published: u64,
    presses: Presses,
    orders: u64,
    answers: BTreeMap<u64, Waiting>,
    out: Vec<VoyageOutput>,
    lines: Vec<Line>,
    end: Option<End>,
    #[cfg(debug_assertions)]
    drill: Option<drill::Drill>,
}

impl Thread {
    fn new(parts: Parts) -> Self {
        let embedded = parts.voyage.is_embedded();
        let tempo = Tempo::new(parts.voyage.pace());
        Self {
            clock: Clock::start(),
            pace: Pace::new(parts.voyage.rate()),
            slips: embedded || tempo.is_trial(),
            late: if embedded { LATE } else { tempo.micros(LATE) },
            parts,
            planned: 0,
            next_publish: 0,
            published: 0,
            presses: Presses::default(),
            orders: 0,
            answers: BTreeMap::new(),
            out: Vec::new(),
            lines: Vec::new(),
            end: None,
            #[cfg(debug_assertions)]
            drill: drill::Drill::from_environment(),
        }
    }

    fn run(mut self, queues: &Queues) -> End {
        self.tell_route();
        self.tell_settings();
        self.planned = self.clock.micros();
        loop {
            let wall = self.clock.micros();
            self.note_lateness(wall);
            self.step(wall);
            if wall >= self.next_publish {
                self.publish(wall);
            }
            self.send_lines();
            #[cfg(debug_assertions)]
            if self.drill.as_ref().is_some_and(|drill| drill.hold(wall)) {
                self.end = Some(End::Deserted);
            }
            if let Some(end) = self.end {
                return end;
            }
            let rate = self.parts.voyage.rate();
            self.pace.change(self.clock.micros(), rate);
            let due = self.pace.wall(self.parts.voyage.due().0);
            self.planned = due.min(self.next_publish);
            let wait = self.planned.saturating_sub(self.clock.micros());
            self.listen(queues, Duration::from_micros(wait));
        }
    }

    /// Waits for something to take, and takes what there is; before each thing that was heard, all that is asked (AP-25).
    fn listen(&mut self, queues: &Queues, wait: Duration) {
        select_biased! {
            recv(queues.asked) -> asked => match asked {
                Ok(asked) => self.asked(asked),
                Err(_) => self.end = Some(End::Deserted),
            },
            recv(queues.heard) -> heard => match heard {
                Ok(heard) => self.heard(heard),
                Err(_) => self.end = Some(End::Deserted),
            },
            default(wait) => return,
        }
        for _ in 0..BUDGET {
            match queues.asked.try_recv() {
                Ok(asked) => self.asked(asked),
                Err(TryRecvError::Empty) => match queues.heard.try_recv() {
                    Ok(heard) => self.heard(heard),
                    Err(_) => return,
                },
                Err(TryRecvError::Disconnected) => return,
            }
        }
    }

    /// FA16: with real equipment the gap counts and every input has to be heard again. Embedded or in a trial at another
    /// pace the stations stood still as long as computer and lines did; a long stop is told all the same.
    fn note_lateness(&mut self, wall: u64) {
        let behind = self.parts.lines.as_ref().map_or(0, Lines::behind);
        let late = wall.saturating_sub(self.planned).max(behind);
        if late <= self.late {
            return;
        }
        self.planned = wall;
        if self.slips {
            let ship = self.pace.ship(wall.saturating_sub(late));
            self.pace.slip(wall, ship.max(self.parts.voyage.now().0));
            if late <= LONG_STOP {
                return;
            }
        }
        self.take(wall, Event::Stalled { ms: late / 1_000 });
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
            if self.slips && self.clock.micros().saturating_sub(wall) > self.late / 4 {
                self.pace.slip(self.clock.micros(), due.0);
                return;
            }
        }
    }

    fn asked(&mut self, asked: Asked) {
        match asked {
            Asked::Order {
                id,
                frame,
                action,
                answer,
                place,
            } => {
                if let Err(text) = self.may_be(frame, &action) {
                    let ok = false;
                    let _ = answer.send(Answer { id, ok, text });
                    return;
                }
                self.orders += 1;
                let order = self.orders;
                let waiting = Waiting {
                    id,
                    client: answer,
                    _place: place,
                };
                // Those who went away before their answer came are forgotten.
                self.answers
                    .retain(|_, waiting| !waiting.client.is_closed());
                self.answers.insert(order, waiting);
                let event = Event::Order {
                    id: order,
                    by: Origin::Officer,
                    order: action,
                };
                self.happen(event);
            }
            Asked::Contact { switch, closed } => self.happen(Event::Contact { switch, closed }),
            Asked::Hello(reply) => {
                let mut hello = view::hello(&self.parts.voyage, env!("CARGO_PKG_VERSION"));
                hello.ship = self.parts.ship;
                let _ = reply.send(hello);
            }
            Asked::Alerts(reply) => drop(reply.send(view::alerts_document(&self.parts.voyage))),
            Asked::Offered(reply) => drop(reply.send(view::offered_route(&self.parts.voyage))),
            Asked::Stop => self.end = Some(End::Asked),
        }
    }

    /// An order has to be pressed beside what is still so (AP-26); a changed setting has to agree with ports and other
    /// settings, as at the start.
    fn may_be(&self, frame: Option<u64>, action: &Order) -> Result<(), String> {
        let Some(autopilot) = self.parts.voyage.autopilot() else {
            return Ok(());
        };
        let now = self.parts.voyage.now();
        self.presses.allow(frame, action, autopilot, now)?;
        let Order::Setting { key, value } = action else {
            return Ok(());
        };
        let mut settings = autopilot.settings().clone();
        let set = settings.set(key, value);
        // What is wrong with the value itself is said by the autopilot.
        set.map_or(Ok(()), |()| self.parts.rules.check(&settings))
    }

    fn heard(&mut self, heard: FromPort) {
        let (event, place) = match heard {
            FromPort::Bytes { port, bytes, place } => (Event::Bytes { port, bytes }, Some(place)),
            FromPort::PortUp { port, up } => (Event::PortUp { port, up }, None),
        };
        self.happen(event);
        drop(place);
    }

    /// What happens after a stall finds the stations told of it: nothing that was missed is made up for.
    fn happen(&mut self, event: Event) {
        let wall = self.clock.micros();
        self.note_lateness(wall);
        self.take(wall, event);
    }

    fn take(&mut self, wall: u64, event: Event) {
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
                    let link = self.parts.links.get(port);
                    if let Some(outbox) = link.and_then(|link| link.outbox.as_ref()) {
                        outbox.push(&bytes, Instant::now());
                    }
                }
                VoyageOutput::Line(line) => self.lines.push(line),
                VoyageOutput::Answer(answer) => {
                    if let Some(waiting) = self.answers.remove(&answer.id) {
                        let id = waiting.id;
                        let _ = waiting.client.send(Answer { id, ..answer });
                    }
                }
                VoyageOutput::Persist { key, value } => {
                    if let Some(keeper) = &self.parts.keeper {
                        keeper.keep(key, value);
                    }
                }
                VoyageOutput::Contact {
                    station,
                    contact,
                    closed,
                } => tracing::warn!(
                    "{}: contact {contact:?} {}",
                    station.name(),
                    if closed { "closes" } else { "opens" }
                ),
                VoyageOutput::Route => self.tell_route(),
                VoyageOutput::Settings => self.tell_settings(),
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
            let ports = view::ports_document(&self.parts.voyage);
            self.tell_document(Document::Ports, Down::Ports(ports));
        }
        self.published += 1;
        let mut snapshot = view::snapshot(&self.parts.voyage);
        snapshot.frame = self.published;
        self.presses.show(&snapshot);
        self.tell(News::Snapshot(Box::new(snapshot)));
    }

    fn tell_route(&self) {
        let route = view::route_document(&self.parts.voyage);
        self.tell_document(Document::Route, Down::Route(route));
    }

    fn tell_settings(&self) {
        let settings = view::settings_document(&self.parts.voyage);
        self.tell_document(Document::Settings, Down::Settings(settings));
    }

    fn tell_document(&self, which: Document, document: Down) {
        self.tell(News::Document(which, Box::new(document)));
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

#[cfg(test)]
mod tests;

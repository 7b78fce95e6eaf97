//! What pages are told: the newest of each document, and the last lines with their numbers.
//!
//! Everything is encoded once and shared by all clients.

use axum::extract::ws::Utf8Bytes;
use serde::Serialize;
use std::collections::VecDeque;
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};
use std::time::{Duration, Instant};
use tokio::sync::{mpsc, watch};
use wheelover_core::view::{
    Down, Line, Lines, PortsDocument, RouteDocument, SettingsDocument, Snapshot,
};

use crate::ports::Link;

/// Lines that are held for clients that come back.
const HELD: usize = 20_000;
/// Lines that a client which is behind is told in one message.
const TOLD: usize = 500;
/// Messages that may wait between the control thread and here.
const QUEUE: usize = 4_096;

/// What the control thread tells.
#[derive(Debug)]
pub enum News {
    /// Own facts, ten times a second.
    Snapshot(Box<Snapshot>),
    /// Lines heard and sent.
    Lines(Vec<Line>),
    /// The route has changed.
    Route(RouteDocument),
    /// The settings have changed.
    Settings(SettingsDocument),
    /// State of the ports.
    Ports(PortsDocument),
}

/// A snapshot as it is sent.
#[derive(Clone, Debug, Default)]
pub struct Frame {
    /// Its number.
    pub number: u64,
    /// Number of the last line that it knows.
    pub line: u64,
    /// Its text.
    pub text: Utf8Bytes,
}

/// The newest of everything.
#[derive(Debug)]
pub struct Feed {
    snapshot: watch::Sender<Frame>,
    route: watch::Sender<Utf8Bytes>,
    settings: watch::Sender<Utf8Bytes>,
    ports: watch::Sender<Utf8Bytes>,
    /// Number of the next line.
    next: watch::Sender<u64>,
    held: Mutex<Held>,
    alive: Mutex<Option<Instant>>,
}

/// What one client follows.
#[derive(Debug)]
pub struct Follower {
    /// Snapshots.
    pub snapshot: watch::Receiver<Frame>,
    /// The route.
    pub route: watch::Receiver<Utf8Bytes>,
    /// The settings.
    pub settings: watch::Receiver<Utf8Bytes>,
    /// The ports.
    pub ports: watch::Receiver<Utf8Bytes>,
    /// Number of the next line.
    pub next: watch::Receiver<u64>,
}

impl Feed {
    /// An empty feed, and the way in.
    #[must_use]
    pub fn new() -> (Arc<Self>, mpsc::Sender<News>, mpsc::Receiver<News>) {
        let (sender, receiver) = mpsc::channel(QUEUE);
        let feed = Self {
            snapshot: watch::Sender::default(),
            route: watch::Sender::default(),
            settings: watch::Sender::default(),
            ports: watch::Sender::default(),
            next: watch::Sender::default(),
            held: Mutex::default(),
            alive: Mutex::default(),
        };
        (Arc::new(feed), sender, receiver)
    }

    /// Follows everything.
    #[must_use]
    pub fn follow(&self) -> Follower {
        Follower {
            snapshot: self.snapshot.subscribe(),
            route: self.route.subscribe(),
            settings: self.settings.subscribe(),
            ports: self.ports.subscribe(),
            next: self.next.subscribe(),
        }
    }

    /// The route as it is sent.
    #[must_use]
    pub fn route(&self) -> Utf8Bytes {
        self.route.borrow().clone()
    }

    /// Whether the control thread has spoken within two seconds.
    #[must_use]
    pub fn is_alive(&self) -> bool {
        let alive = self.alive.lock().unwrap_or_else(PoisonError::into_inner);
        alive.is_some_and(|at| at.elapsed() < Duration::from_secs(2))
    }

    /// The next text for a client that wants lines from `from` on, and the number after it.
    #[must_use]
    pub fn lines(&self, from: u64, last: u64) -> Option<(Utf8Bytes, u64)> {
        self.held().after(from, last)
    }

    fn held(&self) -> MutexGuard<'_, Held> {
        self.held.lock().unwrap_or_else(PoisonError::into_inner)
    }

    /// Takes news until the control thread ends. Lines go out with the snapshots, ten times a second, so that
    /// a client has the lines of a snapshot, and no later ones, when it gets that snapshot.
    pub async fn run(self: Arc<Self>, mut news: mpsc::Receiver<News>, links: Vec<Link>) {
        let mut frame = 0;
        let mut fresh: Vec<Line> = Vec::new();
        while let Some(told) = news.recv().await {
            match told {
                News::Lines(lines) => fresh.extend(lines),
                News::Snapshot(snapshot) => {
                    *self.alive.lock().unwrap_or_else(PoisonError::into_inner) =
                        Some(Instant::now());
                    self.hold(&mut fresh);
                    frame += 1;
                    self.show(frame, *snapshot);
                }
                News::Route(route) => put(&self.route, &Down::Route(route)),
                News::Settings(settings) => put(&self.settings, &Down::Settings(settings)),
                News::Ports(mut ports) => {
                    for view in &mut ports.ports {
                        if let Some(link) = links.iter().find(|link| link.name == view.name) {
                            view.trouble = link.trouble();
                        }
                    }
                    put(&self.ports, &Down::Ports(ports));
                }
            }
        }
    }

    fn hold(&self, fresh: &mut Vec<Line>) {
        let next = self.held().add(std::mem::take(fresh));
        if let Some(next) = next {
            self.next.send_replace(next);
        }
    }

    fn show(&self, frame: u64, mut snapshot: Snapshot) {
        if self.snapshot.receiver_count() == 0 {
            return;
        }
        let line = snapshot.line;
        snapshot.frame = frame;
        if let Some(text) = encode(&Down::Snapshot(snapshot)) {
            let shown = Frame {
                number: frame,
                line,
                text,
            };
            self.snapshot.send_replace(shown);
        }
    }
}

fn put(place: &watch::Sender<Utf8Bytes>, document: &Down) {
    if let Some(text) = encode(document) {
        place.send_if_modified(|old| {
            let changed = *old != text;
            *old = text;
            changed
        });
    }
}

/// A message as text.
pub fn encode<T: Serialize>(message: &T) -> Option<Utf8Bytes> {
    serde_json::to_string(message).ok().map(Utf8Bytes::from)
}

/// Lines that went out together.
#[derive(Debug)]
struct Batch {
    lines: Vec<Line>,
    text: Utf8Bytes,
}

impl Batch {
    fn from(&self) -> u64 {
        self.lines.first().map_or(0, |line| line.seq)
    }

    fn next(&self) -> u64 {
        self.lines.last().map_or(0, |line| line.seq + 1)
    }
}

/// The last lines.
#[derive(Debug, Default)]
struct Held {
    batches: VecDeque<Batch>,
    count: usize,
}

impl Held {
    /// Takes lines; the number after them, where there are any.
    fn add(&mut self, lines: Vec<Line>) -> Option<u64> {
        let next = lines.last()?.seq + 1;
        // A line that was lost on the way here ends a batch, so that the gap can be seen.
        let mut rest = lines;
        while !rest.is_empty() {
            let gap = rest
                .windows(2)
                .position(|pair| pair[1].seq != pair[0].seq + 1);
            let later = rest.split_off(gap.map_or(rest.len(), |at| at + 1));
            self.count += rest.len();
            let text = text_of(rest.clone());
            self.batches.push_back(Batch { lines: rest, text });
            rest = later;
        }
        while self.count > HELD
            && let Some(oldest) = self.batches.pop_front()
        {
            self.count -= oldest.lines.len();
        }
        Some(next)
    }

    /// What a client is told that wants the lines from `from` on, of batches that begin by `last`, and what it wants next.
    fn after(&self, from: u64, last: u64) -> Option<(Utf8Bytes, u64)> {
        let at = self.batches.partition_point(|batch| batch.next() <= from);
        let batch = self.batches.get(at)?;
        if batch.from() > from {
            let lost = batch.from() - from;
            return Some((encode(&Down::Gap { lost })?, batch.from()));
        }
        let since = batch.lines.partition_point(|line| line.seq < from);
        let mut lines = batch.lines.get(since..)?.to_vec();
        let mut next = batch.next();
        for later in self.batches.iter().skip(at + 1) {
            let fits = lines.len() + later.lines.len() <= TOLD;
            if !fits || later.from() != next || later.from() > last {
                break;
            }
            lines.extend_from_slice(&later.lines);
            next = later.next();
        }
        if since == 0 && next == batch.next() {
            // A client that keeps up shares the text with all others.
            return Some((batch.text.clone(), next));
        }
        Some((text_of(lines), next))
    }
}

fn text_of(lines: Vec<Line>) -> Utf8Bytes {
    let message = Down::Lines(Lines {
        from: lines.first().map_or(0, |line| line.seq),
        lines,
    });
    encode(&message).unwrap_or_default()
}

#[cfg(test)]
mod tests {
    use super::*;
    use wheelover_core::station::Direction;

    fn lines(numbers: impl Iterator<Item = u64>) -> Vec<Line> {
        numbers
            .map(|number| Line {
                seq: number,
                at: number * 10,
                port: 0,
                dir: Direction::In,
                text: format!("${number}"),
            })
            .collect()
    }

    /// Everything that a client hears that asks from `from` on: first and last number of each message, or the gap.
    fn check(held: &Held, from: u64, last: u64, expect: &[&str]) {
        let mut next = from;
        let mut heard = Vec::new();
        while let Some((text, then)) = held.after(next, last) {
            if next > last {
                break;
            }
            next = then;
            heard.push(match serde_json::from_str::<Down>(&text).unwrap() {
                Down::Gap { lost } => format!("gap {lost}"),
                Down::Lines(lines) => {
                    assert_eq!(lines.from, lines.lines[0].seq);
                    format!("{}-{}", lines.from, lines.lines.last().unwrap().seq)
                }
                other => panic!("{other:?}"),
            });
        }
        assert_eq!(heard, expect);
    }

    #[test]
    fn a_client_that_comes_back_misses_nothing() {
        let mut held = Held::default();
        assert_eq!(held.add(Vec::new()), None);
        assert_eq!(held.add(lines(1..=3)), Some(4));
        held.add(lines(4..=9));
        const ALL: u64 = u64::MAX;
        check(&held, 1, ALL, &["1-9"]);
        check(&held, 6, ALL, &["6-9"]);
        check(&held, 10, ALL, &[]);
        check(&held, 99, ALL, &[]);
        check(&held, 0, ALL, &["gap 1", "1-9"]);
        // Not beyond the snapshot that goes with them.
        check(&held, 1, 3, &["1-3"]);
        held.add(lines(10..=505));
        check(&held, 1, ALL, &["1-9", "10-505"]);
    }

    #[test]
    fn lines_that_are_no_longer_held_are_a_gap() {
        let mut held = Held::default();
        for batch in 0..30 {
            held.add(lines(batch * 1_000 + 1..=(batch + 1) * 1_000));
        }
        assert_eq!(held.count, HELD);
        let (text, next) = held.after(5, u64::MAX).unwrap();
        assert_eq!(&*text, r#"{"type":"gap","lost":9996}"#);
        assert_eq!(next, 10_001);
    }

    #[test]
    fn a_line_lost_on_the_way_is_a_gap() {
        let mut held = Held::default();
        held.add(lines((1..=9).filter(|number| *number != 5)));
        check(&held, 1, u64::MAX, &["1-4", "gap 1", "6-9"]);
    }
}

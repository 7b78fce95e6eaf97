//! What pages are told: the newest of each document, and the last lines with their numbers.
//!
//! Everything is encoded once and shared by all clients, and one signal a tick wakes them.

use crate::bus::{Document, Link, News};
use crate::dialogue::Dialogue;
use axum::extract::ws::Utf8Bytes;
use serde::Serialize;
use std::collections::VecDeque;
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};
use std::time::{Duration, Instant};
use tokio::sync::{mpsc, watch};
use wheelover_core::view::{Down, Line, Lines, Snapshot};

/// Lines that are held for clients that come back.
const HELD: usize = 20_000;
/// Lines that a client which is behind is told in one message.
const TOLD: usize = 500;
/// Messages that may wait between the control thread and here.
const QUEUE: usize = 4_096;

/// A snapshot as it is sent.
#[derive(Clone, Debug, Default)]
pub(crate) struct Frame {
    /// Its number.
    pub(crate) number: u64,
    /// Number of the last line that it knows.
    pub(crate) line: u64,
    /// Its text.
    pub(crate) text: Utf8Bytes,
}

/// A document as it is sent.
#[derive(Clone, Debug, Default)]
struct Page {
    /// How often it has changed; 0 while there is none.
    version: u64,
    text: Utf8Bytes,
}

/// What a client follows: the newest of everything.
#[derive(Clone, Debug, Default)]
pub(crate) struct Shown {
    /// The last snapshot.
    pub(crate) frame: Frame,
    pages: [Page; Document::ALL.len()],
}

/// How much of the documents one client has.
#[derive(Debug, Default)]
pub(crate) struct Seen([u64; Document::ALL.len()]);

impl Shown {
    /// The first document that is newer than what the client has; it has it then.
    pub(crate) fn unseen(&self, seen: &mut Seen) -> Option<Utf8Bytes> {
        let mut pairs = self.pages.iter().zip(&mut seen.0);
        let (page, seen) = pairs.find(|(page, seen)| page.version > **seen)?;
        *seen = page.version;
        Some(page.text.clone())
    }

    /// Takes a document; whether it differs from the one before.
    fn put(&mut self, which: Document, document: &Down) -> bool {
        let page = &mut self.pages[which as usize];
        match encode(document) {
            Some(text) if text != page.text => {
                page.text = text;
                page.version += 1;
                true
            }
            _ => false,
        }
    }
}

/// The newest of everything, and the last lines.
#[derive(Debug)]
pub(crate) struct Feed {
    shown: watch::Sender<Shown>,
    held: Mutex<Held>,
    alive: Mutex<Option<Instant>>,
    dialogue: Dialogue,
}

impl Feed {
    /// An empty feed, and the way in; the dialogue of `ports` is checked.
    pub(crate) fn new(dialogue: Dialogue) -> (Arc<Self>, mpsc::Sender<News>, mpsc::Receiver<News>) {
        let (sender, receiver) = mpsc::channel(QUEUE);
        let feed = Self {
            shown: watch::Sender::default(),
            held: Mutex::default(),
            alive: Mutex::default(),
            dialogue,
        };
        (Arc::new(feed), sender, receiver)
    }

    /// Follows everything.
    pub(crate) fn follow(&self) -> watch::Receiver<Shown> {
        self.shown.subscribe()
    }

    /// A document as it is sent.
    pub(crate) fn document(&self, which: Document) -> Utf8Bytes {
        self.shown.borrow().pages[which as usize].text.clone()
    }

    /// Whether the control thread has spoken within two seconds.
    pub(crate) fn is_alive(&self) -> bool {
        let alive = self.alive.lock().unwrap_or_else(PoisonError::into_inner);
        alive.is_some_and(|at| at.elapsed() < Duration::from_secs(2))
    }

    /// What the checker of the dialogue has found (CON-2).
    pub(crate) fn dialogue(&self) -> &Dialogue {
        &self.dialogue
    }

    /// The next text for a client that wants lines from `from` on, and the number after it.
    pub(crate) fn lines(&self, from: u64, last: u64) -> Option<(Utf8Bytes, u64)> {
        self.held().after(from, last)
    }

    fn held(&self) -> MutexGuard<'_, Held> {
        self.held.lock().unwrap_or_else(PoisonError::into_inner)
    }

    /// Takes news until the control thread ends. Lines go out with the snapshots, ten times a second, so that
    /// a client has the lines of a snapshot, and no later ones, when it gets that snapshot.
    pub(crate) async fn run(self: Arc<Self>, mut news: mpsc::Receiver<News>, links: Vec<Link>) {
        let mut fresh: Vec<Line> = Vec::new();
        while let Some(told) = news.recv().await {
            match told {
                News::Lines(lines) => {
                    self.dialogue.hear(&lines);
                    fresh.extend(lines);
                }
                News::Snapshot(snapshot) => {
                    *self.alive.lock().unwrap_or_else(PoisonError::into_inner) =
                        Some(Instant::now());
                    self.held().add(std::mem::take(&mut fresh));
                    self.show(*snapshot);
                }
                News::Document(which, mut document) => {
                    if let Down::Ports(ports) = document.as_mut() {
                        for view in &mut ports.ports {
                            let link = links.iter().find(|link| link.name == view.name);
                            // What the line itself has goes before what is heard on it.
                            let trouble = link.map(|link| link.trouble().to_string());
                            if let Some(trouble) = trouble.filter(|words| !words.is_empty()) {
                                view.trouble = trouble;
                            }
                        }
                    }
                    self.shown
                        .send_if_modified(|shown| shown.put(which, &document));
                }
            }
        }
    }

    fn show(&self, snapshot: Snapshot) {
        if self.shown.receiver_count() == 0 {
            return;
        }
        let (number, line) = (snapshot.frame, snapshot.line);
        if let Some(text) = encode(&Down::Snapshot(snapshot)) {
            let frame = Frame { number, line, text };
            self.shown.send_modify(|shown| shown.frame = frame);
        }
    }
}

/// A message as text.
pub(crate) fn encode<T: Serialize>(message: &T) -> Option<Utf8Bytes> {
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
    /// Takes lines.
    fn add(&mut self, lines: Vec<Line>) {
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
        held.add(Vec::new());
        held.add(lines(1..=3));
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

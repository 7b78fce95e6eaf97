//! What waits to be sent on a port: the newest sentence of each kind (FB11).

use std::collections::VecDeque;
use std::sync::{Mutex, MutexGuard, PoisonError};
use std::time::{Duration, Instant};
use tokio::sync::Notify;
use wheelover_core::talk::{Slot, slot};

/// Kinds that may wait at once; far more than any port has.
const PLACES: usize = 128;
/// A periodic sentence that waited longer on board is not sent: a fresh one follows.
pub(crate) const OLDEST: Duration = Duration::from_secs(2);

#[derive(Debug)]
struct Waiting {
    line: Vec<u8>,
    since: Instant,
}

impl Waiting {
    fn slot(&self) -> Slot<'_> {
        slot(&self.line)
    }
}

/// One place for each sentence, by the table of what is said. Pushing never waits.
#[derive(Debug, Default)]
pub(crate) struct Outbox {
    waiting: Mutex<VecDeque<Waiting>>,
    news: Notify,
}

impl Outbox {
    fn lock(&self) -> MutexGuard<'_, VecDeque<Waiting>> {
        self.waiting.lock().unwrap_or_else(PoisonError::into_inner)
    }

    /// Takes whole sentences; each replaces the one of its kind that still waits.
    pub(crate) fn push(&self, sentences: &[u8], now: Instant) {
        let mut waiting = self.lock();
        for line in sentences.split_inclusive(|byte| *byte == b'\n') {
            let fresh = Waiting {
                line: line.to_vec(),
                since: now,
            };
            let place = slot(line);
            let old = waiting.iter().position(|old| old.slot() == place);
            match old {
                // Parts of a message leave in their order: a new first part is never behind a new second one.
                Some(old) if place.event => drop(waiting.remove(old)),
                Some(old) => {
                    waiting[old] = fresh;
                    continue;
                }
                None => {}
            }
            if waiting.len() >= PLACES {
                let periodic = waiting.iter().position(|old| !old.slot().event);
                waiting.remove(periodic.unwrap_or(0));
            }
            waiting.push_back(fresh);
        }
        drop(waiting);
        self.news.notify_one();
    }

    /// The next sentence to send; periodic ones that waited for longer than `oldest` are left out.
    pub(crate) fn take(&self, now: Instant, oldest: Duration) -> Option<Vec<u8>> {
        let mut waiting = self.lock();
        while let Some(next) = waiting.pop_front() {
            if next.slot().event || now.saturating_duration_since(next.since) <= oldest {
                return Some(next.line);
            }
        }
        None
    }

    /// Waits until there is something to send, and takes it.
    pub(crate) async fn next(&self, oldest: Duration) -> Vec<u8> {
        loop {
            if let Some(line) = self.take(Instant::now(), oldest) {
                return line;
            }
            self.news.notified().await;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// What is left to send, in order, after `pushed`.
    fn check(pushed: &[&str], expect: &[&str]) {
        let outbox = Outbox::default();
        let now = Instant::now();
        for text in pushed {
            outbox.push(text.as_bytes(), now);
        }
        let mut sent = Vec::new();
        while let Some(line) = outbox.take(now, OLDEST) {
            sent.push(String::from_utf8(line).unwrap());
        }
        assert_eq!(sent, expect);
    }

    // FB11
    #[test]
    fn the_newest_of_each_kind_is_sent() {
        check(
            &[
                "$AGROR,1.0,A*hh\r\n",
                "$AGHTD,V*hh\r\n",
                "$AGROR,2.0,A*hh\r\n",
            ],
            &["$AGROR,2.0,A*hh\r\n", "$AGHTD,V*hh\r\n"],
        );
        check(
            &["$AGROR,1\r\n$AGRSA,1\r\n", "$AGRSA,2\r\n"],
            &["$AGROR,1\r\n", "$AGRSA,2\r\n"],
        );
    }

    #[test]
    fn numbered_sentences_have_a_slot_each() {
        check(
            &["$PNEY,001,a\r\n", "$PNEY,002,b\r\n", "$PNEY,001,c\r\n"],
            &["$PNEY,001,c\r\n", "$PNEY,002,b\r\n"],
        );
        let alerts = ["$AGALR,,012,A,V,*hh\r\n", "$AGALR,,013,A,V,*hh\r\n"];
        check(&alerts, &alerts);
        check(
            &["$AGALR,,012,A,V,\r\n", "$AGALR,,012,V,V,\r\n"],
            &["$AGALR,,012,V,V,\r\n"],
        );
    }

    #[test]
    fn a_periodic_sentence_that_waited_too_long_is_left_out_and_an_alert_is_not() {
        let outbox = Outbox::default();
        let now = Instant::now();
        outbox.push(b"$AGROR,1,A\r\n$AGALR,,012,A,V\r\n", now);
        let later = now + Duration::from_secs(3);
        assert_eq!(outbox.take(later, OLDEST).unwrap(), b"$AGALR,,012,A,V\r\n");
        assert!(outbox.take(later, OLDEST).is_none());
    }

    #[test]
    fn what_waits_is_bounded() {
        let outbox = Outbox::default();
        let now = Instant::now();
        for number in 0..10_000 {
            outbox.push(format!("$PTST,{number}\r\n").as_bytes(), now);
        }
        assert_eq!(outbox.lock().len(), PLACES);
    }
}

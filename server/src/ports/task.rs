//! One task a port: opens it, moves bytes until it is lost, and opens it again.

use super::contacts::Contacts;
use super::open::{self, Opened};
use super::playback;
use super::stood::Stood;
use super::wire::{Moved, Wire};
use crate::bus::{Inlet, Link, Trouble};
use crate::clock::Tempo;
use crate::config::{Place, Port};
use crate::error::reason;
use crate::outbox::OLDEST;
use std::io;
use std::time::Duration;
use tokio::net::TcpListener;
use tokio::time::{Instant, sleep, sleep_until};

/// First and longest wait before a port is tried again (FB9).
const BACK_OFF: [Duration; 2] = [Duration::from_millis(100), Duration::from_secs(1)];
/// A line that took nothing for this long on board is blocked (FB11).
const WRITE_TIMEOUT: Duration = Duration::from_secs(1);
/// Seconds on board of line that the system may hold back before it counts as blocked.
const HELD_BACK: f64 = 0.3;
/// Between two looks whether the system still holds back, on board.
const LOOK_AGAIN: Duration = Duration::from_millis(50);
/// Bytes a second that are read of one port: 270 times what 38,400 baud carry.
const READ_AT_MOST: f64 = 1_048_576.0;
/// Bytes that may come at once, as when a recording is played into a line.
const AT_ONCE: f64 = 262_144.0;
/// So long after it was held back a line still counts as one that floods.
const FLOODED_FOR: Duration = Duration::from_secs(1);

/// Our end of a port: what its task works with.
pub(super) struct End {
    pub(super) port: Port,
    /// Contacts that are read at it.
    pub(super) contacts: Contacts,
    pub(super) link: Link,
    pub(super) inlet: Inlet,
    /// How fast ship's time runs.
    pub(super) tempo: Tempo,
}

/// Runs a port, for ever.
pub(super) async fn run(mut end: End, mut opened: Option<Opened>) {
    let mut wait = BACK_OFF[0];
    let mut came = false;
    loop {
        let now = match opened.take() {
            Some(opened) => Ok(opened),
            None => open::open(&end.port.place, end.tempo).await,
        };
        match now {
            Ok(Opened::Wire(wire)) => {
                (wait, came) = (BACK_OFF[0], true);
                let lost = converse(wire, &mut end).await;
                say(&end.link, lost_words(&lost));
            }
            Ok(Opened::Listener(listener)) => {
                wait = BACK_OFF[0];
                serve(&listener, &mut end).await;
            }
            Ok(Opened::Recording(path)) => {
                let played = playback::play(&path, &end.link, &end.inlet, end.tempo).await;
                let words = match played {
                    Ok(()) => "end of the recording".to_owned(),
                    Err(error) => reason(&error),
                };
                return say(&end.link, words);
            }
            Err(failure) => {
                // One that was never there is gone too (FD9); what came and went has said so.
                if !std::mem::replace(&mut came, true) {
                    end.inlet.port_up(&end.link, false);
                }
                say(&end.link, failure.text);
            }
        }
        end.contacts.look(None, &end.inlet);
        sleep(wait).await;
        wait = (wait * 2).min(BACK_OFF[1]);
    }
}

fn lost_words(error: &io::Error) -> String {
    match error.kind() {
        io::ErrorKind::UnexpectedEof => "unplugged".to_owned(),
        _ => reason(error),
    }
}

/// One client at a time: who came first keeps the line until it is lost.
async fn serve(listener: &TcpListener, end: &mut End) {
    end.inlet.port_up(&end.link, false);
    say(&end.link, "nobody has called".to_owned());
    loop {
        let Ok((stream, _)) = listener.accept().await else {
            sleep(BACK_OFF[0]).await;
            continue;
        };
        open::prepare(&stream);
        let turn_away = async {
            loop {
                match listener.accept().await {
                    Ok(second) => drop(second),
                    Err(_) => sleep(BACK_OFF[0]).await,
                }
            }
        };
        tokio::select! {
            lost = converse(Wire::Tcp(stream), end) => {
                let words = match lost.kind() {
                    io::ErrorKind::UnexpectedEof => "the other side hung up".to_owned(),
                    _ => reason(&lost),
                };
                say(&end.link, words);
            }
            () = turn_away => {}
        }
    }
}

/// Moves bytes both ways until the line is lost; says why.
async fn converse(mut wire: Wire, end: &mut End) -> io::Error {
    end.inlet.port_up(&end.link, true);
    if end.link.set_trouble(Trouble::None) {
        tracing::info!("port {} is there", end.link.name);
    }
    let lost = move_bytes(&mut wire, end).await;
    end.inlet.port_up(&end.link, false);
    lost
}

async fn move_bytes(wire: &mut Wire, end: &mut End) -> io::Error {
    let End {
        port,
        contacts,
        link,
        inlet,
        tempo,
    } = end;
    let (link, inlet, tempo) = (&*link, &*inlet, *tempo);
    let mut buffer = [0; 1024];
    let mut line: Vec<u8> = Vec::new();
    let mut pace = Pace::new(&port.place, tempo);
    let mut flood = Flood::new();
    let mut stood = Stood::new(tempo);
    loop {
        stood.look();
        let writing = !line.is_empty();
        tokio::select! {
            moved = std::future::poll_fn(|cx| {
                let buffer = flood.reads().then_some(&mut buffer[..]);
                wire.poll(cx, buffer, &line)
            }) => match moved {
                Ok(Moved::Read(_)) if stood.look() => {} // FA16: it was said long ago
                Ok(Moved::Read(count)) => flood.hear(&buffer[..count], link, inlet),
                Ok(Moved::Written(count)) => {
                    line.drain(..count);
                    pace.wrote(count);
                    if line.is_empty() && !pace.blocked(wire) {
                        link.end_trouble(&Trouble::Blocked);
                    }
                }
                Err(error) => return error,
            },
            () = sleep(stood.wait()) => {}
            () = contacts.due(), if !contacts.is_empty() => {
                contacts.look(wire.control_lines(), inlet);
            },
            () = sleep_until(flood.pause), if !flood.reads() => {}
            () = sleep_until(pace.deadline), if writing => {
                // What is left of it is too old; the other side skips the damaged sentence.
                trouble(link, Trouble::Blocked);
                wire.discard();
                line = b"\r\n".to_vec();
                pace.wrote(0);
            },
            () = sleep_until(pace.free), if !writing && !pace.is_free() => {
                if pace.blocked(wire) {
                    if pace.stuck() {
                        trouble(link, Trouble::Blocked);
                        wire.discard();
                    }
                    pace.free = Instant::now() + tempo.wall(LOOK_AGAIN);
                }
            },
            next = next(link, tempo), if !writing && pace.is_free() => {
                line = next;
                pace.deadline = Instant::now() + pace.patience;
            },
        }
    }
}

/// The next sentence to send; never where nothing may leave the port.
async fn next(link: &Link, tempo: Tempo) -> Vec<u8> {
    match &link.outbox {
        Some(outbox) => outbox.next(tempo.wall(OLDEST)).await,
        None => std::future::pending().await,
    }
}

/// A line that brings more than any line carries is read no faster, so that other ports and the pages keep the
/// machine (AP-25). That is said until it was not so for a second.
struct Flood {
    /// Bytes that may still be read at once; below zero they are owed.
    left: f64,
    /// When that was so.
    since: Instant,
    /// When the line was last held back, or bytes were lost.
    held: Option<Instant>,
    /// Until when nothing is read.
    pause: Instant,
}

impl Flood {
    fn new() -> Self {
        let now = Instant::now();
        Self {
            left: AT_ONCE,
            since: now,
            held: None,
            pause: now,
        }
    }

    fn reads(&self) -> bool {
        self.pause <= Instant::now()
    }

    /// How long nothing may be read after so many bytes.
    fn wait(&mut self, count: usize, now: Instant) -> Duration {
        let fresh = now.duration_since(self.since).as_secs_f64() * READ_AT_MOST;
        self.since = now;
        self.left = (self.left + fresh).min(AT_ONCE) - count as f64;
        Duration::from_secs_f64((-self.left).max(0.0) / READ_AT_MOST)
    }

    fn hear(&mut self, bytes: &[u8], link: &Link, inlet: &Inlet) {
        let now = Instant::now();
        let wait = self.wait(bytes.len(), now);
        self.pause = now + wait;
        if !inlet.hear(link, bytes.to_vec()) || !wait.is_zero() {
            self.held = Some(now);
            trouble(link, Trouble::Flooded);
        } else if self.held.is_some_and(|held| now - held > FLOODED_FOR) {
            self.held = None;
            link.end_trouble(&Trouble::Flooded);
        }
    }
}

/// Says why a port is not there.
fn say(link: &Link, reason: String) {
    trouble(link, Trouble::Away(reason));
}

fn trouble(link: &Link, trouble: Trouble) {
    let text = trouble.to_string();
    if link.set_trouble(trouble) {
        tracing::warn!("port {}: {text}", link.name);
    }
}

/// Keeps the line's own queue, where nothing can be replaced, almost empty.
struct Pace {
    /// Bytes a second; none where there is no line rate.
    rate: Option<f64>,
    /// When the next sentence may be given to the system.
    free: Instant,
    /// Until when the present one has to be taken.
    deadline: Instant,
    /// Since when the system holds bytes back.
    since: Option<Instant>,
    /// How long the line may take nothing.
    patience: Duration,
    /// Bytes that the system may hold back.
    held_back: f64,
}

impl Pace {
    fn new(place: &Place, tempo: Tempo) -> Self {
        let now = Instant::now();
        let on_board = match place {
            Place::Serial(_, baud) => Some(f64::from(*baud) / 10.0),
            _ => None,
        };
        Self {
            rate: on_board.map(|rate| rate * tempo.rate()),
            free: now,
            deadline: now,
            since: None,
            patience: tempo.wall(WRITE_TIMEOUT),
            held_back: HELD_BACK * on_board.unwrap_or(f64::INFINITY),
        }
    }

    fn is_free(&self) -> bool {
        self.free <= Instant::now()
    }

    fn wrote(&mut self, count: usize) {
        let now = Instant::now();
        self.deadline = now + self.patience;
        if let Some(rate) = self.rate {
            self.free = self.free.max(now) + Duration::from_secs_f64(count as f64 / rate);
        }
    }

    /// Whether the system holds back more than the line would have carried by now.
    fn blocked(&mut self, wire: &Wire) -> bool {
        let held = f64::from(wire.held_back());
        let blocked = held > self.held_back;
        if !blocked {
            self.since = None;
        } else if self.since.is_none() {
            self.since = Some(Instant::now());
        }
        blocked
    }

    fn stuck(&self) -> bool {
        self.since
            .is_some_and(|since| since.elapsed() >= self.patience)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_line_is_read_up_to_a_rate_that_no_line_has() {
        let mut flood = Flood::new();
        let mut now = flood.since;
        // Ten seconds of 38,400 baud, and a recording at once.
        for _ in 0..1_000 {
            now += Duration::from_millis(10);
            assert_eq!(flood.wait(39, now), Duration::ZERO);
        }
        now += Duration::from_secs(1);
        assert_eq!(flood.wait(262_144, now), Duration::ZERO);
        // Without end: as long as it may take, and no longer.
        let began = now;
        for _ in 0..3 * 1_024 {
            now += flood.wait(1_024, now);
        }
        let took = (now - began).as_secs_f64();
        assert!((2.9..3.1).contains(&took), "{took}");
    }
}

//! One task a port: opens it, moves bytes until it is lost, and opens it again.

use super::open::{self, Opened};
use super::wire::{Moved, Wire};
use super::{Link, playback};
use crate::config::{Place, Port};
use crate::control::{Control, Input};
use crate::error::reason;
use crate::http::stopped;
use std::io;
use std::time::Duration;
use tokio::net::TcpListener;
use tokio::sync::watch;
use tokio::time::{Instant, sleep, sleep_until};

/// First and longest wait before a port is tried again (FB9).
const BACK_OFF: [Duration; 2] = [Duration::from_millis(100), Duration::from_secs(1)];
/// A line that took nothing for this long is blocked (FB11).
const WRITE_TIMEOUT: Duration = Duration::from_secs(1);
/// Seconds of line that the system may hold back before it counts as blocked.
const HELD_BACK: f64 = 0.3;
/// What is said of a line that brings more than can be taken.
const FLOODED: &str = "too much heard at once: some was lost";
/// What is said of a line that does not take its output.
const BLOCKED: &str = "output blocked: the other side does not read";

/// Runs a port until `stop` is raised.
pub(super) async fn run(
    port: Port,
    opened: Option<Opened>,
    link: Link,
    control: Control,
    mut stop: watch::Receiver<bool>,
) {
    tokio::select! {
        () = keep(&port, opened, &link, &control) => {}
        () = stopped(&mut stop) => {}
    }
}

async fn keep(port: &Port, mut opened: Option<Opened>, link: &Link, control: &Control) {
    let mut wait = BACK_OFF[0];
    loop {
        let now = match opened.take() {
            Some(opened) => Ok(opened),
            None => open::open(&port.place).await,
        };
        match now {
            Ok(Opened::Wire(wire)) => {
                wait = BACK_OFF[0];
                let lost = converse(wire, port, link, control).await;
                link.set_trouble(&lost_words(&lost));
            }
            Ok(Opened::Listener(listener)) => {
                wait = BACK_OFF[0];
                serve(&listener, port, link, control).await;
            }
            Ok(Opened::Recording(path)) => {
                let played = playback::play(&path, link, control).await;
                link.set_trouble(&match played {
                    Ok(()) => "end of the recording".to_owned(),
                    Err(error) => reason(&error),
                });
                return;
            }
            Err(failure) => link.set_trouble(&failure.text),
        }
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
async fn serve(listener: &TcpListener, port: &Port, link: &Link, control: &Control) {
    link.set_trouble("nobody has called");
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
            lost = converse(Wire::Tcp(stream), port, link, control) => {
                let words = match lost.kind() {
                    io::ErrorKind::UnexpectedEof => "the other side hung up".to_owned(),
                    _ => reason(&lost),
                };
                link.set_trouble(&words);
            }
            () = turn_away => {}
        }
    }
}

/// Moves bytes both ways until the line is lost; says why.
async fn converse(mut wire: Wire, port: &Port, link: &Link, control: &Control) -> io::Error {
    control.port_up(link.index, true).await;
    link.set_trouble("");
    let lost = move_bytes(&mut wire, port, link, control).await;
    control.port_up(link.index, false).await;
    lost
}

async fn move_bytes(wire: &mut Wire, port: &Port, link: &Link, control: &Control) -> io::Error {
    let mut buffer = [0; 1024];
    let mut line: Vec<u8> = Vec::new();
    let mut pace = Pace::new(&port.place);
    loop {
        let writing = !line.is_empty();
        tokio::select! {
            moved = std::future::poll_fn(|cx| wire.poll(cx, &mut buffer, &line)) => match moved {
                Ok(Moved::Read(count)) => {
                    let bytes = buffer[..count].to_vec();
                    hear(bytes, link, control);
                }
                Ok(Moved::Written(count)) => {
                    line.drain(..count);
                    pace.wrote(count);
                    if line.is_empty() && link.trouble() == BLOCKED && !pace.blocked(wire) {
                        link.set_trouble("");
                    }
                }
                Err(error) => return error,
            },
            () = sleep_until(pace.deadline), if writing => {
                // What is left of it is too old; the other side skips the damaged sentence.
                link.set_trouble(BLOCKED);
                wire.discard();
                line = b"\r\n".to_vec();
                pace.wrote(0);
            },
            () = sleep_until(pace.free), if !writing && !pace.is_free() => {
                if pace.blocked(wire) {
                    if pace.stuck() {
                        link.set_trouble(BLOCKED);
                        wire.discard();
                    }
                    pace.free = Instant::now() + Duration::from_millis(50);
                }
            },
            next = link.outbox.next(), if !writing && pace.is_free() => {
                line = next;
                pace.deadline = Instant::now() + WRITE_TIMEOUT;
            },
        }
    }
}

/// Bytes beyond what the control thread takes are lost, and that is said until some are taken again.
fn hear(bytes: Vec<u8>, link: &Link, control: &Control) {
    let port = link.index;
    if !control.offer(Input::Bytes { port, bytes }) {
        link.set_trouble(FLOODED);
    } else if link.trouble() == FLOODED {
        link.set_trouble("");
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
}

impl Pace {
    fn new(place: &Place) -> Self {
        let now = Instant::now();
        Self {
            rate: match place {
                Place::Serial(_, baud) => Some(f64::from(*baud) / 10.0),
                _ => None,
            },
            free: now,
            deadline: now,
            since: None,
        }
    }

    fn is_free(&self) -> bool {
        self.free <= Instant::now()
    }

    fn wrote(&mut self, count: usize) {
        let now = Instant::now();
        self.deadline = now + WRITE_TIMEOUT;
        if let Some(rate) = self.rate {
            self.free = self.free.max(now) + Duration::from_secs_f64(count as f64 / rate);
        }
    }

    /// Whether the system holds back more than the line would have carried by now.
    fn blocked(&mut self, wire: &Wire) -> bool {
        let held = f64::from(wire.held_back());
        let blocked = self.rate.is_some_and(|rate| held > HELD_BACK * rate);
        if !blocked {
            self.since = None;
        } else if self.since.is_none() {
            self.since = Some(Instant::now());
        }
        blocked
    }

    fn stuck(&self) -> bool {
        self.since
            .is_some_and(|since| since.elapsed() >= WRITE_TIMEOUT)
    }
}

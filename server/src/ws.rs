//! One client on the WebSocket: hello first, then what it follows; commands up, answers down.
//!
//! **Invariant:** a client that does not read holds nothing up and is closed within ten seconds (FC3), and
//! nothing longer than 16 KiB is taken from one (FC11).

use crate::bus::{Asked, Inlet, Place};
use crate::feed::{Feed, Seen, Shown, encode};
use crate::window::Window;
use axum::body::Bytes;
use axum::extract::ws::{CloseFrame, Message, Utf8Bytes, WebSocket, WebSocketUpgrade, close_code};
use futures_util::SinkExt;
use std::sync::Arc;
use std::time::{Duration, Instant};
use tokio::sync::{Semaphore, mpsc, watch};
use tokio::time::timeout;
use tokio_util::sync::CancellationToken;
use wheelover_core::view::{Answer, Down, ModeRequest, Order, Up};

/// Longest message taken.
const LONGEST: usize = 16 * 1024;
/// A message that cannot be handed over in this time ends the connection.
const SEND_TIMEOUT: Duration = Duration::from_secs(8);
/// Between two questions whether the client is still there.
const PING: Duration = Duration::from_secs(3);
/// A client that was silent for this long is gone (FC5).
const SILENCE: Duration = Duration::from_secs(9);
/// Frames a second that a client may send; far more than any page does.
const FRAMES: u32 = 200;
/// Orders of one client that may wait for their answer; STANDBY is not counted.
const ORDERS: usize = 64;
/// The first lines wait this long for the client to say from where it wants them.
const GRACE: Duration = Duration::from_millis(200);
/// As [`GRACE`], for a client that has said that it will: a page on a slow tablet shows its first values before it asks.
const LONG_GRACE: Duration = Duration::from_secs(15);
/// What is gathered before it is written: the lines and the snapshot of a tick leave together.
const GATHERED: usize = 64 * 1024;

/// What a client may command.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Rights {
    /// Everything.
    All,
    /// Nothing: it may look.
    Look,
}

/// What one client is served from.
#[derive(Debug)]
pub(crate) struct Source {
    /// The way to the control thread.
    pub(crate) inlet: Inlet,
    /// What pages are told.
    pub(crate) feed: Arc<Feed>,
    /// Cancelled when the server ends.
    pub(crate) stop: CancellationToken,
    /// What the client may command.
    pub(crate) rights: Rights,
    /// Whether the client has said that it will say from where it wants lines (`/ws?lines=resumed`).
    pub(crate) will_resume: bool,
}

/// Limits of every connection: small buffers, so that a thousand clients take little (FC2).
pub(crate) fn limit(upgrade: WebSocketUpgrade) -> WebSocketUpgrade {
    upgrade
        .read_buffer_size(4 * 1024)
        .write_buffer_size(GATHERED)
        .max_write_buffer_size(1024 * 1024)
        .max_message_size(LONGEST)
        .max_frame_size(LONGEST)
}

/// Serves one client to its end.
pub(crate) async fn serve(socket: WebSocket, source: Source) {
    let grace = if source.will_resume {
        LONG_GRACE
    } else {
        GRACE
    };
    let now = Instant::now();
    let (answer, answers) = mpsc::unbounded_channel();
    let mut client = Client {
        socket,
        source,
        window: Window::default(),
        wants_lines: true,
        next: 0,
        lines_from: now + grace,
        seen: Seen::default(),
        frame: 0,
        heard: now,
        second: now,
        frames: 0,
        orders: Arc::new(Semaphore::new(ORDERS)),
        answer,
    };
    if let End::Close(code, reason) = client.follow(answers).await {
        let frame = CloseFrame {
            code,
            reason: Utf8Bytes::from_static(reason),
        };
        let closing = client.socket.send(Message::Close(Some(frame)));
        let _ = timeout(Duration::from_secs(1), closing).await;
    }
}

/// How a connection ends.
enum End {
    /// The other side is gone.
    Gone,
    /// We end it, and say why.
    Close(u16, &'static str),
}

/// Whether a client has everything that there is for it.
#[derive(PartialEq, Eq)]
enum Caught {
    Up,
    Behind,
}

struct Client {
    socket: WebSocket,
    source: Source,
    window: Window,
    wants_lines: bool,
    /// Number of the next line for this client.
    next: u64,
    /// When the first lines go.
    lines_from: Instant,
    /// Documents that it has.
    seen: Seen,
    /// Number of the last snapshot that it was sent.
    frame: u64,
    heard: Instant,
    second: Instant,
    frames: u32,
    /// Places of its orders.
    orders: Arc<Semaphore>,
    /// Where the answers to them go.
    answer: mpsc::UnboundedSender<Answer>,
}

impl Client {
    async fn follow(&mut self, answers: mpsc::UnboundedReceiver<Answer>) -> End {
        match self.converse(answers).await {
            Err(end) => end,
            Ok(never) => match never {},
        }
    }

    async fn converse(
        &mut self,
        mut answers: mpsc::UnboundedReceiver<Answer>,
    ) -> Result<std::convert::Infallible, End> {
        let mut shown = self.source.feed.follow();
        self.frame = shown.borrow_and_update().frame.number;
        let Some(mut hello) = self.source.inlet.hello().await else {
            return Err(End::Close(close_code::AGAIN, "the control loop has ended"));
        };
        hello.may_command = self.source.rights == Rights::All;
        self.next = hello.line + 1;
        self.say(encode(&Down::Hello(hello))).await?;
        let mut ping = tokio::time::interval(PING);
        let stop = self.source.stop.clone();
        loop {
            let caught = self.catch_up(&mut shown).await?;
            self.flush().await?;
            // In the order of their weight: an answer waits behind no backlog of lines (AP-25).
            tokio::select! {
                biased;
                () = stop.cancelled() => return Err(End::Close(close_code::AWAY, "the server ends")),
                Some(answer) = answers.recv() => self.say(encode(&Down::Answer(answer))).await?,
                heard = self.socket.recv() => match heard {
                    Some(Ok(message)) => self.take(message)?,
                    Some(Err(error)) => return Err(broken(error)),
                    None => return Err(End::Gone),
                },
                changed = shown.changed(), if caught == Caught::Up => {
                    changed.map_err(|_| End::Gone)?;
                }
                () = std::future::ready(()), if caught == Caught::Behind => {}
                _ = ping.tick() => {
                    if self.heard.elapsed() > SILENCE {
                        return Err(End::Gone);
                    }
                    self.put(Message::Ping(Bytes::new())).await?;
                }
            }
        }
    }

    /// Puts down what there is for this client: documents, then lines, then the snapshot that goes with them.
    async fn catch_up(&mut self, shown: &mut watch::Receiver<Shown>) -> Result<Caught, End> {
        let now = Instant::now();
        let (frame, documents) = {
            let shown = shown.borrow_and_update();
            let documents: Vec<_> = std::iter::from_fn(|| shown.unseen(&mut self.seen)).collect();
            (shown.frame.clone(), documents)
        };
        for document in documents {
            self.say(Some(document)).await?;
        }
        if self.wants_lines
            && self.lines_from <= now
            && self.next <= frame.line
            && let Some((text, next)) = self.source.feed.lines(self.next, frame.line)
        {
            self.say(Some(text)).await?;
            self.next = next;
            if next <= frame.line {
                return Ok(Caught::Behind);
            }
        }
        let opens = self.window.opens(now);
        if frame.number > self.frame && opens.is_some_and(|opens| opens <= now) {
            self.frame = frame.number;
            self.window.sent(frame.number, now);
            self.say(Some(frame.text)).await?;
        }
        Ok(Caught::Up)
    }

    fn take(&mut self, message: Message) -> Result<(), End> {
        self.heard = Instant::now();
        if self.second.elapsed() >= Duration::from_secs(1) {
            self.second = self.heard;
            self.frames = 0;
        }
        self.frames += 1;
        if self.frames > FRAMES {
            return Err(End::Close(close_code::POLICY, "too many frames"));
        }
        let text = match message {
            Message::Text(text) => text,
            Message::Binary(_) => return Err(End::Close(close_code::UNSUPPORTED, "text only")),
            Message::Close(_) => return Err(End::Gone),
            Message::Ping(_) | Message::Pong(_) => return Ok(()),
        };
        match serde_json::from_str::<Up>(&text) {
            Ok(Up::Ack { frame }) => self.window.acknowledge(frame),
            Ok(Up::Resume { seq }) => {
                self.next = seq;
                self.lines_from = self.heard;
            }
            Ok(Up::Subscribe { rate, lines }) => {
                self.window.set_rate(rate);
                self.wants_lines = lines;
            }
            Ok(Up::Command { id, frame, action }) => self.order(id, frame, action),
            Err(error) => match command_number(&text) {
                Some(id) => self.refuse(id, &format!("not understood: {error}")),
                None => return Err(End::Close(close_code::INVALID, "not understood")),
            },
        }
        Ok(())
    }

    /// Gives an order to the control thread; its answer comes by itself.
    fn order(&mut self, id: u64, frame: Option<u64>, action: Order) {
        if self.source.rights == Rights::Look {
            let text = "this page may only look: commands are taken on the ship's own computer";
            return self.refuse(id, text);
        }
        let place = self.place();
        if place.is_none() && !is_standby(&action) {
            return self.refuse(id, "busy: not done");
        }
        let asked = Asked::Order {
            id,
            frame,
            action,
            answer: self.answer.clone(),
            place,
        };
        if self.source.inlet.ask(asked).is_err() {
            self.refuse(id, "the control loop has ended: not done");
        }
    }

    fn place(&self) -> Option<Place> {
        self.orders.clone().try_acquire_owned().ok()
    }

    fn refuse(&self, id: u64, text: &str) {
        let _ = self.answer.send(Answer {
            id,
            ok: false,
            text: text.to_owned(),
        });
    }

    async fn say(&mut self, text: Option<Utf8Bytes>) -> Result<(), End> {
        match text {
            Some(text) => self.put(Message::Text(text)).await,
            None => Ok(()),
        }
    }

    /// Puts a message down; it leaves with the next flush.
    async fn put(&mut self, message: Message) -> Result<(), End> {
        handed_over(timeout(SEND_TIMEOUT, self.socket.feed(message)).await)
    }

    async fn flush(&mut self) -> Result<(), End> {
        handed_over(timeout(SEND_TIMEOUT, self.socket.flush()).await)
    }
}

fn handed_over<T, E>(done: Result<Result<(), T>, E>) -> Result<(), End> {
    match done {
        Ok(Ok(())) => Ok(()),
        Ok(Err(_)) | Err(_) => Err(End::Gone),
    }
}

/// STANDBY is never refused for want of a place (AP-25).
fn is_standby(action: &Order) -> bool {
    matches!(action, Order::Mode(ModeRequest::Standby))
}

/// Why nothing more is heard: too long, damaged, or gone.
fn broken(error: axum::Error) -> End {
    use tungstenite::Error as Broken;
    match error.into_inner().downcast_ref::<Broken>() {
        Some(Broken::Capacity(_)) => End::Close(close_code::SIZE, "longer than 16 KiB"),
        Some(Broken::Protocol(_)) => End::Close(close_code::PROTOCOL, "not a frame"),
        Some(Broken::Utf8(_)) => End::Close(close_code::INVALID, "not text"),
        _ => End::Gone,
    }
}

/// The number of a command that is otherwise not understood.
fn command_number(text: &str) -> Option<u64> {
    let value: serde_json::Value = serde_json::from_str(text).ok()?;
    (value.get("type")?.as_str()? == "command").then(|| value.get("id")?.as_u64())?
}

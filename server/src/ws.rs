//! One client on the WebSocket: hello first, then what it follows; commands up, answers down.
//!
//! **Invariant:** a client that does not read holds nothing up and is closed within ten seconds (FC3), and
//! nothing longer than 16 KiB is taken from one (FC11).

use crate::control::{Control, Input};
use crate::feed::{Feed, Frame, encode};
use crate::http::stopped;
use crate::window::Window;
use axum::extract::ws::{CloseFrame, Message, Utf8Bytes, WebSocket, WebSocketUpgrade, close_code};
use std::sync::Arc;
use std::time::{Duration, Instant};
use tokio::sync::{mpsc, oneshot, watch};
use tokio::time::{sleep_until, timeout};
use wheelover_core::view::{Answer, Down, Order, Up};

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
/// Answers that may wait for one client.
const ANSWERS: usize = 64;
/// The first lines wait this long for the client to say from where it wants them.
const GRACE: Duration = Duration::from_millis(200);
/// As [`GRACE`], for a client that has said that it will: a page on a slow tablet shows its first values before it asks.
const LONG_GRACE: Duration = Duration::from_secs(15);

/// What a client may command.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Rights {
    /// Everything.
    All,
    /// Nothing: it may look.
    Look,
}

/// What one client is served from.
#[derive(Debug)]
pub struct Source {
    /// The control thread.
    pub control: Control,
    /// What pages are told.
    pub feed: Arc<Feed>,
    /// Raised when the server ends.
    pub stop: watch::Receiver<bool>,
    /// What the client may command.
    pub rights: Rights,
    /// Whether the client has said that it will say from where it wants lines (`/ws?lines=resumed`).
    pub will_resume: bool,
}

/// Limits of every connection: small buffers, so that a thousand clients take little (FC2).
pub fn limit(upgrade: WebSocketUpgrade) -> WebSocketUpgrade {
    upgrade
        .read_buffer_size(4 * 1024)
        .write_buffer_size(0)
        .max_write_buffer_size(1024 * 1024)
        .max_message_size(LONGEST)
        .max_frame_size(LONGEST)
}

/// Serves one client to its end.
pub async fn serve(socket: WebSocket, source: Source) {
    let grace = if source.will_resume {
        LONG_GRACE
    } else {
        GRACE
    };
    let mut client = Client {
        socket,
        window: Window::default(),
        wants_lines: true,
        next: 0,
        lines_from: Instant::now() + grace,
        heard: Instant::now(),
        second: Instant::now(),
        frames: 0,
    };
    let reason = client.converse(source).await;
    if let End::Close(code, reason) = reason {
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

struct Client {
    socket: WebSocket,
    window: Window,
    wants_lines: bool,
    /// Number of the next line for this client.
    next: u64,
    /// When the first lines go.
    lines_from: Instant,
    heard: Instant,
    second: Instant,
    frames: u32,
}

impl Client {
    async fn converse(&mut self, mut source: Source) -> End {
        match self.follow(&mut source).await {
            Ok(()) => End::Gone,
            Err(end) => end,
        }
    }

    async fn follow(&mut self, source: &mut Source) -> Result<(), End> {
        let mut follower = source.feed.follow();
        let Some(mut hello) = source.control.hello().await else {
            return Err(End::Close(close_code::AGAIN, "busy"));
        };
        hello.may_command = source.rights == Rights::All;
        self.next = hello.line + 1;
        self.say(encode(&Down::Hello(hello))).await?;
        self.document(&mut follower.route).await?;
        self.document(&mut follower.settings).await?;
        self.document(&mut follower.ports).await?;
        let (answer, mut answers) = mpsc::channel::<Answer>(ANSWERS);
        let mut ping = tokio::time::interval(PING);
        let mut stop = source.stop.clone();
        loop {
            let opens = self.window.opens(Instant::now());
            let lines_from = self.lines_from;
            tokio::select! {
                heard = self.socket.recv() => {
                    let Some(Ok(message)) = heard else { return Err(ended(heard)) };
                    self.take(message, source, &answer).await?;
                }
                Ok(()) = newest(&mut follower.snapshot, opens), if opens.is_some() => {
                    let frame = follower.snapshot.borrow_and_update().clone();
                    self.window.sent(frame.number, Instant::now());
                    if self.wants_lines && self.lines_from <= Instant::now() {
                        self.lines(source, frame.line).await?;
                    }
                    self.say(Some(frame.text)).await?;
                }
                Ok(()) = lines(&mut follower.next, lines_from), if self.wants_lines => {
                    self.lines(source, u64::MAX).await?;
                }
                Ok(()) = follower.route.changed() => self.document(&mut follower.route).await?,
                Ok(()) = follower.settings.changed() => self.document(&mut follower.settings).await?,
                Ok(()) = follower.ports.changed() => self.document(&mut follower.ports).await?,
                Some(answer) = answers.recv() => self.say(encode(&Down::Answer(answer))).await?,
                _ = ping.tick() => {
                    if self.heard.elapsed() > SILENCE {
                        return Err(End::Gone);
                    }
                    self.send(Message::Ping(axum::body::Bytes::new())).await?;
                }
                () = stopped(&mut stop) => return Err(End::Close(close_code::AWAY, "the server ends")),
            }
        }
    }

    /// A document as it is now; nothing while there is none.
    async fn document(&mut self, document: &mut watch::Receiver<Utf8Bytes>) -> Result<(), End> {
        let text = document.borrow_and_update().clone();
        if text.is_empty() {
            return Ok(());
        }
        self.say(Some(text)).await
    }

    /// Lines from where the client stands, as far as batches that begin by `last`.
    async fn lines(&mut self, source: &Source, last: u64) -> Result<(), End> {
        while self.next <= last
            && let Some((text, next)) = source.feed.lines(self.next, last)
        {
            self.say(Some(text)).await?;
            self.next = next;
        }
        Ok(())
    }

    async fn take(
        &mut self,
        message: Message,
        source: &Source,
        answers: &mpsc::Sender<Answer>,
    ) -> Result<(), End> {
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
                if self.wants_lines {
                    self.lines(source, u64::MAX).await?;
                }
            }
            Ok(Up::Subscribe { rate, lines }) => {
                self.window.set_rate(rate);
                self.wants_lines = lines;
            }
            Ok(Up::Command { id, action }) => {
                command(id, action, source, answers);
            }
            Err(error) => match command_number(&text) {
                Some(id) => refuse(answers, id, &format!("not understood: {error}")),
                None => return Err(End::Close(close_code::INVALID, "not understood")),
            },
        }
        Ok(())
    }

    async fn say(&mut self, text: Option<Utf8Bytes>) -> Result<(), End> {
        match text {
            Some(text) => self.send(Message::Text(text)).await,
            None => Ok(()),
        }
    }

    async fn send(&mut self, message: Message) -> Result<(), End> {
        match timeout(SEND_TIMEOUT, self.socket.send(message)).await {
            Ok(Ok(())) => Ok(()),
            Ok(Err(_)) | Err(_) => Err(End::Gone),
        }
    }
}

/// Waits for a snapshot that this client has not seen, not before the window opens.
async fn newest(snapshot: &mut watch::Receiver<Frame>, opens: Option<Instant>) -> Result<(), ()> {
    if let Some(opens) = opens {
        sleep_until(opens.into()).await;
    }
    snapshot.changed().await.map_err(|_| ())
}

/// Waits for lines, the first ones not before their time.
async fn lines(next: &mut watch::Receiver<u64>, from: Instant) -> Result<(), ()> {
    sleep_until(from.into()).await;
    next.changed().await.map_err(|_| ())
}

/// Why nothing more is heard: too long or damaged, or gone.
fn ended(heard: Option<Result<Message, axum::Error>>) -> End {
    match heard {
        Some(Err(error)) if error.to_string().contains("too") => {
            End::Close(close_code::SIZE, "longer than 16 KiB")
        }
        Some(Err(_)) => End::Close(close_code::PROTOCOL, "not a frame"),
        _ => End::Gone,
    }
}

/// Gives a command to the control thread; its answer comes by itself.
fn command(id: u64, action: Order, source: &Source, answers: &mpsc::Sender<Answer>) {
    if source.rights == Rights::Look {
        let text = "this page may only look: commands are taken on the ship's own computer";
        return refuse(answers, id, text);
    }
    let (sender, receiver) = oneshot::channel();
    let input = Input::Command {
        action,
        answer: sender,
    };
    if !source.control.offer(input) {
        return refuse(answers, id, "busy: not done");
    }
    let answers = answers.clone();
    tokio::spawn(async move {
        if let Ok(answer) = receiver.await {
            let _ = answers.send(Answer { id, ..answer }).await;
        }
    });
}

fn refuse(answers: &mpsc::Sender<Answer>, id: u64, text: &str) {
    let _ = answers.try_send(Answer {
        id,
        ok: false,
        text: text.to_owned(),
    });
}

/// The number of a command that is otherwise not understood.
fn command_number(text: &str) -> Option<u64> {
    let value: serde_json::Value = serde_json::from_str(text).ok()?;
    (value.get("type")?.as_str()? == "command").then(|| value.get("id")?.as_u64())?
}

//! A client of the WebSocket that does what the page does: folds the lines itself and compares digests.

use futures_util::{SinkExt, StreamExt};
use std::net::SocketAddr;
use std::time::{Duration, Instant};
use tokio::net::TcpStream;
use tokio::time::timeout;
use tokio_tungstenite::tungstenite::Message;
use tokio_tungstenite::{WebSocketStream, client_async};
use wheelover_core::picture::Picture;
use wheelover_core::time::Stamp;
use wheelover_core::view::{
    Answer, Down, Hello, Line, Order, PortsDocument, RouteDocument, SettingsDocument, Snapshot, Up,
};

/// How long anything may take that should come at once.
pub const SOON: Duration = Duration::from_secs(20);

/// A connected client with its own picture.
#[derive(Debug)]
pub struct Page {
    socket: WebSocketStream<TcpStream>,
    /// First frame.
    pub hello: Hello,
    /// Folded from the lines.
    pub picture: Picture,
    /// Number of the last line folded.
    pub line: u64,
    /// Every line heard, in order.
    pub lines: Vec<Line>,
    /// Last snapshot.
    pub snapshot: Option<Snapshot>,
    /// Snapshots whose digest was compared and agreed.
    pub agreed: u64,
    /// Snapshots whose digest differed.
    pub differed: Vec<u64>,
    /// Numbers of lines that were missing.
    pub gaps: Vec<u64>,
    /// The documents.
    pub route: Option<RouteDocument>,
    /// The documents.
    pub settings: Option<SettingsDocument>,
    /// The documents.
    pub ports: Option<PortsDocument>,
    answers: Vec<Answer>,
    /// Whether snapshots are acknowledged.
    pub acknowledges: bool,
    commands: u64,
}

impl Page {
    /// Connects and takes the first frame.
    ///
    /// # Panics
    /// The server refuses, or its first frame is no hello.
    #[allow(clippy::unwrap_used)]
    pub async fn open(address: SocketAddr) -> Self {
        let stream = TcpStream::connect(address).await.unwrap();
        let (mut socket, _) = client_async(format!("ws://{address}/ws"), stream)
            .await
            .unwrap();
        let first = timeout(SOON, socket.next())
            .await
            .unwrap()
            .unwrap()
            .unwrap();
        let Down::Hello(hello) = serde_json::from_str(first.to_text().unwrap()).unwrap() else {
            panic!("the first frame is no hello: {first}");
        };
        Self {
            picture: hello.picture.clone(),
            line: hello.line,
            hello,
            socket,
            lines: Vec::new(),
            snapshot: None,
            agreed: 0,
            differed: Vec::new(),
            gaps: Vec::new(),
            route: None,
            settings: None,
            ports: None,
            answers: Vec::new(),
            acknowledges: true,
            commands: 0,
        }
    }

    /// Goes away: the connection is closed, what was folded is kept.
    pub async fn leave(mut self) -> Self {
        let _ = self.socket.close(None).await;
        self
    }

    /// The same page on a new connection, from the line after its last one.
    pub async fn come_back(self, address: SocketAddr) -> Self {
        let mut fresh = Self::open(address).await;
        fresh.picture = self.picture;
        fresh.line = self.line;
        fresh.lines = self.lines;
        fresh.gaps = self.gaps;
        fresh.say(&Up::Resume { seq: self.line + 1 }).await;
        fresh
    }

    /// Sends a frame.
    ///
    /// # Panics
    /// The connection is closed.
    #[allow(clippy::unwrap_used)]
    pub async fn say(&mut self, up: &Up) {
        let text = serde_json::to_string(up).unwrap();
        self.socket.send(Message::text(text)).await.unwrap();
    }

    /// Sends text as it is; whether it went out.
    pub async fn say_text(&mut self, text: String) -> bool {
        self.socket.send(Message::text(text)).await.is_ok()
    }

    /// Takes one frame; none where the time is over or the connection ended.
    pub async fn next(&mut self, within: Duration) -> Option<Down> {
        let end = Instant::now() + within;
        loop {
            let left = end.saturating_duration_since(Instant::now());
            let message = timeout(left, self.socket.next()).await.ok()??.ok()?;
            if let Message::Text(text) = message {
                let down = serde_json::from_str(&text);
                let down: Down = down.unwrap_or_else(|error| panic!("{error}: {text}"));
                self.take(&down).await;
                return Some(down);
            }
        }
    }

    async fn take(&mut self, down: &Down) {
        match down {
            Down::Lines(lines) => {
                for line in &lines.lines {
                    self.fold(line);
                }
            }
            Down::Snapshot(snapshot) => {
                if snapshot.line == self.line {
                    if self.picture.digest() == snapshot.digest {
                        self.agreed += 1;
                    } else {
                        self.differed.push(snapshot.line);
                    }
                }
                let frame = snapshot.frame;
                self.snapshot = Some(snapshot.clone());
                if self.acknowledges {
                    self.say(&Up::Ack { frame }).await;
                }
            }
            Down::Route(route) => self.route = Some(route.clone()),
            Down::Settings(settings) => self.settings = Some(settings.clone()),
            Down::Ports(ports) => self.ports = Some(ports.clone()),
            Down::Answer(answer) => self.answers.push(answer.clone()),
            Down::Gap { lost } => self.gaps.push(*lost),
            Down::Hello(_) => {}
        }
    }

    fn fold(&mut self, line: &Line) {
        let Line {
            seq: number,
            at,
            port,
            dir,
            text,
        } = line;
        if *number <= self.line {
            return;
        }
        self.gaps.extend(self.line + 1..*number);
        let bytes: Vec<u8> = text.chars().map(|c| c as u8).collect();
        self.picture.fold(Stamp(*at), *port, *dir, &bytes);
        self.line = *number;
        self.lines.push(line.clone());
    }

    /// Follows for a time.
    pub async fn follow(&mut self, time: Duration) {
        let end = Instant::now() + time;
        while Instant::now() < end {
            let left = end.saturating_duration_since(Instant::now());
            self.next(left).await;
        }
    }

    /// Follows until something holds.
    ///
    /// # Panics
    /// It does not hold within that time; `name` says what.
    pub async fn until(&mut self, name: &str, within: Duration, holds: impl Fn(&Self) -> bool) {
        let end = Instant::now() + within;
        while !holds(self) {
            let left = end.saturating_duration_since(Instant::now());
            assert!(
                !left.is_zero(),
                "{name} not within {within:?}: {:?} {:?}",
                self.snapshot,
                self.ports
            );
            self.next(left).await;
        }
    }

    /// Commands and waits for the answer.
    ///
    /// # Panics
    /// None comes within 20 s.
    pub async fn command(&mut self, action: Order) -> Answer {
        self.press(None, action).await
    }

    /// Commands as a page does that showed this frame (AP-26), and waits for the answer.
    ///
    /// # Panics
    /// None comes within 20 s.
    pub async fn press(&mut self, frame: Option<u64>, action: Order) -> Answer {
        self.commands += 1;
        let id = 7_000 + self.commands;
        self.say(&Up::Command { id, frame, action }).await;
        let end = Instant::now() + SOON;
        loop {
            if let Some(answer) = self.answers.iter().find(|answer| answer.id == id) {
                return answer.clone();
            }
            let left = end.saturating_duration_since(Instant::now());
            assert!(!left.is_zero(), "no answer to command {id}");
            self.next(left).await;
        }
    }

    /// Commands until it is done, as an officer tries again.
    ///
    /// # Panics
    /// It is still refused after that time.
    pub async fn insist(&mut self, action: Order, within: Duration) {
        let end = Instant::now() + within;
        loop {
            let answer = self.command(action.clone()).await;
            if answer.ok {
                return;
            }
            assert!(Instant::now() < end, "{action:?}: {}", answer.text);
            self.follow(Duration::from_millis(300)).await;
        }
    }

    /// Sends bytes below the WebSocket, as a client that does not know the protocol.
    ///
    /// # Panics
    /// The connection is gone.
    #[allow(clippy::unwrap_used)]
    pub async fn say_bytes(&mut self, bytes: &[u8]) {
        use tokio::io::AsyncWriteExt;
        self.socket.get_mut().write_all(bytes).await.unwrap();
    }

    /// With which code and words the server closes the connection within that time.
    pub async fn closing(&mut self, within: Duration) -> Option<(u16, String)> {
        let end = Instant::now() + within;
        loop {
            let left = end.saturating_duration_since(Instant::now());
            match timeout(left, self.socket.next()).await.ok()?? {
                Ok(Message::Close(frame)) => {
                    let frame = frame?;
                    return Some((frame.code.into(), frame.reason.to_string()));
                }
                Ok(_) => {}
                Err(_) => return None,
            }
        }
    }

    /// Whether the connection is closed by the server within that time.
    pub async fn closed(&mut self, within: Duration) -> bool {
        let end = Instant::now() + within;
        loop {
            let left = end.saturating_duration_since(Instant::now());
            match timeout(left, self.socket.next()).await {
                Err(_) => return false,
                Ok(None | Some(Err(_) | Ok(Message::Close(_)))) => return true,
                Ok(Some(Ok(_))) => {}
            }
        }
    }
}

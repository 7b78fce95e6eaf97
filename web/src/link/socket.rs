//! The WebSocket to a server: hello, lines and snapshots down; acknowledgements, resume and commands up. Comes back by itself.

use super::frames::read;
use super::source::{Source, receive};
use crate::deck::Deck;
use crate::steady::steady;
use js_sys::Reflect;
use leptos::prelude::*;
use serde::Serialize;
use serde_wasm_bindgen::Serializer;
use std::cell::RefCell;
use std::rc::Rc;
use std::time::Duration;
use wasm_bindgen::closure::Closure;
use wasm_bindgen::{JsCast, JsValue};
use web_sys::{CloseEvent, MessageEvent, WebSocket};
use wheelover_core::view::{Down, Up};

/// First wait before a new connection, milliseconds; doubled up to [`LONGEST_WAIT`].
const FIRST_WAIT: u64 = 250;
/// Longest wait, milliseconds.
const LONGEST_WAIT: u64 = 2_000;
/// A connection without any believed frame for so long is closed and made anew, milliseconds.
const SILENT: f64 = 3_000.0;

/// A connection, and what hears it.
struct Connection {
    socket: WebSocket,
    /// Kept so that they live as long as the socket.
    _message: Closure<dyn FnMut(MessageEvent)>,
    _close: Closure<dyn FnMut(CloseEvent)>,
}

impl Drop for Connection {
    fn drop(&mut self) {
        self.socket.set_onmessage(None);
        self.socket.set_onclose(None);
        // Closing a socket that is closing already is no error worth a word.
        let _closed = self.socket.close();
    }
}

struct State {
    connection: Option<Connection>,
    wait: u64,
    waiting: bool,
    opened: f64,
}

/// A link to the server that this page came from. A copy is a handle.
#[derive(Clone)]
pub(crate) struct Socket {
    deck: Deck,
    state: Rc<RefCell<State>>,
}

impl Socket {
    /// A link that is not open yet.
    pub(crate) fn new(deck: Deck) -> Self {
        let state = State {
            connection: None,
            wait: FIRST_WAIT,
            waiting: false,
            opened: 0.0,
        };
        Self {
            deck,
            state: Rc::new(RefCell::new(state)),
        }
    }

    /// Connects, with what came already while the page was being compiled.
    pub(crate) fn connect(&self) {
        let early = early();
        let Some(socket) = early
            .as_ref()
            .map(|early| early.socket.clone())
            .or_else(dial)
        else {
            self.reopen(LONGEST_WAIT);
            return;
        };
        let deck = self.deck;
        let heard = self.clone();
        let message = Closure::new(move |event: MessageEvent| {
            if let Some(text) = event.data().as_string() {
                heard.hear(&text, steady());
            }
        });
        let ended = self.clone();
        let close = Closure::new(move |_: CloseEvent| {
            let wait = {
                let mut state = ended.state.borrow_mut();
                let wait = state.wait;
                state.wait = (wait * 2).min(LONGEST_WAIT);
                wait
            };
            // What was asked on this connection is answered on no other.
            deck.unanswered();
            ended.reopen(wait);
        });
        socket.set_onmessage(Some(message.as_ref().unchecked_ref()));
        socket.set_onclose(Some(close.as_ref().unchecked_ref()));
        {
            let mut state = self.state.borrow_mut();
            state.opened = steady();
            state.connection = Some(Connection {
                socket,
                _message: message,
                _close: close,
            });
        }
        let Some(early) = early else { return };
        for frame in early.frames.iter() {
            if let Some(text) = frame.as_string() {
                self.hear(&text, early.came);
            }
        }
    }

    /// Drops the connection and opens another one after a wait.
    fn reopen(&self, wait: u64) {
        if std::mem::replace(&mut self.state.borrow_mut().waiting, true) {
            return;
        }
        let jitter = (js_sys::Math::random() * 100.0) as u64;
        let socket = self.clone();
        // Not at once: the socket's own handler may be running.
        set_timeout(
            move || {
                let old = {
                    let mut state = socket.state.borrow_mut();
                    state.waiting = false;
                    state.connection.take()
                };
                drop(old);
                socket.connect();
            },
            Duration::from_millis(wait + jitter),
        );
    }

    fn hear(&self, text: &str, came: f64) {
        match read(text) {
            Some(frame) => {
                if matches!(frame, Down::Hello(_)) {
                    self.state.borrow_mut().wait = FIRST_WAIT;
                }
                receive(self.deck, frame, came);
            }
            None => self.deck.misunderstood(),
        }
    }
}

impl Source for Socket {
    fn say(&mut self, up: &Up) -> bool {
        let state = self.state.borrow();
        let Some(connection) = state.connection.as_ref().filter(|_| !state.waiting) else {
            return false;
        };
        // A socket that is closing swallows what it is given.
        if connection.socket.ready_state() != WebSocket::OPEN {
            return false;
        }
        let text = up
            .serialize(&Serializer::json_compatible())
            .ok()
            .and_then(|up| js_sys::JSON::stringify(&up).ok()?.as_string());
        text.is_some_and(|text| connection.socket.send_with_str(&text).is_ok())
    }

    fn watch(&mut self, silent: Option<u64>) {
        let dead = {
            let state = self.state.borrow();
            let since = steady() - state.opened;
            let silent = silent.map_or(since, |silent| (silent as f64).min(since));
            state.connection.is_some() && !state.waiting && silent > SILENT
        };
        if dead {
            self.reopen(FIRST_WAIT);
        }
    }

    fn renew(&mut self) {
        self.state.borrow_mut().wait = FIRST_WAIT;
        self.reopen(0);
    }
}

/// The socket that was opened while the page was being compiled.
struct Early {
    socket: WebSocket,
    /// What it has heard since.
    frames: js_sys::Array,
    /// When the first of it came, steady milliseconds.
    came: f64,
}

/// Takes the early socket, once.
fn early() -> Option<Early> {
    let name = JsValue::from_str("wheeloverLink");
    let early = Reflect::get(&window(), &name).ok()?;
    Reflect::set(&window(), &name, &JsValue::UNDEFINED).ok()?;
    let part = |name| Reflect::get(&early, &JsValue::from_str(name)).ok();
    let socket: WebSocket = part("socket")?.dyn_into().ok()?;
    let frames = part("frames")?.dyn_into().ok()?;
    let came = part("came")?.as_f64().unwrap_or_else(steady);
    if socket.ready_state() <= WebSocket::OPEN && steady() - came < SILENT {
        return Some(Early {
            socket,
            frames,
            came,
        });
    }
    // What waited for a page that took so long is old: it asks anew.
    socket.set_onmessage(None);
    let _closed = socket.close();
    None
}

fn dial() -> Option<WebSocket> {
    let location = window().location();
    let scheme = if location.protocol().is_ok_and(|p| p == "https:") {
        "wss"
    } else {
        "ws"
    };
    let host = location.host().ok()?;
    WebSocket::new(&format!("{scheme}://{host}/ws?lines=resumed")).ok()
}

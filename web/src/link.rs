//! The WebSocket: hello, lines and snapshots down; acknowledgements, resume and commands up. Comes back by itself.

use crate::deck::Deck;
use js_sys::Reflect;
use leptos::prelude::*;
use serde::Serialize;
use serde::de::DeserializeOwned;
use serde_wasm_bindgen::{Serializer, from_value};
use std::cell::RefCell;
use std::time::Duration;
use wasm_bindgen::closure::Closure;
use wasm_bindgen::{JsCast, JsValue};
use web_sys::{CloseEvent, MessageEvent, WebSocket};
use wheelover_core::view::{
    Answer, Hello, Lines, Order, PortsDocument, RouteDocument, Snapshot, Up,
};

/// First wait before a new connection, milliseconds; doubled up to [`LONGEST_WAIT`].
const FIRST_WAIT: u64 = 250;
/// Longest wait, milliseconds.
const LONGEST_WAIT: u64 = 2_000;
/// A link without any frame for so long is closed and made anew, milliseconds.
const SILENT: f64 = 3_000.0;

struct Socket {
    socket: WebSocket,
    /// Kept so that they live as long as the socket.
    _message: Closure<dyn FnMut(MessageEvent)>,
    _close: Closure<dyn FnMut(CloseEvent)>,
}

impl Drop for Socket {
    fn drop(&mut self) {
        self.socket.set_onmessage(None);
        self.socket.set_onclose(None);
        // Closing a socket that is closing already is no error worth a word.
        let _closed = self.socket.close();
    }
}

#[derive(Default)]
struct State {
    socket: Option<Socket>,
    wait: u64,
    waiting: bool,
    opened: f64,
    next_command: u64,
}

thread_local! {
    static STATE: RefCell<State> = RefCell::new(State { wait: FIRST_WAIT, next_command: 1, ..State::default() });
}

/// Milliseconds of the browser's own steady clock.
#[must_use]
pub(crate) fn wall() -> f64 {
    js_sys::Date::now()
}

/// Opens the link; from then on it keeps itself open.
pub(crate) fn open(deck: Deck) {
    connect(deck);
    let visible = move || {
        let hidden = document().hidden();
        if !hidden && wall() - deck.heard_at() > 1_000.0 {
            STATE.with_borrow_mut(|state| state.wait = FIRST_WAIT);
            reopen(deck, 0);
        }
    };
    let handle = window_event_listener_untyped("visibilitychange", move |_| visible());
    // The listener lives as long as the page.
    std::mem::forget(handle);
}

/// Closes a link on which nothing comes any more. Called by the page's tick.
pub(crate) fn watch(deck: Deck) {
    let silent = STATE.with_borrow(|state| {
        let since = wall() - deck.heard_at().max(state.opened);
        state.socket.is_some() && !state.waiting && since > SILENT
    });
    if silent {
        reopen(deck, FIRST_WAIT);
    }
}

/// Sends a command; gives back its number, or nothing where there is no link.
pub(crate) fn command(action: Order) -> Option<u64> {
    let id = STATE.with_borrow_mut(|state| {
        state.next_command += 1;
        state.next_command
    });
    send(&Up::Command { id, action }).then_some(id)
}

fn send(up: &Up) -> bool {
    STATE.with_borrow(|state| {
        let Some(socket) = &state.socket else {
            return false;
        };
        let text = up
            .serialize(&Serializer::json_compatible())
            .ok()
            .and_then(|up| js_sys::JSON::stringify(&up).ok()?.as_string());
        text.is_some_and(|text| socket.socket.send_with_str(&text).is_ok())
    })
}

/// The socket that was opened while the page was being compiled, and the frames that came since; taken once.
fn early() -> Option<(WebSocket, js_sys::Array)> {
    let name = JsValue::from_str("wheeloverLink");
    let early = Reflect::get(&window(), &name).ok()?;
    Reflect::set(&window(), &name, &JsValue::UNDEFINED).ok()?;
    let part = |name| Reflect::get(&early, &JsValue::from_str(name)).ok();
    let socket: WebSocket = part("socket")?.dyn_into().ok()?;
    let frames = part("frames")?.dyn_into().ok()?;
    (socket.ready_state() <= WebSocket::OPEN).then_some((socket, frames))
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

fn connect(deck: Deck) {
    let early = early();
    let frames = early.as_ref().map(|(_, frames)| frames.clone());
    let Some(socket) = early.map(|(socket, _)| socket).or_else(dial) else {
        reopen(deck, LONGEST_WAIT);
        return;
    };
    let message = Closure::new(move |event: MessageEvent| {
        if let Some(text) = event.data().as_string() {
            receive(deck, &text);
        }
    });
    let close = Closure::new(move |_: CloseEvent| {
        let wait = STATE.with_borrow_mut(|state| {
            let wait = state.wait;
            state.wait = (wait * 2).min(LONGEST_WAIT);
            wait
        });
        reopen(deck, wait);
    });
    socket.set_onmessage(Some(message.as_ref().unchecked_ref()));
    socket.set_onclose(Some(close.as_ref().unchecked_ref()));
    STATE.with_borrow_mut(|state| {
        state.opened = wall();
        state.socket = Some(Socket {
            socket,
            _message: message,
            _close: close,
        });
    });
    for frame in frames.iter().flat_map(js_sys::Array::iter) {
        if let Some(text) = frame.as_string() {
            receive(deck, &text);
        }
    }
}

/// Drops the socket and opens another one after a wait.
fn reopen(deck: Deck, wait: u64) {
    let begin = STATE.with_borrow_mut(|state| !std::mem::replace(&mut state.waiting, true));
    if !begin {
        return;
    }
    let jitter = (js_sys::Math::random() * 100.0) as u64;
    // Not at once: the socket's own handler may be running.
    set_timeout(
        move || {
            let old = STATE.with_borrow_mut(|state| {
                state.waiting = false;
                state.socket.take()
            });
            drop(old);
            connect(deck);
        },
        Duration::from_millis(wait + jitter),
    );
}

fn receive(deck: Deck, text: &str) {
    let understood = js_sys::JSON::parse(text)
        .ok()
        .and_then(|frame| take(deck, frame));
    if understood.is_none() {
        deck.misunderstood();
    }
}

/// Takes one frame; nothing where it cannot be read.
fn take(deck: Deck, frame: JsValue) -> Option<()> {
    fn body<T: DeserializeOwned>(frame: JsValue) -> Option<T> {
        from_value(frame).ok()
    }
    deck.alive();
    let kind = Reflect::get(&frame, &JsValue::from_str("type"))
        .ok()?
        .as_string()?;
    match kind.as_str() {
        "hello" => {
            let hello: Hello = body(frame)?;
            STATE.with_borrow_mut(|state| state.wait = FIRST_WAIT);
            let first = deck.greeting.with_untracked(Option::is_none);
            let from = deck.greet(hello);
            let follow = move || {
                send(&Up::Subscribe {
                    rate: 10.0,
                    lines: true,
                });
                send(&Up::Resume { seq: from });
            };
            if first && !document().hidden() {
                // What the hello says is on the screen before the lines of the past are read.
                request_animation_frame(move || set_timeout(follow, Duration::ZERO));
            } else {
                follow();
            }
        }
        "snapshot" => {
            let snapshot: Snapshot = body(frame)?;
            send(&Up::Ack {
                frame: snapshot.frame,
            });
            deck.snapshot(snapshot);
        }
        "lines" => {
            let lines: Lines = body(frame)?;
            if !deck.lines(&lines) {
                // Lines are missing: only a new hello can mend the picture.
                reopen(deck, 0);
            }
        }
        "route" => deck.route.set(body::<RouteDocument>(frame)?),
        "ports" => deck.ports.set(body::<PortsDocument>(frame)?.ports),
        "answer" => deck.answered(body::<Answer>(frame)?),
        "settings" | "gap" => {}
        _ => return None,
    }
    Some(())
}

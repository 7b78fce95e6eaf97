//! Cuts a stream of bytes into sentences and garbage; every split of the stream gives the same frames (SEN-1, SEN-8).

use alloc::vec::Vec;
use serde::{Deserialize, Serialize};

/// Longest sentence that is kept, TAG block included.
const LONGEST: usize = 512;
/// Garbage is shown to this length.
const SHOWN: usize = 256;
/// Garbage without an end is reported each time it has grown so long.
const ENDLESS: usize = 65_536;

/// What a frame holds.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum FrameKind {
    /// A line that begins as a sentence.
    Sentence,
    /// Bytes outside sentences, or a sentence that was cut off or is too long.
    Garbage,
}

/// A piece of the stream.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Frame<'a> {
    /// The line without CR LF; garbage is cut at 256 bytes.
    pub text: &'a [u8],
    /// What it holds.
    pub kind: FrameKind,
    /// How long it was.
    pub length: usize,
}

#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
enum State {
    /// Between lines.
    #[default]
    Idle,
    /// In a sentence, or behind its TAG block.
    Sentence,
    /// In a TAG block, before its closing backslash.
    Tag,
    /// In bytes that are no sentence.
    Garbage,
}

/// Cuts a stream into frames. Holds at most 512 bytes (FB5).
///
/// ```
/// use wheelover_core::nmea::{FrameKind, Framer};
/// let mut framer = Framer::new();
/// let mut seen = Vec::new();
/// framer.push(b"noise$HEHDT,216.8,T*22\r\n$HEROT,", &mut |frame| {
///     seen.push((frame.kind, frame.length));
/// });
/// assert_eq!(seen, [(FrameKind::Garbage, 5), (FrameKind::Sentence, 17)]);
/// // The rest waits for its end, or for the caller's patience.
/// assert!(framer.pending());
/// framer.flush(&mut |frame| assert_eq!(frame.text, b"$HEROT,"));
/// ```
#[derive(Clone, Debug, Default, Serialize, Deserialize)]
pub struct Framer {
    state: State,
    held: Vec<u8>,
    length: usize,
}

impl Framer {
    /// An empty framer.
    #[must_use]
    pub fn new() -> Self {
        Self::default()
    }

    /// Bytes of memory that are held (FB5).
    #[must_use]
    pub fn held(&self) -> usize {
        self.held.capacity()
    }

    /// Whether a line has begun and not ended; it ends by [`Framer::flush`] at a timeout.
    #[must_use]
    pub fn pending(&self) -> bool {
        self.state != State::Idle
    }

    /// Bytes of memory that it keeps.
    #[cfg(test)]
    pub(crate) fn capacity(&self) -> usize {
        self.held.capacity()
    }

    /// Takes bytes as they come and gives each frame that they end.
    pub fn push(&mut self, bytes: &[u8], sink: &mut dyn FnMut(Frame<'_>)) {
        let mut rest = bytes;
        while !rest.is_empty() {
            if self.state == State::Idle {
                rest = self.whole_line(rest, sink);
                let Some((&byte, tail)) = rest.split_first() else {
                    return;
                };
                rest = tail;
                self.begin(byte);
                continue;
            }
            let special = rest
                .iter()
                .position(|b| matches!(b, b'\r' | b'\n' | b'$' | b'!' | b'\\'));
            let (plain, tail) = rest.split_at(special.unwrap_or(rest.len()));
            self.keep(plain, sink);
            rest = tail;
            if let Some((&byte, tail)) = rest.split_first() {
                rest = tail;
                self.special(byte, sink);
            }
        }
    }

    /// Ends the line that has begun: its terminator did not come in time.
    pub fn flush(&mut self, sink: &mut dyn FnMut(Frame<'_>)) {
        self.end(false, sink);
    }

    /// The short way: a line that stands whole in `bytes` is given without being copied.
    fn whole_line<'b>(&mut self, bytes: &'b [u8], sink: &mut dyn FnMut(Frame<'_>)) -> &'b [u8] {
        let mut rest = bytes;
        loop {
            match rest.first() {
                Some(b'\r' | b'\n') => rest = &rest[1..],
                Some(b'$' | b'!') => {
                    let special = rest[1..]
                        .iter()
                        .position(|b| matches!(b, b'\r' | b'\n' | b'$' | b'!' | b'\\'))
                        .map(|at| at + 1);
                    match special {
                        Some(at) if at <= LONGEST && matches!(rest[at], b'\r' | b'\n') => {
                            sink(Frame {
                                text: &rest[..at],
                                kind: FrameKind::Sentence,
                                length: at,
                            });
                            rest = &rest[at + 1..];
                        }
                        _ => return rest,
                    }
                }
                _ => return rest,
            }
        }
    }

    fn begin(&mut self, byte: u8) {
        self.state = match byte {
            b'\r' | b'\n' => return,
            b'$' | b'!' => State::Sentence,
            b'\\' => State::Tag,
            _ => State::Garbage,
        };
        self.held.push(byte);
        self.length = 1;
    }

    fn special(&mut self, byte: u8, sink: &mut dyn FnMut(Frame<'_>)) {
        match (byte, self.state) {
            (b'\r' | b'\n', _) => self.end(false, sink),
            (b'$' | b'!', State::Sentence) if self.held.last() == Some(&b'\\') => {
                self.keep(&[byte], sink);
            }
            (b'\\', State::Tag) => {
                self.keep(&[byte], sink);
                if self.state == State::Tag {
                    self.state = State::Sentence;
                }
            }
            (b'\\', State::Sentence) if !self.complete() && self.held.last() != Some(&b'\\') => {
                self.keep(&[byte], sink);
            }
            // A new beginning: what was before it has no terminator.
            _ => {
                self.end(true, sink);
                self.begin(byte);
            }
        }
    }

    /// Whether what is held ends with a checksum.
    fn complete(&self) -> bool {
        matches!(self.held.as_slice(), [b'$' | b'!' | b'\\', .., b'*', high, low]
            if high.is_ascii_hexdigit() && low.is_ascii_hexdigit())
    }

    fn keep(&mut self, bytes: &[u8], sink: &mut dyn FnMut(Frame<'_>)) {
        let mut rest = bytes;
        while !rest.is_empty() {
            let (piece, tail) = rest.split_at(rest.len().min(ENDLESS - self.length));
            rest = tail;
            self.length += piece.len();
            if self.state != State::Garbage && self.length > LONGEST {
                self.state = State::Garbage;
            }
            let limit = if self.state == State::Garbage {
                SHOWN
            } else {
                LONGEST
            };
            let room = limit.saturating_sub(self.held.len());
            self.held.extend_from_slice(&piece[..piece.len().min(room)]);
            if self.length >= ENDLESS {
                self.end(true, sink);
                self.state = State::Garbage;
            }
        }
    }

    fn end(&mut self, cut_off: bool, sink: &mut dyn FnMut(Frame<'_>)) {
        let whole = match self.state {
            State::Idle => return,
            State::Sentence => !cut_off || self.complete(),
            State::Tag | State::Garbage => false,
        };
        if self.length > 0 {
            let kind = if whole {
                FrameKind::Sentence
            } else {
                FrameKind::Garbage
            };
            let shown = if whole {
                self.held.len()
            } else {
                self.held.len().min(SHOWN)
            };
            sink(Frame {
                text: &self.held[..shown],
                kind,
                length: self.length,
            });
        }
        self.held.clear();
        self.length = 0;
        self.state = State::Idle;
    }
}

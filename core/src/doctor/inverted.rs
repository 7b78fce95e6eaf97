//! Sentences of a line whose two wires are changed, read out of what a receiver makes of them.
//!
//! Every level is the other one, start and stop bits and the rest between sentences too. A receiver waits for the rest, which
//! it takes for a break, to end; its start bit is then the first inverted bit that is 0, somewhere in a character, and from there
//! on its frames and the sender's do not meet. What it cannot say is how many bits passed between two of its frames: none at
//! all where its stop bit was missing and is the next start bit, else one or more that are 1. All that there can have been are
//! followed, and only those that are sentences stay: the start bit of a character is 1, its eighth bit 1, its stop bit 0, and
//! what the checksum says must be right.

use alloc::vec;
use alloc::vec::Vec;

/// So many ways are followed at once; a line has few.
const WAYS: usize = 400;
/// So many bits that are 1 can stand between two frames.
const BETWEEN: usize = 9;

/// One way to read the bits.
#[derive(Clone, Debug)]
struct Way {
    /// Characters so far.
    text: Vec<u8>,
    /// Where in a character the next bit stands: 0 its start bit, 9 its stop bit.
    place: u8,
    /// The data bits so far, not inverted.
    bits: u8,
    /// Sum of the characters since the last `$` or `!`.
    sum: u8,
    /// What may come next.
    part: Part,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Part {
    Begin,
    Body,
    High,
    Low(u8),
    Return,
    Feed,
}

impl Way {
    /// Before the first character.
    const fn new() -> Self {
        Self {
            text: Vec::new(),
            place: 0,
            bits: 0,
            sum: 0,
            part: Part::Begin,
        }
    }

    /// Takes a level of the line; false where no sentence has it there.
    fn take(&mut self, level: bool) -> bool {
        match self.place {
            0 | 8 if !level => return false,
            9 if level => return false,
            1..=7 => self.bits |= u8::from(!level) << (self.place - 1),
            _ => {}
        }
        self.place += 1;
        if self.place < 10 {
            return true;
        }
        self.place = 0;
        let character = core::mem::take(&mut self.bits);
        self.text.push(character);
        self.follow(character)
    }

    /// Whether a character may stand here.
    fn follow(&mut self, character: u8) -> bool {
        let digit = |character: u8| match character {
            b'0'..=b'9' => Some(character - b'0'),
            b'A'..=b'F' => Some(character - b'A' + 10),
            _ => None,
        };
        let next = match (self.part, character) {
            (Part::Begin, b'$' | b'!') => {
                self.sum = 0;
                Some(Part::Body)
            }
            (Part::Body, b'*') => Some(Part::High),
            (Part::Body, b'$' | b'!') => None,
            (Part::Body, b' '..=b'~') => {
                self.sum ^= character;
                Some(Part::Body)
            }
            (Part::High, character) => digit(character).map(Part::Low),
            (Part::Low(high), character) => digit(character)
                .filter(|low| high << 4 | low == self.sum)
                .map(|_| Part::Return),
            (Part::Return, b'\r') => Some(Part::Feed),
            (Part::Feed, b'\n') => Some(Part::Begin),
            _ => None,
        };
        next.map(|part| self.part = part).is_some()
    }

    /// How many sentences stand in it, then how many characters.
    fn worth(&self) -> (usize, usize) {
        let ends = self.text.iter().filter(|byte| **byte == b'*').count();
        (ends, self.text.len())
    }
}

/// The sentences that can be read out of what was received, one after the other.
pub(super) fn sentences(bytes: &[u8]) -> Vec<u8> {
    let mut all = Vec::new();
    // Between sentences the line rests, which is a break: a zero.
    for burst in bytes
        .split(|byte| *byte == 0)
        .filter(|burst| burst.len() > 4)
    {
        let mut ways = begun();
        let mut best: Option<Way> = None;
        for byte in burst {
            ways = frame(ways, *byte);
            for way in &ways {
                let ended = matches!(way.part, Part::Return | Part::Feed | Part::Begin);
                if ended && best.as_ref().is_none_or(|best| way.worth() > best.worth()) {
                    best = Some(way.clone());
                }
            }
        }
        if let Some(best) = best {
            all.extend(best.text);
            all.extend(b"\r\n");
        }
    }
    all
}

/// The levels before the first frame are 1: the start bit of `$` or `!` and what follows it.
fn begun() -> Vec<Way> {
    let mut ways = Vec::new();
    let mut way = Way::new();
    for _ in 0..BETWEEN {
        if !way.take(true) {
            break;
        }
        ways.push(way.clone());
    }
    ways
}

/// All ways on over a frame and what can stand behind it.
fn frame(ways: Vec<Way>, byte: u8) -> Vec<Way> {
    let mut on = vec![];
    for mut way in ways {
        let levels = (0..8).map(|shift| byte >> shift & 1 == 1);
        if !core::iter::once(false)
            .chain(levels)
            .all(|level| way.take(level))
        {
            continue;
        }
        on.push(way.clone());
        for _ in 0..BETWEEN {
            if !way.take(true) {
                break;
            }
            on.push(way.clone());
        }
    }
    on.truncate(WAYS);
    on
}

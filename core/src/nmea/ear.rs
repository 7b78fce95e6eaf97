//! The framer of a port with its patience: a line whose end does not come is taken as it is (SEN-1).

use super::{Frame, Framer};
use crate::time::Stamp;
use serde::{Deserialize, Serialize};

/// How long the end of a line is waited for without a byte, milliseconds.
const LINE_TIMEOUT_MS: u64 = 500;

/// What a station hears a port with.
#[derive(Clone, Debug, Default, Serialize, Deserialize)]
pub(crate) struct Ear {
    framer: Framer,
    /// When bytes were last heard.
    last: Stamp,
}

impl Ear {
    /// Takes bytes; `sink` gets each frame that they end.
    pub(crate) fn hear(&mut self, now: Stamp, bytes: &[u8], sink: &mut dyn FnMut(Frame<'_>)) {
        self.time_out(now, sink);
        self.last = now;
        self.framer.push(bytes, sink);
    }

    /// Whether a line has waited too long for its end.
    pub(crate) fn is_late(&self, now: Stamp) -> bool {
        self.framer.pending() && now.since(self.last) > LINE_TIMEOUT_MS
    }

    /// Ends a line that has waited too long.
    pub(crate) fn time_out(&mut self, now: Stamp, sink: &mut dyn FnMut(Frame<'_>)) {
        if self.is_late(now) {
            self.framer.flush(sink);
        }
    }
}

//! Whose commands are obeyed: the first that commands keeps the authority while it is fresh, and several valid commands in a
//! row come before the first that is obeyed (FA14, FB13).

use crate::picture::Source;
use crate::time::Stamp;
use alloc::collections::VecDeque;
use alloc::string::String;
use serde::{Deserialize, Serialize};

/// So many valid commands in a row, within so long, before the first is obeyed (FA14).
const PROOFS: usize = 3;
const PROOF_WINDOW_MS: u64 = 5_000;

/// Commands of one kind: whose, the last that was accepted, and the last that was not.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub(in super::super) struct Authority<T> {
    /// Whose commands are obeyed, and when it last commanded (FB13).
    holder: Option<(Source, Stamp)>,
    /// When another source last commanded.
    other: Option<Stamp>,
    /// The last command that was accepted.
    command: Option<(T, Stamp)>,
    /// The last refusal.
    refusal: Option<(String, Stamp)>,
    /// Times of the accepted commands in a row (FA14).
    proofs: VecDeque<Stamp>,
}

impl<T> Default for Authority<T> {
    fn default() -> Self {
        Self {
            holder: None,
            other: None,
            command: None,
            refusal: None,
            proofs: VecDeque::new(),
        }
    }
}

impl<T> Authority<T> {
    /// The command in force, unless it is older than `ms`.
    pub(in super::super) fn command(&self, now: Stamp, ms: u64) -> Option<&T> {
        let (command, at) = self.command.as_ref()?;
        (now.since(*at) <= ms).then_some(command)
    }

    /// When the last command was accepted.
    pub(in super::super) fn heard_at(&self) -> Stamp {
        self.command.as_ref().map_or(Stamp(0), |(_, at)| *at)
    }

    /// Takes an accepted command.
    pub(in super::super) fn take(&mut self, now: Stamp, source: Source, command: T) {
        self.holder = Some((source, now));
        self.command = Some((command, now));
    }

    /// Forgets the command in force: what is said next begins anew.
    pub(in super::super) fn drop_command(&mut self) {
        self.command = None;
        self.disprove();
    }

    /// FB13: the first that commands keeps the authority while it is fresh, for `ms`; that one, where it is another.
    pub(in super::super) fn other_holder(
        &mut self,
        now: Stamp,
        source: &Source,
        ms: u64,
    ) -> Option<&Source> {
        let (holder, at) = self.holder.as_ref()?;
        if holder == source || now.since(*at) > ms {
            return None;
        }
        self.other = Some(now);
        Some(holder)
    }

    /// Whether another source has commanded within `ms`.
    pub(in super::super) fn in_conflict(&self, now: Stamp, ms: u64) -> bool {
        self.other.is_some_and(|at| now.since(at) <= ms)
    }

    /// Notes a valid command for the proof of life.
    pub(in super::super) fn prove(&mut self, now: Stamp) {
        self.proofs.push_back(now);
        while self.proofs.len() > PROOFS {
            self.proofs.pop_front();
        }
    }

    /// The row of valid commands is broken.
    pub(in super::super) fn disprove(&mut self) {
        self.proofs.clear();
    }

    /// FA14: there were enough valid commands in a row.
    pub(in super::super) fn is_proven(&self, now: Stamp) -> bool {
        let first = self.proofs.front();
        self.proofs.len() >= PROOFS && first.is_some_and(|at| now.since(*at) <= PROOF_WINDOW_MS)
    }

    /// Notes why a command is not followed.
    pub(in super::super) fn refuse(&mut self, now: Stamp, text: String) {
        self.refusal = Some((text, now));
    }

    /// The last refusal, where it is younger than the last command that was accepted.
    pub(in super::super) fn refused(&self) -> Option<&str> {
        let (text, at) = self.refusal.as_ref()?;
        (*at > self.heard_at()).then_some(text.as_str())
    }
}

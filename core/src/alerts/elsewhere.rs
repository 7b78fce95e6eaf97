//! What another system may ask of an alert, and why it is refused (ACN, ACK, ARC).

use core::fmt;

/// Why a command of another system was not obeyed (ARC).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum CommandRefused {
    /// There is no such alert here.
    Unknown,
    /// It waits for nothing: it is not raised, is taken already, or is a caution.
    NotWaiting,
    /// Category A, and who asks cannot show the reason.
    ReasonNotShown,
    /// Responsibility goes to nobody whose heartbeat is not heard.
    NoHeartbeat,
}

impl fmt::Display for CommandRefused {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Unknown => "no such alert is known here",
            Self::NotWaiting => "it waits for no such command",
            Self::ReasonNotShown => "category A: acknowledge it where its reason is shown",
            Self::NoHeartbeat => "no heartbeat is heard from there",
        })
    }
}

/// What who commands can do.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Elsewhere {
    /// It shows the reasons of alerts, so that category A may be taken there.
    pub(crate) shows_reason: bool,
    /// Its heartbeat is heard, so that responsibility may go there.
    pub(crate) alive: bool,
}

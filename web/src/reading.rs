//! What is shown of a quantity: its value, how far it may be believed, its age and its source.

use wheelover_core::limits::{Freshness, Quantity};
use wheelover_core::picture::{Heard, Picture};
use wheelover_core::time::Stamp;

/// One shown quantity.
#[derive(Clone, Debug, PartialEq)]
pub struct Reading<T> {
    /// The value; absent where it is unknown, lost, or empty on the line.
    pub value: Option<T>,
    /// How far it may be believed.
    pub state: Freshness,
    /// Milliseconds since it was heard.
    pub age: u64,
    /// Who said it, as `port/talker/formatter`.
    pub source: String,
    /// Which source is not believed, and why; empty where all are.
    pub why: String,
}

impl<T> Default for Reading<T> {
    fn default() -> Self {
        Self {
            value: None,
            state: Freshness::Never,
            age: 0,
            source: String::new(),
            why: String::new(),
        }
    }
}

impl<T> Reading<T> {
    pub(crate) fn heard<H>(
        picture: &Picture,
        heard: Option<&Heard<H>>,
        quantity: Quantity,
        now: Stamp,
        value: impl Fn(&H) -> Option<T>,
    ) -> Self {
        let Some(heard) = heard else {
            return Self::default();
        };
        let state = heard.freshness(quantity, now);
        let usable = heard.usable(quantity, now);
        Self {
            value: usable.and_then(value),
            state,
            age: now.since(heard.at),
            source: picture.source_name(&heard.source),
            why: String::new(),
        }
    }

    /// An own fact: as good as the link.
    pub(crate) fn own(value: Option<T>) -> Self {
        let state = if value.is_some() {
            Freshness::Valid
        } else {
            Freshness::Never
        };
        Self {
            value,
            state,
            age: 0,
            source: String::new(),
            why: String::new(),
        }
    }

    /// An own fact with a mark in the place of its source.
    pub(crate) fn marked(value: Option<T>, mark: &str) -> Self {
        Self {
            source: mark.to_owned(),
            ..Self::own(value)
        }
    }

    /// The same without its value, for when the link is gone.
    pub(crate) fn lost(self, age: u64) -> Self {
        match self.state {
            Freshness::Never => self,
            _ => Self {
                value: None,
                state: Freshness::Lost,
                age: self.age.max(age),
                why: String::new(),
                ..self
            },
        }
    }

    /// The port that the value came from, in capitals: `GYRO1`.
    #[must_use]
    pub fn port(&self) -> String {
        self.source
            .split('/')
            .next()
            .unwrap_or_default()
            .to_ascii_uppercase()
    }
}

/// The name of a state in `data-state`.
#[must_use]
pub const fn state_name(state: Freshness) -> &'static str {
    match state {
        Freshness::Valid => "valid",
        Freshness::Late => "late",
        Freshness::Low => "low",
        Freshness::Lost => "lost",
        Freshness::Never => "never",
    }
}

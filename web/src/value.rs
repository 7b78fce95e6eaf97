//! One shown value: its text, its state, and its age where that matters.

use crate::deck::Deck;
use crate::format;
use crate::reading::{Reading, state_name};
use crate::readings::Readings;
use leptos::prelude::*;
use wheelover_core::limits::Freshness;

/// What stands on the screen for a reading; changes only when the picture must.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Shown {
    /// The number or text.
    pub(crate) text: String,
    /// How far it may be believed.
    pub(crate) state: Freshness,
    /// `3 s` where late, `lost 14 s` where lost, `GYRO1 jumped` where not believed, else empty.
    pub(crate) badge: String,
    /// The port that it came from, in capitals.
    pub(crate) port: String,
}

impl Shown {
    /// From a reading and its text.
    #[must_use]
    pub(crate) fn of<T>(reading: &Reading<T>, text: String) -> Self {
        let badge = match reading.state {
            _ if !reading.why.is_empty() => reading.why.clone(),
            Freshness::Late => format::seconds(reading.age),
            Freshness::Lost => format!("lost {}", format::seconds(reading.age)),
            Freshness::Low => "low integrity".to_owned(),
            Freshness::Valid | Freshness::Never => String::new(),
        };
        Self {
            text,
            state: reading.state,
            badge,
            port: reading.port(),
        }
    }
}

/// A memo of one quantity as it is shown.
pub(crate) fn shown<T: Clone + Send + Sync + 'static>(
    pick: fn(&Readings) -> &Reading<T>,
    write: impl Fn(Option<T>) -> String + Send + Sync + 'static,
) -> Memo<Shown> {
    let deck = Deck::here();
    Memo::new(move |_| {
        deck.readings.with(|readings| {
            let reading = pick(readings);
            Shown::of(reading, write(reading.value.clone()))
        })
    })
}

/// The element that tests and scripts hold on to: `data-value` and `data-state`.
#[component]
pub(crate) fn Value(name: &'static str, shown: Memo<Shown>) -> impl IntoView {
    view! {
        <span
            class="shown"
            data-value=name
            data-state=move || shown.with(|shown| state_name(shown.state))
        >
            {move || shown.with(|shown| shown.text.clone())}
        </span>
    }
}

/// The age of a value that is late, lost or of low integrity.
#[component]
pub(crate) fn Badge(shown: Memo<Shown>) -> impl IntoView {
    let text = Memo::new(move |_| shown.with(|shown| shown.badge.clone()));
    view! {
        <span class="badge-age" class:hidden=move || text.with(String::is_empty)>
            {move || text.get()}
        </span>
    }
}

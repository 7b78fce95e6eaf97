//! The alert bar and the list (IEC 62923): the highest alert, the others beside it, silence and acknowledge.
//!
//! **Invariant:** the bar's height and its buttons' places do not depend on what is in it.

use crate::deck::Deck;
use crate::format;
use crate::steady::steady;
use leptos::prelude::*;
use wheelover_core::alerts::{Category, Priority, State};
use wheelover_core::view::{AlertView, Order};

const fn priority_key(priority: Priority) -> &'static str {
    match priority {
        Priority::Alarm => "alarm",
        Priority::Warning => "warning",
        Priority::Caution => "caution",
    }
}

const fn state_key(state: State) -> &'static str {
    match state {
        State::Unacknowledged => "unacknowledged",
        State::Silenced => "silenced",
        State::Acknowledged => "acknowledged",
        State::Transferred => "transferred",
        State::RectifiedUnacknowledged => "rectified_unacknowledged",
        State::Normal => "normal",
    }
}

const fn flashes(state: State, priority: Priority) -> bool {
    !matches!(priority, Priority::Caution)
        && matches!(
            state,
            State::Unacknowledged | State::Silenced | State::RectifiedUnacknowledged
        )
}

/// Whether the page may acknowledge it: not a caution, not done yet. The page shows the reasons, so category A too.
fn may_acknowledge(alert: &AlertView) -> bool {
    alert.priority != Priority::Caution
        && matches!(
            alert.state,
            State::Unacknowledged | State::Silenced | State::RectifiedUnacknowledged
        )
}

/// The symbol: shape says the priority, mark says the state.
#[component]
fn Icon(priority: Priority, state: State) -> impl IntoView {
    let face = match priority {
        Priority::Alarm => "M18 3 L34 32 H2 Z",
        Priority::Warning => "M18 3 a15 15 0 1 0 .1 0 Z",
        Priority::Caution => "M4 4 H32 V32 H4 Z",
    };
    let speaker = "M12 18 h4 l5 -4 v13 l-5 -4 h-4 Z";
    let mark = match (priority, state) {
        (Priority::Caution, _) | (_, State::Acknowledged | State::Normal) => {
            "M17 12 h2 v10 h-2 Z M17 25 h2 v3 h-2 Z"
        }
        (_, State::Unacknowledged) => speaker,
        (_, State::Silenced) => "M12 18 h4 l5 -4 v13 l-5 -4 h-4 Z M9 28 L27 12 l1 1 L10 29 Z",
        (_, State::Transferred) => "M10 20 h10 v-4 l7 5.5 -7 5.5 v-4 h-10 Z",
        (_, State::RectifiedUnacknowledged) => "M11 21 l2 -2 4 4 8 -9 2 2 -10 11 Z",
    };
    view! {
        <svg
            class="icon"
            class:flashing=flashes(state, priority)
            viewBox="0 0 36 36"
            data-priority=priority_key(priority)
            aria-hidden="true"
        >
            <path class="face" d=face/>
            <path class="mark" d=mark/>
        </svg>
    }
}

/// The alert bar.
#[component]
pub(crate) fn AlertBar() -> impl IntoView {
    let deck = Deck::here();
    let alerts = Memo::new(move |_| {
        deck.own.with(|own| {
            own.as_ref()
                .map(|own| own.alerts.clone())
                .unwrap_or_default()
        })
    });
    let open = RwSignal::new(false);
    let top = Memo::new(move |_| alerts.with(|alerts| alerts.first().cloned()));
    let sounding = Memo::new(move |_| {
        alerts.with(|alerts| {
            alerts
                .iter()
                .any(|alert| alert.state == State::Unacknowledged)
        })
    });
    // What the button takes is what the bar shows.
    let takable = Memo::new(move |_| {
        top.with(|top| {
            top.as_ref()
                .filter(|a| may_acknowledge(a))
                .map(|a| a.number)
        })
    });
    let taking = Taking::default();
    provide_context(taking);
    let others = Memo::new(move |_| {
        alerts.with(|alerts| alerts.iter().skip(1).cloned().collect::<Vec<_>>())
    });
    view! {
        <div
            class="alerts"
            data-priority=move || top.with(|top| top.as_ref().map_or("none", |a| priority_key(a.priority)))
        >
            {move || match top.get() {
                None => {
                    // What is not known is not "none".
                    let none = move || if deck.own.with(Option::is_some) { "NO ALERTS" } else { "ALERTS NOT KNOWN" };
                    view! { <span class="quiet" data-value="no-alerts">{none}</span> <span class="alert-text"></span> }.into_any()
                }
                Some(alert) => {
                    view! {
                        <Icon priority=alert.priority state=alert.state/>
                        <button
                            type="button"
                            class="alert-text"
                            data-alert=alert.number.to_string()
                            data-state=state_key(alert.state)
                            on:click=move |_| open.update(|open| *open = !*open)
                        >
                            <span class="head">
                                <b role="alert">{alert.title.clone()}</b>
                                <span class="small">{aside(&alert)}</span>
                            </span>
                            <span class="say">{alert.text.clone()}</span>
                        </button>
                    }
                        .into_any()
                }
            }}
            <span class="others">
                {move || others.get().into_iter().map(other).collect_view()}
                <span class="more" class:hidden=move || others.with(Vec::is_empty)>
                    {move || format!("+{}", others.with(Vec::len))}
                </span>
            </span>
            <button
                type="button"
                class="act"
                data-command="silence"
                disabled=move || !sounding.get()
                on:click=move |_| deck.command("silence", Order::Silence(true))
            >
                "Silence"
            </button>
            <button
                type="button"
                class="act"
                data-command="acknowledge"
                disabled=move || takable.get().is_none()
                on:click=move |_| {
                    if let Some(number) = takable.get_untracked() {
                        taking.acknowledge(deck, number);
                    }
                }
            >
                <b>"ACK"</b>
            </button>
            <div class="alert-list" class:hidden=move || !open.get() || alerts.with(Vec::is_empty)>
                {move || alerts.get().into_iter().map(|alert| view! { <Row alert/> }).collect_view()}
            </div>
        </div>
    }
}

/// One tap takes one alert: so long after an acknowledgement no other is sent, milliseconds. The second tap of two would
/// take an alert that nobody has read yet.
const NEXT_TAKEN: f64 = 700.0;

/// When this page last acknowledged.
#[derive(Clone, Copy)]
struct Taking(StoredValue<f64>);

impl Default for Taking {
    fn default() -> Self {
        Self(StoredValue::new(f64::NEG_INFINITY))
    }
}

impl Taking {
    fn acknowledge(self, deck: Deck, number: u16) {
        let now = steady();
        if now - self.0.get_value() > NEXT_TAKEN {
            self.0.set_value(now);
            deck.command("acknowledge", Order::Acknowledge(number));
        }
    }
}

/// A further alert, beside the highest.
fn other(alert: AlertView) -> impl IntoView {
    view! {
        <span class="small other" data-alert=alert.number.to_string() data-state=state_key(alert.state)>
            {format!("+ {}", alert.title)}
        </span>
    }
}

fn aside(alert: &AlertView) -> String {
    let priority = match alert.priority {
        Priority::Alarm => "Alarm",
        Priority::Warning => "Warning",
        Priority::Caution => "Caution",
    };
    match alert.category {
        Category::A => format!("{priority} · cat A"),
        Category::B => format!("{priority} · cat B"),
    }
}

/// One alert of the list.
#[component]
fn Row(alert: AlertView) -> impl IntoView {
    let deck = Deck::here();
    let taking = expect_context::<Taking>();
    let (number, at) = (alert.number, alert.at);
    let age = Memo::new(move |_| {
        deck.readings
            .with(|r| r.now.0.saturating_sub(at) / 1000 * 1000)
    });
    view! {
        <div>
            <Icon priority=alert.priority state=alert.state/>
            <p>
                <b>{alert.title.clone()}</b>
                " "
                <span class="small">{move || format::seconds(age.get())}</span>
                <br/>
                {alert.text.clone()}
            </p>
            <button
                type="button"
                disabled=!may_acknowledge(&alert)
                on:click=move |_| taking.acknowledge(deck, number)
            >
                "ACK"
            </button>
        </div>
    }
}

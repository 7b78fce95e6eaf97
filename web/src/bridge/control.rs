//! The controls: STANDBY at one press; AUTO, its heading and AutoNAV by press and confirm; the reason for the mode.
//!
//! A mode that would be refused is greyed, and the line below the buttons says what it waits for (AP-6). STANDBY never is.
//!
//! **Invariant:** every button has its place at all times, and CONFIRM has one that nothing else ever had: a finger that
//! taps again where it tapped confirms nothing.

use crate::deck::Deck;
use crate::steady::steady;
use crate::{format, top};
use leptos::prelude::*;
use wheelover_core::view::{ModeName, ModeRequest, Order, Own};

/// A press waits so long for its confirmation, steady milliseconds.
const CONFIRM: f64 = 8_000.0;

/// What a press asks for, until it is confirmed.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Armed {
    pub(crate) order: Order,
    /// What CONFIRM would do; that of a change of the heading is made where it is shown.
    words: String,
    /// Until when, steady milliseconds.
    until: f64,
    /// The frame that it was pressed beside (AP-26).
    frame: Option<u64>,
}

impl Armed {
    /// Pressed now.
    pub(crate) fn new(deck: Deck, order: Order, words: String) -> Self {
        Self {
            order,
            words,
            until: steady() + CONFIRM,
            frame: deck.frame(),
        }
    }

    /// What CONFIRM would do.
    fn words(&self, set: Option<f64>) -> String {
        let Order::AdjustHeading(degrees) = self.order else {
            return self.words.clone();
        };
        match set {
            Some(set) => format!("{}°", format::direction(Some(set + degrees))),
            None => format!("{}°", format::sided(Some(degrees), 0)),
        }
    }
}

/// The control bar; it confirms whatever is armed.
#[component]
pub(crate) fn Control(armed: RwSignal<Option<Armed>>) -> impl IntoView {
    let deck = Deck::here();
    let own = Memo::new(move |_| {
        deck.own
            .with(|own| own.as_ref().and_then(|s| s.own.clone()))
    });
    let mode = Memo::new(move |_| own.with(|own| own.as_ref().map(|own| own.mode)));
    let set = Memo::new(move |_| own.with(|own| own.as_ref().and_then(|own| own.set_heading)));
    let may = Memo::new(move |_| {
        deck.greeting
            .with(|g| g.as_ref().is_some_and(|g| g.may_command))
    });
    // A press that is not confirmed lapses.
    Effect::new(move |_| {
        deck.readings.track();
        if armed.with_untracked(|armed| armed.as_ref().is_some_and(|armed| steady() > armed.until))
        {
            armed.set(None);
        }
    });
    // What was pressed beside another mode or set heading is not confirmed beside this one.
    Effect::new(move |_| {
        mode.track();
        set.track();
        armed.set(None);
    });
    let arm = move |order: Order, words: &str| {
        armed.set(Some(Armed::new(deck, order, words.to_owned())));
    };
    let nudge = move |degrees: f64| {
        let before = match armed.get_untracked().map(|armed| armed.order) {
            Some(Order::AdjustHeading(sum)) => sum,
            _ => 0.0,
        };
        arm(Order::AdjustHeading(before + degrees), "");
    };
    let confirm = move |_| {
        if let Some(armed) = armed.get_untracked() {
            deck.press("confirm", armed.frame, armed.order);
        }
        armed.set(None);
    };
    let is_armed = Memo::new(move |_| armed.with(Option::is_some));
    let left = move || {
        deck.readings.track();
        armed.with(|armed| {
            armed.as_ref().map_or_else(String::new, |armed| {
                let seconds = format::fixed(((armed.until - steady()) / 1_000.0).max(0.0), 0);
                format!("{} · {seconds} s", armed.words(set.get()))
            })
        })
    };
    let pending = Memo::new(move |_| {
        let now = deck.readings.with(|r| r.now.0);
        own.with(|own| {
            let pending = own.as_ref()?.pending.as_ref()?;
            let seconds = pending.until.saturating_sub(now).div_ceil(1_000);
            Some(format!(
                "{}: {seconds} s, {}",
                top::mode_title(pending.request),
                pending.waits_for
            ))
        })
    });
    let closed = Memo::new(move |_| {
        own.with(|own| {
            own.as_ref()
                .map(|own| own.closed.clone())
                .unwrap_or_default()
        })
    });
    let reason = move |request: ModeRequest| {
        let of = |closed: &Vec<(ModeRequest, String)>| {
            let found = closed.iter().find(|(mode, _)| *mode == request);
            found.map(|(_, why)| why.clone())
        };
        closed.with(of)
    };
    let select =
        move |name: &'static str, text: &'static str, request, on: fn(ModeName) -> bool| {
            let why = move || reason(request);
            let line = move || {
                why().map(|why| match why.strip_prefix(text) {
                    Some(_) => why,
                    None => format!("{text}: {why}"),
                })
            };
            let key = view! {
                <button
                    type="button"
                    data-command=name
                    aria-pressed=move || pressed(mode.get().is_some_and(on))
                    aria-disabled=move || pressed(why().is_some())
                    aria-describedby=move || why().is_some().then_some(name)
                    title=why
                    disabled=move || !may.get()
                    on:click=move |_| if why().is_none() { arm(Order::Mode(request), text) }
                >
                    {text}
                </button>
            };
            let line = view! { <span id=name class="closed" data-closed=name>{line}</span> };
            (key, line)
        };
    let (auto, auto_closed) = select("auto", "AUTO", ModeRequest::Auto, |mode| {
        mode == ModeName::Auto
    });
    let (autonav, autonav_closed) = select("autonav", "AutoNAV", ModeRequest::Autonav, |mode| {
        matches!(mode, ModeName::AutonavTi | ModeName::AutonavTn)
    });
    let adjust = move |name: &'static str, text: &'static str, degrees: f64| {
        view! {
            <button type="button" data-command=name disabled=move || !may.get() on:click=move |_| nudge(degrees)>
                {text}
            </button>
        }
    };
    view! {
        <div class="bar control">
            <div class="keys">
                <button
                    type="button"
                    class="standby"
                    data-command="standby"
                    aria-pressed=move || pressed(mode.get() == Some(ModeName::Standby))
                    on:click=move |_| {
                        armed.set(None);
                        deck.command("standby", Order::Mode(ModeRequest::Standby));
                    }
                >
                    "STANDBY"
                </button>
                {auto}
                {autonav}
                {adjust("adjust-10", "−10", -10.0)}
                {adjust("adjust-1", "−1", -1.0)}
                <span class="set">
                    <small>"SET HDG"</small>
                    <b data-value="set-heading">{move || format::direction(set.get())}</b>
                </span>
                {adjust("adjust+1", "+1", 1.0)}
                {adjust("adjust+10", "+10", 10.0)}
            </div>
            <p class="why" role="status">
                <b class="pending" data-value="pending">{move || pending.get()}</b>
                <span data-value="why">{move || why(deck, &own)}</span>
                {auto_closed}
                {autonav_closed}
            </p>
            <button
                type="button"
                class="confirm"
                data-command="confirm"
                disabled=move || !is_armed.get()
                on:click=confirm
            >
                <b>"CONFIRM"</b>
                <span data-value="armed">{left}</span>
            </button>
            <button
                type="button"
                class="cancel"
                data-command="cancel"
                aria-label="cancel"
                disabled=move || !is_armed.get() && pending.with(Option::is_none)
                on:click=move |_| {
                    if armed.get_untracked().is_some() {
                        armed.set(None);
                    } else {
                        deck.press("cancel", deck.frame(), Order::Mode(ModeRequest::Cancel));
                    }
                }
            >
                "✕"
            </button>
        </div>
    }
}

pub(crate) const fn pressed(on: bool) -> &'static str {
    if on { "true" } else { "false" }
}

/// The reason for the mode; a refusal of this page's last command stands before it.
fn why(deck: Deck, own: &Memo<Option<Own>>) -> String {
    let busy = deck.asked.with(|asked| !asked.is_empty());
    if busy {
        return "asked, waiting for the answer".to_owned();
    }
    let refused = deck.answer.with(|answer| {
        answer
            .as_ref()
            .filter(|answer| !answer.ok)
            .map(|answer| answer.text.clone())
    });
    let why = own.with(|own| own.as_ref().map(|own| own.why.clone()).unwrap_or_default());
    match refused {
        Some(unsent) if unsent.starts_with("NO ") => unsent,
        Some(refused) => format!("Refused: {refused}"),
        None => why,
    }
}

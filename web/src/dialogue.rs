//! The dialogue page: the latest line of every sentence in both directions, live; a tap on a field explains it.

use crate::deck::Deck;
use crate::drawing::Drawing;
use crate::heard::Lane;
use crate::lookup::Dictionary;
use crate::offered::Offered;
use crate::{format, situation};
use leptos::prelude::*;
use wasm_bindgen::JsCast;
use web_sys::{Element, MouseEvent};
use wheelover_core::station::Direction;
use wheelover_core::view::Line;

/// A sentence and the field of it that is looked at.
type Chosen = RwSignal<Option<(Lane, usize)>>;

/// The dialogue page.
#[component]
pub(crate) fn Dialogue() -> impl IntoView {
    let deck = Deck::here();
    let port = RwSignal::new(0_usize);
    let chosen: Chosen = RwSignal::new(None);
    let names = Memo::new(move |_| {
        deck.greeting
            .with(|g| g.as_ref().map(|g| g.ports.clone()).unwrap_or_default())
    });
    // The chart system's port is what this page is for.
    Effect::new(move |_| {
        if let Some(index) = names.with(|names| names.iter().position(|name| name == "ecdis")) {
            port.set(index);
        }
    });
    let now = Memo::new(move |_| situation::current(deck));
    let station = move || {
        deck.greeting.with(|g| {
            g.as_ref()
                .map(|g| g.station.replace('_', " "))
                .unwrap_or_default()
        })
    };
    let ports = move || {
        names
            .get()
            .into_iter()
            .enumerate()
            .map(|(index, name)| {
                let command = format!("port-{name}");
                view! {
                    <button
                        type="button"
                        data-command=command
                        aria-pressed=move || if port.get() == index { "true" } else { "false" }
                        on:click=move |_| port.set(index)
                    >
                        {name}
                    </button>
                }
            })
            .collect_view()
    };
    view! {
        <main class="talk">
            <header>
                <span class="situation" data-value="situation" data-state="valid">
                    {move || match now.get() {
                        Some(n) => format!("Situation {n}: {}", situation::words(n)),
                        None => "Situation not known".to_owned(),
                    }}
                </span>
                <span class="sources"></span>
                <span class="caption">"PORT"</span>
                {ports}
            </header>
            <section class="lane" data-lane="in">
                <h2>{move || format!("to the {}", station())}</h2>
                <LaneRows port heard=true chosen/>
            </section>
            <section class="lane" data-lane="out">
                <h2>{move || format!("from the {}", station())}</h2>
                <LaneRows port heard=false chosen/>
            </section>
            <Offered/>
            <Looked chosen/>
            <Log port/>
            <Checked port/>
        </main>
    }
}

/// The latest line of each sentence in one direction.
#[component]
fn LaneRows(port: RwSignal<usize>, heard: bool, chosen: Chosen) -> impl IntoView {
    let deck = Deck::here();
    let lanes = Memo::new(move |_| {
        deck.readings.track();
        deck.with_fold(|fold| {
            let port = port.get();
            fold.latest
                .keys()
                .filter(|(at, out, _)| *at == port && *out != heard)
                .cloned()
                .collect::<Vec<_>>()
        })
    });
    view! {
        {move || lanes.get().into_iter().map(|lane| view! { <Row lane chosen/> }).collect_view()}
        <p class="quiet" class:hidden=move || lanes.with(|lanes| !lanes.is_empty())>"nothing yet"</p>
    }
}

#[component]
fn Row(lane: Lane, chosen: Chosen) -> impl IntoView {
    let deck = Deck::here();
    let dictionary = Dictionary::here();
    let (line, when) = latest(deck, lane.clone());
    let text = Memo::new(move |_| {
        line.with(|line| {
            line.as_ref()
                .map(|line| line.text.clone())
                .unwrap_or_default()
        })
    });
    let mine = StoredValue::new(lane.clone());
    let field = Signal::derive(move || {
        chosen.with(|chosen| match chosen {
            Some((lane, field)) if mine.with_value(|mine| mine == lane) => Some(*field),
            _ => None,
        })
    });
    let chips = move || {
        let (text, field) = (text.get(), field.get());
        dictionary.chips(&text, field).unwrap_or_else(|| {
            let mut plain = Drawing::new();
            plain.element("span", "quiet", text);
            plain.markup()
        })
    };
    let choose = move |event: MouseEvent| {
        if let Some(field) = tapped(&event) {
            chosen.set(Some((mine.get_value(), field)));
        }
    };
    view! {
        <div class="line-row" class:selected=move || field.get().is_some() data-line=lane.2>
            <span class="when">{move || when.get()}</span>
            <span class="chips" inner_html=chips on:click=choose></span>
        </div>
    }
}

/// Number of the field whose chip was tapped.
fn tapped(event: &MouseEvent) -> Option<usize> {
    let target: Element = event.target()?.dyn_into().ok()?;
    let chip = target.closest("[data-field]").ok()??;
    chip.get_attribute("data-field")?.parse().ok()
}

/// The latest line of a lane, and its age and period in words.
fn latest(deck: Deck, lane: Lane) -> (Memo<Option<Line>>, Memo<String>) {
    let key = StoredValue::new(lane);
    let found = Memo::new(move |_| {
        deck.readings.track();
        deck.with_fold(|fold| key.with_value(|key| fold.latest.get(key).cloned()))
    });
    let line =
        Memo::new(move |_| found.with(|found| found.as_ref().map(|found| found.line.clone())));
    let when = Memo::new(move |_| {
        let now = deck.readings.with(|readings| readings.now.0);
        found.with(|found| {
            found.as_ref().map_or_else(String::new, |found| {
                let age = now.saturating_sub(found.line.at);
                if age > 2_000 {
                    format!("{} ago", format::seconds(age))
                } else {
                    format!("{} s", format::fixed(found.period as f64 / 1_000.0, 1))
                }
            })
        })
    });
    (line, when)
}

/// The table of the sentence that is looked at.
#[component]
fn Looked(chosen: Chosen) -> impl IntoView {
    let deck = Deck::here();
    let dictionary = Dictionary::here();
    let text = Memo::new(move |_| {
        deck.readings.track();
        chosen.with(|chosen| {
            let (lane, _) = chosen.as_ref()?;
            deck.with_fold(|fold| fold.latest.get(lane).map(|latest| latest.line.text.clone()))
        })
    });
    let table = move || {
        let field = chosen.with(|chosen| chosen.as_ref().map(|(_, field)| *field));
        let table = text.with(|text| dictionary.table(text.as_ref()?, field));
        table.unwrap_or_else(|| {
            "<p class=\"explained quiet\">Tap a field: it is explained here.</p>".to_owned()
        })
    };
    view! {
        <section class="looked" inner_html=table></section>
    }
}

/// What the checker finds in the dialogue of this port, from the lines that the page holds on (CON-2).
#[component]
fn Checked(port: RwSignal<usize>) -> impl IntoView {
    let deck = Deck::here();
    let dictionary = Dictionary::here();
    // The port that is checked, and the last line of it that was.
    let until = StoredValue::new((usize::MAX, 0_u64));
    let found = Memo::new(move |before: Option<&String>| {
        deck.log.track();
        let port = port.get();
        let (checked, last) = until.get_value();
        let after = if checked == port { last } else { 0 };
        let mut newest = after;
        let mut text = String::new();
        deck.with_fold(|fold| {
            let fresh = |line: &&Line| line.port == port && line.seq > after;
            for Line {
                seq,
                at,
                text: said,
                ..
            } in fold.log.iter().filter(fresh)
            {
                newest = *seq;
                text += &format!("{seq}\t{at}\t{said}\n");
            }
        });
        let follows = dictionary.follow(&text, checked != port);
        if follows.is_some() {
            until.set_value((port, newest));
        }
        follows.or_else(|| before.cloned()).unwrap_or_default()
    });
    view! { <section class="lane check" inner_html=move || found.get()></section> }
}

/// The last lines as they came.
#[component]
fn Log(port: RwSignal<usize>) -> impl IntoView {
    let deck = Deck::here();
    let held = RwSignal::new(false);
    let text = Memo::new(move |before: Option<&String>| {
        deck.readings.track();
        if held.get()
            && let Some(before) = before
        {
            return before.clone();
        }
        let port = port.get();
        deck.with_fold(|fold| {
            let lines: Vec<_> = fold
                .log
                .iter()
                .rev()
                .filter(|line| line.port == port)
                .take(40)
                .map(|Line { at, dir, text, .. }| {
                    let arrow = if *dir == Direction::In { '<' } else { '>' };
                    format!("{:>5}.{:03} {arrow} {text}", at / 1_000, at % 1_000)
                })
                .collect();
            lines.join("\n")
        })
    });
    view! {
        <section class="lane log">
            <button
                type="button"
                data-command="hold-log"
                aria-pressed=move || if held.get() { "true" } else { "false" }
                on:click=move |_| held.update(|held| *held = !*held)
            >
                "HOLD"
            </button>
            <pre>{move || text.get()}</pre>
        </section>
    }
}

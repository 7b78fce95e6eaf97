//! The right column: heading, rudder, rate of turn, cross-track distance, speeds, position, drift.

use crate::deck::Deck;
use crate::reading::{Reading, state_name};
use crate::readings::Readings;
use crate::value::{Badge, Shown, Value, shown};
use crate::{format, gauge, gauge::Bar, situation};
use leptos::prelude::*;
use wheelover_core::limits::Freshness;
use wheelover_core::view::{self, ModeName};

/// The right column.
#[component]
pub(super) fn Instruments() -> impl IntoView {
    view! {
        <aside class="right">
            <HeadingPanel/>
            <RudderPanel/>
            <RatePanel/>
            <CrossTrackPanel/>
            <Cells/>
            <Terms/>
        </aside>
    }
}

#[component]
fn HeadingPanel() -> impl IntoView {
    let heading = shown(|r| &r.heading, format::direction);
    let rows = [
        ("HTS", "hts", shown(|r| &r.hts, format::direction)),
        ("TRACK", "track", shown(|r| &r.track, format::direction)),
        ("COG", "cog", shown(|r| &r.cog, format::direction)),
    ];
    let deck = Deck::here();
    let own = |of: &Option<view::Snapshot>| of.as_ref()?.own.as_ref().map(|own| own.magnetic);
    let north = move || match deck.own.with(own) {
        Some(true) => "HDG °M ",
        _ => "HDG °T ",
    };
    view! {
        <section class="hdg">
            <div>
                <p class="label">{north}{move || heading.with(|h| h.port.clone())}<Badge shown=heading/></p>
                <dl class="rows">
                    {rows
                        .into_iter()
                        .map(|(label, name, shown)| {
                            view! {
                                <dt>{label}</dt>
                                <dd><Value name shown/>" "<Badge shown/></dd>
                            }
                        })
                        .collect_view()}
                </dl>
            </div>
            <div class="big"><Value name="heading" shown=heading/></div>
        </section>
    }
}

/// A bar on the screen; drawn anew only when it changes.
#[component]
fn Gauge(bar: Memo<Bar>, ticks: u32, label: &'static str) -> impl IntoView {
    view! {
        <svg
            class="gauge"
            class:pair=move || bar.with(|bar| bar.port.is_some())
            viewBox=move || bar.with(Bar::view)
            role="img"
            aria-label=label
            inner_html=move || bar.with(|bar| bar.markup(ticks))
        ></svg>
    }
}

#[component]
fn RudderPanel() -> impl IntoView {
    let deck = Deck::here();
    let response = shown(|r| &r.rudder, |angle| format::sided(angle, 1));
    let order = shown(|r| &r.order, |angle| format::sided(angle, 1));
    let bar = Memo::new(move |_| {
        let limit = deck
            .own
            .with(|own| own.as_ref()?.own.as_ref().map(|own| own.rudder_limit));
        deck.readings.with(|r| {
            let (port, note) = pair(deck, r);
            Bar {
                value: r.rudder.value,
                order: r.order.value,
                full: 35.0,
                limit: limit.filter(|limit| *limit < 35.0),
                note,
                port,
                ..Bar::default()
            }
        })
    });
    view! {
        <section>
            <div class="head">
                <p class="label">
                    "RUDDER ° "<span class="quiet">"order "<Value name="rudder-order" shown=order/></span>
                    <Badge shown=response/>
                </p>
                <span class="mid"><Value name="rudder-response" shown=response/></span>
            </div>
            <Gauge bar ticks=7 label="rudder order and response"/>
        </section>
    }
}

/// What a second scale shows, where there is an independent pair of rudders, and the words under the last one (DSP-3).
fn pair(deck: Deck, readings: &Readings) -> (Option<[Option<f64>; 2]>, String) {
    let own = |of: &Option<view::Snapshot>| Some(of.as_ref()?.own.as_ref()?.pair);
    let heard = readings.port_rudder.state != Freshness::Never;
    let limit = limited(deck);
    if !deck.own.with(own).unwrap_or(heard) {
        return (None, limit);
    }
    let port = [readings.port_rudder.value, readings.port_order.value];
    let [is, order] = port.map(|angle| format::sided(angle, 1));
    (Some(port), format!("P {is} order {order} {limit}"))
}

fn limited(deck: Deck) -> String {
    deck.own
        .with(|own| match own.as_ref().and_then(|s| s.own.as_ref()) {
            Some(own) if own.limited => format!("AT LIMIT {}", format::fixed(own.rudder_limit, 0)),
            Some(own) => format!("limit {}", format::fixed(own.rudder_limit, 0)),
            None => String::new(),
        })
}

#[component]
fn RatePanel() -> impl IntoView {
    let deck = Deck::here();
    let rate = shown(|r| &r.rot, |rate| format::sided(rate, 0));
    let bar = Memo::new(move |_| {
        deck.readings.with(|r| {
            let largest = r
                .rot
                .value
                .unwrap_or(0.0)
                .abs()
                .max(r.rot_set.value.unwrap_or(0.0).abs());
            Bar {
                value: r.rot.value,
                order: r.rot_set.value,
                full: gauge::full_scale(largest, &[60.0, 120.0, 300.0]),
                limit: None,
                over: false,
                note: r.rot_set.value.map_or_else(String::new, |rate| {
                    format!("set {}", format::sided(Some(rate), 1))
                }),
                port: None,
            }
        })
    });
    view! {
        <section>
            <div class="head">
                <p class="label">"ROT °/min "{move || rate.with(|r| r.port.clone())}<Badge shown=rate/></p>
                <span class="mid"><Value name="rot" shown=rate/></span>
            </div>
            <Gauge bar ticks=6 label="rate of turn"/>
        </section>
    }
}

#[component]
fn CrossTrackPanel() -> impl IntoView {
    let deck = Deck::here();
    let xtd = shown(|r| &r.xtd, |metres| format::sided(metres, 0));
    let next = shown(|r| &r.xtd_next, |metres| format::sided(metres, 0));
    let words = Memo::new(move |_| format::cross_track_words(situation::current(deck)));
    let limits = Memo::new(move |_| {
        let (leg, watched) = deck.own.with(|own| {
            let own = own.as_ref();
            let leg = own
                .and_then(|own| own.chart.as_ref())
                .map(|chart| chart.leg);
            let own = own.and_then(|own| own.own.as_ref());
            (leg, own.map(|own| own.cross_track_limit))
        });
        deck.route.with(|route| {
            let planned = leg.and_then(|leg| route.waypoints.get(leg + 1));
            let planned = planned.map(|waypoint| waypoint.xtd_m);
            planned.or_else(|| watched.map(|limit| [limit, limit]))
        })
    });
    let bar = Memo::new(move |_| {
        let limits = limits.get();
        let limit = limits.map(|[port, stbd]| port.min(stbd));
        deck.readings.with(|r| {
            let largest = r
                .xtd
                .value
                .unwrap_or(0.0)
                .abs()
                .max(limit.unwrap_or(0.0) * 1.2);
            let full = gauge::full_scale(largest, &[60.0, 120.0, 240.0, 500.0, 1000.0, 2000.0]);
            let (over, note) = gauge::corridor(r.xtd.value, limits);
            Bar {
                value: r.xtd.value,
                order: None,
                full,
                limit,
                over,
                note,
                port: None,
            }
        })
    });
    view! {
        <section>
            <div class="head">
                <p class="label">
                    {move || words.get().0}
                    <span class="quiet">
                        {move || words.get().1}
                        <Value name="xtd-next-leg" shown=next/>
                    </span>
                    <Badge shown=xtd/>
                </p>
                <span class="mid"><Value name="xtd" shown=xtd/></span>
            </div>
            <Gauge bar ticks=6 label="cross-track distance"/>
        </section>
    }
}

#[component]
fn Cells() -> impl IntoView {
    let deck = Deck::here();
    let sog = shown(|r| &r.sog, format::speed);
    let stw = shown(|r| &r.stw, format::speed);
    let drift = shown(|r| &r.drift, |angle| format::sided(angle, 1));
    let position = Memo::new(move |_| deck.readings.with(position_of));
    let text = Memo::new(move |_| position.with(|(_, lines)| lines.clone()));
    let badge = Memo::new(move |_| position.with(|(shown, _)| shown.clone()));
    view! {
        <section class="cells">
            <Cell label="SOG" name="sog" unit="kn" shown=sog/>
            <Cell label="STW" name="stw" unit="kn" shown=stw/>
            <div class="cell">
                <p class="label">"POS "{move || badge.with(|b| b.port.clone())}<Badge shown=badge/></p>
                <p
                    class="number two"
                    data-value="position"
                    data-state=move || badge.with(|b| state_name(b.state))
                >
                    {move || text.with(|(lat, _)| lat.clone())}
                    <br/>
                    {move || text.with(|(_, lon)| lon.clone())}
                </p>
            </div>
            <Cell label="DRIFT" name="drift" unit="°" shown=drift/>
        </section>
    }
}

fn position_of(readings: &Readings) -> (Shown, (String, String)) {
    let reading: &Reading<_> = &readings.position;
    (
        Shown::of(reading, String::new()),
        format::position(reading.value),
    )
}

#[component]
fn Cell(
    label: &'static str,
    name: &'static str,
    unit: &'static str,
    shown: Memo<Shown>,
) -> impl IntoView {
    view! {
        <div class="cell">
            <p class="label">{label}" "{move || shown.with(|s| s.port.clone())}<Badge shown/></p>
            <p class="number"><Value name shown/><span class="unit">{unit}</span></p>
        </div>
    }
}

/// Why the rudder moves: the parts of the order, from the autopilot itself. An order that is held has none (FA7).
#[component]
fn Terms() -> impl IntoView {
    let deck = Deck::here();
    let own = Memo::new(move |_| {
        deck.own.with(|own| {
            let own = own.as_ref()?.own.as_ref()?;
            let held = own.mode == ModeName::RudderHold;
            Some((own.terms, own.rudder_order.filter(|_| held)))
        })
    });
    let terms = move || own.get().and_then(|(terms, _)| terms);
    let held = move || own.get().and_then(|(_, held)| held);
    let part = move |name: &'static str, of: fn(view::Terms) -> f64| {
        let text = move || format::sided(terms().map(of), 1);
        view! { <span class:hidden=move || held().is_some()><small>{name}</small>" "{text}</span> }
    };
    view! {
        <section class="terms" data-value="terms">
            <span class="label">"ORDER ="</span>
            <b class:hidden=move || held().is_none()>{move || format!("HELD {}", format::sided(held(), 1))}</b>
            {part("heading", |terms| terms.proportional)}
            {part("rate", |terms| terms.rate)}
            {part("bias", |terms| terms.integral)}
            {part("turn", |terms| terms.feedforward)}
        </section>
    }
}

//! What this is, and what it is not (AP-17).

use crate::deck::Deck;
use crate::heard::Agreement;
use leptos::prelude::*;

/// The page about the program.
#[component]
pub(crate) fn About() -> impl IntoView {
    let deck = Deck::here();
    let facts = move || {
        deck.greeting.with(|greeting| {
            greeting.as_ref().map_or_else(
                || "not connected".to_owned(),
                |greeting| {
                    format!(
                        "version {}, {} sentences, shows the {} of {}",
                        greeting.build,
                        greeting.dictionary,
                        greeting.station.replace('_', " "),
                        if greeting.simulated {
                            "a simulated ship"
                        } else {
                            "a real installation"
                        },
                    )
                },
            )
        })
    };
    let agreement = move || match deck.agreement.get() {
        Agreement::Unknown => "not compared yet",
        Agreement::Agree => "agrees with the server's, digest by digest",
        Agreement::Disagree => "DIFFERS from the server's: reload the page and report it",
    };
    view! {
        <main class="about">
            <h1>"Wheelover"</h1>
            <p class="notice">
                "Not approved as a track control system under SOLAS. For non-SOLAS ships and leisure craft only. "
                "It is an aid: the officer of the watch remains responsible, keeps a look-out, and can take over at any moment with STANDBY."
            </p>
            <p>
                "Wheelover is a track-control autopilot that faces a chart system over NMEA 0183. This page reads the same lines as the autopilot, with the same code, and computes the age of every value itself."
            </p>
            <p>"Server: "{facts}</p>
            <p>"This page's picture "<span data-value="agreement">{agreement}</span>"."</p>
            <p>"The plan is not a chart. Positions are on WGS 84."</p>
            <p>"The file "<a href="/decoder.html">"decoder.html"</a>" explains sentences without a server or a network; keep a copy."</p>
            <p>"MIT or Apache-2.0. Colours after the OpenBridge Design System (Apache-2.0)."</p>
        </main>
    }
}

//! Which of the six situations the dialogue is in, and the words for it.

use crate::deck::Deck;
use crate::format;
use leptos::prelude::*;
use wheelover_core::geo::{Plane, Position};
use wheelover_core::route::foreign::Told;
use wheelover_core::units::wrap_180;
use wheelover_core::view::ModeName;

/// The route is sailed to its end.
pub(crate) const END: u8 = 6;

/// The words for a situation (interface.md 4).
#[must_use]
pub(crate) const fn words(situation: u8) -> &'static str {
    match situation {
        1 => "not active",
        2 => "on the first leg",
        3 => "wheel-over passed: on the forwarding distance",
        4 => "on the radius",
        5 => "turn finished: on the leg",
        END => "end of route",
        _ => "not known",
    }
}

/// The situation: from our chart-system side, else from what a foreign one says.
#[must_use]
pub(crate) fn current(deck: Deck) -> Option<u8> {
    // Heard sentences are believed longer than the link.
    if deck.link.get().lost() {
        return None;
    }
    let own = deck.own.with(|own| {
        own.as_ref()
            .and_then(|s| s.chart.as_ref())
            .map(|c| c.situation)
    });
    own.or_else(|| told(deck).situation)
}

/// What the sentences of a foreign chart system tell of the path, in a plane at the ship.
#[must_use]
pub(crate) fn told(deck: Deck) -> Told {
    deck.readings.with(|readings| {
        let ship = readings.position.value;
        let plane = Plane::at(ship.unwrap_or(Position { lat: 0.0, lon: 0.0 }));
        deck.with_fold(|fold| fold.told(readings.now, &plane))
    })
}

/// What the top bar says: headline and detail.
#[must_use]
pub(crate) fn headline(deck: Deck) -> (String, String) {
    deck.readings.with(|readings| {
        let waypoint = format::waypoint(readings.waypoint.value.as_deref());
        let track = readings.track.value;
        let Some(track) = track else {
            return (String::new(), String::new());
        };
        let remote = deck.own.with(|own| {
            let own = own.as_ref().and_then(|snapshot| snapshot.own.as_ref());
            own.is_some_and(|own| own.mode == ModeName::AutonavTn)
        });
        let turning = if remote {
            readings.rot_set.value.is_some()
        } else {
            readings.radius.value.is_some()
        };
        let side = match readings.heading.value {
            Some(heading) if wrap_180(track - heading) < 0.0 => "PORT",
            Some(_) => "STBD",
            None => "",
        };
        format::headline(remote, turning.then_some(side), track, &waypoint)
    })
}

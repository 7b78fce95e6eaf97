//! Which of the six situations the dialogue is in, and the words for it.

use crate::deck::Deck;
use crate::format;
use leptos::prelude::*;
use wheelover_core::nmea::SteeringMode;
use wheelover_core::picture::Picture;
use wheelover_core::time::Stamp;
use wheelover_core::units::wrap_180;
use wheelover_core::view::ModeName;

/// The words for a situation (interface.md 4).
#[must_use]
pub(crate) const fn words(situation: u8) -> &'static str {
    match situation {
        1 => "not active",
        2 => "on the first leg",
        3 => "wheel-over passed: on the forwarding distance",
        4 => "on the radius",
        5 => "turn finished: on the leg",
        6 => "end of route",
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
    own.or_else(|| {
        deck.readings
            .with(|r| deck.with_fold(|fold| heard(&fold.picture, r.now)))
    })
}

/// The situation as the sentences of a foreign chart system show it.
fn heard(picture: &Picture, now: Stamp) -> Option<u8> {
    use wheelover_core::limits::Quantity::Control;
    let htc = &picture.htc.as_ref()?.usable(Control, now)?.htc;
    let metres = |miles: Option<f64>| miles.unwrap_or(0.0) * 1852.0;
    let xte = picture
        .xte
        .as_ref()
        .and_then(|x| x.usable(Control, now))
        .and_then(|x| x.cross_track);
    let pney1 = picture
        .pney1
        .as_ref()
        .and_then(|x| x.usable(Control, now))
        .and_then(|x| x.cross_track);
    match htc.steering_mode? {
        SteeringMode::TrackControl => Some(match htc.radius {
            None => 2,
            Some(_) if libm::fabs(metres(xte) - metres(pney1)) < 2.0 => 3,
            Some(_) => 4,
        }),
        SteeringMode::StandAlone => Some(1),
        _ => None,
    }
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

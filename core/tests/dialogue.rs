//! The embedded voyage under the checker (CON-1, CON-2): a whole round without a breach, the situations in
//! order (TCS-1), the ship within 50 m of every leg and arc.
#![allow(clippy::unwrap_used)]

use wheelover_core::conformance::{Breach, Checker};
use wheelover_core::nmea::{Htd, SteeringMode, Xte, decode};
use wheelover_core::station::Profile;
use wheelover_core::time::Stamp;
use wheelover_core::view::{ChartRequest, Line, ModeRequest, Order, Origin, hello};
use wheelover_core::voyage::{Event, Voyage, VoyageOutput};

struct Sailed {
    checker: Checker,
    breaches: Vec<Breach>,
    /// Largest distance off leg or arc under track control, metres, and when.
    widest: (f64, f64),
}

/// A round by the scripted officer, or in "Tn" by hand.
fn sail(seed: u64, seconds: u64, by_hand: Option<ChartRequest>) -> Sailed {
    let mut voyage = Voyage::embedded(seed);
    let ecdis = hello(&voyage, "test")
        .ports
        .iter()
        .position(|port| port.profile == Profile::Ecdis)
        .unwrap();
    let mut checker = Checker::new();
    let mut breaches = Vec::new();
    let mut out = Vec::new();
    let (mut mode, mut since) = (None, 0.0);
    let mut widest = (0.0, 0.0);
    for step in 1..=seconds * 10 {
        voyage.handle(Stamp(step * 100), Event::Tick, &mut out);
        let button = by_hand.and_then(|request| match step {
            1 => Some(Order::Officer(false)),
            20 => Some(Order::Mode(ModeRequest::Auto)),
            60 => Some(Order::Chart(request)),
            100 => Some(Order::Mode(ModeRequest::Autonav)),
            _ => None,
        });
        if let Some(action) = button {
            let event = Event::Order {
                id: step,
                by: Origin::Officer,
                order: action,
            };
            voyage.handle(Stamp(step * 100), event, &mut out);
        }
        for output in out.drain(..) {
            let VoyageOutput::Line(Line {
                seq,
                at,
                port,
                text,
                ..
            }) = output
            else {
                continue;
            };
            if port != ecdis {
                continue;
            }
            let at = at as f64 / 1000.0;
            checker.take(seq, Some(at), text.as_bytes(), &mut breaches);
            let sentence = decode(text.as_bytes());
            if let Some(htd) = Htd::from_sentence(&sentence)
                && htd.steering_mode != mode
            {
                (mode, since) = (htd.steering_mode, at);
            }
            if let Some(xte) = Xte::from_sentence(&sentence)
                && matches!(
                    mode,
                    Some(SteeringMode::TrackControl | SteeringMode::HeadingControl)
                )
                && at - since > 5.0
            {
                let off = xte.cross_track.unwrap_or(0.0).abs() * 1852.0;
                if off > widest.0 {
                    widest = (off, at);
                }
            }
        }
    }
    checker.finish(&mut breaches);
    Sailed {
        checker,
        breaches,
        widest,
    }
}

impl Sailed {
    /// The situations in their order.
    fn situations(&self) -> Vec<u8> {
        let spans = self.checker.spans().iter();
        spans.map(|span| span.situation).collect()
    }
}

#[test]
fn a_round_of_the_embedded_voyage_has_no_breach() {
    let sailed = sail(1, 4_200, None);
    let situations = sailed.situations();
    assert!(sailed.breaches.is_empty(), "{:#?}", sailed.breaches);
    let first_end = situations
        .iter()
        .position(|situation| *situation == 6)
        .unwrap();
    let round = &situations[..=first_end];
    assert_eq!(round[..2], [1, 2], "{round:?}");
    assert_eq!(round.last(), Some(&6));
    for turn in round[2..first_end].chunks(3) {
        assert_eq!(turn, [3, 4, 5], "{round:?}");
    }
    println!("widest {:?}, situations {situations:?}", sailed.widest);
    assert!(sailed.widest.0 <= 50.0, "{:?}", sailed.widest);
}

// TCS-12
#[test]
fn a_round_in_tn_has_no_breach_and_stays_near_the_track() {
    let sailed = sail(2, 3_600, Some(ChartRequest::Heading));
    assert!(sailed.breaches.is_empty(), "{:#?}", sailed.breaches);
    let situations = sailed.situations();
    println!("widest {:?}, situations {situations:?}", sailed.widest);
    assert_eq!(situations, [1, 6]);
    assert!(sailed.widest.0 <= 120.0, "{:?}", sailed.widest);
}

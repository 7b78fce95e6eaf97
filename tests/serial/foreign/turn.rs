//! Trials at a turn: a centre that does not come or does not fit, glitches on the arc, a track that follows the arc.

use super::{Trial, edited, spoil};
use std::path::Path;
use wheelover_core::alerts::Alert;
use wheelover_tests::foreign::{Foreign, Sailing, whole};

pub(super) const TRIALS: &[Trial] = &[
    ("radius without centre", radius_without_centre),
    ("centre by forwarding time", centre_by_forwarding_time),
    ("wrong centre", wrong_centre),
    ("glitches on the arc", glitches_on_the_arc),
    ("track along the arc", track_along_the_arc),
];

/// A ship half a minute before the wheel-over line.
fn near_the_turn() -> Foreign {
    Foreign {
        turn: 30.0,
        lead: 32.0,
        ..Foreign::default()
    }
}

/// The same under track control.
fn before_the_turn(folder: &Path) -> Sailing {
    let ship = near_the_turn().sail(folder);
    ship.engage();
    assert_eq!(ship.log().situation, 2, "engaged too late");
    ship
}

fn turned(heading: f64) -> f64 {
    (heading - 245.0 + 540.0).rem_euclid(360.0) - 180.0
}

// TCS-8: never straight on into the bank.
fn radius_without_centre(folder: &Path) {
    let ship = Foreign {
        ship: "length_m = 45\nspeed_kn = 9.7\ngain_per_s = 0.5\ntime_constant_s = 31\n",
        ..near_the_turn()
    };
    let ship = ship.sail(folder);
    ship.engage();
    spoil(&ship, "PNEY,002", &[(2, ""), (3, ""), (4, ""), (5, "")]);
    ship.until("wheel over", 60.0, |log| log.situation == 3);
    ship.until("TRACK FAIL", 10.0, |log| log.raised(Alert::TrackFail));
    ship.until("the arc", 40.0, |log| log.situation == 4);
    ship.until("the turn", 60.0, |log| turned(log.heading) > 20.0);
}

// Where the forwarding time is known, the arc is certain from leg, radius and place.
fn centre_by_forwarding_time(folder: &Path) {
    let ship = before_the_turn(folder);
    spoil(&ship, "PNEY,002", &[(2, ""), (3, ""), (4, ""), (5, "")]);
    ship.until("the arc", 90.0, |log| log.situation == 4);
    ship.until("the turn", 60.0, |log| turned(log.heading) > 20.0);
    let log = ship.log();
    assert_eq!(log.htd(4), "T");
    assert!(log.off_path.abs() < 50.0, "{} m", log.off_path);
}

// TCS-4: refused with what does not fit; TRACK FAIL when it stays.
fn wrong_centre(folder: &Path) {
    let ship = before_the_turn(folder);
    spoil(&ship, "PNEY,002", &[(2, "6835.234")]);
    let over = ship.until("wheel over", 60.0, |log| log.situation == 3);
    ship.until("TRACK FAIL", 10.0, |log| log.raised(Alert::TrackFail));
    let log = ship.log();
    assert!(log.largest_order(over) < 3.0, "{}", log.largest_order(over));
    assert!(log.htd.iter().all(|(_, htd)| htd[8] != "0.300"), "echoed");
}

// A single glitch in a turn changes nothing; at last the leg is reached.
fn glitches_on_the_arc(folder: &Path) {
    let ship = before_the_turn(folder);
    ship.until("the arc", 90.0, |log| log.situation == 4);
    ship.run(8.0);
    let glitches: [(&str, &[(usize, &str)]); 4] = [
        ("EIHTC", &[(8, "")]),
        ("EIHTC", &[(8, "99.0")]),
        ("EIHTC", &[(12, "30.0")]),
        ("PNEY,002", &[(2, "6835.234")]),
    ];
    for (begin, changes) in glitches {
        let before = ship.log().orders.last().map_or(0.0, |(_, order)| *order);
        let mut once = true;
        ship.tap(move |port, body| {
            let hit = once && body.starts_with(begin);
            once &= !hit;
            if hit {
                vec![(port, edited(body, changes))]
            } else {
                whole(port, body)
            }
        });
        ship.always(&format!("{begin} {changes:?} once"), 3.0, |log| {
            let order = log.orders.last().map_or(0.0, |(_, order)| *order);
            log.htd(4) == "T" && log.htd(8) == "0.300" && (order - before).abs() < 4.0
        });
    }
    let rate: f64 = ship.log().htd(9).parse().unwrap();
    assert!(rate > 10.0, "rate in use {rate}");
    stays_on_the_arc(&ship);
}

// HTC-3: the commanded track is the tangent of the arc.
fn track_along_the_arc(folder: &Path) {
    let ship = before_the_turn(folder);
    let mut heading = 245.0_f64;
    ship.tap(move |port, body| {
        if let Some(said) = body.strip_prefix("HEHDT,") {
            heading = said.trim_end_matches(",T").parse().unwrap_or(heading);
        }
        let turning = body.starts_with("EIHTC") && body.split(',').nth(8) == Some("0.300");
        let tangent = format!("{:.1}", heading.clamp(245.0, 275.0));
        if turning {
            vec![(port, edited(body, &[(12, &tangent)]))]
        } else {
            whole(port, body)
        }
    });
    ship.until("the arc", 90.0, |log| log.situation == 4);
    stays_on_the_arc(&ship);
}

/// Within 30 m of the arc to its end, and under track control on the next leg.
fn stays_on_the_arc(ship: &Sailing) {
    let mut worst = 0.0_f64;
    let end = ship.now() + 120.0;
    while ship.log().situation == 4 {
        worst = worst.max(ship.log().off_path.abs());
        assert!(ship.now() < end, "the arc has no end");
        ship.run(0.05);
    }
    assert!(worst < 30.0, "{worst} m off the arc");
    ship.run(3.0);
    let log = ship.log();
    assert_eq!((log.situation, log.htd(4)), (5, "T"));
    println!("{worst:.1} m off the arc");
}

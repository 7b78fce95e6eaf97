//! While engaged, on a leg, on the forwarding distance and on the arc: absurd, missing, jumping and contradictory commands
//! move nothing, are named, are never echoed, and are TRACK FAIL when they last (SEN-5, TCS-4, TCS-8, HTC-3, FB13).

use crate::rig::{Rig, edited};
use wheelover_core::alerts::Alert;
use wheelover_core::nmea::with_checksum;
use wheelover_core::station::Profile;
use wheelover_core::time::Stamp;
use wheelover_core::view::{ModeName, ModeRequest, Order};

/// Under track control in a situation: 2 on the leg, 3 before the arc, 4 on it.
fn at(situation: u8) -> Rig {
    let mut rig = Rig::tracking();
    rig.until("the situation", 900.0, |rig| {
        rig.chart().situation() == situation
    });
    rig.run(match situation {
        2 => 60.0,
        3 => 8.0,
        _ => 30.0,
    });
    assert_eq!(rig.chart().situation(), situation);
    rig
}

/// One way to spoil a sentence: its formatter, and the fields by number.
type Spoil = (&'static str, &'static [(usize, &'static str)]);

fn spoil(rig: &mut Rig, (formatter, changes): Spoil, until: Stamp) {
    rig.filter(move |now, from, line| {
        let hit = from == Profile::Ecdis && now <= until && line.contains(formatter);
        Some(if hit {
            edited(line, changes)
        } else {
            line.to_string()
        })
    });
}

fn order(rig: &Rig) -> f64 {
    rig.autopilot()
        .rudder_order()
        .map_or(0.0, |order| order.deg())
}

/// Sails a spoiled rig beside a sound one; the largest difference of the orders while the spoiled one is engaged.
fn beside(mut spoiled: Rig, situation: u8, seconds: f64) -> (Rig, f64, Option<f64>) {
    let mut sound = at(situation);
    let (begun, mut apart, mut failed) = (sound.now, 0.0_f64, None);
    while sound.now.since(begun) < (seconds * 1000.0) as u64 {
        sound.step();
        spoiled.step();
        if spoiled.mode() == ModeName::AutonavTi {
            apart = apart.max((order(&spoiled) - order(&sound)).abs());
        } else if failed.is_none() {
            failed = Some(spoiled.now.since(begun) as f64 / 1000.0);
        }
    }
    spoiled.check_orders();
    (spoiled, apart, failed)
}

const ON_A_LEG: [Spoil; 14] = [
    ("PNEY,001", &[(4, "0.050")]),
    ("PNEY,001", &[(4, ""), (5, "")]),
    ("XTE", &[(3, "0.050")]),
    ("XTE", &[(3, ""), (4, "")]),
    ("HTC,", &[(8, "0.5")]),
    ("HTC,", &[(12, "335.0")]),
    ("HTC,", &[(12, "155.0")]),
    ("HTC,", &[(13, "M")]),
    ("HTC,", &[(8, "0.000")]),
    ("HTC,", &[(8, "0.001")]),
    ("HTC,", &[(8, "99.0")]),
    ("HTC,", &[(8, "0.5"), (12, "305.0")]),
    ("PNEY,001", &[(4, "3.000")]),
    ("PNEY,001", &[(4, "1.000"), (5, "L")]),
];

const NO_CENTRE: Spoil = ("PNEY,002", &[(2, ""), (3, ""), (4, ""), (5, "")]);

const IN_A_TURN: [Spoil; 13] = [
    ("PNEY,001", &[(4, ""), (5, "")]),
    ("XTE", &[(3, ""), (4, "")]),
    ("HTC,", &[(12, "090.0")]),
    ("HTC,", &[(12, "185.0")]),
    ("HTC,", &[(13, "M")]),
    ("HTC,", &[(8, "0.000")]),
    ("HTC,", &[(8, "99.0")]),
    ("HTC,", &[(8, "2.0")]),
    ("PNEY,001", &[(4, "3.000")]),
    ("PNEY,002", &[(2, "6835.234")]),
    ("PNEY,002", &[(2, "5950.000"), (4, "02500.000")]),
    ("PNEY,002", &[(4, "12343.231"), (5, "W")]),
    ("HTC,", &[(8, "")]),
];

fn spoils(situation: u8) -> &'static [Spoil] {
    if situation == 2 {
        &ON_A_LEG
    } else {
        &IN_A_TURN
    }
}

/// Sails a spoiled rig beside a sound one: its order never moves, and track control goes on.
fn unmoved(spoiled: Rig, situation: u8, seconds: f64, what: &str) -> Rig {
    let (rig, apart, failed) = beside(spoiled, situation, seconds);
    assert_eq!(failed, None, "{what}: {}", rig.autopilot().why());
    assert!(apart < 1.5, "{what}: the order moved by {apart}");
    assert_eq!(rig.mode(), ModeName::AutonavTi, "{what}");
    rig
}

// TCS-4, TCS-8, AP-2
#[test]
fn what_lasts_is_track_fail_and_moves_nothing_before() {
    for situation in [2, 3, 4] {
        for spoiled in spoils(situation) {
            if situation == 3 && *spoiled == ("HTC,", &[(8, "")]) {
                continue; // before the arc that is another next leg's course without a turn: seen on the arc
            }
            let mut rig = at(situation);
            let path = rig.last_htd().clone();
            spoil(&mut rig, *spoiled, Stamp(u64::MAX));
            let (rig, apart, failed) = beside(rig, situation, 9.0);
            let what = format!("situation {situation}, {spoiled:?}");
            let failed = failed.unwrap_or_else(|| panic!("{what}: no TRACK FAIL"));
            assert!((4.0..=6.3).contains(&failed), "{what}: {failed} s");
            assert!(apart < 1.5, "{what}: the order moved by {apart}");
            assert!(rig.raised(Alert::TrackFail), "{what}");
            assert_ne!(rig.text(Alert::TrackFail), "", "{what}");
            let echoed = rig
                .htd
                .iter()
                .filter(|(_, htd)| htd.steering_mode == path.steering_mode)
                .filter(|(at, _)| at.seconds() > rig.now.seconds() - 9.0);
            for (_, htd) in echoed {
                assert_eq!(htd.track, path.track, "{what}: echoed");
                assert_eq!(htd.radius, path.radius, "{what}: echoed");
            }
        }
    }
}

// A single glitch changes nothing.
#[test]
fn a_single_one_changes_nothing() {
    for situation in [2, 3, 4] {
        for spoiled in spoils(situation) {
            let mut rig = at(situation);
            let until = rig.now + 1_000;
            spoil(&mut rig, *spoiled, until);
            let what = format!("situation {situation}, {spoiled:?}");
            unmoved(rig, situation, 12.0, &what);
        }
    }
}

// TCS-4: a position of the chart system's that is off for once is nothing to learn from.
#[test]
fn a_single_position_of_the_chart_system_far_off_changes_nothing() {
    for situation in [2, 3, 4] {
        for minutes in [0.05, 0.1, -1.0, 30.0] {
            let mut rig = at(situation);
            let until = rig.now + 1_000;
            rig.filter(move |now, from, line| {
                if from != Profile::Ecdis || now > until || !line.contains("GLL") {
                    return Some(line.to_string());
                }
                let lat: f64 = line.split(',').nth(1)?.parse().ok()?;
                Some(edited(line, &[(1, &format!("{:09.4}", lat + minutes))]))
            });
            let what = format!("situation {situation}, {minutes} minutes");
            unmoved(rig, situation, 12.0, &what);
        }
    }
}

// SEN-4: the centre is left out on the arc: the turn goes on, and it is said.
#[test]
fn a_turn_whose_centre_is_left_out_is_a_caution() {
    let mut rig = at(4);
    spoil(&mut rig, NO_CENTRE, Stamp(u64::MAX));
    let rig = unmoved(rig, 4, 8.0, "no centre");
    let text = rig.text(Alert::TrackDataRefused);
    assert!(text.contains("PNEY,002 has no centre"), "{text}");
}

// A radius without its centre: never straight on into the bank.
#[test]
fn a_radius_whose_centre_never_comes_is_track_fail_and_the_turn_is_made() {
    let mut rig = at(2);
    spoil(&mut rig, NO_CENTRE, Stamp(u64::MAX));
    rig.until("the wheel-over line", 900.0, |rig| {
        rig.chart().situation() == 3
    });
    rig.until("TRACK FAIL", 7.5, |rig| rig.raised(Alert::TrackFail));
    assert!(rig.text(Alert::TrackFail).contains("PNEY,002"));
    assert_eq!(rig.set_heading(), 305.0);
    rig.until("the turn", 300.0, |rig| {
        (rig.heading().deg() - 305.0).abs() < 3.0
    });
    rig.check_orders();
}

// FB13
#[test]
fn of_two_that_command_the_first_is_obeyed() {
    let mut rig = at(2);
    let set = rig.last_htd().track;
    for _ in 0..20 {
        rig.say(Profile::Ecdis, "IIHTC,V,,,T,R,,,,,,,266.0,T,C");
        rig.run(1.0);
        assert_eq!(rig.last_htd().track, set);
    }
    assert_eq!(rig.mode(), ModeName::AutonavTi);
    assert!(rig.raised(Alert::HtcConflict));
    assert!(rig.text(Alert::HtcConflict).contains("HTC SOURCE CONFLICT"));
    rig.run(6.0);
    assert!(!rig.raised(Alert::HtcConflict), "its way back");
    rig.check_orders();
}

// FA14: three in a row are counted anew after a broken one.
#[test]
fn a_broken_htc_begins_the_row_anew() {
    let mut rig = Rig::tracking();
    rig.command(Order::Mode(ModeRequest::Auto)).unwrap();
    rig.filter(|_, _, line| {
        (!line.contains("HTC,") || line.contains("245.00")).then(|| line.into())
    });
    rig.run(10.0);
    rig.command(Order::Mode(ModeRequest::Autonav)).unwrap();
    let good = "EIHTC,V,,,T,R,,,,,,,245.00,T,C";
    let say = |rig: &mut Rig, broken: bool| {
        let line = with_checksum(good);
        let line = if broken {
            line.replace("*", "*0")
        } else {
            line
        };
        rig.say_raw(Profile::Ecdis, &line);
        rig.run(1.0);
    };
    for broken in [false, false, true, false, false] {
        say(&mut rig, broken);
        assert_eq!(rig.mode(), ModeName::Auto);
    }
    say(&mut rig, false);
    assert_eq!(
        rig.mode(),
        ModeName::AutonavTi,
        "{}",
        rig.autopilot().waits_for(rig.now)
    );
}

// HTC-3: the track is the tangent of the arc.
#[test]
fn a_track_that_follows_the_arc_keeps_the_ship_on_it() {
    let mut rig = at(2);
    let heading = std::sync::Arc::new(std::sync::Mutex::new(245.0));
    let shared = heading.clone();
    rig.filter(move |_, from, line| {
        let turning = line.contains("HTC,") && !line.contains(",R,,,,");
        Some(if from == Profile::Ecdis && turning {
            edited(line, &[(12, &format!("{:05.1}", *shared.lock().unwrap()))])
        } else {
            line.to_string()
        })
    });
    rig.until("the arc", 900.0, |rig| rig.chart().situation() == 4);
    let mut worst = 0.0_f64;
    while rig.chart().situation() == 4 {
        let truth = rig.world().truth();
        *heading.lock().unwrap() = rig.heading().deg().clamp(245.0, 305.0);
        worst = worst.max(crate::rig::off_path(
            &rig.route,
            rig.chart(),
            truth.position,
        ));
        rig.step();
    }
    assert!(worst < 30.0, "{worst} m off the arc");
    assert_eq!(rig.mode(), ModeName::AutonavTi, "{}", rig.autopilot().why());
    rig.check_orders();
}

// The same sweep over every number of every order.
#[test]
fn an_order_out_of_range_is_refused_and_changes_nothing() {
    let mut rig = Rig::tracking();
    rig.command(Order::Mode(ModeRequest::Auto)).unwrap();
    let set = rig.set_heading();
    for value in [400.0, -1.0, 360.1, 1e308, -1e308, f64::NAN, f64::INFINITY] {
        let refused = rig.command(Order::SetHeading(value)).unwrap_err();
        assert!(refused.contains("0 to 360"), "{refused}");
        let by = if value == 400.0 || value.abs() > 1e9 || value.is_nan() {
            value
        } else {
            180.1
        };
        let refused = rig.command(Order::AdjustHeading(by)).unwrap_err();
        assert!(refused.contains("-180 to 180"), "{refused}");
        assert_eq!(rig.set_heading(), set);
    }
    assert!(rig.command(Order::SetHeading(360.0)).is_ok());
}

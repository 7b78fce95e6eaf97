//! The chart system falls silent, stops, lies or speaks damaged sentences under track control (FA1 to FA5, TCS-8 to TCS-10).

use crate::rig::{Rig, edited};
use std::sync::{Arc, Mutex};
use wheelover_core::alerts::Alert;
use wheelover_core::nmea::{self, SteeringMode};
use wheelover_core::station::Profile;
use wheelover_core::time::Stamp;
use wheelover_core::view::{ChartRequest, ModeName, ModeRequest, Order, own};

/// What becomes of a sentence.
type Damage = fn(&str) -> Option<String>;

/// Seconds from the last good sentence to the caution, and to the alarm.
struct Times {
    caution: f64,
    alarm: f64,
}

/// Damages that formatter from now on; gives the times of caution and alarm.
fn lose(rig: &mut Rig, formatter: &'static str, damage: Damage) -> Times {
    let last = Arc::new(Mutex::new(rig.now));
    let seen = last.clone();
    let begin = rig.now + 2_500;
    rig.filter(move |now, from, line| {
        if from != Profile::Ecdis || nmea::decode(line.as_bytes()).formatter != formatter {
            return Some(line.to_string());
        }
        if now < begin {
            *seen.lock().unwrap() = now;
            return Some(line.to_string());
        }
        damage(line)
    });
    rig.run(2.6);
    let caution = rig.until("TRACK DATA LATE", 5.0, |rig| {
        rig.raised(Alert::TrackDataLate)
    });
    assert_eq!(rig.mode(), ModeName::AutonavTi);
    let alarm = rig.until("TRACK FAIL", 5.0, |rig| rig.raised(Alert::TrackFail));
    let since = |at: Stamp| at.since(*last.lock().unwrap()) as f64 / 1000.0;
    Times {
        caution: since(caution),
        alarm: since(alarm),
    }
}

/// The same, and the alarm comes in its time.
fn fail(rig: &mut Rig, formatter: &'static str, what: &str, damage: Damage) {
    let alarm = lose(rig, formatter, damage).alarm;
    assert!((5.0..=5.2).contains(&alarm), "{formatter} {what} {alarm}");
}

/// The same from the beginning; the alarm names the sentence.
fn fail_by_name(formatter: &'static str, damage: Damage) {
    let mut rig = Rig::tracking();
    fail(&mut rig, formatter, "", damage);
    let text = rig.text(Alert::TrackFail);
    assert!(text.contains(formatter), "{text}");
    rig.check_orders();
}

fn nothing(_: &str) -> Option<String> {
    None
}

// FA1
#[test]
fn silent_on_a_leg_holds_the_present_heading() {
    let mut rig = Rig::tracking();
    rig.run(60.0);
    let times = lose(&mut rig, "HTC", nothing);
    assert!((3.0..=3.1).contains(&times.caution), "{}", times.caution);
    assert!((5.0..=5.2).contains(&times.alarm), "{}", times.alarm);
    assert_eq!(rig.mode(), ModeName::Auto);
    // The step that failed steered by the reading before the last.
    let readings = rig.read.iter().rev().take(3);
    let nearest = readings.fold(9.0_f64, |least, read| {
        least.min((rig.set_heading() - read).abs())
    });
    assert!(nearest <= 0.1, "{nearest}");
    assert!(rig.text(Alert::TrackFail).contains("SWITCH TO AUTO"));
    assert!(!rig.raised(Alert::TrackDataLate));
    rig.run(1.1);
    assert_eq!(rig.last_htd().steering_mode, Some(SteeringMode::StandAlone));
    rig.run(60.0);
    let off = rig.heading().deg() - rig.set_heading();
    assert!(off.abs() < 1.5, "{off}");
    rig.check_orders();
}

// FA1: all four at once, and the ship's own reports go on.
#[test]
fn a_dead_cable_is_the_same() {
    let mut rig = Rig::tracking();
    rig.run(30.0);
    let before = rig.htd.len();
    rig.silence(Profile::Ecdis, "");
    rig.until("TRACK FAIL", 6.2, |rig| rig.raised(Alert::TrackFail));
    assert_eq!(rig.mode(), ModeName::Auto);
    rig.run(10.0);
    assert!(rig.htd.len() >= before + 14);
    rig.check_orders();
}

// FA2
#[test]
fn silent_on_the_arc_finishes_the_turn() {
    let mut rig = Rig::tracking();
    rig.until("the arc", 900.0, |rig| rig.chart().situation() == 4);
    rig.run(10.0);
    let times = lose(&mut rig, "HTC", nothing);
    assert!((5.0..=5.2).contains(&times.alarm), "{}", times.alarm);
    assert_eq!(rig.mode(), ModeName::Auto);
    assert!((rig.set_heading() - 305.0).abs() < 0.05);
    // Half a mile at about 15 kn is some 28 degrees a minute.
    let rate = rig.world().truth().rate.deg_per_min();
    assert!((15.0..45.0).contains(&rate), "{rate}");
    rig.run(20.0);
    let rate = rig.world().truth().rate.deg_per_min();
    assert!((18.0..42.0).contains(&rate), "{rate}");
    rig.run(180.0);
    assert!((rig.heading().deg() - 305.0).abs() < 2.0);
    rig.check_orders();
}

// FA2
#[test]
fn silent_on_the_forwarding_distance_turns_where_the_arc_begins() {
    let mut rig = Rig::tracking();
    rig.until("the forwarding distance", 900.0, |rig| {
        rig.chart().situation() == 3
    });
    rig.run(1.5);
    rig.silence(Profile::Ecdis, "HTC");
    rig.until("TRACK FAIL", 6.2, |rig| rig.raised(Alert::TrackFail));
    assert_eq!(rig.mode(), ModeName::Auto);
    assert!((rig.set_heading() - 305.0).abs() < 0.05);
    let at_failure = rig.heading().deg();
    let start = rig.route.turns()[0].start();
    let leg = *rig.route.leg(0);
    let to_go = |rig: &Rig| leg.along(start).m() - leg.along(rig.world().truth().position).m();
    assert!(to_go(&rig) > 60.0, "{}", to_go(&rig));
    rig.until("the beginning of the arc", 60.0, |rig| to_go(rig) < 15.0);
    let turned = rig.heading().deg() - at_failure;
    assert!(turned.abs() < 6.0, "turned {turned} before the arc");
    rig.run(240.0);
    assert!((rig.heading().deg() - 305.0).abs() < 2.0);
    rig.check_orders();
}

// FA3, note 8.1
#[test]
fn stopped_by_the_chart_system_keeps_the_latest_set_heading() {
    let mut rig = Rig::tracking();
    rig.run(40.0);
    let hts = rig.autopilot().hts().map(|hts| hts.deg());
    rig.ask(ChartRequest::Stop).unwrap();
    let before = rig.now;
    rig.until("TRACK FAIL", 1.3, |rig| rig.raised(Alert::TrackFail));
    assert!(rig.now.since(before) <= 1_200);
    assert_eq!(rig.mode(), ModeName::Auto);
    assert!((rig.set_heading() - hts.unwrap()).abs() < 1.0);
    rig.run(3.0);
    assert!(
        rig.text(Alert::TrackFail)
            .contains("stopped by chart system")
    );
    rig.check_orders();
}

// FA3, TCS-10
#[test]
fn the_end_of_the_route_is_named() {
    let mut rig = Rig::tracking();
    rig.until("TRACK FAIL", 1_500.0, |rig| rig.raised(Alert::TrackFail));
    rig.run(2.0);
    assert_eq!(rig.chart().situation(), 6);
    assert!(rig.text(Alert::TrackFail).contains("end of route"));
    assert!((rig.set_heading() - 305.0).abs() < 15.0);
    rig.check_orders();
}

// FA4
#[test]
fn each_sentence_alone_missing_is_named() {
    for formatter in ["HTC", "XTE", "PNEY,001", "PNEY,002"] {
        let mut rig = Rig::tracking();
        let times = lose(&mut rig, formatter, nothing);
        assert!(
            (5.0..=5.2).contains(&times.alarm),
            "{formatter} {}",
            times.alarm
        );
        let text = rig.text(Alert::TrackFail);
        assert!(text.contains(formatter), "{text}");
        assert_eq!(rig.mode(), ModeName::Auto);
        rig.check_orders();
    }
}

// FA4
#[test]
fn each_sentence_alone_with_a_wrong_checksum_is_missing() {
    for formatter in ["HTC", "XTE", "PNEY,001", "PNEY,002"] {
        fail_by_name(formatter, |line| {
            let wrong = if line.ends_with('0') { '1' } else { '0' };
            Some(format!("{}{wrong}", &line[..line.len() - 1]))
        });
    }
}

// FA4: a broken format with a right checksum.
#[test]
fn each_sentence_alone_malformed_is_missing() {
    let malformed: [(&'static str, Damage); 4] = [
        ("HTC", |line| Some(edited(line, &[(12, "400.0")]))),
        ("XTE", |line| Some(edited(line, &[(3, "0.0x1")]))),
        ("PNEY,001", |line| Some(edited(line, &[(5, "Q")]))),
        ("PNEY,002", |line| Some(edited(line, &[(2, "9999.000")]))),
    ];
    for (formatter, damage) in malformed {
        fail_by_name(formatter, damage);
    }
}

// FA5: the status or the mode says not valid; the value would steer the ship away.
#[test]
fn a_distance_that_says_it_is_not_valid_is_never_used() {
    let lies: [(&'static str, &'static str, Damage); 6] = [
        ("XTE", "V", |l| {
            Some(edited(l, &[(1, "V"), (3, "0.400"), (4, "L")]))
        }),
        ("XTE", "E", |l| {
            Some(edited(l, &[(3, "0.400"), (4, "L"), (6, "E")]))
        }),
        ("XTE", "S", |l| {
            Some(edited(l, &[(3, "0.400"), (4, "L"), (6, "S")]))
        }),
        ("XTE", "N", |l| {
            Some(edited(l, &[(3, "0.400"), (4, "L"), (6, "N")]))
        }),
        ("PNEY,001", "V", |l| {
            Some(edited(l, &[(2, "V"), (4, "0.400"), (5, "L")]))
        }),
        ("PNEY,001", "M", |l| {
            Some(edited(l, &[(4, "0.400"), (5, "L"), (7, "M")]))
        }),
    ];
    for (formatter, name, lie) in lies {
        let mut rig = Rig::tracking();
        rig.run(30.0);
        let before = rig.heading().deg();
        fail(&mut rig, formatter, name, lie);
        let turned = rig.heading().deg() - before;
        assert!(turned.abs() < 3.0, "{formatter} {name}: turned {turned}");
        assert_eq!(rig.mode(), ModeName::Auto);
        rig.check_orders();
    }
}

// FA5
#[test]
fn with_an_invalid_xte_track_control_is_not_entered() {
    let mut rig = Rig::new(crate::rig::route(&[(245.0, 2.5), (305.0, 2.5)], 0.5), 3);
    rig.filter(|_, _, line| {
        Some(if line.contains("XTE,") {
            edited(line, &[(1, "V")])
        } else {
            line.to_string()
        })
    });
    rig.run(5.0);
    rig.command(Order::Mode(ModeRequest::Auto)).unwrap();
    rig.run(2.0);
    rig.ask(ChartRequest::Track).unwrap();
    rig.command(Order::Mode(ModeRequest::Autonav)).unwrap();
    rig.run(10.0);
    let own = own(rig.autopilot(), rig.now);
    assert_eq!(own.pending.unwrap().waits_for, "no valid XTE");
    rig.run(11.0);
    assert_eq!(rig.mode(), ModeName::Auto);
    assert!(rig.autopilot().pending().is_none());
}

// TCS-9
#[test]
fn manual_and_rudder_control_by_the_chart_system_are_refused() {
    for letter in ["M", "R"] {
        let mut rig = Rig::tracking();
        rig.run(20.0);
        let line = edited(&rig.line("HTC"), &[(4, letter), (2, "30.0"), (3, "R")]);
        let order = rig.autopilot().rudder_order().unwrap().deg();
        rig.say(Profile::Ecdis, line[1..].split('*').next().unwrap());
        assert_eq!(rig.mode(), ModeName::Auto, "{letter}");
        assert!(rig.raised(Alert::TrackFail));
        rig.silence(Profile::Ecdis, "HTC");
        rig.run(1.0);
        let now = rig.autopilot().rudder_order().unwrap().deg();
        assert!((now - order).abs() < 5.0, "{letter}: {order} -> {now}");
        rig.check_orders();
    }
}

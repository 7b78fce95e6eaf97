//! Trials on a leg: refused, absurd and doubled commands, compasses that fail, her own constants, a receiver beside.

use super::{Trial, edited, spoil};
use std::path::Path;
use wheelover_core::alerts::Alert;
use wheelover_core::settings::Value;
use wheelover_core::view::{ModeRequest, Order};
use wheelover_tests::foreign::{Foreign, Log, Sailing, whole};

pub(super) const TRIALS: &[Trial] = &[
    ("refused reference", refused_reference),
    ("echo on the chart port", echo_on_the_chart_port),
    ("bad headings", bad_headings),
    ("first gyro jumps", first_gyro_jumps),
    ("two commanders", two_commanders),
    ("first order ship", first_order_ship),
    ("absurd commands", absurd_commands),
    ("absurd orders", absurd_orders),
    ("receiver beside", receiver_beside),
    ("three in a row", three_in_a_row),
    ("stuck heading", stuck_heading),
];

fn engaged(ship: &Foreign, folder: &Path) -> Sailing {
    let ship = ship.sail(folder);
    ship.engage();
    ship.run(2.0);
    ship
}

/// Track control goes on, and the rudder stays.
fn undisturbed(ship: &Sailing, what: &str, seconds: f64) {
    let before = ship.log().orders.last().map_or(0.0, |(_, order)| *order);
    ship.always(what, seconds, |log| {
        let order = log.orders.last().map_or(0.0, |(_, order)| *order);
        log.htd(4) == "T" && (order - before).abs() < 2.5
    });
}

fn tracks(log: &Log) -> Vec<String> {
    let mut tracks: Vec<String> = log.htd.iter().map(|(_, htd)| htd[12].clone()).collect();
    tracks.sort();
    tracks.dedup();
    tracks
}

// Refused is not obeyed, from the first one; HTD never echoes it; TRACK FAIL when it lasts.
fn refused_reference(folder: &Path) {
    let ship = engaged(&Foreign::default(), folder);
    spoil(&ship, "EIHTC", &[(12, "275.0"), (13, "M")]);
    undisturbed(&ship, "a reference M for two seconds", 2.0);
    ship.heal();
    undisturbed(&ship, "after it", 3.0);
    spoil(&ship, "EIHTC", &[(12, "275.0"), (13, "M")]);
    ship.until("TRACK FAIL", 9.0, |log| log.raised(Alert::TrackFail));
    ship.until("AUTO", 2.5, |log| log.htd(4) == "S");
    assert_eq!(tracks(&ship.log()), ["", "245.0"]);
    assert!(ship.log().largest_order(0.0) < 3.0);
}

// FE11: what comes back from the chart system is no compass and no feedback.
fn echo_on_the_chart_port(folder: &Path) {
    let ship = engaged(&Foreign::default(), folder);
    ship.tap(|port, body| match port {
        "gyro1" if body.contains("HDT") => vec![("ecdis", body.replace("HE", "AG"))],
        "gyro1" => vec![],
        "gear" => vec![("ecdis", "EIRSA,25.0,A,,V".to_string())],
        _ => whole(port, body),
    });
    ship.until("RUDDER HOLD", 5.0, |log| log.htd(4) == "R");
    ship.until("its alarms", 5.0, |log| {
        log.raised(Alert::HeadingLost) && log.raised(Alert::Rudder)
    });
    ship.always("the rudder is held", 2.0, |log| log.htd(4) == "R");
    assert!(ship.log().largest_order(0.0) < 3.0);
}

// SEN-4, FA7
fn bad_headings(folder: &Path) {
    let ship = engaged(&Foreign::default(), folder);
    for bad in ["HEHDT,,T", "HEHDT,3x1.0,T", "HEHDT,361.0,T", "HEROT,,A"] {
        ship.say("gyro1", bad);
        undisturbed(&ship, bad, 2.6);
        assert!(!ship.log().raised(Alert::HeadingLost), "{bad}");
    }
    ship.tap(|port, body| match body.contains("HDT") {
        true => vec![(port, "HEHDT,,T".to_string())],
        false => whole(port, body),
    });
    ship.until("RUDDER HOLD", 5.0, |log| log.htd(4) == "R");
    assert!(ship.log().raised(Alert::HeadingLost));
}

// AP-9: the jump of one compass is not the ship's while another is good.
fn first_gyro_jumps(folder: &Path) {
    let ship = Foreign {
        ports: &["ecdis", "gyro1", "gyro2", "gps", "log", "gear"],
        ..Foreign::default()
    };
    let ship = engaged(&ship, folder);
    ship.tap(|port, body| {
        let heading = body
            .split(',')
            .nth(1)
            .and_then(|text| text.parse::<f64>().ok());
        match heading {
            Some(heading) if port == "gyro1" && body.contains("HDT") => {
                let jumped = (heading + 20.0).rem_euclid(360.0);
                vec![(port, format!("HEHDT,{jumped:.2},T"))]
            }
            _ => whole(port, body),
        }
    });
    undisturbed(&ship, "gyro 1 is 20 degrees off", 6.0);
    let log = ship.log();
    assert!(log.raised(Alert::HeadingJump) || log.raised(Alert::HeadingSource));
    assert!(!log.raised(Alert::HeadingLost));
}

// FB13
fn two_commanders(folder: &Path) {
    let ship = engaged(&Foreign::default(), folder);
    ship.tap(|port, body| {
        let mut said = whole(port, body);
        if body.starts_with("EIHTC") {
            said.push((port, "IIHTC,V,,,T,R,,,,,,,266.0,T,C".to_string()));
        }
        said
    });
    undisturbed(&ship, "a second commander", 6.0);
    assert!(ship.log().raised(Alert::HtcConflict));
    assert_eq!(tracks(&ship.log()), ["", "245.0"]);
}

// AP-20: constants of [ship] alone, 60 m beside the leg at the start.
fn first_order_ship(folder: &Path) {
    let ship = Foreign {
        gain: 0.18,
        time_constant: 27.0,
        knots: 17.5,
        ship: "length_m = 100\nspeed_kn = 17.5\ngain_per_s = 0.18\ntime_constant_s = 27\n",
        beside: 60.0,
        ..Foreign::default()
    };
    let ship = engaged(&ship, folder);
    ship.run(110.0);
    ship.always("on the leg", 15.0, |log| {
        log.htd(4) == "T" && log.off_path.abs() < 10.0
    });
}

// TCS-4: what does not agree with all else is refused, and nothing moves.
fn absurd_commands(folder: &Path) {
    let ship = engaged(&Foreign::default(), folder);
    let absurd: [(&str, &[(usize, &str)]); 6] = [
        ("EIHTC", &[(8, "0.000")]),
        ("EIHTC", &[(8, "0.001")]),
        ("EIHTC", &[(8, "99.0")]),
        ("EIHTC", &[(12, "335.0")]),
        (
            "EIHTC",
            &[
                (4, "H"),
                (5, "T"),
                (9, "500.0"),
                (10, "275.0"),
                (12, "275.0"),
            ],
        ),
        ("PNEY,001", &[(4, "3.000")]),
    ];
    for (begin, changes) in absurd {
        spoil(&ship, begin, changes);
        undisturbed(&ship, &format!("{begin} {changes:?}"), 1.6);
        ship.heal();
        undisturbed(&ship, &format!("after {begin} {changes:?}"), 2.4);
    }
    assert_eq!(tracks(&ship.log()), ["", "245.0"]);
    let log = ship.log();
    assert!(
        log.htd
            .iter()
            .all(|(_, htd)| htd[8].is_empty() || htd[8] == "0.500")
    );
}

// The range of every order, at the page's door.
fn absurd_orders(folder: &Path) {
    let ship = Foreign::default().sail(folder);
    ship.auto();
    for order in [
        Order::SetHeading(400.0),
        Order::SetHeading(-1.0),
        Order::SetHeading(1e308),
        Order::AdjustHeading(181.0),
        Order::AdjustHeading(-1e308),
    ] {
        let answer = ship.order(order.clone());
        assert!(!answer.ok, "{order:?}: {}", answer.text);
        assert!(answer.text.contains("allowed are"), "{}", answer.text);
    }
    ship.run(2.0);
    assert!(ship.log().largest_order(0.0) < 2.0);
}

// TCS-4: the chart system's distance comes to zero, wherever the autopilot's own receiver stands.
fn receiver_beside(folder: &Path) {
    let ship = Foreign {
        receiver: 20.0,
        ..Foreign::default()
    };
    let ship = engaged(&ship, folder);
    ship.run(90.0);
    ship.always("on the leg by PNEY,001", 10.0, |log| {
        log.off_path.abs() < 6.0
    });
}

// FA14: a broken one begins the row anew.
fn three_in_a_row(folder: &Path) {
    let ship = Foreign::default().sail(folder);
    ship.auto();
    ship.control(true);
    ship.tap(|port, body| match body.starts_with("EIHTC") {
        true => vec![],
        false => whole(port, body),
    });
    ship.run(3.0);
    let answer = ship.order(Order::Mode(ModeRequest::Autonav));
    assert!(answer.ok, "{}", answer.text);
    let good = "EIHTC,V,,,T,R,,,,,,,245.0,T,C";
    for broken in [false, false, true, false, false] {
        let broken_line = format!("${good}*00");
        ship.say("ecdis", if broken { &broken_line } else { good });
        ship.always("two in a row are not enough", 1.2, |log| log.htd(4) == "S");
    }
    ship.say("ecdis", good);
    ship.until("track control", 2.5, |log| log.htd(4) == "T");
}

// FA8: it stands still while the ship turns.
fn stuck_heading(folder: &Path) {
    let ship = Foreign::default().sail(folder);
    ship.auto();
    let tight = Order::Setting {
        key: "set_radius".to_string(),
        value: Value::Number(0.15),
    };
    for order in [tight, Order::SetHeading(335.0)] {
        let answer = ship.order(order);
        assert!(answer.ok, "{}", answer.text);
    }
    ship.until("the turn", 60.0, |log| log.heading > 255.0);
    let mut frozen = None::<String>;
    ship.tap(move |port, body| match body.starts_with("HEHDT") {
        true => vec![(
            port,
            frozen.get_or_insert_with(|| edited(body, &[])).clone(),
        )],
        false => whole(port, body),
    });
    ship.until("HEADING STUCK", 12.0, |log| log.raised(Alert::HeadingStuck));
}

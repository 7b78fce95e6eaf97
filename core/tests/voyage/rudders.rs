//! An independent pair of rudders in closed loop: each with its own order, feedback and failure (AP-4, FA11).

use crate::rig::{Rig, edited, off_path};
use wheelover_core::alerts::Alert;
use wheelover_core::settings::{Rudders, Value};
use wheelover_core::station::Profile;
use wheelover_core::view::{FaultKind, ModeName, ModeRequest, Order};

const ALERTS: [Alert; 2] = [Alert::Rudder, Alert::RudderPort];
const STICKS: [FaultKind; 2] = [FaultKind::Stuck, FaultKind::StuckPort];
const NAMES: [&str; 2] = ["starboard", "port"];

fn pair() -> Rig {
    Rig::tracking_as(|config| {
        config.settings.rudders = Rudders::Independent;
        config.world.pair = true;
    })
}

/// Fields of a line that the autopilot said to the chart system, from 0: the address.
fn said(rig: &Rig, formatter: &str) -> Vec<String> {
    let line = rig.told(formatter);
    let body = line.split('*').next().unwrap().to_string();
    body.split(',').map(str::to_string).collect()
}

/// Status letters of both sides.
fn statuses(rig: &Rig, formatter: &str) -> [String; 2] {
    let fields = said(rig, formatter);
    [fields[2].clone(), fields[4].clone()]
}

fn rudders(rig: &Rig) -> [f64; 2] {
    let truth = rig.world().truth();
    [truth.rudder.deg(), truth.port_rudder.unwrap().deg()]
}

/// Sails the turn to its end and on; the largest distance from the path on the arc, and over the last minute.
fn sail_the_turn(rig: &mut Rig) -> (f64, f64) {
    let (mut worst, mut after) = (0.0_f64, 0.0_f64);
    let mut since_the_turn = 0;
    while since_the_turn < 3_600 {
        rig.step();
        let position = rig.world().truth().position;
        let off = off_path(&rig.route, rig.chart(), position);
        match rig.chart().situation() {
            4 => worst = worst.max(off),
            5 => {
                since_the_turn += 1;
                if since_the_turn > 3_000 {
                    after = after.max(off);
                }
            }
            _ => {}
        }
        assert_eq!(rig.mode(), ModeName::AutonavTi, "{}", rig.autopilot().why());
    }
    (worst, after)
}

// AP-4, AP-1
#[test]
fn both_sides_are_steered_and_said() {
    let mut rig = pair();
    rig.until("the arc", 600.0, |rig| rig.chart().situation() == 4);
    rig.run(20.0);
    assert!(rudders(&rig)[0] > 3.0, "{:?}", rudders(&rig));
    for formatter in ["RSA", "ROR"] {
        assert_eq!(statuses(&rig, formatter), ["A", "A"], "{formatter}");
        let fields = said(&rig, formatter);
        let angles: Vec<f64> = [1, 3].map(|index| fields[index].parse().unwrap()).to_vec();
        assert!(
            (angles[0] - angles[1]).abs() < 0.2 && angles[0] > 3.0,
            "{fields:?}"
        );
    }
    assert!(ALERTS.iter().all(|alert| !rig.raised(*alert)));
    rig.command(Order::Mode(ModeRequest::Standby)).unwrap();
    rig.run(2.0);
    let ror = said(&rig, "ROR");
    assert_eq!(ror[1..5], ["", "V", "", "V"], "no order is given");
    assert_eq!(statuses(&rig, "RSA"), ["A", "A"]);
    rig.check_orders();
}

// AP-4, FA11: either side sticks in the turn with the rudder laid; the other one finishes the turn and keeps the next leg.
#[test]
fn a_side_that_sticks_in_a_turn_is_told_and_the_other_one_keeps_the_track() {
    let (worst_whole, _) = sail_the_turn(&mut pair());
    for side in 0..2 {
        let mut rig = pair();
        rig.until("the arc", 600.0, |rig| rig.chart().situation() == 4);
        rig.run(15.0);
        rig.injure(Profile::Gear, STICKS[side], true);
        let stuck = rudders(&rig)[side];
        assert!(stuck > 4.0, "laid: {stuck}");
        let (worst, after) = sail_the_turn(&mut rig);
        assert!((rudders(&rig)[side] - stuck).abs() < 1e-9, "it sticks");
        assert!(rig.raised(ALERTS[side]) && !rig.raised(ALERTS[1 - side]));
        let text = rig.text(ALERTS[side]);
        let names = format!(
            "the {} rudder does not follow its order: the {} rudder steers",
            NAMES[side],
            NAMES[1 - side]
        );
        assert!(text.contains(&names), "{text}");
        let status = statuses(&rig, "RSA");
        assert_eq!(
            (status[side].as_str(), status[1 - side].as_str()),
            ("V", "A")
        );
        assert_eq!(statuses(&rig, "ROR"), ["A", "A"], "the order goes on");
        let mean = (rudders(&rig)[0] + rudders(&rig)[1]) / 2.0;
        assert!(
            mean.abs() < 4.0,
            "the other one lies against it: {:?}",
            rudders(&rig)
        );
        assert!(
            worst < worst_whole + 15.0,
            "{worst} m on the arc, {worst_whole} with both"
        );
        assert!(after < 10.0, "{after} m on the leg after it");
        rig.check_orders();
        // Free again, and believed after it has followed for ten seconds.
        rig.injure(Profile::Gear, STICKS[side], false);
        rig.run(9.0);
        assert!(rig.raised(ALERTS[side]));
        rig.until("trust", 10.0, |rig| !rig.raised(ALERTS[side]));
        rig.run(30.0);
        assert_eq!(statuses(&rig, "RSA"), ["A", "A"]);
        assert!((rudders(&rig)[0] - rudders(&rig)[1]).abs() < 1.0);
        rig.check_orders();
    }
}

// AP-4: the feedback of either side says V, or is null; its order goes on.
#[test]
fn a_side_without_feedback_is_told_and_its_order_goes_on() {
    for side in 0..2 {
        for lost in ["V", ""] {
            let mut rig = pair();
            rig.filter(move |_, from, line| {
                let (angle, status) = (1 + 2 * side, 2 + 2 * side);
                Some(match from {
                    Profile::Gear if lost.is_empty() => edited(line, &[(angle, ""), (status, "V")]),
                    Profile::Gear => edited(line, &[(status, lost)]),
                    _ => line.to_string(),
                })
            });
            rig.until("alarm", 2.3, |rig| rig.raised(ALERTS[side]));
            rig.run(2.0);
            assert!(!rig.raised(ALERTS[1 - side]));
            assert!(rig.text(ALERTS[side]).contains("has no feedback"));
            let status = statuses(&rig, "RSA");
            assert_eq!(
                (status[side].as_str(), status[1 - side].as_str()),
                ("V", "A")
            );
            let (worst, after) = sail_the_turn(&mut rig);
            assert!(worst < 30.0 && after < 10.0, "{worst} m, {after} m");
            let [one, other] = rudders(&rig);
            assert!((one - other).abs() < 1.0, "{one} {other}");
            rig.check_orders();
        }
    }
}

// FA11: with both gone there is nothing left but the hand.
#[test]
fn with_both_sides_gone_the_officer_is_told_to_steer_by_hand() {
    let mut rig = pair();
    rig.silence(Profile::Gear, "RSA");
    rig.until("both", 3.0, |rig| {
        ALERTS.iter().all(|alert| rig.raised(*alert))
    });
    rig.run(1.0);
    for alert in ALERTS {
        assert!(
            rig.text(alert).contains("steer by hand"),
            "{}",
            rig.text(alert)
        );
    }
    assert_eq!(statuses(&rig, "RSA"), ["V", "V"]);
    rig.check_orders();
}

// AP-4
#[test]
fn the_rudders_are_changed_in_standby_only() {
    let mut rig = pair();
    let single = || Order::Setting {
        key: "rudders".into(),
        value: Value::Choice("single".into()),
    };
    let refused = rig.command(single()).unwrap_err();
    assert!(refused.contains("STANDBY"), "{refused}");
    rig.command(Order::Mode(ModeRequest::Standby)).unwrap();
    rig.command(single()).unwrap();
    rig.run(2.0);
    assert_eq!(statuses(&rig, "RSA"), ["A", "V"]);
    assert_eq!(said(&rig, "RSA")[3], "", "a single rudder has no port side");
}

//! WIND VANE: the angle to the wind, apparent and true, a tack, and the loss of the wind (AP-21).

use super::{check_htd, refused, sea, select, turned};
use crate::rig::Rig;
use wheelover_core::alerts::Alert;
use wheelover_core::settings::Value;
use wheelover_core::station::Profile;
use wheelover_core::view::{ModeName, ModeRequest, Order, Side};

/// The wind angle that the world's sensor says, apparent or true, degrees.
fn wind(rig: &Rig, apparent: bool) -> f64 {
    let heard = rig.autopilot().picture().wind(apparent, rig.now).unwrap();
    heard.value.deg()
}

fn to_the(rig: &mut Rig, apparent: bool) {
    let (key, value) = ("wind_true".into(), Value::Switch(!apparent));
    rig.command(Order::Setting { key, value }).unwrap();
    select(rig, ModeRequest::WindVane);
}

// AP-21, AP-1
#[test]
fn the_set_angle_to_the_wind_is_held() {
    for (apparent, angles) in [(true, [-25.0, 18.0]), (false, [-60.0, 45.0])] {
        let mut rig = sea();
        rig.run(60.0);
        let from = rig.heading().deg();
        to_the(&mut rig, apparent);
        rig.run(60.0);
        // By what was read at the selection, waves and all.
        let off = turned(&rig, from);
        assert!(off.abs() < 2.5, "{apparent}: at first as she lies: {off}");
        for angle in angles {
            let answer = rig.command(Order::SetWindAngle(angle)).unwrap();
            assert!(answer.starts_with("set wind angle"), "{answer}");
            rig.run(600.0);
            let off = wind(&rig, apparent) - angle;
            assert!(off.abs() < 2.0, "{apparent} {angle}: {off}");
            assert_eq!(rig.mode(), ModeName::WindVane);
            check_htd(&rig.last_htd().clone(), 20.0);
        }
        refused(
            &mut rig,
            Order::SetWindAngle(181.0),
            "allowed are -180 to 180 deg",
        );
        rig.check_orders();
    }
}

// AP-21: through the wind by one order, to the side that it comes from.
#[test]
fn a_tack_goes_through_the_wind_to_the_same_angle_on_the_other_side() {
    for (side, other, sign) in [
        (Side::Port, Side::Starboard, -1.0),
        (Side::Starboard, Side::Port, 1.0),
    ] {
        let mut rig = sea();
        to_the(&mut rig, false);
        rig.command(Order::SetWindAngle(sign * 120.0)).unwrap();
        refused(&mut rig, Order::Tack(side), "through the wind ahead");
        rig.command(Order::SetWindAngle(sign * 50.0)).unwrap();
        rig.run(500.0);
        refused(&mut rig, Order::Tack(other), "the wind is on the");
        let from = rig.heading().deg();
        rig.command(Order::Tack(side)).unwrap();
        rig.run(20.0);
        assert!(turned(&rig, from) * sign > 1.0, "into the wind");
        rig.run(400.0);
        assert!((turned(&rig, from) - sign * 100.0).abs() < 2.5);
        assert!((wind(&rig, false) + sign * 50.0).abs() < 2.0);
        rig.check_orders();
    }
}

// AP-21: without wind for 5 s AUTO holds the present heading, with an alarm.
#[test]
fn a_lost_wind_is_auto_on_the_present_heading_with_an_alarm() {
    for formatter in ["", "MWV"] {
        let mut rig = sea();
        select(&mut rig, ModeRequest::WindVane);
        rig.command(Order::SetWindAngle(-10.0)).unwrap();
        rig.run(20.0);
        let silent = rig.now;
        rig.silence(Profile::Wind, formatter);
        let lost = rig.until("AUTO", 7.0, |rig| rig.mode() == ModeName::Auto);
        assert!((4_000..=5_300).contains(&lost.since(silent)));
        assert!(turned(&rig, rig.set_heading()).abs() < 0.6);
        assert!(rig.raised(Alert::WindLost));
        rig.run(5.0);
        refused(
            &mut rig,
            Order::Mode(ModeRequest::WindVane),
            "no wind is heard",
        );
        rig.filter(|_, _, line| Some(line.to_string()));
        rig.run(3.0);
        assert!(!rig.raised(Alert::WindLost), "it is heard again");
        assert_eq!(rig.mode(), ModeName::Auto, "never by itself");
        select(&mut rig, ModeRequest::WindVane);
        rig.check_orders();
    }
}

// AP-21: the status of the sentence counts, and one wind is no measure of the other.
#[test]
fn a_wind_that_is_not_valid_is_not_used() {
    let mut rig = sea();
    to_the(&mut rig, true);
    rig.run(10.0);
    rig.filter(|_, from, line| {
        let apparent = from == Profile::Wind && line.contains(",R,");
        Some(match apparent {
            true => crate::rig::edited(line, &[(5, "V")]),
            false => line.to_string(),
        })
    });
    rig.until("AUTO", 7.0, |rig| rig.mode() == ModeName::Auto);
    assert!(rig.autopilot().why().contains("no wind"));
    refused(
        &mut rig,
        Order::Mode(ModeRequest::WindVane),
        "no wind is heard",
    );
    to_the(&mut rig, false);
    rig.run(10.0);
    assert_eq!(rig.mode(), ModeName::WindVane);
    // VWT says the same as MWV with T does.
    rig.silence(Profile::Wind, "MWV");
    for _ in 0..30 {
        rig.say(Profile::Wind, "WIVWT,40.0,L,15.0,N,7.7,M,27.8,K");
        rig.run(1.0);
    }
    assert_eq!((rig.mode(), wind(&rig, false)), (ModeName::WindVane, -40.0));
}

// AP-21: DODGE comes back to the set angle where there is wind.
#[test]
fn dodge_comes_back_to_the_wind() {
    let mut rig = sea();
    select(&mut rig, ModeRequest::WindVane);
    rig.run(30.0);
    let angle = rig.autopilot().mode().set_value();
    for (heard, back) in [(true, ModeName::WindVane), (false, ModeName::Auto)] {
        select(&mut rig, ModeRequest::Dodge);
        rig.command(Order::SetDodge(-15.0)).unwrap();
        rig.run(40.0);
        if !heard {
            rig.silence(Profile::Wind, "");
            rig.run(6.0);
        }
        let answer = select(&mut rig, ModeRequest::Dodge);
        assert_eq!(rig.mode(), back);
        if heard {
            assert_eq!(rig.autopilot().mode().set_value(), angle);
        } else {
            assert!(answer.contains("no wind is heard"), "{answer}");
        }
        rig.run(30.0);
    }
    rig.check_orders();
}

// 3a, AP-21: the wind that a plotter says is held where no sensor says one, and a sensor's goes before.
#[test]
fn a_plotters_wind_is_a_wind() {
    let ports = [("plotter", Profile::Plotter), ("mast", Profile::Wind)];
    let mut rig = Rig::heading_east(&ports, 0.0);
    rig.run(5.0);
    select(&mut rig, ModeRequest::Auto);
    rig.run(5.0);
    refused(
        &mut rig,
        Order::Mode(ModeRequest::WindVane),
        "no wind is heard",
    );
    // It blows from 040.
    let blows = |rig: &mut Rig, seconds: u32| {
        for _ in 0..seconds {
            let angle = (40.0 - rig.heading().deg()).rem_euclid(360.0);
            rig.say(Profile::Plotter, &format!("IIMWV,{angle:.1},R,7.5,M,A"));
            rig.run(1.0);
        }
    };
    blows(&mut rig, 10);
    select(&mut rig, ModeRequest::WindVane);
    rig.command(Order::SetWindAngle(-30.0)).unwrap();
    blows(&mut rig, 300);
    assert_eq!(rig.mode(), ModeName::WindVane);
    assert!(turned(&rig, 70.0).abs() < 2.0, "{}", rig.heading().deg());
    let source = |rig: &Rig| {
        let heard = rig.autopilot().picture().wind(true, rig.now).unwrap();
        rig.autopilot().source_name(&heard.source)
    };
    assert_eq!(source(&rig), "plotter/II/MWV");
    rig.say(Profile::Wind, "WIMWV,330.0,R,7.5,M,A");
    blows(&mut rig, 1);
    assert_eq!(source(&rig), "mast/WI/MWV");
    // Both fall silent.
    rig.until("AUTO", 7.0, |rig| rig.mode() == ModeName::Auto);
    assert!(rig.raised(Alert::WindLost));
    rig.check_orders();
}

//! RIVER PILOT by a rate of turn alone: kept, selected, and lost (AP-21, FA7).

use super::{order, rate, refused, sea, select, turned};
use crate::rig::{Rig, edited, route};
use wheelover_core::alerts::Alert;
use wheelover_core::station::Profile;
use wheelover_core::view::{ModeName, ModeRequest, Order};

/// The mean rate of turn while she sails on, degrees a minute.
fn mean(rig: &mut Rig, seconds: u32) -> f64 {
    let mut sum = 0.0;
    for _ in 0..seconds * 10 {
        rig.step();
        sum += rate(rig) / f64::from(seconds * 10);
    }
    sum
}

fn without_heading(rig: &mut Rig) {
    rig.silence(Profile::Gyro1, "HDT,");
}

fn whole(rig: &mut Rig) {
    rig.filter(|_, _, line| Some(line.to_string()));
}

// AP-21, FA6: with a caution, no step when the heading goes and none when it is back.
#[test]
fn a_lost_heading_is_a_caution_where_a_rate_of_turn_is_measured() {
    for set in [0.0, 20.0, -12.0] {
        let mut rig = sea();
        select(&mut rig, ModeRequest::RiverPilot);
        rig.command(Order::SetRate(set)).unwrap();
        rig.run(90.0);
        without_heading(&mut rig);
        let came = rig.until("NO HEADING", 2.3, |rig| rig.raised(Alert::NoHeading));
        assert!(rig.autopilot().believed_heading().is_none());
        let (from, before) = (rig.heading().deg(), order(&rig));
        rig.run(1.0);
        assert!((order(&rig) - before).abs() < 2.0, "{set}");
        let held = mean(&mut rig, 180);
        assert!((held - set).abs() < 0.8, "{set}: {held}");
        if set == 0.0 {
            let drift = turned(&rig, from);
            assert!(drift.abs() < 3.0, "{drift} in three minutes");
        }
        assert_eq!(rig.mode(), ModeName::RiverPilot);
        assert!(!rig.raised(Alert::HeadingLost));
        assert_eq!(rig.last_htd().heading, None);
        // Another rate is reached all the same.
        rig.command(Order::SetRate(15.0)).unwrap();
        rig.run(60.0);
        let held = mean(&mut rig, 60);
        assert!((held - 15.0).abs() < 0.8, "{held}");
        let before = order(&rig);
        whole(&mut rig);
        rig.until("a heading", 1.0, |rig| !rig.raised(Alert::NoHeading));
        rig.run(1.0);
        assert!((order(&rig) - before).abs() < 2.0, "{set}");
        let held = mean(&mut rig, 60);
        assert!((held - 15.0).abs() < 0.8, "{held}");
        assert!(rig.now.since(came) > 300_000);
        rig.check_orders();
    }
}

// AP-21: it is selected without a heading, from STANDBY and from RUDDER HOLD; what needs a heading is not.
#[test]
fn it_is_selected_by_a_rate_of_turn_alone() {
    for held in [false, true] {
        let mut rig = Rig::windy(route(&[(90.0, 4.0), (150.0, 4.0)], 0.5), 11);
        if held {
            rig.run(5.0);
            select(&mut rig, ModeRequest::Auto);
            rig.run(5.0);
        }
        without_heading(&mut rig);
        rig.run(6.0);
        let now = if held {
            ModeName::RudderHold
        } else {
            ModeName::Standby
        };
        assert_eq!(rig.mode(), now);
        for mode in [ModeRequest::Auto, ModeRequest::WindVane] {
            refused(&mut rig, Order::Mode(mode), "no heading");
        }
        select(&mut rig, ModeRequest::RiverPilot);
        assert!(!rig.raised(Alert::HeadingLost));
        rig.command(Order::SetRate(-18.0)).unwrap();
        rig.run(240.0);
        let kept = mean(&mut rig, 120);
        assert!((kept + 18.0).abs() < 0.8, "{kept}");
        assert!(rig.raised(Alert::NoHeading));
        whole(&mut rig);
        rig.run(2.0);
        select(&mut rig, ModeRequest::Auto);
        assert!(!rig.raised(Alert::NoHeading));
        rig.run(120.0);
        assert!(turned(&rig, rig.set_heading()).abs() < 1.5);
        rig.check_orders();
    }
}

// FA7: without either the rudder is held, with the alarm, until the operator ends it; a rate that is not believed is none.
#[test]
fn without_a_rate_of_turn_too_the_rudder_is_held() {
    let mut rig = sea();
    select(&mut rig, ModeRequest::RiverPilot);
    rig.command(Order::SetRate(20.0)).unwrap();
    rig.run(60.0);
    without_heading(&mut rig);
    rig.run(20.0);
    rig.silence(Profile::Gyro1, "");
    rig.until("RUDDER HOLD", 2.3, |rig| rig.mode() == ModeName::RudderHold);
    assert!(rig.raised(Alert::HeadingLost) && !rig.raised(Alert::NoHeading));
    let why = rig.autopilot().why();
    assert!(
        why.contains("neither a heading nor a rate of turn"),
        "{why}"
    );
    let before = order(&rig);
    refused(
        &mut rig,
        Order::Mode(ModeRequest::RiverPilot),
        "neither a heading nor a measured rate of turn",
    );
    rig.run(5.0);
    assert_eq!(order(&rig), before, "frozen");
    without_heading(&mut rig);
    rig.run(5.0);
    assert_eq!(rig.mode(), ModeName::RudderHold, "never by itself");
    rig.check_orders();

    let mut rig = sea();
    select(&mut rig, ModeRequest::RiverPilot);
    rig.run(30.0);
    let lying = |line: &str| line.contains("ROT,").then(|| edited(line, &[(1, "-90.0")]));
    rig.filter(move |_, _, line| Some(lying(line).unwrap_or_else(|| line.to_string())));
    rig.until("doubt", 8.0, |rig| rig.raised(Alert::RateOfTurn));
    rig.filter(move |_, from, line| {
        let heading = from == Profile::Gyro1 && line.contains("HDT,");
        (!heading).then(|| lying(line).unwrap_or_else(|| line.to_string()))
    });
    rig.until("RUDDER HOLD", 2.3, |rig| rig.mode() == ModeName::RudderHold);
    rig.check_orders();
}

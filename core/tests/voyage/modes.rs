//! The operator's modes in closed loop: entered, set, left, and what each loss makes of them (AP-1, AP-21, FA6, FA7).

mod dodge;
mod engineer;
mod pairs;
mod river;
mod wind;

use crate::rig::{Rig, SLEW, route};
use wheelover_core::alerts::Alert;
use wheelover_core::nmea::{Htd, LimitStatus, OverrideStatus, SteeringMode, TurnMode};
use wheelover_core::station::Profile;
use wheelover_core::view::{ModeName, ModeRequest, Order};

/// A ship in wind on a leg of 090, in AUTO.
fn sea() -> Rig {
    let mut rig = Rig::windy(route(&[(90.0, 4.0), (150.0, 4.0)], 0.5), 11);
    rig.run(5.0);
    select(&mut rig, ModeRequest::Auto);
    rig.run(5.0);
    rig
}

fn select(rig: &mut Rig, mode: ModeRequest) -> String {
    rig.command(Order::Mode(mode)).unwrap()
}

/// A refused order: nothing has changed, and the reason is given.
fn refused(rig: &mut Rig, order: Order, reason: &str) {
    let (mode, value) = (*rig.autopilot().mode(), rig.autopilot().mode().set_value());
    let text = rig.command(order.clone()).unwrap_err();
    assert!(text.contains(reason), "{order:?}: {text}");
    assert_eq!(rig.autopilot().why(), text);
    let now = (
        rig.autopilot().mode().name(),
        rig.autopilot().mode().set_value(),
    );
    assert_eq!(now, (mode.name(), value), "{order:?}");
}

/// The heading turned through, degrees, starboard positive.
fn turned(rig: &Rig, from: f64) -> f64 {
    (rig.heading().deg() - from + 540.0).rem_euclid(360.0) - 180.0
}

fn order(rig: &Rig) -> f64 {
    rig.autopilot().rudder_order().unwrap().deg()
}

/// Rate of turn, degrees a minute.
fn rate(rig: &Rig) -> f64 {
    rig.world().truth().rate.deg_per_min()
}

/// What HTD says in a mode of rudder control that turns by nothing of its own, with that rudder limit (AP-1).
fn check_htd(htd: &Htd, limit: f64) {
    assert_eq!(htd.override_status, Some(OverrideStatus::NotInUse));
    assert_eq!(htd.steering_mode, Some(SteeringMode::RudderControl));
    assert_eq!(htd.turn_mode, Some(TurnMode::NotControlled));
    assert_eq!(htd.rudder_limit, Some(limit));
    assert_eq!(htd.off_heading_limit, Some(20.0));
    let nulls = [
        htd.radius,
        htd.rate_of_turn,
        htd.heading_to_steer,
        htd.off_track_limit,
        htd.track,
    ];
    assert_eq!(nulls, [None; 5]);
}

/// A mode that needs a heading holds the rudder without one, with an alarm, until the operator ends it (FA7).
fn check_heading_lost(rig: &mut Rig) {
    rig.silence(Profile::Gyro1, "");
    let held = |rig: &Rig| rig.mode() == ModeName::RudderHold;
    rig.until("RUDDER HOLD", 2.3, held);
    assert!(rig.raised(Alert::HeadingLost));
    let before = order(rig);
    rig.run(3.0);
    assert_eq!(order(rig), before, "frozen");
    rig.filter(|_, _, line| Some(line.to_string()));
    rig.run(3.0);
    assert_eq!(rig.mode(), ModeName::RudderHold, "never by itself");
    select(rig, ModeRequest::Auto);
    rig.run(30.0);
    rig.check_orders();
}

// AP-21, AP-1
#[test]
fn ffu_override_gives_the_ordered_rudder_up_to_the_maximum() {
    let mut rig = sea();
    select(&mut rig, ModeRequest::FfuOverride);
    let before = order(&rig);
    rig.run(3.0);
    assert_eq!(order(&rig), before, "at first as it stood");
    for degrees in [12.5, -35.0, 35.0, 0.0] {
        let from = order(&rig);
        let answer = rig.command(Order::SetRudder(degrees)).unwrap();
        assert!(answer.starts_with("set rudder"), "{answer}");
        let seconds = (degrees - from).abs() / SLEW;
        rig.run(seconds + 0.2);
        assert_eq!(order(&rig), degrees, "at the slew of the gear");
        rig.run(2.0);
        let htd = rig.last_htd().clone();
        check_htd(&htd, 35.0);
        assert_eq!(htd.rudder_angle, Some(degrees));
        let reached = degrees.abs() == 35.0;
        assert_eq!(htd.rudder_status == Some(LimitStatus::Reached), reached);
        assert!(
            rig.told("ROR").contains(&format!("ROR,{degrees:.1},A")),
            "{}",
            rig.told("ROR")
        );
    }
    refused(
        &mut rig,
        Order::SetRudder(35.1),
        "allowed are -35 to 35 deg",
    );
    refused(&mut rig, Order::SetRudder(f64::NAN), "allowed are");
    refused(&mut rig, Order::SetRate(5.0), "RIVER PILOT and AUTO only");
    refused(&mut rig, Order::SetHeading(5.0), "in AUTO only");
    refused(
        &mut rig,
        Order::Mode(ModeRequest::FfuOverride),
        "on already",
    );
    refused(
        &mut rig,
        Order::Mode(ModeRequest::Autonav),
        "from AUTO only",
    );
    rig.check_orders();
}

// AP-21, FA7: it needs no heading, and the way back to one has no bump.
#[test]
fn ffu_override_needs_no_heading() {
    for seconds in [0.0, 40.0] {
        let mut rig = sea();
        select(&mut rig, ModeRequest::FfuOverride);
        rig.command(Order::SetRudder(15.0)).unwrap();
        rig.run(seconds);
        rig.silence(Profile::Gyro1, "");
        rig.run(6.0);
        assert_eq!(rig.mode(), ModeName::FfuOverride);
        assert!(rig.autopilot().believed_heading().is_none());
        rig.command(Order::SetRudder(-8.0)).unwrap();
        rig.run(6.0);
        assert_eq!(order(&rig), -8.0);
        refused(&mut rig, Order::Mode(ModeRequest::Auto), "no heading");
        rig.filter(|_, _, line| Some(line.to_string()));
        rig.run(2.0);
        select(&mut rig, ModeRequest::Auto);
        rig.run(120.0);
        assert!(turned(&rig, rig.set_heading()).abs() < 1.5);
        rig.check_orders();
    }
    // From RUDDER HOLD, and from STANDBY with nothing but the gear: the rudder stays where it is.
    let mut rig = sea();
    rig.command(Order::AdjustHeading(40.0)).unwrap();
    rig.run(8.0);
    rig.silence(Profile::Gyro1, "");
    rig.until("RUDDER HOLD", 3.0, |rig| rig.mode() == ModeName::RudderHold);
    let held = order(&rig);
    assert!(held.abs() > 2.0, "{held}");
    select(&mut rig, ModeRequest::FfuOverride);
    rig.run(5.0);
    assert_eq!(order(&rig), held);
    select(&mut rig, ModeRequest::Standby);
    rig.run(2.0);
    select(&mut rig, ModeRequest::FfuOverride);
    rig.run(2.0);
    assert!((order(&rig) - held).abs() < 0.2, "{} {held}", order(&rig));
    rig.check_orders();
}

// AP-21, AP-1
#[test]
fn river_pilot_keeps_the_set_rate_of_turn_and_at_none_the_heading() {
    for side in [1.0, -1.0] {
        let mut rig = sea();
        select(&mut rig, ModeRequest::RiverPilot);
        rig.run(60.0);
        let held = rig.heading().deg();
        for set in [10.0, 25.0, 18.5] {
            rig.command(Order::SetRate(side * set)).unwrap();
            rig.run(70.0);
            let mut sum = 0.0;
            for _ in 0..600 {
                rig.step();
                sum += rate(&rig) / 600.0;
            }
            assert!((sum - side * set).abs() < 0.6, "{set}: {sum}");
            let htd = rig.last_htd();
            assert_eq!(htd.steering_mode, Some(SteeringMode::RudderControl));
            assert_eq!(htd.turn_mode, Some(TurnMode::Rate));
            assert_eq!(htd.rate_of_turn, Some(set));
            assert_eq!(htd.rudder_limit, Some(20.0));
            assert_eq!(
                (htd.radius, htd.heading_to_steer, htd.track),
                (None, None, None)
            );
        }
        assert_ne!(held, rig.heading().deg());
        rig.command(Order::SetRate(0.0)).unwrap();
        rig.run(90.0);
        let held = rig.heading().deg();
        for _ in 0..6_000 {
            rig.step();
            assert!(turned(&rig, held).abs() < 1.0, "{}", turned(&rig, held));
        }
        rig.check_orders();
    }
}

// AP-21: more than the ship can do winds nothing up; the order stays within the set limit.
#[test]
fn river_pilot_stays_within_the_set_rudder_limit() {
    let mut rig = sea();
    select(&mut rig, ModeRequest::RiverPilot);
    rig.set("rudder_limit", 10.0).unwrap();
    rig.run(10.0);
    rig.command(Order::SetRate(300.0)).unwrap();
    let from = rig.orders.len();
    rig.run(240.0);
    let most = rig.orders[from..].iter().filter_map(|(_, order)| *order);
    let most = most.fold(0.0_f64, |most, order| most.max(order.abs()));
    assert!((9.0..=10.0 + 1e-9).contains(&most), "{most}");
    rig.command(Order::SetRate(0.0)).unwrap();
    rig.run(120.0);
    let stands = rig.heading().deg();
    rig.run(60.0);
    assert!(turned(&rig, stands).abs() < 2.0, "{}", turned(&rig, stands));
    refused(
        &mut rig,
        Order::SetRate(-301.0),
        "allowed are -300 to 300 deg/min",
    );
    refused(&mut rig, Order::SetRadius(0.5), "in AUTO only");
    rig.check_orders();
}

// FA7
#[test]
fn every_mode_that_needs_a_heading_holds_the_rudder_without_one() {
    for mode in [
        ModeRequest::RiverPilot,
        ModeRequest::Dodge,
        ModeRequest::WindVane,
    ] {
        let mut rig = sea();
        select(&mut rig, mode);
        rig.run(10.0);
        check_heading_lost(&mut rig);
    }
}

// AP-21: AUTO pressed again in a turn holds the heading of then.
#[test]
fn auto_pressed_in_a_turn_holds_the_present_heading() {
    for side in [1.0, -1.0] {
        let mut rig = sea();
        rig.command(Order::AdjustHeading(90.0 * side)).unwrap();
        rig.run(90.0);
        let captured = rig.heading().deg();
        assert!(rate(&rig) * side > 10.0, "{}", rate(&rig));
        select(&mut rig, ModeRequest::Auto);
        assert!((turned(&rig, rig.set_heading())).abs() < 0.6);
        rig.run(180.0);
        assert!(
            turned(&rig, captured).abs() < 1.5,
            "{}",
            turned(&rig, captured)
        );
        rig.check_orders();
    }
}

// AP-21, AP-1: what AUTO is set to are settings, kept as such; nothing else takes them there.
#[test]
fn rate_and_radius_set_in_auto_are_its_settings() {
    let mut rig = sea();
    assert_eq!(rig.command(Order::SetRate(12.0)).unwrap(), "set_rate is 12");
    assert_eq!(
        rig.command(Order::SetRadius(0.8)).unwrap(),
        "set_radius is 0.8"
    );
    rig.run(2.0);
    let settings = rig.autopilot().settings();
    assert_eq!((settings.set_rate, settings.set_radius), (12.0, 0.8));
    assert_eq!(rig.last_htd().radius, Some(0.8));
    refused(
        &mut rig,
        Order::SetRate(-12.0),
        "allowed are 1 to 300 deg/min",
    );
    refused(
        &mut rig,
        Order::SetRadius(11.0),
        "allowed are 0.05 to 10 nm",
    );
    for (order, reason) in [
        (
            Order::SetRudder(3.0),
            "the rudder is set in FFU OVERRIDE only",
        ),
        (Order::SetDodge(3.0), "the offset is set in DODGE only"),
        (
            Order::SetWindAngle(3.0),
            "the wind angle is set in WIND VANE only",
        ),
    ] {
        refused(&mut rig, order, reason);
    }
    // In STANDBY there is nothing to set.
    select(&mut rig, ModeRequest::Standby);
    refused(&mut rig, Order::SetRate(12.0), "RIVER PILOT and AUTO only");
    refused(&mut rig, Order::SetRadius(0.8), "AUTO only");
    assert_eq!(rig.autopilot().settings().set_rate, 12.0);
}

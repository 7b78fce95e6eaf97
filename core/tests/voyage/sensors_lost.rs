//! Sensors that fall silent, jump or stick, and a loop that stalls (FA6 to FA10, FA16).

use crate::rig::{Rig, edited};
use wheelover_core::alerts::Alert;
use wheelover_core::geo::{Position, rhumb};
use wheelover_core::nmea::{self, Gll, SteeringMode, with_checksum};
use wheelover_core::station::{Direction, Profile};
use wheelover_core::units::{Course, Distance};
use wheelover_core::view::{ChartRequest, FaultKind, ModeName, ModeRequest, Order};
use wheelover_core::voyage::VoyageOutput;

// FA7
#[test]
fn a_lost_heading_freezes_the_order_until_the_operator_ends_it() {
    for autonav in [true, false] {
        let mut rig = Rig::tracking();
        if !autonav {
            rig.command(Order::Mode(ModeRequest::Auto)).unwrap();
        }
        rig.run(10.0);
        let lost = rig.now;
        rig.silence(Profile::Gyro1, "");
        rig.until("RUDDER HOLD", 3.0, |rig| rig.mode() == ModeName::RudderHold);
        let waited = rig.now.since(lost);
        assert!((1_900..=2_200).contains(&waited), "{waited}");
        assert!(rig.raised(Alert::HeadingLost));
        let frozen = rig.autopilot().rudder_order();
        let from = rig.orders.len();
        rig.run(20.0);
        assert!(
            rig.orders[from..]
                .iter()
                .all(|(_, order)| *order == frozen.map(|o| o.deg()))
        );
        assert_eq!(
            rig.last_htd().steering_mode,
            Some(SteeringMode::RudderControl)
        );
        // The gyro comes back: nothing happens by itself, and AUTO takes over without a jump.
        rig.filter(|_, _, line| Some(line.to_string()));
        rig.run(20.0);
        assert_eq!(rig.mode(), ModeName::RudderHold);
        rig.command(Order::Mode(ModeRequest::Auto)).unwrap();
        rig.run(30.0);
        rig.check_orders();
    }
}

// TCS-8: an alarm that was taken does not go on saying that AUTO steers.
#[test]
fn track_fail_says_what_steers_now() {
    let mut rig = Rig::tracking();
    rig.run(10.0);
    rig.silence(Profile::Ecdis, "");
    rig.until("TRACK FAIL", 6.2, |rig| rig.raised(Alert::TrackFail));
    let says = |rig: &Rig, steering: &str| {
        let text = rig.text(Alert::TrackFail);
        assert_eq!(
            text,
            format!("chart system: HTC, XTE, PNEY missing: {steering}")
        );
    };
    says(&rig, "AUTO steers, SWITCH TO AUTO");
    rig.command(Order::Acknowledge(101)).unwrap();
    rig.silence(Profile::Gyro1, "");
    rig.until("RUDDER HOLD", 3.0, |rig| rig.mode() == ModeName::RudderHold);
    says(&rig, "rudder held, steer by hand");
    rig.command(Order::Mode(ModeRequest::Standby)).unwrap();
    says(&rig, "STANDBY, steer by hand");
}

// FA8
#[test]
fn a_jump_of_the_gyro_is_never_followed() {
    let mut rig = Rig::tracking();
    rig.run(30.0);
    let order = rig.autopilot().rudder_order().unwrap().deg();
    let begun = rig.now;
    rig.injure(Profile::Gyro1, FaultKind::Jump, true);
    rig.until("HEADING LOST", 2.0, |rig| rig.raised(Alert::HeadingLost));
    let waited = rig.now.since(begun);
    assert!((900..=1_300).contains(&waited), "{waited}");
    assert_eq!(rig.mode(), ModeName::RudderHold);
    let now = rig.autopilot().rudder_order().unwrap().deg();
    assert!((now - order).abs() < 3.0, "{order} -> {now}");
    rig.check_orders();
}

// FA8: half a second of it is bridged.
#[test]
fn a_short_jump_of_the_gyro_is_bridged() {
    let mut rig = Rig::tracking();
    rig.run(120.0);
    let order = rig.autopilot().rudder_order().unwrap().deg();
    rig.injure(Profile::Gyro1, FaultKind::Jump, true);
    rig.run(0.5);
    assert!(rig.raised(Alert::HeadingJump));
    rig.injure(Profile::Gyro1, FaultKind::Jump, false);
    rig.run(5.0);
    assert_eq!(rig.mode(), ModeName::AutonavTi);
    assert!(!rig.raised(Alert::HeadingJump));
    let now = rig.autopilot().rudder_order().unwrap().deg();
    assert!((now - order).abs() < 4.0, "{order} -> {now}");
    rig.check_orders();
}

/// Moves a GLL some metres to the east.
fn moved(line: &str, metres: f64) -> String {
    let gll = Gll::from_sentence(&nmea::decode(line.as_bytes())).unwrap();
    let east = Course::from_deg(90.0);
    let place: Position = gll.position.unwrap();
    let position = Some(rhumb::destination(place, east, Distance::from_m(metres)));
    Gll { position, ..gll }.line(&line[1..3])
}

// FA9: the orders are those of a twin whose operator selects AUTO at that moment.
#[test]
fn a_position_jump_ends_track_control_without_a_turn_towards_it() {
    let mut rig = Rig::tracking();
    rig.run(120.0);
    let heading = rig.heading().deg();
    rig.injure(Profile::Gps, FaultKind::Jump, true);
    rig.until("TRACK FAIL", 2.2, |rig| rig.raised(Alert::TrackFail));
    assert_eq!(rig.mode(), ModeName::Auto);
    assert!((rig.set_heading() - heading).abs() < 1.5);
    let mut twin = Rig::tracking();
    twin.run(120.0);
    let failed = rig.now;
    twin.until("the same moment", 5.0, |twin| twin.now >= failed);
    twin.command(Order::Mode(ModeRequest::Auto)).unwrap();
    for _ in 0..300 {
        rig.step();
        twin.step();
        let order = |rig: &Rig| rig.autopilot().rudder_order().unwrap().deg();
        let apart = (order(&rig) - order(&twin)).abs();
        assert!(apart < 4.0, "{apart} degrees from the twin's order");
    }
    rig.run(60.0);
    assert!((rig.heading().deg() - heading).abs() < 2.0);
    rig.check_orders();
}

// FA9: 60 m off once is not used, three times in a row is a jump.
#[test]
fn one_wrong_position_is_left_out_and_three_end_track_control() {
    for (wrong, fails) in [(1, false), (2, false), (3, true)] {
        let mut rig = Rig::tracking();
        rig.run(30.0);
        let mut left = wrong;
        rig.filter(move |_, from, line| {
            if from == Profile::Gps && line.contains("GLL,") && left > 0 {
                left -= 1;
                return Some(moved(line, 60.0));
            }
            Some(line.to_string())
        });
        rig.until("POSITION JUMP", 2.0, |rig| rig.raised(Alert::PositionJump));
        rig.run(6.0);
        assert_eq!(
            rig.raised(Alert::TrackFail),
            fails,
            "{wrong} wrong positions"
        );
        assert_eq!(rig.mode() == ModeName::Auto, fails);
        rig.check_orders();
    }
}

// FA10
#[test]
fn a_lost_speed_is_a_caution_and_steering_goes_on() {
    let mut rig = Rig::tracking();
    rig.command(Order::Mode(ModeRequest::Auto)).unwrap();
    rig.run(5.0);
    rig.filter(|_, _, line| {
        // Without positions, too: a speed is calculated from them (AP-9).
        let speed = ["VTG,", "VHW,", "GLL,"]
            .iter()
            .any(|name| line.contains(name));
        (!speed).then(|| line.to_string())
    });
    rig.until("SPEED LOST", 7.0, |rig| rig.raised(Alert::SpeedLost));
    rig.run(60.0);
    assert_eq!(rig.mode(), ModeName::Auto);
    assert!((rig.heading().deg() - rig.set_heading()).abs() < 2.0);
    rig.check_orders();
}

// FA6: through every mode and back, with a rudder that a hand has laid before.
#[test]
fn no_change_of_mode_steps_the_order() {
    let mut rig = Rig::tracking();
    let go = |rig: &mut Rig, request| {
        rig.command(Order::Mode(request)).unwrap();
        rig.run(7.0);
    };
    rig.run(20.0);
    go(&mut rig, ModeRequest::Auto);
    rig.command(Order::AdjustHeading(10.0)).unwrap();
    rig.run(4.0);
    rig.command(Order::AdjustHeading(-20.0)).unwrap();
    rig.run(3.0);
    rig.ask(ChartRequest::Track).unwrap(); // TCS-13: it has stopped when AUTO was selected
    go(&mut rig, ModeRequest::Autonav);
    assert_eq!(rig.mode(), ModeName::AutonavTi);
    go(&mut rig, ModeRequest::Auto);
    go(&mut rig, ModeRequest::Standby);
    let rudder = rig.world().truth().rudder.deg();
    rig.command(Order::Mode(ModeRequest::Auto)).unwrap();
    rig.step();
    let first = rig.autopilot().rudder_order().unwrap().deg();
    assert!((first - rudder).abs() < 1.0, "{rudder} -> {first}");
    rig.run(30.0);
    rig.check_orders();
}

// AP-1, AP-4: the report of the rudder when its feedback is gone.
#[test]
fn lost_rudder_feedback_is_an_alarm_and_rsa_says_v() {
    let mut rig = Rig::tracking();
    rig.silence(Profile::Gear, "RSA");
    rig.until("RUDDER", 4.0, |rig| rig.raised(Alert::Rudder));
    assert_eq!(rig.mode(), ModeName::AutonavTi);
    let status = rig.autopilot().picture().rudder.as_ref().unwrap();
    assert!(
        status
            .usable(wheelover_core::limits::Quantity::Rudder, rig.now)
            .is_none()
    );
    rig.check_orders();
}

// FA16
#[test]
fn after_a_stall_every_input_must_be_heard_again() {
    let mut rig = Rig::tracking();
    rig.run(20.0);
    rig.now = rig.now + 10_000;
    let out = rig.stall(10_000);
    assert!(rig.raised(Alert::Stalled));
    let said = |output: &VoyageOutput| matches!(output, VoyageOutput::Line(line) if line.dir == Direction::Out);
    assert!(!out.iter().any(said), "no burst: {out:?}");
    assert!(rig.raised(Alert::TrackFail), "ages count the gap");
    rig.run(30.0);
    rig.check_orders();
}

// FA5 on the gyro: THS whose mode is not autonomous counts as not received (AP-9).
#[test]
fn a_heading_that_says_v_is_lost() {
    let mut rig = Rig::tracking();
    rig.filter(|_, from, line| {
        if from != Profile::Gyro1 {
            return Some(line.to_string());
        }
        line.contains("HDT,").then(|| {
            let changed = edited(line, &[(2, "V")]);
            let body = changed[1..]
                .split('*')
                .next()
                .unwrap()
                .replace("HDT", "THS");
            with_checksum(&body)
        })
    });
    rig.until("RUDDER HOLD", 2.5, |rig| rig.mode() == ModeName::RudderHold);
    assert!(rig.raised(Alert::HeadingLost));
    rig.check_orders();
}

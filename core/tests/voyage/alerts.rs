//! Every alert has its way in and its way back, on the wiring that is shipped (AP-11).

mod cases;

use crate::rig::{Rig, route};
use cases::{CASES, Case, case, fault, nothing, set, whole};
use std::collections::BTreeSet;
use wheelover_core::alerts::{Alert, State};
use wheelover_core::station::Profile;
use wheelover_core::view::{ChartRequest, FaultKind, ModeRequest, Order};
use wheelover_core::voyage::{Voyage, VoyageConfig};

/// Raised by either station.
fn stands(rig: &Rig, alert: Alert) -> bool {
    let chart = rig.chart().alerts().iter();
    rig.raised(alert)
        || chart
            .filter(|standing| standing.alert == alert)
            .any(|standing| standing.state != State::RectifiedUnacknowledged)
}

fn check(rig: &mut Rig, case: &Case) {
    let (alert, name) = (case.alert, case.alert.definition().title);
    assert!(!stands(rig, alert), "{name} stands before");
    (case.raise)(rig);
    rig.until(name, case.within, |rig| stands(rig, alert));
    (case.heal)(rig);
    rig.until(&format!("the end of {name}"), case.gone, |rig| {
        !stands(rig, alert)
    });
}

// AP-11
#[test]
fn every_alert_comes_and_goes() {
    for case in &CASES {
        check(&mut Rig::tracking(), case);
    }
}

// TCS-3, TCS-11: the chart system's own view is hurt by the cable that both hear.
#[test]
fn the_chart_systems_own_alerts_come_and_go() {
    let lost = case(
        Alert::ChartPositionLost,
        |rig| fault(rig, "gps", FaultKind::Cut, true),
        8.0,
        |rig| fault(rig, "gps", FaultKind::Cut, false),
        8.0,
    );
    check(&mut Rig::tracking(), &lost);
    let outside = case(
        Alert::CrossTrack,
        |rig| {
            let set = 335.0;
            rig.command(Order::Current { set, drift: 5.0 }).unwrap();
        },
        600.0,
        |rig| {
            rig.ask(ChartRequest::Stop).unwrap();
        },
        3.0,
    );
    let mut straying = Rig::tracking_on(route(&[(245.0, 20.0), (305.0, 2.5)], 0.5));
    fault(&mut straying, "gear", FaultKind::Cut, true);
    check(&mut straying, &outside);
}

// AP-20: a ship that nobody described.
#[test]
fn unknown_constants_are_said_until_they_are_given() {
    let mut config = VoyageConfig::embedded(1);
    config.ship = None;
    let mut rig = Rig::of(
        Voyage::configured(config),
        route(&[(245.0, 2.5), (305.0, 2.5)], 0.5),
    );
    let unknown = case(
        Alert::ShipUnknown,
        nothing,
        1.0,
        |rig| {
            set(rig, "gain_per_s", 0.185);
            set(rig, "time_constant_s", 107.3);
        },
        1.0,
    );
    check(&mut rig, &unknown);
}

// AP-21: there has to be a wind that can be lost.
#[test]
fn a_lost_wind_is_said_until_it_is_heard() {
    let mut rig = Rig::windy(route(&[(245.0, 2.5), (305.0, 2.5)], 0.5), 3);
    rig.run(5.0);
    for mode in [ModeRequest::Auto, ModeRequest::WindVane] {
        rig.command(Order::Mode(mode)).unwrap();
    }

    check(
        &mut rig,
        &case(
            Alert::WindLost,
            |rig| rig.silence(Profile::Wind, ""),
            7.0,
            whole,
            3.0,
        ),
    );
}

#[test]
fn no_alert_is_left_out() {
    let here: BTreeSet<Alert> = (CASES.iter().map(|case| case.alert))
        .chain([
            Alert::ChartPositionLost,
            Alert::CrossTrack,
            Alert::ShipUnknown,
            Alert::WindLost,
            // It takes a second compass: `monitor`.
            Alert::HeadingDifference,
            // It is off unless it is set: the chart system's tests of its position.
            Alert::ManualSteering,
            // They take a plotter or a steering stand: `track`, `track_refused`, `heading_command` and `stand`.
            Alert::Arrival,
            Alert::ApbConflict,
            Alert::HscConflict,
            Alert::Stand,
            // It takes a second rudder: `rudders`.
            Alert::RudderPort,
            // It takes a motor: `motor`.
            Alert::Motor,
            // They take a port to the outside: `ports`.
            Alert::PortFail,
            Alert::NoSentence,
            Alert::ChartPortFail,
            Alert::ChartNoSentence,
            // It takes RIVER PILOT: `modes::river`.
            Alert::NoHeading,
            // It takes a speed entered by hand: `speed`.
            Alert::ChangeSpeedSource,
        ])
        .collect();
    let missing: Vec<_> = Alert::ALL
        .iter()
        .filter(|alert| !here.contains(alert))
        .collect();
    assert_eq!(missing, [] as [&Alert; 0]);
}

// AP-11: an ACK of what is unknown, or waits for none, does nothing and is said.
#[test]
fn an_acknowledgement_by_sentence_takes_what_waits_and_nothing_else() {
    let mut rig = Rig::tracking();
    rig.silence(Profile::Ecdis, "HTC,");
    rig.until("TRACK FAIL", 6.0, |rig| rig.raised(Alert::TrackFail));
    for (number, why) in [
        ("999", "no such alert"),
        ("110", "no such command"),
        ("122", "no such command"),
    ] {
        rig.say(Profile::Ecdis, &format!("EIACK,{number}"));
        assert!(rig.autopilot().why().contains(number), "{number}");
        assert!(rig.autopilot().why().contains(why), "{number}");
        assert_eq!(
            rig.autopilot().alerts().state(Alert::TrackFail),
            State::Unacknowledged
        );
    }
    rig.say(Profile::Ecdis, "EIACK,101");
    assert_eq!(
        rig.autopilot().alerts().state(Alert::TrackFail),
        State::Acknowledged
    );
}

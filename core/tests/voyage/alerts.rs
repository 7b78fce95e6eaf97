//! Every alert has its way in and its way back, on the wiring that is shipped (AP-11).

use crate::rig::{Rig, edited, route};
use std::collections::BTreeSet;
use wheelover_core::alerts::Alert;
use wheelover_core::nmea;
use wheelover_core::settings::Value;
use wheelover_core::station::Profile;
use wheelover_core::view::{ChartRequest, FaultKind, ModeRequest, Order};
use wheelover_core::voyage::{Voyage, VoyageConfig};

/// How an alert comes and how it goes, once the ship is under track control; and how long each may take, seconds.
struct Case {
    alert: Alert,
    raise: fn(&mut Rig),
    within: f64,
    heal: fn(&mut Rig),
    gone: f64,
}

const fn case(
    alert: Alert,
    raise: fn(&mut Rig),
    within: f64,
    heal: fn(&mut Rig),
    gone: f64,
) -> Case {
    Case {
        alert,
        raise,
        within,
        heal,
        gone,
    }
}

/// Nothing is done: time alone brings it about.
const fn nothing(_: &mut Rig) {}

fn whole(rig: &mut Rig) {
    rig.filter(|_, _, line| Some(line.into()));
}

fn auto(rig: &mut Rig) {
    whole(rig);
    rig.run(3.0);
    rig.command(Order::Mode(ModeRequest::Auto)).unwrap();
}

fn fault(rig: &mut Rig, cable: &str, kind: FaultKind, on: bool) {
    let cable = cable.into();
    rig.command(Order::Fault { cable, kind, on }).unwrap();
}

fn set(rig: &mut Rig, key: &str, value: f64) {
    let (key, value) = (key.into(), Value::Number(value));
    rig.command(Order::Setting { key, value }).unwrap();
}

/// Edits every sentence of that formatter from that port.
fn edit(rig: &mut Rig, from: Profile, formatter: &'static str, field: usize, text: &'static str) {
    rig.filter(move |_, port, line| {
        let hit = port == from && nmea::decode(line.as_bytes()).formatter == formatter;
        Some(if hit {
            edited(line, &[(field, text)])
        } else {
            line.into()
        })
    });
}

/// Another talker on the gyro's line says the same heading.
fn second_compass(rig: &mut Rig, first: bool) {
    rig.filter(move |_, port, line| {
        let heading = port == Profile::Gyro1 && line.contains("HEHDT");
        if !heading {
            return Some(line.into());
        }
        let body = line[1..].split('*').next()?.replace("HEHDT", "HFHDT");
        let second = nmea::with_checksum(&body);
        Some(if first {
            format!("{line}\r\n{second}")
        } else {
            second
        })
    });
}

fn quiet(rig: &mut Rig, ports: &'static [Profile], formatters: &'static [&'static str]) {
    rig.filter(move |_, port, line| {
        let formatter = nmea::decode(line.as_bytes()).formatter;
        let hit = ports.contains(&port) && formatters.contains(&formatter);
        (!hit).then(|| line.into())
    });
}

const CASES: [Case; 26] = [
    case(
        Alert::TrackFail,
        |rig| rig.silence(Profile::Ecdis, "HTC,"),
        6.0,
        auto,
        1.0,
    ),
    case(
        Alert::TrackDataLate,
        |rig| rig.silence(Profile::Ecdis, "XTE,"),
        4.5,
        whole,
        2.0,
    ),
    case(
        Alert::HtcConflict,
        |rig| {
            let second = rig.line("HTC").replace("$EIHTC", "IIHTC");
            rig.say(Profile::Ecdis, second.split('*').next().unwrap());
        },
        1.0,
        nothing,
        6.0,
    ),
    case(
        Alert::TrackDataRefused,
        |rig| edit(rig, Profile::Ecdis, "HTC", 12, "400"),
        2.0,
        whole,
        2.0,
    ),
    case(
        Alert::HeadingLost,
        |rig| rig.silence(Profile::Gyro1, ""),
        3.0,
        auto,
        1.0,
    ),
    case(
        Alert::HeadingJump,
        |rig| fault(rig, "gyro1", FaultKind::Jump, true),
        1.0,
        |rig| fault(rig, "gyro1", FaultKind::Jump, false),
        30.0,
    ),
    case(
        Alert::OffHeading,
        |rig| {
            rig.command(Order::Mode(ModeRequest::Auto)).unwrap();
            rig.run(120.0);
            fault(rig, "gear", FaultKind::Cut, true);
            rig.command(Order::AdjustHeading(40.0)).unwrap();
        },
        200.0,
        |rig| fault(rig, "gear", FaultKind::Cut, false),
        200.0,
    ),
    case(
        Alert::HeadingStuck,
        |rig| {
            fault(rig, "gyro1", FaultKind::Stuck, true);
            rig.command(Order::Mode(ModeRequest::Auto)).unwrap();
            rig.command(Order::AdjustHeading(60.0)).unwrap();
        },
        60.0,
        |rig| fault(rig, "gyro1", FaultKind::Stuck, false),
        20.0,
    ),
    case(
        Alert::HeadingSource,
        |rig| {
            second_compass(rig, true);
            rig.run(15.0);
            second_compass(rig, false);
        },
        4.0,
        |rig| second_compass(rig, true),
        40.0,
    ),
    case(
        Alert::OffTrack,
        |rig| {
            rig.run(60.0);
            edit(rig, Profile::Ecdis, "HTC", 11, "0.003");
            rig.run(20.0);
            rig.command(Order::Current {
                set: 335.0,
                drift: 5.0,
            })
            .unwrap();
        },
        120.0,
        whole,
        5.0,
    ),
    case(
        Alert::PositionJump,
        |rig| fault(rig, "gps", FaultKind::Jump, true),
        3.0,
        |rig| fault(rig, "gps", FaultKind::Jump, false),
        30.0,
    ),
    case(
        Alert::NoDifferential,
        |rig| edit(rig, Profile::Gps, "GLL", 7, "A"),
        3.0,
        whole,
        3.0,
    ),
    case(
        Alert::SpeedLost,
        |rig| {
            quiet(
                rig,
                &[Profile::Gps, Profile::Log, Profile::Ecdis],
                &["VTG", "VBW", "VHW", "RMC"],
            )
        },
        7.0,
        whole,
        3.0,
    ),
    case(
        Alert::PositionSource,
        |rig| quiet(rig, &[Profile::Gps], &["GLL"]),
        7.0,
        whole,
        30.0,
    ),
    case(
        Alert::SpeedSource,
        |rig| quiet(rig, &[Profile::Log], &["VBW", "VHW"]),
        7.0,
        whole,
        30.0,
    ),
    case(
        Alert::RateOfTurn,
        |rig| edit(rig, Profile::Gyro1, "ROT", 1, "-90.0"),
        8.0,
        whole,
        20.0,
    ),
    case(
        Alert::LowSpeed,
        |rig| set(rig, "minimum_speed", 20.0),
        1.0,
        |rig| set(rig, "minimum_speed", 2.0),
        1.0,
    ),
    case(
        Alert::Rudder,
        |rig| rig.silence(Profile::Gear, "RSA"),
        3.0,
        whole,
        1.0,
    ),
    case(
        Alert::Override,
        |rig| edit(rig, Profile::Ecdis, "HTC", 1, "A"),
        2.0,
        whole,
        2.0,
    ),
    case(
        Alert::Stalled,
        |rig| {
            rig.stall(300);
        },
        0.2,
        nothing,
        20.0,
    ),
    case(Alert::CourseChange, nothing, 700.0, nothing, 300.0),
    case(Alert::CourseChangeSoon, nothing, 700.0, nothing, 60.0),
    case(Alert::WheelOver, nothing, 700.0, nothing, 300.0),
    case(Alert::BackupNavigator, nothing, 800.0, nothing, 300.0),
    case(Alert::LastWaypoint, nothing, 1_500.0, nothing, 400.0),
    case(
        Alert::AutopilotLeft,
        |rig| {
            rig.run(3.0);
            rig.command(Order::Mode(ModeRequest::Standby)).unwrap();
        },
        8.0,
        |rig| {
            rig.command(Order::Acknowledge(Alert::AutopilotLeft.number()))
                .unwrap();
        },
        2.0,
    ),
];

/// Raised by either station.
fn stands(rig: &Rig, alert: Alert) -> bool {
    let chart = rig.chart().alerts().iter();
    rig.raised(alert)
        || chart
            .filter(|standing| standing.alert == alert)
            .any(|standing| {
                standing.state != wheelover_core::alerts::State::RectifiedUnacknowledged
            })
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

#[test]
fn no_alert_is_left_out() {
    let here: BTreeSet<Alert> = (CASES.iter().map(|case| case.alert))
        .chain([
            Alert::ChartPositionLost,
            Alert::CrossTrack,
            Alert::ShipUnknown,
            // It takes a second compass: `monitor`.
            Alert::HeadingDifference,
        ])
        .collect();
    let missing: Vec<_> = Alert::ALL
        .iter()
        .filter(|alert| !here.contains(alert))
        .collect();
    assert_eq!(missing, [] as [&Alert; 0]);
}

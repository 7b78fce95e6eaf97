//! How each alert is brought about under track control, and what ends it.

use crate::rig::{Rig, edited};
use wheelover_core::alerts::Alert;
use wheelover_core::nmea;
use wheelover_core::station::Profile;
use wheelover_core::view::{FaultKind, ModeRequest, Order};

/// How an alert comes and how it goes, once the ship is under track control; and how long each may take, seconds.
pub(super) struct Case {
    pub(super) alert: Alert,
    pub(super) raise: fn(&mut Rig),
    pub(super) within: f64,
    pub(super) heal: fn(&mut Rig),
    pub(super) gone: f64,
}

pub(super) const fn case(
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
pub(super) const fn nothing(_: &mut Rig) {}

pub(super) fn whole(rig: &mut Rig) {
    rig.filter(|_, _, line| Some(line.into()));
}

pub(super) fn auto(rig: &mut Rig) {
    whole(rig);
    rig.run(3.0);
    rig.command(Order::Mode(ModeRequest::Auto)).unwrap();
}

pub(super) fn fault(rig: &mut Rig, cable: &str, kind: FaultKind, on: bool) {
    let cable = cable.into();
    rig.command(Order::Fault { cable, kind, on }).unwrap();
}

pub(super) fn set(rig: &mut Rig, key: &str, value: f64) {
    rig.set(key, value).unwrap();
}

/// Edits every sentence of that formatter from that port.
pub(super) fn edit(
    rig: &mut Rig,
    from: Profile,
    formatter: &'static str,
    field: usize,
    text: &'static str,
) {
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
pub(super) fn second_compass(rig: &mut Rig, first: bool) {
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

pub(super) fn quiet(rig: &mut Rig, ports: &'static [Profile], formatters: &'static [&'static str]) {
    rig.filter(move |_, port, line| {
        let formatter = nmea::decode(line.as_bytes()).formatter;
        let hit = ports.contains(&port) && formatters.contains(&formatter);
        (!hit).then(|| line.into())
    });
}

pub(super) const CASES: [Case; 29] = [
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
                &["VTG", "VBW", "VHW", "RMC", "GLL"],
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
    // FA15: 30 s after TRACK FAIL, until that is taken.
    case(
        Alert::BackupCalled,
        |rig| rig.silence(Profile::Ecdis, "HTC,"),
        37.0,
        |rig| {
            let number = Alert::TrackFail.number();
            rig.command(Order::Acknowledge(number)).unwrap();
        },
        0.2,
    ),
    // F2: who has said HBT once is supervised, by its own interval.
    case(
        Alert::HeartbeatLost,
        |rig| rig.say(Profile::Ecdis, "EIHBT,2.0,A,0"),
        5.2,
        |rig| rig.say(Profile::Ecdis, "EIHBT,30.0,A,1"),
        0.2,
    ),
    case(
        Alert::ChartHeartbeatLost,
        |rig| rig.tell_chart(Profile::Ecdis, "AGHBT,2.0,A,0"),
        6.2,
        |rig| rig.tell_chart(Profile::Ecdis, "AGHBT,30.0,A,1"),
        1.2,
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

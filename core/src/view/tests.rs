//! Each message as text: if one changes, `PROTOCOL` must be raised with `golden.txt`.

use super::*;
use crate::facts::Quantity;
use crate::geo::Position;
use crate::picture::Picture;
use crate::station::{ChecksumPolicy, Direction, PortSetup, Profile};
use alloc::string::{String, ToString};
use alloc::vec::Vec;
use alloc::{format, vec};

fn messages() -> Vec<String> {
    let place = Position {
        lat: 59.5,
        lon: 24.25,
    };
    let port = PortSetup {
        name: "ecdis".into(),
        profile: Profile::Ecdis,
        checksum: ChecksumPolicy::Required,
        talkers: Vec::new(),
        baud: 4800,
        output: true,
    };
    let down = [
        Down::Hello(Hello {
            protocol: PROTOCOL,
            build: "0.1.0".into(),
            dictionary: 140,
            picture: Picture::new(crate::station::Role::Autopilot, vec![port.clone()]),
            line: 7,
            at: 1_000,
            rate: 1.0,
            ports: vec![port],
            station: "autopilot".into(),
            ship: Outline::default(),
            simulated: true,
            may_command: false,
        }),
        Down::Snapshot(Snapshot {
            frame: 1,
            at: 2_000,
            rate: 10.0,
            line: 9,
            digest: "cbf29ce484222325".into(),
            own: Some(Own {
                mode: ModeName::AutonavTi,
                why: "track controlled by the chart system".into(),
                pending: Some(Pending {
                    request: ModeName::AutonavTi,
                    until: 21_000,
                    waits_for: "no position".into(),
                }),
                closed: vec![(ModeRequest::Auto, "no heading".into())],
                set_heading: None,
                set_value: None,
                hts: Some(245.5),
                set_rate: 28.0,
                set_radius: 0.5,
                by_radius: true,
                rudder_limit: 35.0,
                rudder_order: Some(-3.5),
                pair: true,
                port_order: Some(-3.0),
                cross_track: Some(12.5),
                cross_track_limit: 185.2,
                sources: vec![("heading".into(), "gyro1/HE/HDT".into())],
                heading: Some(245.0),
                magnetic: false,
                judged: 1_900,
                position: Some(place),
                manual_speed: Some(11.5),
                calculated: Some((Some(246.5), 14.25)),
                refused: vec![RefusedView {
                    quantity: Quantity::Position,
                    source: "gps/GP/GLL".into(),
                    why: "jumped".into(),
                }],
                terms: Some(Terms {
                    proportional: 1.0,
                    integral: 0.5,
                    rate: -0.25,
                    feedforward: 4.0,
                }),
                limited: false,
                output: true,
            }),
            chart: Some(ChartOwn {
                situation: 4,
                control: "track".into(),
                leg: 2,
                wheel_over_s: Some(-40.0),
                why: String::new(),
                adrift: Some((
                    Position {
                        lat: 59.5,
                        lon: 25.0,
                    },
                    64.5,
                )),
            }),
            voyage: Some(VoyageOwn {
                officer: true,
                round: 1,
                speed: 10.0,
                faults: vec![("ecdis".into(), FaultKind::Silent)],
                current: [100.0, 1.0],
            }),
            alerts: vec![AlertView {
                number: 101,
                priority: crate::alerts::Priority::Alarm,
                state: crate::alerts::State::Unacknowledged,
                category: crate::alerts::Category::B,
                title: "TRACK FAIL".into(),
                text: "HTC missing".into(),
                at: 1_500,
            }],
        }),
        Down::Route(RouteDocument {
            revision: 1,
            name: "Gulf of Finland".into(),
            waypoints: vec![WaypointView {
                id: "001".into(),
                position: place,
                radius_nm: Some(0.5),
                xtd_m: [185.2, 185.2],
                course: Some(245.0),
            }],
            turns: vec![TurnView {
                waypoint: 1,
                wheel_over: place,
                start: place,
                end: place,
                centre: place,
                turn: -30.0,
                forwarding_m: 216.0,
            }],
        }),
        Down::Settings(SettingsDocument {
            revision: 1,
            values: vec![
                ("rudder_limit".into(), Value::Number(20.0)),
                ("external_tcs".into(), Value::Switch(true)),
                ("steering_by".into(), Value::Choice("radius".into())),
                ("gain_per_s".into(), Value::Absent),
            ],
        }),
        Down::Ports(PortsDocument {
            revision: 1,
            ports: vec![PortView::default()],
        }),
        Down::Lines(Lines {
            from: 8,
            lines: vec![Line {
                seq: 8,
                at: 1_900,
                port: 0,
                dir: Direction::In,
                text: "$EIHTC,V\u{e4}".into(),
            }],
        }),
        Down::Gap { lost: 12 },
        Down::Answer(Answer {
            id: 3,
            ok: false,
            text: "no position".into(),
        }),
    ];
    let pressed = |frame, action| Up::Command {
        id: 7,
        frame,
        action,
    };
    let command = |action| pressed(None, action);
    let up = [
        Up::Ack { frame: 1 },
        Up::Resume { seq: 8 },
        Up::Subscribe {
            rate: 10.0,
            lines: true,
        },
        command(Order::Mode(ModeRequest::Standby)),
        pressed(Some(812), Order::SetHeading(245.0)),
        command(Order::AdjustHeading(10.0)),
        command(Order::Mode(ModeRequest::WindVane)),
        command(Order::Mode(ModeRequest::RiverPilot)),
        command(Order::Mode(ModeRequest::Dodge)),
        command(Order::Mode(ModeRequest::FfuOverride)),
        command(Order::Mode(ModeRequest::Installation)),
        command(Order::Mode(ModeRequest::Autotuning)),
        command(Order::SetRate(-12.5)),
        command(Order::SetRadius(0.5)),
        command(Order::SetRudder(5.0)),
        command(Order::SetDodge(-15.0)),
        command(Order::SetWindAngle(-40.0)),
        command(Order::Tack(Side::Port)),
        command(Order::Acknowledge(101)),
        command(Order::Silence(true)),
        command(Order::Speed(10.0)),
        command(Order::Officer(false)),
        command(Order::Fault {
            cable: "ecdis".into(),
            kind: FaultKind::Silent,
            on: true,
        }),
        command(Order::Current {
            set: 100.0,
            drift: 1.0,
        }),
        command(Order::Chart(ChartRequest::Track)),
        command(Order::Setting {
            key: "rudder_limit".into(),
            value: Value::Number(15.0),
        }),
    ];
    let mut texts = vec![format!("protocol {PROTOCOL}")];
    texts.extend(
        down.iter()
            .map(|message| serde_json::to_string(message).unwrap()),
    );
    texts.extend(
        up.iter()
            .map(|message| serde_json::to_string(message).unwrap()),
    );
    texts
}

#[test]
fn no_message_changes_its_text_without_a_new_protocol() {
    let golden = include_str!("golden.txt")
        .lines()
        .map(ToString::to_string)
        .collect::<Vec<_>>();
    let now = messages();
    if golden.first() == now.first() {
        assert_eq!(
            now, golden,
            "a message has changed: raise PROTOCOL and renew golden.txt"
        );
    } else {
        panic!("PROTOCOL is new: renew golden.txt with\n{}", now.join("\n"));
    }
}

#[test]
fn every_message_comes_back_as_it_was() {
    for text in &messages()[1..9] {
        let message: Down = serde_json::from_str(text).unwrap();
        assert_eq!(&serde_json::to_string(&message).unwrap(), text);
    }
    for text in &messages()[9..] {
        let message: Up = serde_json::from_str(text).unwrap();
        assert_eq!(&serde_json::to_string(&message).unwrap(), text);
    }
}

#[test]
fn a_route_is_drawn_with_all_its_turns() {
    let document = drawn_route(&crate::route::embedded(), 3);
    let drawn = (document.waypoints.len(), document.turns.len());
    assert_eq!((drawn, document.revision), ((8, 6), 3));
}

/// AP-6, AP-25: what the page greys is what a press would be refused with, in each mode that an officer meets.
#[test]
fn a_mode_that_would_be_refused_is_closed_with_the_reason_of_the_refusal() {
    use crate::time::Stamp;
    use crate::voyage::{Event, Voyage, VoyageConfig, VoyageOutput};
    let mut config = VoyageConfig::embedded(7);
    config.settings.external_tcs = false;
    let mut unfitted = Voyage::configured(config);
    let mut voyage = Voyage::embedded(7);
    let closed = |voyage: &Voyage| snapshot(voyage).own.unwrap().closed;
    let press = |voyage: &mut Voyage, request| {
        let mut out = Vec::new();
        let order = Order::Mode(request);
        let by = Origin::Officer;
        voyage.handle(voyage.now(), Event::Order { id: 1, by, order }, &mut out);
        out.into_iter().find_map(|output| match output {
            VoyageOutput::Answer(answer) => Some((answer.ok, answer.text)),
            _ => None,
        })
    };
    assert_eq!(closed(&voyage)[0], (ModeRequest::Auto, "no heading".into()));
    for voyage in [&mut voyage, &mut unfitted] {
        for (second, request) in [
            (5, ModeRequest::Standby),
            (6, ModeRequest::Auto),
            (7, ModeRequest::Standby),
        ] {
            voyage.handle(Stamp(second * 1_000), Event::Tick, &mut Vec::new());
            press(voyage, request);
            for (mode, why) in closed(voyage) {
                assert_eq!(press(&mut voyage.clone(), mode), Some((false, why)));
            }
        }
        let open = |mode: ModeRequest| closed(voyage).iter().all(|(closed, _)| *closed != mode);
        assert!(open(ModeRequest::Standby) && open(ModeRequest::Auto));
    }
    let why_not = |voyage: &Voyage, mode| {
        let mut closed = closed(voyage).into_iter();
        closed.find_map(|(closed, why)| (closed == mode).then_some(why))
    };
    let why = |voyage: &Voyage| why_not(voyage, ModeRequest::Autonav);
    let autonav = |why: &str| Some(why.to_string());
    let not_fitted = autonav("AutoNAV is not enabled at installation");
    assert_eq!(why(&unfitted), not_fitted);
    assert_eq!(why(&voyage), autonav("AutoNAV is selected from AUTO only"));
    press(&mut voyage, ModeRequest::Auto);
    press(&mut unfitted, ModeRequest::Auto);
    for open in [ModeRequest::Auto, ModeRequest::Autonav, ModeRequest::Dodge] {
        assert_eq!(why_not(&voyage, open), None, "AUTO is on");
    }
    let standby = autonav("INSTALLATION is selected from STANDBY only");
    assert_eq!(why_not(&voyage, ModeRequest::Installation), standby);
    let no_plotter = autonav("no valid APB");
    assert_eq!(why_not(&voyage, ModeRequest::Track), no_plotter);
    assert_eq!(why(&unfitted), not_fitted);
}

#[test]
fn a_snapshot_fits_into_two_kilobytes() {
    assert!(messages()[2].len() <= 2_048, "{}", messages()[2].len());
}

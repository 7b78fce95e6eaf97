//! Hand-written meanings of lines, and what typed views write.

#![allow(clippy::needless_update)] // some samples name every field

use crate::geo::Position;
use crate::nmea::*;
use alloc::string::String;

fn line(body: &str) -> String {
    with_checksum(body)
}

macro_rules! reads {
    ($body:expr, $view:ident { $($field:ident : $value:expr),* $(,)? }) => {
        let text = line($body);
        let sentence = decode(text.as_bytes());
        assert_eq!(sentence.faults(), [], "{}", $body);
        let view = $view::from_sentence(&sentence).expect("the view");
        #[allow(clippy::needless_update)]
        let expected = $view { $($field: $value,)* ..Default::default() };
        assert_eq!(view, expected, "{}", $body);
        assert_eq!(encode(&sentence).as_deref(), Some(text.as_str()));
    };
}

#[test]
fn chart_system_sentences_mean_what_the_document_says() {
    reads!(
        "EIHTC,V,,,T,R,,,0.35,,,,280.0,T,C",
        Htc {
            override_status: Some(OverrideStatus::NotInUse),
            steering_mode: Some(SteeringMode::TrackControl),
            turn_mode: Some(TurnMode::Radius),
            radius: Some(0.35),
            track: Some(280.0),
            reference: Some(Reference::True),
            status: Some(CommandStatus::Command),
        }
    );
    // Steer to port: the ship is right of the track.
    reads!(
        "EIXTE,A,A,0.12,L,N,A",
        Xte {
            status: Some(DataStatus::Valid),
            cycle_lock: Some(DataStatus::Valid),
            cross_track: Some(0.12),
            mode: Some(ModeIndicator::Autonomous),
        }
    );
    reads!(
        "PNEY,001,A,A,0.015,R,N,A",
        Pney1 {
            status: Some(DataStatus::Valid),
            cycle_lock: Some(DataStatus::Valid),
            cross_track: Some(-0.015),
            mode: Some(ModeIndicator::Autonomous),
        }
    );
    reads!(
        "PNEY,002,6235.234,N,12343.231,W,001",
        Pney2 {
            centre: Some(Position {
                lat: 62.0 + 35.234 / 60.0,
                lon: -(123.0 + 43.231 / 60.0)
            }),
            waypoint: Some("001".into()),
        }
    );
    reads!("PNEY,002,,,,,", Pney2 {});
    reads!(
        "EIVTG,234.5,T,,M,10.0,N,18.2,K,A",
        Vtg {
            course_true: Some(234.5),
            speed_knots: Some(10.0),
            speed_kmh: Some(18.2),
            mode: Some(ModeIndicator::Autonomous),
        }
    );
}

#[test]
fn autopilot_sentences_mean_what_the_document_says() {
    reads!(
        "AGHTD,V,14.0,R,T,R,35.0,20.0,0.35,017.5,279.5,,280.0,T,A,A,,267.2",
        Htd {
            override_status: Some(OverrideStatus::NotInUse),
            rudder_angle: Some(14.0),
            steering_mode: Some(SteeringMode::TrackControl),
            turn_mode: Some(TurnMode::Radius),
            rudder_limit: Some(35.0),
            off_heading_limit: Some(20.0),
            radius: Some(0.35),
            rate_of_turn: Some(17.5),
            heading_to_steer: Some(279.5),
            track: Some(280.0),
            reference: Some(Reference::True),
            rudder_status: Some(LimitStatus::Within),
            off_heading_status: Some(LimitStatus::Within),
            heading: Some(267.2),
        }
    );
    reads!(
        "AGRSA,11.2,A,,V",
        Rsa {
            starboard: Some(11.2),
            starboard_status: Some(DataStatus::Valid),
            port_status: Some(DataStatus::Invalid),
        }
    );
    reads!(
        "AGROR,-14.0,A,,V,B",
        Ror {
            starboard: Some(-14.0),
            starboard_status: Some(DataStatus::Valid),
            port_status: Some(DataStatus::Invalid),
            source: Some(CommandSource::Bridge),
        }
    );
    reads!(
        "AGALR,,012,A,V,",
        Alr {
            number: Some(12),
            condition: Some(AlarmCondition::Raised),
            acknowledged: Some(AcknowledgeState::NotAcknowledged),
        }
    );
}

#[test]
fn awkward_forms_are_read() {
    reads!(
        "YXXDR,A,-12.5,D,HEEL,C,,C,AIR",
        Xdr {
            readings: alloc::vec![
                XdrReading {
                    kind: Some(TransducerType::Angle),
                    reading: Some(-12.5),
                    unit: Some(TransducerUnit::Degree),
                    name: Some("HEEL".into())
                },
                XdrReading {
                    kind: Some(TransducerType::Temperature),
                    reading: None,
                    unit: Some(TransducerUnit::Celsius),
                    name: Some("AIR".into())
                },
            ]
        }
    );
    reads!(
        "GPGSV,2,2,05,07,45,066,",
        Gsv {
            total: Some(2),
            number: Some(2),
            in_view: Some(5),
            satellites: alloc::vec![GsvSatellite {
                id: Some(7),
                elevation: Some(45.0),
                azimuth: Some(66.0),
                signal: None
            }],
        }
    );
    reads!(
        "AGALC,01,01,03,2,,10012,,1,FEC,999,,2",
        Alc {
            total: Some(1),
            number: Some(1),
            sequence: Some(3),
            count: Some(2),
            entries: alloc::vec![
                AlcEntry {
                    alert: Some(10012),
                    revision: Some(1),
                    ..Default::default()
                },
                AlcEntry {
                    manufacturer: Some("FEC".into()),
                    alert: Some(999),
                    revision: Some(2),
                    ..Default::default()
                },
            ],
        }
    );
    let text = "!AIVDM,1,1,,A,15MgK45P3@G?fl0E`JbR0OwT0@MS,0*4E";
    let sentence = decode(text.as_bytes());
    assert_eq!(sentence.faults(), []);
    assert_eq!(encode(&sentence).as_deref(), Some(text));
}

#[test]
fn views_write_the_decimals_of_the_document() {
    let htc = Htc {
        override_status: Some(OverrideStatus::NotInUse),
        steering_mode: Some(SteeringMode::HeadingControl),
        turn_mode: Some(TurnMode::Rate),
        rate_of_turn: Some(27.46),
        heading_to_steer: Some(45.0),
        track: Some(345.44),
        reference: Some(Reference::True),
        status: Some(CommandStatus::Command),
        ..Default::default()
    };
    assert_eq!(
        htc.line("EI"),
        line("EIHTC,V,,,H,T,,,,027.5,045.0,,345.4,T,C")
    );
    assert_eq!(Rsa::default().line("AG"), line("AGRSA,,,,"));
    assert_eq!(
        Hsc {
            heading_true: Some(10.0),
            ..Default::default()
        }
        .line("EI"),
        line("EIHSC,010.0,T,,M")
    );
    let ror = Ror {
        starboard: Some(-4.04),
        source: Some(CommandSource::Bridge),
        ..Default::default()
    };
    assert_eq!(ror.line("AG"), line("AGROR,-4.0,,,,B"));
    let gll = Gll {
        position: Some(Position {
            lat: -5.5,
            lon: 100.25,
        }),
        time: Some(UtcTime {
            hour: 1,
            minute: 2,
            centisecond: 350,
        }),
        ..Default::default()
    };
    assert_eq!(
        gll.line("EI"),
        line("EIGLL,0530.00000,S,10015.00000,E,010203.50,,")
    );
    let xdr = Xdr {
        readings: alloc::vec![XdrReading {
            kind: Some(TransducerType::Angle),
            name: Some("a,b".into()),
            ..Default::default()
        }],
    };
    assert_eq!(xdr.line("YX"), line("YXXDR,A,,,a^2Cb"));
}

#[test]
fn faults_name_the_field_and_leave_the_others() {
    let check = |body: &str, expect: &[(Option<u8>, &str)]| {
        let text = line(body);
        let found: alloc::vec::Vec<_> = decode(text.as_bytes())
            .faults()
            .iter()
            .map(|f| (f.field, f.kind.name()))
            .collect();
        assert_eq!(found, expect, "{body}");
    };
    check(
        "EIGLL,5345.345,N,12365.635,W,123423,A,A",
        &[(Some(3), "minutes_too_large")],
    );
    check("EIGLL,5345.345,N,,W,,A,A", &[(Some(3), "missing_part")]);
    check(
        "EIGLL,345.345,N,00000.000,W,246060,A,X",
        &[
            (Some(1), "bad_width"),
            (Some(5), "bad_time"),
            (Some(7), "unknown_code"),
        ],
    );
    check("HEHDT,360.0,T", &[]);
    check("HEHDT,360.1,T", &[(Some(1), "out_of_range")]);
    check(
        "HEHDT,NaN,M",
        &[(Some(1), "not_a_number"), (Some(2), "wrong_letter")],
    );
    check("EIXTE,A,A,0.1,,N,A", &[(Some(4), "missing_part")]);
    check(
        "AGHTD,V,16.0,R,S,N,16.0,20.0,0.42,028,,,,T,A,A,,216.8,",
        &[],
    );
    check(
        "AGHTD,V,16.0,R,S,N,16.0,20.0,0.42,028,,,,T,A,A,,216.8,1",
        &[(Some(18), "extra_field")],
    );
    check(
        "EIHTC,V,,,S,N,,,,,,T,C",
        &[
            (None, "field_count"),
            (Some(11), "not_a_number"),
            (Some(12), "not_a_number"),
        ],
    );
    check("AGALC,01,01,03,2,,10012,,1", &[(Some(8), "field_count")]);
    check("XXZZZ,1", &[]);
    let gll = line("EIGLL,5345.345,N,12365.635,W,123423,A,A");
    let view = Gll::from_sentence(&decode(gll.as_bytes())).expect("a GLL");
    assert_eq!(
        (view.position, view.status),
        (None, Some(DataStatus::Valid))
    );
}

#[test]
fn lines_are_identified() {
    let check = |text: &str, talker: &str, formatter: &str, known: bool| {
        let sentence = decode(text.as_bytes());
        assert_eq!(
            (
                sentence.talker(),
                sentence.formatter,
                sentence.known.is_some()
            ),
            (talker, formatter, known),
            "{text}"
        );
    };
    check("$EIHTC,V", "EI", "HTC", true);
    check("$PNEY,001,A", "P", "PNEY,001", true);
    check("$PNEY,009,A", "P", "PNEY", false);
    check("$PYDKD,CRA", "P", "PYDKD", false);
    check("$GPZZZ,1", "GP", "ZZZ", false);
    check("$CCECQ,HTC", "CC", "ECQ", true);
    check("\\s:a*12\\$EIHTC,V", "EI", "HTC", true);
    check("$", "", "", false);
    check("", "", "", false);
    check("$\u{e9}\u{e9}\u{e9}", "", "\u{e9}\u{e9}\u{e9}", false);
}

#[test]
fn whole_numbers_of_the_documents_are_sent_whole() {
    // SEN-9, EMC-1: as EMACUA and Furuno print them.
    let check = |line: &str, again: Option<String>, talker: &str| {
        let line = with_checksum(line);
        assert_eq!(again.as_deref(), Some(line.as_str()), "{talker}");
    };
    let printed = "PEMC,03,2,45,5,S,2,-3.2,-32.9,10";
    let line = with_checksum(printed);
    let view = Pemc03::from_sentence(&decode(line.as_bytes()));
    check(printed, view.map(|view| view.line("")), "PEMC,03");
    let abm = "!AIABM,1,1,2,230123456,0,12,D89C,0";
    let line = with_checksum(abm);
    let view = Abm::from_sentence(&decode(line.as_bytes()));
    check(abm, view.map(|view| view.line("AI")), "ABM");
    let tlb = "RATLB,5,07,1023,230123456";
    let line = with_checksum(tlb);
    let view = Tlb::from_sentence(&decode(line.as_bytes()));
    check(tlb, view.map(|view| view.line("RA")), "TLB");
}

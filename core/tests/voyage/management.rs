//! Bridge alert management on a real port: ALF, ALC, ARC and HBT out, ACN and HBT in, both stations (AP-11, F2).

use crate::rig::Rig;
use wheelover_core::alerts::{Alert, State};
use wheelover_core::nmea::{self, Alc, Alf, Arc, Hbt};
use wheelover_core::settings::Value;
use wheelover_core::station::{ChecksumPolicy, PortSetup, Profile, Role};
use wheelover_core::view::Order;

fn rig(station: Role) -> Rig {
    let port = PortSetup {
        name: "bams".into(),
        profile: Profile::Bams,
        checksum: ChecksumPolicy::Required,
        talkers: Vec::new(),
        baud: 4_800,
        output: true,
    };
    Rig::tracking_with(vec![(station, port)])
}

/// What was said on the port since it was last asked: body without talker and checksum.
fn said(rig: &mut Rig, talker: &str) -> Vec<String> {
    let sent = std::mem::take(&mut rig.sent);
    let body = |(_, line): (_, String)| {
        let sentence = nmea::decode(line.as_bytes());
        assert_eq!(sentence.faults(), [], "{line}");
        assert!(line.len() <= 80, "{line}");
        let body = line.strip_prefix(&format!("${talker}"))?;
        Some(body.split('*').next()?.to_string())
    };
    sent.into_iter().filter_map(body).collect()
}

/// The fields of ALF that change with the state, as it was told last: total, number, category, priority, state,
/// identifier, instance, revision, escalation, text.
fn alf(said: &[String], identifier: &str, number: &str) -> String {
    let line = said.iter().rev().find(|line| {
        let fields: Vec<&str> = line.split(',').collect();
        fields[0] == "ALF" && fields[2] == number && fields[9] == identifier
    });
    let line = line.unwrap_or_else(|| panic!("no ALF {number} of {identifier} in {said:?}"));
    let fields: Vec<&str> = line.split(',').collect();
    let told = [1, 2, 5, 6, 7, 9, 10, 11, 12, 13].map(|field| fields[field]);
    told.join(",")
}

fn acn(rig: &mut Rig, identifier: &str, command: &str) {
    let body = format!("BNACN,101112.00,,{identifier},1,{command},C");
    rig.say(Profile::Bams, &body);
}

// AP-11: what ACN asks, what is told of it, and the state after it.
#[test]
fn an_alarm_is_told_whole_and_commanded_from_there() {
    let mut rig = rig(Role::Autopilot);
    rig.silence(Profile::Ecdis, "HTC,");
    rig.until("TRACK FAIL", 6.0, |rig| rig.raised(Alert::TrackFail));
    let state = |rig: &Rig| rig.autopilot().alerts().state(Alert::TrackFail);
    let mut step = |heartbeat: bool, identifier: &str, command: &str, first: &str, is: State| {
        if heartbeat {
            rig.say(Profile::Bams, "BNHBT,30.0,A,4");
        }
        if !command.is_empty() {
            acn(&mut rig, identifier, command);
        }
        rig.run(2.0);
        let said = said(&mut rig, "AG");
        if first.starts_with("ARC") {
            assert!(said.iter().any(|line| line == first), "{first} {said:?}");
        } else {
            assert_eq!(alf(&said, identifier, "1"), first);
            let second = alf(&said, identifier, "2");
            assert!(second.starts_with("2,2,,,,10101,1,"), "{second}");
            assert!(second.contains(",HTC "), "{second}");
        }
        assert_eq!(state(&rig), is, "{command} {identifier}");
    };
    let waits = State::Unacknowledged;
    step(
        false,
        "10101",
        "",
        "2,1,B,A,V,10101,1,1,0,TRACK FAIL",
        waits,
    );
    step(
        false,
        "10101",
        "Q",
        "2,1,B,A,V,10101,1,1,0,TRACK FAIL",
        waits,
    );
    step(false, "10101", "O", "ARC,101112.00,,10101,1,O", waits);
    step(false, "10999", "A", "ARC,101112.00,,10999,1,A", waits);
    step(false, "101", "A", "ARC,101112.00,,101,1,A", waits);
    step(false, "10201", "A", "ARC,101112.00,,10201,1,A", waits);
    step(false, "10110", "A", "ARC,101112.00,,10110,1,A", waits);
    step(
        false,
        "10101",
        "S",
        "2,1,B,A,S,10101,1,2,0,TRACK FAIL",
        State::Silenced,
    );
    step(
        true,
        "10101",
        "O",
        "2,1,B,A,O,10101,1,3,0,TRACK FAIL",
        State::Transferred,
    );
    step(
        false,
        "10101",
        "A",
        "2,1,B,A,A,10101,1,4,0,TRACK FAIL",
        State::Acknowledged,
    );
    step(
        false,
        "10101",
        "A",
        "ARC,101112.00,,10101,1,A",
        State::Acknowledged,
    );
    step(
        false,
        "10101",
        "S",
        "ARC,101112.00,,10101,1,S",
        State::Acknowledged,
    );
}

// AP-11: category A is refused with ARC, and acknowledged where its reason is shown.
#[test]
fn category_a_is_refused_there_and_acknowledged_here() {
    let mut rig = rig(Role::Autopilot);
    rig.run(60.0);
    let (key, value) = ("off_track_limit".into(), Value::Number(20.0));
    rig.command(Order::Setting { key, value }).unwrap();
    let (set, drift) = (335.0, 5.0);
    rig.command(Order::Current { set, drift }).unwrap();
    rig.until("OFF TRACK", 300.0, |rig| rig.raised(Alert::OffTrack));
    acn(&mut rig, "10115", "A");
    rig.run(2.0);
    let told = said(&mut rig, "AG");
    assert!(
        told.iter().any(|line| line == "ARC,101112.00,,10115,1,A"),
        "{told:?}"
    );
    assert!(
        alf(&told, "10115", "1").starts_with("2,1,A,A,V,10115,"),
        "{told:?}"
    );
    assert!(rig.autopilot().why().contains("category A"));
    rig.command(Order::Acknowledge(115)).unwrap();
    assert_eq!(
        rig.autopilot().alerts().state(Alert::OffTrack),
        State::Acknowledged
    );
}

// AP-11: what is no whole command changes nothing and is not answered.
#[test]
fn what_is_no_command_is_left_alone() {
    let mut rig = rig(Role::Autopilot);
    rig.silence(Profile::Ecdis, "HTC,");
    rig.until("TRACK FAIL", 6.0, |rig| rig.raised(Alert::TrackFail));
    rig.run(2.0);
    said(&mut rig, "AG");
    for body in [
        "BNACN,,,10101,1,A,R",
        "BNACN,,,10101,1,A,",
        "BNACN,,,10101,1,X,C",
        "BNACN,,,10101,1,,C",
        "BNACN,996112.00,,10101,1,A,C",
        "BNACK,101",
    ] {
        rig.say(Profile::Bams, body);
        rig.run(1.0);
        let told = said(&mut rig, "AG");
        let quiet = told
            .iter()
            .all(|line| line.starts_with("ALC") || line.starts_with("HBT"));
        assert!(quiet, "{body}: {told:?}");
        assert_eq!(
            rig.autopilot().alerts().state(Alert::TrackFail),
            State::Unacknowledged,
            "{body}"
        );
    }
}

// AP-11, IEC 62923-1: list and heartbeat each half minute; an entry is never split.
#[test]
fn the_list_names_all_that_is_not_normal() {
    let mut rig = rig(Role::Autopilot);
    let (key, value) = ("minimum_speed".into(), Value::Number(20.0));
    rig.command(Order::Setting { key, value }).unwrap();
    let later = rig.now + 8_000;
    rig.filter(move |now, from, line| {
        let lost = from == Profile::Ecdis || from == Profile::Gyro1 && now > later;
        (!lost).then(|| line.to_string())
    });
    rig.run(65.0);
    let (mut lists, mut beats) = (Vec::new(), Vec::new());
    for (at, line) in &rig.sent {
        let sentence = nmea::decode(line.as_bytes());
        lists.extend(Alc::from_sentence(&sentence).map(|alc| (at.0, alc)));
        beats.extend(Hbt::from_sentence(&sentence).map(|hbt| (at.0, hbt)));
    }
    let times: Vec<u64> = beats.iter().map(|(at, _)| *at).collect();
    assert!(times.len() >= 3, "{times:?}");
    assert!(
        times.windows(2).all(|pair| pair[1] - pair[0] == 30_000),
        "{times:?}"
    );
    for (number, (_, beat)) in (0..).zip(&beats) {
        assert_eq!((beat.interval, beat.sequence), (Some(30.0), Some(number)));
    }
    // The last list is that of now.
    let last = lists.last().unwrap().1.sequence;
    let pages: Vec<&Alc> = lists
        .iter()
        .filter(|(_, alc)| alc.sequence == last)
        .map(|(_, alc)| alc)
        .collect();
    for (number, page) in (1..).zip(&pages) {
        assert_eq!(
            (page.total, page.number),
            (Some(pages.len() as u32), Some(number))
        );
        assert_eq!(page.count, Some(page.entries.len() as u32));
    }
    let listed: Vec<_> = pages
        .iter()
        .flat_map(|page| &page.entries)
        .map(|entry| (entry.alert.unwrap(), entry.revision.unwrap()))
        .collect();
    let alerts = rig.autopilot().alerts();
    let standing: Vec<_> = alerts
        .standing()
        .iter()
        .map(|standing| {
            let alert = standing.alert;
            (alert.identifier(), u32::from(alerts.revision(alert)))
        })
        .collect();
    assert!(
        standing.len() > 3,
        "one page is no test of pages: {standing:?}"
    );
    assert_eq!(listed, standing);
    let first = &lists[0].1;
    assert_eq!(
        (first.total, first.count),
        (Some(1), Some(0)),
        "none at the start"
    );
}

// F2: a heartbeat that is missed is an alert, and what was transferred waits here again.
#[test]
fn what_was_transferred_comes_back_with_the_heartbeat_lost() {
    let mut rig = rig(Role::Autopilot);
    rig.silence(Profile::Ecdis, "HTC,");
    rig.until("TRACK FAIL", 6.0, |rig| rig.raised(Alert::TrackFail));
    rig.say(Profile::Bams, "BNHBT,4.0,A,0");
    acn(&mut rig, "10101", "O");
    rig.run(9.9);
    let state = |rig: &Rig| rig.autopilot().alerts().state(Alert::TrackFail);
    assert_eq!(state(&rig), State::Transferred);
    rig.run(0.3);
    assert_eq!(state(&rig), State::Unacknowledged);
    assert_eq!(rig.text(Alert::HeartbeatLost), "bams: no heartbeat");
    rig.say(Profile::Bams, "BNHBT,4.0,V,1");
    rig.run(0.2);
    assert_eq!(
        rig.text(Alert::HeartbeatLost),
        "bams: its heartbeat says system fail"
    );
}

// AP-11, TCS-11: the chart system's alerts leave in the same way, and are commanded in the same way.
#[test]
fn the_chart_systems_alerts_are_told_and_commanded_too() {
    let mut rig = rig(Role::ChartSystem);
    let stands = |rig: &Rig, alert| {
        let mut alerts = rig.chart().alerts().iter();
        alerts
            .find(|standing| standing.alert == alert)
            .map(|standing| standing.state)
    };
    rig.until("WHEEL OVER", 700.0, |rig| {
        stands(rig, Alert::WheelOver).is_some()
    });
    rig.run(2.0);
    let told = said(&mut rig, "EI");
    // The warning before it has ended without an answer, and is told so.
    let warning = told
        .iter()
        .rev()
        .find(|line| line.contains(",WHEEL OVER SOON"));
    assert!(
        warning.is_some_and(|line| line.contains(",B,W,N,,10202,1,2,0,")),
        "{told:?}"
    );
    assert_eq!(alf(&told, "10203", "1"), "2,1,B,A,V,10203,1,1,0,WHEEL OVER");
    let command = |rig: &mut Rig, command| {
        let body = format!("BNACN,,,10203,,{command},C");
        rig.tell_chart(Profile::Bams, &body);
        rig.run(2.0);
    };
    rig.tell_chart(Profile::Bams, "BNACN,,,10101,,A,C");
    rig.run(2.0);
    let refused = said(&mut rig, "EI");
    assert!(
        refused.iter().any(|line| line == "ARC,,,10101,,A"),
        "{refused:?}"
    );
    command(&mut rig, "S");
    assert_eq!(stands(&rig, Alert::WheelOver), Some(State::Silenced));
    command(&mut rig, "A");
    assert_eq!(stands(&rig, Alert::WheelOver), Some(State::Acknowledged));
    // It is the confirmation of the course change: no back-up navigator is called.
    rig.run(31.0);
    assert_eq!(stands(&rig, Alert::BackupNavigator), None);
}

#[test]
fn every_sentence_of_the_port_is_understood_by_its_own_tables() {
    let mut rig = rig(Role::Autopilot);
    rig.silence(Profile::Ecdis, "HTC,");
    rig.run(8.0);
    acn(&mut rig, "10999", "A");
    rig.run(30.0);
    let mut seen = [false; 4];
    for (_, line) in &rig.sent {
        let sentence = nmea::decode(line.as_bytes());
        let views = [
            Alf::from_sentence(&sentence).map(|view| view.line("AG")),
            Alc::from_sentence(&sentence).map(|view| view.line("AG")),
            Arc::from_sentence(&sentence).map(|view| view.line("AG")),
            Hbt::from_sentence(&sentence).map(|view| view.line("AG")),
        ];
        for (seen, view) in seen.iter_mut().zip(views) {
            *seen |= view.is_some();
            assert!(view.is_none_or(|view| view == *line), "{line}");
        }
    }
    assert_eq!(seen, [true; 4]);
}

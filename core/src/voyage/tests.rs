//! The embedded voyage in fast time: situations, cross-track distance, faults, replay.

use super::*;
use crate::autopilot::ModeName;
use crate::command::{FaultKind, Order};
use crate::picture::Picture;
use alloc::format;
use alloc::string::String;
use alloc::vec;
use alloc::vec::Vec;

/// Runs second by second; `see` is asked after each.
fn sail(voyage: &mut Voyage, seconds: u64, mut see: impl FnMut(&Voyage, &[VoyageOutput])) {
    let mut out = Vec::new();
    for _ in 0..seconds {
        out.clear();
        voyage.handle(voyage.now() + 1_000, Event::Tick, &mut out);
        see(voyage, &out);
    }
}

#[test]
fn all_six_situations_follow_each_other_round_after_round() {
    let mut voyage = Voyage::embedded(7);
    let mut seen = Vec::new();
    let mut worst = 0.0_f64;
    let mut log = String::new();
    sail(&mut voyage, 5_400, |voyage, _| {
        let snapshot = crate::view::snapshot(voyage);
        let (own, chart) = (snapshot.own.unwrap(), snapshot.chart.unwrap());
        if seen.last() != Some(&chart.situation) {
            log += &format!(
                "{} s: {} {:?} {} {}\n",
                voyage.now().0 / 1000,
                chart.situation,
                own.mode,
                own.why,
                chart.why
            );
            seen.push(chart.situation);
        }
        if let (ModeName::AutonavTi, Some(xtd)) = (own.mode, own.cross_track) {
            if xtd.abs() > worst {
                log += &format!("{} xtd {xtd}\n", voyage.now().0 / 1000);
            }
            worst = worst.max(xtd.abs());
        }
    });
    let turn = [3, 4, 5];
    let mut expected = vec![1, 2];
    (0..6).for_each(|_| expected.extend(turn));
    expected.extend([6, 1, 2, 3, 4, 5]);
    assert!(seen.starts_with(&expected), "{seen:?}\n{log}");
    assert!(worst < 50.0, "{worst} m\n{log}");
}

// TCS-13: the chart system has stopped; the officer asks it again, and the ship is back under track control.
#[test]
fn the_officer_engages_again_after_a_lost_cable() {
    for kind in [FaultKind::Silent, FaultKind::Cut] {
        let mut voyage = Voyage::embedded(7);
        let following = |voyage: &Voyage| {
            let autopilot = voyage.autopilot().unwrap();
            autopilot.mode().name() == ModeName::AutonavTi
        };
        sail(&mut voyage, 120, |_, _| {});
        assert!(following(&voyage));
        let fault = |voyage: &mut Voyage, on| {
            let fault = Order::Fault {
                cable: "ecdis".into(),
                kind,
                on,
            };
            voyage.conduct(voyage.now(), &fault).unwrap();
        };
        fault(&mut voyage, true);
        sail(&mut voyage, 20, |_, _| {});
        assert!(!following(&voyage));
        assert_eq!(
            voyage.chart.as_ref().unwrap().control_name(),
            "off",
            "{kind:?}"
        );
        fault(&mut voyage, false);
        let mut again = false;
        // The cable is lost in a turn, in which control does not begin.
        sail(&mut voyage, 300, |voyage, _| again |= following(voyage));
        assert!(again, "{kind:?}");
    }
}

/// Who says what and who believes it lays the cables; a recording names ports by their numbers, which follow from it.
#[test]
fn a_cable_lies_where_one_station_says_what_another_believes() {
    let voyage = Voyage::embedded(7);
    let check = |picture: &Picture, expect: &[&str]| {
        let names: Vec<&str> = picture
            .ports
            .iter()
            .map(|port| port.name.as_str())
            .collect();
        assert_eq!(names, expect, "{:?}", picture.station);
    };
    let autopilot = voyage.autopilot().unwrap().picture();
    check(autopilot, &["ecdis", "gyro1", "gps", "log", "gear"]);
    let chart = voyage.chart_system().unwrap().picture();
    check(chart, &["ecdis", "gyro1", "gps", "log"]);
    let world = voyage.world().unwrap().picture();
    check(world, &["gyro1", "gps", "log", "gear"]);
}

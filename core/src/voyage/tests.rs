//! The embedded voyage in fast time: situations, cross-track distance, faults, replay.

use super::*;
use crate::autopilot::ModeName;
use alloc::format;
use alloc::vec;

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

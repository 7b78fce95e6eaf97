//! Indications and alarms before and after wheel-over (TCS-11).

use super::*;
use crate::alerts::State;

// TCS-11
#[test]
fn a_course_change_is_indicated_three_minutes_and_half_a_minute_before_and_alarmed_at_wheel_over() {
    let mut bench = Bench::tracking();
    let mut first = alloc::collections::BTreeMap::new();
    let mut wheel_over = None;
    for _ in 0..600 {
        bench.second();
        if bench.chart.situation() == 3 {
            wheel_over.get_or_insert(bench.now);
        }
        for view in bench.chart.alerts() {
            first
                .entry(view.alert.definition().title)
                .or_insert(bench.now);
        }
        if bench.chart.situation() == 5 {
            break;
        }
    }
    let before = |title: &str| (wheel_over.unwrap() as f64 - first[title] as f64) / 1000.0;
    near(before("COURSE CHANGE"), 180.0, 1.0);
    near(before("WHEEL OVER SOON"), 30.0, 1.0);
    near(before("WHEEL OVER"), 0.0, 0.0);
    near(before("BACKUP NAVIGATOR"), -30.0, 1.0);
    assert!(!first.contains_key("CROSS TRACK"));
}

#[test]
fn a_confirmed_course_change_gives_no_alarm_and_the_ship_turns_all_the_same() {
    let mut bench = Bench::tracking();
    while !bench
        .chart
        .alerts()
        .iter()
        .any(|view| view.alert.number() == 202)
    {
        bench.second();
    }
    bench.order(&Order::Acknowledge(202)).unwrap();
    bench.until(3);
    for _ in 0..40 {
        bench.second();
        assert!(
            bench.chart.alerts().is_empty(),
            "{:?}",
            bench.chart.alerts()
        );
    }
}

#[test]
fn the_last_waypoint_and_the_corridor_have_alerts() {
    let mut bench = Bench::tracking();
    bench.until(5);
    for _ in 0..30 {
        bench.right += 7.0;
        bench.second();
    }
    let alerts = bench.chart.alerts();
    assert!(
        alerts
            .iter()
            .any(|view| view.alert.definition().title == "CROSS TRACK"),
        "{alerts:?}"
    );
    let mut bench = Bench::tracking();
    let mut warned = None;
    while bench.chart.situation() != 6 {
        bench.second();
        if bench
            .chart
            .alerts()
            .iter()
            .any(|view| view.alert.definition().title == "LAST WAYPOINT")
        {
            warned.get_or_insert(bench.now);
        }
    }
    near((bench.now - warned.unwrap()) as f64 / 1000.0, 180.0, 20.0);
}

#[test]
fn what_was_silenced_sounds_again_at_once_when_it_is_asked_to() {
    let mut bench = Bench::tracking();
    bench.until(3);
    while bench.chart.alerts().is_empty() {
        bench.second();
    }
    let state = |bench: &Bench| bench.chart.alerts()[0].state;
    bench.order(&Order::Silence(true)).unwrap();
    assert_eq!(state(&bench), State::Silenced);
    bench.order(&Order::Silence(false)).unwrap();
    assert_eq!(state(&bench), State::Unacknowledged);
}

//! The station by itself: cadence, forwarding distance, storing.

use super::*;

#[test]
fn the_forwarding_distance_is_a_time_of_way() {
    let mut bench = Bench::new();
    bench.second();
    bench.second();
    near(bench.chart.forwarding().m(), 28.0 * STEP_M, 1.0);
}

#[test]
fn sentences_come_once_a_second_and_are_not_made_up_for() {
    let mut bench = Bench::new();
    let mut out = vec![];
    bench.chart.handle(Stamp(0), Input::Tick, &mut out);
    assert_eq!(bench.chart.due(), Stamp(1_000));
    out.clear();
    bench.chart.handle(Stamp(999), Input::Tick, &mut out);
    assert!(out.is_empty());
    bench.chart.handle(Stamp(30_400), Input::Tick, &mut out);
    assert_eq!(
        out.iter()
            .filter(|o| matches!(o, Output::Send { .. }))
            .count(),
        7
    );
    assert_eq!(bench.chart.due(), Stamp(31_000));
}

#[test]
fn a_stored_chart_system_carries_on_as_if_it_had_not_been_stored() {
    let mut bench = Bench::tracking();
    bench.until(3);
    let json = serde_json::to_string(&bench.chart).unwrap();
    let mut other: ChartSystem = serde_json::from_str(&json).unwrap();
    let (mut one, mut two) = (vec![], vec![]);
    let next = bench.chart.due();
    bench.chart.handle(next, Input::Tick, &mut one);
    other.handle(next, Input::Tick, &mut two);
    assert_eq!(one, two);
    assert!(!one.is_empty());
}

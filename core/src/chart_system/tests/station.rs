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

/// TCS-13: bridge alert management is told that somebody operates the chart system, where that is asked for.
#[test]
fn an_officers_order_is_told_by_eve_where_that_is_asked_for() {
    let told = |eve: bool, by: Origin| {
        let mut config = ChartConfig {
            eve,
            ..ChartConfig::default()
        };
        let bams = crate::station::PortSetup {
            name: "bams".into(),
            profile: crate::station::Profile::Bams,
            ..config.ports[ECDIS].clone()
        };
        config.ports.push(bams);
        let mut chart = ChartSystem::new(config);
        let mut out = vec![];
        let order = Order::Chart(ChartRequest::Stop);
        let input = Input::Order { by, order: &order };
        chart.handle(Stamp(0), Input::Tick, &mut vec![]);
        chart.handle(Stamp(500), input, &mut out);
        for second in 1..20 {
            chart.handle(Stamp(second * 1_000), Input::Tick, &mut out);
        }
        let said = out.iter().filter_map(|output| match output {
            Output::Send { port: 4, bytes } => Some(String::from_utf8_lossy(bytes)),
            _ => None,
        });
        said.filter(|line| line.starts_with("$EIEVE,,EI0001,OPERATION*"))
            .count()
    };
    assert_eq!(told(true, Origin::Officer), 1);
    assert_eq!(told(true, Origin::Script), 0);
    assert_eq!(told(false, Origin::Officer), 0);
}

//! Control that the autopilot leaves, or under which it falls silent, is not commanded on (TCS-13).

use super::*;
use crate::alerts::{Alert, State};

fn alert(bench: &Bench) -> Option<State> {
    let mut standing = bench.chart.alerts().iter();
    standing
        .find(|standing| standing.alert == Alert::AutopilotLeft)
        .map(|standing| standing.state)
}

#[test]
fn control_that_the_autopilot_leaves_is_stopped_within_the_second() {
    for mode in [
        SteeringMode::Manual,
        SteeringMode::StandAlone,
        SteeringMode::RudderControl,
    ] {
        for request in [ChartRequest::Track, ChartRequest::Heading] {
            let mut bench = Bench::new();
            bench.second();
            bench.request(request).unwrap();
            bench.steering = match request {
                ChartRequest::Heading => SteeringMode::HeadingControl,
                _ => SteeringMode::TrackControl,
            };
            for _ in 0..10 {
                bench.second();
            }
            assert_eq!(alert(&bench), None);
            bench.steering = mode;
            let said = bench.second();
            assert_eq!(said.htc.steering_mode, Some(SteeringMode::StandAlone));
            assert_eq!(alert(&bench), Some(State::Unacknowledged), "{mode:?}");
            assert!(bench.chart.reason().contains("has left it"));
        }
    }
}

#[test]
fn a_silent_autopilot_is_noticed_after_five_seconds() {
    let mut bench = Bench::tracking();
    bench.second();
    let last = bench.now - 500;
    let mut out = vec![];
    for now in (bench.now..last + 5_000).step_by(10) {
        bench.chart.handle(Stamp(now), Input::Tick, &mut out);
        assert_eq!(alert(&bench), None, "{now}");
    }
    assert_eq!(bench.chart.due(), Stamp(last + 5_000));
    bench
        .chart
        .handle(Stamp(last + 5_000), Input::Tick, &mut out);
    assert_eq!(bench.chart.control_name(), "off");
    assert_eq!(alert(&bench), Some(State::Unacknowledged));
    assert!(bench.chart.reason().contains("is silent"));
}

#[test]
fn control_is_offered_as_long_as_the_autopilot_has_not_followed() {
    let mut bench = Bench::new();
    bench.second();
    // What HTD said before control began is not following.
    bench.steering = SteeringMode::TrackControl;
    bench.second();
    bench.request(ChartRequest::Track).unwrap();
    bench.steering = SteeringMode::StandAlone;
    for _ in 0..60 {
        let said = bench.second();
        assert_eq!(said.htc.steering_mode, Some(SteeringMode::TrackControl));
    }
    assert_eq!(alert(&bench), None);
}

#[test]
fn a_change_of_control_keeps_what_the_autopilot_follows() {
    let mut bench = Bench::tracking();
    bench.second();
    bench.request(ChartRequest::Heading).unwrap();
    bench.second();
    assert_eq!(bench.chart.control_name(), "heading");
    bench.steering = SteeringMode::Manual;
    bench.second();
    assert_eq!(bench.chart.control_name(), "off");
    assert_eq!(alert(&bench), Some(State::Unacknowledged));
}

#[test]
fn the_alarm_ends_when_it_is_taken_and_when_control_begins_anew() {
    let left = || {
        let mut bench = Bench::tracking();
        bench.second();
        bench.steering = SteeringMode::StandAlone;
        bench.second();
        bench
    };
    let mut bench = left();
    bench.order(&Order::Acknowledge(208)).unwrap();
    assert_eq!(alert(&bench), None);
    let mut bench = left();
    bench.request(ChartRequest::Track).unwrap();
    assert_eq!(alert(&bench), Some(State::RectifiedUnacknowledged));
    bench.order(&Order::Acknowledge(208)).unwrap();
    for _ in 0..10 {
        bench.second();
    }
    assert_eq!(bench.chart.control_name(), "track");
    assert_eq!(alert(&bench), None);
}

#[test]
fn the_officers_stop_is_no_alarm() {
    let mut bench = Bench::tracking();
    bench.second();
    bench.request(ChartRequest::Stop).unwrap();
    bench.steering = SteeringMode::StandAlone;
    bench.second();
    assert_eq!(alert(&bench), None);
}

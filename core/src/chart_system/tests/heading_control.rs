//! Remote heading control, "Tn" (TCS-6, TCS-12).

use super::*;

// TCS-12
#[test]
fn in_tn_headings_are_commanded_on_legs_and_rates_in_turns() {
    let mut bench = Bench::new();
    bench.right = 40.0;
    bench.second();
    bench.request(ChartRequest::Heading).unwrap();
    bench.steering = SteeringMode::HeadingControl;
    let said = bench.second();
    assert_eq!(bench.chart.situation(), 0);
    assert_eq!(said.htc.steering_mode, Some(SteeringMode::HeadingControl));
    assert_eq!(said.htc.turn_mode, Some(TurnMode::NotControlled));
    assert_eq!((said.htc.radius, said.htc.rate_of_turn), (None, None));
    near(said.htc.track.unwrap(), 245.0, 0.01);
    // 40 m to the right: steer to port of the track by atan(40 m / 60 s way).
    near(said.htc.heading_to_steer.unwrap(), 245.0 - 4.9, 0.2);
    bench.right = 0.0;
    let mut turning = Said::default();
    let mut turns = 0;
    for _ in 0..3_000 {
        let said = bench.second();
        if said.htc.turn_mode == Some(TurnMode::Rate) {
            turns += 1;
            assert_eq!(said.htc.heading_to_steer, said.htc.track);
            assert_eq!((said.htc.radius, said.pney2.centre), (None, None));
            turning = said;
        } else if turns > 0 {
            break;
        }
    }
    near(turning.htc.track.unwrap(), 280.0, 0.01);
    near(
        turning.htc.rate_of_turn.unwrap(),
        0.9549 * SPEED_KN / 0.35,
        0.1,
    );
    // 26 s before the arc and the arc itself.
    let turn = &route().turns()[0].clone();
    near(f64::from(turns), 26.0 + turn.length().m() / STEP_M, 1.5);
}

// TCS-6, AP-6
#[test]
fn ti_and_tn_are_switched_without_a_stop_but_not_into_ti_in_a_turn() {
    let mut bench = Bench::tracking();
    bench.second();
    bench.request(ChartRequest::Heading).unwrap();
    assert_eq!(
        bench.second().htc.steering_mode,
        Some(SteeringMode::HeadingControl)
    );
    bench.request(ChartRequest::Track).unwrap();
    bench.until(4);
    bench.request(ChartRequest::Heading).unwrap();
    assert_eq!(bench.second().htc.turn_mode, Some(TurnMode::Rate));
    assert_eq!(
        bench.request(ChartRequest::Track).unwrap_err(),
        "not in the middle of a turn"
    );
    bench.request(ChartRequest::Stop).unwrap();
    assert_eq!(
        bench.request(ChartRequest::Track).unwrap_err(),
        "not in the middle of a turn"
    );
    assert_eq!(
        bench.second().htc.steering_mode,
        Some(SteeringMode::StandAlone)
    );
}

// TCS-12: a virtual leg
#[test]
fn without_a_route_tn_keeps_the_heading() {
    let mut bench = Bench::new();
    bench.chart.unload();
    bench.second();
    bench.request(ChartRequest::Heading).unwrap();
    let said = bench.second();
    assert_eq!(said.htc.turn_mode, Some(TurnMode::NotControlled));
    assert_eq!(said.htc.heading_to_steer, said.htc.track);
    near(said.htc.track.unwrap(), 245.0, 0.05);
    assert_eq!(said.xte.cross_track, None);
}

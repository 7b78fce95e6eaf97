//! Lost, old, jumping positions, and what control needs (TCS-3, FA9).

use super::*;

// TCS-3
#[test]
fn a_position_that_is_not_valid_ends_track_control_at_once() {
    let mut bench = Bench::tracking();
    let before = bench.second();
    bench.gps_mode = ModeIndicator::NotValid;
    let said = bench.second();
    assert_eq!(said.htc.steering_mode, Some(SteeringMode::StandAlone));
    for (status, mode) in [
        (said.gll.status, said.gll.mode),
        (said.xte.status, said.xte.mode),
        (said.pney1.status, said.pney1.mode),
        (Some(DataStatus::Invalid), said.vtg.mode),
    ] {
        assert_eq!(
            (status, mode),
            (Some(DataStatus::Invalid), Some(ModeIndicator::NotValid))
        );
    }
    // The magnitude stays (note 3.2): null would say that the route has ended (TCS-10).
    assert_eq!(said.xte.cross_track, before.xte.cross_track);
    assert_eq!(said.gll.position, None);
    assert_eq!(
        bench.request(ChartRequest::Track).unwrap_err(),
        "no position"
    );
    assert_eq!(
        bench.chart.alerts()[0].alert.definition().title,
        "NO POSITION"
    );
    bench.gps_mode = ModeIndicator::Autonomous;
    bench.second();
    let said = bench.second();
    assert_eq!(said.xte.status, Some(DataStatus::Valid));
    assert_eq!(
        bench.chart.situation(),
        1,
        "control does not come back by itself"
    );
}

#[test]
fn a_silent_receiver_is_bridged_by_dead_reckoning_for_five_seconds_at_most() {
    let mut bench = Bench::tracking();
    let mut last = bench.second();
    bench.gps = false;
    for second in 1..=4 {
        let said = bench.second();
        let (from, to) = (last.gll.position.unwrap(), said.gll.position.unwrap());
        near(rhumb::between(from, to).1.m(), STEP_M, 0.3);
        assert_eq!(bench.chart.situation(), 2, "{second}");
        last = said;
    }
    bench.second();
    let said = bench.second();
    assert_eq!(said.gll.status, Some(DataStatus::Invalid));
    assert_eq!(said.htc.steering_mode, Some(SteeringMode::StandAlone));
    assert_eq!(bench.chart.reason(), "control ended: no position");
}

// FA9
#[test]
fn a_position_jump_is_not_followed() {
    let mut bench = Bench::tracking();
    bench.second();
    bench.right = 380.0;
    let said = bench.second();
    near(metres(said.xte.cross_track), 10.0, 1.0);
    bench.right = 10.0;
    bench.second();
    assert_eq!(bench.chart.situation(), 2);
    bench.right = 380.0;
    for _ in 0..3 {
        bench.second();
    }
    assert_eq!(
        bench.chart.reason(),
        "control ended: the position has jumped"
    );
}

#[test]
fn what_track_control_needs_is_named_when_it_is_missing() {
    let mut bench = Bench::new();
    assert_eq!(
        bench.request(ChartRequest::Track).unwrap_err(),
        "no position"
    );
    assert_eq!(
        bench.request(ChartRequest::Heading).unwrap_err(),
        "no heading"
    );
    bench.right = 1_000.0;
    bench.second();
    assert_eq!(
        bench.request(ChartRequest::Track).unwrap_err(),
        "too far from the track: 0.54 nm"
    );
    let mut bench = Bench::new();
    let line = route().turns()[0].tangent().m() + 28.0 * STEP_M;
    bench.run = route().leg(0).length().m() - line - 10.0 * STEP_M;
    bench.second();
    assert_eq!(
        bench.request(ChartRequest::Track).unwrap_err(),
        "too close to the wheel-over line"
    );
    assert_eq!(
        bench.chart.reason(),
        "refused: too close to the wheel-over line"
    );
}

#[test]
fn damaged_lines_are_not_believed() {
    let mut bench = Bench::tracking();
    bench.second();
    let mut out = vec![];
    for line in [
        "$GPGLL,5345.345,N,01230.635,W,123423,A,A*00",
        "$GPGLL,,,,,,V,N",
    ] {
        bench.hear(GPS, line, &mut out);
    }
    bench.second();
    assert_eq!(bench.chart.situation(), 2);
}

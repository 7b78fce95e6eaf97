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

impl Bench {
    /// Under track control, with dead reckoning where it is set; the receiver falls silent.
    fn without_position(dead_reckoning: bool) -> Self {
        let mut bench = Self::tracking();
        bench.chart.config.dead_reckoning = dead_reckoning;
        bench.second();
        bench.gps = false;
        bench
    }
}

/// TCS-14: control goes on by dead reckoning, marked as estimated, and the helm is called for each two minutes.
#[test]
fn where_it_is_set_control_goes_on_by_dead_reckoning_and_says_so() {
    let mut bench = Bench::without_position(true);
    let (mut calls, mut before) = (0, None);
    for second in 1..=250 {
        let said = bench.second();
        assert_ne!(bench.chart.situation(), 1, "{second}");
        if second > 6 {
            let mode = Some(ModeIndicator::Estimated);
            assert_eq!([said.gll.mode, said.xte.mode, said.pney1.mode], [mode; 3]);
            assert_eq!(said.xte.status, Some(DataStatus::Valid));
            let (there, _) = bench.place();
            let off = rhumb::between(there, said.gll.position.unwrap()).1.m();
            let two_sigma = bench.chart.adrift().unwrap().1.m();
            assert!(
                off < 30.0 && (20.0..185.2).contains(&two_sigma),
                "{second}: {off}"
            );
        }
        let raised = (bench.chart.alerts().iter())
            .find(|standing| standing.alert == crate::alerts::Alert::ManualSteering)
            .map(|standing| standing.at);
        calls += u32::from(raised.is_some() && raised != before);
        before = raised;
    }
    assert_eq!(calls, 3, "raised, and anew after two and four minutes");
}

/// TCS-14: at the latest when two sigma exceed the corridor, control ends; without the setting after five seconds (TCS-3).
#[test]
fn dead_reckoning_ends_by_itself_and_is_off_unless_it_is_set() {
    let ends = |dead_reckoning| {
        let mut bench = Bench::without_position(dead_reckoning);
        let ended =
            (1..=700).find(|_| bench.second().htc.steering_mode == Some(SteeringMode::StandAlone));
        (ended.unwrap(), bench.chart.reason())
    };
    let (seconds, why) = ends(true);
    // The corridor of these legs is 185 m.
    assert!((250..400).contains(&seconds), "{seconds}");
    assert!(why.contains("more than the corridor"), "{why}");
    assert_eq!(ends(false), (5, "control ended: no position".into()));
}

/// TCS-14: a position that comes back far from what was reckoned ends control.
#[test]
fn a_position_that_is_back_elsewhere_ends_control_and_one_at_hand_does_not() {
    for (right, goes_on) in [(15.0, true), (400.0, false)] {
        let mut bench = Bench::without_position(true);
        for _ in 0..60 {
            bench.second();
        }
        bench.right = right;
        bench.gps = true;
        bench.second();
        let said = bench.second();
        let controls = said.htc.steering_mode == Some(SteeringMode::TrackControl);
        assert_eq!(controls, goes_on, "{}", bench.chart.reason());
        assert_eq!(bench.chart.adrift(), None);
        let alerts = &bench.chart.watch.alerts;
        assert!(!alerts.raised(crate::alerts::Alert::ManualSteering));
    }
}

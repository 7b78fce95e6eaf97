//! A test a row of the situation table (TCS-1, TCS-2).

use super::*;

#[test]
fn situation_1_with_a_route() {
    let mut bench = Bench::new();
    bench.second();
    let said = bench.second();
    assert_eq!(bench.chart.situation(), 1);
    assert_eq!(
        said.formatters,
        ["HTC", "XTE", "PNEY,001", "PNEY,002", "GLL", "VTG", "VHW"]
    );
    assert_eq!(said.htc.steering_mode, Some(SteeringMode::StandAlone));
    assert_eq!(said.htc.turn_mode, Some(TurnMode::NotControlled));
    assert_eq!((said.htc.radius, said.htc.track), (None, None));
    near(metres(said.xte.cross_track), 10.0, 0.2);
    assert_eq!(said.pney1.cross_track, said.xte.cross_track);
    assert_eq!((said.pney2.centre, Bench::waypoint(&said)), (None, "001"));
    assert_eq!(said.gll.mode, Some(ModeIndicator::Differential));
    near(said.vtg.course_true.unwrap(), 245.0, 0.05);
    near(said.vhw.speed_kmh.unwrap(), 27.8, 0.05);
}

// TCS-2
#[test]
fn situation_1_without_a_route_has_no_cross_track_distance() {
    let mut bench = Bench::new();
    bench.chart.unload();
    bench.second();
    let said = bench.second();
    assert_eq!(bench.chart.situation(), 1);
    assert_eq!((said.xte.cross_track, said.pney1.cross_track), (None, None));
    assert_eq!(said.xte.status, Some(DataStatus::Valid));
    assert_eq!(said.pney2, Pney2::default());
    assert_eq!(bench.request(ChartRequest::Track).unwrap_err(), "no route");
}

#[test]
fn situation_2_active_on_the_first_leg() {
    let mut bench = Bench::tracking();
    let said = bench.second();
    assert_eq!(bench.chart.situation(), 2);
    assert_eq!(said.htc.steering_mode, Some(SteeringMode::TrackControl));
    assert_eq!(said.htc.turn_mode, Some(TurnMode::Radius));
    assert_eq!((said.htc.radius, said.htc.heading_to_steer), (None, None));
    near(said.htc.track.unwrap(), 245.0, 0.01);
    near(metres(said.xte.cross_track), 10.0, 0.2);
    assert_eq!(said.pney1.cross_track, said.xte.cross_track);
    assert_eq!((said.pney2.centre, Bench::waypoint(&said)), (None, "001"));
    assert_eq!(
        bench.chart.reason(),
        "the autopilot follows in track control"
    );
}

#[test]
fn situation_3_on_the_forwarding_distance() {
    let mut bench = Bench::tracking();
    let said = bench.until(3);
    let turn = &route().turns()[0].clone();
    near(said.htc.radius.unwrap(), 0.35, 1e-9);
    near(said.htc.track.unwrap(), 280.0, 0.01); // the next leg
    near(metres(said.xte.cross_track), 10.0, 0.5);
    assert_eq!(said.pney1.cross_track, said.xte.cross_track); // both to the current leg
    let centre = said.pney2.centre.unwrap();
    near(rhumb::between(centre, turn.centre()).1.m(), 0.0, 0.1);
    assert_eq!(Bench::waypoint(&said), "001"); // of this turn
    // The line was crossed within the last second.
    let to_arc = route().leg(0).length().m() - turn.tangent().m() - bench.run;
    let forwarding = 28.0 * STEP_M;
    assert!(
        to_arc <= forwarding && to_arc > forwarding - STEP_M - 0.5,
        "{to_arc}"
    );
}

#[test]
fn situation_4_on_the_radius() {
    let mut bench = Bench::tracking();
    bench.until(4);
    let said = bench.second();
    near(said.htc.radius.unwrap(), 0.35, 1e-9);
    near(said.htc.track.unwrap(), 280.0, 0.01);
    near(metres(said.xte.cross_track), 10.0, 0.5); // to the arc
    // To the next leg: on its right (the source prints L), R (1 - cos of what remains), with the 10 m to the right.
    let next_leg = metres(said.pney1.cross_track);
    let turn = &route().turns()[0].clone();
    let swept = (bench.run - route().leg(0).length().m() + turn.tangent().m()) / turn.radius().m();
    let expected = 648.2 - (648.2 - 10.0) * (35.0_f64.to_radians() - swept).cos();
    near(next_leg, expected, 2.5);
    assert!(said.pney2.centre.is_some());
    assert_eq!(Bench::waypoint(&said), "001");
}

#[test]
fn situation_5_after_the_turn() {
    let mut bench = Bench::tracking();
    bench.until(4);
    let said = bench.until(5);
    assert_eq!(
        (said.htc.radius, said.htc.turn_mode),
        (None, Some(TurnMode::Radius))
    );
    near(said.htc.track.unwrap(), 280.0, 0.01);
    near(metres(said.xte.cross_track), 10.0, 0.7);
    assert_eq!(said.pney1.cross_track, said.xte.cross_track);
    assert_eq!(
        (said.pney2.centre, Bench::waypoint(&said)),
        (None, "HAMBURG")
    ); // TCS-5
    let past_arc =
        route().leg(1).along(said.gll.position.unwrap()).m() - route().turns()[0].tangent().m();
    assert!((0.0..STEP_M + 1.0).contains(&past_arc), "{past_arc}");
}

#[test]
fn situation_6_at_the_end_of_the_route_until_it_is_loaded_again() {
    let mut bench = Bench::tracking();
    let said = bench.until(6);
    assert_eq!(said.htc.steering_mode, Some(SteeringMode::StandAlone));
    assert_eq!(said.htc.turn_mode, Some(TurnMode::NotControlled));
    assert_eq!((said.xte.cross_track, said.pney1.cross_track), (None, None));
    assert_eq!(said.xte.status, Some(DataStatus::Valid));
    assert_eq!(said.pney2, Pney2::default());
    assert_eq!(bench.chart.reason(), "control ended: end of route");
    assert_eq!(
        bench.request(ChartRequest::Track).unwrap_err(),
        "the last waypoint is passed"
    );
    bench.second();
    assert_eq!(bench.chart.situation(), 6);
    bench.chart.load(route());
    bench.run = 200.0;
    bench
        .chart
        .handle(Stamp(bench.now), Input::Stalled { ms: 5_000 }, &mut vec![]);
    bench.second();
    assert_eq!(bench.chart.situation(), 1);
}

#[test]
fn the_six_situations_come_in_order() {
    let mut bench = Bench::new();
    bench.second();
    let mut seen = vec![bench.chart.situation()];
    bench.request(ChartRequest::Track).unwrap();
    while *seen.last().unwrap() != 6 {
        bench.second();
        if seen.last() != Some(&bench.chart.situation()) {
            seen.push(bench.chart.situation());
        }
        assert!(seen.len() < 12, "{seen:?}");
    }
    assert_eq!(seen, [1, 2, 3, 4, 5, 3, 4, 5, 6]);
}

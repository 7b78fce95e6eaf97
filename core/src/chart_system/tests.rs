//! The chart system fed with bytes of a ship that is moved along its route: a test a row of the situation table.

use super::*;
use crate::geo::{Position, rhumb};
use crate::nmea::{
    self, DataStatus, Gll, Hdt, Htc, Htd, ModeIndicator, Pney1, Pney2, SteeringMode, TurnMode,
    UtcTime, Vhw, Vtg, Xte,
};
use crate::route::{RouteLimits, Waypoint};
use crate::stream::ChartRequest;
use crate::units::{Course, Radius};
use alloc::vec;

const SPEED_KN: f64 = 15.0;
const STEP_M: f64 = SPEED_KN * 1852.0 / 3600.0;
const ECDIS: usize = 0;
const GPS: usize = 1;
const GYRO: usize = 2;
const LOG: usize = 3;

/// 245.0, then 35 degrees to starboard with the source's 0.35 nm, then 50 degrees to port.
fn route() -> Route {
    let mut place = Position {
        lat: 53.75,
        lon: 6.5,
    };
    let mut waypoints = vec![Waypoint::new("000", place, None)];
    for (id, course, miles, radius) in [
        ("001", 245.0, 2.0, Some(0.35)),
        ("HAMBURG", 280.0, 2.0, Some(0.6)),
        ("003", 230.0, 1.5, None),
    ] {
        place = rhumb::destination(place, Course::from_deg(course), Distance::from_nm(miles));
        waypoints.push(Waypoint::new(id, place, radius.map(Radius::from_nm)));
    }
    Route::new("test", waypoints, RouteLimits::default()).unwrap()
}

/// What was said in one second.
#[derive(Debug, Default)]
struct Said {
    formatters: Vec<String>,
    htc: Htc,
    xte: Xte,
    pney1: Pney1,
    pney2: Pney2,
    gll: Gll,
    vtg: Vtg,
    vhw: Vhw,
}

struct Bench {
    chart: ChartSystem,
    now: u64,
    /// Distance run along the track, and the ship's distance to the right of it.
    run: f64,
    right: f64,
    gps: bool,
    gps_mode: ModeIndicator,
    steering: SteeringMode,
}

impl Bench {
    fn new() -> Self {
        let config = ChartConfig {
            route: Some(route()),
            ..ChartConfig::default()
        };
        let mut chart = ChartSystem::new(config);
        chart.handle(Stamp(0), Input::Tick, &mut vec![]);
        Self {
            chart,
            now: 0,
            run: 200.0,
            right: 10.0,
            gps: true,
            gps_mode: ModeIndicator::Differential,
            steering: SteeringMode::StandAlone,
        }
    }

    /// Place and course on the track after a run of so many metres.
    fn place(&self) -> (Position, Course) {
        let route = route();
        let mut left = self.run;
        for (index, leg) in route.legs().iter().enumerate() {
            let from = index
                .checked_sub(1)
                .map_or(0.0, |k| route.turns()[k].tangent().m());
            let turn = route.turn_after(index);
            let straight = leg.length().m() - from - turn.map_or(0.0, |turn| turn.tangent().m());
            let Some(turn) = turn.filter(|_| left > straight) else {
                if turn.is_some() || index + 1 == route.legs().len() {
                    return (leg.at(Distance::from_m(from + left)), leg.course());
                }
                continue;
            };
            left -= straight;
            if left <= turn.length().m() {
                let swept = left / turn.length().m() * turn.angle().deg();
                return (
                    turn.at(Distance::from_m(left)),
                    Course::from_deg(leg.course().deg() + swept),
                );
            }
            left -= turn.length().m();
        }
        unreachable!()
    }

    fn hear(&mut self, port: usize, line: &str, out: &mut Vec<Output>) {
        let bytes = alloc::format!("{line}\r\n").into_bytes();
        self.chart.handle(
            Stamp(self.now),
            Input::Bytes {
                port,
                bytes: &bytes,
            },
            out,
        );
    }

    /// One second: the sensors speak, then the chart system.
    fn second(&mut self) -> Said {
        self.now += 500;
        self.run += STEP_M / 2.0;
        let (place, course) = self.place();
        let right = Course::from_deg(course.deg() + 90.0);
        let place = rhumb::destination(place, right, Distance::from_m(self.right));
        let mut out = vec![];
        if self.gps {
            let valid = self.gps_mode.valid();
            let gll = Gll {
                position: valid.then_some(place),
                time: Some(UtcTime::from_seconds(self.now as f64 / 1000.0)),
                status: Some(if valid {
                    DataStatus::Valid
                } else {
                    DataStatus::Invalid
                }),
                mode: Some(self.gps_mode),
            };
            let vtg = Vtg {
                course_true: Some(course.deg()),
                speed_knots: Some(SPEED_KN),
                mode: Some(self.gps_mode),
                ..Vtg::default()
            };
            self.hear(GPS, &gll.line("GP"), &mut out);
            self.hear(GPS, &vtg.line("GP"), &mut out);
        }
        self.hear(
            GYRO,
            &Hdt {
                heading: Some(course.deg()),
            }
            .line("HE"),
            &mut out,
        );
        let vhw = Vhw {
            speed_knots: Some(SPEED_KN),
            ..Vhw::default()
        };
        self.hear(LOG, &vhw.line("VD"), &mut out);
        let htd = Htd {
            steering_mode: Some(self.steering),
            ..Htd::default()
        };
        self.hear(ECDIS, &htd.line("AG"), &mut out);
        self.now += 500;
        self.run += STEP_M / 2.0;
        self.chart.handle(Stamp(self.now), Input::Tick, &mut out);
        self.said(&out)
    }

    fn said(&self, out: &[Output]) -> Said {
        let mut said = Said::default();
        for output in out {
            let Output::Send { port, bytes } = output else {
                continue;
            };
            assert_eq!(*port, ECDIS);
            assert!(bytes.len() <= 82, "{}", String::from_utf8_lossy(bytes));
            let line = bytes.strip_suffix(b"\r\n").unwrap();
            let sentence = nmea::decode(line);
            assert!(
                sentence.checksum.is_right() && sentence.faults().is_empty(),
                "{sentence:?}"
            );
            said.formatters.push(sentence.formatter.into());
            if let Some(view) = Htc::from_sentence(&sentence) {
                said.htc = view;
            } else if let Some(view) = Xte::from_sentence(&sentence) {
                said.xte = view;
            } else if let Some(view) = Pney1::from_sentence(&sentence) {
                said.pney1 = view;
            } else if let Some(view) = Pney2::from_sentence(&sentence) {
                said.pney2 = view;
            } else if let Some(view) = Gll::from_sentence(&sentence) {
                said.gll = view;
            } else if let Some(view) = Vtg::from_sentence(&sentence) {
                said.vtg = view;
            } else if let Some(view) = Vhw::from_sentence(&sentence) {
                said.vhw = view;
            }
        }
        said
    }

    fn request(&mut self, request: ChartRequest) -> Result<String, String> {
        self.chart
            .command(Stamp(self.now), &request)
            .map_err(|refusal| refusal.0)
    }

    /// Runs until the situation is reached and gives what was said first in it.
    fn until(&mut self, situation: u8) -> Said {
        for _ in 0..3_000 {
            let said = self.second();
            if self.chart.situation() == situation {
                return said;
            }
        }
        panic!("situation {situation} was not reached");
    }

    fn tracking() -> Self {
        let mut bench = Self::new();
        bench.second();
        bench.request(ChartRequest::Track).unwrap();
        bench.steering = SteeringMode::TrackControl;
        bench
    }

    fn waypoint(said: &Said) -> &str {
        said.pney2.waypoint.as_deref().unwrap_or("")
    }
}

fn metres(nm: Option<f64>) -> f64 {
    nm.unwrap() * 1852.0
}

fn near(a: f64, b: f64, within: f64) {
    assert!((a - b).abs() <= within, "{a} is not {b}");
}

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
        bench.chart.own().why,
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
    assert_eq!(bench.chart.own().why, "control ended: end of route");
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
    // 12 s before the arc and the arc itself.
    let turn = &route().turns()[0].clone();
    near(f64::from(turns), 12.0 + turn.length().m() / STEP_M, 1.5);
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
    assert_eq!(bench.chart.alerts()[0].title, "NO POSITION");
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
    assert_eq!(bench.chart.own().why, "control ended: no position");
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
        bench.chart.own().why,
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
        bench.chart.own().why,
        "refused: too close to the wheel-over line"
    );
}

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
            first.entry(view.title).or_insert(bench.now);
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
    while !bench.chart.alerts().iter().any(|view| view.number == 202) {
        bench.second();
    }
    assert!(bench.chart.acknowledge(Stamp(bench.now), 202));
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
        alerts.iter().any(|view| view.title == "CROSS TRACK"),
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
            .any(|view| view.title == "LAST WAYPOINT")
        {
            warned.get_or_insert(bench.now);
        }
    }
    near((bench.now - warned.unwrap()) as f64 / 1000.0, 180.0, 20.0);
}

#[test]
fn the_forwarding_distance_is_a_time_of_way() {
    let mut bench = Bench::new();
    bench.second();
    bench.second();
    let document = bench.chart.document();
    near(document.turns[0].forwarding_m, 28.0 * STEP_M, 1.0);
    assert_eq!(document.revision, bench.chart.revision());
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

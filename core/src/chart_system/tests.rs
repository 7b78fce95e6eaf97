//! The chart system fed with the bytes of a ship that is moved along its route.

mod dialogue;
mod followed;
mod heading_control;
mod indications;
mod offered;
mod position;
mod situations;
mod station;

use super::*;
use crate::command::{ChartRequest, Order, Origin};
use crate::geo::{Position, rhumb};
use crate::nmea::{
    self, DataStatus, Gll, Hdt, Htc, Htd, ModeIndicator, Pney1, Pney2, SteeringMode, TurnMode,
    UtcTime, Vhw, Vtg, Xte,
};
use crate::route::{Route, RouteLimits, Waypoint};
use crate::station::{Input, Output};
use crate::time::Stamp;
use crate::units::{Course, Distance, Radius};
use alloc::string::String;
use alloc::vec;
use alloc::vec::Vec;

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
    lines: Vec<String>,
    htc: Htc,
    xte: Xte,
    pney1: Pney1,
    pney2: Pney2,
    gll: Gll,
    vtg: Vtg,
    vhw: Vhw,
}

pub(crate) struct Bench {
    route: Route,
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
    pub(crate) fn new() -> Self {
        let config = ChartConfig {
            route: Some(route()),
            ..ChartConfig::default()
        };
        let mut chart = ChartSystem::new(config);
        chart.handle(Stamp(0), Input::Tick, &mut vec![]);
        Self {
            route: route(),
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
        let route = &self.route;
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
            said.lines.push(String::from_utf8_lossy(line).into_owned());
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
        self.order(&Order::Chart(request))
    }

    fn order(&mut self, order: &Order) -> Result<String, String> {
        let by = Origin::Officer;
        let mut out = Vec::new();
        self.chart
            .handle(Stamp(self.now), Input::Order { by, order }, &mut out);
        match out.pop() {
            Some(Output::Answer(answer)) => answer.map_err(|refusal| refusal.text),
            _ => panic!("every order is answered"),
        }
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

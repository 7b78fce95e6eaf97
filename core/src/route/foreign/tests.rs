//! Sentences of a chart system that sails a known turn: what is told is that turn, and no more than was said.

use super::*;
use crate::nmea::{decode, with_checksum};
use crate::station::{ChecksumPolicy, Direction, PortSetup, Profile, Role};
use alloc::format;
use alloc::string::String;
use alloc::vec::Vec;

const ORIGIN: Position = Position {
    lat: 54.5,
    lon: 11.2,
};

/// Northbound, then a turn of half a mile's radius to starboard onto 070.
fn turn() -> Path {
    let centre = Point {
        north: 2_000.0,
        east: 926.0,
    };
    let course = Course::from_deg;
    Path::turn(course(0.0), centre, Radius::from_nm(0.5), course(70.0))
}

struct Bridge {
    picture: Picture,
    before: Before,
    now: Stamp,
}

impl Bridge {
    fn new() -> Self {
        let port = |name: &str| PortSetup {
            name: name.into(),
            profile: Profile::Ecdis,
            checksum: ChecksumPolicy::Required,
            talkers: Vec::new(),
            baud: 4_800,
            output: true,
        };
        Self {
            picture: Picture::new(Role::Autopilot, alloc::vec![port("ecdis"), port("second")]),
            before: Before::default(),
            now: Stamp(10_000),
        }
    }

    fn hear(&mut self, port: PortIndex, bodies: &[String]) {
        for body in bodies {
            let line = with_checksum(body);
            let sentence = decode(line.as_bytes());
            self.picture
                .fold_sentence(self.now, port, Direction::In, &sentence);
            self.before.hear(self.now, port, &sentence);
        }
    }

    /// A second passes in which the chart system sees the ship there.
    fn second(&mut self, situation: u8, ship: Point) -> Told {
        self.now = self.now + 1_000;
        self.hear(0, &said(situation, ship, &turn()));
        self.told()
    }

    fn told(&self) -> Told {
        Told::of(&self.picture, &self.before, self.now, &Plane::at(ORIGIN))
    }
}

fn place(point: Point) -> String {
    let position = Plane::at(ORIGIN).position(point);
    let part = |value: f64, width: usize| {
        let degrees = libm::floor(value);
        format!("{degrees:0width$}{:07.4}", (value - degrees) * 60.0)
    };
    format!("{},N,{},E", part(position.lat, 2), part(position.lon, 3))
}

/// What a chart system says in a situation (interface.md section 4).
fn said(situation: u8, ship: Point, path: &Path) -> Vec<String> {
    let (leg_in, out) = (Path::leg(path.point, path.course_in), path.leg_out());
    let off = |leg: &Path| leg.progress(ship).cross_track;
    let (display, control, track) = match situation {
        2 | 3 => (off(&leg_in), off(&leg_in), path.course_in),
        4 => (path.progress(ship).cross_track, off(&out), out.course_in),
        _ => (off(&out), off(&out), out.course_in),
    };
    let track = if situation == 3 { out.course_in } else { track };
    let turning = matches!(situation, 3 | 4);
    let side = |metres: f64| {
        let letter = if metres > 0.0 { 'L' } else { 'R' };
        format!("{:.4},{letter},N,A", libm::fabs(metres) / 1852.0)
    };
    let (radius, centre) = match path.turn.filter(|_| turning) {
        Some(arc) => (format!("{:.3}", arc.radius.nm()), place(arc.centre)),
        None => (String::new(), ",,,".into()),
    };
    alloc::vec![
        format!("EIHTC,V,,,T,R,,,{radius},,,0.10,{:05.1},T,C", track.deg()),
        format!("EIXTE,A,A,{}", side(display)),
        format!("PNEY,001,A,A,{}", side(control)),
        format!("PNEY,002,{centre},WP7"),
        format!("EIGLL,{},101010.00,A,A", place(ship)),
    ]
}

/// A ship a little to starboard of the path.
fn at(along: f64) -> Point {
    turn().at(along, 15.0)
}

fn near(told: Point, truth: Point, metres: f64) {
    assert!(told.distance(truth) < metres, "{told:?} is not {truth:?}");
}

#[test]
fn a_leg_is_told_by_its_track_and_the_distance_from_it() {
    let mut bridge = Bridge::new();
    let told = bridge.second(2, at(-2_500.0));
    let leg = told.leg.unwrap();
    assert_eq!((told.situation, leg.course_in.deg()), (Some(2), 0.0));
    near(leg.point, turn().at(-2_500.0, 0.0), 0.5);
    assert_eq!(told.limit.map(|limit| limit.nm()), Some(0.1));
    // The place of the waypoint, the next leg and the wheel-over line are not known.
    assert_eq!(
        (told.turn, told.next_track, told.wheel_over),
        (None, None, None)
    );
}

#[test]
fn a_turn_is_told_from_its_wheel_over_to_its_end() {
    let mut bridge = Bridge::new();
    bridge.second(2, at(-410.0));
    bridge.second(2, at(-400.0));
    for along in [-390.0, -200.0, -5.0] {
        let told = bridge.second(3, at(along));
        assert_eq!((told.situation, told.whole), (Some(3), true), "{along}");
        let path = told.turn.unwrap();
        near(path.start(), turn().start(), 1.0);
        near(path.leg_out().point, turn().leg_out().point, 1.0);
        near(told.leg.unwrap().point, turn().at(along, 0.0), 0.5);
        assert_eq!(told.next_track.map(|track| track.deg()), Some(70.0));
        // The radius came before the position of its second.
        near(told.wheel_over.unwrap().1, turn().at(-400.0, 0.0), 1.0);
    }
    let end = turn().arc_length();
    for along in [5.0, 300.0, end - 5.0] {
        let told = bridge.second(4, at(along));
        assert_eq!((told.situation, told.leg), (Some(4), None), "{along}");
        let left = told.turn.unwrap().left(at(along)).unwrap();
        assert!((left - (end - along)).abs() < 1.0, "{left}");
    }
    let told = bridge.second(5, at(end + 10.0));
    let leg = told.leg.unwrap();
    assert_eq!((told.situation, leg.course_in.deg()), (Some(2), 70.0));
    assert_eq!((told.turn, told.wheel_over), (None, None));
}

#[test]
fn a_leg_that_nobody_heard_is_not_invented() {
    let mut bridge = Bridge::new();
    let told = bridge.second(3, at(-200.0));
    assert_eq!((told.situation, told.turn, told.leg), (Some(3), None, None));
    assert_eq!(told.next_track.map(|track| track.deg()), Some(70.0));
    // On the arc the leg after it tells the side and what is left; not where it began.
    let told = bridge.second(4, at(300.0));
    assert!(!told.whole && told.wheel_over.is_none());
    let path = told.turn.unwrap();
    near(path.start(), turn().at(300.0, 0.0), 1.0);
    near(path.leg_out().point, turn().leg_out().point, 2.0);
    // The same where the sentences fell silent for longer than they count.
    let mut bridge = Bridge::new();
    bridge.second(2, at(-400.0));
    bridge.now = bridge.now + 6_000;
    assert!(!bridge.second(4, at(100.0)).whole);
    // Or where another chart system speaks.
    let mut bridge = Bridge::new();
    bridge.second(2, at(-400.0));
    bridge.now = bridge.now + 1_000;
    bridge.hear(1, &said(4, at(100.0), &turn()));
    assert!(!bridge.told().whole);
}

#[test]
fn a_turn_behind_a_turn_forgets_the_leg_of_the_first() {
    let mut bridge = Bridge::new();
    bridge.second(2, at(-400.0));
    bridge.second(4, at(600.0));
    let first = turn().leg_out();
    let second = Path::turn(
        first.course_in,
        first.at(40.0, 926.0),
        Radius::from_nm(0.5),
        Course::from_deg(150.0),
    );
    bridge.now = bridge.now + 1_000;
    bridge.hear(0, &said(4, second.at(200.0, 0.0), &second));
    let told = bridge.told();
    assert!(!told.whole, "{told:?}");
    near(
        told.turn.unwrap().leg_out().point,
        second.leg_out().point,
        2.0,
    );
}

#[test]
fn what_is_old_refused_or_contradicts_itself_is_not_told() {
    let mut bridge = Bridge::new();
    bridge.second(2, at(-400.0));
    bridge.now = bridge.now + 5_001;
    assert_eq!(bridge.told(), Told::default());
    // Sentences that never came leave out what they would tell.
    for missing in ["PNEY,001", "PNEY,002", "EIGLL"] {
        let mut bridge = Bridge::new();
        bridge.second(2, at(-410.0));
        bridge.now = bridge.now + 6_000;
        let mut lines = said(4, at(200.0), &turn());
        lines.retain(|line| !line.starts_with(missing));
        bridge.hear(0, &lines);
        let told = bridge.told();
        assert_eq!((told.turn, told.leg), (None, None), "{missing}");
    }
    // A magnetic track, a centre far off, a distance to another leg.
    let spoil: [(&str, &str, &str); 3] = [
        ("EIHTC", ",T,C", ",M,C"),
        ("PNEY,002", "N,011", "N,013"),
        ("PNEY,001", "A,A,", "A,A,3"),
    ];
    for (sentence, from, to) in spoil {
        let mut bridge = Bridge::new();
        bridge.second(2, at(-400.0));
        bridge.now = bridge.now + 1_000;
        let spoilt = |line: &String| match line.starts_with(sentence) {
            true => line.replace(from, to),
            false => line.clone(),
        };
        let lines: Vec<String> = said(3, at(-390.0), &turn()).iter().map(spoilt).collect();
        bridge.hear(0, &lines);
        let told = bridge.told();
        assert_eq!((told.turn, told.leg), (None, None), "{sentence}");
    }
}

#[test]
fn remote_heading_control_tells_its_leg_but_no_turn() {
    let mut bridge = Bridge::new();
    let lines = said(2, at(-400.0), &turn());
    let tn = |turn_mode: &str| {
        let htc = format!("EIHTC,V,,,H,{turn_mode},,,,30.0,358.0,,000.0,T,C");
        let mut lines = lines.clone();
        lines[0] = htc;
        lines
    };
    bridge.hear(0, &tn("N"));
    near(
        bridge.told().leg.unwrap().point,
        turn().at(-400.0, 0.0),
        0.5,
    );
    bridge.hear(0, &tn("T"));
    assert_eq!(bridge.told(), Told::default());
}

//! Closed loop: the steering laws on the simulated Mariner.
#![allow(clippy::unwrap_used)]

use wheelover_core::autopilot::gear::{Gear, Steered};
use wheelover_core::autopilot::steering::{Demand, Measured, Steering, SteeringSettings, TurnBy};
use wheelover_core::geo::Point;
use wheelover_core::path::Path;
use wheelover_core::scenario::{BenchRun, Disturbance, Document};
use wheelover_core::units::{Course, Heading, Radius, RateOfTurn, RudderAngle, Speed};
use wheelover_core::world::{Drive, Hull};

#[path = "steering/ordered.rs"]
mod ordered;

const LIMIT: f64 = 35.0;

/// A ship with perfect sensors at the paces of real ones.
struct Sea {
    hull: Hull,
    drive: Drive,
    steering: Steering,
    gear: Gear,
    fix: Option<Point>,
    ground: Option<(Course, Speed)>,
    steps: u32,
    last_order: f64,
    limit: f64,
}

impl Sea {
    fn new(knots: f64, set: f64, drift: f64) -> Self {
        let speed = Speed::from_knots(knots).mps();
        let drift = Speed::from_knots(drift).mps();
        let set = set.to_radians();
        let mut sea = Self {
            hull: Hull::running(0.0, speed),
            drive: Drive {
                order: 0.0,
                approach_speed: speed,
                current_north: drift * set.cos(),
                current_east: drift * set.sin(),
                ..Drive::default()
            },
            steering: Steering::new(SteeringSettings::default()),
            gear: Gear::default(),
            fix: None,
            ground: None,
            steps: 0,
            last_order: 0.0,
            limit: LIMIT,
        };
        let measured = sea.measure();
        sea.steering.engage(&measured);
        sea.gear.engage(RudderAngle::from_deg(0.0));
        sea
    }

    fn place(&self) -> Point {
        Point {
            north: self.hull.north,
            east: self.hull.east,
        }
    }

    fn measure(&mut self) -> Measured {
        if self.steps.is_multiple_of(10) {
            let (north, east) = self.hull.ground_velocity(&self.drive);
            self.fix = Some(self.place());
            let course = Course::from_rad(east.atan2(north));
            self.ground = Some((course, Speed::from_mps(north.hypot(east))));
        }
        Measured {
            heading: Heading::from_rad(self.hull.heading),
            rate: RateOfTurn::from_rad_per_s(self.hull.rate),
            rudder: Some(RudderAngle::from_deg(self.hull.rudder.to_degrees())),
            water_speed: Some(Speed::from_mps(self.hull.surge)),
            ground: self.ground,
            position: self.fix,
        }
    }

    /// One control step; checks limit and slew (FA6).
    fn step(&mut self, demand: &Demand) -> Steered {
        let measured = self.measure();
        self.step_with(&measured, demand)
    }

    fn step_with(&mut self, measured: &Measured, demand: &Demand) -> Steered {
        let limit = RudderAngle::from_deg(self.limit);
        let given = self.gear.given();
        let wanted = self.steering.step(measured, demand, limit, given, 0.1);
        let ship = self.steering.ship();
        let steered = self.gear.steer(&wanted, limit, ship, 0.1);
        let order = steered.order.deg();
        let slew = self.steering.ship().slew * 0.1;
        assert!(
            (order - self.last_order).abs() <= slew + 1e-9,
            "step {}",
            self.steps
        );
        assert!(order.abs() <= self.limit.max(self.last_order.abs()) + 1e-9);
        self.last_order = order;
        self.drive.order = order.to_radians();
        self.hull.step(&self.drive, 0.1);
        self.steps += 1;
        steered
    }

    fn heading(&self) -> f64 {
        self.hull.heading.to_degrees()
    }
}

fn heading(set: f64, by: TurnBy) -> Demand {
    Demand::Heading {
        set: Heading::from_deg(set),
        by,
    }
}

/// Steps of the set heading: overshoot and the largest rate against the one asked for.
fn check_step(change: f64, rate: f64, overshoot: f64) {
    let mut sea = Sea::new(15.0, 0.0, 0.0);
    for _ in 0..3000 {
        sea.step(&heading(0.0, TurnBy::Free));
    }
    let by = TurnBy::Rate(RateOfTurn::from_deg_per_min(rate * 60.0));
    let (mut most, mut fastest) = (0.0_f64, 0.0_f64);
    for _ in 0..6000 {
        sea.step(&heading(change, by));
        most = most.max((sea.heading() - change) * change.signum());
        fastest = fastest.max(sea.hull.rate.to_degrees().abs());
    }
    let left = sea.heading() - change;
    println!(
        "{change} deg at {rate} deg/s: overshoot {most:.2}, rate {fastest:.3}, left {left:.3}"
    );
    assert!(most < overshoot, "{change}: overshoot {most}");
    assert!(fastest < 1.1 * rate, "{change}: rate {fastest}");
    assert!(left.abs() < 0.2, "{change}: {left} left");
}

#[test]
fn heading_steps_do_not_overshoot() {
    check_step(10.0, 0.4, 1.0);
    check_step(30.0, 0.4, 1.0);
    check_step(-30.0, 0.5, 1.0);
    check_step(80.0, 0.4, 2.0);
    check_step(-80.0, 0.5, 2.0);
}

#[test]
fn a_heading_change_holds_its_radius() {
    let mut sea = Sea::new(15.0, 0.0, 0.0);
    let by = TurnBy::Radius(Radius::from_nm(0.6));
    for _ in 0..1500 {
        sea.step(&heading(170.0, by));
    }
    let radius = sea.hull.speed() / sea.hull.rate;
    assert!(
        (radius / Radius::from_nm(0.6).m() - 1.0).abs() < 0.1,
        "{radius} m"
    );
}

#[test]
fn a_leg_is_captured_smoothly_from_150_metres() {
    let mut sea = Sea::new(15.0, 90.0, 1.0);
    sea.hull.east = 150.0;
    let path = Demand::Track(Path::leg(Point::default(), Course::from_deg(0.0)));
    let (mut furthest, mut last_hts) = (0.0_f64, None);
    for _ in 0..6000 {
        let steered = sea.step(&path);
        furthest = furthest.min(sea.hull.east);
        let hts = steered.hts.deg();
        let step = last_hts.map_or(0.0, |last: f64| wheelover_core::units::wrap_180(hts - last));
        assert!(step.abs() < 0.5, "a step of {step} in the heading to steer");
        last_hts = Some(hts);
    }
    println!(
        "capture: {:.1} m on the far side, {:.2} m left",
        -furthest, sea.hull.east
    );
    assert!(furthest > -10.0, "{furthest}");
    assert!(sea.hull.east.abs() < 3.0, "{}", sea.hull.east);
}

/// Two legs and the turn between them, told as a chart system does; largest distance from the path.
fn sail_turn(knots: f64, set: f64, drift: f64, radius_nm: f64, course_out: f64) -> f64 {
    let mut sea = Sea::new(knots, set, drift);
    let radius = Radius::from_nm(radius_nm);
    let (first, second) = (Course::from_deg(0.0), Course::from_deg(course_out));
    let side = wheelover_core::units::wrap_180(course_out).signum();
    let centre = Point {
        north: 3500.0,
        east: side * radius.m(),
    };
    let turn = Path::turn(first, centre, radius, second);
    let end = centre.towards(course_out - 90.0 * side, radius.m());
    let mut worst = 0.0_f64;
    loop {
        let at = turn.progress(sea.place());
        let speed = sea.ground.map_or(7.7, |(_, speed)| speed.mps());
        let forwarding = sea.steering.ship().forwarding_time() * speed;
        let path = if at.along < -forwarding {
            Path::leg(Point::default(), first)
        } else if at.along < turn.arc_length() {
            turn
        } else {
            Path::leg(end, second)
        };
        sea.step(&Demand::Track(path));
        if at.along > -1500.0 {
            worst = worst.max(at.cross_track.abs());
        }
        if at.along > turn.arc_length() + 3000.0 {
            return worst;
        }
        assert!(sea.steps < 20_000 && worst < 500.0, "{worst} m at {at:?}");
    }
}

#[test]
fn legs_and_arcs_are_kept_in_a_knot_of_current() {
    let mut worst = 0.0_f64;
    for set in [0.0, 60.0, 120.0, 180.0, 240.0, 300.0] {
        for (radius, out) in [(0.5, 90.0), (0.5, 270.0), (0.8, 30.0), (0.6, 240.0)] {
            let xtd = sail_turn(15.0, set, 1.0, radius, out);
            println!("current to {set:3}, {radius} nm to {out:3}: {xtd:5.1} m");
            worst = worst.max(xtd);
        }
    }
    assert!(worst < 25.0, "{worst} m");
}

#[test]
fn other_speeds_are_steered_without_tuning() {
    for knots in [8.0, 12.0, 18.0, 20.0] {
        let xtd = sail_turn(knots, 90.0, 1.0, 0.5, 90.0);
        println!("{knots} kn: {xtd:.1} m");
        assert!(xtd < 40.0, "{knots} kn: {xtd} m");
    }
}

#[test]
fn orders_never_jump_over_changes_of_demand_sensors_and_limit() {
    let mut sea = Sea::new(15.0, 45.0, 1.0);
    let here =
        |sea: &Sea, course: f64| Demand::Track(Path::leg(sea.place(), Course::from_deg(course)));
    let mut demand = heading(0.0, TurnBy::Free);
    for k in 0..6000_u32 {
        if k.is_multiple_of(100) {
            demand = match k / 100 % 8 {
                0 => heading(f64::from(k % 360), TurnBy::Free),
                1 => here(&sea, sea.heading() + 40.0),
                2 => heading(sea.heading() - 100.0, TurnBy::Radius(Radius::from_nm(0.3))),
                3 => Demand::Track(Path::turn(
                    Course::from_deg(sea.heading()),
                    sea.place().towards(sea.heading() + 90.0, 926.0),
                    Radius::from_m(926.0),
                    Course::from_deg(sea.heading() + 90.0),
                )),
                4 => here(&sea, sea.heading() + 170.0),
                5 => Demand::Rate(RateOfTurn::from_deg_per_min(f64::from(k % 180) - 90.0)),
                6 => Demand::Rudder(RudderAngle::from_deg(f64::from(k % 80) - 40.0)),
                _ => heading(
                    sea.heading(),
                    TurnBy::Rate(RateOfTurn::from_deg_per_min(60.0)),
                ),
            };
            sea.limit = if k / 700 % 2 == 0 { LIMIT } else { 10.0 };
        }
        let mut measured = sea.measure();
        if k / 50 % 5 == 1 {
            measured.position = None;
            measured.ground = None;
        }
        if k / 50 % 7 == 2 {
            measured.water_speed = None;
            measured.rudder = None;
        }
        if k / 30 % 11 == 3 {
            measured.heading = Heading::from_deg(measured.heading.deg() + 20.0);
        }
        let steered = sea.step_with(&measured, &demand);
        assert!(steered.terms.proportional.is_finite() && steered.order.deg().is_finite());
        if k.is_multiple_of(997) {
            let kept = serde_json::to_string(&sea.steering).unwrap();
            sea.steering = serde_json::from_str(&kept).unwrap();
        }
    }
}

#[test]
fn engaging_takes_over_the_rudder_where_it_is() {
    let mut sea = Sea::new(15.0, 0.0, 0.0);
    sea.drive.order = 20_f64.to_radians();
    for _ in 0..300 {
        sea.hull.step(&sea.drive, 0.1);
    }
    let measured = sea.measure();
    sea.steering.engage(&measured);
    sea.gear.engage(RudderAngle::from_deg(20.0));
    sea.last_order = 20.0;
    let first = sea.step(&heading(sea.heading(), TurnBy::Free));
    assert!((first.order.deg() - 20.0).abs() < 0.5, "{first:?}");
}

/// The bench's figures stay at least as good as this.
fn check_bench(name: &str, limits: &[(&str, f64)]) {
    let folder = concat!(env!("CARGO_MANIFEST_DIR"), "/../tests/data/trackbench/");
    let read = |file: &str| std::fs::read_to_string(format!("{folder}{file}")).unwrap();
    let Ok(Document::Bench(bench)) = Document::parse(&read("scenario.json")) else {
        panic!("not a bench");
    };
    let noise =
        Disturbance::parse(&read("disturbance_10hz.csv"), &read("disturbance_1hz.csv")).unwrap();
    let (_, conditions) = bench.scenarios().find(|(n, _)| *n == name).unwrap();
    let mut run = BenchRun::new(&bench, *conditions, &noise, SteeringSettings::default());
    while !run.done() {
        run.step();
    }
    assert!(!run.lost());
    let report = run.report();
    for (figure, limit) in limits {
        let value = report.value(figure).unwrap();
        println!("{name} {figure} {value:.3} (limit {limit})");
        assert!(
            value <= *limit,
            "{name}: {figure} is {value}, limit {limit}"
        );
    }
}

#[test]
fn trackbench_calm() {
    check_bench(
        "TB0_calm_15kn",
        &[
            ("leg_settled_max_m", 5.0),
            ("arc_max_m", 10.0),
            ("capture_overshoot_m", 10.0),
        ],
    );
}

#[test]
fn trackbench_in_waves_and_current() {
    check_bench(
        "TB1_main_15kn",
        &[
            ("leg_settled_max_m", 10.0),
            ("leg_settled_rms_m", 3.0),
            ("leg_all_rms_m", 10.0),
            ("arc_max_m", 30.0),
            ("arc_rms_m", 15.0),
            ("capture_overshoot_m", 10.0),
            ("hdg_overshoot_max_deg", 8.0),
            ("rudder_travel_settled_deg_per_min", 15.0),
            ("rudder_reversals_settled_per_min", 6.0),
        ],
    );
}

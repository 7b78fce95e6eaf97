//! Time of one control step of the steering laws and of one step of the world.
#![allow(clippy::disallowed_types, reason = "what is measured is time")]

use std::hint::black_box;
use std::time::Instant;
use wheelover_core::autopilot::gear::Gear;
use wheelover_core::autopilot::steering::{Demand, Measured, Steering, SteeringSettings};
use wheelover_core::geo::Point;
use wheelover_core::path::Path;
use wheelover_core::station::Input;
use wheelover_core::time::Stamp;
use wheelover_core::units::{Course, Heading, Radius, RateOfTurn, RudderAngle, Speed};
use wheelover_core::world::{Drive, Hull, World, WorldConfig};

const STEPS: u32 = 20_000;

/// Median time of a step, microseconds.
fn median(name: &str, mut step: impl FnMut(u32)) {
    let mut times: Vec<f64> = (0..STEPS)
        .map(|k| {
            let begin = Instant::now();
            step(k);
            begin.elapsed().as_secs_f64() * 1e6
        })
        .collect();
    times.sort_by(f64::total_cmp);
    let (middle, late) = (times[times.len() / 2], times[times.len() * 99 / 100]);
    println!("{name:20} median {middle:7.2} us   p99 {late:7.2} us");
}

fn main() {
    let centre = Point {
        north: 3000.0,
        east: 926.0,
    };
    let demand = Demand::Track(Path::turn(
        Course::from_deg(0.0),
        centre,
        Radius::from_m(926.0),
        Course::from_deg(90.0),
    ));
    let mut steering = Steering::new(SteeringSettings::default());
    let mut gear = Gear::default();
    let limit = RudderAngle::from_deg(35.0);
    median("steering", |k| {
        let measured = Measured {
            heading: Heading::from_deg(0.1),
            rate: RateOfTurn::from_deg_per_min(1.0),
            rudder: Some(RudderAngle::from_deg(1.0)),
            water_speed: Some(Speed::from_knots(15.0)),
            ground: Some((Course::from_deg(0.2), Speed::from_knots(15.1))),
            position: Some(Point {
                north: f64::from(k / 10) * 7.8,
                east: 5.0,
            }),
        };
        let wanted = steering.step(&measured, &demand, limit, gear.given(), 0.1);
        black_box(gear.steer(&wanted, limit, steering.ship(), 0.1));
    });

    let mut hull = Hull::running(0.0, 7.7);
    let drive = Drive {
        order: 0.2,
        approach_speed: 7.7,
        ..Drive::default()
    };
    median("hull", |_| hull.step(black_box(&drive), 0.1));

    let mut world = World::new(WorldConfig::default());
    let mut out = Vec::new();
    median("world with sensors", |k| {
        out.clear();
        world.handle(Stamp(u64::from(k) * 100), Input::Tick, &mut out);
        black_box(&out);
    });
}

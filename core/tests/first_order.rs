//! A ship of first order, given by her constants alone or by nothing: legs and arcs stay near, and nothing swings (AP-20).
#![allow(clippy::unwrap_used)]

use wheelover_core::autopilot::gear::Gear;
use wheelover_core::autopilot::steering::{Demand, Measured, Steering, SteeringSettings, TurnBy};
use wheelover_core::geo::Point;
use wheelover_core::path::Path;
use wheelover_core::settings::Settings;
use wheelover_core::units::{Course, Heading, Radius, RateOfTurn, RudderAngle, Speed};

/// `T r' + r = K delta`, no sway, at a constant speed.
struct Ship {
    gain: f64,
    time_constant: f64,
    speed: f64,
    slew: f64,
    place: Point,
    heading: f64,
    rate: f64,
    rudder: f64,
}

impl Ship {
    fn new(gain: f64, time_constant: f64, knots: f64, heading_deg: f64) -> Self {
        Self {
            gain,
            time_constant,
            speed: Speed::from_knots(knots).mps(),
            slew: 3.0,
            place: Point::default(),
            heading: heading_deg.to_radians(),
            rate: 0.0,
            rudder: 0.0,
        }
    }

    fn measured(&self) -> Measured {
        let heading = Heading::from_rad(self.heading);
        Measured {
            heading,
            rate: RateOfTurn::from_rad_per_s(self.rate),
            rudder: Some(RudderAngle::from_deg(self.rudder)),
            water_speed: Some(Speed::from_mps(self.speed)),
            ground: Some((heading.as_course(), Speed::from_mps(self.speed))),
            position: Some(self.place),
        }
    }

    fn step(&mut self, order: RudderAngle, dt: f64) {
        let most = self.slew * dt;
        self.rudder += (order.deg() - self.rudder).clamp(-most, most);
        let turn = self.gain * self.rudder.to_radians() - self.rate;
        self.rate += turn / self.time_constant * dt;
        self.heading += self.rate * dt;
        self.place.north += self.speed * self.heading.cos() * dt;
        self.place.east += self.speed * self.heading.sin() * dt;
    }
}

fn settings(ship: Option<(f64, f64)>, length: f64, knots: f64) -> SteeringSettings {
    let settings = Settings {
        length_m: Some(length),
        speed_kn: Some(knots),
        gain_per_s: ship.map(|(gain, _)| gain),
        time_constant_s: ship.map(|(_, time)| time),
        ..Settings::default()
    };
    SteeringSettings {
        slew: 3.0,
        ..SteeringSettings::cautious(&settings)
    }
}

/// Two miles, 60 degrees about half a mile, a mile and a half: the farthest off leg and arc once the leg is found.
fn farthest(gain: f64, time: f64, length: f64, knots: f64) -> f64 {
    let mut ship = Ship::new(gain, time, knots, 0.0);
    ship.place.east = 60.0;
    let mut steering = Steering::new(settings(Some((gain, time)), length, knots));
    steering.engage(&ship.measured());
    let mut gear = Gear::default();
    gear.engage(RudderAngle::from_deg(0.0));
    let centre = Point {
        north: 4_500.0,
        east: 926.0,
    };
    let path = Path::turn(
        Course::from_deg(0.0),
        centre,
        Radius::from_nm(0.5),
        Course::from_deg(60.0),
    );
    let (mut worst, mut last) = (0.0_f64, 0.0_f64);
    for step in 0..(8_000.0 / ship.speed * 10.0) as u32 {
        let (measured, limit) = (ship.measured(), RudderAngle::from_deg(35.0));
        let demand = Demand::Track(path);
        let wanted = steering.step(&measured, &demand, limit, gear.given(), 0.1);
        let steered = gear.steer(&wanted, limit, steering.ship(), 0.1);
        assert!((steered.order.deg() - last).abs() <= 0.3 + 1e-9);
        last = steered.order.deg();
        ship.step(steered.order, 0.1);
        if step > 3_500 {
            worst = worst.max(path.progress(ship.place).cross_track.abs());
        }
    }
    worst
}

#[test]
fn a_ship_given_by_her_constants_keeps_legs_and_arcs() {
    for (gain, time, length, knots) in [
        (0.185, 107.3, 160.93, 15.0),
        (0.185, 107.3, 160.93, 20.0),
        (0.12, 60.0, 160.0, 12.0),
        (0.5, 31.0, 45.0, 9.7),
        (0.18, 27.0, 100.0, 17.5),
    ] {
        let worst = farthest(gain, time, length, knots);
        println!("K {gain} T {time} L {length} {knots} kn: {worst:.1} m");
        assert!(worst < 30.0, "K {gain}, T {time}, {knots} kn: {worst} m");
    }
}

#[test]
fn a_ship_of_whom_nothing_is_known_comes_to_her_heading_and_keeps_it() {
    for (gain, time, length, knots) in [
        (0.185, 107.3, 160.93, 15.0),
        (0.5, 31.0, 45.0, 9.7),
        (0.18, 27.0, 100.0, 17.5),
        (0.06, 200.0, 300.0, 15.0),
    ] {
        let mut ship = Ship::new(gain, time, knots, 0.0);
        let mut steering = Steering::new(settings(None, length, knots));
        steering.engage(&ship.measured());
        let mut gear = Gear::default();
        gear.engage(RudderAngle::from_deg(0.0));
        let demand = Demand::Heading {
            set: Heading::from_deg(30.0),
            by: TurnBy::Free,
        };
        let (mut most, mut late) = (0.0_f64, 0.0_f64);
        for step in 0..9_000 {
            let (measured, limit) = (ship.measured(), RudderAngle::from_deg(20.0));
            let wanted = steering.step(&measured, &demand, limit, gear.given(), 0.1);
            let steered = gear.steer(&wanted, limit, steering.ship(), 0.1);
            ship.step(steered.order, 0.1);
            most = most.max(ship.heading.to_degrees());
            if step > 6_000 {
                late = late.max((ship.heading.to_degrees() - 30.0).abs());
            }
        }
        println!(
            "K {gain} T {time}: overshoot {:.1}, later {late:.2} deg",
            most - 30.0
        );
        assert!(
            most < 38.0 && late < 1.5,
            "K {gain}, T {time}: {most} {late}"
        );
    }
}

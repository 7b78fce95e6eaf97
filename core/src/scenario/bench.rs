//! The bench in closed loop: hull, the scenario's sensors, our steering.

use super::document::{Bench, Conditions, Disturbance};
use super::metrics::{Meter, Report};
use super::sample::{STEP, Sample, Stage};
use crate::autopilot::gear::Gear;
use crate::autopilot::steering::{Demand, Measured, Steering, SteeringSettings};
use crate::geo::Point;
use crate::path::Path;
use crate::units::{
    Course, Heading, METRES_PER_NAUTICAL_MILE, METRES_PER_SECOND_PER_KNOT, RateOfTurn, RudderAngle,
    Speed,
};
use crate::world::{Drive, Hull};

const GYRO_NOISE: f64 = 0.1;
const RATE_NOISE: f64 = 0.02;
const POSITION_DRIFT: f64 = 1.5;
const POSITION_NOISE: f64 = 0.5;
const VELOCITY_NOISE: f64 = 0.05;
/// Distance from the track at which a run is given up, m.
const LOST: f64 = 1500.0;
/// A run ends here at the latest, s.
const LONGEST: f64 = 20_000.0;

/// One scenario under way.
#[derive(Clone, Debug)]
pub struct BenchRun<'a> {
    bench: &'a Bench,
    conditions: Conditions,
    disturbance: &'a Disturbance,
    steering: Steering,
    gear: Gear,
    hull: Hull,
    drive: Drive,
    stage: Stage,
    fix: Option<Point>,
    ground: Option<(Course, Speed)>,
    steps: u64,
    meter: Meter,
    done: bool,
    lost: bool,
}

impl<'a> BenchRun<'a> {
    /// Ready at the start, steered by our laws with these settings.
    #[must_use]
    pub fn new(
        bench: &'a Bench,
        conditions: Conditions,
        disturbance: &'a Disturbance,
        settings: SteeringSettings,
    ) -> Self {
        let (start, heading) = bench.start();
        let speed = conditions.kn * METRES_PER_SECOND_PER_KNOT;
        let mut hull = Hull::running(heading.to_radians(), speed);
        (hull.north, hull.east) = (start.north, start.east);
        let drift = conditions.cur_kn * METRES_PER_SECOND_PER_KNOT;
        let set = conditions.cur_set.to_radians();
        let drive = Drive {
            order: 0.0,
            approach_speed: speed,
            current_north: drift * libm::cos(set),
            current_east: drift * libm::sin(set),
            ..Drive::default()
        };
        let mut run = Self {
            bench,
            conditions,
            disturbance,
            steering: Steering::new(settings),
            gear: Gear::default(),
            hull,
            drive,
            stage: Stage::Leg(0),
            fix: None,
            ground: None,
            steps: 0,
            meter: Meter::new(bench.leg_count()),
            done: false,
            lost: false,
        };
        let first = run.measure();
        run.steering.engage(&first);
        run.gear.engage(RudderAngle::from_deg(0.0));
        run
    }

    /// Whether the route is sailed, or the ship lost.
    #[must_use]
    pub const fn done(&self) -> bool {
        self.done
    }

    /// Whether the run ended without reaching the end of the route.
    #[must_use]
    pub const fn lost(&self) -> bool {
        self.lost
    }

    /// Part of the route that is sailed, 0 to 1.
    #[must_use]
    pub fn progress(&self) -> f64 {
        let (Stage::Leg(i) | Stage::Arc(i)) = self.stage;
        i as f64 / self.bench.leg_count() as f64
    }

    /// One control step: measure, steer, sail 0.1 s.
    pub fn step(&mut self) -> Sample {
        let measured = self.measure();
        let place = self.place();
        let demand = Demand::Track(self.path(place, &measured));
        let limit = RudderAngle::from_deg(self.bench.rudder_limit());
        let given = self.gear.given();
        let wanted = (self.steering).step(&measured, &demand, limit, given, STEP);
        let ship = self.steering.ship();
        let steered = self.gear.steer(&wanted, limit, ship, STEP);
        let sample = Sample {
            time: self.steps as f64 * STEP,
            north: self.hull.north,
            east: self.hull.east,
            heading: self.hull.heading.to_degrees(),
            rate: self.hull.rate.to_degrees(),
            rudder: self.hull.rudder.to_degrees(),
            order: steered.order.deg(),
            speed: self.hull.speed(),
            cross_track: self.cross_track(place),
            stage: self.stage,
        };
        self.meter.take(&sample, self.on_leg(place));
        let last = self.stage == Stage::Leg(self.bench.leg_count() - 1);
        let left = place.distance(self.bench.end());
        self.lost = libm::fabs(sample.cross_track) > LOST || sample.time > LONGEST;
        self.done = self.lost || (last && left < 0.1 * METRES_PER_NAUTICAL_MILE);
        self.drive.order = steered.order.rad();
        self.hull.step(&self.drive, STEP);
        self.steps += 1;
        sample
    }

    /// The figures of the run so far.
    #[must_use]
    pub fn report(&self) -> Report {
        self.meter.report()
    }

    const fn place(&self) -> Point {
        Point {
            north: self.hull.north,
            east: self.hull.east,
        }
    }

    /// Metres along the leg from the end of the arc before it (first leg: from its waypoint).
    fn on_leg(&self, place: Point) -> f64 {
        match self.stage {
            Stage::Leg(0) | Stage::Arc(0) => self.bench.leg(0).progress(place).along,
            Stage::Leg(i) | Stage::Arc(i) => {
                let before = self.bench.leg_and_turn(i - 1);
                before.progress(place).along - before.arc_length()
            }
        }
    }

    fn cross_track(&self, place: Point) -> f64 {
        match self.stage {
            Stage::Leg(i) => self.bench.leg(i).progress(place).cross_track,
            Stage::Arc(i) => self.bench.leg_and_turn(i).progress(place).cross_track,
        }
    }

    /// The path as a chart system commands it: the turn from the wheel-over line to the end of the arc.
    fn path(&mut self, place: Point, measured: &Measured) -> Path {
        let ahead = |i: usize| {
            let path = self.bench.leg_and_turn(i);
            (path, path.progress(place).along, path.arc_length())
        };
        match self.stage {
            Stage::Leg(i) => {
                let (path, along, _) = ahead(i);
                if path.turn.is_none() {
                    return path;
                }
                if along >= 0.0 {
                    self.stage = Stage::Arc(i);
                }
                let speed = measured.ground.map_or(0.0, |(_, speed)| speed.mps());
                let forwarding = speed * self.steering.ship().forwarding_time();
                if along >= -forwarding {
                    path
                } else {
                    self.bench.leg(i)
                }
            }
            Stage::Arc(i) => {
                let (path, along, length) = ahead(i);
                if along < length {
                    return path;
                }
                self.stage = Stage::Leg(i + 1);
                self.bench.leg(i + 1)
            }
        }
    }

    fn measure(&mut self) -> Measured {
        let Conditions {
            wave_deg, noise, ..
        } = self.conditions;
        let row = |series: &[[f64; 4]]| match series.len() {
            0 => [0.0; 4],
            n => series[self.steps as usize % n],
        };
        let [yaw, yaw_rate, gyro, rate] = row(&self.disturbance.fast);
        if self.steps.is_multiple_of(10) {
            self.measure_each_second(noise);
        }
        let heading = self.hull.heading.to_degrees() + wave_deg * yaw + noise * GYRO_NOISE * gyro;
        let turn = self.hull.rate.to_degrees() + wave_deg * yaw_rate + noise * RATE_NOISE * rate;
        Measured {
            heading: Heading::from_deg(heading),
            rate: RateOfTurn::from_deg_per_min(turn * 60.0),
            rudder: Some(RudderAngle::from_deg(self.hull.rudder.to_degrees())),
            water_speed: Some(Speed::from_mps(self.hull.surge)),
            ground: self.ground,
            position: self.fix,
        }
    }

    fn measure_each_second(&mut self, noise: f64) {
        let [drift_n, drift_e, fast_n, fast_e, vel_n, vel_e] = match self.disturbance.slow.len() {
            0 => [0.0; 6],
            n => self.disturbance.slow[(self.steps / 10) as usize % n],
        };
        self.fix = Some(Point {
            north: self.hull.north + noise * (POSITION_DRIFT * drift_n + POSITION_NOISE * fast_n),
            east: self.hull.east + noise * (POSITION_DRIFT * drift_e + POSITION_NOISE * fast_e),
        });
        let (north, east) = self.hull.ground_velocity(&self.drive);
        let (north, east) = (
            north + noise * VELOCITY_NOISE * vel_n,
            east + noise * VELOCITY_NOISE * vel_e,
        );
        self.ground = Some((
            Course::from_rad(libm::atan2(east, north)),
            Speed::from_mps(libm::hypot(north, east)),
        ));
    }
}

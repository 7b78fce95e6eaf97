//! A yacht whose tiller a motor turns, in fifteen knots of wind: she keeps her heading, and a motor that fails is a held rudder
//! with its reason (AP-18, FA11, FA7).

use wheelover_core::alerts::Alert;
use wheelover_core::autopilot::{Autopilot, Mode};
use wheelover_core::motor::Protocol;
use wheelover_core::settings::{GearKind, HeadingLaw, Settings, Value};
use wheelover_core::station::{Input, Output};
use wheelover_core::time::Stamp;
use wheelover_core::units::{Course, Heading, Speed};
use wheelover_core::view::{ModeRequest, Order, Origin};
use wheelover_core::world::{Noise, ShipModel, TillerFaults, World, WorldConfig};

/// Autopilot and world, port by port.
struct Boat {
    autopilot: Autopilot,
    world: World,
    now: Stamp,
    /// Headings as she has them, one a step.
    headings: Vec<f64>,
}

impl Boat {
    fn new(protocol: Protocol) -> Self {
        let config = WorldConfig {
            heading: Heading::from_deg(60.0),
            speed: Speed::from_knots(6.0),
            wind_from: Course::from_deg(150.0),
            wind_speed: Speed::from_knots(15.0),
            gustiness: 0.25,
            ship: ShipModel::Yacht,
            motor: Some(protocol),
            noise: Noise {
                wave_yaw: 1.0,
                wave_frequency: 1.3,
                ..Noise::default()
            },
            ..WorldConfig::default()
        };
        let settings = Settings {
            gear: match protocol {
                Protocol::Pypilot => GearKind::Pypilot,
                Protocol::Jrk => GearKind::Jrk,
            },
            length_m: Some(10.0),
            speed_kn: Some(6.0),
            gain_per_s: Some(0.25),
            time_constant_s: Some(2.0),
            cruise_speed: 6.0,
            rudder_limit: 30.0,
            set_radius: 0.05,
            heading_law: HeadingLaw::Pid,
            pid_kp: 1.8,
            pid_ki: 0.12,
            pid_kd: 1.2,
            sample_time: 500.0,
            rudder_damping: 1.5,
            motor_band_min: 0.8,
            rudder_slew: 8.0,
            ..Settings::default()
        };
        let ports = config.ports.clone();
        let mut boat = Self {
            autopilot: Autopilot::new(ports, settings, None, Stamp(0)),
            world: World::new(config),
            now: Stamp(0),
            headings: Vec::new(),
        };
        boat.run(5.0);
        boat
    }

    fn run(&mut self, seconds: f64) {
        for _ in 0..(seconds * 10.0) as u32 {
            self.now = self.now + 100;
            let mut said = Vec::new();
            self.world.handle(self.now, Input::Tick, &mut said);
            let mut orders = Vec::new();
            for output in &said {
                if let Output::Send { port, bytes } = output {
                    let input = Input::Bytes { port: *port, bytes };
                    self.autopilot.handle(self.now, input, &mut orders);
                }
            }
            self.autopilot.handle(self.now, Input::Tick, &mut orders);
            self.deliver(&orders);
            self.headings.push(self.world.truth().heading.deg());
        }
    }

    fn deliver(&mut self, said: &[Output]) {
        let mut silence = Vec::new();
        for output in said {
            if let Output::Send { port, bytes } = output {
                let said = bytes.windows(6).any(|part| part == b"$AGROR");
                assert!(!said, "a sentence to the motor");
                let input = Input::Bytes { port: *port, bytes };
                self.world.handle(self.now, input, &mut silence);
            }
        }
    }

    fn order(&mut self, order: &Order) -> Result<String, String> {
        let mut said = Vec::new();
        let by = Origin::Officer;
        self.autopilot
            .handle(self.now, Input::Order { by, order }, &mut said);
        self.deliver(&said);
        let answer = said.into_iter().find_map(|output| match output {
            Output::Answer(answer) => Some(answer.map_err(|refusal| refusal.to_string())),
            _ => None,
        });
        answer.expect("an answer")
    }

    fn auto(&mut self) -> Result<String, String> {
        self.order(&Order::Mode(ModeRequest::Auto))
    }

    fn suffer(&mut self, faults: TillerFaults) {
        self.world.tiller().expect("a tiller").faults = faults;
    }

    fn runs(&mut self) -> bool {
        self.world.tiller().expect("a tiller").runs()
    }

    /// Root of the mean square of what she was off a heading since `from` steps, degrees.
    fn off(&self, heading: f64, from: usize) -> f64 {
        let off = self.headings[from..].iter().map(|read| {
            let off = (read - heading + 540.0) % 360.0 - 180.0;
            off * off
        });
        (off.sum::<f64>() / (self.headings.len() - from) as f64).sqrt()
    }
}

// Three degrees in fifteen knots and gusts; how often the motor starts is printed.
#[test]
fn she_keeps_her_heading_in_gusts() {
    for protocol in [Protocol::Pypilot, Protocol::Jrk] {
        let mut boat = Boat::new(protocol);
        boat.auto().expect("AUTO");
        let set = boat.autopilot.hts().expect("a heading").deg();
        boat.run(60.0);
        let (from, before) = (boat.headings.len(), boat.autopilot.motor_starts());
        boat.run(600.0);
        let off = boat.off(set, from);
        let starts = (boat.autopilot.motor_starts() - before) as f64 / 10.0;
        println!("{protocol:?}: {off:.2} deg, {starts:.1} motor starts a minute");
        assert!(off <= 3.0, "{protocol:?}: {off:.2} deg");
        assert!(!boat.autopilot.alerts().raised(Alert::Motor));
        boat.order(&Order::SetHeading(set + 30.0))
            .expect("a new heading");
        boat.run(40.0);
        let from = boat.headings.len();
        boat.run(60.0);
        assert!(
            boat.off(set + 30.0, from) <= 3.0,
            "{protocol:?}: on the new heading"
        );
    }
}

#[test]
fn standby_stops_the_motor_without_a_step() {
    for protocol in [Protocol::Pypilot, Protocol::Jrk] {
        let mut boat = Boat::new(protocol);
        boat.auto().expect("AUTO");
        boat.order(&Order::SetHeading(150.0)).expect("a heading");
        boat.run(2.0);
        assert!(boat.runs(), "{protocol:?}");
        boat.order(&Order::Mode(ModeRequest::Standby))
            .expect("STANDBY");
        assert!(!boat.runs(), "{protocol:?}");
    }
}

#[test]
fn a_motor_that_fails_holds_the_rudder_until_a_mode_is_selected_anew() {
    let none = TillerFaults::default();
    let faults = [
        (
            TillerFaults {
                no_feedback: true,
                ..none
            },
            "feedback",
            true,
        ),
        (
            TillerFaults {
                silent: true,
                ..none
            },
            "no answer",
            true,
        ),
        (
            TillerFaults {
                blocked: true,
                ..none
            },
            "stands",
            false,
        ),
        (
            TillerFaults {
                over_current: true,
                ..none
            },
            "current",
            false,
        ),
    ];
    for protocol in [Protocol::Pypilot, Protocol::Jrk] {
        for (fault, word, refuses) in faults {
            let mut boat = Boat::new(protocol);
            boat.auto().expect("AUTO");
            boat.order(&Order::SetHeading(150.0)).expect("a heading");
            boat.run(1.5);
            boat.suffer(fault);
            boat.run(3.0);
            assert!(
                matches!(boat.autopilot.mode(), Mode::RudderHold(_)),
                "{protocol:?} {word}"
            );
            assert!(!boat.runs(), "{protocol:?} {word}");
            let alert = boat.autopilot.alerts().standing_of(Alert::Motor);
            let text = alert.expect("an alarm").detail.clone();
            assert!(text.contains(word), "{text}");
            if refuses {
                let refused = boat.auto().expect_err("AUTO without a motor");
                assert!(refused.contains("motor"), "{refused}");
            }
            boat.suffer(none);
            boat.run(3.0);
            assert!(
                matches!(boat.autopilot.mode(), Mode::RudderHold(_)),
                "by itself nothing returns"
            );
            assert!(!boat.runs());
            boat.auto().expect("AUTO again");
            boat.run(30.0);
            assert!(
                matches!(boat.autopilot.mode(), Mode::Auto(_)),
                "{protocol:?} {word}"
            );
            assert!(!boat.autopilot.alerts().raised(Alert::Motor));
        }
    }
}

#[test]
fn a_motor_that_is_not_there_refuses_auto() {
    let mut boat = Boat::new(Protocol::Pypilot);
    boat.suffer(TillerFaults {
        silent: true,
        ..TillerFaults::default()
    });
    boat.run(3.0);
    let refused = boat.auto().expect_err("AUTO");
    assert!(refused.contains("no answer from the motor"), "{refused}");
}

// A wrong sign refuses AUTO, and says which parameter to change.
#[test]
fn a_motor_that_goes_the_wrong_way_is_refused_until_it_is_mended() {
    let mut boat = Boat::new(Protocol::Pypilot);
    boat.suffer(TillerFaults {
        reversed: true,
        ..TillerFaults::default()
    });
    boat.auto().expect("AUTO");
    boat.order(&Order::SetHeading(150.0)).expect("a heading");
    boat.run(4.0);
    assert!(matches!(boat.autopilot.mode(), Mode::RudderHold(_)));
    let refused = boat.auto().expect_err("AUTO the wrong way");
    assert!(refused.contains("motor_reversed"), "{refused}");
    let key = "motor_reversed".to_string();
    boat.order(&Order::Setting {
        key,
        value: Value::Switch(true),
    })
    .expect("mended");
    boat.auto().expect("AUTO");
    boat.order(&Order::SetHeading(150.0)).expect("a heading");
    boat.run(60.0);
    let from = boat.headings.len();
    boat.run(60.0);
    assert!(boat.off(150.0, from) <= 3.0);
}

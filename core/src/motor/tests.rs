//! A motor against a controller that speaks its protocol, with its faults (AP-18, FA11).

use super::*;
use crate::world::{Tiller, TillerFaults};

const STEP_MS: u64 = 100;
const BOTH: [Protocol; 2] = [Protocol::Pypilot, Protocol::Jrk];

/// A motor and its counterpart on one line.
struct Line {
    motor: Motor,
    tiller: Tiller,
    setup: MotorSetup,
    now: Stamp,
}

impl Line {
    fn new(protocol: Protocol) -> Self {
        let mut line = Self {
            motor: Motor::new(Stamp(0)),
            tiller: Tiller::new(protocol, 7),
            setup: MotorSetup {
                protocol,
                ..MotorSetup::default()
            },
            now: Stamp(0),
        };
        line.run(None, 1.0);
        line
    }

    /// Control steps for `seconds`; the controller goes on and speaks every 20 ms.
    fn run(&mut self, order: Option<f64>, seconds: f64) {
        for _ in 0..libm::round(seconds * 1000.0) as u64 / STEP_MS {
            let order = order.map(RudderAngle::from_deg);
            let said = (self.motor).step(self.now, order, &self.setup, STEP_MS as f64 / 1000.0);
            self.tiller.hear(&said);
            for _ in 0..5 {
                self.now = self.now + 20;
                self.tiller.step(0.02);
                let said = self.tiller.say();
                self.motor.hear(self.now, &said, &self.setup);
            }
        }
    }

    /// How long after now the control step is that stops the motor, ms; absent where it runs on.
    fn stands_after(&mut self, order: f64) -> Option<u64> {
        let began = self.now;
        for _ in 0..40 {
            let step = self.now;
            self.run(Some(order), 0.1);
            if !self.tiller.runs() {
                return Some(step.since(began));
            }
        }
        None
    }
}

#[test]
fn the_rudder_comes_to_each_order() {
    for protocol in BOTH {
        let mut line = Line::new(protocol);
        for order in [10.0, -20.0, 34.0, 0.0, 1.0] {
            line.run(Some(order), 10.0);
            let rudder = line.tiller.rudder();
            assert!(
                (rudder - order).abs() < 0.8,
                "{protocol:?}: {order}, {rudder}"
            );
            let response = line.motor.response(line.now).expect("a response");
            assert!((response.deg() - rudder).abs() < 0.1, "{protocol:?}");
        }
        assert_eq!(line.motor.fault(), None, "{protocol:?}");
    }
}

#[test]
fn travel_trim_and_end_switches_hold() {
    for protocol in BOTH {
        let mut line = Line::new(protocol);
        line.setup.travel_deg = 35.0;
        line.run(Some(80.0), 12.0);
        assert!(line.tiller.rudder() <= 35.0);
        assert_eq!(line.motor.fault(), None, "{protocol:?}: an end is no stall");
        line.setup.trim_deg = -4.0;
        line.run(Some(0.0), 10.0);
        assert!((line.tiller.rudder() + 4.0).abs() < 0.8, "{protocol:?}");
    }
}

#[test]
fn without_an_order_the_motor_stands_at_once() {
    for protocol in BOTH {
        let mut line = Line::new(protocol);
        line.run(Some(30.0), 0.5);
        assert!(line.tiller.runs(), "{protocol:?}");
        let said = line.motor.stop(&line.setup);
        line.tiller.hear(&said);
        assert!(!line.tiller.runs(), "{protocol:?}");
        let there = line.tiller.rudder();
        line.run(None, 5.0);
        assert!((line.tiller.rudder() - there).abs() < 2.0, "{protocol:?}");
    }
}

// FA11: each fault stops the motor, in its time, by its name.
#[test]
fn each_fault_stops_it_and_is_named() {
    let none = TillerFaults::default();
    let faults: [(TillerFaults, MotorFault, u64); 5] = [
        (
            TillerFaults {
                no_feedback: true,
                ..none
            },
            MotorFault::NoFeedback,
            300,
        ),
        (
            TillerFaults {
                silent: true,
                ..none
            },
            MotorFault::NoFeedback,
            300,
        ),
        (
            TillerFaults {
                blocked: true,
                ..none
            },
            MotorFault::Stalled,
            1_800,
        ),
        (
            TillerFaults {
                reversed: true,
                ..none
            },
            MotorFault::Reversed,
            1_200,
        ),
        (
            TillerFaults {
                over_current: true,
                ..none
            },
            MotorFault::OverCurrent,
            300,
        ),
    ];
    for protocol in BOTH {
        for (fault, named, within) in faults {
            let mut line = Line::new(protocol);
            line.run(Some(-30.0), 0.5);
            line.tiller.faults = fault;
            let stood = line.stands_after(-30.0);
            assert!(
                stood.is_some_and(|ms| ms <= within),
                "{protocol:?} {named:?}: {stood:?}"
            );
            line.run(Some(-30.0), 0.1);
            assert_eq!(line.motor.fault(), Some(named), "{protocol:?}");
            line.run(Some(-30.0), 3.0);
            assert!(!line.tiller.runs(), "{protocol:?} {named:?}: it stays so");
            line.tiller.faults = none;
            line.run(None, 1.5);
            let said = line.motor.try_again(line.now, &line.setup);
            line.tiller.hear(&said);
            line.run(Some(10.0), 8.0);
            assert_eq!(
                line.motor.fault(),
                None,
                "{protocol:?} {named:?}: it is over"
            );
            assert!(
                (line.tiller.rudder() - 10.0).abs() < 0.8,
                "{protocol:?} {named:?}"
            );
        }
    }
}

#[test]
fn a_motor_that_is_not_there_is_named() {
    for protocol in BOTH {
        let mut line = Line::new(protocol);
        line.tiller.faults.silent = true;
        line.run(None, 2.0);
        assert_eq!(line.motor.fault(), Some(MotorFault::Absent), "{protocol:?}");
        assert_eq!(line.motor.response(line.now), None);
        line.tiller.faults.silent = false;
        line.run(None, 0.5);
        assert_eq!(line.motor.fault(), None, "{protocol:?}: it came");
    }
}

// A wrong sign stands until it is changed, however often it is tried.
#[test]
fn wrong_wires_are_mended_by_a_parameter() {
    for protocol in BOTH {
        let mut line = Line::new(protocol);
        line.tiller.faults.reversed = true;
        line.run(Some(20.0), 3.0);
        assert_eq!(
            line.motor.fault(),
            Some(MotorFault::Reversed),
            "{protocol:?}"
        );
        assert!(
            line.tiller.rudder() > -8.0,
            "{protocol:?}: {}",
            line.tiller.rudder()
        );
        line.setup.reversed = true;
        let said = line.motor.try_again(line.now, &line.setup);
        line.tiller.hear(&said);
        line.run(Some(20.0), 10.0);
        assert!((line.tiller.rudder() - 20.0).abs() < 0.8, "{protocol:?}");
    }
}

// A motor that is turned round at full speed is not going the wrong way while the rudder runs on.
#[test]
fn an_order_that_is_turned_round_is_no_fault() {
    for protocol in BOTH {
        let mut line = Line::new(protocol);
        for turn in 0..200 {
            let order = if turn % 2 == 0 { 12.0 } else { -12.0 };
            line.run(Some(order), 0.4 + 0.1 * f64::from(turn % 7));
            assert_eq!(line.motor.fault(), None, "{protocol:?}: at the turn {turn}");
        }
    }
}

#[test]
fn lost_bytes_cost_no_more_than_themselves() {
    for protocol in BOTH {
        let mut line = Line::new(protocol);
        line.tiller.faults.lost_percent = 1;
        let mut stood = 0;
        for order in [10.0, -10.0, 20.0, -20.0, 0.0] {
            line.run(Some(order), 12.0);
            stood += u32::from((line.tiller.rudder() - order).abs() > 1.0);
        }
        assert_eq!(stood, 0, "{protocol:?}");
    }
}

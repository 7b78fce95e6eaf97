//! Every parameter of the autopilot: name, kind, range, default, who may change it, where it acts, help. One table.
//!
//! **Invariant:** settings in force are within their ranges and agree with each other, however they were changed.

mod value;

use alloc::format;
use alloc::string::{String, ToString};
use alloc::vec::Vec;
use serde::{Deserialize, Serialize};
use value::Slot;
pub use value::{
    DeadBand, Differential, GearKind, Group, HeadingLaw, Kind, Role, Rudders, SpeedSource,
    SteeringBy, TillerSide, Value,
};

/// One line of the settings table.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Definition {
    /// Name in commands and in the configuration.
    pub name: &'static str,
    /// What it may be.
    pub kind: Kind,
    /// Who may change it.
    pub role: Role,
    /// Where it acts.
    pub group: Group,
    /// What it does.
    pub help: &'static str,
}

macro_rules! kind {
    (type switch $($args:tt)*) => { bool };
    (type choice $of:ident $default:ident) => { $of };
    (type number $($args:tt)*) => { f64 };
    (type given $($args:tt)*) => { Option<f64> };
    (default switch $default:literal) => { $default };
    (default choice $of:ident $default:ident) => { $of::$default };
    (default number $unit:literal, $min:literal ..= $max:literal, $decimals:literal, $default:literal) => { $default };
    (default given $unit:literal, $min:literal ..= $max:literal, $decimals:literal) => { None };
    (row switch $default:literal) => { Kind::Switch { default: $default } };
    (row choice $of:ident $default:ident) => { Kind::Choice { names: $of::NAMES, default: $of::$default.written() } };
    (row number $unit:literal, $min:literal ..= $max:literal, $decimals:literal, $default:literal) => {
        Kind::Number { unit: $unit, min: $min, max: $max, decimals: $decimals, default: Some($default) }
    };
    (row given $unit:literal, $min:literal ..= $max:literal, $decimals:literal) => {
        Kind::Number { unit: $unit, min: $min, max: $max, decimals: $decimals, default: None }
    };
}

macro_rules! settings {
    ($($name:ident: $kind:ident($($args:tt)*), $role:ident, $group:ident, $help:literal;)*) => {
        /// The parameters in force.
        #[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
        pub struct Settings {
            $(#[doc = $help] pub $name: kind!(type $kind $($args)*),)*
        }
        /// The settings table.
        pub const TABLE: &[Definition] = &[$(Definition {
            name: stringify!($name), kind: kind!(row $kind $($args)*), role: Role::$role, group: Group::$group, help: $help,
        },)*];
        impl Default for Settings {
            fn default() -> Self {
                Self { $($name: kind!(default $kind $($args)*),)* }
            }
        }
        impl Settings {
            fn slot(&mut self, name: &str) -> Option<&mut dyn Slot> {
                match name {
                    $(stringify!($name) => Some(&mut self.$name),)*
                    _ => None,
                }
            }
            /// Names and values, in the order of the table.
            #[must_use]
            pub fn values(&self) -> Vec<(String, Value)> {
                alloc::vec![$((stringify!($name).to_string(), self.$name.value()),)*]
            }
        }
    };
}

settings! {
    accept_null_status: switch(true), Engineer, ChartSystem, "An HTC whose status (field 14) is null commands; HTC 14.";
    antenna_forward_m: number("m", -400.0 ..= 400.0, 1, 0.0), Engineer, Ship, "Antenna of the own receivers forward of midships; AP-16.";
    antenna_starboard_m: number("m", -400.0 ..= 400.0, 1, 0.0), Engineer, Ship, "Antenna of the own receivers to starboard of the midship line; AP-16.";
    centre_tolerance: number("m", 10.0 ..= 500.0, 0, 60.0), Engineer, ChartSystem, "A radius centre that is off the leg and the radius by more is refused.";
    conning_forward_m: number("m", -400.0 ..= 400.0, 1, 0.0), Engineer, Ship, "Conning position, which is what is steered along the track, forward of midships; AP-16.";
    conning_starboard_m: number("m", -400.0 ..= 400.0, 1, 0.0), Engineer, Ship, "Conning position to starboard of the midship line; AP-16.";
    cruise_speed: number("kn", 1.0 ..= 40.0, 1, 12.0), Operator, SetValues, "Speed used for the gains while no speed is measured.";
    dead_band: choice(DeadBand Automatic), Engineer, Rudder, "Dead band of the PID law: 1 deg, 4 deg, or between them by how much she yaws; EMC-2.";
    differential: choice(Differential Caution), Engineer, Sensors, "A position without differential correction: a caution in track control, or no position for it; AP-7.";
    external_compass: switch(false), Engineer, Sensors, "External compass: HDM and heel are believed from the plotter, and are not told there; EMC-5.";
    external_tcs: switch(false), Engineer, ChartSystem, "AutoNAV is enabled at installation; AP-6.";
    forwarding_s: given("s", 5.0 ..= 120.0, 0), Engineer, Ship, "Time from wheel-over to the start of the arc that the chart system is set to; AP-20.";
    gain_per_s: given("1/s", 0.005 ..= 2.0, 3), Engineer, Ship, "Nomoto gain K at speed_kn: rate of turn for each unit of rudder; AP-20.";
    gear: choice(GearKind Ror), Engineer, Rudder, "What turns the rudder: a gear that takes ROR, or a motor whose controller speaks the servo protocol of pypilot or that of the Jrk G2; changed in STANDBY only; AP-18.";
    heading_alignment: number("deg", -180.0 ..= 180.0, 1, 0.0), Engineer, Sensors, "Added to what a magnetic compass on imu, magn or plotter reads; changed in STANDBY only; EMC-7.";
    heading_jump: number("deg", 3.0 ..= 30.0, 1, 8.0), Engineer, Sensors, "A heading off its prediction by more is not used; FA8.";
    heading_law: choice(HeadingLaw Ship), Engineer, Rudder, "A heading is steered by the ship's model, or by the PID gains of a small craft; EMC-2.";
    heading_monitor_limit: number("deg", 1.0 ..= 60.0, 1, 10.0), Operator, Sensors, "Two compasses that are farther apart raise HDG DIFF; AP-10.";
    heel_offset: number("deg", -45.0 ..= 45.0, 1, 0.0), Engineer, Sensors, "Added to the heel that is heard; measured by the calibration of the IMU; EMC-2.";
    hsc: switch(false), Engineer, ChartSystem, "HSC is a source of the heading to steer in Tn, where no HTC is heard; AP-13.";
    leg_tolerance: number("m", 10.0 ..= 1000.0, 0, 30.0), Engineer, ChartSystem, "A leg that moves sideways by more at once is refused.";
    length_m: given("m", 5.0 ..= 460.0, 1), Engineer, Ship, "The ship's length; AP-20.";
    manual_speed: number("kn", 1.0 ..= 40.0, 1, 12.0), Operator, SetValues, "Speed entered by hand: the gains are made of it where speed_source is manual; AP-9.";
    minimum_speed: number("kn", 0.0 ..= 20.0, 1, 2.0), Engineer, Ship, "Below it the ship hardly answers her rudder: alarm, and gains of the cruise speed; FA10.";
    motor_band: choice(DeadBand Automatic), Engineer, Rudder, "Dead band of the motor: motor_band_min, motor_band_max, or between them by how it hunts; AP-18.";
    motor_band_max: number("deg", 0.5 ..= 10.0, 1, 3.0), Engineer, Rudder, "The widest dead band of the motor; AP-18.";
    motor_band_min: number("deg", 0.1 ..= 5.0, 1, 0.5), Engineer, Rudder, "The narrowest dead band of the motor; AP-18.";
    motor_current: number("A", 1.0 ..= 60.0, 1, 10.0), Engineer, Rudder, "Current above which the motor is stopped; AP-18.";
    motor_damping: number("s", 0.0 ..= 2.0, 2, 0.15), Engineer, Rudder, "The rudder runs on for so long when the motor is switched off; AP-18.";
    motor_feedback_centre: number("%", 0.0 ..= 100.0, 1, 50.0), Engineer, Rudder, "The motor's feedback with the rudder amidships; AP-18.";
    motor_feedback_port: number("%", 0.0 ..= 100.0, 1, 10.0), Engineer, Rudder, "The motor's feedback with the rudder hard to port; AP-18.";
    motor_feedback_starboard: number("%", 0.0 ..= 100.0, 1, 90.0), Engineer, Rudder, "The motor's feedback with the rudder hard to starboard; AP-18.";
    motor_reversed: switch(false), Engineer, Rudder, "The motor's positive command turns the rudder to port; AP-18.";
    motor_travel: number("deg", 5.0 ..= 45.0, 1, 35.0), Engineer, Rudder, "Rudder angle at either end of the motor's travel; AP-18.";
    motor_trim: number("deg", -10.0 ..= 10.0, 1, 0.0), Engineer, Rudder, "Rudder that holds her straight, added to each order to the motor, starboard positive; AP-18.";
    off_heading_limit: number("deg", 2.0 ..= 60.0, 0, 20.0), Operator, Rudder, "Off-heading limit; AP-5.";
    off_track_limit: number("m", 20.0 ..= 1000.0, 0, 185.0), Operator, ChartSystem, "Off-track alarm in track control where HTC gives no limit of its own.";
    pid_kd: number("s", 0.0 ..= 200.0, 3, 2.0), Engineer, Rudder, "PID law: rudder for each degree a second of the rate of turn; EMC-2.";
    pid_ki: number("1/s", 0.0 ..= 5.0, 3, 0.01), Engineer, Rudder, "PID law: rudder a second for each degree off the heading; EMC-2.";
    pid_kp: number("", 0.0 ..= 20.0, 3, 1.0), Engineer, Rudder, "PID law: rudder for each degree off the heading, at the cruise speed; EMC-2.";
    pivot_forward_m: given("m", -200.0 ..= 230.0, 1), Engineer, Ship, "Pivot point in a turn forward of midships: on an arc the bow points in by its distance from the conning position; without it the named ship's, else by the length; AP-16.";
    position_jump: number("m", 10.0 ..= 200.0, 0, 30.0), Engineer, Sensors, "A position off the dead reckoning by more is not used; FA9.";
    rate_offset: number("deg/min", -300.0 ..= 300.0, 1, 0.0), Engineer, Sensors, "Added to the rate of turn of an IMU; measured by its calibration; EMC-2.";
    rudder_damping: number("deg", 0.0 ..= 15.0, 1, 1.0), Engineer, Rudder, "PID law: the order rests while the wanted rudder is off it by no more; EMC-7.";
    rudder_forward_m: given("m", -230.0 ..= -1.0, 1), Engineer, Ship, "Rudder stock forward of midships, so less than nothing: the cautious gain goes by its lever; of no effect once gain_per_s and time_constant_s are given; AP-16.";
    rudder_limit: number("deg", 2.0 ..= 35.0, 0, 20.0), Operator, Rudder, "Rudder limit of AUTO; not used in AutoNAV (AP-8).";
    rudder_max: number("deg", 10.0 ..= 45.0, 0, 35.0), Engineer, Rudder, "Maximum rudder angle of the gear.";
    rudder_slew: number("deg/s", 0.5 ..= 20.0, 1, 2.3), Engineer, Rudder, "Fastest change of the rudder order; AP-15.";
    rudders: choice(Rudders Single), Engineer, Ship, "One rudder, two that are linked, or an independent pair with an order and a feedback each; AP-4.";
    sample_time: number("ms", 100.0 ..= 5000.0, 0, 200.0), Engineer, Rudder, "PID law: time between two samples, in whole control steps; EMC-7.";
    set_radius: number("nm", 0.05 ..= 10.0, 2, 0.5), Operator, SetValues, "Radius of AUTO's turns; not used in AutoNAV.";
    set_rate: number("deg/min", 1.0 ..= 300.0, 0, 28.0), Operator, SetValues, "Rate of turn of AUTO's turns; not used in AutoNAV.";
    speed_kn: given("kn", 1.0 ..= 40.0, 1), Engineer, Ship, "Speed at which gain and time constant hold; AP-20.";
    speed_source: choice(SpeedSource Automatic), Operator, Sensors, "Speed for the gains: automatic is the log, else over ground; manual is manual_speed, and AutoNAV is refused with it; AP-7, AP-9.";
    steady_turn_0: given("rad", -0.2 ..= 0.2, 4), Engineer, Ship, "Steady turn, rudder over r' = r L / U: the constant; AP-20.";
    steady_turn_1: given("rad", -5.0 ..= 5.0, 4), Engineer, Ship, "Steady turn: factor of r'; AP-20.";
    steady_turn_3: given("rad", -500.0 ..= 500.0, 3), Engineer, Ship, "Steady turn: factor of r' to the third; AP-20.";
    steady_turn_5: given("rad", -5000.0 ..= 5000.0, 2), Engineer, Ship, "Steady turn: factor of r' to the fifth; AP-20.";
    steering_by: choice(SteeringBy Radius), Operator, SetValues, "AUTO turns by the set radius or by the set rate of turn; AP-1.";
    step_hz: number("Hz", 5.0 ..= 20.0, 0, 10.0), Engineer, Rudder, "Control steps a second; AP-15.";
    tiller_centre: number("deg", -40.0 ..= 40.0, 1, 0.0), Engineer, Rudder, "Position of the gear with the rudder amidships; changed in STANDBY only; EMC-7.";
    tiller_side: choice(TillerSide Starboard), Engineer, Rudder, "Side of the tiller motor; to port its positions are the other way round; changed in STANDBY only; EMC-7.";
    time_constant_s: given("s", 1.0 ..= 1000.0, 1), Engineer, Ship, "Nomoto time constant T at speed_kn; AP-20.";
    track_caution: number("s", 1.0 ..= 10.0, 1, 3.0), Engineer, ChartSystem, "Age of the chart system's sentences at which a caution is raised; TCS-8.";
    track_fail: number("s", 2.0 ..= 30.0, 1, 5.0), Engineer, ChartSystem, "Age at which TRACK FAIL is raised; TCS-8.";
    tuning_bound: number("deg", 10.0 ..= 60.0, 0, 35.0), Engineer, Rudder, "AUTOTUNING ends where the heading is farther off the one before; AP-19.";
    tuning_heading: number("deg", 5.0 ..= 20.0, 0, 10.0), Engineer, Rudder, "AUTOTUNING puts the rudder over at so much off the heading; AP-19.";
    tuning_rudder: number("deg", 5.0 ..= 20.0, 0, 10.0), Engineer, Rudder, "Rudder of AUTOTUNING to each side, within rudder_limit; AP-19.";
    tuning_time: number("s", 60.0 ..= 1800.0, 0, 600.0), Engineer, Rudder, "AUTOTUNING ends at the latest after so long; AP-19.";
    variation: given("deg", -90.0 ..= 90.0, 1), Operator, Sensors, "Variation, east positive, for a magnetic compass where none is heard; AP-9.";
    wind_time: number("s", 1.0 ..= 120.0, 0, 15.0), Operator, Sensors, "Time constant with which the wind's direction is smoothed; AP-21.";
    wind_true: switch(false), Operator, SetValues, "WIND VANE, from its next selection on, holds the true wind angle and not the apparent one; AP-21.";
}

/// The line of a setting.
#[must_use]
pub fn definition(name: &str) -> Option<&'static Definition> {
    TABLE.iter().find(|definition| definition.name == name)
}

impl Settings {
    /// Changes one parameter: the one check for a configuration, a kept file and a change at run time.
    ///
    /// # Errors
    /// The reason where the name is unknown, the value is not allowed, or does not agree with another setting;
    /// nothing is changed then.
    pub fn set(&mut self, name: &str, value: &Value) -> Result<(), String> {
        let Some(definition) = definition(name) else {
            return Err(format!("no setting is named {name}"));
        };
        let mut changed = self.clone();
        if let Some(slot) = changed.slot(name) {
            slot.put(&definition.kind, value)
                .map_err(|allowed| format!("{name} is {value}, {allowed}"))?;
        }
        changed.agree()?;
        *self = changed;
        Ok(())
    }

    /// Duration of a control step, milliseconds.
    #[must_use]
    pub const fn step_ms(&self) -> u64 {
        (1000.0 / self.step_hz) as u64
    }

    /// Age in milliseconds at which what the chart system says is too old (TCS-8).
    #[must_use]
    pub const fn track_fail_ms(&self) -> u64 {
        (self.track_fail * 1000.0) as u64
    }

    /// What must hold between the settings of a motor (AP-18).
    fn motor_agrees(&self) -> Result<(), String> {
        if self.motor_band_min > self.motor_band_max {
            return Err(format!(
                "motor_band_min ({} deg) must not be above motor_band_max ({} deg)",
                self.motor_band_min, self.motor_band_max
            ));
        }
        let [port, centre, starboard] = [
            self.motor_feedback_port,
            self.motor_feedback_centre,
            self.motor_feedback_starboard,
        ];
        if (centre - port) * (starboard - centre) <= 0.0 {
            return Err(format!(
                "motor_feedback_centre ({centre} %) must be between motor_feedback_port ({port} %) and \
                 motor_feedback_starboard ({starboard} %)"
            ));
        }
        if self.gear != GearKind::Ror && self.rudders == Rudders::Independent {
            return Err("a motor turns one rudder, or linked ones: rudders is independent".into());
        }
        Ok(())
    }

    /// What must hold between settings.
    fn agree(&self) -> Result<(), String> {
        if self.track_caution >= self.track_fail {
            return Err(format!(
                "track_caution ({} s) must be below track_fail ({} s)",
                self.track_caution, self.track_fail
            ));
        }
        self.motor_agrees()?;
        if self.rudder_limit > self.rudder_max {
            return Err(format!(
                "rudder_limit ({} deg) must not be above rudder_max ({} deg)",
                self.rudder_limit, self.rudder_max
            ));
        }
        // EMC-7
        let step = self.step_ms();
        if self.heading_law == HeadingLaw::Pid && !(self.sample_time as u64).is_multiple_of(step) {
            return Err(format!(
                "sample_time ({} ms) must be whole control steps of {step} ms",
                self.sample_time
            ));
        }
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_default_is_allowed() {
        let mut settings = Settings::default();
        for (line, (name, value)) in TABLE.iter().zip(Settings::default().values()) {
            assert_eq!(line.name, name);
            assert_eq!(settings.set(&name, &value), Ok(()), "{name}");
        }
        assert_eq!(settings, Settings::default());
    }

    #[test]
    fn a_value_outside_its_range_is_refused_with_the_range() {
        let check = |name: &str, value: Value, expect: &str| {
            let mut settings = Settings::default();
            assert_eq!(settings.set(name, &value).unwrap_err(), expect);
            assert_eq!(settings, Settings::default());
        };
        let number = Value::Number;
        check(
            "rudder_limit",
            number(99.0),
            "rudder_limit is 99, allowed are 2 to 35 deg",
        );
        check(
            "rudder_limit",
            number(f64::NAN),
            "rudder_limit is NaN, allowed are 2 to 35 deg",
        );
        check(
            "rudder_limit",
            Value::Switch(true),
            "rudder_limit is on, allowed are 2 to 35 deg",
        );
        check("rudder", number(1.0), "no setting is named rudder");
        check(
            "external_tcs",
            number(1.0),
            "external_tcs is 1, allowed are true and false",
        );
        check(
            "steering_by",
            Value::Choice("sail".into()),
            "steering_by is sail, allowed are radius, rate",
        );
    }

    #[test]
    fn settings_that_contradict_each_other_are_refused_whichever_is_changed() {
        let mut settings = Settings::default();
        assert!(settings.set("track_fail", &Value::Number(2.5)).is_err());
        assert!(settings.set("track_caution", &Value::Number(6.0)).is_err());
        assert!(settings.set("rudder_max", &Value::Number(15.0)).is_err());
        assert_eq!(settings, Settings::default());
    }
}

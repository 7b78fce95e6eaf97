//! Every parameter of the autopilot: name, unit, range, default, help. One table.

use alloc::format;
use alloc::string::{String, ToString};
use alloc::vec::Vec;
use serde::{Deserialize, Serialize};

/// One line of the settings table.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Definition {
    /// Name in commands and in the configuration.
    pub name: &'static str,
    /// Unit; empty for a switch.
    pub unit: &'static str,
    /// Lowest value allowed.
    pub min: f64,
    /// Highest value allowed.
    pub max: f64,
    /// Value without a configuration.
    pub default: f64,
    /// What it does.
    pub help: &'static str,
}

macro_rules! settings {
    ($($name:ident: $unit:literal, $min:literal ..= $max:literal, $default:literal, $help:literal;)*) => {
        /// The parameters in force.
        #[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
        pub struct Settings {
            $(#[doc = $help] pub $name: f64,)*
        }
        /// The settings table.
        pub const TABLE: &[Definition] = &[$(Definition {
            name: stringify!($name), unit: $unit, min: $min, max: $max, default: $default, help: $help,
        },)*];
        impl Default for Settings {
            fn default() -> Self {
                Self { $($name: $default,)* }
            }
        }
        impl Settings {
            fn slot(&mut self, name: &str) -> Option<&mut f64> {
                match name {
                    $(stringify!($name) => Some(&mut self.$name),)*
                    _ => None,
                }
            }
            /// Names and values, in the order of the table.
            #[must_use]
            pub fn values(&self) -> Vec<(String, f64)> {
                alloc::vec![$((stringify!($name).to_string(), self.$name),)*]
            }
        }
    };
}

settings! {
    accept_null_status: "", 0.0 ..= 1.0, 1.0, "Accept an HTC whose status (field 14) is null (1) or not (0); HTC 14.";
    cruise_speed: "kn", 1.0 ..= 40.0, 12.0, "Speed used for the gains while no speed is measured.";
    external_tcs: "", 0.0 ..= 1.0, 1.0, "AutoNAV is enabled at installation (1) or not (0); AP-6.";
    heading_jump: "deg", 3.0 ..= 30.0, 8.0, "A heading off its prediction by more is not used; FA8.";
    off_heading_limit: "deg", 2.0 ..= 60.0, 20.0, "Off-heading limit; AP-5.";
    position_jump: "m", 10.0 ..= 200.0, 40.0, "A position off the dead reckoning by more is not used; FA9.";
    rudder_limit: "deg", 2.0 ..= 35.0, 20.0, "Rudder limit of AUTO; not used in AutoNAV (AP-8).";
    rudder_max: "deg", 10.0 ..= 45.0, 35.0, "Maximum rudder angle of the gear.";
    rudder_slew: "deg/s", 0.5 ..= 20.0, 2.3, "Fastest change of the rudder order; AP-15.";
    set_by_radius: "", 0.0 ..= 1.0, 1.0, "AUTO turns by radius (1) or by rate of turn (0).";
    set_radius: "nm", 0.05 ..= 10.0, 0.5, "Radius of AUTO's turns; not used in AutoNAV.";
    set_rate: "deg/min", 1.0 ..= 300.0, 28.0, "Rate of turn of AUTO's turns; not used in AutoNAV.";
    step_hz: "Hz", 5.0 ..= 20.0, 10.0, "Control steps a second; AP-15.";
    track_caution: "s", 1.0 ..= 10.0, 3.0, "Age of the chart system's sentences at which a caution is raised; TCS-8.";
    track_fail: "s", 2.0 ..= 30.0, 5.0, "Age at which TRACK FAIL is raised; TCS-8.";
}

impl Settings {
    /// Changes one parameter.
    ///
    /// # Errors
    /// The reason where the name is unknown or the value is outside its range.
    pub fn set(&mut self, name: &str, value: f64) -> Result<(), String> {
        let Some(definition) = TABLE.iter().find(|definition| definition.name == name) else {
            return Err(format!("no setting is named {name}"));
        };
        if !(definition.min..=definition.max).contains(&value) {
            return Err(format!(
                "{name} is {value}, allowed are {} to {} {}",
                definition.min, definition.max, definition.unit
            ));
        }
        if let Some(slot) = self.slot(name) {
            *slot = value;
        }
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_default_is_within_its_range() {
        for line in TABLE {
            assert!(
                (line.min..=line.max).contains(&line.default),
                "{}",
                line.name
            );
        }
    }

    #[test]
    fn a_value_outside_its_range_is_refused_with_the_range() {
        let mut settings = Settings::default();
        let error = settings.set("rudder_limit", 99.0).unwrap_err();
        assert_eq!(error, "rudder_limit is 99, allowed are 2 to 35 deg");
        assert_eq!(
            settings.set("rudder", 1.0).unwrap_err(),
            "no setting is named rudder"
        );
    }
}

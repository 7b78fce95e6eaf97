//! What a setting may be: a switch, a choice or a number with unit, range and decimals.

use alloc::format;
use alloc::string::{String, ToString};
use serde::{Deserialize, Serialize};

/// A setting's value as it is written, stored and sent: `true`, `12.5`, `"radius"`; null where a number is not given.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(untagged)]
pub enum Value {
    /// Of a switch.
    Switch(bool),
    /// Of a number, in the unit of its definition.
    Number(f64),
    /// Of a choice.
    Choice(String),
    /// A number that is not given.
    Absent,
}

impl core::fmt::Display for Value {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        match self {
            Self::Switch(on) => f.write_str(if *on { "on" } else { "off" }),
            Self::Number(number) => write!(f, "{number}"),
            Self::Choice(name) => f.write_str(name),
            Self::Absent => f.write_str("not given"),
        }
    }
}

/// What a setting may be.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Kind {
    /// On or off.
    Switch {
        /// Without a configuration.
        default: bool,
    },
    /// One of these names.
    Choice {
        /// What may be chosen.
        names: &'static [&'static str],
        /// Without a configuration.
        default: &'static str,
    },
    /// A number.
    Number {
        /// Unit.
        unit: &'static str,
        /// Lowest value allowed.
        min: f64,
        /// Highest value allowed.
        max: f64,
        /// Decimals shown.
        decimals: u8,
        /// Without a configuration; none where it is then not given.
        default: Option<f64>,
    },
}

/// Who may change a setting.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Role {
    /// Whoever steers.
    Operator,
    /// Whoever installs and commissions.
    Engineer,
}

/// Where a setting acts.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Group {
    /// What the chart system may command, and how it is supervised.
    ChartSystem,
    /// What AUTO is set to.
    SetValues,
    /// Rudder and control step.
    Rudder,
    /// Limits of what is believed.
    Sensors,
    /// The ship's own constants (AP-20).
    Ship,
}

/// A choice: its variants, and how each is written.
macro_rules! choices {
    ($($(#[$doc:meta])* $name:ident { $($(#[$of:meta])* $variant:ident = $text:literal,)* })*) => {$(
        $(#[$doc])*
        #[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
        #[serde(rename_all = "snake_case")]
        pub enum $name { $($(#[$of])* $variant,)* }

        impl $name {
            pub(super) const NAMES: &'static [&'static str] = &[$($text,)*];

            pub(super) const fn written(self) -> &'static str {
                match self { $(Self::$variant => $text,)* }
            }

            /// As a setting's value.
            #[must_use]
            pub fn value(self) -> Value {
                Value::Choice(self.written().to_string())
            }
        }

        impl Slot for $name {
            fn value(&self) -> Value {
                Self::value(*self)
            }

            fn put(&mut self, _: &Kind, value: &Value) -> Result<(), String> {
                *self = match value {
                    $(Value::Choice(name) if name == $text => Self::$variant,)*
                    _ => return Err(format!("allowed are {}", Self::NAMES.join(", "))),
                };
                Ok(())
            }
        }
    )*};
}

choices! {
    /// How wide a dead band is: of a small craft's heading before the PID law answers (EMC-2), of a rudder before its motor
    /// starts (AP-18).
    DeadBand {
        /// The least.
        Minimum = "minimum",
        /// The greatest.
        Maximum = "maximum",
        /// Between them: by how much she yaws, or by how the motor hunts.
        Automatic = "automatic",
    }
    /// Which law steers a heading (EMC-2).
    HeadingLaw {
        /// By the model of the ship.
        Ship = "ship",
        /// By three gains, as a small craft's.
        Pid = "pid",
    }
    /// Where the motor of the tiller stands (EMC-7).
    TillerSide {
        /// To starboard: its positions are as the rudder's.
        Starboard = "starboard",
        /// To port: they are the other way round.
        Port = "port",
    }
    /// What turns the rudder (AP-18).
    GearKind {
        /// A gear that takes ROR and says RSA.
        Ror = "ror",
        /// A motor by the servo protocol of pypilot.
        Pypilot = "pypilot",
        /// A motor by a Jrk G2.
        Jrk = "jrk",
    }
    /// How AUTO turns (AP-1).
    SteeringBy {
        /// By the set radius.
        Radius = "radius",
        /// By the set rate of turn.
        Rate = "rate",
    }
    /// What a position without differential correction is to track control (AP-7).
    Differential {
        /// It engages and goes on, with a caution.
        Caution = "caution",
        /// It is no position for track control.
        Required = "required",
    }
    /// Where the speed for the gains comes from (AP-7, AP-9).
    SpeedSource {
        /// Log, else the speed over ground; the cruise speed where neither is known.
        Automatic = "automatic",
        /// Entered by hand.
        Manual = "manual",
    }
    /// How the rudders hang together (AP-4).
    Rudders {
        /// One.
        Single = "single",
        /// Two that move as one, with one order and one feedback.
        Linked = "linked",
        /// Two, each with its own order and feedback.
        Independent = "independent",
    }
}

/// A place in the settings that holds one value.
pub(super) trait Slot {
    fn value(&self) -> Value;
    /// Takes a value, or says what is allowed.
    fn put(&mut self, kind: &Kind, value: &Value) -> Result<(), String>;
}

impl Slot for bool {
    fn value(&self) -> Value {
        Value::Switch(*self)
    }

    fn put(&mut self, _: &Kind, value: &Value) -> Result<(), String> {
        *self = match value {
            Value::Switch(on) => *on,
            _ => return Err("allowed are true and false".into()),
        };
        Ok(())
    }
}

impl Slot for f64 {
    fn value(&self) -> Value {
        Value::Number(*self)
    }

    fn put(&mut self, kind: &Kind, value: &Value) -> Result<(), String> {
        *self = number(kind, value)?;
        Ok(())
    }
}

impl Slot for Option<f64> {
    fn value(&self) -> Value {
        self.map_or(Value::Absent, Value::Number)
    }

    fn put(&mut self, kind: &Kind, value: &Value) -> Result<(), String> {
        *self = match value {
            Value::Absent => None,
            // As it is kept: TOML has no null.
            Value::Choice(text) if text.is_empty() => None,
            _ => Some(number(kind, value)?),
        };
        Ok(())
    }
}

fn number(kind: &Kind, value: &Value) -> Result<f64, String> {
    let Kind::Number { unit, min, max, .. } = kind else {
        return Err("is no number".into());
    };
    match value {
        Value::Number(number) if (*min..=*max).contains(number) => Ok(*number),
        _ => Err(format!("allowed are {min} to {max} {unit}")
            .trim_end()
            .to_string()),
    }
}

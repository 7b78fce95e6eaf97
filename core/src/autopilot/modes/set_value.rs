//! What an operator sets in a mode: what it is called, where it is set, how far, and the words of a refusal. One table.

use crate::command::{Order, Refusal, Side};
use crate::settings::Settings;
use alloc::format;
use alloc::string::String;

/// What is set.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(in super::super) enum SetValue {
    /// Rate of turn, degrees a minute, starboard positive.
    Rate(f64),
    /// Radius, nautical miles.
    Radius(f64),
    /// Rudder, degrees, starboard positive.
    Rudder(f64),
    /// Offset of the heading, degrees, starboard positive.
    Dodge(f64),
    /// Wind angle, degrees, starboard positive.
    WindAngle(f64),
    /// A tack by a turn to that side.
    Tack(Side),
}

impl SetValue {
    /// What an order sets; absent where it is no order of this kind.
    pub(in super::super) const fn of(order: &Order) -> Option<Self> {
        Some(match order {
            Order::SetRate(value) => Self::Rate(*value),
            Order::SetRadius(value) => Self::Radius(*value),
            Order::SetRudder(value) => Self::Rudder(*value),
            Order::SetDodge(value) => Self::Dodge(*value),
            Order::SetWindAngle(value) => Self::WindAngle(*value),
            Order::Tack(side) => Self::Tack(*side),
            _ => return None,
        })
    }

    /// Its name, the modes that take it, its largest size and its unit.
    const fn row(self) -> (&'static str, &'static str, f64, &'static str) {
        match self {
            Self::Rate(_) => ("rate of turn", "RIVER PILOT and AUTO", 300.0, "deg/min"),
            Self::Radius(_) => ("radius", "AUTO", 10.0, "nm"),
            Self::Rudder(_) => ("rudder", "FFU OVERRIDE", f64::MAX, "deg"),
            Self::Dodge(_) => ("offset", "DODGE", 90.0, "deg"),
            Self::WindAngle(_) => ("wind angle", "WIND VANE", 180.0, "deg"),
            Self::Tack(_) => ("tack", "WIND VANE", f64::MAX, ""),
        }
    }

    const fn value(self) -> f64 {
        match self {
            Self::Rate(value)
            | Self::Radius(value)
            | Self::Rudder(value)
            | Self::Dodge(value)
            | Self::WindAngle(value) => value,
            Self::Tack(_) => 0.0,
        }
    }

    /// The same where it is within its range; the gear's maximum ends that of the rudder.
    pub(super) fn within(self, settings: &Settings) -> Result<Self, Refusal> {
        let (what, _, most, unit) = self.row();
        let (value, most) = (
            self.value(),
            match self {
                Self::Rudder(_) => settings.rudder_max,
                _ => most,
            },
        );
        if (-most..=most).contains(&value) {
            return Ok(self);
        }
        Err(Refusal::because(format!(
            "{what} is {value}, allowed are -{most} to {most} {unit}"
        )))
    }

    /// It is not set in the mode that is on.
    pub(super) fn refused(self) -> Refusal {
        let (what, modes, ..) = self.row();
        Refusal::because(format!("the {what} is set in {modes} only"))
    }

    /// What is answered where it is set.
    pub(super) fn done(self) -> String {
        let (what, _, _, unit) = self.row();
        match self {
            Self::Tack(side) => format!("tack to {}", side_name(side)),
            _ => format!("set {what} {}", sided(self.value(), unit)),
        }
    }
}

/// A number with its unit and its side: `12.5 deg/min to port`.
pub(super) fn sided(value: f64, unit: &str) -> String {
    let size = format!("{:.1}", libm::fabs(value));
    let side = match value {
        _ if size == "0.0" => "",
        _ if value < 0.0 => " to port",
        _ => " to starboard",
    };
    format!("{size} {unit}{side}")
}

/// A side for people.
pub(super) const fn side_name(side: Side) -> &'static str {
    match side {
        Side::Port => "port",
        Side::Starboard => "starboard",
    }
}

//! `[gear]`: what turns the rudder, by the names of the settings table (AP-18).

use serde::Deserialize;
use wheelover_core::settings::Value;

/// What turns the rudder. Keys that are not written are as the settings have them.
#[derive(Clone, Debug, Default, PartialEq, Deserialize)]
#[serde(deny_unknown_fields, default)]
pub(crate) struct Gear {
    kind: Kind,
    /// The protocol of the motor's controller.
    protocol: Option<Protocol>,
    /// 1, or -1 where the motor's positive command turns the rudder to port.
    sign: Option<i8>,
    /// Feedback amidships, per cent of its range: the centred tiller position.
    centre: Option<f64>,
    /// Feedback hard to port, per cent.
    port_end: Option<f64>,
    /// Feedback hard to starboard, per cent.
    starboard_end: Option<f64>,
    /// Rudder angle at either end, degrees.
    travel_deg: Option<f64>,
    /// Rudder that holds her straight, degrees.
    trim_deg: Option<f64>,
    /// Slew limit of the order, degrees a second.
    slew_deg_s: Option<f64>,
    /// minimum, maximum or automatic.
    dead_band: Option<String>,
    dead_band_min_deg: Option<f64>,
    dead_band_max_deg: Option<f64>,
    /// The rudder runs on for so long, s.
    damping_s: Option<f64>,
    /// Largest current, A.
    current_max_a: Option<f64>,
}

/// What turns the rudder.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Deserialize)]
#[serde(rename_all = "lowercase")]
enum Kind {
    /// A gear that takes ROR.
    #[default]
    Ror,
    /// A motor behind a controller.
    Motor,
}

/// How a motor's controller speaks.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Deserialize)]
#[serde(rename_all = "lowercase")]
enum Protocol {
    Pypilot,
    Jrk,
}

impl Gear {
    /// By the names of the settings table.
    ///
    /// # Errors
    /// Keys that do not go together.
    pub(super) fn settings(&self) -> Result<Vec<(&'static str, Value)>, String> {
        let gear = match (self.kind, self.protocol) {
            (Kind::Ror, None) => None,
            (Kind::Ror, Some(_)) => {
                return Err("protocol is a motor's; allowed with kind = \"motor\"".to_owned());
            }
            (Kind::Motor, Some(Protocol::Jrk)) => Some("jrk"),
            (Kind::Motor, Some(Protocol::Pypilot) | None) => Some("pypilot"),
        };
        let reversed = match self.sign {
            None => None,
            Some(1) => Some(false),
            Some(-1) => Some(true),
            Some(sign) => return Err(format!("sign = {sign}; allowed are 1 and -1")),
        };
        let choices = [
            ("gear", gear.map(str::to_owned)),
            ("motor_band", self.dead_band.clone()),
        ];
        let numbers = [
            ("motor_feedback_centre", self.centre),
            ("motor_feedback_port", self.port_end),
            ("motor_feedback_starboard", self.starboard_end),
            ("motor_travel", self.travel_deg),
            ("motor_trim", self.trim_deg),
            ("rudder_slew", self.slew_deg_s),
            ("motor_band_min", self.dead_band_min_deg),
            ("motor_band_max", self.dead_band_max_deg),
            ("motor_damping", self.damping_s),
            ("motor_current", self.current_max_a),
        ];
        let choices = choices
            .into_iter()
            .filter_map(|(name, value)| Some((name, Value::Choice(value?))));
        let reversed = reversed.map(|on| ("motor_reversed", Value::Switch(on)));
        let numbers = numbers
            .into_iter()
            .filter_map(|(name, value)| Some((name, Value::Number(value?))));
        Ok(choices.chain(reversed).chain(numbers).collect())
    }
}

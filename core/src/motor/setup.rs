//! What a motor that turns the rudder is told of itself and of her gear (AP-18).

use crate::settings::{DeadBand, GearKind, Settings};
use crate::units::RudderAngle;
use serde::{Deserialize, Serialize};

/// The protocol of a motor controller.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Protocol {
    /// The open servo protocol of pypilot: packets of four bytes with a CRC, both ways.
    #[default]
    Pypilot,
    /// Pololu Jrk G2, compact protocol: asked for its variables, told a duty cycle.
    Jrk,
}

/// A motor and what it turns.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct MotorSetup {
    /// How its controller speaks.
    pub protocol: Protocol,
    /// Feedback with the rudder hard to port, as a part of the feedback's range, 0 to 1.
    pub feedback_port: f64,
    /// Feedback with the rudder amidships, 0 to 1: the centred tiller position.
    pub feedback_centre: f64,
    /// Feedback with the rudder hard to starboard, 0 to 1; below the port one where it is mounted the other way round.
    pub feedback_starboard: f64,
    /// Rudder angle at either end of the travel, degrees.
    pub travel_deg: f64,
    /// The controller's positive command moves the rudder to port.
    pub reversed: bool,
    /// Rudder that holds her straight, added to each order, degrees, starboard positive.
    pub trim_deg: f64,
    /// Which dead band.
    pub dead_band: DeadBand,
    /// The narrowest, degrees.
    pub dead_band_min_deg: f64,
    /// The widest, degrees.
    pub dead_band_max_deg: f64,
    /// Rudder damping: so many seconds of its present speed does the rudder run on when the motor is switched off.
    pub damping_s: f64,
    /// Current above which the motor is stopped, amperes.
    pub current_max_a: f64,
}

impl Default for MotorSetup {
    fn default() -> Self {
        Self {
            protocol: Protocol::Pypilot,
            feedback_port: 0.1,
            feedback_centre: 0.5,
            feedback_starboard: 0.9,
            travel_deg: 35.0,
            reversed: false,
            trim_deg: 0.0,
            dead_band: DeadBand::Automatic,
            dead_band_min_deg: 0.5,
            dead_band_max_deg: 3.0,
            damping_s: 0.15,
            current_max_a: 10.0,
        }
    }
}

impl MotorSetup {
    /// As it is set; absent where the gear takes ROR.
    #[must_use]
    pub fn of(settings: &Settings) -> Option<Self> {
        let protocol = match settings.gear {
            GearKind::Ror => return None,
            GearKind::Pypilot => Protocol::Pypilot,
            GearKind::Jrk => Protocol::Jrk,
        };
        Some(Self {
            protocol,
            feedback_port: settings.motor_feedback_port / 100.0,
            feedback_centre: settings.motor_feedback_centre / 100.0,
            feedback_starboard: settings.motor_feedback_starboard / 100.0,
            travel_deg: settings.motor_travel,
            reversed: settings.motor_reversed,
            trim_deg: settings.motor_trim,
            dead_band: settings.motor_band,
            dead_band_min_deg: settings.motor_band_min,
            dead_band_max_deg: settings.motor_band_max,
            damping_s: settings.motor_damping,
            current_max_a: settings.motor_current,
        })
    }

    /// The rudder angle of a feedback from 0 to 1: one straight line from either end to amidships. Beyond the ends it goes
    /// on; absent where the three positions stand in no order.
    #[must_use]
    pub fn angle(&self, feedback: f64) -> Option<RudderAngle> {
        let to_starboard = self.feedback_starboard - self.feedback_centre;
        let to_port = self.feedback_centre - self.feedback_port;
        if to_starboard * to_port <= 0.0 {
            return None;
        }
        let off = feedback - self.feedback_centre;
        let side = if off * to_starboard >= 0.0 {
            to_starboard
        } else {
            to_port
        };
        Some(RudderAngle::from_deg(off / side * self.travel_deg))
    }

    /// The band in force, where the automatic one is `automatic` wide, degrees.
    pub(super) fn band(&self, automatic: f64) -> f64 {
        let (least, most) = (self.dead_band_min_deg, self.dead_band_max_deg);
        match self.dead_band {
            DeadBand::Minimum => least,
            DeadBand::Maximum => most,
            DeadBand::Automatic => automatic.clamp(least, most.max(least)),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    // EMC-7, AP-18: the centred tiller position and the ends, mounted either way.
    #[test]
    fn feedback_is_an_angle_by_its_three_positions() {
        let mounted = |port, centre, starboard| MotorSetup {
            feedback_port: port,
            feedback_centre: centre,
            feedback_starboard: starboard,
            travel_deg: 30.0,
            ..MotorSetup::default()
        };
        let setup = mounted(0.2, 0.4, 0.8);
        for (feedback, degrees) in [
            (0.2, -30.0),
            (0.3, -15.0),
            (0.4, 0.0),
            (0.6, 15.0),
            (0.8, 30.0),
        ] {
            let angle = setup.angle(feedback).expect("an angle");
            assert!((angle.deg() - degrees).abs() < 1e-9, "{feedback}");
            let turned = mounted(0.8, 0.6, 0.2)
                .angle(1.0 - feedback)
                .expect("an angle");
            assert!((turned.deg() - degrees).abs() < 1e-9, "{feedback} turned");
        }
        assert_eq!(mounted(0.2, 0.9, 0.8).angle(0.5), None, "no order");
        assert_eq!(mounted(0.5, 0.5, 0.8).angle(0.5), None);
    }
}

//! How the world begins.

use super::hull::ShipModel;
use super::sensors::Noise;
use crate::geo::Position;
use crate::motor::Protocol;
use crate::station::{ChecksumPolicy, PortSetup, Profile};
use crate::units::{Course, Heading, Speed};
use alloc::string::String;
use alloc::vec::Vec;
use serde::{Deserialize, Serialize};

/// How the world begins.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct WorldConfig {
    /// Where the ship is.
    pub start: Position,
    /// Her heading.
    pub heading: Heading,
    /// Speed that the engine keeps on a straight course.
    pub speed: Speed,
    /// Direction towards which the current sets.
    pub current_set: Course,
    /// Speed of the current.
    pub current_drift: Speed,
    /// Where the wind comes from, over ground; the Mariner does not feel it.
    pub wind_from: Course,
    /// Its speed; at none no wind is measured.
    pub wind_speed: Speed,
    /// Ports; a profile that is not here sends nothing.
    pub ports: Vec<PortSetup>,
    /// Seed of all noise.
    pub seed: u64,
    /// How noisy the sensors are.
    pub noise: Noise,
    /// Which ship she is.
    pub ship: ShipModel,
    /// How the wind gusts: the deviation of its speed as a part of it.
    pub gustiness: f64,
    /// Her rudder is turned by a motor whose controller speaks so on the gear's port; else the gear takes ROR.
    pub motor: Option<Protocol>,
    /// Whether she has an independent pair of rudders, which act as their mean; else a single one (AP-4).
    pub pair: bool,
}

impl Default for WorldConfig {
    fn default() -> Self {
        let port = |name: &str, profile| PortSetup {
            name: String::from(name),
            profile,
            checksum: ChecksumPolicy::Required,
            talkers: Vec::new(),
            baud: 38_400,
            output: true,
        };
        Self {
            start: Position {
                lat: 54.0,
                lon: 7.5,
            },
            heading: Heading::from_deg(0.0),
            speed: Speed::from_knots(15.0),
            current_set: Course::from_deg(0.0),
            current_drift: Speed::from_knots(0.0),
            wind_from: Course::from_deg(0.0),
            wind_speed: Speed::from_knots(0.0),
            ports: alloc::vec![
                port("gyro1", Profile::Gyro1),
                port("gps", Profile::Gps),
                port("log", Profile::Log),
                port("gear", Profile::Gear),
            ],
            seed: 1,
            noise: Noise::default(),
            ship: ShipModel::Mariner,
            gustiness: 0.0,
            motor: None,
            pair: false,
        }
    }
}

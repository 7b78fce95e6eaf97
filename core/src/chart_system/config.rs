//! How a chart system is set up.

use crate::route::Route;
use crate::station::{ChecksumPolicy, PortSetup, Profile};
use crate::units::{Distance, Radius, Speed};
use alloc::vec::Vec;
use serde::{Deserialize, Serialize};

/// How a chart system is set up.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct ChartConfig {
    /// The route that is monitored from the start.
    pub route: Option<Route>,
    /// Its ports.
    pub ports: Vec<PortSetup>,
    /// Time on the forwarding distance in "Ti", seconds; absent: the route's own.
    pub forwarding_s: Option<f64>,
    /// Time from the start of a turn in "Tn" to the beginning of the arc, seconds.
    pub forwarding_tn_s: f64,
    /// Early course change indication before wheel-over, seconds; at least 60 (TCS-11).
    pub early_s: f64,
    /// Indication before wheel-over, seconds.
    pub soon_s: f64,
    /// An EVE leaves for bridge alert management with each order of an officer (TCS-13).
    pub eve: bool,
    /// Without a position control goes on by dead reckoning for a while (TCS-14).
    pub dead_reckoning: bool,
    /// Largest cross-track distance at which control may begin.
    pub begin_cross_track: Distance,
    /// Largest difference of heading and track at which control may begin, degrees.
    pub begin_angle_deg: f64,
    /// Radius of the turns of a route that a plotter offers: its sentences have none (TCS-13).
    pub offered_radius: Radius,
    /// Corridor of its legs, to each side.
    pub offered_corridor: Distance,
    /// Planned speed, by which its turns are judged.
    pub planned_speed: Speed,
    /// From the antenna to the conning position: metres forward, metres to starboard (AP-16).
    pub conning_offset_m: [f64; 2],
}

impl Default for ChartConfig {
    fn default() -> Self {
        let port = |name: &str, profile, output| PortSetup {
            name: name.into(),
            profile,
            checksum: ChecksumPolicy::Required,
            talkers: Vec::new(),
            baud: 0,
            output,
        };
        Self {
            route: None,
            ports: alloc::vec![
                port("ecdis", Profile::Ecdis, true),
                port("gps", Profile::Gps, false),
                port("gyro1", Profile::Gyro1, false),
                port("log", Profile::Log, false),
            ],
            forwarding_s: None,
            forwarding_tn_s: 26.0,
            early_s: 180.0,
            soon_s: 30.0,
            eve: false,
            dead_reckoning: false,
            begin_cross_track: Distance::from_nm(0.5),
            begin_angle_deg: 90.0,
            offered_radius: Radius::from_nm(0.5),
            offered_corridor: Distance::from_nm(0.1),
            planned_speed: Speed::from_knots(15.0),
            conning_offset_m: [0.0, 0.0],
        }
    }
}

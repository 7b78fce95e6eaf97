//! State of a hull and what acts on it, whichever ship she is.

use serde::{Deserialize, Serialize};

/// A simulated ship.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum ShipModel {
    /// The Mariner-class cargo ship.
    #[default]
    Mariner,
    /// A sailing yacht of eleven metres.
    Yacht,
}

/// State of the hull: metres, radians, seconds; starboard, north and east positive.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Hull {
    /// Surge through the water, m/s.
    pub surge: f64,
    /// Sway through the water, m/s.
    pub sway: f64,
    /// Rate of turn, rad/s.
    pub rate: f64,
    /// Heading, rad, not wrapped.
    pub heading: f64,
    /// Metres north of the origin.
    pub north: f64,
    /// Metres east of the origin.
    pub east: f64,
    /// Rudder, rad; of a pair, the starboard one.
    pub rudder: f64,
    /// The port one of a pair, rad.
    pub port_rudder: f64,
    /// Heel, rad, to starboard positive; the Mariner has none.
    pub heel: f64,
    /// Its rate of change, rad/s.
    pub heel_rate: f64,
    /// Which ship.
    pub ship: ShipModel,
}

/// What acts on the hull.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Drive {
    /// Rudder order, rad; of a pair, to the starboard one.
    pub order: f64,
    /// Order to the port one of a pair, rad; a single rudder has none.
    pub port_order: Option<f64>,
    /// Rudders that stick where they are: the single or the starboard one, the port one.
    pub stuck: [bool; 2],
    /// Approach speed that the engine keeps, m/s.
    pub approach_speed: f64,
    /// Current towards north, m/s.
    pub current_north: f64,
    /// Current towards east, m/s.
    pub current_east: f64,
    /// The wind over ground: its speed times the direction where it comes from, north, m/s; it acts on the yacht.
    pub wind_north: f64,
    /// The same, east, m/s.
    pub wind_east: f64,
}

impl Hull {
    /// The Mariner at the origin on `heading` (rad), running straight at `speed` (m/s).
    #[must_use]
    pub fn running(heading: f64, speed: f64) -> Self {
        Self {
            surge: speed,
            heading,
            ..Self::default()
        }
    }

    /// Another ship that runs so.
    #[must_use]
    pub fn of(ship: ShipModel, heading: f64, speed: f64) -> Self {
        Self {
            ship,
            ..Self::running(heading, speed)
        }
    }

    /// Speed through the water, m/s.
    #[must_use]
    pub fn speed(&self) -> f64 {
        libm::sqrt(self.surge * self.surge + self.sway * self.sway)
    }

    /// Apparent wind: its angle from the bow (rad, starboard positive) and its speed, m/s.
    #[must_use]
    pub fn apparent_wind(&self, drive: &Drive) -> (f64, f64) {
        let (north, east) = self.ground_velocity(drive);
        let (north, east) = (drive.wind_north + north, drive.wind_east + east);
        (
            libm::atan2(east, north) - self.heading,
            libm::hypot(north, east),
        )
    }

    /// Velocity over ground: north and east, m/s.
    #[must_use]
    pub fn ground_velocity(&self, drive: &Drive) -> (f64, f64) {
        let (sine, cosine) = (libm::sin(self.heading), libm::cos(self.heading));
        (
            self.surge * cosine - self.sway * sine + drive.current_north,
            self.surge * sine + self.sway * cosine + drive.current_east,
        )
    }
}

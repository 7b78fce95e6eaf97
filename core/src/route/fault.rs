//! Why a route is refused, in an officer's words, with what would fit.

use alloc::string::String;
use core::fmt;

/// Why a route was refused; legs and waypoints count from 1.
#[derive(Clone, Debug, PartialEq)]
pub enum RouteFault {
    /// A route needs two waypoints.
    TooFewWaypoints,
    /// A latitude or longitude that is not on the globe, or too near a pole.
    Place {
        /// Identifier of the waypoint.
        waypoint: String,
    },
    /// An identifier that cannot stand in a sentence.
    Identifier {
        /// Number of the waypoint.
        number: usize,
    },
    /// A corridor that is not a distance.
    Corridor {
        /// Identifier of the waypoint.
        waypoint: String,
    },
    /// Two waypoints on one place.
    NoLength {
        /// Number of the leg.
        leg: usize,
    },
    /// A waypoint between two legs without a radius.
    NoRadius {
        /// Identifier of the waypoint.
        waypoint: String,
    },
    /// A radius outside the limits.
    RadiusLimit {
        /// Identifier of the waypoint.
        waypoint: String,
        /// The radius, nautical miles.
        radius_nm: f64,
        /// Smallest and largest that are allowed, nautical miles.
        allowed_nm: (f64, f64),
    },
    /// The rate of turn on the radius at the planned speed is too high.
    Rate {
        /// Identifier of the waypoint.
        waypoint: String,
        /// The rate, degrees a minute.
        rate: f64,
        /// The highest that is allowed.
        highest: f64,
    },
    /// The change of course is too large for one waypoint.
    TurnTooSharp {
        /// Identifier of the waypoint.
        waypoint: String,
        /// The change of course, degrees.
        turn_deg: f64,
        /// The largest that is allowed.
        largest_deg: f64,
    },
    /// The radius does not fit its legs (TCS-11).
    RadiusDoesNotFit {
        /// Identifier of the waypoint.
        waypoint: String,
        /// Number of the leg that is too short for it.
        leg: usize,
        /// The radius, nautical miles.
        radius_nm: f64,
        /// The largest that fits both its legs, nautical miles, rounded down to a thousandth.
        largest_nm: f64,
    },
    /// The leg is too short for any radius at its ends.
    LegTooShort {
        /// Number of the leg.
        leg: usize,
        /// Its length, nautical miles.
        length_nm: f64,
        /// What it needs beside the turns, nautical miles.
        needed_nm: f64,
    },
}

impl fmt::Display for RouteFault {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::TooFewWaypoints => f.write_str("a route needs at least two waypoints"),
            Self::Place { waypoint } => write!(
                f,
                "waypoint {waypoint} is not a place at sea: latitude \
                -85 to 85, longitude -180 to 180"
            ),
            Self::Identifier { number } => write!(
                f,
                "identifier of waypoint {number} must be 1 to 20 printable \
                characters without , * $ ! \\ ^ ~"
            ),
            Self::Corridor { waypoint } => {
                write!(
                    f,
                    "corridor at waypoint {waypoint} must be more than 0 m and at most 10 nm"
                )
            }
            Self::NoLength { leg } => write!(f, "leg {leg} has no length"),
            Self::NoRadius { waypoint } => write!(f, "waypoint {waypoint} has no radius"),
            Self::RadiusLimit {
                waypoint,
                radius_nm,
                allowed_nm: (low, high),
            } => write!(
                f,
                "radius {radius_nm:.3} nm at waypoint {waypoint} is not between {low:.3} and {high:.3} nm"
            ),
            Self::Rate {
                waypoint,
                rate,
                highest,
            } => write!(
                f,
                "radius at waypoint {waypoint} needs {rate:.1} deg/min at the planned speed, more than {highest:.1}"
            ),
            Self::TurnTooSharp {
                waypoint,
                turn_deg,
                largest_deg,
            } => write!(
                f,
                "course change of {turn_deg:.1} deg at waypoint {waypoint} is more than {largest_deg:.0} deg"
            ),
            Self::RadiusDoesNotFit {
                waypoint,
                leg,
                radius_nm,
                largest_nm,
            } => write!(
                f,
                "radius {radius_nm:.3} nm at waypoint {waypoint} does not fit leg {leg}; \
                 the largest that fits is {largest_nm:.3} nm"
            ),
            Self::LegTooShort {
                leg,
                length_nm,
                needed_nm,
            } => write!(
                f,
                "leg {leg} of {length_nm:.3} nm is too short: {needed_nm:.3} nm are needed beside the turns"
            ),
        }
    }
}

impl core::error::Error for RouteFault {}
